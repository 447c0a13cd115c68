//! The step of a law whose yield stress grows with the rate, or whose back stresses recover: Armstrong and Frederick's, several of them as Chaboche has them.
//!
//! In uniaxial tension a back stress X grows by `dX = H dε_p − g X dα`: from H to nothing as it nears H/g. A step of backward Euler has, in the coordinates of
//! [`super::modes`],
//!
//! ```text
//! b_k' = q_k (b_k + ⅔H_k γ ξ)     q_k = 1/(1 + g_k Δα)     γ = Δα/r²Y
//! ξ_i (1 + (p_i + ⅔H) γ + Σ_k ⅔H_k q_k γ) = ξ_i⁰ − Σ_k q_k b_k,i                f(Δα) = √(Σ p_i ξ_i²) = r Y(α + Δα)
//! ```
//!
//! H the modulus of the linear one beside them, ξ⁰ the trial stress without them. The unknown is Δα; `r Y/f − 1` is nearly linear in it, and Newton's method takes a
//! number of steps that is the same everywhere. [armstrong1966], [chaboche1986].
//!
//! Where the yield stress grows with the rate ([`super::rate`]) a step of the duration Δt has `Y = (1 + s) K(α + Δα)` and `Δα = Δt ε̇(s)`, the unknown s: `r Y/f − 1` is convex in
//! it. From the lesser of two bounds, the s of a step without flow, f(0)/rK − 1, and that of the flow which the step would have without overstress, Newton's steps fall
//! to the root. Outside a commit no time passes, and s stays what the last one found.
//!
//! Each back stress stores `Σ p_i b_i²/(2·⅔H)` and dissipates `g Δα Σ p_i b_i²/⅔H`. The step has no potential: its tangent is not symmetric, and the
//! symmetric half stands for it.

use super::functions::{above_zero, three};
use super::hardening::Yield;
use super::point::{BackStress, Backs, Committed, Pace, Point};
use super::rate::Rate;
use super::return_map::{ON_THE_SURFACE, PointLaw};
use crate::pack::{Arithmetic, Number, Pack};

/// Newton's steps behind the first; four reach the surface to rounding.
const STEPS: usize = 5;
/// Newton's steps for the overstress; five leave 1e-7.
const RATED_STEPS: usize = 6;

/// A step under way: the trial stress without back stresses that recover, and these.
struct Step<'a, P> {
    law: &'a PointLaw,
    over: [P; 3],
    backs: &'a Backs<P>,
    alpha: P,
    tiny: P,
}

/// What a step is at one value of its unknown.
struct At<P> {
    gamma: P,
    /// ξ and how it grows with the unknown.
    over: [P; 3],
    growth: [P; 3],
    /// f², and its half of the growth.
    square: P,
    turn: P,
    /// γ by the unknown.
    gamma_growth: P,
}

