//! Columns of the curve: what is measured on which particles.

use schemars::JsonSchema;
use serde::Deserialize;

use super::bounded::PlyNumber;
use super::criterion::{Criterion, PlyComponent, ShellFace};
use super::through::Through;

/// One column of the curve.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name of the column.
    pub name: String,
    /// What it measures.
    pub of: Measured,
    /// Particle set, or a list of sets: the union of them; of what strains make, such as stresses, a set of cells.
    pub on: String,
    /// What is taken of the values of its particles; left out, the mean, for forces, moments, fluxes, energies of cells and
    /// fracture energies the sum, of von Mises' stress, Tresca's, the greatest principal stress and the failure index the largest, of the least
    /// principal stress and the reserve factor the least.
    pub take: Option<Take>,
    /// Component that is taken, in the un-turned frame; of damage, energies, pressures, densities, levels, fluxes, principal stresses and what
    /// is made of them and of plies, which are numbers, none. Stresses, membrane forces and bending moments are those along it, at rest, in the
    /// surface; a principal angle is counted from it.
    pub direction: Option<[f64; 3]>,
    /// Point about which a moment is taken \[L\]; left out, the origin.
    pub about: Option<[f64; 3]>,
    /// Name of the joint whose force or moment is taken; left out, that of all joints of the body.
    pub joint: Option<String>,
    /// Face of a shell at which a stress is taken, or the middle of its thickness; of a stress of a ply, of that ply. Left out, of principal stresses,
    /// von Mises' and Tresca's the worse of both faces.
    pub face: Option<ShellFace>,
    /// Number of the ply, from the lowest, 1; left out, of reserve factors and failure indices the worst of all.
    pub ply: Option<PlyNumber>,
    /// Stress of a ply that is taken, in the axes of its fibre.
    pub component: Option<PlyComponent>,
    /// Criterion of a reserve factor or a failure index.
    pub criterion: Option<Criterion>,
    /// Takes a stress or a section force of a shell at the particles of the set, edges among them, from those at the middles of the cells round each.
    #[serde(default)]
    pub recovered: bool,
    /// Point at which a pressure, over which a level is measured \[L\]: on a fluid it stays, on walls it goes with them.
    pub at: Option<[f64; 3]>,
    /// Line of a plane, face in space, through which a flux is measured; of a section force or moment the cut.
    pub through: Option<Through>,
    /// Factor on the value, such as 4 for the reaction of a quarter model.
    #[serde(default = "one")]
    pub factor: f64,
    /// Unit in which the column is written, such as `mm`, `kN` or `MPa`; left out, that of the scene. Values are converted. `-` beside a factor
    /// that divides by a quantity of the same kind: a ratio.
    pub unit: Option<String>,
}

/// What a column takes of the values of its particles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Take {
    /// Their mean.
    Mean,
    /// Their sum.
    Sum,
    /// The largest.
    Max,
    /// The least.
    Min,
}

impl Probe {
    /// What it takes of the values of its particles.
    pub fn taken(&self) -> Take {
        self.take.unwrap_or_else(|| Take::usual(self.of))
    }
}

impl Take {
    /// What is taken where nothing is said: the sum of forces, moments and energies that add up, the largest of what fails by its size and of depths, the
    /// least of gaps and of what fails by being small, else the mean.
    pub fn usual(of: Measured) -> Self {
        match of {
            Measured::Reaction
            | Measured::ContactForce
            | Measured::ContactMoment
            | Measured::GlueForce
            | Measured::LinkForce
            | Measured::JointForce
            | Measured::JointMoment
            | Measured::TouchingArea
            | Measured::FractureEnergy
            | Measured::FrictionLoss
            | Measured::PlasticWork
            | Measured::Force
            | Measured::Moment
            | Measured::ReactionMoment
            | Measured::SectionForce
            | Measured::SectionMoment
            | Measured::Energy
            | Measured::HeldHeat
            | Measured::Flux => Self::Sum,
            Measured::VonMises
            | Measured::Tresca
            | Measured::MaxPrincipal
            | Measured::FailureIndex
            | Measured::GreatestDepth
            | Measured::PlasticStrain => Self::Max,
            Measured::ContactGap | Measured::Thickness | Measured::MinPrincipal | Measured::ReserveFactor => {
                Self::Min
            }
            _ => Self::Mean,
        }
    }
}

