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
//! Laws whose yield stress grows with the rate, or whose back stresses recover, go another way: [`super::flow_step`].

use super::functions::{above_zero, three};
use super::hardening::{Hardening, Yield};
use super::modes::Modes;
use super::point::{BackStress, Committed, OF_SLICE, Pace, Point};
use super::rate::Rate;
use crate::pack::{Number, Pack};

/// Newton's steps behind the first.
const STEPS: usize = 3;
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

/// γ and f(γ) of one equation.
struct Root<P> {
    gamma: P,
    size: P,
    on_surface: P,
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

    /// ξ of a point that stays as it is.
    #[inline(always)]
    fn over<P: Number>(&self, stress: &[P; 3], plastic: &[P; 3]) -> [P; 3] {
        if self.kinematic == 0.0 {
            return *stress;
        }
        three(|i| stress[i] - plastic[i] * (self.kinematic / self.yielding[i]))
    }

    /// The step to a strain e from a committed point, by any law.
    #[inline(always)]
    pub fn step<P: Number>(&self, strain: &[P; 3], committed: &Committed<P>, pace: Pace<P>) -> Point<P> {
        if self.loses_more {
            let stress = three(|i| strain[i] - committed.plastic[i]);
            let over = self.over(&stress, &committed.plastic);
            return self.flow_step(&stress, &over, committed, pace);
        }
        let [p0, p1, p2] = committed.plastic;
        self.plain_step(strain, &[p0, p1, p2, committed.alpha])
    }

    /// The same by a law without rates and back stresses that recover, from e_p and α.
    #[inline(always)]
    pub fn plain_step<P: Number>(&self, strain: &[P; 3], committed: &[P; OF_SLICE]) -> Point<P> {
        let [p0, p1, p2, alpha] = *committed;
        let plastic = [p0, p1, p2];
        let stress = three(|i| strain[i] - plastic[i]);
        let over = self.over(&stress, &plastic);
        let square = |i: usize| over[i] * over[i] * self.yielding[i];
        let [p, q, s] = self.yielding;
        let [a, b, c] = [p + self.kinematic, q + self.kinematic, s + self.kinematic];
        let root = if self.pair {
            self.solve(&[square(0), square(1) + square(2)], &[a, b], alpha)
        } else {
            self.solve(&[square(0), square(1), square(2)], &[a, b, c], alpha)
        };
        let zero = alpha.all(0.0);
        let Some(Root { gamma, size, on_surface }) = root else {
            return Point { stress, plastic, alpha, gamma: zero, over, on_surface: zero, overstress: zero };
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
            overstress: zero,
        }
    }

    /// γ for the terms A_i of the trial stress and rates a_i; none where no lane is on the surface.
    #[inline(always)]
    fn solve<P: Number, const N: usize>(
        &self,
        terms: &[P; N],
        rates: &[f64; N],
        alpha: P,
    ) -> Option<Root<P>> {
        let zero = alpha.all(0.0);
        let r = self.root;
        let start = self.hardening.at(alpha);
        let limit = start.stress * r;
        // Keeps a point without stress from dividing zero by zero; of the size of rounding squared.
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
        let mut gamma = newton(&Sums { square, own: square, weighted }, size, &start, r).max(zero);
        for _ in 0..STEPS {
            let sums = Sums::at(terms, rates, gamma, tiny);
            let size = sums.square.sqrt();
            let now = self.hardening.at(alpha + gamma * size * r);
            gamma = (gamma + newton(&sums, size, &now, r)).max(zero);
        }
        Some(Root {
            gamma,
            size: Sums::at(terms, rates, gamma, tiny).square.sqrt(),
            on_surface: above_zero(beyond),
        })
    }

    /// `∂x/∂e` of the step, symmetric: 11, 22, 33, 12, 13, 23 of its three coordinates.
    ///
    /// With `θ1 = 1 + ⅔H_kγ`, `θ2 = 1 − ⅔K'γ`, `m_i = 1/(1 + p_iγ/θ1)` and `n_i = m_i p_i ξ_i` it is
    /// `diag m − θ2 n nᵀ/(θ2 Σ n_i p_i ξ_i + ⅔θ1(K'θ1 + H_kθ2) f²)`.
    pub fn tangent(&self, point: &Point<Pack>, committed: &Committed<Pack>) -> [Pack; 6] {
        if self.loses_more {
            return self.flow_tangent(point, committed.alpha, &committed.backs);
        }
        let [zero, one] = [Pack::ZERO, Pack::splat(1.0)];
        let slope = self.hardening.at(point.alpha).slope;
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
