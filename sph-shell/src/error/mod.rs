//! Why a shell could not be built.

use sph_core::SpaceError;

mod enclosed;
mod heat;
mod stiffener;

pub use enclosed::EnclosedError;
pub use heat::HeatError;
pub use stiffener::StiffenerError;

/// A shell that was refused before anything ran.
#[derive(Clone, Debug, thiserror::Error)]
pub enum ShellError {
    /// The cloud or its stencils are invalid.
    #[error(transparent)]
    Space(#[from] SpaceError),
    /// A stiffener that makes no sense.
    #[error(transparent)]
    Stiffener(#[from] StiffenerError),
    /// A couple along the normal of a particle with nothing around it.
    #[error(
        "particle {0} has no cell around it that would turn about its normal under a couple; give the set cells, or a couple across the normal"
    )]
    DrillingAlone(u32),
    /// Density must be positive and finite.
    #[error("density is {0}; it must be positive and finite")]
    Density(f64),
    /// Joined particles under a formulation that is not sampled at cells.
    #[error(
        "sheets that meet along a line need strains sampled at cells; use the formulation stress-point with the support cell"
    )]
    JunctionOfWideStencils,
    /// Joined particles whose directors run along one line, about which nothing would resist.
    #[error(
        "the sheets that meet at particle {particle} are parallel: the sine of the greatest angle between their normals is {sine:.1e}, at least {bound} is needed; give them one particle there, or keep them apart"
    )]
    ParallelDirectors {
        /// A particle of the place.
        particle: u32,
        /// Sine of the greatest angle.
        sine: f64,
        /// What it must be.
        bound: f64,
    },
    /// A tool of a shape without sense.
    #[error(transparent)]
    Tool(#[from] contact::ToolError),
    /// A tool that pushes with no stiffness.
    #[error("a tool has the stiffness {0}; it must be positive and finite")]
    ToolStiffness(f64),
    /// A tool with a friction that is negative or not finite.
    #[error("a tool has the friction {0}; it needs one of zero or more")]
    ToolFriction(f64),
    /// Tools on a shell that is particles alone.
    #[error("tools touch cells, and the cloud has none; give it cells, or leave the tools out")]
    ToolWithoutCells,
    /// Tools on sections that do not lie in the middle of their particles.
    #[error(
        "tools reckon with half of the thickness on both sides of the particles, but the section of cell {cell} lies over or below them; give it no height"
    )]
    ToolOnOffset {
        /// The first such cell.
        cell: usize,
    },
    /// Contact that pushes with no stiffness.
    #[error("a contact has the stiffness {0}; it must be positive and finite")]
    ContactStiffness(f64),
    /// Contact of a shell that is particles alone with itself.
    #[error("contact is that of cells, and the cloud has none; give it cells, or leave the contact out")]
    ContactWithoutCells,
    /// Contact of sections that do not lie in the middle of their particles.
    #[error(
        "contact reckons with half of the thickness on both sides of the particles, but the section of cell {cell} lies over or below them; give it no height"
    )]
    ContactOnOffset {
        /// The first such cell.
        cell: usize,
    },
    /// Contact of a shell with itself where its thickness is not one.
    #[error(
        "a shell that touches itself has one thickness, this one goes from {least:.4e} to {most:.4e}; give its parts one, or leave the contact out"
    )]
    ContactOfThicknesses {
        /// Least thickness \[L\].
        least: f64,
        /// Greatest thickness \[L\].
        most: f64,
    },
    /// Contact of a shell with itself whose edges lie on its own cells.
    #[error(
        "edges that are tied lie on the cells below them, which contact of the shell with itself would push away; join the sheets at a junction, or leave the contact out"
    )]
    ContactOfTies,
    /// Ties under a formulation that is not sampled at cells.
    #[error("ties hang particles on cells; use the formulation stress-point with the support cell")]
    TieOfWideStencils,
    /// An edge away from what it is tied to.
    #[error(
        "particle {particle} of the edge is {distance:.4e} away from the nearest cell of its host; at most {bound:.4e} can be tied, half of both thicknesses or a tenth of the cell: move the edge there, or name the cells below it"
    )]
    TieTooFar {
        /// Number of the tie.
        tie: usize,
        /// The particle.
        particle: u32,
        /// Its distance \[L\].
        distance: f64,
        /// The greatest that is taken \[L\].
        bound: f64,
    },
    /// A host much coarser than the edge.
    #[error(
        "more than {bound} particles of the edge hang on cell {cell} of the host, whose shape they would all have to take; refine the host along the edge"
    )]
    TieTooCoarse {
        /// Number of the tie.
        tie: usize,
        /// The cell.
        cell: u32,
        /// Particles that may hang on a cell.
        bound: usize,
    },
    /// An edge all of whose particles are the host's.
    #[error(
        "every particle of the edge belongs to the host already, by its cells or by a junction; remove the tie, or name the edge of the other sheet and the cells below it"
    )]
    TieWithoutEdge {
        /// Number of the tie.
        tie: usize,
    },
    /// A tied particle with supports that its host does not have.
    #[error(
        "particle {particle} is tied and goes where its host goes, and a support holds or moves it in a way that it does not hold or move the host below; support the host there, or leave the particle out of the set"
    )]
    TieHeld {
        /// The particle.
        particle: u32,
    },
    /// Edges that hang on each other.
    #[error(
        "the tie of particle {particle} leads back to itself: edges hang on each other in a circle; leave one of the ties out"
    )]
    TieInACircle {
        /// The particle.
        particle: u32,
    },
    /// A particle number beyond the cloud.
    #[error("{what} names particle {particle}, but the cloud has {count} particles (numbered from 0)")]
    NoSuchParticle {
        /// Who named it.
        what: &'static str,
        /// The number.
        particle: u32,
        /// Particles in the cloud.
        count: usize,
    },
    /// A cell number beyond the cloud.
    #[error("{what} names cell {cell}, but the cloud has {count} cells (numbered from 0)")]
    NoSuchCell {
        /// Who named it.
        what: &'static str,
        /// The number.
        cell: u32,
        /// Cells in the cloud.
        count: usize,
    },
    /// What cells cannot enclose.
    #[error(transparent)]
    Enclosed(#[from] EnclosedError),
    /// What cannot be heated.
    #[error(transparent)]
    Heat(#[from] HeatError),
    /// What one process marches alone.
    #[error("{0} is marched by one process alone; start one, with as many threads as there are cores")]
    NotShared(&'static str),
    /// A mass that is none.
    #[error("the mass at particle {particle} is {mass}; it must be positive and finite")]
    Mass {
        /// The particle.
        particle: u32,
        /// The mass \[M\].
        mass: f64,
    },
    /// A spring that is none.
    #[error(
        "the spring at particle {particle} has the stiffness {stiffness}; it must be positive and finite"
    )]
    Spring {
        /// The particle.
        particle: u32,
        /// The stiffness \[F/L\].
        stiffness: f64,
    },
    /// A spring between a particle and itself.
    #[error("a spring joins particle {particle} with itself; name two sets without a particle in common")]
    SpringOnItself {
        /// The particle.
        particle: u32,
    },
    /// A spring against turning about the director.
    #[error(
        "the axis of a spring against turning lies along the director of particle {particle}: the sine of the angle between them is {sine:.1e}, at least {bound} is needed; take an axis along the surface"
    )]
    SpringAlongDirector {
        /// The particle.
        particle: u32,
        /// The sine.
        sine: f64,
        /// What it must be.
        bound: f64,
    },
    /// A spring of rigid sets that is none.
    #[error(
        "a spring on rigid set {set} with the stiffness {stiffness}: there must be such a set, two of them for a spring between two, and the stiffness must be positive and finite"
    )]
    SpringOfBody {
        /// Number of the set.
        set: usize,
        /// The stiffness \[F/L, F L\].
        stiffness: f64,
    },
    /// A rigid set where strains are not sampled in cells.
    #[error("a rigid set wants strains sampled in cells; use the formulation by cells")]
    RigidOfWideStencils,
    /// A particle of two rigid sets, or twice in one.
    #[error("particle {particle} belongs to two rigid sets; take it out of one of them, or make them one")]
    RigidTwice {
        /// The particle.
        particle: u32,
    },
    /// A supported particle in a rigid set.
    #[error(
        "particle {particle} of a rigid set has a support of its own; a rigid set is supported as a whole: put the support on the name of the rigid set, or take the particle out of one of the two"
    )]
    RigidHeld {
        /// The particle.
        particle: u32,
    },
    /// A tied particle in a rigid set.
    #[error(
        "particle {particle} of a rigid set is tied to the cells of another sheet and goes where they go; take it out of the rigid set, or make the cells below it rigid"
    )]
    RigidHangs {
        /// The particle.
        particle: u32,
    },
    /// A junction that lies in a rigid set in part.
    #[error(
        "particle {particle} shares its place at a junction with a particle of a rigid set to which it does not belong; a rigid set takes all particles of a place"
    )]
    RigidInPart {
        /// The particle.
        particle: u32,
    },
    /// A rigid set without two places side by side.
    #[error(
        "rigid set {set} has no two particles side by side, so nothing tells how it turns about the normal; take in a neighbour, or lump a mass there"
    )]
    RigidOnALine {
        /// Number of the set.
        set: usize,
    },
    /// A mass or inertia that no body has.
    #[error(
        "rigid set {set} has the mass {mass} and {least} as its least principal moment of inertia; neither may be negative"
    )]
    RigidInertia {
        /// Number of the set.
        set: usize,
        /// The mass \[M\].
        mass: f64,
        /// The moment \[M L²\].
        least: f64,
    },
    /// Supports of a rigid set that contradict each other.
    #[error("the supports of rigid set {set} cannot all be: {what}")]
    RigidOpposed {
        /// Number of the set.
        set: usize,
        /// Which they are, and the repair.
        what: &'static str,
    },
    /// A cell in two regions.
    #[error("cell {cell} lies in two regions; take it out of one of them")]
    TwoRegions {
        /// The cell.
        cell: u32,
    },
    /// Regions where strains are not sampled in cells.
    #[error("several sections want strains sampled in cells; use the formulation by cells")]
    RegionsWithoutCells,
    /// A section with memory where no point would keep its history, or one that is not linear under an initial stress.
    #[error("a section with memory, or one of several that is not linear, {0}")]
    OwnLaw(&'static str),
    /// Initial stresses where strains are not sampled in cells.
    #[error("an initial stress wants strains sampled in cells; use the formulation by cells")]
    StressOfWideStencils,
    /// A direction of an initial stress that has none in the surface.
    #[error(
        "the axis of initial stress {number} stands on the surface in cell {cell}; take a direction that lies along the surface in all of its cells"
    )]
    StressAxis {
        /// Number of the stress.
        number: usize,
        /// The cell.
        cell: u32,
    },
    /// A load or support on nothing.
    #[error("{0} acts on an empty set; name a set that holds at least one particle or cell")]
    EmptySet(&'static str),
    /// An edge load on particles that do not lie on an edge in a row.
    #[error("{0} needs at least two particles in a row along an edge of the shell")]
    NotAnEdge(&'static str),
    /// Supports that contradict each other.
    #[error(
        "particle {particle} is prescribed to move by {wanted:.6e} along a direction its other supports hold to {held:.6e}; remove one of them"
    )]
    Contradiction {
        /// The particle.
        particle: u32,
        /// The motion asked for.
        wanted: f64,
        /// What the other supports leave of it.
        held: f64,
    },
    /// A director is to stay in a plane in which it does not lie.
    #[error(
        "support {support} holds the director of particle {particle} in a plane from which it stands out by {along:.3e} (its component along the normal, at most 1e-6); choose a normal along the surface"
    )]
    OutOfPlane {
        /// Number of the support in [`crate::Parts`].
        support: usize,
        /// The particle.
        particle: u32,
        /// `D·ν`.
        along: f64,
    },
    /// A section that has no one plane to lean in.
    #[error(
        "support {support} holds the whole section at particle {particle}, whose director lies along the axis, or which joins sheets at an angle; let it hold displacements only, or clamp what must not turn"
    )]
    SectionAlongAxis {
        /// Number of the support in [`crate::Parts`].
        support: usize,
        /// The particle.
        particle: u32,
    },
    /// A director that one support turns and another holds or turns as well.
    #[error(
        "support {rotated} turns the director of particle {particle}, which support {other} holds or turns as well; remove one of them, or let support {other} hold displacements only"
    )]
    HeldDirector {
        /// The particle.
        particle: u32,
        /// Number of the support that turns it in [`crate::Parts`].
        rotated: usize,
        /// Number of the other.
        other: usize,
    },
    /// Two motions with different amplitudes on one particle.
    #[error("particle {0} is moved by two supports with different amplitudes; give it one")]
    TwoMotions(u32),
    /// A particle without a positive area.
    #[error("particle {particle} has area {area:.3e}; every particle must carry a positive area")]
    Area {
        /// The particle.
        particle: usize,
        /// Its area \[L²\].
        area: f64,
    },
    /// A shell whose places are kept from an origin, in a fluid, whose places are not.
    #[error(
        "the places of this shell are kept from an origin, those of a fluid from zero; build it without an origin"
    )]
    WetFromAfar,
    /// A spacing of the fluid that is none.
    #[error("the spacing of the fluid is {0}; it must be positive and finite")]
    WetSpacing(f64),
    /// A wet face without points.
    #[error(
        "a wet face has no rows of points; ask for at least one, three reach as far as the kernel of a fluid"
    )]
    NoRows,
    /// A shell that is to meet a plane fluid and does not stand across its plane.
    #[error(
        "the row of particle {particle} across the plane z = 0 is {width:.6e} wide, that of the first particle {first:.6e}; in a plane fluid a shell is a strip along z of one width, two particles or more"
    )]
    NotAStrip {
        /// A particle of the row.
        particle: u32,
        /// Width of its row \[L\].
        width: f64,
        /// Width of the first row \[L\].
        first: f64,
    },
}
