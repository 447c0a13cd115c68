//! A shell that touches itself: derivatives, a ring under pressure in closed form, momentum and energy, the same bits, no crossing.

use std::ops::ControlFlow;

use crate::audit::crossings;
use crate::common::{DENSITY, POISSON, YOUNG, beam_parts, momenta, parts, shake, supported};
use contact::{Law, stiffness};
use explicit_dynamics::{Amplitude, Event, March, Transient};
use implicit_statics::{Control, End, Equilibrium, Newton, PathOptions, Start, follow, stiffness_error};
use sph_core::{Cylinder, EndWeights, Side, Vec3, lattice};
use sph_shell::{Force, Formulation, Load, OwnContact, Pressure, Reach, Shell, StaticShell, SymmetryPlane};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

fn touching(thickness: f64, spacing: f64, law: Law, edges: bool) -> OwnContact {
    OwnContact { law, stiffness: 0.5 * stiffness(YOUNG, thickness, spacing), edges, friction: 0.0 }
}

/// A tube, open along its length, pressed flat until its walls are in each other by a fifth of the thickness.
fn flat_tube() -> Shell {
    let shape = Cylinder { radius: 1.0, angles: [0.2, 6.0], length: 0.6 };
    let cloud = lattice(&shape, [31, 5], EndWeights::Trapezoid).unwrap();
    let (thickness, rest) = (0.15, cloud.positions.clone());
    let own = touching(thickness, 0.19, Law::SHARP, false);
    let mut shell = Shell::builder(parts(cloud, CELL, thickness)).touching_itself(own).build().unwrap();
    for (a, x) in rest.iter().enumerate() {
        let d = shell.director(a);
        // Shifted along the axis, so that no vertex faces another.
        let y = x.y + 0.03 * x.z;
        shell.set_state(a, Vec3::new(x.x, y, 0.06 * x.z), Vec3::new(d.x, d.y, d.z * 3.0));
    }
    shell
}

/// Differences over 2e-6: 1e-9 measured.
#[test]
fn the_tangent_of_a_shell_in_itself_is_a_derivative() {
    let mut shell = flat_tube();
    shake(&mut shell, 0.004, 5);
    let mut system = StaticShell::new(shell);
    let way: Vec<f64> = (0..system.unknowns()).map(|i| libm::sin(1.0 + 3.7 * i as f64)).collect();
    let error = stiffness_error(&mut system, 1.0, &way, 2e-6);
    system.evaluate(1.0);
    let touch = *system.shell().own_touch().unwrap();
    println!("{error:.1e} {touch:?}");
    assert!(touch.greatest_depth > 0.1 && touch.greatest_depth < 0.95 && touch.area > 0.3, "{touch:?}");
    assert!(error < 1e-8, "{error:.1e}");
}

/// Half of a ring of radius one and width .1 under pressure, from its crown to its foot; two forces pinch it a little, which both grow with the level.
fn ring(cells: usize, thickness: f64, pressure: f64, pinch: f64) -> Shell {
    let shape = Cylinder { radius: 1.0, angles: [0.0, std::f64::consts::PI], length: 0.1 };
    let cloud = lattice(&shape, [cells + 1, 3], EndWeights::Trapezoid).unwrap();
    let sides = cloud.sides.clone().unwrap();
    let [crown, foot] = [Side::U0, Side::U1].map(|side| sides.edge(side).to_vec());
    let middle: Vec<u32> =
        (0..cloud.len() as u32).filter(|&a| cloud.positions[a as usize].z.abs() < 1e-9).collect();
    assert_eq!(middle.len(), 3);
    let plane = |of: Vec<u32>, normal| supported(of, SymmetryPlane { normal });
    let supports = vec![
        plane(crown.clone(), Vec3::x()),
        plane(foot.clone(), Vec3::x()),
        plane(middle, Vec3::z()),
        plane(sides.edge(Side::V0).to_vec(), Vec3::y()),
    ];
    let bending = YOUNG * thickness.powi(3) / 12.0;
    let force = |particles: Vec<u32>, sign: f64| -> Box<dyn Load> {
        let shares = particles.into_iter().zip([1.0, 2.0, 1.0]).collect();
        Box::new(Force { shares, total: Vec3::z() * (0.05 * pinch * bending * sign) })
    };
    let loads: Vec<Box<dyn Load>> = vec![
        Box::new(Pressure { value: -pressure * bending, follower: true }),
        force(crown, -1.0),
        force(foot, 1.0),
    ];
    let own = touching(thickness, std::f64::consts::PI / cells as f64, Law::SHARP, false);
    Shell::builder(beam_parts(cloud, thickness, supports, loads)).touching_itself(own).build().unwrap()
}

