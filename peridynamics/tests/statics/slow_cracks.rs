//! A double cantilever opened level by level: what its broken bonds held is what was asked of its crack.

use explicit_dynamics::Amplitude;
use implicit_statics::{Newton, NewtonOptions};
use peridynamics::{
    Correction, Crack, Criterion, Elastic, Formulation, Fracture, Law, Parts, Solid, Space, StaticSolid,
    Support, Supported,
};
use sph_core::Vec3;

use crate::blocks::{formulation, lattice, parts};

/// Nodes across an arm of height one.
const ACROSS: usize = 8;
/// Energy of a unit area of crack over `E h`; so little that arms hardly turn.
const TOUGHNESS: f64 = 1e-7;

/// Energy of the bonds that break by work while the crack grows by half an arm, over that asked for.
fn spent(poisson: f64) -> f64 {
    let criterion = Criterion::EnergyByWork(TOUGHNESS);
    let dx = 1.0 / ACROSS as f64;
    let block = lattice(2, Vec3::new(0.0, -1.0, 0.0), [5.0, 2.0, 1.0], dx).block().unwrap();
    let on = |here: &dyn Fn(&Vec3) -> bool| -> Vec<u32> {
        (0..block.len()).filter(|&a| here(&block.positions[a])).map(|a| a as u32).collect()
    };
    let held = Support::Held { displacement: vec![Vec3::x(), Vec3::y()], director: Vec::new() };
    let mut supports = vec![Supported { nodes: on(&|x| x.x > 5.0 - dx), support: held }];
    for side in [1.0, -1.0] {
        let (direction, by) = (Vec3::y(), side * 5e-3);
        let support = Support::Moved { direction, by, amplitude: Amplitude::Constant };
        supports.push(Supported { nodes: on(&|x| x.x < dx && side * x.y > 0.0), support });
    }
    let unbreakable = on(&|x| x.x < 1.0 || x.x > 4.0);
    let material = Elastic { young: 1.0, poisson, density: 1.0 };
    let mut system = StaticSolid::new(
        Solid::new(Parts {
            supports,
            fracture: Some(Fracture { criterion, unbreakable }),
            cracks: vec![Crack::Segment([Vec3::new(-1.0, 0.0, 0.0), Vec3::new(2.0, 0.0, 0.0)])],
            ..parts(
                block.clone(),
                material,
                Formulation {
                    horizon: 2.015,
                    ..formulation(Space::PlaneStress, Law::StateBased, Correction::Even)
                },
            )
        })
        .unwrap(),
    );
    // The tip by the number of cut bonds a column.
    let tip = |system: &StaticSolid| {
        let cracked = |&a: &usize| block.positions[a].y.abs() < dx && system.solid().damage(a) > 0.3;
        (0..block.len()).filter(cracked).map(|a| block.positions[a].x).fold(0.0, f64::max)
    };
    let held =
        |system: &StaticSolid| -> f64 { (0..block.len()).map(|a| system.solid().fracture_energy(a)).sum() };
    let mut newton = Newton::new(&system, &NewtonOptions::default()).unwrap();
    let (from, mut level) = (tip(&system), 0.6);
    while tip(&system) < from + 0.5 {
        newton.at_level(&mut system, level).unwrap();
        while newton.give_way(&mut system, level).unwrap().is_some() {}
        level *= 1.03;
    }
    held(&system) / (TOUGHNESS * (tip(&system) - from))
}

/// With one work for all bonds, short or long, it is 1.23 to 1.31 in finer cantilevers: the shortest bonds hold the tip alone,
/// and the others are far beyond their limit when those break.
#[test]
fn bonds_of_a_slow_crack_hold_what_is_asked() {
    for (poisson, measured) in [(0.2, 1.0), (0.45, 1.02)] {
        let spent = spent(poisson);
        // Each bond is counted with what takes it to its limit; measured 0.999 and 1.018.
        assert!((spent - measured).abs() < 0.05, "ν = {poisson}: {spent}");
    }
}
