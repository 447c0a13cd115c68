//! Rigid sets that supports move and turn: as the same particles one by one, torsion, inverse of forces and couples, rates along the level, marches.

use std::f64::consts::PI;
use std::ops::ControlFlow;

use crate::common::{RandomNumbers, X, Y, Z, curved, flat, parts, records, supported};
use explicit_dynamics::{Amplitude, Clock, Dynamics, Transient};
use implicit_statics::{
    Control, End, Equilibrium, Newton, NewtonOptions, PathOptions, Start, follow, linear_response,
    load_rate_error,
};
use nalgebra::Matrix3;
use shell_kinematics::{Isotropic, IsotropicSection};
use sph_core::{Cloud, Side, Vec3};
use sph_shell::{
    AppliedLoad, Clamped, DirectorHold, Formulation, Holds, LoadCase, Moved, Parts, Preloaded, Reach,
    RigidLoad, RigidSet, Rotated, Shell, ShellError, StaticShell, Support, Turned,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
const YOUNG: f64 = 1200.0;

/// What is asked, as a support of its own.
#[derive(Clone)]
struct Asked(Holds);

impl Support for Asked {
    fn holds(&self) -> Holds {
        self.0.clone()
    }
}

fn moved(direction: Vec3, by: f64, amplitude: Amplitude) -> Holds {
    Moved { direction, by, amplitude }.holds()
}

fn turned(axis: Vec3, point: Vec3, by: f64, amplitude: Amplitude) -> Holds {
    Turned { axis, point, by, amplitude }.holds()
}

/// Displacements along some directions and rotations.
fn held(displacement: &[Vec3], director: DirectorHold) -> Holds {
    Holds { translations: displacement.to_vec(), director, ..Holds::default() }
}

fn built(cloud: Cloud, patch: Vec<u32>, asked: &[Holds], body: Option<RigidSet>, thick: f64) -> Shell {
    loaded(cloud, patch, asked, body, thick, None)
}

/// A shell clamped along one edge with a patch, or its far edge, rigid or held particle by particle, and a load on the body.
fn loaded(
    cloud: Cloud,
    patch: Vec<u32>,
    asked: &[Holds],
    body: Option<RigidSet>,
    thick: f64,
    load: Option<RigidLoad>,
) -> Shell {
    let sides = cloud.sides.clone().unwrap();
    let mut supports = vec![supported(sides.edge(Side::U0).to_vec(), Clamped)];
    if body.is_none() {
        let each = asked.iter().map(|holds| supported(patch.clone(), Asked(holds.clone())));
        supports.extend(each);
    }
    let section = IsotropicSection::new(Isotropic::new(YOUNG, 0.3).unwrap(), thick).unwrap();
    let applied = |load| AppliedLoad { load: Box::new(load), amplitude: Amplitude::Constant };
    let loads = load.into_iter().map(applied).collect();
    let parts = Parts { section: Box::new(section), supports, loads, ..parts(cloud, CELL, thick) };
    let rigid = body.map(|set| RigidSet { particles: patch, holds: asked.to_vec(), ..set });
    Shell::builder(parts).rigid(rigid.into_iter().collect()).build().unwrap()
}

fn patch() -> Vec<u32> {
    [4, 5, 6].into_iter().flat_map(|i| [2, 3, 4].map(|j| 7 * i + j)).collect()
}

fn solved(shell: Shell, step: f64) -> StaticShell {
    let mut system = StaticShell::new(shell);
    let control = Control::Load { step, until: 1.0 };
    let options = PathOptions {
        newton: NewtonOptions { tolerance: 1e-11, line_search: false, ..NewtonOptions::default() },
        ..PathOptions::new(control)
    };
    let path = follow(&mut system, &Start::default(), &options, |_, _| ControlFlow::Continue(()));
    assert_eq!(path.end, Ok(End::Reached), "{:?}", path.points.last());
    system.evaluate(1.0);
    system
}

/// Force on a set and moment about a point.
fn borne(shell: &Shell, on: &[u32], about: Vec3) -> [Vec3; 2] {
    on.iter().map(|&a| a as usize).fold([Vec3::zeros(); 2], |[f, m], a| {
        let force = shell.reaction(a);
        [f + force, m + (shell.position(a) - about).cross(&force) + shell.reaction_moment(a)]
    })
}

/// The reference point stands beside the patch: what is prescribed is the same.
#[test]
fn a_body_that_is_moved_is_the_set_held_particle_by_particle() {
    let beside = RigidSet { at: Vec3::new(1.3, 0.1, 0.4), mass: 2.0, ..RigidSet::default() };
    let axis = Vec3::new(0.3, 1.0, -0.2);
    let course = Amplitude::Constant;
    let cases: Vec<(&str, Vec<Holds>)> = vec![
        ("pushed", vec![moved(Z, 0.15, course.clone()), held(&[X, Y], DirectorHold::Fixed)]),
        ("turned", vec![turned(axis, Vec3::new(0.9, 0.5, 0.3), 0.35, course.clone())]),
        (
            "turned and pulled",
            vec![turned(Y, Vec3::new(0.9, 0.5, 0.0), 0.3, course.clone()), moved(Y, 0.02, course.clone())],
        ),
    ];
    for (name, asked) in cases {
        let plate = || flat([11, 7], [1.5, 1.0]);
        let body = solved(built(plate(), patch(), &asked, Some(beside.clone()), 0.05), 0.25);
        let each = solved(built(plate(), patch(), &asked, None, 0.05), 0.25);
        let (body, each) = (body.shell(), each.shell());
        let apart = (0..body.len()).map(|a| (body.position(a) - each.position(a)).norm()).fold(0.0, f64::max);
        let about = Vec3::new(0.2, -0.4, 1.0);
        let (found, wanted) = (borne(body, &patch(), about), borne(each, &patch(), about));
        let lack = (0..2).map(|i| (found[i] - wanted[i]).norm() / wanted[i].norm()).fold(0.0, f64::max);
        let energy = body.stored_energy() / each.stored_energy() - 1.0;
        let whole = body.support_resultant(about);
        let balance = (whole.force.norm() + whole.moment.norm()) / wanted[0].norm();
        println!(
            "{name}: apart {apart:.1e}, reactions {lack:.1e}, energy {energy:.1e}, balance {balance:.1e}"
        );
        // Round-off of places, and of forces whose parts are some hundred times as large.
        assert!(apart < 2e-15 && lack < 1e-13 && energy.abs() < 2e-14, "{name}");
        assert!(balance < 4e-13, "{name}");
    }
}

/// Angle over torque of two lengths differ by ΔL/GJ, `J = b t³/3 (1 − 0.63 t/b)`, as with the edge turned particle by particle.
#[test]
fn a_strip_with_a_rigid_end_is_twisted_as_st_venant_says() {
    let (thick, angle) = (0.05, 1e-3);
    let rigidity = YOUNG / 2.6 * thick * thick * thick / 3.0 * (1.0 - 0.63 * thick);
    let centre = Vec3::new(0.0, 0.5, 0.0);
    let soft = |length: f64, across: usize, rigid: bool| {
        let cloud = flat([length as usize * across + 1, across + 1], [length, 1.0]);
        let end = cloud.sides.as_ref().unwrap().edge(Side::U1).to_vec();
        let body = rigid.then(|| RigidSet { at: Vec3::new(length, 0.2, 0.7), ..RigidSet::default() });
        let asked = [turned(X, centre, angle, Amplitude::Constant)];
        let system = solved(built(cloud, end.clone(), &asked, body, thick), 1.0);
        angle / borne(system.shell(), &end, centre)[1].x
    };
    for (across, bound) in [(8, 1.6e-2), (16, 1.2e-2)] {
        let [long, short] = [8.0, 4.0].map(|length| soft(length, across, true));
        let error = (long - short) * rigidity / 4.0 - 1.0;
        let each = soft(4.0, across, false) / short - 1.0;
        println!("{across} cells across: {error:.2e}, against single particles {each:.1e}");
        // Of the lattice, which does not resolve the layer of width t at the free edges; rounding of two solves, 1.1e-13.
        assert!(error.abs() < bound && each.abs() < 4e-13, "{error} {each}");
    }
}

/// A force on a body and the displacement that it brings about, a couple and the rotation: prescribed, the other is found.
#[test]
fn motions_are_the_inverse_of_forces() {
    let plate = || flat([11, 7], [1.5, 1.0]);
    let at = plate().positions[patch()[0] as usize];
    let solve = |asked: &[Holds], load: Option<RigidLoad>| {
        let set = RigidSet { at, ..RigidSet::default() };
        let system = loaded(plate(), patch(), asked, Some(set), 0.05, load);
        solved(system, 0.25)
    };
    let first = patch()[0] as usize;
    let force = RigidLoad { set: 0, force: Z * 0.02, couple: Vec3::zeros() };
    let pushed = solve(&[], Some(force));
    let way = pushed.shell().displacement(first).z;
    // Along z alone, beside the centre of the patch: the body turns and slides as it did.
    let moved = solve(&[moved(Z, way, Amplitude::Constant)], None);
    let found = borne(moved.shell(), &patch(), at + Z * way);
    let apart = |a: &StaticShell, b: &StaticShell| {
        let of = |i: usize| (a.shell().position(i) - b.shell().position(i)).norm();
        (0..a.shell().len()).map(of).fold(0.0, f64::max)
    };
    let errors = [
        found[0].z / 0.02 - 1.0,
        moved.shell().stored_energy() / pushed.shell().stored_energy() - 1.0,
        apart(&moved, &pushed),
    ];
    println!("way {way}: {errors:?}, beside {:?}", found);
    assert!(way > 0.1 && errors.iter().all(|e| e.abs() < 1e-8), "{errors:?}");

    let hinge = held(&[X, Y, Z], DirectorHold::InPlane(Y));
    let couple = RigidLoad { set: 0, force: Vec3::zeros(), couple: Y * 0.02 };
    let turned_by = solve(std::slice::from_ref(&hinge), Some(couple));
    let d = turned_by.shell().director(first);
    let angle = libm::atan2(d.x, d.z);
    let turned = solve(&[turned(Y, at, angle, Amplitude::Constant)], None);
    let found = borne(turned.shell(), &patch(), at)[1].y;
    let errors = [found / 0.02 - 1.0, apart(&turned, &turned_by)];
    println!("angle {angle}: {errors:?}");
    assert!(angle > 0.1 && errors.iter().all(|e| e.abs() < 1e-8), "{errors:?}");
}

/// At a state far from rest, the body moved along one direction beside its centre, or turned with one direction held.
#[test]
fn rates_along_the_level_are_derivatives() {
    let slide = vec![moved(Vec3::new(0.3, -0.2, 1.0), 0.3, Amplitude::Constant)];
    let turn = vec![
        Rotated { axis: Vec3::new(0.2, 1.0, 0.3), by: 0.4, amplitude: Amplitude::Constant }.holds(),
        held(&[Z], DirectorHold::Free),
    ];
    let both = vec![turned(Y, Vec3::new(0.3, 0.1, -0.4), 0.5, Amplitude::Constant)];
    for (name, asked) in [("slide", slide), ("turn", turn), ("both", both)] {
        let particles: Vec<u32> = [2, 3, 4].into_iter().flat_map(|i| [1, 2, 3].map(|j| 6 * i + j)).collect();
        let set = RigidSet { at: Vec3::new(0.4, 1.5, 0.9), mass: 1.0, ..RigidSet::default() };
        let push = RigidLoad { set: 0, force: Vec3::new(3.0, -5.0, 2.0), couple: Vec3::zeros() };
        let mut system =
            StaticShell::new(loaded(curved([7, 6]), particles, &asked, Some(set), 0.2, Some(push)));
        let n = system.unknowns();
        let mut dice = RandomNumbers(5);
        let step: Vec<f64> = (0..n).map(|_| 0.1 * dice.roll()).collect();
        system.update(&step);
        let worst = load_rate_error(&mut system, 0.7, 1e-3);
        println!("{name}: {worst:.1e}");
        // Truncation h⁴ and the round-off of forces over h.
        assert!(worst < 2e-11, "{name}: {worst:.1e}");
        assert!(linear_response(&mut system, 0.0).is_ok());
    }
}

/// A heavy body beside its patch, turned about an axis beside both.
fn swung(amplitude: Amplitude) -> Shell {
    let set = RigidSet {
        at: Vec3::new(1.2, 0.6, 0.3),
        mass: 0.5,
        inertia: Matrix3::from_diagonal(&Vec3::new(0.02, 0.05, 0.03)),
        ..RigidSet::default()
    };
    let turn = turned(Vec3::new(0.2, 1.0, 0.1), Vec3::new(0.4, 0.5, 0.1), 0.3, amplitude);
    built(flat([11, 7], [1.5, 1.0]), patch(), &[turn], Some(set), 0.05)
}

/// The same body pushed along one direction at a point beside its centre; it turns and slides as it will.
fn shoved(amplitude: Amplitude) -> Shell {
    let set = RigidSet {
        at: Vec3::new(1.2, 0.6, 0.3),
        mass: 0.5,
        inertia: Matrix3::from_diagonal(&Vec3::new(0.02, 0.05, 0.03)),
        ..RigidSet::default()
    };
    // The mass stands at the reference point, the patch of .1 apart from it: the centre of mass is neither.
    built(flat([11, 7], [1.5, 1.0]), patch(), &[moved(Z, 0.2, amplitude)], Some(set), 0.05)
}

#[test]
fn the_energy_of_a_march_balances_with_the_work_of_what_is_prescribed() {
    for (name, make) in [("swung", swung as fn(Amplitude) -> Shell), ("shoved", shoved)] {
        let error = |safety: f64| {
            let mut body = make(Amplitude::Smooth(2.0));
            let run = Transient { duration: 3.0, record_every: 0.05, damping: 0.0, safety };
            let records = records(run, &mut body).unwrap();
            let most = records.iter().map(|r| r.energy.external).fold(0.0, f64::max);
            let worst = records.iter().map(|r| r.balance_error.abs()).fold(0.0, f64::max);
            assert!(most > 1e-4, "{most}");
            worst / most
        };
        let errors = [0.8, 0.4, 0.2].map(error);
        println!("{name}: {errors:?}");
        assert!(errors[0] < 4e-5 && errors[1] < errors[0] / 3.0 && errors[2] < errors[1] / 3.0, "{errors:?}");
    }
}

#[test]
fn a_damped_march_comes_to_rest_where_newton_does() {
    for (name, make) in [("swung", swung as fn(Amplitude) -> Shell), ("shoved", shoved)] {
        let still = solved(make(Amplitude::Constant), 0.25);
        let mut body = make(Amplitude::Smooth(3.0));
        let mut clock = Clock::start(&mut body, 1.0, 0.8, 0.8).unwrap();
        while clock.now.time < 80.0 {
            clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
        }
        let stored = body.evaluate(clock.now);
        let apart = (0..body.len())
            .map(|a| (body.position(a) - still.shell().position(a)).norm())
            .fold(0.0, f64::max);
        let about = Vec3::zeros();
        let (found, wanted) = (borne(&body, &patch(), about), borne(still.shell(), &patch(), about));
        let lack = (0..2).map(|i| (found[i] - wanted[i]).norm() / wanted[i].norm()).fold(0.0, f64::max);
        let energy = stored / still.shell().stored_energy() - 1.0;
        println!("{name}: apart {apart:.1e}, reactions {lack:.1e}, energy {energy:.1e}");
        assert!(apart < 5e-14 && lack < 5e-11 && energy.abs() < 4e-14, "{name}");
    }
}

/// Moved before, turned then: where both at once lead.
#[test]
fn a_preload_moves_a_body_before_the_rest() {
    let (pull, turn) = (0.02, 0.3);
    let point = Vec3::new(0.9, 0.5, 0.0);
    let course = Amplitude::Constant;
    let set = || Some(RigidSet { at: Vec3::new(1.3, 0.1, 0.4), ..RigidSet::default() });
    let plate = || flat([11, 7], [1.5, 1.0]);
    let once = [turned(Y, point, turn, course.clone()), moved(Y, pull, course.clone())];
    let once = solved(built(plate(), patch(), &once, set(), 0.05), 0.25);
    let first: Box<dyn Support> = Box::new(Asked(moved(Y, pull, course.clone())));
    let apart = [turned(Y, point, turn, course), Preloaded(first).holds()];
    let mut system = StaticShell::new(built(plate(), patch(), &apart, set(), 0.05));
    assert!(system.has_preload());
    let options = NewtonOptions { tolerance: 1e-11, line_search: false, ..NewtonOptions::default() };
    let mut newton = Newton::new(&system, &options).unwrap();
    system.set_case(LoadCase::Preload);
    newton.at_level(&mut system, 1.0).unwrap();
    let first = patch()[0] as usize;
    assert!((system.shell().displacement(first) - Y * pull).norm() < 1e-14);
    system.set_case(LoadCase::Loading);
    for level in [0.25, 0.5, 0.75, 1.0] {
        newton.at_level(&mut system, level).unwrap();
    }
    let worst = (0..system.shell().len())
        .map(|a| (system.shell().position(a) - once.shell().position(a)).norm())
        .fold(0.0, f64::max);
    println!("apart {worst:.1e}");
    assert!(worst < 2e-14, "{worst:.1e}");
}

#[test]
fn supports_of_a_body_that_oppose_each_other_are_refused() {
    let course = Amplitude::Constant;
    let refused = |asked: &[Holds]| {
        let set = RigidSet { particles: patch(), holds: asked.to_vec(), ..RigidSet::default() };
        Shell::builder(parts(flat([11, 7], [1.5, 1.0]), CELL, 0.05)).rigid(vec![set]).build().err().unwrap()
    };
    let ramp = Amplitude::Ramp(PI);
    for (asked, says) in [
        (vec![moved(Z, 0.1, course.clone()), Clamped.holds()], "another holds"),
        (vec![turned(X, Vec3::zeros(), 0.1, course.clone()), held(&[], DirectorHold::Fixed)], "rotation"),
        (vec![moved(Z, 0.1, course), moved(X, 0.1, ramp)], "courses of their own"),
    ] {
        let fault = refused(&asked);
        assert!(matches!(fault, ShellError::RigidOpposed { set: 0, .. }), "{fault}");
        assert!(fault.to_string().contains(says), "{fault}");
    }
}
