//! The wet surface of a shell: where its points are, and that their forces reach the particles whole.

use std::f64::consts::PI;

use crate::common::{
    RandomNumbers, curved, energy_formulations, flat, free_shell, parts, scattered_curved, shake,
};
use explicit_dynamics::{BoundaryLoad, BoundaryState, Dynamics, Face, Instant, Wetted};
use sph_core::{Cell, Cloud, Side, Vec3};
use sph_shell::{Formulation, Reach, Shell, ShellError, WetFaces, Wetting};

const CELLS: Formulation = Formulation::StressPoint(Reach::Cell);
const THICKNESS: f64 = 0.05;

fn wetting(spacing: f64) -> Wetting {
    Wetting { spacing, rows: 3, faces: WetFaces::Both, plane: false, free_edges: Vec::new() }
}

/// A strip along x that stands on the plane z = 0, so many particles along it and across.
fn strip(counts: [usize; 2], length: f64, width: f64) -> Cloud {
    let mut cloud = flat(counts, [length, width]);
    let turn = |v: Vec3| Vec3::new(v.x, -v.z, v.y);
    cloud.positions.iter_mut().for_each(|x| *x = turn(*x));
    let normals = cloud.frames.iter().map(|frame| turn(frame.n)).collect();
    Cloud::from_cells(cloud.positions, Some(normals), cloud.cells).unwrap()
}

/// A closed tube about z, two particles high, its normals outward.
fn tube(around: usize, radius: f64, height: f64) -> Cloud {
    let mut positions = Vec::new();
    for i in 0..around {
        let angle = 2.0 * PI * i as f64 / around as f64;
        for z in [0.0, height] {
            positions.push(Vec3::new(radius * libm::cos(angle), radius * libm::sin(angle), z));
        }
    }
    let at = |i: usize, z: usize| (2 * (i % around) + z) as u32;
    let cell = |i: usize| Cell::quadrangle([at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1)]);
    Cloud::from_cells(positions, None, (0..around).map(cell).collect()).unwrap()
}

fn wet(cloud: Cloud, wetting: &Wetting) -> Shell {
    let shell = Shell::builder(parts(cloud, CELLS, THICKNESS));
    shell.wetted(wetting.clone()).build().unwrap()
}

fn boundary(shell: &Shell) -> BoundaryState {
    let mut out = BoundaryState::default();
    shell.boundary(&mut out);
    out
}

fn velocities(shell: &Shell) -> Vec<Vec3> {
    let mut out = vec![[f64::NAN; 3]];
    shell.boundary_velocities(&mut out);
    out.into_iter().map(Vec3::from).collect()
}

/// `[f, τ]` of all particles under such forces on the points, beside those of internal forces.
fn on_particles(shell: &mut Shell, forces: &[[f64; 3]], seen: &[[f64; 3]], impedance: f64) -> Vec<[f64; 6]> {
    shell.apply_load(&BoundaryLoad { forces, found: forces, seen, impedance });
    shell.evaluate(Instant { time: 0.0, level: 1.0 });
    (0..shell.len()).map(|a| shell.external_force(a)).collect()
}

fn random_forces(count: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut dice = RandomNumbers(seed);
    (0..count).map(|_| dice.vector().into()).collect()
}

