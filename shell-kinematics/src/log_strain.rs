//! Logarithmic membrane strain, and curvature and shear freed of stretch of any size, with their transpose.
//!
//! With `C = 1 + 2e` of the mid-surface, `J = √(C11 C22 − C12²)`, `τ = √(C11 + C22 + 2J)` and the total curvatures k,
//!
//! ```text
//! u = (C11 − C22)/2J    v = C12/J    q = u² + v²    φ = asinh(√q)/2√q
//! h11 = ½ ln J + φu     h22 = ½ ln J − φu     2h12 = 2φv                              h = ½ ln C = ln U
//! U⁻¹ = (a, b, c) = (C22 + J, C11 + J, −C12)/τJ                                       11, 22, 12
//! K11 = a k11 + ½c k12 − k11⁰    K22 = b k22 + ½c k12 − k22⁰    2K12 = ½(a + b) k12 + c (k11 + k22) − k12⁰
//! Γ = U⁻¹ γ
//! ```
//!
//! The principal values of h are the logarithms of the principal stretches: `√q = sinh(h₁ − h₂)`, and `(u, v)/√q` is their direction.
//! K is the symmetric part of `U⁻¹ k − k⁰`: of a strip of any stretch λ rolled to a circle, `1/λ` of `x,₁·d,₁`, the angle per present length.

use crate::pack::{Arithmetic, Number, Pack};
use crate::placement::{MeasureForces, Measures};
use crate::slope::Slope;
use crate::strain::{StrainMeasure, StrainsOf};
use crate::strains::{Resultants, Strains};
use crate::tangent::{Matrix8, ZERO8};

/// Logarithmic membrane strain and the curvature per present length, for stretches of any size.
///
/// The measure of sections that yield. With an elastic section it is Hencky's law.
#[derive(Clone, Copy, Debug, Default)]
pub struct Logarithmic;

/// Numerator and denominator of Padé's approximation of order \[4/4\] to `atanh(√w)/√w`: of y = √w = tanh ½ it is 8·10⁻¹⁷ off.
const ATANH: [[f64; 5]; 2] = [
    [
        1.0,
        -1.784_313_725_490_196_1,
        0.976_470_588_235_294_1,
        -0.166_645_119_586_296_06,
        0.004_279_119_573_237_22,
    ],
    [
        1.0,
        -2.117_647_058_823_529_4,
        1.482_352_941_176_470_6,
        -0.380_090_497_737_556_6,
        0.025_915_261_209_378_857,
    ],
];

/// A polynomial and its derivative.
#[inline(always)]
fn polynomial<P: Arithmetic>(w: P, [a, b, c, d, e]: [f64; 5]) -> [P; 2] {
    let all = |value| w.all(value);
    let value = (((w * e + all(d)) * w + all(c)) * w + all(b)) * w + all(a);
    let slope = ((w * (4.0 * e) + all(3.0 * d)) * w + all(2.0 * c)) * w + all(b);
    [value, slope]
}

/// `atanh(√w)/√w` and its derivative.
#[inline(always)]
fn atanh_ratio<P: Arithmetic>(w: P) -> [P; 2] {
    let [p, dp] = polynomial(w, ATANH[0]);
    let [q, dq] = polynomial(w, ATANH[1]);
    let ratio = p / q;
    [ratio, (dp - ratio * dq) / q]
}

/// `ln x`, from the fourth root of x; 10⁻¹⁶ off for x of e⁻² to e².
#[inline(always)]
fn ln<P: Arithmetic>(x: P) -> P {
    let one = x.all(1.0);
    let root = x.sqrt().sqrt();
    let y = (root - one) / (root + one);
    y * atanh_ratio(y * y)[0] * 8.0
}

