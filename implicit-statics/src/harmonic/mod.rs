//! Steady vibration about a state under loads that go as cos ωt, frequency by frequency: directly, and in modes.
//!
//! ```text
//! (κK + (iωα − ω²) M) u = p        u(t) = Re[u exp(iωt)]
//! κ = 1 + iη      structural       κ = 1 + iωβ     Rayleigh, C = αM + βK
//! ```
//!
//! K is the tangent of the state, M the diagonal masses of modes, p the load of level one.

mod complex;
mod direct;
mod motion;
mod reduced;

pub use complex::Complex;
pub use direct::DirectResponse;
pub use motion::{CycleEnergies, EnergyForms, HarmonicMotion};
pub use reduced::ReducedResponse;

/// What takes energy out of a steady vibration.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum HarmonicDamping {
    /// Nothing.
    #[default]
    None,
    /// The same part of the critical damping in each mode \[–\]; in modes alone.
    Ratio(f64),
    /// `C = αM + βK`.
    Rayleigh {
        /// α \[1/T\].
        mass: f64,
        /// β \[T\].
        stiffness: f64,
    },
    /// A loss factor η: `K (1 + iη)`, as much energy in a cycle at any frequency \[–\].
    Structural(f64),
}

impl HarmonicDamping {
    /// α \[1/T\] and Im κ \[–\] at a circular frequency; of a ratio none, which is that of a mode.
    pub fn at(self, omega: f64) -> (f64, f64) {
        match self {
            Self::None | Self::Ratio(_) => (0.0, 0.0),
            Self::Rayleigh { mass, stiffness } => (mass, omega * stiffness),
            Self::Structural(loss) => (0.0, loss),
        }
    }

    /// The part of the critical damping that a mode has at its own frequency \[–\]: half of the width of its peak where the amplitude is 1/√2
    /// of the greatest, over the frequency.
    pub fn ratio(self, natural: f64) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Ratio(ratio) => ratio,
            Self::Rayleigh { mass, stiffness } => 0.5 * (mass / natural + stiffness * natural),
            Self::Structural(loss) => 0.5 * loss,
        }
    }
}
