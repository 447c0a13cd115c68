//! Warnings about a number: what may be wrong with a result, and the figure that says so.

use serde::{Deserialize, Serialize};

/// What is doubtful, as a word that a script can look for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum WarningKind {
    /// A load level was left before the motion had died, or far out of balance.
    NotSettled,
    /// A state of rest that the shell would leave at the least disturbance.
    Unstable,
    /// A critical point was passed, and what follows is not what the shell would do.
    PassedCritical,
    /// The loads have no potential: part of their stiffness is skew, and the tangent leaves it out.
    NoPotential,
    /// Fewer modes were found than asked for.
    FewerModes,
    /// Natural frequencies among those of a steady vibration that nothing damps.
    Undamped,
    /// Frequencies of a steady vibration that are too far apart for its peaks.
    CoarseFrequencies,
    /// A steady vibration in modes up to frequencies where those left out count.
    TruncatedModes,
    /// Modes softer, or of another damping, than the response spectrum goes.
    BeyondSpectrum,
    /// Modes in still water that make waves of its surface.
    SurfaceWaves,
    /// A buckling level that hangs on the change of shape before buckling.
    ChangedShape,
    /// The formulation conserves neither momentum nor energy.
    StrongForm,
    /// Strains sampled at the particles lock, or are off at edges.
    NodalLocking,
    /// Stencils wider than a cell on a thin shell.
    WideThin,
    /// Uneven cells on a thin curved shell lock its membrane, or soften it.
    UnevenCells,
    /// Too few cells to a bending length √(Rt).
    CoarseBending,
    /// Neighbouring cells turn too far from one to the next.
    CoarseTurn,
    /// A handful of particles from end to end.
    FewParticles,
    /// A fold with one director for both sides.
    SharpFold,
    /// Cells between two junctions that are one cell apart.
    TiedBothSides,
    /// Edges tied inside cells of their host that hand over couples.
    TieBetweenLines,
    /// A sheet of few cells from a junction to its edge.
    ShallowSheet,
    /// A beam of thin walls with few cells a wall.
    ThinProfile,
    /// A stiffener deep for its length on wide cells.
    DeepStiffener,
    /// Sections high over their particles where masses count.
    OffsetInertia,
    /// A body that turns freely with the rotary inertia of its masses in time, which is not its own.
    ScaledInertia,
    /// Patterns of single cells among the modes of a sheet in tension.
    PatternModes,
    /// A run that sets out under stresses that nothing balances.
    NotAtRest,
    /// Cells with sharp corners.
    SharpCorners,
    /// Quadrangles of a file that are warped.
    PoorMesh,
    /// Many triangles round one particle.
    Pole,
    /// A load most of which supports bear at once.
    HeldLoad,
    /// A load that does no work.
    NoWork,
    /// A set whose nearest particle is far from its point.
    FarNearest,
    /// A body too thick for a shell.
    TooThick,
    /// Cells that lie on each other.
    Overlap,
    /// A horizon shorter or longer than what was found to serve cracks.
    OddHorizon,
    /// Spacings of a block that differ much from axis to axis.
    FlatCells,
    /// Few layers of nodes across a member that bends, at rest or in modes.
    FewLayers,
    /// A motion prescribed on less than the depth of the horizon.
    ThinLayer,
    /// The displacement of a loaded face on which bonds are missing.
    LoadedFace,
    /// A solid of bonds that is touched through a skin that lacks bonds.
    SoftSkin,
    /// Parts of a filled surface are too thin for nodes of their own.
    ThinFins,
    /// A fluid that was compressed more than its method bears.
    Compressed,
    /// A speed of sound too low for the speed that the fluid reached.
    SlowSound,
    /// Water that ran, in a fluid whose artificial viscosity brakes thin fronts.
    LateFront,
    /// A wall with gaps through which a fluid may leak.
    LeakyWall,
    /// Fluid beyond the closed sides of a basin.
    LostFluid,
    /// A smoothing length at which a lattice of fluid particles resists shear.
    StiffLattice,
    /// A coupling that feeds energy into structures.
    FluidFirst,
    /// A structure that gets, or may get, into a wall, which it does not feel.
    NoContact,
    /// A closed fluid that walls compress, and that has less pressure for it than it should.
    SoftWalls,
    /// Water at a face of a shell that the scene leaves dry.
    DryFace,
    /// Boundaries that pull on a fluid and give way.
    PullingBoundary,
    /// Bonds that broke in states of balance: a lattice holds a crack on each of its rows.
    BrokenAtRest,
    /// Supports that fix nodal parameters, which are no displacements.
    LeakySupport,
    /// A face of a thin solid that is held along its thickness and may turn.
    HeldFace,
    /// A basis that locks in bending at the spacing of its nodes.
    ShearLocking,
    /// Strains beyond those that the law was made for.
    LargeStrain,
    /// A linear answer that is not small.
    LargeLinear,
    /// Temperatures that swing over beside what is held where it jumps.
    HeatOvershoot,
    /// Numbers of a material that stay those of the whole heat while its part goes with the level.
    WholeHeat,
    /// Faces that are far in each other.
    DeepContact,
    /// Cells that sag far towards a round tool.
    CoarseContact,
    /// Steps in time that contact made much shorter.
    ShortenedStep,
    /// Modes and levels of a touched state in which contact would not stay as it was.
    FrozenContact,
    /// Bodies between which no contact is named, or parts of a shell, that are in each other.
    TouchingUnseen,
    /// Glue between bodies that gives way as the bodies do.
    SoftGlue,
    /// Few points through the thickness of a section that yields.
    FewSlices,
    /// Plastic strains beyond the last row of a table of hardening.
    BeyondData,
    /// Much of the work goes into the control of zero-energy modes of cells that yield.
    StiffControl,
    /// A liquid that pulls at what encloses it.
    PullingLiquid,
    /// Hinges along clamped edges that are wide for the span.
    CoarseHinge,
    /// A level that leads what yields or rubs elsewhere than small steps do.
    LargeHistoryStep,
    /// Cells of a shell that yields which are drawn thin and harden by less than that.
    Necking,
    /// States at which a march came to rest without a look at whether they are stable.
    StabilityUnknown,
    /// Energy that comes or goes in a march without a book that says whence or whither.
    OpenBalance,
}

