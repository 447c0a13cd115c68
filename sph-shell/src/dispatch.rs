//! Runs a piece of work with the widest registers of the machine it finds itself on.
//!
//! The workspace is built for the oldest processor of its architecture. Where AVX2 is present, the sweeps of a step run
//! as a second copy compiled for it. Those of the default step have a third for AVX-512, eight numbers wide. No fused
//! multiply-add is generated (the compiler may not contract), so all copies give the same bits; tests compare them.

#[cfg(target_arch = "x86_64")]
use std::sync::LazyLock;

#[cfg(target_arch = "x86_64")]
use fearless_simd::{Simd, x86::Avx512};

#[cfg(target_arch = "x86_64")]
use crate::eights::Eights;
use crate::registers::{Baseline, Registers};

/// A piece of work, written once for any registers of four numbers.
pub(crate) trait Work {
    /// What it gives back.
    type Output;

    /// Does the work; only code that is inlined into it is compiled for the registers.
    fn run<R: Registers>(self, registers: R) -> Self::Output;
}

/// A piece of work, written once for any registers.
pub(crate) trait WideWork {
    /// What it gives back.
    type Output;

    /// Does the work; only code that is inlined into it is compiled for the registers.
    fn run<const P: usize, R: Registers<P>>(self, registers: R) -> Self::Output;
}

/// Runs `work` in the copy for this machine.
pub(crate) fn widest<W: Work>(work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    if let Some(lanes) = pulp::x86::V3::try_new() {
        return lanes.vectorize(Wide { work, lanes });
    }
    work.run(Baseline)
}

/// The same in a third copy where there is AVX-512.
pub(crate) fn fullest<W: WideWork>(work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    if let (Some(more), Some(lanes)) = (*MORE, pulp::x86::V3::try_new()) {
        return more.vectorize(
            #[inline(always)]
            || work.run(Eights::new(lanes, more)),
        );
    }
    widest(Narrow(work))
}

/// The registers of AVX-512, if they are there.
#[cfg(target_arch = "x86_64")]
static MORE: LazyLock<Option<Avx512>> = LazyLock::new(|| fearless_simd::Level::new().as_avx512());

/// Work for any registers, in those of four numbers.
pub(crate) struct Narrow<W>(pub W);

impl<W: WideWork> Work for Narrow<W> {
    type Output = W::Output;

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) -> W::Output {
        self.0.run(registers)
    }
}

/// Work on its way into the copy with AVX2.
#[cfg(target_arch = "x86_64")]
struct Wide<W> {
    work: W,
    lanes: pulp::x86::V3,
}

#[cfg(target_arch = "x86_64")]
impl<W: Work> pulp::NullaryFnOnce for Wide<W> {
    type Output = W::Output;

    #[inline(always)]
    fn call(self) -> W::Output {
        self.work.run(self.lanes)
    }
}