/// Wet shells of all kinds, in states far from rest.
fn shaken() -> Vec<(&'static str, Shell)> {
    let plane = Wetting { plane: true, ..wetting(0.03) };
    let strips = strip([21, 3], 1.0, 0.1);
    let nodal = energy_formulations()[4].1;
    let mut no_cells = flat([6, 5], [1.0, 0.8]);
    (no_cells.cells, no_cells.lattice) = (Vec::new(), None);
    let without_cells = Shell::builder(parts(no_cells, nodal, THICKNESS));
    let without_cells = without_cells.wetted(wetting(0.3)).build().unwrap();
    let mut all = vec![
        ("strip in a plane", wet(strips, &plane)),
        ("tube in a plane", wet(tube(40, 1.0, 0.1), &plane)),
        ("lattice, finer fluid", wet(curved([7, 6]), &wetting(0.13))),
        (
            "lattice, coarser fluid",
            wet(curved([17, 16]), &Wetting { faces: WetFaces::Back, ..wetting(0.37) }),
        ),
        ("scattered, finer fluid", wet(scattered_curved(0.3), &wetting(0.17))),
        ("scattered, coarser fluid", wet(scattered_curved(0.2), &Wetting { rows: 1, ..wetting(0.5) })),
        ("without cells", without_cells),
    ];
    for (number, (_, shell)) in all.iter_mut().enumerate() {
        shake(shell, 0.2, number as u64);
    }
    all
}

/// Work of the forces on the points for any motion of the particles is that of the forces on the particles.
#[test]
fn virtual_work_is_the_same_on_points_and_particles() {
    for (name, mut shell) in shaken() {
        let before = boundary(&shell).points;
        let plane = name.ends_with("plane");
        let forces = random_forces(before.len(), 5);
        let rows = on_particles(&mut shell, &forces, &vec![[0.0; 3]; before.len()], 0.0);
        let mut dice = RandomNumbers(11);
        let (mut work, mut size) = (0.0, 0.0);
        for (a, row) in rows.iter().enumerate() {
            let (x, d) = (shell.position(a), shell.director(a));
            // Directors stay unit vectors: the work of what acts along them is not asked for.
            let (step, turn) = (dice.vector() * 1e-3, dice.vector() * 1e-3);
            shell.set_state(a, x + step, d + turn);
            let change = shell.director(a) - d;
            let [f, t] = [[row[0], row[1], row[2]], [row[3], row[4], row[5]]].map(Vec3::from);
            work += f.dot(&step) + t.dot(&change);
            size += f.norm() * step.norm() + t.norm() * change.norm();
        }
        let width = if plane { 0.1 } else { 1.0 };
        let after = boundary(&shell).points;
        let moved: f64 = (before.iter().zip(&after).zip(&forces))
            .map(|((a, b), f)| width * (Vec3::from(*b) - Vec3::from(*a)).dot(&Vec3::from(*f)))
            .sum();
        assert!(size > 0.0 && (work - moved).abs() < 1e-12 * size, "{name}: {work} {moved}");
    }
}

#[test]
fn forces_and_moments_are_kept() {
    for (name, mut shell) in shaken() {
        let points = boundary(&shell).points;
        let mut forces = random_forces(points.len(), 7);
        let plane = name.ends_with("plane");
        if plane {
            forces.iter_mut().for_each(|f| f[2] = 0.0);
        }
        let width = if plane { 0.1 } else { 1.0 };
        let (mut force, mut moment, mut size) = (Vec3::zeros(), Vec3::zeros(), [0.0, 0.0]);
        for (x, f) in points.iter().zip(&forces) {
            let (x, f) = (Vec3::from(*x), Vec3::from(*f) * width);
            force += f;
            moment += x.cross(&f);
            size = [size[0] + f.norm(), size[1] + x.norm() * f.norm()];
        }
        let rows = on_particles(&mut shell, &forces, &vec![[0.0; 3]; points.len()], 0.0);
        for (a, row) in rows.iter().enumerate() {
            let [f, t] = [[row[0], row[1], row[2]], [row[3], row[4], row[5]]].map(Vec3::from);
            force -= f;
            moment -= shell.position(a).cross(&f) + shell.director(a).cross(&t);
        }
        if plane {
            // What lies across the plane has no moment in it.
            (moment.x, moment.y) = (0.0, 0.0);
        }
        assert!(
            force.norm() < 1e-12 * size[0] && moment.norm() < 1e-12 * size[1],
            "{name}: {force} {moment}"
        );
    }
}