impl WarningKind {
    /// The word, as `summary.json` has it.
    pub fn word(self) -> &'static str {
        match self {
            Self::NotSettled => "not-settled",
            Self::Unstable => "unstable",
            Self::PassedCritical => "passed-critical",
            Self::NoPotential => "no-potential",
            Self::FewerModes => "fewer-modes",
            Self::Undamped => "undamped",
            Self::CoarseFrequencies => "coarse-frequencies",
            Self::TruncatedModes => "truncated-modes",
            Self::BeyondSpectrum => "beyond-spectrum",
            Self::SurfaceWaves => "surface-waves",
            Self::ChangedShape => "changed-shape",
            Self::StrongForm => "strong-form",
            Self::NodalLocking => "nodal-locking",
            Self::WideThin => "wide-thin",
            Self::UnevenCells => "uneven-cells",
            Self::CoarseBending => "coarse-bending",
            Self::CoarseTurn => "coarse-turn",
            Self::FewParticles => "few-particles",
            Self::SharpFold => "sharp-fold",
            Self::TiedBothSides => "tied-both-sides",
            Self::TieBetweenLines => "tie-between-lines",
            Self::ShallowSheet => "shallow-sheet",
            Self::ThinProfile => "thin-profile",
            Self::DeepStiffener => "deep-stiffener",
            Self::OffsetInertia => "offset-inertia",
            Self::ScaledInertia => "scaled-inertia",
            Self::PatternModes => "pattern-modes",
            Self::NotAtRest => "not-at-rest",
            Self::SharpCorners => "sharp-corners",
            Self::PoorMesh => "poor-mesh",
            Self::Pole => "pole",
            Self::HeldLoad => "held-load",
            Self::NoWork => "no-work",
            Self::FarNearest => "far-nearest",
            Self::TooThick => "too-thick",
            Self::Overlap => "overlap",
            Self::OddHorizon => "odd-horizon",
            Self::FlatCells => "flat-cells",
            Self::FewLayers => "few-layers",
            Self::ThinLayer => "thin-layer",
            Self::LoadedFace => "loaded-face",
            Self::SoftSkin => "soft-skin",
            Self::ThinFins => "thin-fins",
            Self::Compressed => "compressed",
            Self::SlowSound => "slow-sound",
            Self::LateFront => "late-front",
            Self::LeakyWall => "leaky-wall",
            Self::LostFluid => "lost-fluid",
            Self::StiffLattice => "stiff-lattice",
            Self::FluidFirst => "fluid-first",
            Self::NoContact => "no-contact",
            Self::SoftWalls => "soft-walls",
            Self::DryFace => "dry-face",
            Self::PullingBoundary => "pulling-boundary",
            Self::BrokenAtRest => "broken-at-rest",
            Self::LeakySupport => "leaky-support",
            Self::HeldFace => "held-face",
            Self::ShearLocking => "shear-locking",
            Self::LargeStrain => "large-strain",
            Self::LargeLinear => "large-linear",
            Self::HeatOvershoot => "heat-overshoot",
            Self::WholeHeat => "whole-heat",
            Self::DeepContact => "deep-contact",
            Self::CoarseContact => "coarse-contact",
            Self::ShortenedStep => "shortened-step",
            Self::FrozenContact => "frozen-contact",
            Self::TouchingUnseen => "touching-unseen",
            Self::SoftGlue => "soft-glue",
            Self::FewSlices => "few-slices",
            Self::BeyondData => "beyond-data",
            Self::StiffControl => "stiff-control",
            Self::PullingLiquid => "pulling-liquid",
            Self::CoarseHinge => "coarse-hinge",
            Self::LargeHistoryStep => "large-history-step",
            Self::Necking => "necking",
            Self::StabilityUnknown => "stability-unknown",
            Self::OpenBalance => "open-balance",
        }
    }
}