/// Pressures p R³/B, half openings b/R before it touches, and forces F R²/B after, of the elastica with walls of t = .05 R.
const FREE: [[f64; 2]; 3] = [[4.0, 0.29133701], [4.5, 0.150464051], [5.0, 0.0439592193]];
const TOUCHES: [[f64; 2]; 3] = [[5.5, 0.617768873], [6.0, 1.39763462], [7.0, 2.96140343]];

/// Measured with 40 and 80 cells: b is at most .0030 and .0019 R off, F at most .030 and .008 B/R².
#[test]
fn a_ring_under_pressure_touches_itself_as_the_elastica_does() {
    let (thickness, pinch): (f64, f64) = (0.05, 0.01);
    let bending = YOUNG * thickness.powi(3) / 12.0;
    for (cells, bounds) in [(40, [0.009, 0.09]), (80, [0.0057, 0.024])] {
        let mut system = StaticShell::new(ring(cells, thickness, 7.0, pinch));
        let mut options = PathOptions::new(Control::Load { step: 0.05, until: 1.0 });
        options.newton.line_search = true;
        let mut found = Vec::new();
        let path = follow(&mut system, &Start::default(), &options, |point, system| {
            let shell = system.shell();
            let upper = (0..shell.len()).filter(|&a| shell.rest_position(a).z > 0.0);
            let force: f64 = upper.map(|a| shell.contact_force(a).z).sum();
            // A half ring bears half of the force on its width, and the pinch beside.
            let force = force * 2.0 / 0.1 / bending - pinch * point.level();
            found.push([7.0 * point.level(), shell.position(0).z, force]);
            ControlFlow::Continue(())
        });
        assert_eq!(path.end, Ok(End::Reached));
        let at = |pressure: f64, column: usize| {
            let after = found.iter().position(|row| row[0] >= pressure - 1e-9).unwrap();
            let [a, b] = [found[after - 1], found[after]];
            a[column] + (b[column] - a[column]) * (pressure - a[0]) / (b[0] - a[0])
        };
        for ([pressure, exact], (column, bound)) in
            FREE.map(|row| (row, (1, bounds[0]))).into_iter().chain(TOUCHES.map(|row| (row, (2, bounds[1]))))
        {
            let error = at(pressure, column) - exact;
            println!("{cells} cells, p {pressure}: {:.5}, off by {error:+.5}", at(pressure, column));
            assert!(error.abs() < bound, "{cells} cells, p {pressure}: {error:+.5}");
        }
        assert_eq!(crossings(system.shell()), 0);
    }
}

/// One level from walls apart to walls that press: Newton's method may give up, where a path shortens its step, but leaps through nothing.
#[test]
fn a_long_step_does_not_leap_through() {
    for until in [5.5, 7.0] {
        let mut system = StaticShell::new(ring(40, 0.05, until, 0.02));
        let mut options = PathOptions::new(Control::Load { step: 0.02, until: 5.0 / until });
        options.newton.line_search = true;
        let path = follow(&mut system, &Start::default(), &options, |_, _| ControlFlow::Continue(()));
        assert_eq!(path.end, Ok(End::Reached));
        let mut newton = Newton::new(&system, &options.newton).unwrap();
        let converged = newton.at_level(&mut system, 1.0).map(|found| found.iterations);
        let shell = system.shell();
        println!("p {until}: {converged:?}");
        assert!(
            shell.position(0).z > 0.02 && crossings(shell) == 0,
            "{} {}",
            shell.position(0),
            crossings(shell)
        );
    }
}

