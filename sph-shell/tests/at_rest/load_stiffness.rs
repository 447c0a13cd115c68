//! Loads that follow the shell: their derivatives, their symmetry, and what Newton's method and buckling make of them.

use std::f64::consts::FRAC_PI_2;

use crate::common::{
    self, POISSON, YOUNG, disordered_curved, energy_formulations, flat, scattered_curved, shake, shell,
};
use implicit_statics::{BucklingOptions, Equilibrium, Newton, NewtonOptions, linear_buckling, unwatched};
use shell_kinematics::strain_measures;
use sph_core::{Cloud, Cylinder, EndWeights, Side, Vec3, lattice};
use sph_shell::{
    Block, Body, Clamped, CoupleAxis, DrillingCouple, EdgeCouple, Force, Gravity, Load, Pressure,
    PressurePatch, StaticShell, Supported, SymmetryPlane, spread,
};

/// Every kind of load on a shell, on the edge given, and whether it follows the shell.
fn loads(edge: &[(u32, f64)], cloud: &Cloud) -> Vec<(&'static str, bool, Box<dyn Load>)> {
    let (edge, particles) = (edge.to_vec(), cloud.len());
    let drilling = |shares| {
        Box::new(DrillingCouple::new(cloud, shares, Vec3::new(0.3, -0.2, 0.9).normalize(), 0.94_f64.sqrt()))
    };
    let couple = |axis| Box::new(EdgeCouple { edge: edge.clone(), moment: 0.7, axis });
    vec![
        ("force", false, Box::new(Force { shares: edge.clone(), total: Vec3::new(1.0, -2.0, 0.5) })),
        ("gravity", false, Box::new(Gravity { acceleration: Vec3::new(0.0, 0.3, -9.8) })),
        ("dead pressure", false, Box::new(Pressure { value: 1.3, follower: false })),
        ("follower pressure", true, Box::new(Pressure { value: 1.3, follower: true })),
        ("follower pressure on cells", true, {
            Box::new(PressurePatch {
                pressure: Pressure { value: 1.3, follower: true },
                cells: vec![2, 3, 7],
                factors: Vec::new(),
            })
        }),
        ("follower pressure that differs from particle to particle", true, {
            Box::new(PressurePatch {
                pressure: Pressure { value: 1.3, follower: true },
                cells: vec![2, 3, 7],
                factors: (0..particles).map(|a| 0.5 + 0.1 * a as f64).collect(),
            })
        }),
        ("couple about a fixed axis", true, couple(CoupleAxis::Fixed(Vec3::new(0.6, 0.0, 0.8)))),
        ("couple about the edge", true, couple(CoupleAxis::Edge)),
        ("couple along normals of a line", true, drilling(edge.clone())),
        ("couple along normals", true, drilling((4..12).map(|a| (a, 1.0 + 0.1 * f64::from(a))).collect())),
    ]
}

#[test]
fn the_stiffness_of_every_load_is_its_derivative() {
    for (cloud_name, cloud) in
        [("disordered", disordered_curved([6, 5])), ("with triangles", scattered_curved(0.5))]
    {
        let edge: Vec<(u32, f64)> =
            cloud.sides.as_ref().unwrap().edge(Side::U1).iter().map(|&a| (a, 0.5)).collect();
        for (name, follows, load) in loads(&edge, &cloud) {
            let mut body =
                shell(cloud.clone(), energy_formulations()[0].1, 0.2, strain_measures()[0], vec![], vec![]);
            shake(&mut body, 0.1, 4);
            let state: Vec<[f64; 6]> = (0..body.len())
                .map(|a| {
                    let (x, d) = (body.position(a), body.director(a));
                    [x.x, x.y, x.z, d.x, d.y, d.z]
                })
                .collect();
            let reference = body.reference();
            let masses = &reference.masses;
            let add = |state: &[[f64; 6]]| {
                let mut forces = vec![[0.0; 6]; state.len()];
                load.add(0.9, &Body { reference, state, masses }, &mut forces);
                forces
            };
            let mut dice = common::RandomNumbers(11);
            let way: Vec<[f64; 6]> = state.iter().map(|_| std::array::from_fn(|_| dice.roll())).collect();
            let mut found = vec![[0.0; 6]; state.len()];
            let mut any = false;
            let mut put = |a: u32, b: u32, block: &Block| {
                any = true;
                for (i, row) in block.iter().enumerate() {
                    let product: f64 = row.iter().zip(&way[b as usize]).map(|(k, v)| k * v).sum();
                    found[a as usize][i] += product;
                }
            };
            load.stiffness(0.9, &Body { reference, state: &state, masses }, &mut put);
            assert_eq!(any, follows, "{name}");
            let h = 1e-4;
            let at = |factor: f64| {
                let moved = |(row, way): (&[f64; 6], &[f64; 6])| {
                    std::array::from_fn(|i| row[i] + factor * h * way[i])
                };
                add(&state.iter().zip(&way).map(moved).collect::<Vec<_>>())
            };
            let [before, behind, ahead, beyond] = [-2.0, -1.0, 1.0, 2.0].map(at);
            let largest = found.iter().flatten().fold(1e-3, |top: f64, f| top.max(f.abs()));
            for (a, row) in found.iter().enumerate() {
                for (i, value) in row.iter().enumerate() {
                    let (near, far) = (ahead[a][i] - behind[a][i], beyond[a][i] - before[a][i]);
                    let difference = (8.0 * near - far) / (12.0 * h);
                    // Rounding 1e-16/h of the forces, truncation h⁴ of their fourth derivative.
                    assert!(
                        (difference - value).abs() < 1e-9 * largest,
                        "{name} on {cloud_name}, particle {a}, row {i}: {difference} {value}"
                    );
                }
            }
        }
    }
}