/// What a column measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Measured {
    /// Component of the displacement \[L\].
    Displacement,
    /// Component of the position \[L\].
    Position,
    /// Component of the force that the supports exert \[F\].
    Reaction,
    /// Component of the force that its tools, and a shell that touches itself, exert on it \[F\]; of all of a shell its own forces cancel.
    ContactForce,
    /// Component of the moment that its tools exert on a shell about a point \[F L\].
    ContactMoment,
    /// Gap between the face of a shell, at its particles, and that of the nearest tool, of the shell itself or of another body, negative where they are in each
    /// other \[L\]; to other bodies up to ten times the distance at which they touch, to itself up to half of the thickness, which stand for all beyond.
    ContactGap,
    /// Depth of contact of a shell, at its particles and its share of the middles of cells, over the distance of its middle at which faces
    /// touch \[–\]: mid-surfaces come through at one. The largest of a set.
    GreatestDepth,
    /// Area of a shell that touches \[L²\].
    TouchingArea,
    /// Component of the force that glue exerts on the body \[F\].
    GlueForce,
    /// Component of the force that links exert on the body \[F\].
    LinkForce,
    /// Component of the force that a joint, or all of its joints, exert on a rigid body \[F\].
    JointForce,
    /// Component of the moment about a point of what a joint, or all of its joints, exert on a rigid body \[F L\]: about the place of a joint that of its couple
    /// alone.
    JointMoment,
    /// Component of the way from where glue holds a particle to where it is \[L\]: of particles of sets that are glued.
    GlueGap,
    /// Energy that friction has taken of a body \[F L\]: on tools, and one half of what it took where it rubs on another or, a shell, on itself.
    FrictionLoss,
    /// Equivalent plastic strain of a body that yields, the greatest through the thickness of a shell and of the cells round a particle \[–\]. The largest of a set.
    PlasticStrain,
    /// Thickness of a shell that yields, the least of the cells round a particle \[L\]. The least of a set.
    Thickness,
    /// Energy that plastic flow has dissipated in a shell or a Galerkin solid \[F L\].
    PlasticWork,
    /// Pressure of what cells of a shell enclose, on the set of its load \[F/L²\].
    EnclosedPressure,
    /// Volume that cells of a shell enclose, with what its load has beside, on the set of the load \[L³\].
    EnclosedVolume,
    /// Axial force of the stiffeners of a shell at a particle, the mean of the pieces that end there \[F\].
    BarForce,
    /// Their bending moment about their centroid, positive where it stretches the side to which normals point \[F L\].
    BarMoment,
    /// Component of the moment that the supports of a shell, or of a solid of bonds in space, exert about a point \[F L\].
    ReactionMoment,
    /// Angle by which the director has turned about the direction, counted on beyond π \[rad\].
    Rotation,
    /// Component of the director \[–\].
    Director,
    /// Component of the velocity, in analyses in time \[L/T\].
    Velocity,
    /// Component of the acceleration, in analyses of vibration \[L/T²\].
    Acceleration,
    /// Share of the bonds of a node of a solid that are broken \[–\].
    Damage,
    /// Energy of the broken bonds of a node of a solid \[F L\].
    FractureEnergy,
    /// Number of pieces of a solid, whose nodes whole bonds join \[–\].
    Pieces,
    /// Stored energy by volume at a node of a solid \[F/L²\].
    StrainEnergy,
    /// Von Mises' stress at the faces of a homogeneous shell, or at nodes of a solid \[F/L²\].
    VonMises,
    /// Normal stress along a direction at a face of a homogeneous shell, or at nodes of a solid \[F/L²\].
    Stress,
    /// Greatest principal stress, of a homogeneous shell in its surface \[F/L²\].
    MaxPrincipal,
    /// Least principal stress, of a homogeneous shell in its surface \[F/L²\].
    MinPrincipal,
    /// Tresca's stress, twice the greatest shear stress: the greatest difference of principal stresses, of a shell that of zero across it among them \[F/L²\].
    Tresca,
    /// Angle about the normal of a homogeneous shell from a direction to the axis of the greatest principal stress, from −π/2 to π/2 \[rad\].
    PrincipalAngle,
    /// Stress of a ply of a shell in the axes of its fibre \[F/L²\].
    PlyStress,
    /// Factor on the stresses of a shell at which a criterion says that it fails, the least of its plies \[–\]; 1000 stands for all beyond.
    ReserveFactor,
    /// What a criterion says of the stresses of a shell, one at failure, the greatest of its plies \[–\].
    FailureIndex,
    /// Component of the force that goes through a cut of a shell: with which what lies beyond pulls at the rest \[F\].
    SectionForce,
    /// Component of the moment that goes through a cut of a shell, about a point \[F L\].
    SectionMoment,
    /// Membrane force of a shell along a direction, by length across it \[F/L\].
    MembraneForce,
    /// Bending moment of a shell along a direction, by length across it, about the particles \[F L/L\].
    BendingMoment,
    /// Transverse shear force of a shell across a direction, by length \[F/L\].
    ShearForce,
    /// Energy stored by the strains of cells of a shell \[F L\].
    Energy,
    /// Pressure of a fluid: of its particles, before a wall, or at a point; zero where that is dry \[F/L²\].
    Pressure,
    /// Density of the particles of a fluid \[F T²/L⁴\].
    Density,
    /// Height of the surface of a fluid over places of a wall, or over a point, against gravity from the origin \[L\].
    Level,
    /// Length of the line through a point, along gravity, that lies in a fluid, as a gauge of wire tells it: sheets that
    /// fly over the surface count as thick as they are \[L\].
    WetLength,
    /// Component of the force of a fluid on walls or on a structure \[F; by depth in a plane F/L\]. A column `NAME_mean` beside it
    /// has the mean since the last record: the impulse over the time. In the corners of a basin each side has what acts along its normal,
    /// and an equal part of what acts along the edge, so that the floor bears the weight of still water; if the basin turns, equal parts.
    Force,
    /// Component of the moment of the forces of a fluid on walls or on a structure \[F L; by depth in a plane F\]. A column
    /// `NAME_mean` beside it has the mean since the last record.
    Moment,
    /// Volume of a fluid at rest that flows through a line or a face in a time \[L³/T; by depth in a plane L²/T\].
    Flux,
    /// Temperature of a shell that conducts heat \[Θ\].
    Temperature,
    /// Heat that enters a shell where its temperature is held \[F L/T\].
    HeldHeat,
}