/// A number that may be wrong, and why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Warning {
    /// What is doubtful.
    pub kind: WarningKind,
    /// What was found, its bound and the repair, in one sentence.
    pub message: String,
}

impl Warning {
    /// A warning with its message.
    pub fn new(kind: WarningKind, message: impl Into<String>) -> Self {
        Self { kind, message: message.into() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_word_is_the_one_in_the_summary() {
        for kind in [
            WarningKind::NotSettled,
            WarningKind::Unstable,
            WarningKind::PassedCritical,
            WarningKind::LargeHistoryStep,
            WarningKind::ChangedShape,
            WarningKind::NoPotential,
            WarningKind::FewerModes,
            WarningKind::Undamped,
            WarningKind::CoarseFrequencies,
            WarningKind::TruncatedModes,
            WarningKind::BeyondSpectrum,
            WarningKind::SurfaceWaves,
            WarningKind::StrongForm,
            WarningKind::NodalLocking,
            WarningKind::PatternModes,
            WarningKind::ScaledInertia,
            WarningKind::NotAtRest,
            WarningKind::WideThin,
            WarningKind::UnevenCells,
            WarningKind::CoarseBending,
            WarningKind::CoarseTurn,
            WarningKind::FewParticles,
            WarningKind::SharpFold,
            WarningKind::TiedBothSides,
            WarningKind::TieBetweenLines,
            WarningKind::ShallowSheet,
            WarningKind::ThinProfile,
            WarningKind::DeepStiffener,
            WarningKind::OffsetInertia,
            WarningKind::SharpCorners,
            WarningKind::PoorMesh,
            WarningKind::Pole,
            WarningKind::HeldLoad,
            WarningKind::NoWork,
            WarningKind::FarNearest,
            WarningKind::TooThick,
            WarningKind::Overlap,
            WarningKind::OddHorizon,
            WarningKind::FlatCells,
            WarningKind::FewLayers,
            WarningKind::ThinLayer,
            WarningKind::LoadedFace,
            WarningKind::SoftSkin,
            WarningKind::ThinFins,
            WarningKind::Compressed,
            WarningKind::SlowSound,
            WarningKind::LateFront,
            WarningKind::LeakyWall,
            WarningKind::LostFluid,
            WarningKind::StiffLattice,
            WarningKind::FluidFirst,
            WarningKind::NoContact,
            WarningKind::SoftWalls,
            WarningKind::DryFace,
            WarningKind::PullingBoundary,
            WarningKind::BrokenAtRest,
            WarningKind::LeakySupport,
            WarningKind::HeldFace,
            WarningKind::ShearLocking,
            WarningKind::LargeStrain,
            WarningKind::LargeLinear,
            WarningKind::HeatOvershoot,
            WarningKind::WholeHeat,
            WarningKind::DeepContact,
            WarningKind::CoarseContact,
            WarningKind::ShortenedStep,
            WarningKind::FrozenContact,
            WarningKind::TouchingUnseen,
            WarningKind::SoftGlue,
            WarningKind::StabilityUnknown,
            WarningKind::OpenBalance,
        ] {
            assert_eq!(serde_json::to_value(kind).unwrap(), kind.word());
        }
    }
}
