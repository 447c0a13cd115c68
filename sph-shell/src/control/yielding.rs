//! The control of cells whose section yields: it follows the share of the section that does not flow.
//!
//! Zero-energy modes of a cell that flows everywhere would be held as if it were elastic, and a hinge would cost what no hinge does. With S the
//! six pulls of a cell on s1…s6, k their stiffness at rest and ψ the share of the section that did not flow when it was committed last
//! ([`shell_kinematics::Memory::free_share`]),
//!
//! ```text
//! S = S⁰ + ψ⁰ k (s − s⁰)            commit: S⁰ ← S min(1, ψ/ψ⁰),  s⁰ ← s,  ψ⁰ ← ψ
//! ```
//!
//! so that the energy S²/2ψk never rises at a commit: what a cell was loaded with while stiff is not handed out by a soft one.

use shell_kinematics::{Number, Pack};

use crate::registers::Registers;

/// Pulls of four cells where their history was committed last, and the share of their stiffness that is left.
#[derive(Clone, Debug)]
pub(crate) struct YieldingControl<P = Pack> {
    /// ψ⁰ \[–\].
    free: P,
    /// S⁰ by a unit of s1…s6.
    pull: [P; 6],
    /// s⁰.
    at: [P; 6],
    /// Work done on the control until then \[F L\].
    work: P,
}

impl Default for YieldingControl {
    fn default() -> Self {
        Self { free: Pack::splat(1.0), pull: [Pack::ZERO; 6], at: [Pack::ZERO; 6], work: Pack::ZERO }
    }
}

impl<P: Number> YieldingControl<P> {
    /// `ψ⁰ k` of s1…s6.
    #[inline(always)]
    pub fn stiffnesses(&self, at_rest: [P; 6]) -> [P; 6] {
        let mut left = at_rest;
        for k in &mut left {
            *k = *k * self.free;
        }
        left
    }

    /// S at s1…s6, without what the scale of the curvature adds to the pulls at s4, s5, and the work that was done on it \[F L\].
    #[inline(always)]
    pub fn pulls(&self, at_rest: [P; 6], s: &[P; 6]) -> ([P; 6], P) {
        let (k, mut pulls, mut work) = (self.stiffnesses(at_rest), self.pull, self.work);
        for i in 0..6 {
            let way = s[i] - self.at[i];
            let more = k[i] * way;
            work += (self.pull[i] + more * 0.5) * way;
            pulls[i] += more;
        }
        (pulls, work)
    }
}

impl YieldingControl {
    /// Numbers that change with a commit.
    pub const PACKS: usize = 14;

    /// Itself in registers.
    #[inline(always)]
    pub fn load<R: Registers>(&self, registers: R) -> YieldingControl<R::Four> {
        YieldingControl {
            free: registers.load(&self.free),
            pull: registers.loads(&self.pull),
            at: registers.loads(&self.at),
            work: registers.load(&self.work),
        }
    }

    /// Commits s1…s6; `free` is the share of the section that did not flow on the way there.
    pub fn commit(&mut self, at_rest: [Pack; 6], s: &[Pack; 6], free: Pack) {
        let (pulls, work) = self.pulls(at_rest, s);
        let (now, before) = (free.lanes(), self.free.lanes());
        let kept = Pack::from_fn(|lane| (now[lane] / before[lane]).min(1.0));
        *self = Self { free, pull: pulls.map(|pull| pull * kept), at: *s, work };
    }

    /// Work done on the control until the last commit \[F L\].
    pub fn work(&self) -> Pack {
        self.work
    }

    /// All that a commit changes.
    pub fn numbers(&self) -> [Pack; Self::PACKS] {
        let Self { free, pull: [a, b, c, d, e, f], at: [g, h, i, j, k, l], work } = *self;
        [free, a, b, c, d, e, f, g, h, i, j, k, l, work]
    }

    /// Takes up what [`YieldingControl::numbers`] gave.
    pub fn take_up(&mut self, numbers: [Pack; Self::PACKS]) {
        let [free, a, b, c, d, e, f, g, h, i, j, k, l, work] = numbers;
        *self = Self { free, pull: [a, b, c, d, e, f], at: [g, h, i, j, k, l], work };
    }
}
