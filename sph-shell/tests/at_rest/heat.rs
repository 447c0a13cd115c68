//! Heat: derivatives of the energy, free and held plates, two plies, buckling, vibration, ways of finding balance.

use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::common::{
    self, AXIS, DENSITY, POISSON, X, Y, YOUNG, Z, curved, derivatives_agree, disordered_curved,
    disordered_flat, energy, flat, parts, scattered_curved, scattered_flat, shake, supported, unsymmetric,
};
use implicit_statics::{
    BucklingOptions, Control, CriticalOptions, End, Equilibrium, Path, PathOptions, Prebuckling,
    RelaxationOptions, Start, follow, linear_buckling, linear_response, natural_modes, relax, unwatched,
};
use nalgebra::Rotation3;
use shell_kinematics::{
    GreenLagrange, Isotropic, IsotropicSection, LayeredSection, Orthotropic, Ply, strain_measures,
};
use sph_core::{Cloud, Side, Vec3};
use sph_shell::{
    Clamped, Formulation, HeatError, Held, LoadCase, Parts, PointResult, Reach, Region, Shell, ShellError,
    StaticShell, Supported,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
/// Coefficient of expansion of isotropic shells \[1/Θ\].
const EXPANSION: f64 = 2e-3;

fn isotropic() -> Isotropic {
    Isotropic::new(YOUNG, POISSON).unwrap().expanding(EXPANSION).unwrap()
}

/// An isotropic shell that expands.
fn expanding(cloud: Cloud, thickness: f64) -> Parts {
    let section = Box::new(IsotropicSection::new(isotropic(), thickness).unwrap());
    Parts { section, ..parts(cloud, CELL, thickness) }
}

/// All cells warmer by the same.
fn everywhere(cloud: &Cloud, change: [f64; 2], case: LoadCase) -> sph_shell::Temperature {
    let cells: Vec<u32> = (0..cloud.cells.len() as u32).collect();
    sph_shell::Temperature { changes: vec![change; cells.len()], cells, case }
}

fn heated(parts: Parts, change: [f64; 2]) -> StaticShell {
    let heat = everywhere(&parts.cloud, change, LoadCase::Loading);
    StaticShell::new(Shell::builder(parts).temperatures(vec![heat]).build().unwrap())
}

/// Three supports that hold no more than rigid motions of a plate in the plane z = 0.
fn determinate(cloud: &Cloud) -> Vec<Supported> {
    let sides = cloud.sides.as_ref().unwrap();
    let (left, right) = (sides.edge(Side::U0), sides.edge(Side::U1));
    let held = |a: u32, directions: &[Vec3]| {
        supported(vec![a], Held { displacement: directions.to_vec(), director: None })
    };
    vec![held(left[0], &[X, Y, Z]), held(right[0], &[Y, Z]), held(*left.last().unwrap(), &[Z])]
}

/// Edges of a plate that turn about themselves and do not move.
fn hinged(cloud: &Cloud, [a, b]: [f64; 2]) -> Vec<Supported> {
    let (ends, sides) = (
        common::at(cloud, |x| x.x.min(a - x.x) < 1e-9),
        common::at(cloud, |x| x.y.min(b - x.y) < 1e-9 && x.x.min(a - x.x) > 1e-9),
    );
    let held = |director| Held { displacement: vec![X, Y, Z], director: Some(director) };
    vec![supported(ends, held(Y)), supported(sides, held(X))]
}

fn loaded(system: &mut StaticShell, step: f64) -> Path {
    let options = PathOptions::new(Control::Load { step, until: 1.0 });
    let path = follow(system, &Start::default(), &options, |_, _| ControlFlow::Continue(()));
    assert_eq!(path.end, Ok(End::Reached), "{:?}", path.points.last());
    system.evaluate(1.0);
    path
}

fn results(shell: &Shell) -> Vec<PointResult> {
    let mut all = vec![PointResult::default(); shell.reference().operator.points.len()];
    shell.point_results(&mut all);
    all
}

/// Plies at a height on one side of a shell, heat of preload and loading on all of it and on a corner.
fn mixed(cloud: Cloud, parts: impl Fn(Cloud) -> Parts) -> Shell {
    let centre = |c: u32| cloud.cells[c as usize].geometry(&cloud.positions).centroid;
    let cells = |inside: &dyn Fn(Vec3) -> bool| -> Vec<u32> {
        (0..cloud.cells.len() as u32).filter(|&c| inside(centre(c))).collect()
    };
    let fibre =
        Orthotropic::new(3300.0, 600.0, 0.25, 660.0, 400.0).unwrap().expanding([-1e-3, 8e-3]).unwrap();
    let ply = |thickness, angle| Ply { material: fibre, thickness, angle };
    let laminate = Region {
        cells: cells(&|x| x.y < 0.9),
        section: Arc::new(LayeredSection::new(&[ply(0.05, 0.0), ply(0.08, 1.1), ply(0.07, -0.6)]).unwrap()),
        density: DENSITY,
        height: 0.15,
        axis: Some(X),
        strain: Some(&GreenLagrange),
    };
    let corner = cells(&|x| x.y < 1.2 && x.x > 0.0);
    let uneven = (0..corner.len()).map(|i| [-8.0 + i as f64, 3.0]).collect();
    let temperatures = vec![
        everywhere(&cloud, [10.0, -6.0], LoadCase::Loading),
        sph_shell::Temperature { cells: corner, changes: uneven, case: LoadCase::Loading },
        everywhere(&cloud, [-4.0, 2.0], LoadCase::Preload),
    ];
    Shell::builder(parts(cloud)).regions(vec![laminate]).temperatures(temperatures).build().unwrap()
}

#[test]
fn tangent_forces_and_level_rate_are_derivatives_of_the_energy() {
    for cloud in [curved([7, 6]), disordered_curved([7, 6]), scattered_curved(0.45)] {
        for strain in strain_measures() {
            let mut body = mixed(cloud.clone(), |cloud| Parts { strain, ..expanding(cloud, 0.2) });
            shake(&mut body, 0.05, 17);
            let mut system = StaticShell::new(body);
            for case in [LoadCase::Preload, LoadCase::Loading] {
                system.set_case(case);
                let (n, level) = (system.unknowns(), 0.7);
                derivatives_agree(&mut system, level, strain.name());
                let [mut rate, mut less, mut more] = [vec![0.0; n], vec![0.0; n], vec![0.0; n]];
                system.load_rate(level, &mut rate);
                // Linear in the level: one difference is exact.
                system.internal(level, &mut less);
                system.internal(level + 0.5, &mut more);
                let most = rate.iter().fold(0.0_f64, |m, r| m.max(r.abs()));
                for (i, (rate, (more, less))) in rate.iter().zip(more.iter().zip(&less)).enumerate() {
                    assert!((rate + (more - less) / 0.5).abs() < 1e-11 * most, "{i}: {rate}");
                }
            }
        }
    }
}

#[test]
fn a_rigid_motion_turns_the_forces_and_keeps_what_is_stored() {
    let mut body = mixed(disordered_curved([7, 6]), |cloud| expanding(cloud, 0.2));
    let forces = |body: &mut Shell| -> Vec<[f64; 6]> {
        body.evaluate_internal(false);
        (0..body.len()).map(|a| body.internal_force(a)).collect()
    };
    let (before, stored) = (forces(&mut body), energy(&mut body));
    let most = before.iter().flatten().fold(0.0_f64, |m, f| m.max(f.abs()));
    assert!(most > 1.0 && stored > 0.0, "{most} {stored}");
    let turn = Rotation3::from_scaled_axis(Vec3::new(1.1, -0.7, 0.9));
    for a in 0..body.len() {
        let (x, d) = (turn * body.position(a) + Vec3::new(2.0, -1.0, 3.0), turn * body.director(a));
        body.set_state(a, x, d);
    }
    for (f, g) in before.iter().zip(&forces(&mut body)) {
        for half in [0, 3] {
            let [f, g] = [f, g].map(|row| Vec3::new(row[half], row[half + 1], row[half + 2]));
            assert!((turn * f - g).norm() < 1e-12 * most, "{f} {g}");
        }
    }
    assert!((energy(&mut body) / stored - 1.0).abs() < 1e-12);
}

/// Free, a plate of any cells takes the strain αθ, and nothing is left of forces or stored.
#[test]
fn a_free_plate_expands_without_stress() {
    let change = 10.0;
    for cloud in [flat([9, 6], [2.0, 1.5]), disordered_flat([9, 6], [2.0, 1.5])] {
        let supports = determinate(&cloud);
        let mut system = heated(Parts { supports, ..expanding(cloud.clone(), 0.1) }, [change, 0.0]);
        loaded(&mut system, 0.5);
        let most = YOUNG * 0.1 * EXPANSION * change;
        for found in results(system.shell()) {
            let left = found.force.iter().chain(&found.moment).fold(0.0_f64, |m, n| m.max(n.abs()));
            assert!(left < 1e-9 * most, "{left}");
            assert!((found.membrane[0] / (EXPANSION * change) - 1.0).abs() < 1e-9, "{:?}", found.membrane);
        }
        let stored = energy(system.shell_mut());
        assert!(stored.abs() < 1e-9 * most * EXPANSION * change, "{stored}");
        // Lengths grow by √(1 + 2αθ).
        let corner = common::at(&cloud, |x| x.x > 2.0 - 1e-9 && x.y < 1e-9)[0] as usize;
        let grown = system.shell().position(corner).x / 2.0;
        assert!((grown / (1.0 + 2.0 * EXPANSION * change).sqrt() - 1.0).abs() < 1e-9, "{grown}");
    }
}

/// Free and slightly hotter on one face, a plate takes the curvature αθ/t in all directions, free of moments: exactly in the linear answer.
#[test]
fn a_free_plate_hotter_on_one_face_becomes_a_sphere() {
    let (thickness, difference) = (0.05, 1e-4);
    let cloud = flat([13, 9], [2.0, 1.5]);
    let parts = Parts { supports: determinate(&cloud), ..expanding(cloud, thickness) };
    let mut system = heated(parts, [0.0, difference]);
    let answer = linear_response(&mut system, 0.0).unwrap();
    system.update(&answer);
    system.evaluate(1.0);
    let exact = EXPANSION * difference / thickness;
    let bending = YOUNG * thickness.powi(3) / 12.0;
    let mut off = 0.0_f64;
    for found in results(system.shell()) {
        let [k11, k22, k12] = found.curvature.map(|k| k / exact);
        off = [k11 - 1.0, k22 - 1.0, k12].into_iter().fold(off, |m, x| m.max(x.abs()));
        off = found.moment.iter().fold(off, |m, x| m.max(x.abs() / (bending * exact)));
    }
    println!("off by {off:.1e}");
    assert!(off < 1e-6, "{off}");
}

/// Clamped all round, a plate stands still and bears N = −E t α θ/(1 − ν), and stores what that costs, by every way of finding balance.
#[test]
fn a_clamped_plate_stands_still_under_its_forces() {
    let (thickness, change) = (0.1, [5.0, 2.0]);
    for cloud in [flat([6, 5], [2.0, 1.5]), scattered_flat(0.3, [2.0, 1.5])] {
        let rim = common::at(&cloud, |x| x.x.min(2.0 - x.x).min(x.y).min(1.5 - x.y) < 1e-9);
        let parts = || Parts {
            supports: vec![supported(rim.clone(), Clamped)],
            ..expanding(cloud.clone(), thickness)
        };
        let force = YOUNG * thickness * EXPANSION * change[0] / (1.0 - POISSON);
        let moment = YOUNG * thickness.powi(2) / 12.0 * EXPANSION * change[1] / (1.0 - POISSON);
        let slope = EXPANSION * change[1] / thickness;
        let stored = 3.0 * (force * EXPANSION * change[0] + moment * slope);
        let bears = |system: &mut StaticShell, what: &str| {
            for found in results(system.shell()) {
                let off = |is: [f64; 3], should: f64| {
                    ((is[0] / should - 1.0).abs())
                        .max((is[1] / should - 1.0).abs())
                        .max((is[2] / should).abs())
                };
                assert!(off(found.force, -force) < 1e-12, "{what}: {:?}", found.force);
                assert!(off(found.moment, -moment) < 1e-12, "{what}: {:?}", found.moment);
            }
            let found = energy(system.shell_mut());
            assert!((found / stored - 1.0).abs() < 1e-12, "{what}: {found} {stored}");
            let moved = (0..system.shell().len()).map(|a| system.shell().displacement(a).norm());
            assert!(moved.fold(0.0, f64::max) < 1e-12, "{what}");
        };
        let mut system = heated(parts(), change);
        let path = loaded(&mut system, 0.25);
        assert_eq!(path.points.iter().map(|point| point.converged.iterations).max(), Some(0));
        bears(&mut system, "Newton's method");
        let mut system = heated(parts(), change);
        let options = PathOptions::new(Control::ArcLength { first: 0.3, range: (-1.0, 1.0) });
        let path = follow(&mut system, &Start::default(), &options, |_, _| ControlFlow::Continue(()));
        assert_eq!(path.end, Ok(End::Reached));
        system.evaluate(1.0);
        bears(&mut system, "arc length");
        let mut system = heated(parts(), change);
        relax(&mut system, &RelaxationOptions::default(), (0.0, 1.0), |_| ControlFlow::Continue(())).unwrap();
        system.evaluate(1.0);
        bears(&mut system, "relaxation");
    }
}

/// `α θ = π² t²/(6 (1 + ν) a²)` of a square plate that its hinged edges hold in its plane \[timoshenko1961\]; the tangent along the path turns there as well.
#[test]
fn a_held_plate_buckles_as_it_is_heated() {
    let (side, thickness, cells) = (10.0, 0.1, 40);
    let cloud = flat([cells + 1, cells + 1], [side, side]);
    let exact = PI.powi(2) * thickness * thickness / (6.0 * (1.0 + POISSON) * side * side) / EXPANSION;
    let plate = |change: f64| {
        let supports = hinged(&cloud, [side, side]);
        heated(Parts { supports, ..expanding(cloud.clone(), thickness) }, [change, 0.0])
    };
    for prebuckling in [Prebuckling::Rotations, Prebuckling::Stress] {
        let options = BucklingOptions { prebuckling, ..BucklingOptions::new(1) };
        let found = linear_buckling(&mut plate(1.0), 0.0, &options, &mut unwatched).unwrap().modes[0].level;
        println!("{prebuckling:?}: {:.4} %", 100.0 * (found / exact - 1.0));
        // .025 % of one curvature and one gradient a cell.
        assert!((found / exact - 1.0).abs() < 8e-4, "{found} {exact}");
    }
    let critical = Some(CriticalOptions::default());
    let options = PathOptions { critical, ..PathOptions::new(Control::Load { step: 0.5, until: 1.0 }) };
    let path = follow(&mut plate(1.2 * exact), &Start::default(), &options, |_, _| ControlFlow::Continue(()));
    let critical: Vec<f64> = path.critical.iter().map(|point| 1.2 * point.level).collect();
    println!("on the path: {critical:?}");
    assert!(critical.len() == 1 && (critical[0] - 1.0).abs() < 8e-4, "{critical:?}");
}

/// Warmed first, a held plate sings lower: `ρ t ω² = D k⁴ − N k²`.
#[test]
fn a_heated_plate_sings_lower() {
    let (sides, thickness) = ([10.0, 8.0], 0.1_f64);
    let cloud = flat([41, 33], sides);
    let stiffness = YOUNG * thickness.powi(3) / (12.0 * (1.0 - POISSON * POISSON));
    let k = (PI / sides[0]).powi(2) + (PI / sides[1]).powi(2);
    let critical = stiffness * k * (1.0 - POISSON) / (YOUNG * thickness * EXPANSION);
    for part in [-1.0, 0.5, 0.9] {
        let parts = Parts { supports: hinged(&cloud, sides), ..expanding(cloud.clone(), thickness) };
        let heat = everywhere(&cloud, [part * critical, 0.0], LoadCase::Preload);
        let mut system = StaticShell::new(Shell::builder(parts).temperatures(vec![heat]).build().unwrap());
        assert!(system.has_preload());
        let mode = natural_modes(&mut system, 0.0, 1, 0.0, &mut unwatched).unwrap().modes[0].eigenvalue;
        let exact = stiffness * k * k * (1.0 - part) / (DENSITY * thickness);
        println!("{part}: {:.3} %", 100.0 * (mode / exact - 1.0));
        // .26 % with 40 cells, of the load a tenth of it; what is left of the stiffness makes it the more.
        assert!((mode / exact - 1.0).abs() < 8e-3 / (1.0 - part).min(1.0), "{mode} {exact}");
    }
}

/// A panel between clamped edges that bulges: relaxation finds the balance that Newton's method finds.
#[test]
fn relaxation_finds_what_newton_finds() {
    let panel = || {
        let cloud = curved([9, 7]);
        let sides = cloud.sides.as_ref().unwrap();
        let rim = [Side::U0, Side::U1].map(|side| supported(sides.edge(side).to_vec(), Clamped));
        heated(Parts { supports: rim.into(), ..expanding(cloud, 0.1) }, [10.0, 5.0])
    };
    let (mut exact, mut system) = (panel(), panel());
    loaded(&mut exact, 0.25);
    let (exact, rest) = (exact.save(), system.save());
    let way = exact.iter().zip(&rest).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    let mut relaxation = implicit_statics::Relaxation::new(&RelaxationOptions::default()).unwrap();
    for levels in [(0.0, 0.5), (0.5, 1.0)] {
        let found = relaxation.to_level(&mut system, levels, |_| ControlFlow::Continue(())).unwrap();
        assert!(!found.release.snapped(), "{:?}", found.release);
    }
    let off = system.save().iter().zip(&exact).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs())) / way;
    println!("way {way}, off by {off:.1e}");
    assert!(way > 0.03 && off < 1e-4, "{way} {off}");
}