/// `φ(q) = asinh(√q)/2√q` and its derivative.
///
/// With `√q = sinh d`, c = cosh d, c₁ = cosh ½d, c₂ = cosh ¼d: `φ = R(w)/((1 + c₂) c₁ c₂)`, `w = tanh² ⅛d`, R = [`atanh_ratio`].
#[inline(always)]
fn phi<P: Arithmetic>(q: P) -> [P; 2] {
    let one = q.all(1.0);
    let c = (one + q).sqrt();
    let q1 = q / (one + c) * 0.5;
    let c1 = (one + q1).sqrt();
    let q2 = q1 / (one + c1) * 0.5;
    let c2 = (one + q2).sqrt();
    let sum = one / (one + c2);
    let [ratio, slope] = atanh_ratio(q2 * sum * sum);
    let (over1, over2) = (one / c1, one / c2);
    let value = ratio * sum * over1 * over2;
    // dc₁/dq and dc₂/dq.
    let by1 = over1 / c * 0.125;
    let by2 = by1 * over2 * 0.25;
    let change = (slope / ratio * sum * sum * 2.0 - sum - over2) * by2 - over1 * by1;
    [value, value * change]
}

/// What strains and their transpose share: the stretch of the mid-surface.
struct Stretched<P> {
    /// C11, C22, C12.
    c: [P; 3],
    j: P,
    tau: P,
    /// u, v.
    swing: [P; 2],
    /// φ and φ'.
    phi: [P; 2],
    /// U⁻¹ as a, b, c.
    inverse: [P; 3],
}

impl<P: Arithmetic> Stretched<P> {
    #[inline(always)]
    fn new(now: &Measures<P>, reference: &Measures<P>) -> Self {
        let one = now.membrane[0].all(1.0);
        let c11 = one + (now.membrane[0] - reference.membrane[0]) * 2.0;
        let c22 = one + (now.membrane[1] - reference.membrane[1]) * 2.0;
        let c12 = now.membrane[2] - reference.membrane[2];
        let j = (c11 * c22 - c12 * c12).sqrt();
        let tau = (c11 + c22 + j * 2.0).sqrt();
        let (u, v) = ((c11 - c22) / j * 0.5, c12 / j);
        let over = one / (tau * j);
        let inverse = [(c22 + j) * over, (c11 + j) * over, c12 * over * -1.0];
        Self { c: [c11, c22, c12], j, tau, swing: [u, v], phi: phi(u * u + v * v), inverse }
    }

    #[inline(always)]
    fn strains(&self, now: &Measures<P>, reference: &Measures<P>) -> Strains<P> {
        let ([u, v], [phi, _], [a, b, c]) = (self.swing, self.phi, self.inverse);
        let mean = ln(self.j) * 0.5;
        let ([k11, k22, k12], rest) = (now.curvature, reference.curvature);
        let gamma = [now.shear[0] - reference.shear[0], now.shear[1] - reference.shear[1]];
        let mixed = c * k12 * 0.5;
        Strains {
            membrane: [mean + phi * u, mean - phi * u, phi * v * 2.0],
            curvature: [
                a * k11 + mixed - rest[0],
                b * k22 + mixed - rest[1],
                (a + b) * k12 * 0.5 + c * (k11 + k22) - rest[2],
            ],
            shear: [a * gamma[0] + c * gamma[1], c * gamma[0] + b * gamma[1]],
        }
    }

    /// Forces on the measures. `s` is the force on the entries of U⁻¹; `a_u`, `a_v`, `a_m` are those on u, v and, divided by 1/J, on J.
    #[inline(always)]
    fn transpose(
        &self,
        now: &Measures<P>,
        reference: &Measures<P>,
        stress: &Resultants<P>,
    ) -> MeasureForces<P> {
        let Self { c: [c11, c22, c12], j, tau, .. } = *self;
        let ([u, v], [phi, dphi], [a, b, c]) = (self.swing, self.phi, self.inverse);
        let ([n11, n22, n12], [m11, m22, m12], [q1, q2]) = (stress.membrane, stress.moment, stress.shear);
        let [k11, k22, k12] = now.curvature;
        let gamma = [now.shear[0] - reference.shear[0], now.shear[1] - reference.shear[1]];
        let apart = n11 - n22;
        let twice = dphi * (apart * u + n12 * v * 2.0) * 2.0;
        let a_u = phi * apart + u * twice;
        let a_v = phi * n12 * 2.0 + v * twice;
        let a_m = (n11 + n22) * 0.5 - u * a_u - v * a_v;
        let s_a = m11 * k11 + m12 * k12 * 0.5 + q1 * gamma[0];
        let s_b = m22 * k22 + m12 * k12 * 0.5 + q2 * gamma[1];
        let s_c = (m11 + m22) * k12 * 0.5 + m12 * (k11 + k22) + q1 * gamma[1] + q2 * gamma[0];
        let (over_j, over) = (j.all(1.0) / j, j.all(1.0) / (tau * j));
        let half = over_j * 0.5;
        let back = (a * s_a + b * s_b + c * s_c) * over * -1.0;
        let on_j = (s_a + s_b) * over + back * (tau + j / tau) + a_m * over_j;
        let (direct, through) = (back * j / tau * 0.5, on_j * half);
        let g11 = a_u * half + s_b * over + direct + c22 * through;
        let g22 = s_a * over + direct + c11 * through - a_u * half;
        let g12 = a_v * over_j - s_c * over - c12 * on_j * over_j;
        MeasureForces {
            membrane: [g11 * 2.0, g22 * 2.0, g12],
            curvature: [a * m11 + c * m12, b * m22 + c * m12, c * (m11 + m22) * 0.5 + (a + b) * m12 * 0.5],
            shear: [a * q1 + c * q2, c * q1 + b * q2],
        }
    }
}