fn sound() -> f64 {
    (YOUNG / (DENSITY * (1.0 - POISSON * POISSON))).sqrt()
}

/// What a march of a shell against itself did.
#[derive(Debug, PartialEq)]
struct Course {
    /// Greatest error of the energy over what it had at the start.
    energy: f64,
    /// Greatest change of momentum and of angular momentum over their sizes by particle.
    momentum: [f64; 2],
    crossings: usize,
    depth: f64,
    steps: u64,
    last: Vec<[f64; 6]>,
}

fn course(shell: &mut Shell, duration: f64) -> Course {
    let run = Transient { duration, record_every: 0.02 * duration, damping: 0.0, safety: 0.8 };
    let (first, sizes) = momenta(shell);
    let mut march = March::start(run, shell).unwrap();
    let (mut energy, mut most, mut crossed, mut depth): (f64, [f64; 2], usize, f64) = (0.0, [0.0; 2], 0, 0.0);
    let mut start = None;
    loop {
        match march.advance(shell).unwrap() {
            Event::Record(record) => {
                let whole = *start.get_or_insert(record.energy.kinetic + record.energy.internal);
                energy = energy.max(record.balance_error.abs() / whole);
                let (now, _) = momenta(shell);
                for i in 0..2 {
                    most[i] = most[i].max((now[i] - first[i]).norm() / sizes[i]);
                }
                crossed += crossings(shell);
                depth = depth.max(shell.own_touch().unwrap().greatest_depth);
            }
            Event::End => break,
            _ => {}
        }
    }
    let last = shell.motion()[0].to_vec();
    Course { energy, momentum: most, crossings: crossed, depth, steps: march.clock().steps, last }
}

/// A tube, open along its length, whose walls are thrown at each other at a speed over that of sound.
fn thrown(counts: [usize; 2], thickness: f64, speed: f64, threads: usize) -> Shell {
    let shape = Cylinder { radius: 1.0, angles: [0.2, 6.1], length: 1.0 };
    let cloud = lattice(&shape, counts, EndWeights::Trapezoid).unwrap();
    let (spacing, rest) = (cloud.spacing(), cloud.positions.clone());
    let own = touching(thickness, spacing, Law::new(0.05).unwrap(), true);
    let builder = Shell::builder(sph_shell::Parts { threads, ..parts(cloud, CELL, thickness) });
    let mut shell = builder.touching_itself(own).build().unwrap();
    for (a, x) in rest.iter().enumerate() {
        let wave = 1.0 + 0.3 * libm::sin(5.0 * x.y + 3.0 * x.x);
        shell.set_rate(a, Vec3::new(0.1 * x.x, 0.0, -x.z * wave) * (speed * sound()), Vec3::zeros());
    }
    shell
}

/// Energy measured 5e-4, 2.5e-3 and 3e-4; momentum to rounding.
#[test]
fn walls_thrown_at_each_other_keep_energy_and_momentum_and_do_not_cross() {
    let sound = sound();
    for (thickness, speed, bound) in [(0.05, 0.02, 1.5e-3), (0.05, 0.05, 7.5e-3), (0.3, 0.05, 1e-3)] {
        let found = course(&mut thrown([41, 8], thickness, speed, 1), 2.5 / (speed * sound));
        println!(
            "{thickness} {speed}: energy {:.1e}, momentum {:.1e} {:.1e}, {} crossings, depth {:.2}, {} steps",
            found.energy, found.momentum[0], found.momentum[1], found.crossings, found.depth, found.steps
        );
        assert!(found.energy < bound && found.crossings == 0 && found.depth < 1.0, "{found:?}");
        assert!(found.momentum.iter().all(|error| *error < 1e-13), "{:?}", found.momentum);
    }
}

