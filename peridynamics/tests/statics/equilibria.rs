//! Equilibria: Newton converges quadratically, relaxation finds the same, prescribed values go with the level.

use std::ops::ControlFlow;

use implicit_statics::{
    BucklingOptions, Control, Damping, End, Equilibrium, Newton, NewtonOptions, PathOptions, Prebuckling,
    RelaxationOptions, Start, follow, linear_buckling, relax, unwatched,
};
use peridynamics::{Criterion, Fracture, Law, Parts, Solid, Space, StaticSolid};
use sph_core::Vec3;

use crate::blocks::{held, moved, nodes, pulled};
use crate::bodies::{LAWS, SPACES, block_parts, norm};

/// A strip held at its left end.
fn cantilever(space: Space, law: Law, cells: [usize; 3]) -> (Parts, Vec<u32>) {
    let mut parts = block_parts(space, law, cells);
    let left = nodes(&parts.block, |x| x.x < 2.0);
    let right = nodes(&parts.block, |x| x.x > cells[0] as f64 - 1.0);
    let axes = [Vec3::x(), Vec3::y(), Vec3::z()];
    parts.supports = vec![held(left, &axes[..space.dimensions()])];
    (parts, right)
}

#[test]
fn residuals_fall_quadratically() {
    for space in SPACES {
        for law in LAWS {
            let cells = if space == Space::Solid { [14, 3, 3] } else { [20, 4, 1] };
            let (mut parts, tip) = cantilever(space, law, cells);
            let force = if space == Space::Solid { 4e-3 } else { 2e-3 };
            parts.loads = vec![pulled(&tip, Vec3::new(0.0, force, 0.0))];
            let mut system = StaticSolid::new(Solid::new(parts).unwrap());
            let options = NewtonOptions { tolerance: 1e-12, line_search: false, ..NewtonOptions::default() };
            let mut newton = Newton::new(&system, &options).unwrap();
            for level in [0.25, 0.5, 0.75] {
                newton.at_level(&mut system, level).unwrap();
            }
            let residuals = newton.at_level(&mut system, 1.0).unwrap().residuals;
            let sag = system.solid().displacement(tip[0] as usize).y;
            assert!(sag > 1.0, "{space:?}, {law:?}: {sag} spacings are no large deflection");
            // The order between three iterates that are neither far away nor round-off.
            let largest = residuals.iter().copied().fold(0.0, f64::max);
            let order = residuals
                .windows(3)
                .filter(|r| r[0] < largest && r[2] > 1e-10 * largest)
                .map(|r| (r[2] / r[1]).ln() / (r[1] / r[0]).ln())
                .fold(0.0, f64::max);
            println!("{space:?}, {law:?}: sag {sag:.2}, order {order:.2} in {residuals:.1e?}");
            assert!(order > 1.8 || residuals.len() <= 4, "{space:?}, {law:?}: {residuals:?}");
        }
    }
}

/// A plate pulled by one end, the other held, with its reaction there.
fn pulled_plate(law: Law) -> (StaticSolid, Vec<u32>) {
    let (mut parts, right) = cantilever(Space::PlaneStress, law, [30, 20, 1]);
    parts.supports.push(moved(right.clone(), Vec3::x(), 0.03));
    parts.supports.push(held(right.clone(), &[Vec3::y()]));
    (StaticSolid::new(Solid::new(parts).unwrap()), right)
}

fn reaction(system: &mut StaticSolid, set: &[u32]) -> f64 {
    system.evaluate(1.0);
    set.iter().map(|&a| system.solid().reaction(a as usize).x).sum()
}