#[test]
fn velocities_of_points_are_their_rates() {
    for (name, mut shell) in shaken() {
        let mut dice = RandomNumbers(3);
        for a in 0..shell.len() {
            let (v, w) = (dice.vector(), dice.vector());
            shell.set_rate(a, v, w);
        }
        let (found, dt) = (velocities(&shell), 1e-6);
        assert_eq!(found.len(), shell.boundary_layout().points);
        let [state, rates] = shell.motion().map(<[[f64; 6]]>::to_vec);
        let [behind, ahead] = [-dt, dt].map(|dt| {
            for (a, (row, rate)) in state.iter().zip(&rates).enumerate() {
                let at = |k: usize| row[k] + dt * rate[k];
                shell.set_state(a, Vec3::new(at(0), at(1), at(2)), Vec3::new(at(3), at(4), at(5)));
            }
            boundary(&shell).points
        });
        for (v, (a, b)) in found.iter().zip(behind.iter().zip(&ahead)) {
            let rate = (Vec3::from(*b) - Vec3::from(*a)) / (2.0 * dt);
            assert!((rate - v).norm() < 1e-8 * (1.0 + v.norm()), "{name}: {rate} {v}");
        }
    }
}

/// Distances of each point to the nearest other of its row on its face.
fn gaps(points: &[[f64; 3]]) -> Vec<f64> {
    let nearest = |a: usize| {
        let far = |b: usize| (Vec3::from(points[a]) - Vec3::from(points[b])).norm();
        (0..points.len()).filter(|&b| b != a).map(far).fold(f64::INFINITY, f64::min)
    };
    (0..points.len()).map(nearest).collect()
}

#[test]
fn a_strip_is_wetted_along_its_middle_line() {
    // Finer, even with, and coarser than the particles, .05 apart.
    for (spacing, count) in [(0.02, 50), (0.05, 20), (0.11, 10)] {
        let cloud = strip([21, 2], 1.0, 0.3);
        let tip: Vec<u32> =
            (0..cloud.len() as u32).filter(|&a| cloud.positions[a as usize].x > 0.999).collect();
        let shell = wet(cloud, &Wetting { plane: true, free_edges: tip, ..wetting(spacing) });
        let (layout, state) = (shell.boundary_layout(), boundary(&shell));
        let thin = layout.thin.as_ref().unwrap();
        assert_eq!((layout.points, state.points.len(), thin.thickness), (6 * count, 6 * count, THICKNESS));
        assert!((layout.areas.iter().sum::<f64>() - 6.0).abs() < 1e-12);
        // Normals of the strip point to −y.
        let mut heights = Vec::new();
        for (k, row) in state.points.chunks(count).enumerate() {
            let face = if k < 3 { Face::Front } else { Face::Back };
            let sign = if k < 3 { -1.0 } else { 1.0 };
            heights.push(sign * (0.5 * THICKNESS - (k % 3) as f64 * spacing - 0.5 * spacing));
            for (i, x) in row.iter().enumerate() {
                let at = Vec3::new((i as f64 + 0.5) / count as f64, heights[k], 0.0);
                assert!((Vec3::from(*x) - at).norm() < 1e-14, "{x:?} {at}");
                assert_eq!(thin.faces[k * count + i], face);
            }
        }
        // The tip is a place of its own; the other end goes on in a wall.
        assert_eq!(state.middle.len(), count + 1);
        assert!(thin.edges[count] && thin.edges[..count].iter().all(|edge| !edge));
        assert!((Vec3::from(state.middle[count]) - Vec3::x()).norm() < 1e-14);
        assert!(state.normals.iter().all(|n| (Vec3::from(*n) + Vec3::y()).norm() < 1e-14));
    }
}

