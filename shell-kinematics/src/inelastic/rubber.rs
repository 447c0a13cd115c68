//! Incompressible rubber in plane stress: the stored energy of a sheet by two invariants of the stretch in its plane.
//!
//! With C the Cauchy–Green tensor of the plane, `T = tr C` and `d = det C`, incompressibility and σ33 = 0 leave `C33 = 1/d`:
//!
//! ```text
//! neo-Hooke, Mooney–Rivlin   W = c1 (T + 1/d − 3) + c2 (d + T/d − 3)
//! Ogden                      W = Σ μ/α (λ1^α + λ2^α + (λ1λ2)^−α − 3)
//! ```
//!
//! Ogden's powers are smooth in T and d even where both stretches are the same: `λ1^α + λ2^α = 2 d^(α/4) g(x)`, `x = T/(2√d)`, with
//! `g = cosh(ν arcosh x)`, ν = α/2, the solution of `(1 − x²) g'' − x g' + ν² g = 0` that is one at x = 1.

use super::hardening::{not_negative, positive};
use crate::pack::{LANES, Pack};
use crate::section::MaterialError;

/// An incompressible hyperelastic material.
#[derive(Clone, Debug, PartialEq)]
pub struct Rubber(Law);

#[derive(Clone, Debug, PartialEq)]
enum Law {
    MooneyRivlin { c1: f64, c2: f64 },
    Ogden(Vec<[f64; 2]>),
}

/// Stored energy per volume \[F/L²\] and its derivatives by T and d.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Stored<P> {
    pub energy: P,
    /// By T, d.
    pub first: [P; 2],
    /// By TT, Td, dd.
    pub second: [P; 3],
}

impl Rubber {
    /// `W = c1 (T + 1/d − 3)`, c1 half the shear modulus \[F/L²\].
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless c1 is positive and finite.
    pub fn neo_hooke(c1: f64) -> Result<Self, MaterialError> {
        Self::mooney_rivlin(c1, 0.0)
    }

    /// `W = c1 (T + 1/d − 3) + c2 (d + T/d − 3)`, both \[F/L²\].
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless `c1 > 0` and `c2 ≥ 0`, both finite.
    pub fn mooney_rivlin(c1: f64, c2: f64) -> Result<Self, MaterialError> {
        let c1 = positive("the constant c1 of rubber", c1)?;
        Ok(Self(Law::MooneyRivlin { c1, c2: not_negative("the constant c2 of rubber", c2)? }))
    }

    /// Ogden's sum over rows of μ \[F/L²\] and α \[–\].
    ///
    /// # Errors
    /// [`MaterialError::Constant`] for no row, or unless every product μα is positive and finite.
    pub fn ogden(rows: &[[f64; 2]]) -> Result<Self, MaterialError> {
        if rows.is_empty() {
            let what = "the number of terms of Ogden's rubber";
            return Err(MaterialError::Constant { what, value: 0.0, bound: "at least 1" });
        }
        for [modulus, exponent] in rows {
            positive("the product μα of a term of Ogden's rubber", modulus * exponent)?;
        }
        Ok(Self(Law::Ogden(rows.to_vec())))
    }

    /// Shear modulus at rest μ \[F/L²\].
    pub fn shear(&self) -> f64 {
        match &self.0 {
            Law::MooneyRivlin { c1, c2 } => 2.0 * (c1 + c2),
            Law::Ogden(rows) => rows.iter().map(|[modulus, exponent]| 0.5 * modulus * exponent).sum(),
        }
    }

    /// Stored energy with its derivatives.
    #[inline(always)]
    pub(super) fn stored(&self, trace: Pack, det: Pack) -> Stored<Pack> {
        match &self.0 {
            Law::MooneyRivlin { c1, c2 } => {
                let one = Pack::splat(1.0);
                let inverse = one / det;
                let square = inverse * inverse;
                let constant = Pack::splat(3.0);
                Stored {
                    energy: (trace + inverse - constant) * *c1 + (det + trace * inverse - constant) * *c2,
                    first: [inverse * *c2 + one * *c1, (one - trace * square) * *c2 - square * *c1],
                    second: [
                        Pack::ZERO,
                        -(square * *c2),
                        (trace * *c2 + one * *c1) * (square * inverse) * 2.0,
                    ],
                }
            }
            Law::Ogden(rows) => {
                let (trace, det) = (trace.lanes(), det.lanes());
                let lanes: [Stored<f64>; LANES] = std::array::from_fn(|lane| {
                    rows.iter()
                        .fold(Stored::default(), |sum, row| plus(sum, ogden(*row, trace[lane], det[lane])))
                });
                Stored {
                    energy: Pack::from_fn(|lane| lanes[lane].energy),
                    first: std::array::from_fn(|i| Pack::from_fn(|lane| lanes[lane].first[i])),
                    second: std::array::from_fn(|i| Pack::from_fn(|lane| lanes[lane].second[i])),
                }
            }
        }
    }
}

fn plus(a: Stored<f64>, b: Stored<f64>) -> Stored<f64> {
    Stored {
        energy: a.energy + b.energy,
        first: std::array::from_fn(|i| a.first[i] + b.first[i]),
        second: std::array::from_fn(|i| a.second[i] + b.second[i]),
    }
}

