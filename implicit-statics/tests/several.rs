//! Several systems balanced together: unjoined each answers as alone; joined, forces and tangent belong to one potential.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::ops::ControlFlow;

use implicit_statics::{
    Control, Equilibrium, Interaction, Joinable, Newton, NewtonOptions, PathOptions, Several, Start, follow,
    force_error, linear_response, load_rate_error, tangent_error,
};

/// Points on springs that harden, `½ q² + ¼ q⁴` an unknown; each goes by an oblique matrix times its three unknowns.
struct Grains {
    q: Vec<f64>,
    exerted: Vec<[f64; 3]>,
}

const WAYS: [[f64; 3]; 3] = [[0.8, 0.1, -0.3], [0.2, 1.1, 0.4], [-0.1, 0.3, 0.9]];

impl Grains {
    fn new(count: usize) -> Self {
        let q = (0..3 * count).map(|i| 0.1 * (i as f64 - 2.0)).collect();
        Self { q, exerted: vec![[0.0; 3]; count] }
    }
}

impl Equilibrium for Grains {
    fn unknowns(&self) -> usize {
        self.q.len()
    }
    fn pattern(&self) -> Vec<(usize, usize)> {
        (0..self.q.len()).map(|i| (i, i)).collect()
    }
    fn internal(&mut self, _level: f64, out: &mut [f64]) {
        out.iter_mut().zip(&self.q).for_each(|(out, q)| *out = q + q * q * q);
    }
    fn external(&mut self, level: f64, out: &mut [f64]) {
        for (i, out) in out.iter_mut().enumerate() {
            let exerted = self.exerted[i / 3].iter().zip(&WAYS[i % 3]).map(|(f, way)| f * way).sum::<f64>();
            *out = level * (1.0 + i as f64) + exerted;
        }
    }
    fn load_rate(&mut self, _level: f64, out: &mut [f64]) {
        out.iter_mut().enumerate().for_each(|(i, out)| *out = 1.0 + i as f64);
    }
    fn tangent(&mut self, _level: f64, values: &mut [f64]) {
        values.iter_mut().zip(&self.q).for_each(|(value, q)| *value = 1.0 + 3.0 * q * q);
    }
    fn update(&mut self, increment: &[f64]) {
        self.q.iter_mut().zip(increment).for_each(|(q, dq)| *q += dq);
    }
    fn save(&self) -> Vec<f64> {
        self.q.clone()
    }
    fn restore(&mut self, saved: &[f64]) {
        self.q.copy_from_slice(saved);
    }
    fn energy(&mut self) -> f64 {
        self.q.iter().map(|q| 0.5 * q * q + 0.25 * q.powi(4)).sum()
    }
    fn masses(&self) -> Vec<f64> {
        vec![1.0; self.q.len()]
    }
    fn name_unknown(&self, unknown: usize) -> String {
        format!("unknown {unknown}")
    }
}

impl Joinable for Grains {
    fn places(&self, particles: &[u32], out: &mut [[f64; 3]]) {
        for (out, &a) in out.iter_mut().zip(particles) {
            *out = std::array::from_fn(|k| (0..3).map(|i| WAYS[i][k] * self.q[3 * a as usize + i]).sum());
        }
    }
    fn put(&mut self, _: f64) {}

    fn release(&mut self) {
        self.exerted.fill([0.0; 3]);
    }

    fn exert(&mut self, particles: &[u32], forces: &[[f64; 3]]) {
        for (&a, force) in particles.iter().zip(forces) {
            (0..3).for_each(|k| self.exerted[a as usize][k] += force[k]);
        }
    }
    fn motion_of(&self, particle: u32) -> Vec<(usize, [f64; 3])> {
        (0..3).map(|i| (3 * particle as usize + i, WAYS[i])).collect()
    }
}

/// `½ (x·y)²` of two places: neither linear nor of a constant stiffness.
#[derive(Default)]
struct Product {
    places: [[f64; 3]; 2],
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Interaction for Product {
    fn particles(&self) -> Vec<Vec<u32>> {
        vec![vec![1], vec![0]]
    }
    fn pairs(&self) -> Vec<[usize; 2]> {
        vec![[0, 0], [1, 1], [0, 1]]
    }
    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.places = [places[0], places[1]];
        let s = dot(&places[0], &places[1]);
        for k in 0..3 {
            forces[0][k] = -s * places[1][k];
            forces[1][k] = -s * places[0][k];
        }
        0.5 * s * s
    }
    fn stiffness(&self, _: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        let [x, y] = self.places;
        let s = dot(&x, &y);
        for i in 0..3 {
            for j in 0..3 {
                blocks[0][i][j] = y[i] * y[j];
                blocks[1][i][j] = x[i] * x[j];
                blocks[2][i][j] = y[i] * x[j] + if i == j { s } else { 0.0 };
            }
        }
    }
}

fn joined() -> Several<Grains> {
    Several::new(vec![Box::new(Grains::new(2)), Box::new(Grains::new(1))], vec![Box::new(Product::default())])
}

