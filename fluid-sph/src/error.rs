//! Why a fluid could not be built, or not be put into a state.

/// A fluid that was refused before anything ran.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FluidError {
    /// An option out of bounds.
    #[error("{key} is {value}; it must be {bound}")]
    Option {
        /// The option.
        key: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        bound: &'static str,
    },
    /// Neither a plane nor space.
    #[error("a fluid of {0} dimensions; it must have 2 (the plane z = 0) or 3")]
    Dimensions(usize),
    /// No particles.
    #[error("the fluid has no particle; a spacing below the size of its region gives it some")]
    Empty,
    /// More particles than numbers of 32 bits tell apart.
    #[error("{0} particles are more than 4.2e9; coarsen the spacing")]
    TooMany(usize),
    /// A list of another length than that of the particles.
    #[error("{what} has {found} entries, {expected} are needed; give one each")]
    Length {
        /// Which list.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The length needed.
        expected: usize,
    },
    /// A number that is none.
    #[error("{what} {index} is not finite; check what places it")]
    NotFinite {
        /// Of what.
        what: &'static str,
        /// Its number.
        index: usize,
    },
    /// Two particles too near to each other.
    #[error(
        "particle {particle} of the fluid is {distance:.3} spacings from {other}; at least 0.5 are needed: remove one of them"
    )]
    Overlap {
        /// The particle of the fluid.
        particle: usize,
        /// What it is too near to.
        other: String,
        /// Their distance over the spacing.
        distance: f64,
    },
    /// A particle outside the domain.
    #[error("particle {0} of the fluid lies outside the domain; enlarge the domain or remove the particle")]
    Outside(usize),
    /// Thin structures beyond those that can be distinguished.
    #[error("{0} thin structures wet by one fluid; at most 16 can be distinguished: join some of them")]
    ThinStructures(usize),
    /// A boundary that does not fit its layout.
    #[error("structure {structure}: {what} has {found} entries, its layout needs {expected}")]
    Boundary {
        /// The structure.
        structure: usize,
        /// Which list.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The length needed.
        expected: usize,
    },
    /// What one process marches alone.
    #[error("{0} is marched by one process alone; start it as one, with threads")]
    NotShared(&'static str),
    /// A period shorter than the kernel is wide, or across a plane.
    #[error(
        "the period along {axis} is {period}; it must be at least {least:.6} in the plane or space of the fluid, twice the reach of the kernel"
    )]
    Period {
        /// Along which axis.
        axis: &'static str,
        /// The period given \[L\].
        period: f64,
        /// The least \[L\].
        least: f64,
    },
    /// What periodic sides do not go with.
    #[error("{0} does not go with periodic sides; remove one of the two")]
    NotPeriodic(&'static str),
    /// An opening that cannot be.
    #[error("opening {number} {what}")]
    Opening {
        /// Which of them.
        number: usize,
        /// What is wrong, and what to do.
        what: &'static str,
    },
    /// What openings do not go with.
    #[error("{0} does not go with openings; remove one of the two")]
    NotOpen(&'static str),
    /// An axis of no length.
    #[error("the axis of rotation of wall {0} has no length; give a direction")]
    Axis(usize),
    /// An array of a state that this fluid does not have, or of another length.
    #[error(
        "the state has no array {0} of the length that this fluid needs; take the state of the same fluid"
    )]
    State(&'static str),
}