#[test]
fn relaxation_finds_the_reaction_of_newton() {
    for law in LAWS {
        let (mut system, right) = pulled_plate(law);
        let rest = system.save();
        let load = PathOptions::new(Control::Load { step: 1.0, until: 1.0 });
        let path = follow(&mut system, &Start::default(), &load, |_, _| ControlFlow::Continue(()));
        assert_eq!(path.end, Ok(End::Reached));
        let exact = reaction(&mut system, &right);
        for damping in [Damping::Kinetic, Damping::Rayleigh] {
            system.restore(&rest);
            let options =
                RelaxationOptions { damping, tolerance: 1e-5, ramp: 40, ..RelaxationOptions::default() };
            let found = relax(&mut system, &options, (0.0, 1.0), |_| ControlFlow::Continue(())).unwrap();
            let off = (reaction(&mut system, &right) / exact - 1.0).abs();
            println!("{law:?}, {damping:?}: {off:.1e} after {} iterations", found.iterations);
            assert!(off < 1e-4, "{law:?}, {damping:?}: {off:.1e}");
            assert!(found.iterations <= 200, "{law:?}, {damping:?}: {} iterations", found.iterations);
        }
    }
}

#[test]
fn the_load_rate_is_the_derivative_of_the_residual() {
    let (mut system, _) = pulled_plate(Law::StateBased);
    let n = system.unknowns();
    let (mut rate, mut ends) = (vec![0.0; n], [vec![0.0; n], vec![0.0; n]]);
    system.load_rate(0.5, &mut rate);
    for (level, out) in [0.5 + 1e-4, 0.5 - 1e-4].into_iter().zip(&mut ends) {
        system.internal(level, out);
    }
    let off: Vec<f64> = (0..n).map(|i| (ends[1][i] - ends[0][i]) / 2e-4 - rate[i]).collect();
    // Moves of 3e-6 spacings: rounding of the forces is 1e-10 of their change.
    assert!(norm(&off) < 1e-7 * norm(&rate), "{:.1e}", norm(&off) / norm(&rate));
}

#[test]
fn a_column_buckles_at_eulers_load() {
    for law in LAWS {
        // Held over two spacings, so that the column begins between the second and the third.
        let (across, length) = (8.0, 80.0);
        let (mut parts, tip) = cantilever(Space::PlaneStress, law, [82, 8, 1]);
        let load = 1e-3;
        parts.loads = vec![pulled(&tip, Vec3::new(-load, 0.0, 0.0))];
        let mut system = StaticSolid::new(Solid::new(parts).unwrap());
        let inertia = across.powi(3) / 12.0;
        let euler = std::f64::consts::PI.powi(2) * inertia / (4.0 * (length - 0.5_f64).powi(2)) / load;
        let mut found = Vec::new();
        for prebuckling in [Prebuckling::Rotations, Prebuckling::Stress] {
            let options = BucklingOptions { prebuckling, ..BucklingOptions::new(1) };
            let modes = linear_buckling(&mut system, 0.0, &options, &mut unwatched).unwrap();
            found.push(modes.modes[0].level / euler);
        }
        println!("{law:?}: {found:.4?} of Euler's load");
        // The column is straight before it buckles: both derivatives are the same but for Poisson's widening.
        assert!((found[0] / found[1] - 1.0).abs() < 1e-3, "{law:?}: {found:?}");
        assert!((found[1] - 1.0).abs() < 0.03, "{law:?}: {found:?}");
    }
}

#[test]
fn a_state_that_is_kept_breaks_its_bonds_once() {
    let (mut parts, right) = cantilever(Space::PlaneStress, Law::StateBased, [12, 8, 1]);
    parts.supports.push(moved(right.clone(), Vec3::x(), 0.5));
    let criterion = Criterion::Stretch { tension: 0.06, compression: None };
    parts.fracture = Some(Fracture { criterion, unbreakable: Vec::new() });
    let mut system = StaticSolid::new(Solid::new(parts).unwrap());
    let mut newton = Newton::new(&system, &NewtonOptions::default()).unwrap();
    newton.at_level(&mut system, 0.5).unwrap();
    let whole = reaction(&mut system, &right);
    assert_eq!(system.solid().broken()[0].len(), 0);
    newton.at_level(&mut system, 1.0).unwrap();
    let broken = system.solid().broken()[0].len();
    assert!(broken > 0);
    system.accept();
    assert_eq!(system.solid().broken()[0].len(), broken);
    let path = newton.at_level(&mut system, 0.5).unwrap();
    assert!(reaction(&mut system, &right) < 0.999 * whole, "{path:?}");
}