impl<P: Number> StrainsOf<P> for Logarithmic {
    #[inline(always)]
    fn strains_of(&self, now: &Measures<P>, reference: &Measures<P>) -> Strains<P> {
        Stretched::new(now, reference).strains(now, reference)
    }

    #[inline(always)]
    fn transpose_of(
        &self,
        now: &Measures<P>,
        reference: &Measures<P>,
        stress: &Resultants<P>,
    ) -> MeasureForces<P> {
        Stretched::new(now, reference).transpose(now, reference, stress)
    }
}

/// Measures as numbers with a slope along one of them.
fn along(now: &Measures, number: usize) -> Measures<Slope> {
    let slope = |i: usize, value: Pack| Slope::new(value, Pack::splat(if i == number { 1.0 } else { 0.0 }));
    let [m, k, s] = [now.membrane, now.curvature, [now.shear[0], now.shear[1], Pack::ZERO]];
    Measures {
        membrane: std::array::from_fn(|i| slope(i, m[i])),
        curvature: std::array::from_fn(|i| slope(3 + i, k[i])),
        shear: std::array::from_fn(|i| slope(6 + i, s[i])),
    }
}

/// A matrix column by column: the slopes of eight numbers along each measure.
fn columns(find: impl Fn(&Measures<Slope>) -> [[Slope; 3]; 3], now: &Measures) -> Matrix8 {
    let mut out = ZERO8;
    for column in 0..8 {
        let found = find(&along(now, column));
        for (row, value) in found.iter().flatten().take(8).enumerate() {
            out[row][column] = value.slope();
        }
    }
    out
}

impl StrainMeasure for Logarithmic {
    fn name(&self) -> &'static str {
        "logarithmic"
    }

    fn describe(&self) -> &'static str {
        "logarithmic membrane strain, curvature per present length: for stretches of any size"
    }

    fn strains(&self, now: &Measures, reference: &Measures) -> Strains {
        self.strains_of(now, reference)
    }

    fn transpose(&self, now: &Measures, reference: &Measures, stress: &Resultants) -> MeasureForces {
        self.transpose_of(now, reference, stress)
    }

    fn gradient(&self, now: &Measures, reference: &Measures) -> Matrix8 {
        let rest = along(reference, usize::MAX);
        let find = |at: &Measures<Slope>| {
            let found = Stretched::new(at, &rest).strains(at, &rest);
            [found.membrane, found.curvature, [found.shear[0], found.shear[1], found.shear[1]]]
        };
        columns(find, now)
    }

    /// Slopes of the transpose: exact, and symmetric but for rounding.
    fn second_gradient(&self, now: &Measures, reference: &Measures, stress: &Resultants) -> Matrix8 {
        let rest = along(reference, usize::MAX);
        let held = Resultants {
            membrane: stress.membrane.map(Slope::level),
            moment: stress.moment.map(Slope::level),
            shear: stress.shear.map(Slope::level),
        };
        let find = |at: &Measures<Slope>| {
            let found = Stretched::new(at, &rest).transpose(at, &rest, &held);
            [found.membrane, found.curvature, [found.shear[0], found.shear[1], found.shear[1]]]
        };
        columns(find, now)
    }
}
