//! Runs a loop with the widest vectors of the machine it finds itself on.
//!
//! The workspace is built for the oldest processor of its architecture; the sweep runs as a second copy where AVX2 is
//! present. No fused multiply-add is generated (the compiler may not contract), so both copies give the same bits.

use pulp::NullaryFnOnce;

/// Runs `work` in the copy for this machine; only code that is inlined into it is compiled twice.
pub(crate) fn widest<W: NullaryFnOnce>(work: W) -> W::Output {
    pulp::Arch::new().dispatch(work)
}