/// One term of Ogden's sum.
fn ogden([modulus, exponent]: [f64; 2], trace: f64, det: f64) -> Stored<f64> {
    let x = 0.5 * trace / det.sqrt();
    let [g, g1, g2] = power(0.5 * exponent, x);
    // x and its derivatives by T and d.
    let [x_t, x_d] = [0.5 / det.sqrt(), -0.5 * x / det];
    let [x_td, x_dd] = [-0.5 * x_t / det, 0.75 * x / (det * det)];
    // u = 2 d^a and v = d^−2a.
    let a = 0.25 * exponent;
    let u = 2.0 * libm::pow(det, a);
    let [u_d, u_dd] = [a * u / det, a * (a - 1.0) * u / (det * det)];
    let v = libm::pow(det, -2.0 * a);
    let [v_d, v_dd] = [-2.0 * a * v / det, 2.0 * a * (2.0 * a + 1.0) * v / (det * det)];
    let factor = modulus / exponent;
    Stored {
        energy: factor * (u * g + v - 3.0),
        first: [u * g1 * x_t, u_d * g + u * g1 * x_d + v_d].map(|slope| factor * slope),
        second: [
            u * g2 * x_t * x_t,
            u_d * g1 * x_t + u * (g2 * x_t * x_d + g1 * x_td),
            u_dd * g + 2.0 * u_d * g1 * x_d + u * (g2 * x_d * x_d + g1 * x_dd) + v_dd,
        ]
        .map(|slope| factor * slope),
    }
}

/// g, g', g'' of `g = cosh(ν arcosh x)`.
///
/// To `y = x − 1 = 0.3` by its series `c₀ = 1`, `c_k+1 = c_k (ν² − k²)/((k+1)(2k+1))` in y, which ends below 1e-17 of itself; beyond by the hyperbolic
/// functions.
fn power(nu: f64, x: f64) -> [f64; 3] {
    let y = x - 1.0;
    if y < 0.3 {
        let [mut g, mut g1, mut g2] = [1.0, 0.0, 0.0];
        let mut coefficient = 1.0;
        let mut powers = [0.0, 0.0, 1.0]; // y^(k−2), y^(k−1), y^k
        for k in 0..30 {
            let n = f64::from(k);
            coefficient *= (nu * nu - n * n) / ((n + 1.0) * (2.0 * n + 1.0));
            powers = [powers[1], powers[2], powers[2] * y];
            g += coefficient * powers[2];
            g1 += (n + 1.0) * coefficient * powers[1];
            g2 += (n + 1.0) * n * coefficient * powers[0];
        }
        return [g, g1, g2];
    }
    let root = (y * (y + 2.0)).sqrt(); // sinh θ
    let theta = libm::log1p(y + root);
    let [sinh, cosh] = [libm::sinh(nu * theta), libm::cosh(nu * theta)];
    let g1 = nu * sinh / root;
    [cosh, g1, (nu * nu * cosh - x * g1) / (root * root)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Even powers are polynomials; both branches agree where they meet; derivatives against differences.
    #[test]
    fn powers_of_the_stretches_are_smooth() {
        for (nu, of) in [(1.0, [0.0, 1.0, 0.0]), (2.0, [-1.0, 0.0, 2.0])] {
            for x in [1.0, 1.1, 1.29, 1.31, 4.0] {
                let exact = [of[0] + of[1] * x + of[2] * x * x, of[1] + 2.0 * of[2] * x, 2.0 * of[2]];
                for (found, exact) in power(nu, x).into_iter().zip(exact) {
                    assert!((found - exact).abs() < 2e-14 * exact.abs().max(1.0), "{nu} {x} {found} {exact}");
                }
            }
        }
        for nu in [0.65, 2.5, -1.0, -3.3] {
            let (below, above) = (power(nu, 1.3 - 1e-12), power(nu, 1.3 + 1e-12));
            for i in 0..3 {
                let apart = (below[i] - above[i]).abs();
                assert!(apart < 1e-10 * above[i].abs().max(1.0), "{nu} {below:?} {above:?}");
            }
        }
        let (trace, det, step) = (2.3, 1.2, 1e-6);
        let at = |t: f64, d: f64| ogden([0.6, 1.3], t, d);
        let here = at(trace, det);
        let by_trace = [at(trace + step, det), at(trace - step, det)];
        let by_det = [at(trace, det + step), at(trace, det - step)];
        let slope = |pair: [f64; 2]| (pair[0] - pair[1]) / (2.0 * step);
        for (found, exact) in [
            (here.first[0], slope(by_trace.map(|s| s.energy))),
            (here.first[1], slope(by_det.map(|s| s.energy))),
            (here.second[0], slope(by_trace.map(|s| s.first[0]))),
            (here.second[1], slope(by_det.map(|s| s.first[0]))),
            (here.second[2], slope(by_det.map(|s| s.first[1]))),
        ] {
            assert!((found - exact).abs() < 1e-9, "{found} {exact}");
        }
    }
}
