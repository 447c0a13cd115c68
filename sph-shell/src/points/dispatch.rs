//! Runs a loop with the widest vectors of the machine it finds itself on.
//!
//! The workspace is built for the oldest processor of its architecture. Where AVX2 is present, the two
//! sweeps of a step run as a second copy compiled for it. No fused multiply-add is generated (the
//! compiler may not contract), so both copies give the same bits; a test compares them.

use pulp::NullaryFnOnce;

/// Runs `work` in the copy for this machine.
///
/// Only code that is inlined into `work` is compiled twice.
pub(crate) fn widest<W: NullaryFnOnce>(work: W) -> W::Output {
    pulp::Arch::new().dispatch(work)
}
