//! Linear answers by conjugate gradients: rigid motions, the direct answer, iterations by spacing and thickness, hard cases, refusals.

use crate::common::{
    self, RandomNumbers, X, Y, Z, at, curved, disordered_flat, energy_formulations, flat, free_shell, line,
    parts, supported, tee,
};
use explicit_dynamics::Amplitude;
use implicit_statics::{
    ConjugateOptions, Equilibrium, EquilibriumError, Iterated, conjugate_response, linear_response,
};
use nalgebra::Matrix3;
use sph_core::{Cloud, Side, Vec3};
use sph_shell::{
    AppliedLoad, Clamped, Force, Formulation, Holds, Load, Parts, Reach, RigidSet, Shell, ShellBuilder,
    StaticShell, Supported, Tie,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

fn loaded(
    cloud: Cloud,
    formulation: Formulation,
    thickness: f64,
    clamped: Vec<u32>,
    load: Force,
) -> ShellBuilder {
    let clamp = (!clamped.is_empty()).then(|| supported(clamped, Clamped));
    let supports: Vec<Supported> = clamp.into_iter().collect();
    let loads = vec![AppliedLoad { load: Box::new(load) as Box<dyn Load>, amplitude: Amplitude::Constant }];
    Shell::builder(Parts { supports, loads, ..parts(cloud, formulation, thickness) })
}

/// A sheet clamped along one edge, under a force on the opposite one.
fn cantilever(cloud: Cloud, formulation: Formulation, thickness: f64) -> Shell {
    let edge = |side| cloud.sides.as_ref().unwrap().edge(side).to_vec();
    let (clamped, end) = (edge(Side::U0), edge(Side::U1));
    let force =
        Force { shares: end.into_iter().map(|a| (a, 1.0)).collect(), total: Vec3::new(0.3, 0.2, 1.0) };
    loaded(cloud, formulation, thickness, clamped, force).build().unwrap()
}

/// Distance of the answer from the direct one over the largest unknown of that.
fn compared(body: Shell) -> (Iterated, f64) {
    let mut system = StaticShell::new(body);
    let found = conjugate_response(&mut system, 0.0, &ConjugateOptions::default()).unwrap();
    let direct = linear_response(&mut system, 0.0).unwrap();
    let top = direct.iter().fold(0.0_f64, |top, u| top.max(u.abs()));
    let off = direct.iter().zip(&found.response).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
    (found, off / top)
}

#[test]
fn rigid_motions_meet_no_stiffness() {
    let far = Shell::builder(parts(tee(6, 0.4, 3), CELL, 0.05));
    let far = far
        .rigid(vec![RigidSet {
            particles: at(&tee(6, 0.4, 3), |x| x.z > 1.0 - 1e-9),
            at: Vec3::new(0.1, 0.2, 1.3),
            mass: 1.0,
            inertia: Matrix3::identity() * 0.1,
            holds: Vec::new(),
        }])
        .build()
        .unwrap();
    for body in [free_shell(curved([7, 6]), CELL, 0.1), free_shell(tee(6, 0.4, 3), CELL, 0.05), far] {
        let mut system = StaticShell::new(body);
        let pattern = system.pattern();
        let mut values = vec![0.0; pattern.len()];
        system.tangent(0.0, &mut values);
        let motions = system.rigid_motions().unwrap();
        for k in 0..6 {
            // Forces by rows against those without signs.
            let (mut force, mut size) = (vec![0.0; motions.len()], vec![0.0; motions.len()]);
            for (&(i, j), &value) in pattern.iter().zip(&values) {
                force[i] += value * motions[j][k];
                size[i] += (value * motions[j][k]).abs();
                if i != j {
                    force[j] += value * motions[i][k];
                    size[j] += (value * motions[i][k]).abs();
                }
            }
            let most = size.iter().copied().fold(0.0, f64::max);
            let off = force.iter().fold(0.0_f64, |off, f| off.max(f.abs())) / most;
            assert!(off < 1e-13, "motion {k}: {off}");
        }
    }
}

/// Every way to sample, junctions, bodies, ties: the direct answer within a hundred of the tolerance 1e-9.
#[test]
fn it_finds_the_direct_answer_whatever_the_shell_is_made_of() {
    let wide = Formulation::StressPoint(Reach::Kernel(&sph_core::CubicSpline, 1.4));
    let nodal = energy_formulations().into_iter().find(|(name, _)| name.contains("nodal")).unwrap().1;
    let stem = || {
        let cloud = tee(12, 0.4, 4);
        let (ends, tip) = (at(&cloud, |x| x.x.abs() > 1.0 - 1e-9), at(&cloud, |x| x.z > 1.0 - 1e-9));
        let force = Force { shares: line(&cloud, &tip), total: X + Y * 0.3 };
        loaded(cloud, CELL, 0.02, ends, force)
    };
    let body = {
        let cloud = flat([17, 9], [2.0, 1.0]);
        let edge = |side| cloud.sides.as_ref().unwrap().edge(side).to_vec();
        let (clamped, end) = (edge(Side::U0), edge(Side::U1));
        let middle = at(&cloud, |x| (x.x - 1.0).abs() < 0.2 && (x.y - 0.5).abs() < 0.2);
        let force = Force { shares: end.into_iter().map(|a| (a, 1.0)).collect(), total: Z };
        let body = loaded(cloud, CELL, 0.02, clamped, force);
        let (at, holds) = (Vec3::new(1.0, 0.5, 0.3), Holds::default());
        let inertia = Matrix3::identity();
        body.rigid(vec![RigidSet { particles: middle, at, mass: 1.0, inertia, holds: vec![holds] }])
            .build()
            .unwrap()
    };
    let tied = {
        let cloud = common::Sheets::default()
            .add(-X, [X * 2.0, Y * 0.4], [20, 5])
            .add(Vec3::zeros(), [Z, Y * 0.4], [12, 4])
            .cloud();
        let (ends, tip) = (at(&cloud, |x| x.x.abs() > 1.0 - 1e-9), at(&cloud, |x| x.z > 1.0 - 1e-9));
        let edge = at(&cloud, |x| x.x.abs() < 1e-9 && x.z < 1e-9);
        let force = Force { shares: line(&cloud, &tip), total: X };
        let body = loaded(cloud, CELL, 0.02, ends, force);
        body.ties(vec![Tie { edge, host: (0..100).collect() }]).build().unwrap()
    };
    let all = [
        ("curved", cantilever(curved([17, 13]), CELL, 0.05)),
        ("disordered", cantilever(disordered_flat([17, 13], [1.0, 1.0]), CELL, 0.05)),
        ("wide", cantilever(flat([15, 11], [1.0, 1.0]), wide, 0.1)),
        ("nodal", cantilever(curved([15, 11]), nodal, 0.1)),
        ("tee", stem().build().unwrap()),
        ("rigid set", body),
        ("tied", tied),
    ];
    for (name, body) in all {
        let (found, off) = compared(body);
        println!("{name}: {:?} unknowns, {} iterations, off by {off:.1e}", found.levels, found.iterations);
        assert!(found.levels.len() > 1 && found.iterations > 0, "{name}: {:?}", found.levels);
        assert!(off < 1e-7, "{name}: {off}");
    }
}

/// At one spacing over the thickness sixteen times the particles take twice the iterations; with it they grow, since a node by
/// itself cannot bend without shear.
#[test]
fn iterations_follow_the_spacing_over_the_thickness_and_not_the_number() {
    let count = |n: usize, thickness: f64| {
        let (found, off) = compared(cantilever(flat([n, n], [1.0, 1.0]), CELL, thickness));
        println!("{n}² at t = {thickness}: {} iterations, off by {off:.1e}", found.iterations);
        // The tolerance times the square root of the spread of stiffness, which is h²/t² of bending beside membrane.
        assert!(off < 1e-6, "{n} {thickness}: {off}");
        found.iterations
    };
    let [few, many] = [count(21, 0.05), count(81, 0.0125)];
    assert!(many < 3 * few, "{few} {many}");
    let [thick, thin] = [count(41, 0.025), count(41, 0.0025)];
    assert!(thin > 2 * thick && thin < 20 * thick, "{thick} {thin}");
}

/// A thousandth as thick as long, and slivers of a thousandth of a cell.
#[test]
fn thin_shells_and_slivers_come_to_the_direct_answer() {
    let (found, off) = compared(cantilever(curved([17, 13]), CELL, 1e-3));
    println!("thin: {} iterations, off by {off:.1e}", found.iterations);
    assert!(off < 1e-5, "{off}");
    let mut cloud = flat([17, 13], [1.0, 1.0]);
    let mut dice = RandomNumbers(5);
    for x in &mut cloud.positions {
        // One column of cells a thousandth as wide as the rest.
        if (x.x - 0.5).abs() < 1e-9 {
            x.x += 0.999 / 16.0;
        }
        x.y += 1e-3 * dice.roll() * x.y * (1.0 - x.y);
    }
    let cloud = Cloud {
        sides: cloud.sides.clone(),
        ..Cloud::from_cells(cloud.positions, None, cloud.cells).unwrap()
    };
    let (found, off) = compared(cantilever(cloud, CELL, 0.02));
    println!("slivers: {} iterations, off by {off:.1e}", found.iterations);
    assert!(off < 1e-5, "{off}");
}

#[test]
fn threads_change_no_bit() {
    let answer = |threads: usize| {
        let body = cantilever(curved([21, 17]), CELL, 0.05);
        let mut system = StaticShell::new(body);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| conjugate_response(&mut system, 0.0, &ConjugateOptions::default()).unwrap().response)
    };
    assert_eq!(answer(1), answer(2));
}

#[test]
fn a_body_without_supports_and_too_few_iterations_are_refused() {
    let cloud = curved([17, 13]);
    let force = Force { shares: vec![(0, 1.0), (200, -1.0)], total: Z };
    let mut free = StaticShell::new(loaded(cloud, CELL, 0.05, Vec::new(), force).build().unwrap());
    let refused = conjugate_response(&mut free, 0.0, &ConjugateOptions::default()).unwrap_err();
    assert!(
        matches!(refused, EquilibriumError::Indefinite { .. } | EquilibriumError::Singular { .. }),
        "{refused}"
    );
    let mut held = StaticShell::new(cantilever(curved([17, 13]), CELL, 0.05));
    let options = ConjugateOptions { iterations: 3, ..ConjugateOptions::default() };
    let refused = conjugate_response(&mut held, 0.0, &options).unwrap_err();
    assert!(matches!(refused, EquilibriumError::NotIterated { iterations: 3, .. }), "{refused}");
}
