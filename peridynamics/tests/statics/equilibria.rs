//! Equilibria: Newton converges quadratically, relaxation finds the same, prescribed values go with the level.

use std::ops::ControlFlow;

use implicit_statics::{
    BucklingOptions, Control, Damping, End, Equilibrium, Newton, NewtonOptions, PathOptions, Prebuckling,
    RelaxationOptions, Start, follow, linear_buckling, load_rate_error, relax, unwatched,
};
use peridynamics::{Criterion, Fracture, Law, Parts, Solid, Space, StaticSolid};
use sph_core::Vec3;

use crate::blocks::{held, moved, nodes, pulled};
use crate::bodies::{LAWS, SPACES, block_parts, short};

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
            let force = if space == Space::Solid { 1.6e-2 } else { 3e-3 };
            parts.loads = vec![pulled(&tip, Vec3::new(0.0, force, 0.0))];
            let mut system = StaticSolid::new(Solid::new(parts).unwrap());
            let options = NewtonOptions { tolerance: 1e-12, line_search: false, ..NewtonOptions::default() };
            let mut newton = Newton::new(&system, &options).unwrap();
            newton.at_level(&mut system, 0.5).unwrap();
            let residuals = newton.at_level(&mut system, 1.0).unwrap().residuals;
            let sag = system.solid().displacement(tip[0] as usize).y;
            assert!(sag > 1.0, "{space:?}, {law:?}: {sag} spacings are no large deflection");
            // The order between three iterates that are neither far away nor round-off.
            let largest = residuals.iter().copied().fold(0.0, f64::max);
            let order = residuals
                .windows(3)
                .filter(|r| r[0] <= largest && r[1] < r[0] && r[2] > 1e-13 * largest)
                .map(|r| libm::log(r[2] / r[1]) / libm::log(r[1] / r[0]))
                .fold(0.0, f64::max);
            println!("{space:?}, {law:?}: sag {sag:.2}, order {order:.2} in {}", short(&residuals));
            assert!(order > 1.8, "{space:?}, {law:?}: {residuals:?}");
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
                RelaxationOptions { damping, tolerance: 1e-5, ramp: 10, ..RelaxationOptions::default() };
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
    let error = load_rate_error(&mut system, 0.5, 1e-4);
    // Moves of 3e-6 spacings: rounding of the forces is 1e-10 of their change.
    assert!(error < 1e-7, "{error:.1e}");
}

#[test]
fn a_column_buckles_at_eulers_load() {
    let column = |law, across: usize| {
        let length = 8 * across;
        // Held over two spacings; the column begins between the second and the third.
        let (mut parts, tip) = cantilever(Space::PlaneStress, law, [length + 2, across, 1]);
        let load = 1e-3;
        parts.loads = vec![pulled(&tip, Vec3::new(-load, 0.0, 0.0))];
        let mut system = StaticSolid::new(Solid::new(parts).unwrap());
        let inertia = across.pow(3) as f64 / 12.0;
        let euler = std::f64::consts::PI.powi(2) * inertia / (4.0 * (length as f64 - 0.5).powi(2)) / load;
        let level = |prebuckling| {
            let options = BucklingOptions { prebuckling, ..BucklingOptions::new(1) };
            let modes = linear_buckling(&mut system, 0.0, &options, &mut unwatched).unwrap();
            modes.modes[0].level / euler
        };
        [Prebuckling::Rotations, Prebuckling::Stress].map(level)
    };
    for (law, across) in [(LAWS[0], 8), (LAWS[0], 16), (LAWS[1], 8)] {
        let found = column(law, across);
        println!("{law:?}, {across} across: {found:.4?} of Euler's load");
        // The column is straight before it buckles: the two derivatives differ by its strain there, 0.4 %.
        assert!((found[0] / found[1] - 1.0).abs() < 0.01, "{law:?}: {found:?}");
        // Few nodes across are soft in bending: 0.886 with 8, 0.959 with 16, of which shear is 0.008.
        let known = if across == 8 { 0.888 } else { 0.959 };
        assert!((found[0] - known).abs() < 0.01, "{law:?}: {found:?}");
    }
}

#[test]
fn bonds_break_one_critical_set_at_a_time() {
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
    assert_eq!(system.solid().broken()[0].len(), 0);
    let breach = newton.give_way(&mut system, 1.0).unwrap().unwrap();
    let broken = system.solid().broken()[0].len();
    // The bonds at one corner and those that the mirror makes alike, from both ends.
    assert!(broken > 0 && broken <= 8, "{broken}");
    assert!(breach.utilisation > 1.0 && breach.energy > 0.0 && breach.released > 0.0, "{breach:?}");
    system.commit();
    assert_eq!(system.solid().broken()[0].len(), broken);
    while newton.give_way(&mut system, 1.0).unwrap().is_some() {}
    assert!(system.utilisation() < 1.0);
    let path = newton.at_level(&mut system, 0.5).unwrap();
    assert!(reaction(&mut system, &right) < 0.999 * whole, "{path:?}");
}
