//! A shell far from zero answers as at zero: displacements, iterations, reactions, resultants.

use std::ops::ControlFlow;

use crate::common::{at, curved, parts, supported};
use explicit_dynamics::Amplitude;
use implicit_statics::{Newton, NewtonOptions, RelaxationOptions, relax};
use sph_core::{Cloud, Side, Vec3};
use sph_shell::{
    AppliedLoad, Clamped, Force, Formulation, Load, Parts, Reach, RigidSet, Shell, Spring, StaticShell,
    Turned, origin_of,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
const THICK: f64 = 0.02;

fn moved(mut cloud: Cloud, by: Vec3) -> Cloud {
    cloud.positions.iter_mut().for_each(|x| *x += by);
    cloud
}

/// A curved sheet clamped at one edge, pushed at the other, on a spring, with a rigid patch; far away by so much, about an origin.
fn sheet(by: Vec3, origin: impl Fn(&Cloud) -> Vec3, turned: bool) -> StaticShell {
    let near = curved([9, 8]);
    let patch = at(&near, |x| (x - near.positions[28]).norm() < 0.5);
    let middle = near.positions[28];
    let cloud = moved(near, by);
    let origin = origin(&cloud);
    let sides = cloud.sides.clone().unwrap();
    let edge = sides.edge(Side::U1).to_vec();
    let mut supports = vec![supported(sides.edge(Side::U0).to_vec(), Clamped)];
    let mut loads = Vec::new();
    if turned {
        let (axis, amplitude) = (Vec3::new(0.2, 1.0, 0.1), Amplitude::Constant);
        let point = cloud.positions[edge[0] as usize] + Vec3::new(0.1, 0.0, 0.2);
        supports.push(supported(edge, Turned { axis, point, by: 0.002, amplitude }));
    } else {
        let shares = edge.iter().map(|&a| (a, 1.0)).collect();
        let load: Box<dyn Load> = Box::new(Force { shares, total: Vec3::new(1e-6, 2e-6, -8e-6) });
        loads.push(AppliedLoad { load, amplitude: Amplitude::Constant });
    }
    let parts = Parts { supports, loads, ..parts(cloud, CELL, THICK) };
    let body = Shell::builder(parts).origin(origin);
    let body = body.rigid(vec![RigidSet {
        particles: patch,
        at: middle + by + Vec3::z(),
        mass: 1.0,
        ..RigidSet::default()
    }]);
    let body =
        body.springs(vec![Spring { stiffness: vec![(12, 0.01)], direction: Vec3::z() }]).build().unwrap();
    StaticShell::new(body)
}

/// Displacements of all particles, iterations, and what the supports bear about the clamp.
fn answer(mut system: StaticShell, by: Vec3, relaxed: bool) -> (Vec<Vec3>, usize, [Vec3; 2]) {
    let iterations = if relaxed {
        let options = RelaxationOptions { iterations: 20_000, ..RelaxationOptions::default() };
        let found = relax(&mut system, &options, (0.0, 1.0), |_| ControlFlow::Continue(()));
        found.map_or(20_000, |found| found.evaluations)
    } else {
        let options = NewtonOptions { line_search: false, iterations: 40, ..NewtonOptions::default() };
        Newton::new(&system, &options).unwrap().at_level(&mut system, 1.0).unwrap().iterations
    };
    system.evaluate(1.0);
    let shell = system.shell();
    let borne = shell.support_resultant(by);
    let displacements = (0..shell.len()).map(|a| shell.displacement(a)).collect();
    for a in 0..shell.len() {
        let gap = shell.position(a) - shell.rest_position(a) - shell.displacement(a);
        assert!(gap.norm() <= 1e-14 * (1.0 + by.norm()), "{gap}");
    }
    (displacements, iterations as usize, [borne.force, borne.moment])
}

/// The sheet is 2.5 long: at 10⁴ of its lengths, and where relaxation once stalled.
#[test]
fn a_shell_far_away_answers_as_at_zero() {
    for by in [Vec3::new(3.3, -2.1, 0.7) * 5.0, Vec3::new(2.1e4, -1.3e4, 0.7e4)] {
        for (turned, relaxed) in [(false, false), (true, false), (false, true)] {
            let here = answer(sheet(Vec3::zeros(), |_| Vec3::zeros(), turned), Vec3::zeros(), relaxed);
            let there = answer(sheet(by, origin_of, turned), by, relaxed);
            let plain = answer(sheet(by, |_| Vec3::zeros(), turned), by, relaxed);
            let size = here.0.iter().map(Vec3::norm).fold(0.0, f64::max);
            let off = |other: &(Vec<Vec3>, usize, [Vec3; 2])| {
                here.0.iter().zip(&other.0).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max) / size
            };
            let borne =
                (0..2).map(|i| (here.2[i] - there.2[i]).norm() / here.2[i].norm()).fold(0.0, f64::max);
            println!(
                "by {:.0}, turned {turned}, relaxed {relaxed}: {:.1e} in {} of {}, borne {borne:.1e}; from zero {:.1e} in {}",
                by.norm(),
                off(&there),
                there.1,
                here.1,
                off(&plain),
                plain.1
            );
            // Places far away are rounded to 1e-12 of the sheet when they are given; what is thin answers to that.
            // One iteration more or less where a residual lies at its bound but for rounding.
            assert!(
                off(&there) < 1e-9 && there.1.abs_diff(here.1) <= 1,
                "{:.1e} in {}",
                off(&there),
                there.1
            );
            // What supports that turn bear adds up to nothing.
            assert!(turned || borne < 1e-8, "{borne:.1e}");
            // Without an origin displacements are rounded as places are, and nothing comes to rest.
            assert!(!(relaxed && by.norm() > 1e3) || plain.1 == 20_000, "{}", plain.1);
        }
    }
}