impl<P: Number> Step<'_, P> {
    /// At a flow Δα and the yield stress there, with what both grow by.
    #[inline(always)]
    fn at(&self, [flow, growth]: [P; 2], now: &Yield<P>) -> At<P> {
        let (one, law) = (flow.all(1.0), self.law);
        let per = 1.0 / (law.root * law.root);
        let part = flow / now.stress;
        let gamma = part * per;
        let gamma_growth = (growth - part * now.slope) / now.stress * per;
        let (mut trial, mut trial_growth) = (self.over, three(|_| flow.all(0.0)));
        let [mut softer, mut softer_growth] = [flow.all(0.0); 2];
        for (back, b) in law.backs.iter().zip(self.backs) {
            let q = one / (one + flow * back.recovery);
            let q_growth = q * q * growth * -back.recovery;
            for i in 0..3 {
                trial[i] = trial[i] - q * b[i];
                trial_growth[i] = trial_growth[i] - q_growth * b[i];
            }
            softer += q * gamma * back.own();
            softer_growth += (q_growth * gamma + q * gamma_growth) * back.own();
        }
        let (mut over, mut change) = (trial, trial_growth);
        let [mut square, mut turn] = [self.tiny, flow.all(0.0)];
        for i in 0..3 {
            let p = law.yielding[i];
            let share = one / (one + gamma * (p + law.kinematic) + softer);
            over[i] = trial[i] * share;
            change[i] =
                (trial_growth[i] - over[i] * (gamma_growth * (p + law.kinematic) + softer_growth)) * share;
            square += over[i] * over[i] * p;
            turn += over[i] * change[i] * p;
        }
        At { gamma, over, growth: change, square, turn, gamma_growth }
    }

    /// Yield stress at a flow, with an overstress, and its growth with the unknown where the overstress stays.
    #[inline(always)]
    fn yields(&self, flow: P, overstress: Option<P>) -> Yield<P> {
        self.law.yields(self.alpha + flow, overstress)
    }

    /// Newton's step of `r Y/f − 1` from where it is.
    #[inline(always)]
    fn newton(&self, at: &At<P>, now: &Yield<P>) -> P {
        let (size, r) = (at.square.sqrt(), self.law.root);
        (size - now.stress * r) * at.square / ((now.slope * at.square - now.stress * at.turn) * r)
    }

    /// Δα without rates, or with an overstress that stays.
    #[inline(always)]
    fn slow(&self, held: Option<P>) -> P {
        let [zero, one] = [self.alpha.all(0.0), self.alpha.all(1.0)];
        let mut flow = zero;
        for _ in 0..=STEPS {
            let now = self.yields(flow, held);
            let at = self.at([flow, one], &now);
            flow = (flow + self.newton(&at, &now)).max(zero);
        }
        flow
    }

    /// The overstress of a step of a duration \[T\] whose flow without it is given; zero or less where the rate does nothing.
    #[inline(always)]
    fn rated(&self, rate: &Rate, duration: f64, slow: P, size: P) -> [P; 2] {
        let [zero, one] = [self.alpha.all(0.0), self.alpha.all(1.0)];
        let limit = self.yields(zero, None).stress * self.law.root;
        let of_slow = rate.overstress(slow * (1.0 / duration)).max(zero);
        let mut s = of_slow.min((size / limit - one).max(zero));
        for _ in 0..RATED_STEPS {
            let (at, now) = self.at_overstress(rate, duration, s);
            s = (s + self.newton(&at, &now)).max(zero);
        }
        let fast = above_zero(of_slow) * above_zero(slow);
        [slow + (rate.flow(s, duration)[0] - slow) * fast, s * fast]
    }

    #[inline(always)]
    fn at_overstress(&self, rate: &Rate, duration: f64, s: P) -> (At<P>, Yield<P>) {
        let [flow, growth] = rate.flow(s, duration);
        let now = self.yields(flow, Some(s));
        let slope = now.stress / (s + s.all(1.0)) + now.slope * growth;
        let now = Yield { stress: now.stress, slope };
        (self.at([flow, growth], &now), now)
    }
}

impl PointLaw {
    /// Yield stress and slope of slow flow, or with an overstress.
    #[inline(always)]
    fn yields<P: Number>(&self, alpha: P, overstress: Option<P>) -> Yield<P> {
        let slow = self.hardening().at(alpha);
        match overstress {
            None => slow,
            Some(s) => Yield { stress: slow.stress + slow.stress * s, slope: slow.slope + slow.slope * s },
        }
    }

    /// ξ of a point that stays as it is, its back stresses that recover taken off what is left without them.
    #[inline(always)]
    fn without<P: Number>(&self, over: &[P; 3], backs: &Backs<P>) -> [P; 3] {
        let mut out = *over;
        for (_, b) in self.backs.iter().zip(backs) {
            for i in 0..3 {
                out[i] = out[i] - b[i];
            }
        }
        out
    }