#[test]
fn a_closed_tube_has_no_edge_and_no_seam() {
    let shell = wet(tube(40, 1.0, 0.1), &Wetting { plane: true, rows: 1, ..wetting(0.08) });
    let (layout, state) = (shell.boundary_layout(), boundary(&shell));
    let count = layout.points / 2;
    // Forty sides of 2 sin(π/40), as many points as divide their sum hardly wider than .08.
    let round = 80.0 * libm::sin(PI / 40.0);
    assert_eq!(count, (round / 0.08_f64).ceil() as usize);
    assert_eq!(state.middle.len(), count);
    assert!(layout.thin.as_ref().unwrap().edges.iter().all(|edge| !edge));
    // Chords cut the corners of the polygon: some gaps are a little less than along it.
    for gap in gaps(&state.middle) {
        assert!((0.99..=1.0 + 1e-12).contains(&(gap * count as f64 / round)), "{gap}");
    }
    for (x, n) in state.middle.iter().zip(&state.normals) {
        assert!(Vec3::from(*x).normalize().dot(&Vec3::from(*n)) > 0.999);
    }
}

#[test]
fn points_cover_a_shell_in_space_evenly() {
    let roof = 2.5 * 3.0 * 0.9;
    for (name, cloud, spacing, gap, area) in [
        ("lattice, finer fluid", curved([7, 6]), 0.13, [0.9, 1.05], 5e-3),
        ("lattice, coarser fluid", curved([17, 16]), 0.37, [0.9, 1.05], 5e-3),
        ("scattered, finer fluid", scattered_curved(0.3), 0.17, [0.6, 1.2], 1e-2),
        ("scattered, coarser fluid", scattered_curved(0.2), 0.5, [0.7, 1.4], 1e-2),
    ] {
        let sides = cloud.sides.clone().unwrap();
        let free = sides.edge(Side::U1).to_vec();
        let shell =
            wet(cloud, &Wetting { free_edges: free, faces: WetFaces::Front, rows: 2, ..wetting(spacing) });
        let (layout, state) = (shell.boundary_layout(), boundary(&shell));
        let columns = layout.points / 2;
        let whole: f64 = layout.areas[..columns].iter().sum();
        assert!((whole / roof - 1.0).abs() < area, "{name}: {whole} {roof}");
        for found in gaps(&state.middle[..columns]) {
            assert!((gap[0]..=gap[1]).contains(&(found / spacing)), "{name}: {}", found / spacing);
        }
        // The free edge, a straight one of length 2.5, and nothing else.
        let edge = &state.middle[columns..];
        assert!(edge.len() as f64 * spacing > 2.4 && edge.len() < 60, "{name}: {}", edge.len());
        let at = Vec3::from(edge[0]);
        let straight =
            |x: &[f64; 3]| (Vec3::from(*x) - at).xz().norm().min((Vec3::from(*x) - at).xy().norm());
        assert!(edge.iter().all(|x| straight(x) < 1e-12), "{name}");
    }
}

/// A pressure on the points of a face pushes like a pressure on the cells.
#[test]
fn pressure_on_points_is_pressure_on_the_shell() {
    for faces in [WetFaces::Front, WetFaces::Back] {
        let mut shell = wet(tube(60, 1.0, 0.1), &Wetting { plane: true, faces, rows: 3, ..wetting(0.011) });
        let (state, areas) = (boundary(&shell), shell.boundary_layout().areas.clone());
        let columns = state.middle.len();
        let forces: Vec<[f64; 3]> =
            (0..3 * columns).map(|p| state.normals[p % columns].map(|n| n * 2.0 * areas[p] / 3.0)).collect();
        let rows = on_particles(&mut shell, &forces, &vec![[0.0; 3]; forces.len()], 0.0);
        let share = 2.0 * 2.0 * libm::sin(PI / 60.0) * 0.1 * 0.5;
        for (a, row) in rows.iter().enumerate() {
            let out = Vec3::new(row[0], row[1], row[2]).dot(&shell.director(a));
            assert!((out / share - 1.0).abs() < 0.02, "{out} {share}");
        }
    }
}

