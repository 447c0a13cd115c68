//! Eigenfunctions of the water beside a box and below it, matched where they meet.

use nalgebra::{Complex, DMatrix, DVector, Matrix3, Vector3};

use super::{BoxInWaves, Coefficients, Phased};

const I: Phased = Complex::new(0.0, 1.0);
/// Functions beside the box for each below it.
const BESIDE: usize = 8;

/// One frequency and its functions.
pub(super) struct Matching {
    of: BoxInWaves,
    frequency: f64,
    number: f64,
    gap: f64,
    /// κₙ, and the products of fₙ with cos λₘz on the gap.
    outer: Vec<Phased>,
    products: DMatrix<f64>,
    /// λₘ, cos λₘS, squares of cos λₘz.
    inner: Vec<f64>,
    ends: Vec<f64>,
    squares: Vec<f64>,
    /// On the side of the box the integrals of fₙ, and of its height over the centre.
    side: [Vec<f64>; 2],
    /// N₀/cosh kh.
    norm: f64,
}

/// A solution: A and B.
type Found = (DVector<Phased>, DVector<Phased>);

/// What a motion gives: velocity of the side, and velocity and potential of φ_P at x = a, weighed by the functions.
struct Given {
    even: bool,
    side: Vec<f64>,
    velocity: Vec<f64>,
    potential: Vec<f64>,
    /// Potential and velocity of the waves that come, over f₀.
    waves: [Phased; 2],
}