#[test]
fn what_makes_no_sense_is_refused() {
    let cloud = || flat([5, 4], [1.0, 1.0]);
    let heat = |cells: Vec<u32>, changes| sph_shell::Temperature { cells, changes, case: LoadCase::Loading };
    let with = |parts: Parts, heat| Shell::builder(parts).temperatures(vec![heat]).build().map(drop);
    let own = || expanding(cloud(), 0.1);
    assert!(matches!(with(own(), heat(vec![], vec![])), Err(ShellError::EmptySet(_))));
    let beyond = with(own(), heat(vec![12], vec![[1.0; 2]]));
    assert!(matches!(beyond, Err(ShellError::NoSuchCell { cell: 12, .. })));
    let few = with(own(), heat(vec![1, 2], vec![[1.0; 2]]));
    assert!(matches!(few, Err(ShellError::Heat(HeatError::Changes { number: 0 }))));
    let infinite = with(own(), heat(vec![1], vec![[f64::INFINITY, 0.0]]));
    assert!(matches!(infinite, Err(ShellError::Heat(HeatError::Changes { number: 0 }))));
    let none = with(parts(cloud(), CELL, 0.1), heat(vec![3], vec![[1.0; 2]]));
    assert!(matches!(none, Err(ShellError::Heat(HeatError::NoExpansion { number: 0, cell: 3 }))));
    let plies = Parts { section: Box::new(unsymmetric(0.0)), material_axis: Some(AXIS), ..own() };
    let none = with(plies, heat(vec![3], vec![[1.0; 2]]));
    assert!(matches!(none, Err(ShellError::Heat(HeatError::NoExpansion { .. }))));
    let wide = Parts { formulation: common::energy_formulations()[1].1, ..own() };
    let wide = with(wide, heat(vec![1], vec![[1.0; 2]]));
    assert!(matches!(wide, Err(ShellError::Heat(HeatError::WideStencils))));
    assert!(Isotropic::new(1.0, 0.3).unwrap().expanding(f64::NAN).is_err());
}