    /// [`PointLaw::step`] of such a law, from the trial stress and that less the linear back stress.
    #[inline(always)]
    pub(super) fn flow_step<P: Number>(
        &self,
        stress: &[P; 3],
        over: &[P; 3],
        committed: &Committed<P>,
        pace: Pace<P>,
    ) -> Point<P> {
        let (stress, over, Committed { plastic, alpha, backs }) = (*stress, *over, *committed);
        let zero = alpha.all(0.0);
        let held = if let Pace::Held(s) = pace { Some(s) } else { None };
        let limit = self.yields(alpha, held).stress * self.root;
        let tiny = limit * limit * 1e-32;
        let trial = self.without(&over, &backs);
        let mut square = tiny;
        for i in 0..3 {
            square += trial[i] * trial[i] * self.yielding[i];
        }
        let size = square.sqrt();
        let beyond = size - limit * (1.0 - ON_THE_SURFACE);
        if beyond.below(0.0) {
            let overstress = held.unwrap_or(zero);
            return Point { stress, plastic, alpha, gamma: zero, over: trial, on_surface: zero, overstress };
        }
        let step = Step { law: self, over, backs: &backs, alpha, tiny };
        let slow = step.slow(held);
        let (flow, overstress) = match (pace, &self.rate) {
            (Pace::Lasting(duration), Some(rate)) => {
                let [flow, s] = step.rated(rate, duration, slow, size);
                (flow, Some(s))
            }
            _ => (slow, held),
        };
        let now = step.yields(flow, overstress);
        let At { gamma, over, .. } = step.at([flow, zero], &now);
        let back = three(|i| gamma * over[i] * self.yielding[i]);
        Point {
            stress: three(|i| stress[i] - back[i]),
            plastic: three(|i| plastic[i] + back[i]),
            alpha: alpha + flow,
            gamma,
            over,
            on_surface: above_zero(beyond),
            overstress: overstress.unwrap_or(zero),
        }
    }

    /// A back stress behind a step from a committed α.
    #[inline(always)]
    pub(super) fn moved<P: Number>(&self, number: usize, b: &[P; 3], point: &Point<P>, alpha: P) -> [P; 3] {
        let (back, one) = (&self.backs[number], alpha.all(1.0));
        let q = one / (one + (point.alpha - alpha) * back.recovery);
        three(|i| q * (b[i] + point.gamma * point.over[i] * back.own()))
    }

    /// What back stresses that recover store by volume \[F/L²\].
    #[inline(always)]
    pub(super) fn stored_in<P: Number>(&self, backs: &Backs<P>, zero: P) -> P {
        let mut sum = zero;
        for (back, b) in self.backs.iter().zip(backs) {
            for i in 0..3 {
                sum += b[i] * b[i] * (0.5 * self.yielding[i] / back.own());
            }
        }
        sum
    }

    /// What a step lets back stresses recover by volume, `Σ g Δα Σ p_i b_i²/⅔H` with those behind it \[F/L²\].
    #[inline(always)]
    pub(super) fn recovered<P: Number>(&self, backs: &Backs<P>, flow: P) -> P {
        let mut sum = flow.all(0.0);
        for (back, b) in self.backs.iter().zip(backs) {
            for i in 0..3 {
                sum += b[i] * b[i] * flow * (back.recovery * self.yielding[i] / back.own());
            }
        }
        sum
    }

