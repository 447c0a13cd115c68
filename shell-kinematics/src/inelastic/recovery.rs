//! Back stresses that recover: Armstrong and Frederick's law, several of them side by side as Chaboche has them.
//!
//! In uniaxial tension a back stress X grows by `dX = H dε_p − g X dα`: from H to nothing as it nears H/g. A step of backward Euler has, in the coordinates of
//! [`super::modes`],
//!
//! ```text
//! b_k' = q_k (b_k + ⅔H_k γ ξ)     q_k = 1/(1 + g_k Δα)     γ = Δα/r²Y
//! ξ_i (1 + (p_i + ⅔H) γ + Σ_k ⅔H_k q_k γ) = ξ_i⁰ − Σ_k q_k b_k,i                f(Δα) = √(Σ p_i ξ_i²) = r Y(α + Δα)
//! ```
//!
//! H the modulus of the linear one beside them, ξ⁰ the trial stress without them. The unknown is Δα, or the overstress where the yield stress grows with the rate;
//! `r Y/f − 1` is nearly linear in Δα, and Newton's method takes a number of steps that is the same everywhere. [armstrong1966], [chaboche1986].
//!
//! Each back stress stores `Σ p_i b_i²/(2·⅔H)` and dissipates `g Δα Σ p_i b_i²/⅔H`. The step has no potential: its tangent is not symmetric, and the
//! symmetric half stands for it.

use super::functions::{above_zero, three};
use super::hardening::{Yield, not_negative, positive};
use super::rate::Rate;
use super::return_map::{ON_THE_SURFACE, Pace, Point, PointLaw};
use crate::pack::{Number, Pack};
use crate::section::MaterialError;

/// The most back stresses that recover.
pub const MOST_BACK_STRESSES: usize = 3;
/// Newton's steps behind the first.
const STEPS: usize = 8;

/// A back stress that recovers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BackStress {
    modulus: f64,
    recovery: f64,
}

impl BackStress {
    /// One that grows by H \[F/L²\] a plastic strain at first, in uniaxial tension, and nears H/g with the rate g \[–\].
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless `H > 0` and `g ≥ 0`, both finite.
    pub fn new(modulus: f64, recovery: f64) -> Result<Self, MaterialError> {
        Ok(Self {
            modulus: positive("the modulus of a back stress", modulus)?,
            recovery: not_negative("the recovery of a back stress", recovery)?,
        })
    }

    /// ⅔H \[F/L²\].
    fn own(&self) -> f64 {
        self.modulus * 2.0 / 3.0
    }
}

/// Back stresses of a point, in the coordinates of its modes; those beyond the number of the law are zero.
pub(super) type Backs<P> = [[P; 3]; MOST_BACK_STRESSES];

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
                trial[i] -= q * b[i];
                trial_growth[i] -= q_growth * b[i];
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
            change[i] = (trial_growth[i] - over[i] * (gamma_growth * (p + law.kinematic) + softer_growth)) * share;
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
        for _ in 0..STEPS {
            let (at, now) = self.at_overstress(rate, duration, s);
            s = (s + self.newton(&at, &now)).max(zero);
        }
        let fast = above_zero(of_slow);
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
