//! Notched strips that tear: force and energy against Griffith.

use std::ops::ControlFlow;

use implicit_statics::{Control, Equilibrium, PathOptions, Start, follow};
use peridynamics::{Correction, Crack, Criterion, Elastic, Fracture, Law, Parts, Solid, Space, StaticSolid};
use sph_core::Vec3;

use crate::blocks::{formulation, held, lattice, moved, nodes, parts, pulled};

/// An edge notch in a strip of width one.
const NOTCH: f64 = 0.4;
/// Half of the height; the closed form wants the width at least.
const HALF: f64 = 1.0;
/// Energy of a unit area of crack over `E`; so little that the strip hardly strains.
const TOUGHNESS: f64 = 1e-8;

/// Stress σ at its ends at which `K²/E` is the energy of a unit area of crack, with `K = σ √(πa) F(a/W)`: the polynomial for an edge
/// crack under a uniform stress is within half a percent up to a/W = .6.
fn critical_stress(notch: f64) -> f64 {
    let x = notch;
    let shape = 1.12 - 0.231 * x + 10.55 * x * x - 21.72 * x.powi(3) + 30.39 * x.powi(4);
    TOUGHNESS.sqrt() / ((std::f64::consts::PI * notch).sqrt() * shape)
}

/// The strip, loaded or drawn at its ends, and the nodes of the upper one.
fn strip(across: usize, law: Law, by_work: bool, by_load: bool) -> (StaticSolid, Vec<u32>) {
    let dx = 1.0 / across as f64;
    let block = lattice(2, Vec3::new(0.0, -HALF, 0.0), [1.0, 2.0 * HALF, 1.0], dx).block().unwrap();
    let ends = [1.0, -1.0].map(|side: f64| nodes(&block, |x| side * x.y > HALF - dx));
    let corner = nodes(&block, |x| x.x < dx && x.y < -HALF + dx);
    let criterion =
        if by_work { Criterion::EnergyByWork(TOUGHNESS) } else { Criterion::EnergyByStretch(TOUGHNESS) };
    let unbreakable = nodes(&block, |x| x.y.abs() > 0.5 * HALF);
    let poisson = if law == Law::BondBased { 1.0 / 3.0 } else { 0.3 };
    let material = Elastic { young: 1.0, poisson, density: 1.0 };
    let shape = formulation(Space::PlaneStress, law, Correction::Even);
    let mut parts = Parts {
        fracture: Some(Fracture { criterion, unbreakable }),
        cracks: vec![Crack::Segment([Vec3::new(-1.0, 0.0, 0.0), Vec3::new(NOTCH, 0.0, 0.0)])],
        ..parts(block, material, shape)
    };
    if by_load {
        parts.supports = vec![held(corner, &[Vec3::x(), Vec3::y()])];
        let far = nodes(&parts.block, |x| x.x > 1.0 - dx && x.y < -HALF + dx);
        parts.supports.push(held(far, &[Vec3::y()]));
        parts.loads = vec![pulled(&ends[0], Vec3::y()), pulled(&ends[1], -Vec3::y())];
    } else {
        parts.supports =
            vec![moved(ends[0].clone(), Vec3::y(), 1.0), moved(ends[1].clone(), -Vec3::y(), 1.0)];
        // Each half stands alone once it is torn off.
        let above = nodes(&parts.block, |x| x.x < dx && x.y > HALF - dx);
        parts.supports.extend([corner, above].map(|nodes| held(nodes, &[Vec3::x()])));
    }
    (StaticSolid::new(Solid::new(parts).unwrap()), ends[0].clone())
}

/// Under load the crack runs as soon as it starts, or a few rows later: that level is the greatest borne.
#[test]
fn a_notched_strip_bears_the_load_of_griffith() {
    let griffith = critical_stress(NOTCH);
    let (mut system, _) = strip(30, Law::BondBased, false, true);
    let options = PathOptions::new(Control::Load { step: 0.3 * griffith, until: 3.0 * griffith });
    let mut points = 0;
    let path = follow(&mut system, &Start::default(), &options, |_, _| {
        points += 1;
        // More than a row of the lattice: the crack runs.
        if points > 60 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let [first, last] = [path.breaches.first(), path.breaches.last()].map(|breach| breach.unwrap().level);
    // Measured 0.981 and 0.992; finer lattices hold the crack at up to 1.13, as slow cracks of cantilevers.
    assert!((first / griffith - 0.98).abs() < 0.02, "{}", first / griffith);
    assert!((last / griffith - 1.0).abs() < 0.05, "{}", last / griffith);
    // None is asked for more than its limit before the crack runs.
    assert!(path.breaches[0].utilisation < 1.002, "{}", path.breaches[0].utilisation);
}

/// Drawn by its ends it comes apart in two; bonds hold what is asked of the crack, and with what leaps set free and what is stored it is
/// the work of the ends.
#[test]
fn a_strip_drawn_apart_takes_the_energy_of_its_crack() {
    for (law, by_work, measured) in [(Law::BondBased, false, 1.157), (Law::StateBased, true, 1.147)] {
        let (mut system, top) = strip(20, law, by_work, false);
        let until = 4e-4;
        let mut options = PathOptions::new(Control::Load { step: 0.02 * until, until });
        options.largest = 1.0;
        let (mut work, mut before) = (0.0, [0.0; 2]);
        let path = follow(&mut system, &Start::default(), &options, |point, system| {
            let force: f64 = top.iter().map(|&a| system.solid().reaction(a as usize).y).sum();
            work += (force + before[1]) * (point.level() - before[0]);
            before = [point.level(), force];
            ControlFlow::Continue(())
        });
        assert!(path.end.is_ok(), "{:?}", path.end);
        // A node may still hang between the halves by two bonds that unfold.
        assert!(
            before[1] < 1e-3 * path.breaches.iter().map(|breach| breach.driving_force).fold(0.0, f64::max)
        );
        let asked = TOUGHNESS * (1.0 - NOTCH);
        let spent: f64 = path.breaches.iter().map(|breach| breach.energy).sum();
        let freed: f64 = path.breaches.iter().map(|breach| breach.released).sum();
        let counted: f64 = (0..system.solid().len()).map(|a| system.solid().fracture_energy(a)).sum();
        assert!((spent / counted - 1.0).abs() < 1e-12);
        // More than one are bonds that a straight cut does not cross.
        assert!((spent / asked - measured).abs() < 0.03, "{law:?}: {}", spent / asked);
        let stored = system.energy();
        // The trapezoidal rule is off by the curvature of the force over steps of 2 %: 6e-8 at steps of 1.3 %, 1.2e-4 at 25 %.
        assert!(
            ((stored + spent + freed) / work - 1.0).abs() < 1e-5,
            "{law:?}: {stored} {spent} {freed} {work}"
        );
        assert!(freed > 0.0);
    }
}
