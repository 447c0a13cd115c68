//! Rigid tools on shells: derivatives, a ring between plates and a strip on a cylinder in closed form, restitution, momentum, the same bits.

use std::ops::ControlFlow;

use crate::common::{
    DENSITY, YOUNG, beam_parts, curved, disordered_curved, disordered_flat, energy_formulations, flat, parts,
    shake, supported,
};
use contact::{Law, ToolShape, stiffness};
use explicit_dynamics::{Amplitude, Instant, March, Transient};
use implicit_statics::{Control, End, Equilibrium, PathOptions, Start, follow, stiffness_error};
use nalgebra::Matrix3;
use sph_core::{Cylinder, EndWeights, Side, Vec3, lattice};
use sph_shell::{
    Clamped, Force, Formulation, Load, LoadCase, Parts, Reach, RigidSet, Shell, StaticShell, SymmetryPlane,
    Tool,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

/// A tool that stands where it is at every level, with a law without rounding.
fn still(shape: ToolShape, stiffness: f64) -> Tool {
    Tool {
        shape,
        moved: Vec3::zeros(),
        turn: 0.0,
        friction: 0.0,
        amplitude: Amplitude::Constant,
        case: LoadCase::Loading,
        law: Law::new(0.0).unwrap(),
        stiffness,
    }
}

/// Tools that reach a third and more into the thickness of [`curved`], from outside, from inside, and at a corner.
fn tools() -> Vec<Tool> {
    let moved = Vec3::new(0.01, 0.0, 0.02);
    let of = |shape, stiffness| Tool { moved, law: Law::new(0.05).unwrap(), ..still(shape, stiffness) };
    vec![
        of(ToolShape::Plane { point: Vec3::new(0.0, 0.0, 3.06), normal: Vec3::new(0.02, 0.0, -1.0) }, 400.0),
        of(ToolShape::Sphere { centre: Vec3::new(0.3, 1.0, 1.96), radius: 0.95 }, 300.0),
        of(
            ToolShape::Cylinder {
                point: Vec3::new(0.0, 0.0, 1.0),
                axis: Vec3::new(0.0, 1.0, 0.004),
                radius: 1.93,
            },
            500.0,
        ),
        of(
            ToolShape::Capsule {
                ends: [Vec3::new(-0.747, 0.0, 2.11), Vec3::new(-0.747, 2.0, 2.12)],
                radius: 0.7,
            },
            200.0,
        ),
    ]
}

/// Differences over 2e-6 of a law whose third derivative jumps: 1e-11 measured at most.
#[test]
fn tangent_and_level_rate_of_a_touched_shell_are_derivatives() {
    for cloud in [curved([7, 6]), disordered_curved([7, 6])] {
        for (name, formulation) in energy_formulations() {
            let mut body =
                Shell::builder(parts(cloud.clone(), formulation, 0.2)).tools(tools()).build().unwrap();
            shake(&mut body, 0.01, 5);
            let mut system = StaticShell::new(body);
            let (n, level) = (system.unknowns(), 0.7);
            let way: Vec<f64> = (0..n).map(|i| libm::sin(1.0 + 3.7 * i as f64)).collect();
            let error = stiffness_error(&mut system, level, &way, 2e-6);
            system.evaluate(level);
            let touches = system.shell().touches().to_vec();
            println!("{name}: {error:.1e}");
            assert!(
                touches.iter().all(|touch| touch.greatest_depth > 0.05 && touch.greatest_depth < 0.95),
                "{touches:?}"
            );
            assert!(error < 1e-10, "{name}: {error:.1e}");
            let [mut rate, mut less, mut more] = [vec![0.0; n], vec![0.0; n], vec![0.0; n]];
            system.load_rate(level, &mut rate);
            let h = 1e-5;
            system.external(level - h, &mut less);
            system.external(level + h, &mut more);
            let most = rate.iter().fold(0.0_f64, |m, r| m.max(r.abs()));
            assert!(most > 0.0);
            for (i, (rate, (more, less))) in rate.iter().zip(more.iter().zip(&less)).enumerate() {
                let slope = (more - less) / (2.0 * h);
                assert!((rate - slope).abs() < 1e-6 * most, "{name} {i}: {rate} {slope}");
            }
        }
    }
}

/// The force of a tool on a rigid set goes to the body: the same derivative, and the same error of it.
#[test]
fn the_tangent_of_a_touched_rigid_set_is_a_derivative() {
    let cloud = curved([7, 6]);
    let particles: Vec<u32> =
        (0..cloud.len() as u32).filter(|&a| cloud.positions[a as usize].x.abs() < 0.2).collect();
    assert!(particles.len() >= 6);
    let set = RigidSet {
        particles,
        at: Vec3::new(0.0, 1.0, 3.0),
        mass: 0.1,
        inertia: Matrix3::identity() * 0.01,
        holds: Vec::new(),
    };
    let builder = Shell::builder(parts(cloud, CELL, 0.2)).rigid(vec![set]).tools(tools());
    let mut system = StaticShell::new(builder.build().unwrap());
    let way: Vec<f64> = (0..system.unknowns()).map(|i| libm::sin(1.0 + 3.7 * i as f64)).collect();
    let error = stiffness_error(&mut system, 0.7, &way, 2e-6);
    system.evaluate(0.7);
    assert!(system.shell().touches().iter().all(|touch| touch.greatest_depth > 0.05));
    println!("{error:.1e}");
    assert!(error < 1e-9, "{error:.1e}");
}

/// A quarter of a ring of radius one, from its crown to its side, of two cells across, under a plate that comes down by `down` at level one.
fn ring(cells: usize, thickness: f64, down: f64, law: Law) -> Shell {
    let shape = Cylinder { radius: 1.0, angles: [0.0, std::f64::consts::FRAC_PI_2], length: 0.1 };
    let cloud = lattice(&shape, [cells + 1, 3], EndWeights::Trapezoid).unwrap();
    let sides = cloud.sides.clone().unwrap();
    let plane = |side, normal| supported(sides.edge(side).to_vec(), SymmetryPlane { normal });
    let supports = vec![plane(Side::U0, Vec3::x()), plane(Side::U1, Vec3::z()), plane(Side::V0, Vec3::y())];
    let plate = ToolShape::Plane { point: Vec3::z() * (1.0 + 0.5 * thickness), normal: -Vec3::z() };
    let spacing = std::f64::consts::FRAC_PI_2 / cells as f64;
    let tool = Tool {
        shape: plate,
        moved: Vec3::z() * -down,
        turn: 0.0,
        friction: 0.0,
        amplitude: Amplitude::Constant,
        case: LoadCase::Loading,
        law,
        stiffness: stiffness(YOUNG, thickness, spacing),
    };
    Shell::builder(beam_parts(cloud, thickness, supports, Vec::new())).tools(vec![tool]).build().unwrap()
}

/// Distance of the mid-surfaces H/R and force P R²/B of a ring between plates (elastica): in points, where it flattens, and after.
fn elastica(height: f64) -> Option<f64> {
    const POINTS: [[f64; 2]; 5] =
        [[1.96172042, 0.25], [1.83305622, 1.0], [1.73492321, 1.5], [1.62647072, 2.0], [1.50783211, 2.5]];
    if height < 1.43554 {
        return Some(5.74216009 / (height * height));
    }
    POINTS.iter().find(|point| (point[0] - height).abs() < 1e-9).map(|point| point[1])
}

/// Errors of the force at 20 and 40 cells a quarter \[%\], measured .34, .05 before it flattens, 2.2 and .3 after.
#[test]
fn a_ring_between_plates_bears_what_the_elastica_bears() {
    let thickness = 0.02;
    let bending = YOUNG * thickness * thickness * thickness / 12.0;
    for (height, bounds) in
        [(1.83305622, [1.0, 0.15]), (1.62647072, [1.0, 0.15]), (1.0, [1.0, 0.2]), (0.6, [6.6, 0.9])]
    {
        for (cells, bound) in [20, 40].into_iter().zip(bounds) {
            let shell = ring(cells, thickness, 1.0 - 0.5 * height, Law::new(0.0).unwrap());
            let (system, iterations) = followed(shell);
            let touch = system.shell().touches()[0];
            // A quarter bears half of the force, on a width of a tenth.
            let force = -touch.force.z * 2.0 / 0.1 / bending;
            let error = 100.0 * (force / elastica(height).unwrap() - 1.0);
            println!("{cells} cells, H {height}: {iterations} iterations, P {force:.4}: {error:+.2} %");
            assert!(error.abs() < bound, "{cells} cells, H {height}: {error:+.2} %");
            assert!(touch.greatest_depth < 0.01, "{touch:?}");
        }
    }
}

/// The end of the path to level one, in steps of a tenth, and how many iterations it took.
fn followed(shell: Shell) -> (StaticShell, usize) {
    let mut system = StaticShell::new(shell);
    let options = PathOptions::new(Control::Load { step: 0.1, until: 1.0 });
    let mut iterations = 0;
    let path = follow(&mut system, &Start::default(), &options, |point, _| {
        iterations += point.converged.iterations;
        ControlFlow::Continue(())
    });
    assert_eq!(path.end, Ok(End::Reached));
    (system, iterations)
}

/// Shells far from zero keep their places from an origin of their own, tools theirs from zero.
#[test]
fn a_shell_far_from_zero_meets_a_tool_that_is_as_far() {
    let far = Vec3::new(1024.0, -512.0, 2048.0);
    let found = [Vec3::zeros(), far].map(|by| {
        let mut cloud = curved([7, 6]);
        cloud.positions.iter_mut().for_each(|x| *x += by);
        let point = Vec3::new(0.0, 0.0, 3.06) + by;
        let tool = still(ToolShape::Plane { point, normal: Vec3::new(0.02, 0.0, -1.0) }, 400.0);
        let builder = Shell::builder(parts(cloud, CELL, 0.2)).origin(by).tools(vec![tool]);
        let mut shell = builder.build().unwrap();
        let touch = shell.touch(Instant { time: 0.0, level: 1.0 })[0];
        (touch.force, touch.greatest_depth)
    });
    let [(force, depth), (far, deep)] = found;
    assert!(
        depth > 0.2 && (far - force).norm() < 1e-9 * force.norm() && (deep - depth).abs() < 1e-9,
        "{found:?}"
    );
}

/// A strip of length one, clamped on top of a cylinder of mid-surface radius one, with a dead load at its tip: wrapped length a,
/// P L²/B, tip along x and down (elastica by shooting).
const WRAPPED: [[f64; 4]; 3] = [
    [0.1, 1.21337533, 0.923980717, 0.347366536],
    [0.3, 1.66186345, 0.897254364, 0.395346304],
    [0.6, 3.36152313, 0.862126668, 0.44106888],
];

#[test]
fn a_strip_lies_on_a_cylinder_as_the_elastica_does() {
    let thickness = 0.01;
    let bending = YOUNG * thickness * thickness * thickness / 12.0;
    // Measured 3.7e-4 and 3.7e-5 of the length, where little of it lies on the drum.
    for (cells, bound) in [(50, 1.1e-3), (100, 1.1e-4)] {
        for [wrapped, load, along, down] in WRAPPED {
            let cloud = flat([cells + 1, 3], [1.0, 0.05]);
            let sides = cloud.sides.clone().unwrap();
            let tip = sides.edge(Side::U1).to_vec();
            let shares = tip.iter().zip([0.25, 0.5, 0.25]).map(|(&a, share)| (a, share)).collect();
            let force: Box<dyn Load> =
                Box::new(Force { shares, total: Vec3::z() * (-load * bending * 0.05) });
            let supports = vec![supported(sides.edge(Side::U0).to_vec(), Clamped)];
            let drum = ToolShape::Cylinder {
                point: Vec3::z() * -1.0,
                axis: Vec3::y(),
                radius: 1.0 - 0.5 * thickness,
            };
            let tool = still(drum, stiffness(YOUNG, thickness, 1.0 / cells as f64));
            let shell = Shell::builder(beam_parts(cloud, thickness, supports, vec![force])).tools(vec![tool]);
            let (system, iterations) = followed(shell.build().unwrap());
            let place = system.shell().position(tip[1] as usize);
            let touch = system.shell().touches()[0];
            let error = ((place.x - along).powi(2) + (place.z + down).powi(2)).sqrt();
            println!(
                "{cells} cells, wrapped {wrapped}: {iterations} iterations, tip {error:.1e} off, touching {:.3}",
                touch.area / 0.05
            );
            assert!(error < bound, "{cells} cells, wrapped {wrapped}: {error:.1e}");
        }
    }
}

/// A free plate of cells of unlike size that falls onto a plane at a part of its speed of sound, one edge first where it is tilted.
fn dropped(speed: f64, thickness: f64, tilt: f64, threads: usize) -> Shell {
    let cloud = disordered_flat([9, 8], [1.0, 0.9]);
    let all = Parts { threads, ..parts(cloud, CELL, thickness) };
    let plane =
        ToolShape::Plane { point: Vec3::z() * -(0.5 * thickness + 0.02), normal: Vec3::new(tilt, 0.0, 1.0) };
    let law = Law::new(0.05).unwrap();
    let tool = Tool { law, ..still(plane, stiffness(YOUNG, thickness, 1.0 / 8.0)) };
    let mut shell = Shell::builder(all).tools(vec![tool]).build().unwrap();
    let [state, rates] = shell.motion();
    let (state, mut rates) = (state.to_vec(), rates.to_vec());
    rates.iter_mut().for_each(|rate| rate[2] = -speed * (YOUNG / DENSITY).sqrt());
    assert!(shell.take_up([&state[..], &rates[..]]));
    shell
}

/// Momentum along z \[M L/T\].
fn momentum(shell: &Shell) -> f64 {
    let [_, rates] = shell.motion();
    shell.reference().masses.iter().zip(rates).map(|(mass, rate)| mass * rate[2]).sum()
}

#[test]
fn a_plate_bounces_off_a_plane_with_its_energy() {
    for (thickness, tilt) in [(0.02, 0.0), (0.1, 0.0), (0.05, 0.02)] {
        for speed in [0.001, 0.005] {
            let mut shell = dropped(speed, thickness, tilt, 1);
            let before = momentum(&shell);
            let plan = Transient { duration: 3.0, record_every: 0.01, damping: 0.0, safety: 0.9 };
            let (mut worst, mut impulse, mut touched, mut start) = (0.0_f64, 0.0, 0.0_f64, None);
            let mut march = March::start(plan, &mut shell).unwrap();
            while let Some(record) = march.next_record(&mut shell).unwrap() {
                let initial = *start.get_or_insert(record.energy.kinetic);
                worst = worst.max(record.balance_error.abs() / initial);
                let touch = shell.touches()[0];
                impulse += touch.force.z * 0.01;
                touched = touched.max(touch.greatest_depth);
            }
            let (restitution, taken) = (-momentum(&shell) / before, momentum(&shell) / before - 1.0);
            println!(
                "t {thickness}, tilt {tilt}, v/c {speed}: energy {worst:.1e}, restitution {restitution:.4}, impulse {:.3}, depth {touched:.2}",
                impulse / before
            );
            assert!(worst < 2e-4 && touched < 0.3, "{thickness} {tilt} {speed}: {worst:.1e}");
            // Flat on the plane it leaves as it came: measured .9984 at worst. On an edge some of it turns and swings.
            assert!(tilt != 0.0 || (restitution - 1.0).abs() < 5e-3, "{thickness} {speed}: {restitution}");
            // Records every hundredth of a second see an impact of some hundredths.
            assert!((impulse / before / taken - 1.0).abs() < 0.1, "{thickness} {speed}: {impulse} {taken}");
        }
    }
}
