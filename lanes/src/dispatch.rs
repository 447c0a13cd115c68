//! Runs a sweep with the widest vectors of the machine it finds itself on.
//!
//! The workspace is built for the oldest processor of its architecture; a sweep runs as a second copy where AVX2 is
//! present. No fused multiply-add is generated (the compiler may not contract), so both copies give the same bits.

use super::{Lanes, Plain};

/// A piece of work over lanes.
pub trait Sweep {
    /// What it gives back.
    type Output;

    /// Does the work; only code that is inlined into it is compiled for the lanes.
    fn run<L: Lanes>(self, lanes: L) -> Self::Output;
}

/// Runs a sweep in the copy for this machine.
pub fn widest<S: Sweep>(sweep: S) -> S::Output {
    #[cfg(target_arch = "x86_64")]
    if let Some(lanes) = pulp::x86::V3::try_new() {
        return lanes.vectorize(Wide { sweep, lanes });
    }
    sweep.run(Plain)
}

/// A sweep on its way into the copy with AVX2.
#[cfg(target_arch = "x86_64")]
struct Wide<S> {
    sweep: S,
    lanes: pulp::x86::V3,
}

#[cfg(target_arch = "x86_64")]
impl<S: Sweep> pulp::NullaryFnOnce for Wide<S> {
    type Output = S::Output;

    #[inline(always)]
    fn call(self) -> S::Output {
        self.sweep.run(self.lanes)
    }
}
