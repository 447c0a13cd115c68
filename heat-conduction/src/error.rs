//! Why no temperatures are found.

use implicit_statics::EquilibriumError;

/// Why no temperatures are found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ConductionError {
    /// A node held at two temperatures.
    #[error("particle {particle} is held at {} and at {}", temperatures[0], temperatures[1])]
    Contradiction {
        /// The particle.
        particle: u32,
        /// The temperatures \[Θ\].
        temperatures: [f64; 2],
    },
    /// A piece whose temperature nothing tells.
    #[error(
        "nothing tells the temperature of the piece with particle {particle}: hold a set of it, or let it give heat to a film or by radiation"
    )]
    Untold {
        /// A particle of it.
        particle: u32,
    },
    /// A particle that stores no heat.
    #[error("particle {particle} must store heat, but what it stores by degree is {capacity}")]
    Capacity {
        /// The particle.
        particle: u32,
        /// Heat by degree \[F L/Θ\].
        capacity: f64,
    },
    /// Temperatures that no step follows.
    #[error(
        "at time {time} not even a step of {step:.3e} keeps to the tolerance; allow more, or see whether courses and units are meant so"
    )]
    Step {
        /// Time that was reached \[T\].
        time: f64,
        /// The shortest step \[T\].
        step: f64,
    },
    /// A cell that is colder or warmer than its table of conductivities knows.
    #[error(
        "cell {cell} would be at {temperature:.6}, but its table of conductivities goes from {} to {}; let it go farther", ends[0], ends[1]
    )]
    Table {
        /// The cell.
        cell: usize,
        /// Mean of its corners \[Θ\].
        temperature: f64,
        /// Ends of the table \[Θ\].
        ends: [f64; 2],
    },
    /// Radiation or tables of conductivities that found no balance.
    #[error(
        "no balance of heat after {iterations} iterations; see whether emissivity, temperatures and absolute zero are in the same units, and give tables of conductivities that fall fast more degrees to do so"
    )]
    NotFound {
        /// Iterations made.
        iterations: usize,
    },
    /// A surface that radiates and would be colder than absolute zero.
    #[error(
        "particle {particle} would be at {temperature:.6}, below absolute zero, {zero}: more heat is taken off than any temperature gives; see signs, and absolute zero"
    )]
    BelowZero {
        /// The particle, or one beside the place.
        particle: u32,
        /// Its temperature in balance \[Θ\].
        temperature: f64,
        /// Absolute zero \[Θ\].
        zero: f64,
    },
    /// A matrix that cannot be solved.
    #[error(transparent)]
    Balance(#[from] EquilibriumError),
}
