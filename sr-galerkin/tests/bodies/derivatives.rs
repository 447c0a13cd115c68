//! What every body keeps: forces are the derivative of its energy, its tangent that of the forces.

use implicit_statics::Equilibrium;
use nalgebra::DMatrix;
use sr_galerkin::{Galerkin, Parts};

use super::body;

/// Length of a step of central differences.
const STEP: f64 = 1e-6;
/// Level at which loads act.
const LEVEL: f64 = 0.8;

/// Moves all parameters by uneven amounts.
pub fn wiggle(body: &mut Galerkin, size: f64) {
    let change: Vec<f64> = (0..body.unknowns()).map(|i| size * ((i * 7 % 11) as f64 / 11.0 - 0.45)).collect();
    body.update(&change);
}

/// A body under stress: a step behind it is kept, another is under way.
pub fn stressed(parts: Parts) -> Galerkin {
    let mut body = body(parts);
    wiggle(&mut body, 0.04);
    let mut forces = vec![0.0; body.unknowns()];
    body.internal(0.0, &mut forces);
    body.commit();
    wiggle(&mut body, -0.07);
    body
}

/// Internal forces against differences of the energy, one unknown in five.
pub fn forces_derive_from_the_energy(body: &mut Galerkin) {
    let mut forces = vec![0.0; body.unknowns()];
    body.internal(0.0, &mut forces);
    let scale = forces.iter().map(|f| f * f).sum::<f64>().sqrt().max(1.0);
    for unknown in (0..body.unknowns()).step_by(5) {
        let energy = |sign: f64, body: &mut Galerkin| after(body, unknown, sign, |body| body.energy());
        let difference = (energy(1.0, body) - energy(-1.0, body)) / (2.0 * STEP);
        // energies near .1 carry roundings of 1e-17, over 2e-6
        assert!((forces[unknown] - difference).abs() < 1e-9 * scale, "unknown {unknown}");
    }
}

/// The exact tangent against differences of the forces, one unknown in `every`; what is factorised is its symmetric part. Returns the
/// exact one.
pub fn the_tangent_derives_from_forces(name: &str, body: &mut Galerkin, every: usize) -> DMatrix<f64> {
    let n = body.unknowns();
    let exact = body.exact_tangent(LEVEL);
    let scale = exact.amax();
    for unknown in (0..n).step_by(every) {
        let [above, below] = [1.0, -1.0].map(|sign| after(body, unknown, sign, residual));
        for i in 0..n {
            let difference = (above[i] - below[i]) / (2.0 * STEP);
            let miss = (exact[(i, unknown)] - difference).abs() / scale;
            assert!(miss < 1e-8, "{name}: {i} {unknown} {miss:e}"); // roundings of forces near one, over 2e-6
        }
    }
    let pattern = body.pattern();
    let mut values = vec![0.0; pattern.len()];
    body.tangent(LEVEL, &mut values);
    let mut sparse = DMatrix::zeros(n, n);
    for (&(row, column), &value) in pattern.iter().zip(&values) {
        (sparse[(row, column)], sparse[(column, row)]) = (value, value);
    }
    let miss = (&sparse - (&exact + exact.transpose()) * 0.5).amax() / scale;
    assert!(miss < 1e-13, "{name}: {miss:e}");
    exact
}

/// What is found where one unknown has gone a step; the body comes back.
fn after<T>(body: &mut Galerkin, unknown: usize, sign: f64, find: impl Fn(&mut Galerkin) -> T) -> T {
    let saved = body.save();
    let mut way = vec![0.0; body.unknowns()];
    way[unknown] = sign * STEP;
    body.update(&way);
    let found = find(body);
    body.restore(&saved);
    found
}

fn residual(body: &mut Galerkin) -> Vec<f64> {
    let (mut inner, mut outer) = (vec![0.0; body.unknowns()], vec![0.0; body.unknowns()]);
    body.internal(LEVEL, &mut inner);
    body.external(LEVEL, &mut outer);
    inner.iter().zip(outer).map(|(a, b)| a - b).collect()
}