#[test]
fn what_moves_against_the_fluid_is_resisted_on_loaded_faces() {
    let mut shell = wet(strip([11, 2], 1.0, 0.2), &Wetting { plane: true, ..wetting(0.1) });
    let points = shell.boundary_layout().points;
    let (velocity, z) = (Vec3::new(0.7, 0.3, 0.0), 5.0);
    (0..shell.len()).for_each(|a| shell.set_rate(a, velocity, Vec3::zeros()));
    let seen = vec![[0.1, 0.05, 0.0]; points];
    let front = |f: f64| -> Vec<[f64; 3]> {
        (0..points).map(|p| [if p < points / 2 { f } else { 0.0 }, 0.0, 0.0]).collect()
    };
    let total = |rows: Vec<[f64; 6]>| rows.iter().fold([0.0; 6], |s, r| std::array::from_fn(|k| s[k] + r[k]));
    // One face of area 1 × .2, which yields along its normal alone, ±y.
    let loaded = total(on_particles(&mut shell, &front(1e-9), &seen, z));
    assert!((loaded[1] + z * 0.2 * 0.25).abs() < 1e-12 && loaded[0].abs() < 1e-7, "{loaded:?}");
    let both = total(on_particles(&mut shell, &vec![[1e-9, 0.0, 0.0]; points], &seen, z));
    assert!((both[1] - 2.0 * loaded[1]).abs() < 1e-12);
    // What the fluid takes back, per depth: the force by the span, half of it at the first row below each face.
    let mut impulses = vec![[0.0; 3]; points];
    shell.impedance_impulses(0.5, &mut impulses);
    let sums =
        [&impulses[..points / 2], &impulses[points / 2..]].map(|face| face.iter().map(|j| j[1]).sum::<f64>());
    assert!(sums.iter().all(|sum| (sum - 0.25 * both[1] / 0.2).abs() < 1e-9), "{sums:?} {both:?}");
    // Dry faces, and what moves as the fluid saw it, are left alone.
    let dry = total(on_particles(&mut shell, &front(0.0), &seen, z));
    let followed = total(on_particles(&mut shell, &front(1.0), &vec![velocity.into(); points], z));
    assert!(dry == [0.0; 6] && followed[1].abs() < 1e-12);
}

#[test]
fn what_cannot_be_wetted_is_refused() {
    let refused = |cloud: Cloud, wetting: Wetting| {
        Shell::builder(parts(cloud, CELLS, THICKNESS)).wetted(wetting).build().err().unwrap()
    };
    let plane = || Wetting { plane: true, ..wetting(0.1) };
    for spacing in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(refused(flat([3, 3], [1.0, 1.0]), wetting(spacing)), ShellError::WetSpacing(_)));
    }
    let found = refused(flat([3, 3], [1.0, 1.0]), Wetting { rows: 0, ..wetting(0.1) });
    assert!(found.to_string().contains("at least one"), "{found}");
    let found = refused(flat([3, 3], [1.0, 1.0]), Wetting { free_edges: vec![9], ..wetting(0.1) });
    assert!(found.to_string().contains("names particle 9, but the cloud has 9"), "{found}");
    let found = refused(flat([3, 3], [1.0, 1.0]), plane());
    assert!(found.to_string().contains("a strip along z of one width"), "{found}");
    let mut tapered = strip([5, 2], 1.0, 0.2);
    tapered.positions[3].z *= 1.1;
    let tapered = Cloud::from_cells(tapered.positions, None, tapered.cells).unwrap();
    assert!(matches!(refused(tapered, plane()), ShellError::NotAStrip { particle: 2 | 3, .. }));
    let middle = Wetting { free_edges: vec![4, 5], ..plane() };
    assert!(matches!(refused(strip([5, 2], 1.0, 0.2), middle), ShellError::NotAnEdge(_)));
    let dry = free_shell(flat([3, 3], [1.0, 1.0]), CELLS, THICKNESS);
    assert!(
        dry.boundary_layout().points == 0 && boundary(&dry).points.is_empty() && velocities(&dry).is_empty()
    );
}
