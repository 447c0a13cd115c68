//! The law of a point in plane stress: a step back to the yield surface, in the coordinates of [`super::modes`].
//!
//! With elastic coordinates x = e − e_p of a strain e, back stress `b_i = ⅔H_k e_p,i/p_i` and ξ = x − b, a step of backward Euler is
//!
//! ```text
//! ξ_i = ξ_i⁰/(1 + a_i γ)     a_i = p_i + ⅔H_k     e_p,i += γ p_i ξ_i     α' = α + rγf     r = √⅔
//! f(γ)² = Σ A_i/(1 + a_i γ)²     A_i = p_i (ξ_i⁰)²                  flows if f(0) > r K(α)
//! ```
//!
//! and minimises ½|x|² + ∫K dα + ½·⅔H_k Σ e_p,i²/p_i. It is one equation, `r K(α')/f − 1 = 0`, which is nearly linear in γ: with
//! `F = Σ a_i A_i/(1 + a_iγ)³` and `G = Σ A_i/(1 + a_iγ)³` Newton's step is
//!
//! ```text
//! γ += (f − r K) f²/(⅔ K' f G + r K F)
//! ```
//!
//! The first of them starts at γ = 0, three more follow, always: no lane takes a branch. Stresses are then off the yield stress by 2e-13 of it at most, over
//! strains of one at once, for curves of steel and aluminium; one that saturates within a strain of .001 is off by 9e-8 there, by 5e-13 over strains of .001.
//! \[simo1998\], §3.4, has the step and its tangent.
//!
//! Where the yield stress grows with the rate ([`super::rate`]) a step of the duration Δt solves the same equation with `Y = (1 + s) K(α + Δα)`, `Δα = Δt ε̇(s)` and
//! `γ = Δα/r²Y`, the unknown s: `r Y/f − 1` is convex in it. From the lesser of two bounds, the s of a step without flow, f(0)/rK − 1, and that of the flow which the step
//! would have without overstress, Newton's steps fall to the root. Outside a commit no time passes, and s stays what the last one found.

use super::functions::{above_zero, three};
use super::hardening::{Hardening, Yield};
use super::modes::Modes;
use super::point::{BackStress, Committed, OF_SLICE, Pace, Point};
use super::rate::Rate;
use crate::pack::{Number, Pack};

/// Newton's steps behind the first.
const STEPS: usize = 3;
/// Newton's steps for the overstress.
pub(super) const RATED_STEPS: usize = 6;
/// Points within this share of the yield stress below the surface stand on it, with the tangent of flow.
pub(super) const ON_THE_SURFACE: f64 = 1e-9;

/// r = √⅔.
fn root() -> f64 {
    (2.0_f64 / 3.0).sqrt()
}

/// What a point is made of.
#[derive(Clone, Debug)]
pub(super) struct PointLaw {
    hardening: Hardening,
    /// ⅔H_k \[F/L²\].
    pub(super) kinematic: f64,
    /// Back stresses that recover.
    pub(super) backs: Vec<BackStress>,
    /// p \[F/L²\].
    pub(super) yielding: [f64; 3],
    /// Whether it has a rate or back stresses that recover.
    pub(super) loses_more: bool,
    /// Whether the second and the third p are the same, so that their terms are one.
    pair: bool,
    pub(super) rate: Option<Rate>,
    /// r.
    pub(super) root: f64,
}

/// γ and f(γ) of one equation, and its s.
struct Root<P> {
    gamma: P,
    size: P,
    on_surface: P,
    overstress: P,
}

/// Terms A_i of a trial stress and rates a_i, at a committed α.
struct Trial<'a, P, const N: usize> {
    terms: &'a [P; N],
    rates: &'a [f64; N],
    alpha: P,
    /// Keeps a point without stress from dividing zero by zero; of the size of rounding squared.
    tiny: P,
}

impl<P: Number, const N: usize> Trial<'_, P, N> {
    #[inline(always)]
    fn sums(&self, gamma: P) -> Sums<P> {
        Sums::at(self.terms, self.rates, gamma, self.tiny)
    }
}

/// f², G and F.
struct Sums<P> {
    square: P,
    own: P,
    weighted: P,
}

impl<P: Number> Sums<P> {
    #[inline(always)]
    fn at<const N: usize>(terms: &[P; N], rates: &[f64; N], gamma: P, tiny: P) -> Self {
        let one = gamma.all(1.0);
        let mut sums = Self { square: tiny, own: tiny, weighted: tiny * rates[0] };
        for i in 0..N {
            let share = one / (one + gamma * rates[i]);
            let term = terms[i] * share * share;
            sums.square += term;
            sums.own += term * share;
            sums.weighted += term * share * rates[i];
        }
        sums
    }
}

/// Newton's step at f = `size`.
#[inline(always)]
fn newton<P: Number>(sums: &Sums<P>, size: P, now: &Yield<P>, r: f64) -> P {
    (size - now.stress * r) * sums.square
        / (now.slope * size * sums.own * (2.0 / 3.0) + now.stress * sums.weighted * r)
}

