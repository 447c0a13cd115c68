//! The control of cells whose section yields: it relaxes with the flow of the section.
//!
//! Held as if they were elastic, zero-energy modes of a cell that flows would cost what no hinge does. Their pulls S on s1…s6 stand for stresses that differ from
//! those in the middle of the cell, by δσ; both on the yield surface, they flow at one rate γ, and what `ε̇_p = γ̇ P σ` takes from the difference is
//!
//! ```text
//! δσ̇ = C (δε̇ − γ̇ P δσ)        or, with p the mean of CP,        Ṡ = k ṡ − p γ̇ S
//! ```
//!
//! a spring k and a damper in series, with the flow of the section for its clock: no rate, and no number that is chosen but the least χ, .02, which keeps its
//! stiffness. A step of backward Euler keeps the share χ of S and of what it adds, `S = χ (S' + k Δs)`, with χ = 1/(1 + pγ) in the mean over the section
//! ([`shell_kinematics::Memory::kept_share`]); it is that of the step before, so that a
//! step has a potential:
//!
//! ```text
//! S = S⁰ + χ⁰ k (s − s⁰)            commit: S⁰ ← χ S,  s⁰ ← s,  χ⁰ ← χ
//! ```
//!
//! The energy S²/2χk never rises at a commit: it is multiplied by χ χ⁰. Levels twice as many halve the error.

use shell_kinematics::{Number, Pack};

use crate::registers::{Registers, in_all};

/// Pulls of four cells where their history was committed last, and the share that the step before kept.
#[derive(Clone, Debug)]
pub(crate) struct YieldingControl<P = Pack> {
    /// χ⁰ \[–\].
    kept: P,
    /// S⁰ by a unit of s1…s6.
    pull: [P; 6],
    /// s⁰.
    at: [P; 6],
    /// Work done on the control until then \[F L\].
    work: P,
}

impl Default for YieldingControl {
    fn default() -> Self {
        Self { kept: Pack::splat(1.0), pull: [Pack::ZERO; 6], at: [Pack::ZERO; 6], work: Pack::ZERO }
    }
}

impl<P: Number> YieldingControl<P> {
    /// `χ⁰ k` of s1…s6.
    #[inline(always)]
    pub fn stiffnesses(&self, at_rest: [P; 6]) -> [P; 6] {
        let mut left = at_rest;
        for k in &mut left {
            *k = *k * self.kept;
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
    pub fn load<const P: usize, R: Registers<P>>(
        of: [&Self; P],
        registers: R,
    ) -> YieldingControl<R::Numbers> {
        YieldingControl {
            kept: registers.load(in_all(of, |of| &of.kept)),
            pull: registers.loads(in_all(of, |of| &of.pull)),
            at: registers.loads(in_all(of, |of| &of.at)),
            work: registers.load(in_all(of, |of| &of.work)),
        }
    }

    /// Commits s1…s6; `kept` is the share χ that the flow on the way there leaves.
    pub fn commit(&mut self, at_rest: [Pack; 6], s: &[Pack; 6], kept: Pack) {
        let (pulls, work) = self.pulls(at_rest, s);
        *self = Self { kept, pull: pulls.map(|pull| pull * kept), at: *s, work };
    }

    /// Work done on the control until the last commit \[F L\].
    pub fn work(&self) -> Pack {
        self.work
    }

    /// All that a commit changes.
    pub fn numbers(&self) -> [Pack; Self::PACKS] {
        let Self { kept, pull: [a, b, c, d, e, f], at: [g, h, i, j, k, l], work } = *self;
        [kept, a, b, c, d, e, f, g, h, i, j, k, l, work]
    }

    /// Takes up what [`YieldingControl::numbers`] gave.
    pub fn take_up(&mut self, numbers: [Pack; Self::PACKS]) {
        let [kept, a, b, c, d, e, f, g, h, i, j, k, l, work] = numbers;
        *self = Self { kept, pull: [a, b, c, d, e, f], at: [g, h, i, j, k, l], work };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STIFFNESS: f64 = 3.0;

    /// One component of the pulls.
    fn pull(control: &YieldingControl, s: f64) -> (f64, f64) {
        let (pulls, work) = control.pulls([Pack::splat(STIFFNESS); 6], &[Pack::splat(s); 6]);
        (pulls[3].lanes()[0], work.lanes()[0] / 6.0)
    }

    fn commit(control: &mut YieldingControl, s: f64, kept: f64) {
        control.commit([Pack::splat(STIFFNESS); 6], &[Pack::splat(s); 6], Pack::splat(kept));
    }

    /// Pulled along a way with the flow of a path: `S = k τ₀ (1 − e^(−τ))` where s and τ = ∫pγ̇ grow together, to the first order of the step.
    #[test]
    fn steps_of_any_number_approach_spring_and_damper_in_series() {
        let (way, flow) = (0.4, 2.0);
        let exact = STIFFNESS * way / flow * (1.0 - libm::exp(-flow));
        let off = |steps: u32| {
            let mut control = YieldingControl::default();
            let part = 1.0 / f64::from(steps);
            for step in 1..=steps {
                commit(&mut control, way * part * f64::from(step), 1.0 / (1.0 + flow * part));
            }
            pull(&control, way).0 / exact - 1.0
        };
        let errors = [10, 20, 40, 80].map(off);
        println!("{errors:?}");
        // 1.80, 1.89, 1.94.
        for pair in errors.windows(2) {
            assert!((1.75..2.0).contains(&(pair[0] / pair[1])), "{errors:?}");
        }
    }

    /// Whatever it goes through, it never gives back more work than was done on it, nor does a commit change what it has stored but downwards.
    #[test]
    fn no_path_takes_work_out_of_it() {
        let mut seed = 7_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let (mut least, mut most) = (f64::MAX, 0.0_f64);
        for _ in 0..200 {
            let (mut control, mut s, mut kept) = (YieldingControl::default(), 0.0, 1.0);
            for _ in 0..100 {
                s += random() - 0.5;
                let next = if random() < 0.5 { 1.0 } else { random().max(0.02) };
                let (force, work) = pull(&control, s);
                let stored = force * force / (2.0 * kept * STIFFNESS);
                commit(&mut control, s, next);
                let after = pull(&control, s).0;
                let left = after * after / (2.0 * next * STIFFNESS);
                assert!(left <= stored * (1.0 + 1e-12), "{stored} {left}");
                (least, most) = (least.min(work - stored), most.max(work));
                kept = next;
            }
        }
        assert!(least > -1e-12 * most, "{least:e} {most}");
    }
}
