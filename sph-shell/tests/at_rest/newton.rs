//! Newton's method on the shell: quadratic at regular points; negative pivots are negative eigenvalues.

use crate::common::{curved, energy_formulations, flat, shake, shell};
use implicit_statics::{Equilibrium, Newton, NewtonOptions, SymmetricSolver};
use nalgebra::DMatrix;
use shell_kinematics::strain_measures;
use sph_core::{Side, Vec3};
use sph_shell::{Clamped, Force, StaticShell, Supported};

/// A strip clamped on one edge, bent by a force on the other.
fn cantilever(formulation: usize) -> StaticShell {
    let cloud = flat([9, 3], [4.0, 1.0]);
    let sides = cloud.sides.clone().unwrap();
    let shares = sides.edge(Side::U1).iter().map(|&a| (a, 1.0)).collect();
    let clamp = Supported { particles: sides.edge(Side::U0).to_vec(), support: Box::new(Clamped) };
    let force = Force { shares, total: Vec3::new(0.0, 0.0, 5e-3) };
    let body = shell(
        cloud,
        energy_formulations()[formulation].1,
        0.1,
        strain_measures()[0],
        vec![clamp],
        vec![Box::new(force)],
    );
    StaticShell::new(body)
}

#[test]
fn residuals_fall_quadratically() {
    for (number, (name, _)) in energy_formulations().into_iter().enumerate() {
        let mut system = cantilever(number);
        let options = NewtonOptions { tolerance: 1e-11, line_search: false, keep: 0.0, ..Default::default() };
        let mut newton = Newton::new(&system, &options).unwrap();
        for level in [0.25, 0.5, 0.75, 1.0] {
            newton.at_level(&mut system, level).unwrap();
        }
        let tip = system.shell().displacement(26).z;
        assert!(tip > 0.5, "{name}: {tip} is no large deflection of a strip of 4");
        let residuals = newton.at_level(&mut system, 1.3).unwrap().residuals;
        // The order between three iterates that are neither far away nor round-off.
        let largest = residuals.iter().copied().fold(0.0, f64::max);
        let order = residuals
            .windows(3)
            .filter(|r| r[0] < largest && r[2] > 1e-10 * largest)
            .map(|r| libm::log(r[2] / r[1]) / libm::log(r[1] / r[0]))
            .fold(0.0, f64::max);
        assert!(order > 1.8, "{name}: order {order} in {residuals:?}");
    }
}

#[test]
fn negative_pivots_are_negative_eigenvalues() {
    let mut seen = Vec::new();
    for (number, (name, formulation)) in energy_formulations().into_iter().enumerate() {
        for (size, thickness) in [(0.0, 0.2), (0.1, 0.2), (0.2, 0.05), (0.4, 0.02)] {
            let cloud = curved([5, 4]);
            let clamp = Supported {
                particles: cloud.sides.as_ref().unwrap().edge(Side::U0).to_vec(),
                support: Box::new(Clamped),
            };
            let mut body = shell(cloud, formulation, thickness, strain_measures()[0], vec![clamp], vec![]);
            // A crumpled shell is pressed here and there: its tangent has negative eigenvalues.
            shake(&mut body, size, 5 + number as u64);
            let mut system = StaticShell::new(body);
            let (n, pattern) = (system.unknowns(), system.pattern());
            let mut values = vec![0.0; pattern.len()];
            system.tangent(0.0, &mut values);
            let mut dense = DMatrix::zeros(n, n);
            for (&(i, j), &value) in pattern.iter().zip(&values) {
                dense[(i, j)] = value;
                dense[(j, i)] = value;
            }
            let expected = dense.symmetric_eigenvalues().iter().filter(|&&value| value < 0.0).count();
            let mut solver = SymmetricSolver::new(n, &pattern).unwrap();
            assert_eq!(solver.factor(&values).unwrap().negative, expected, "{name}, shaken by {size}");
            seen.push(expected);
        }
    }
    assert!(seen.contains(&0) && seen.iter().any(|&count| count > 5), "{seen:?}");
}
