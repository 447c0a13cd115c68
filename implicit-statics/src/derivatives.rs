//! What a system says of its derivatives, held against differences: for tests of a system of one's own.
//!
//! Differences are central and of fourth order: truncation falls as `step⁴`, rounding grows as `1e-16/step`; `step` times the direction
//! is what unknowns move by.

use crate::equilibrium::Equilibrium;
use crate::vectors::dot;

/// By how much of itself the work of the internal forces along a direction misses the slope of the energy \[–\].
pub fn force_error<E: Equilibrium>(system: &mut E, level: f64, direction: &[f64], step: f64) -> f64 {
    let mut forces = vec![0.0; direction.len()];
    system.internal(level, &mut forces);
    let home = system.save();
    let slope = slopes(step, |way| {
        system.restore(&home);
        system.update(&scaled(direction, way));
        vec![system.energy()]
    });
    system.restore(&home);
    greatest_miss(&slope, &[dot(&forces, direction)])
}

/// By how much of itself `vᵀK v` of the tangent misses the slope of the work out of balance along v, a motion that goes straight on
/// while unknowns turn with the body \[–\]. A skew share of the tangent does not show.
pub fn stiffness_error<E: Equilibrium>(system: &mut E, level: f64, direction: &[f64], step: f64) -> f64 {
    let stiffness = dot(&product(system, level, direction), direction);
    let home = system.save();
    let slope = slopes(step, |way| {
        system.restore(&home);
        let mut motion = scaled(direction, way);
        system.transport(&mut motion);
        vec![dot(&out_of_balance(system, level), &motion) / way]
    });
    system.restore(&home);
    greatest_miss(&slope, &[stiffness])
}

/// The greatest miss of `K v` of the tangent, row by row, from the slope of the forces out of balance along v, over its greatest row
/// \[–\]; of systems whose unknowns add up.
pub fn tangent_error<E: Equilibrium>(system: &mut E, level: f64, direction: &[f64], step: f64) -> f64 {
    let product = product(system, level, direction);
    let home = system.save();
    let slopes = slopes(step, |way| {
        system.restore(&home);
        system.update(&scaled(direction, way));
        out_of_balance(system, level)
    });
    system.restore(&home);
    greatest_miss(&slopes, &product)
}

/// The greatest miss of the load rate, row by row, from the slope of the forces out of balance over the level, over its greatest row \[–\].
pub fn load_rate_error<E: Equilibrium>(system: &mut E, level: f64, step: f64) -> f64 {
    let mut rate = vec![0.0; system.unknowns()];
    system.load_rate(level, &mut rate);
    let slopes = slopes(step, |way| scaled(&out_of_balance(system, level + way), -1.0));
    greatest_miss(&slopes, &rate)
}

/// Internal less external forces.
fn out_of_balance<E: Equilibrium>(system: &mut E, level: f64) -> Vec<f64> {
    let (mut forces, mut loads) = (vec![0.0; system.unknowns()], vec![0.0; system.unknowns()]);
    system.internal(level, &mut forces);
    system.external(level, &mut loads);
    forces.iter().zip(&loads).map(|(f, e)| f - e).collect()
}

/// The symmetric tangent times a direction.
fn product<E: Equilibrium>(system: &mut E, level: f64, direction: &[f64]) -> Vec<f64> {
    system.pattern_changed(level);
    let pattern = system.pattern();
    let mut values = vec![0.0; pattern.len()];
    system.tangent(level, &mut values);
    let mut product = vec![0.0; direction.len()];
    for (&(row, column), value) in pattern.iter().zip(&values) {
        product[row] += value * direction[column];
        if row != column {
            product[column] += value * direction[row];
        }
    }
    let beside = system.beside_pattern(level);
    beside.iter().for_each(|term| term.add_product(1.0, direction, &mut product));
    product
}

fn slopes(step: f64, mut of: impl FnMut(f64) -> Vec<f64>) -> Vec<f64> {
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|factor| of(factor * step));
    (0..a.len()).map(|i| (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * step)).collect()
}

fn scaled(direction: &[f64], factor: f64) -> Vec<f64> {
    direction.iter().map(|v| factor * v).collect()
}

/// The greatest difference over the greatest value that is wanted; infinite where one of them is no number or nothing is wanted.
fn greatest_miss(found: &[f64], wanted: &[f64]) -> f64 {
    let greatest = wanted.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let misses = || found.iter().zip(wanted).map(|(a, b)| (a - b).abs() / greatest);
    if misses().any(f64::is_nan) { f64::INFINITY } else { misses().fold(0.0, f64::max) }
}