/// Differences of fourth order over steps of 1e-3: some 1e-11 measured.
#[test]
fn the_tangent_is_the_derivative_of_all_forces() {
    let mut several = joined();
    let direction: Vec<f64> = (0..9).map(|i| 1.0 - 0.3 * i as f64).collect();
    let missed = [
        tangent_error(&mut several, 0.7, &direction, 1e-3),
        force_error(&mut several, 0.7, &direction, 1e-3),
        load_rate_error(&mut several, 0.7, 1e-3),
    ];
    assert!(missed.iter().all(|missed| *missed < 1e-9), "{missed:?}");
    // Entries between the systems are there, each once.
    let mut pattern = several.pattern();
    assert_eq!(pattern.len(), 9 + 3 + 3 + 9);
    pattern.sort_unstable();
    pattern.dedup();
    assert_eq!(pattern.len(), 24);
    assert_eq!(several.name_unknown(7), "system 1: unknown 1");
}

/// A linear answer of systems that do not act on each other is that of each, to the bit: the factor of a diagonal has no sums.
#[test]
fn unjoined_systems_answer_as_each_alone() {
    let mut several = Several::new(vec![Box::new(Grains::new(2)), Box::new(Grains::new(1))], Vec::new());
    let together = linear_response(&mut several, 0.0).unwrap();
    let alone = [linear_response(&mut Grains::new(2), 0.0), linear_response(&mut Grains::new(1), 0.0)];
    assert_eq!(together, alone.map(Result::unwrap).concat());
}

/// Newton's method is quadratic with the blocks between systems: six iterations from afar.
#[test]
fn newtons_method_finds_the_balance_of_joined_systems() {
    let mut several = joined();
    let mut newton = Newton::new(&several, &NewtonOptions::default()).unwrap();
    let found = newton.at_level(&mut several, 0.3).unwrap();
    let (mut internal, mut external) = (vec![0.0; 9], vec![0.0; 9]);
    several.internal(0.3, &mut internal);
    several.external(0.3, &mut external);
    let missed = internal.iter().zip(&external).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(missed < 1e-7 && found.iterations <= 10, "{missed:e} after {}", found.iterations);
    // Twice the row sums bound the spectrum, those of the blocks between among them.
    let mut sums = vec![0.0; 9];
    several.row_sums(0.3, &mut sums);
    let mut values = vec![0.0; several.pattern().len()];
    several.tangent(0.3, &mut values);
    let v = [1.0; 9];
    let quotient: f64 = several
        .pattern()
        .iter()
        .zip(&values)
        .map(|(&(i, j), k)| if i == j { k * v[i] } else { 2.0 * k })
        .sum();
    assert!(quotient <= sums.iter().sum::<f64>() * (1.0 + 1e-12), "{quotient} {sums:?}");
}

/// A place that a tool of stiffness κ draws along the third axis, by a unit of way a unit of level.
struct Drawn {
    stiffness: f64,
    level: f64,
    /// Whether it says that it goes with the level.
    says: bool,
}

impl Interaction for Drawn {
    fn particles(&self) -> Vec<Vec<u32>> {
        vec![vec![0]]
    }
    fn put(&mut self, level: f64) {
        self.level = level;
    }
    fn moves(&self) -> bool {
        self.says
    }
    fn pairs(&self) -> Vec<[usize; 2]> {
        vec![[0, 0]]
    }
    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        let way = self.level - places[0][2];
        forces[0] = [0.0, 0.0, self.stiffness * way];
        0.5 * self.stiffness * way * way
    }
    fn rates(&self, _: &[[f64; 3]], rates: &mut [[f64; 3]]) -> bool {
        rates[0] = [0.0, 0.0, self.stiffness];
        true
    }
    fn stiffness(&self, _: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        blocks[0] = [[0.0; 3], [0.0; 3], [0.0, 0.0, self.stiffness]];
    }
}

/// Greatest residual over the forces of the balances that Newton's method finds at four levels.
fn balanced_to(says: bool) -> f64 {
    let tool = Drawn { stiffness: 1e7, level: 0.0, says };
    let mut several = Several::new(vec![Box::new(Grains::new(1))], vec![Box::new(tool)]);
    several.systems_mut()[0].q.fill(0.0);
    assert_eq!(several.has_moving_tools(), says);
    let options = PathOptions::new(Control::Load { step: 0.25, until: 1.0 });
    let mut worst = 0.0_f64;
    let path = follow(&mut several, &Start::default(), &options, |point, several| {
        let (mut internal, mut external) = (vec![0.0; 3], vec![0.0; 3]);
        several.internal(point.level(), &mut internal);
        several.external(point.level(), &mut external);
        let size = |forces: &[f64]| forces.iter().map(|force| force * force).sum::<f64>().sqrt();
        let missed: Vec<f64> = internal.iter().zip(&external).map(|(a, b)| a - b).collect();
        if point.level() > 0.0 {
            worst = worst.max(size(&missed) / size(&internal));
        }
        ControlFlow::Continue(())
    });
    path.end.unwrap();
    worst
}

/// What a stiff tool would press if nothing gave way is no scale of residuals: beside it an iterate far from balance is taken for one. Rounding of a
/// place times κ is 1e-9.
#[test]
fn a_stiff_tool_that_moves_is_balanced_as_loads_are() {
    let [said, unsaid] = [true, false].map(balanced_to);
    println!("{said:e} {unsaid:e}");
    assert!(said < 1e-8 && unsaid > 1e-6, "{said:e} {unsaid:e}");
}