/// Without contact the same walls go through each other: the audit sees it.
#[test]
fn the_audit_sees_walls_that_cross() {
    let mut shell = flat_tube();
    let turned = |x: Vec3| Vec3::new(x.x, x.y, -3.0 * x.z * (x.x - 0.4));
    assert_eq!(crossings(&shell), 0);
    for a in 0..shell.len() {
        let (x, d) = (shell.position(a), shell.director(a));
        shell.set_state(a, turned(x), d);
    }
    assert!(crossings(&shell) > 10);
}

#[test]
fn threads_and_a_stop_on_the_way_leave_the_bits_as_they_are() {
    let (speed, thickness) = (0.05, 0.05);
    let duration = 1.6 / (speed * sound());
    let run = Transient { duration, record_every: 0.1 * duration, damping: 0.0, safety: 0.8 };
    let mut lasts = Vec::new();
    for (threads, stops) in [(1, [u64::MAX; 2]), (3, [u64::MAX; 2]), (1, [101, 263])] {
        let mut shell = thrown([41, 8], thickness, speed, threads);
        let mut march = March::start(run, &mut shell).unwrap();
        let mut most: f64 = 0.0;
        while !matches!(march.advance(&mut shell).unwrap(), Event::End) {
            most = most.max(shell.own_touch().unwrap().area);
            if let Some(at) = march.state().filter(|at| stops.contains(&at.clock.steps)) {
                let (kept, [state, rates]) = (shell.contact_state(), shell.motion());
                let mut other = thrown([41, 8], thickness, speed, threads);
                assert!(other.take_up([state, rates]) && other.take_up_contact(&kept));
                assert!(!other.take_up_contact(&kept[1..]));
                march = March::resume(run, at.clone());
                shell = other;
            }
        }
        assert!(most > 0.1, "{most}");
        lasts.push((shell.motion()[0].to_vec(), march.clock().steps));
    }
    assert!(lasts[1] == lasts[0], "threads");
    assert!(lasts[2] == lasts[0], "a stop");
}

/// A tube under many times the pressure that it bears, long after its walls have met.
#[test]
fn a_tube_that_crumples_never_comes_through_itself() {
    let thickness = 0.05;
    let shape = Cylinder { radius: 1.0, angles: [0.0, 6.1], length: 1.6 };
    let cloud = lattice(&shape, [61, 16], EndWeights::Trapezoid).unwrap();
    let own = touching(thickness, cloud.spacing(), Law::new(0.05).unwrap(), true);
    let value = -12.0 * YOUNG * thickness * thickness * thickness / 12.0;
    let load: Box<dyn Load> = Box::new(Pressure { value, follower: true });
    let loads = vec![sph_shell::AppliedLoad { load, amplitude: Amplitude::Constant }];
    let built = sph_shell::Parts { loads, threads: 2, ..parts(cloud, CELL, thickness) };
    let mut shell = Shell::builder(built).touching_itself(own).build().unwrap();
    for a in 0..shell.len() {
        let x = shell.position(a);
        let rate = libm::sin(3.0 * x.y + 2.0 * x.x) * 0.01 * sound();
        shell.set_rate(a, Vec3::new(x.x, 0.0, x.z) * rate, Vec3::zeros());
    }
    let steps = 2000;
    let run = Transient { duration: 1e6, record_every: 1e6, damping: 0.02, safety: 0.8 };
    let mut march = March::start(run, &mut shell).unwrap();
    let (mut depth, mut area, mut crossed): (f64, f64, usize) = (0.0, 0.0, 0);
    while march.clock().steps < steps {
        march.advance(&mut shell).unwrap();
        let touch = shell.own_touch().unwrap();
        (depth, area) = (depth.max(touch.greatest_depth), area.max(touch.area));
        if march.clock().steps.is_multiple_of(200) {
            crossed += crossings(&shell);
            println!("{}: {touch:?}, {crossed} crossings, {:.3e}", march.clock().steps, march.clock().dt);
        }
    }
    assert_eq!(crossed, 0);
    assert!(area > 0.5 && depth < 1.0, "{area} {depth}");
}