    /// The symmetric half of `∂x/∂e` of the step from a committed point, as [`PointLaw::tangent`] has it.
    ///
    /// With m_i the share that ξ_i keeps of its trial, `n_i = m_i p_i ξ_i/(f (r Y' − f'))` and primes the growth with Δα it is
    /// `diag(1 − γ p m) − p (γ ξ)' nᵀ`.
    pub(super) fn flow_tangent(&self, point: &Point<Pack>, alpha: Pack, backs: &Backs<Pack>) -> [Pack; 6] {
        let [zero, one] = [Pack::ZERO, Pack::splat(1.0)];
        let flow = point.alpha - alpha;
        let now = self.yields(point.alpha, self.rate.map(|_| point.overstress));
        let limit = now.stress * self.root;
        // The trial stress is not kept: ξ is, and its growth follows from it.
        let q = |back: &BackStress| one / (one + flow * back.recovery);
        let softer = self.backs.iter().fold(zero, |sum, back| sum + q(back) * point.gamma * back.own());
        let m: [Pack; 3] =
            std::array::from_fn(|i| one / (one + point.gamma * (self.yielding[i] + self.kinematic) + softer));
        let mut trial: [Pack; 3] = std::array::from_fn(|i| point.over[i] / m[i]);
        for (back, b) in self.backs.iter().zip(backs) {
            for i in 0..3 {
                trial[i] += q(back) * b[i];
            }
        }
        let At { over, growth, square, turn, gamma_growth, .. } =
            Step { law: self, over: trial, backs, alpha, tiny: limit * limit * 1e-32 }.at([flow, one], &now);
        let size = square.sqrt();
        let slope = (now.slope * self.root - turn / size) * size;
        let on = |value: Pack| value * point.on_surface / slope.max(Pack::splat(1e-300));
        let p = self.yielding;
        let n: [Pack; 3] = std::array::from_fn(|i| on(m[i] * over[i] * p[i]));
        let turned: [Pack; 3] =
            std::array::from_fn(|i| (gamma_growth * over[i] + point.gamma * growth[i]) * p[i]);
        let entry = |i: usize, j: usize| {
            let kept = if i == j { one - point.gamma * m[i] * p[i] } else { zero };
            kept - (turned[i] * n[j] + turned[j] * n[i]) * 0.5
        };
        [entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inelastic::hardening::Hardening;
    use crate::inelastic::modes::Modes;
    use crate::inelastic::point::MOST_BACK_STRESSES;
    use crate::section::Isotropic;

    /// `rK/f − 1` at random points, at once from strains of a yield strain to a thousand of them, with one to three back stresses far from their ends and beyond.
    #[test]
    fn the_steps_reach_the_yield_surface() {
        let mut seed = 3_u64;
        let mut unit = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let modes = Modes::von_mises(&Isotropic::new(2e5, 0.3).unwrap());
        let (mut worst, mut flowed) = ([0.0_f64; 2], 0);
        for number in 0..60_000 {
            let hardening = match number % 3 {
                0 => Hardening::linear(250.0, 0.0).unwrap(),
                1 => Hardening::voce(250.0, 200.0, 12.0).unwrap(),
                _ => Hardening::swift(500.0, 0.01, 0.2).unwrap(),
            };
            let mut size = |low: f64, high: f64| low * libm::pow(high / low, unit());
            let mut backs = Vec::new();
            for _ in 0..=number % MOST_BACK_STRESSES {
                backs.push(BackStress::new(size(1e2, 1e5), size(1.0, 2000.0)).unwrap());
            }
            let law = PointLaw::new(&modes, hardening, 0.0).with(backs, None);
            let strain = size(1.0, 1000.0);
            // Stresses are in units of the square root of energy: p x² is that of σ².
            let yield_size = |p: f64| 250.0 / p.sqrt();
            let mut signed = |most: f64| most * (2.0 * unit() - 1.0);
            let mut over = [0.0; 3];
            for (x, p) in over.iter_mut().zip(law.yielding) {
                *x = signed(strain * yield_size(p));
            }
            let mut committed: Backs<f64> = [[0.0; 3]; MOST_BACK_STRESSES];
            for (b, back) in committed.iter_mut().zip(&law.backs) {
                for (b, p) in b.iter_mut().zip(law.yielding) {
                    *b = signed((back.modulus / back.recovery).min(1e3) / p.sqrt());
                }
            }
            let alpha = 0.1 * unit();
            let point = law.flow_step(
                &over,
                &over,
                &Committed { plastic: [0.0; 3], alpha, backs: committed },
                Pace::Slow,
            );
            if point.alpha > alpha {
                flowed += 1;
                let square: f64 = (0..3).map(|i| law.yielding[i] * point.over[i] * point.over[i]).sum();
                let off = law.root * law.yields(point.alpha, None).stress / square.sqrt() - 1.0;
                let large = usize::from(point.alpha - alpha > 0.01);
                worst[large] = worst[large].max(off.abs());
            }
        }
        println!("{worst:?}, {flowed} flowed");
        assert!(flowed > 40_000, "{flowed}");
        // 9e-16, of three steps 2e-9.
        assert!(worst[0] < 3e-15 && worst[1] < 3e-15, "{worst:?}");
    }
}