impl PointLaw {
    /// Hardening of both kinds, H_k the modulus of the kinematic one \[F/L²\].
    pub fn new(modes: &Modes, hardening: Hardening, kinematic: f64) -> Self {
        Self {
            hardening,
            rate: None,
            backs: Vec::new(),
            loses_more: false,
            kinematic: kinematic * 2.0 / 3.0,
            yielding: modes.yielding,
            pair: modes.yielding[1] == modes.yielding[2],
            root: root(),
        }
    }

    /// The same with back stresses that recover, and what rates do.
    pub fn with(self, backs: Vec<BackStress>, rate: Option<Rate>) -> Self {
        Self { loses_more: rate.is_some() || !backs.is_empty(), backs, rate, ..self }
    }

    /// Numbers of a history that a point has.
    pub fn numbers(&self) -> usize {
        OF_SLICE + 3 * self.backs.len() + usize::from(self.is_rated())
    }

    /// The mean of p \[F/L²\]: a stress beside the surface loses the share pγ/(1 + pγ) of it in a step.
    pub fn mean_yielding(&self) -> f64 {
        (self.yielding[0] + self.yielding[1] + self.yielding[2]) / 3.0
    }

    /// How the yield stress grows.
    pub fn hardening(&self) -> &Hardening {
        &self.hardening
    }

    /// Whether its yield stress grows with the rate.
    pub fn is_rated(&self) -> bool {
        self.rate.is_some()
    }

    /// Yield stress and slope of slow flow, or with an overstress.
    #[inline(always)]
    pub(super) fn yields<P: Number>(&self, alpha: P, overstress: Option<P>) -> Yield<P> {
        let slow = self.hardening.at(alpha);
        match overstress {
            None => slow,
            Some(s) => Yield { stress: slow.stress + slow.stress * s, slope: slow.slope + slow.slope * s },
        }
    }

    /// ξ of a point that stays as it is.
    #[inline(always)]
    fn over<P: Number>(&self, stress: &[P; 3], plastic: &[P; 3]) -> [P; 3] {
        if self.kinematic == 0.0 {
            return *stress;
        }
        three(|i| stress[i] - plastic[i] * (self.kinematic / self.yielding[i]))
    }

    /// The step to a strain e from a committed point.
    #[inline(always)]
    pub fn step<P: Number>(&self, strain: &[P; 3], committed: &Committed<P>, pace: Pace<P>) -> Point<P> {
        let Committed { plastic: [p0, p1, p2], alpha, backs } = *committed;
        if self.backs.is_empty() {
            return self.step_without(strain, &[p0, p1, p2, alpha], pace);
        }
        let stress = three(|i| strain[i] - committed.plastic[i]);
        let over = self.over(&stress, &committed.plastic);
        self.recovering_step((stress, committed.plastic, over), alpha, &backs, pace)
    }

    /// The same of a law without back stresses that recover, from e_p and α.
    #[inline(always)]
    pub fn step_without<P: Number>(
        &self,
        strain: &[P; 3],
        committed: &[P; OF_SLICE],
        pace: Pace<P>,
    ) -> Point<P> {
        let [p0, p1, p2, alpha] = *committed;
        let plastic = [p0, p1, p2];
        let stress = three(|i| strain[i] - plastic[i]);
        let over = self.over(&stress, &plastic);
        let square = |i: usize| over[i] * over[i] * self.yielding[i];
        let [p, q, s] = self.yielding;
        let [a, b, c] = [p + self.kinematic, q + self.kinematic, s + self.kinematic];
        let root = if self.pair {
            self.solve(&[square(0), square(1) + square(2)], &[a, b], alpha, pace)
        } else {
            self.solve(&[square(0), square(1), square(2)], &[a, b, c], alpha, pace)
        };
        let Some(Root { gamma, size, on_surface, overstress }) = root else {
            let zero = alpha.all(0.0);
            let overstress = if let Pace::Held(s) = pace { s } else { zero };
            return Point { stress, plastic, alpha, gamma: zero, over, on_surface: zero, overstress };
        };
        let one = alpha.all(1.0);
        let over = three(|i| over[i] / (one + gamma * [a, b, c][i]));
        let flow = three(|i| gamma * over[i] * self.yielding[i]);
        Point {
            stress: three(|i| stress[i] - flow[i]),
            plastic: three(|i| plastic[i] + flow[i]),
            alpha: alpha + gamma * size * self.root,
            gamma,
            over,
            on_surface,
            overstress,
        }
    }