impl Measured {
    /// Its word in a scene.
    pub fn word(self) -> &'static str {
        match self {
            Self::Displacement => "displacement",
            Self::Position => "position",
            Self::Reaction => "reaction",
            Self::ContactForce => "contact-force",
            Self::ContactMoment => "contact-moment",
            Self::ContactGap => "contact-gap",
            Self::GreatestDepth => "greatest-depth",
            Self::TouchingArea => "touching-area",
            Self::GlueForce => "glue-force",
            Self::LinkForce => "link-force",
            Self::JointForce => "joint-force",
            Self::JointMoment => "joint-moment",
            Self::GlueGap => "glue-gap",
            Self::FrictionLoss => "friction-loss",
            Self::PlasticStrain => "plastic-strain",
            Self::Thickness => "thickness",
            Self::PlasticWork => "plastic-work",
            Self::EnclosedPressure => "enclosed-pressure",
            Self::EnclosedVolume => "enclosed-volume",
            Self::BarForce => "bar-force",
            Self::BarMoment => "bar-moment",
            Self::ReactionMoment => "reaction-moment",
            Self::VonMises => "von-mises",
            Self::Stress => "stress",
            Self::MaxPrincipal => "max-principal",
            Self::MinPrincipal => "min-principal",
            Self::Tresca => "tresca",
            Self::PrincipalAngle => "principal-angle",
            Self::PlyStress => "ply-stress",
            Self::ReserveFactor => "reserve-factor",
            Self::FailureIndex => "failure-index",
            Self::SectionForce => "section-force",
            Self::SectionMoment => "section-moment",
            Self::MembraneForce => "membrane-force",
            Self::BendingMoment => "bending-moment",
            Self::ShearForce => "shear-force",
            Self::Energy => "energy",
            Self::Rotation => "rotation",
            Self::Director => "director",
            Self::Velocity => "velocity",
            Self::Acceleration => "acceleration",
            Self::Damage => "damage",
            Self::FractureEnergy => "fracture-energy",
            Self::Pieces => "pieces",
            Self::StrainEnergy => "strain-energy",
            Self::Pressure => "pressure",
            Self::Density => "density",
            Self::Level => "level",
            Self::WetLength => "wet-length",
            Self::Force => "force",
            Self::Moment => "moment",
            Self::Flux => "flux",
            Self::Temperature => "temperature",
            Self::HeldHeat => "held-heat",
        }
    }
}

fn one() -> f64 {
    1.0
}