/// Root of a function that grows from one sign to the other.
fn root([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if of(middle) < 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// `sin(x s)/x`.
fn over(x: f64, s: f64) -> f64 {
    if x.abs() < 1e-9 { s } else { libm::sin(x * s) / x }
}

impl Matching {
    pub(super) fn new(of: BoxInWaves, frequency: f64, terms: usize) -> Self {
        let (h, gap) = (of.depth, of.depth - of.draught);
        let deep = frequency * frequency * h / of.gravity;
        let k = root([1e-9, deep + 10.0], |x| x * libm::tanh(x) - deep) / h;
        let inner: Vec<f64> = (0..terms).map(|m| m as f64 * std::f64::consts::PI / gap).collect();
        let ends: Vec<f64> = (0..terms).map(|m| if m % 2 == 0 { 1.0 } else { -1.0 }).collect();
        let squares = (0..terms).map(|m| if m == 0 { gap } else { 0.5 * gap }).collect();
        let count = BESIDE * terms;
        let (mut outer, mut products) = (vec![-I * k], DMatrix::zeros(count, terms));
        // Of f₀, sinh and cosh over cosh kh, which are finite in deep water.
        let below = libm::exp(-2.0 * k * h);
        let sides =
            |z: f64| [libm::exp(k * (z - h)) / (1.0 + below), libm::exp(-k * (z + h)) / (1.0 + below)];
        let sinh = |z: f64| sides(z)[0] - sides(z)[1];
        let cosh = |z: f64| sides(z)[0] + sides(z)[1];
        let norm = (2.0 * h * below / ((1.0 + below) * (1.0 + below)) + libm::tanh(k * h) / (2.0 * k)).sqrt();
        let centre = h + 0.5 * of.section[1] - of.draught;
        let turned = |z: f64| z * sinh(z) / k - cosh(z) / (k * k);
        let high = (sinh(h) - sinh(gap)) / (k * norm);
        let mut side = [vec![high], vec![(turned(h) - turned(gap)) / norm - centre * high]];
        for (m, lambda) in inner.iter().enumerate() {
            products[(0, m)] = k * sinh(gap) * ends[m] / ((k * k + lambda * lambda) * norm);
        }
        for n in 1..count {
            let from = (n as f64 - 0.5) * std::f64::consts::PI;
            let ends = [from, from + 0.5 * std::f64::consts::PI];
            // x sin x + deep cos x, with the sign that lets it grow.
            let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
            let own = root(ends, |x| sign * (x * libm::sin(x) + deep * libm::cos(x))) / h;
            let norm = (0.5 * h + libm::sin(2.0 * own * h) / (4.0 * own)).sqrt();
            let turned = |z: f64| z * libm::sin(own * z) / own + libm::cos(own * z) / (own * own);
            let high = (libm::sin(own * h) - libm::sin(own * gap)) / (own * norm);
            side[0].push(high);
            side[1].push((turned(h) - turned(gap)) / norm - centre * high);
            for (m, lambda) in inner.iter().enumerate() {
                products[(n, m)] = 0.5 * (over(own - lambda, gap) + over(own + lambda, gap)) / norm;
            }
            outer.push(Complex::new(own, 0.0));
        }
        Self { of, frequency, number: k, gap, outer, products, inner, ends, squares, side, norm }
    }

    /// Nothing that is given, of the even or the odd problem.
    fn nothing(&self, even: bool) -> Given {
        let (outer, inner) = (vec![0.0; self.outer.len()], vec![0.0; self.inner.len()]);
        Given { even, side: outer, velocity: inner.clone(), potential: inner, waves: [Complex::ZERO; 2] }
    }

    fn solved(&self, given: &Given) -> Option<Found> {
        let (a, count) = (0.5 * self.of.section[0], self.inner.len());
        // Velocity across x = a of each function below.
        let fast = |m: usize| match (given.even, m) {
            (true, _) => self.inner[m] * libm::tanh(self.inner[m] * a),
            (false, 0) => 1.0 / a,
            (false, _) => self.inner[m] / libm::tanh(self.inner[m] * a),
        };
        let across = DMatrix::from_fn(self.outer.len(), count, |n, m| {
            Complex::from(self.products[(n, m)] / self.squares[m])
        });
        let products = self.products.map(Complex::from);
        let given_below = DVector::from_fn(count, |m, _| Complex::from(given.velocity[m]));
        let mut beside = &across * given_below;
        for (n, value) in beside.iter_mut().enumerate() {
            *value = -(*value + given.side[n]) / self.outer[n];
        }
        beside[0] += given.waves[1] / self.outer[0];
        let answered =
            DMatrix::from_fn(self.outer.len(), count, |n, m| products[(n, m)] * fast(m) / self.outer[n]);
        let mut matrix = products.transpose() * &answered;
        let mut right = products.transpose() * &beside;
        for m in 0..count {
            matrix[(m, m)] += self.squares[m];
            right[m] += given.waves[0] * products[(0, m)] - given.potential[m];
        }
        let below = matrix.lu().solve(&right)?;
        Some((beside - answered * &below, below))
    }

    /// Integral over the lower face of the potential (even) or x times it (odd), without φ_P.
    fn on_face(&self, even: bool, below: &DVector<Phased>) -> Phased {
        let a = 0.5 * self.of.section[0];
        let weight = |m: usize| match (even, m, self.inner[m]) {
            (true, 0, _) => 2.0 * a,
            (true, _, l) => 2.0 * libm::tanh(l * a) / l,
            (false, 0, _) => 2.0 * a * a / 3.0,
            (false, _, l) => 2.0 * (a / libm::tanh(l * a) - 1.0 / l) / l,
        };
        below.iter().enumerate().map(|(m, value)| value * (self.ends[m] * weight(m))).sum()
    }

    fn on_side(&self, which: usize, beside: &DVector<Phased>) -> Phased {
        beside.iter().zip(&self.side[which]).map(|(value, part)| value * *part).sum()
    }

    /// Sway and roll of an odd potential: −∫ φ n ds of both sides and the face.
    fn odd(&self, (beside, below): &Found) -> [Phased; 2] {
        [-2.0 * self.on_side(0, beside), self.on_face(false, below) + 2.0 * self.on_side(1, beside)]
    }

    pub(super) fn coefficients(&self) -> Option<Coefficients> {
        let (a, gap, omega, k) = (0.5 * self.of.section[0], self.gap, self.frequency, self.number);
        // 1 and z², weighed by cos λₘz.
        let one = |m: usize| if m == 0 { gap } else { 0.0 };
        let square = |m: usize| match self.inner[m] {
            _ if m == 0 => gap * gap * gap / 3.0,
            l => 2.0 * gap * self.ends[m] / (l * l),
        };
        let each = |of: &dyn Fn(usize) -> f64| (0..self.inner.len()).map(of).collect::<Vec<f64>>();
        let sway = self.solved(&Given { side: self.side[0].clone(), ..self.nothing(false) })?;
        let heave = self.solved(&Given {
            velocity: each(&|m| -a * one(m) / gap),
            potential: each(&|m| 0.5 * (square(m) - a * a * one(m)) / gap),
            ..self.nothing(true)
        })?;
        let roll = self.solved(&Given {
            side: self.side[1].iter().map(|part| -part).collect(),
            velocity: each(&|m| 0.5 * (square(m) - a * a * one(m)) / gap),
            potential: each(&|m| 0.5 * (a * square(m) - a * a * a / 3.0 * one(m)) / gap),
            ..self.nothing(false)
        })?;
        // Of φ_P on the lower face.
        let lifted = a * gap - a * a * a / (3.0 * gap);
        let turned = a * a * a * gap / 3.0 - a * a * a * a * a / (15.0 * gap);
        let ([ss, rs], [sr, rr]) = (self.odd(&sway), self.odd(&roll));
        let hh = self.on_face(true, &heave.1) + lifted;
        let zero = Complex::ZERO;
        let all = Matrix3::new(ss, zero, sr, zero, hh, zero, rs, zero, rr + turned);
        // A wave of unit amplitude from the left, over f₀: cos kx is even, i sin kx odd.
        let size = -I * (self.of.gravity / omega * self.norm);
        let (sine, cosine) = libm::sincos(k * a);
        let even = self.solved(&Given { waves: [size * cosine, -size * k * sine], ..self.nothing(true) })?;
        let mut odd =
            self.solved(&Given { waves: [size * I * sine, size * I * k * cosine], ..self.nothing(false) })?;
        // Elevation over f₀ of what goes out, counted from the middle of the box.
        let out = |value: Phased| value / size * Complex::new(cosine, -sine);
        let (first, second) = (out(even.0[0]), out(odd.0[0]));
        odd.0[0] += size * I * sine;
        let [pushed, moment] = self.odd(&odd);
        Some(Coefficients {
            frequency: omega,
            number: k,
            group: omega / k * (0.5 + k * self.of.depth / libm::sinh(2.0 * k * self.of.depth)),
            added: all.map(|value| value.re),
            damping: all.map(|value| omega * value.im),
            push: Vector3::new(pushed, self.on_face(true, &even.1), moment) * (I * omega),
            sent: [&sway, &heave, &roll].map(|found| out(found.0[0])),
            held: [first - second, 1.0 + first + second],
        })
    }
}