/// A quarter of an endless cylinder of radius 1 under pressure from outside: planes of symmetry on all four sides.
fn quarter(counts: [usize; 2], thickness: f64, follower: bool) -> StaticShell {
    let patch = Cylinder { radius: 1.0, angles: [0.0, FRAC_PI_2], length: 0.1 };
    let cloud = lattice(&patch, counts, EndWeights::Trapezoid).unwrap();
    let sides = cloud.sides.clone().unwrap();
    let plane = |side, normal| Supported {
        particles: sides.edge(side).to_vec(),
        support: Box::new(SymmetryPlane { normal }),
    };
    let supports = vec![
        plane(Side::U0, Vec3::x()),
        plane(Side::U1, Vec3::z()),
        plane(Side::V0, Vec3::y()),
        plane(Side::V1, Vec3::y()),
    ];
    let pressure = Box::new(Pressure { value: -1.0, follower });
    let body =
        shell(cloud, energy_formulations()[0].1, thickness, strain_measures()[0], supports, vec![pressure]);
    StaticShell::new(body)
}

#[test]
fn pressure_inside_planes_of_symmetry_has_a_potential_and_over_free_edges_has_none() {
    assert_eq!(quarter([13, 3], 0.01, true).skew_load_share(), 0.0);
    let cloud = flat([6, 5], [2.0, 1.5]);
    let clamp = Supported {
        particles: cloud.sides.as_ref().unwrap().edge(Side::U0).to_vec(),
        support: Box::new(Clamped),
    };
    let pressure = |follower| -> Vec<Box<dyn Load>> { vec![Box::new(Pressure { value: 1.0, follower })] };
    let plate = |loads| {
        let clamp = Supported { particles: clamp.particles.clone(), support: Box::new(Clamped) };
        shell(cloud.clone(), energy_formulations()[0].1, 0.1, strain_measures()[0], vec![clamp], loads)
    };
    assert!(StaticShell::new(plate(pressure(true))).skew_load_share() > 0.1);
    assert_eq!(StaticShell::new(plate(pressure(false))).skew_load_share(), 0.0);
}

#[test]
fn a_tube_buckles_at_three_under_follower_pressure_and_at_four_under_dead() {
    let thickness: f64 = 0.01;
    // Held along its axis it bends with D = E t³/12(1 − ν²).
    let stiffness = YOUNG * thickness.powi(3) / (12.0 * (1.0 - POISSON * POISSON));
    let level = |follower| {
        let mut tube = quarter([61, 2], thickness, follower);
        linear_buckling(&mut tube, 0.0, &BucklingOptions::new(1), &mut unwatched).unwrap().modes[0].level
            / stiffness
    };
    let (follower, dead) = (level(true), level(false));
    assert!((follower / 3.0 - 1.0).abs() < 2e-3, "{follower}");
    assert!((dead / 4.0 - 1.0).abs() < 2e-3, "{dead}");
}