    /// γ for the terms A_i of the trial stress and rates a_i; none where no lane is on the surface.
    #[inline(always)]
    fn solve<P: Number, const N: usize>(
        &self,
        terms: &[P; N],
        rates: &[f64; N],
        alpha: P,
        pace: Pace<P>,
    ) -> Option<Root<P>> {
        let zero = alpha.all(0.0);
        let r = self.root;
        let held = if let Pace::Held(s) = pace { Some(s) } else { None };
        let start = self.yields(alpha, held);
        let limit = start.stress * r;
        let tiny = limit * limit * 1e-32;
        let [mut square, mut weighted] = [tiny, tiny * rates[0]];
        for i in 0..N {
            square += terms[i];
            weighted += terms[i] * rates[i];
        }
        let size = square.sqrt();
        let beyond = size - limit * (1.0 - ON_THE_SURFACE);
        if beyond.below(0.0) {
            return None;
        }
        let trial = Trial { terms, rates, alpha, tiny };
        let mut gamma = newton(&Sums { square, own: square, weighted }, size, &start, r).max(zero);
        for _ in 0..STEPS {
            let sums = trial.sums(gamma);
            let size = sums.square.sqrt();
            let now = self.yields(alpha + gamma * size * r, held);
            gamma = (gamma + newton(&sums, size, &now, r)).max(zero);
        }
        let slow = Root {
            gamma,
            size: trial.sums(gamma).square.sqrt(),
            on_surface: above_zero(beyond),
            overstress: held.unwrap_or(zero),
        };
        Some(match (pace, &self.rate) {
            (Pace::Lasting(duration), Some(rate)) => self.rated(rate, duration, &trial, size, slow),
            _ => slow,
        })
    }

    /// The root of a step that takes a time \[T\], from that of a slow one and f(0).
    #[inline(always)]
    fn rated<P: Number, const N: usize>(
        &self,
        rate: &Rate,
        duration: f64,
        trial: &Trial<'_, P, N>,
        size: P,
        slow: Root<P>,
    ) -> Root<P> {
        let (r, alpha, one) = (self.root, trial.alpha, trial.alpha.all(1.0));
        let zero = alpha.all(0.0);
        let without_flow = (size / (self.hardening.at(alpha).stress * r) - one).max(zero);
        let of_slow = rate.overstress(slow.gamma * slow.size * (r / duration)).max(zero);
        let mut s = of_slow.min(without_flow);
        let gamma_at = |s: P| {
            let [flow, growth] = rate.flow(s, duration);
            let now = self.yields(alpha + flow, Some(s));
            let slope = now.stress / (one + s) + now.slope * growth;
            let part = flow / now.stress;
            (
                part * (1.0 / (r * r)),
                (growth - part * slope) / now.stress * (1.0 / (r * r)),
                now.stress,
                slope,
            )
        };
        for _ in 0..RATED_STEPS {
            let (gamma, turn, stress, slope) = gamma_at(s);
            let sums = trial.sums(gamma);
            let short = sums.square.sqrt() - stress * r;
            let per = (slope * sums.square + stress * sums.weighted * turn) * r;
            s = (s + short * sums.square / per).max(zero);
        }
        // Where the slow step is slow enough it is the answer, and where nothing flows.
        let fast = above_zero(of_slow) * above_zero(slow.gamma);
        let gamma = slow.gamma + (gamma_at(s).0 - slow.gamma) * fast;
        Root { gamma, size: trial.sums(gamma).square.sqrt(), overstress: s * fast, ..slow }
    }

    /// `∂x/∂e` of the step, symmetric: 11, 22, 33, 12, 13, 23 of its three coordinates.
    ///
    /// With `θ1 = 1 + ⅔H_kγ`, `θ2 = 1 − ⅔K'γ`, `m_i = 1/(1 + p_iγ/θ1)` and `n_i = m_i p_i ξ_i` it is
    /// `diag m − θ2 n nᵀ/(θ2 Σ n_i p_i ξ_i + ⅔θ1(K'θ1 + H_kθ2) f²)`.
    pub fn tangent(&self, point: &Point<Pack>, committed: &Committed<Pack>) -> [Pack; 6] {
        if !self.backs.is_empty() {
            return self.recovering_tangent(point, committed.alpha, &committed.backs);
        }
        let [zero, one] = [Pack::ZERO, Pack::splat(1.0)];
        let slope = self.yields(point.alpha, self.rate.map(|_| point.overstress)).slope;
        let theta1 = one + point.gamma * self.kinematic;
        let theta2 = one - slope * point.gamma * (2.0 / 3.0);
        let m = self.yielding.map(|p| theta1 / (theta1 + point.gamma * p));
        let n: [Pack; 3] = std::array::from_fn(|i| m[i] * point.over[i] * self.yielding[i]);
        let [mut across, mut square] = [zero, zero];
        for i in 0..3 {
            across += n[i] * point.over[i] * self.yielding[i];
            square += point.over[i] * point.over[i] * self.yielding[i];
        }
        let harden = theta1 * (slope * theta1 * (2.0 / 3.0) + theta2 * self.kinematic) * square;
        let share = theta2 * point.on_surface / (theta2 * across + harden).max(Pack::splat(1e-300));
        let entry = |i: usize, j: usize| (if i == j { m[i] } else { zero }) - n[i] * n[j] * share;
        [entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)]
    }
}