#[test]
fn residuals_fall_quadratically_under_follower_pressure() {
    let thickness: f64 = 0.05;
    let mut system = quarter([25, 3], thickness, true);
    let options = NewtonOptions {
        tolerance: 1e-12,
        iterations: 30,
        line_search: false,
        keep: 0.0,
        ..Default::default()
    };
    let mut newton = Newton::new(&system, &options).unwrap();
    // An oval beyond the critical pressure, reached from a bent start: the pressure turns by much on the way.
    let critical = 3.0 * YOUNG * thickness.powi(3) / (12.0 * (1.0 - POISSON * POISSON));
    let mode = linear_buckling(&mut system, 0.0, &BucklingOptions::new(1), &mut unwatched)
        .unwrap()
        .modes
        .remove(0)
        .shape;
    system.update(&mode.iter().map(|q| 0.3 * q).collect::<Vec<_>>());
    for level in [1.1, 1.3, 1.5] {
        newton.at_level(&mut system, level * critical).unwrap();
    }
    let oval = (0..system.shell().len()).map(|a| system.shell().displacement(a).norm()).fold(0.0, f64::max);
    let residuals = newton.at_level(&mut system, 1.7 * critical).unwrap().residuals;
    // The order between three iterates that are neither far away nor round-off.
    let largest = residuals.iter().copied().fold(0.0, f64::max);
    let order = residuals
        .windows(3)
        .filter(|r| r[0] < 1e-2 * largest && r[2] > 1e-12 * largest)
        .map(|r| libm::log(r[2] / r[1]) / libm::log(r[1] / r[0]))
        .fold(0.0, f64::max);
    assert!(oval > 0.2, "the tube is still round: {oval}");
    assert!(order > 1.8, "order {order} in {residuals:?}");
}

/// A shell of particles in disorder under one load on some cells.
fn loaded(load: Box<dyn Load>) -> sph_shell::Shell {
    let cloud = scattered_curved(0.5);
    let clamp = Supported {
        particles: cloud.sides.as_ref().unwrap().edge(Side::U0).to_vec(),
        support: Box::new(Clamped),
    };
    shell(cloud, energy_formulations()[0].1, 0.2, strain_measures()[0], vec![clamp], vec![load])
}

#[test]
fn patches_of_pressure_add_up_to_the_whole() {
    let cells = scattered_curved(0.5).cells.len() as u32;
    let half = cells / 2;
    let of = |load: Box<dyn Load>| {
        let mut body = loaded(load);
        shake(&mut body, 0.1, 4);
        body.load_resultants(body.centroid())[0]
    };
    for follower in [false, true] {
        let pressure = Pressure { value: 1.3, follower };
        let part = |cells: std::ops::Range<u32>| {
            of(Box::new(PressurePatch { pressure, cells: cells.collect(), factors: Vec::new() }))
        };
        let (whole, one, other) = (of(Box::new(pressure)), part(0..half), part(half..cells));
        assert!((one.force + other.force - whole.force).norm() < 1e-13 * whole.force.norm());
        assert!((one.moment + other.moment - whole.moment).norm() < 1e-13 * whole.force.norm());
    }
}

#[test]
fn areas_spread_over_cells_add_up_to_those_of_the_particles() {
    for cloud in [flat([6, 5], [2.0, 1.5]), scattered_curved(0.5)] {
        let cells: Vec<u32> = (0..cloud.cells.len() as u32).collect();
        let mut sums = vec![0.0; cloud.len()];
        for cells in cells.chunks(7) {
            spread(&cloud, cells, |_| 1.0).into_iter().for_each(|(a, part)| sums[a as usize] += part);
        }
        for (sum, area) in sums.iter().zip(&cloud.areas) {
            assert!((sum / area - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn supports_bear_what_the_loads_are() {
    let pressure = Pressure { value: 0.3, follower: true };
    let mut system = StaticShell::new(loaded(Box::new(PressurePatch {
        pressure,
        cells: (3..9).collect(),
        factors: Vec::new(),
    })));
    let options = NewtonOptions {
        tolerance: 1e-12,
        iterations: 30,
        line_search: false,
        keep: 0.0,
        ..Default::default()
    };
    Newton::new(&system, &options).unwrap().at_level(&mut system, 1.0).unwrap();
    system.evaluate(1.0);
    let shell = system.shell();
    // About any point, and in the deformed state.
    for about in [shell.centroid(), Vec3::new(7.0, -2.0, 1.0)] {
        let (load, borne) = (shell.load_resultants(about)[0], shell.support_resultant(about));
        assert!((load.force + borne.force).norm() < 1e-9 * load.force.norm());
        assert!((load.moment + borne.moment).norm() < 1e-9 * load.force.norm(), "{load:?} {borne:?}");
    }
}
