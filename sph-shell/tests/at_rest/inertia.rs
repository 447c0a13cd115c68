//! Inertia of shells that turn as a whole: plates on springs, whole bodies, free plates, strips; rigid sets.

use crate::common::{self, disordered_flat, flat, free_shell, parts, scattered_flat};
use explicit_dynamics::Transient;
use implicit_statics::{natural_modes, unwatched};
use sph_core::{Cloud, Vec3};
use sph_shell::{Formulation, Reach, RigidLoad, RigidSet, Shell, Spring, StaticShell};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

/// Eigenvalues of the lowest modes.
fn lowest(body: Shell, count: usize, shift: f64) -> Vec<f64> {
    let mut system = StaticShell::new(body);
    let found = natural_modes(&mut system, 0.0, count, shift, &mut unwatched).unwrap().modes;
    found.iter().map(|mode| mode.eigenvalue).collect()
}

/// A free plate on springs along all axes at its corners, far softer than itself: it rolls about either axis by `k L²/(m (L² + t²)/12)` and
/// spins about its normal by `12 k/m`. Errors of the three frequencies.
fn rolls(cloud: Cloud, lengths: [f64; 2], thickness: f64) -> [f64; 3] {
    let corner = |x: f64, y: f64| {
        let at = &cloud.positions;
        let off = |a: &usize| (at[*a] - Vec3::new(x * lengths[0], y * lengths[1], 0.0)).norm();
        let nearest = (0..at.len()).min_by(|a, b| off(a).total_cmp(&off(b))).unwrap();
        assert!(off(&nearest) < 1e-9);
        nearest as u32
    };
    let k = 1e-9;
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| (corner(x, y), k));
    let hold = |direction| Spring { stiffness: corners.to_vec(), direction };
    let springs = vec![hold(Vec3::z()), hold(Vec3::x()), hold(Vec3::y())];
    let body = Shell::builder(parts(cloud, CELL, thickness)).springs(springs).build().unwrap();
    let mass = common::DENSITY * thickness * lengths[0] * lengths[1];
    let mut found = lowest(body, 6, 0.0);
    found.sort_by(f64::total_cmp);
    let thick = |side: f64| side * side / (side * side + thickness * thickness);
    let exact =
        [lengths[1].min(lengths[0]), lengths[0].max(lengths[1])].map(|side| 12.0 * k / mass * thick(side));
    [exact[0], exact[1], 12.0 * k / mass]
        .map(|exact| exact)
        .into_iter()
        .zip(&found[3..])
        .map(|(exact, value)| (value / exact).sqrt() - 1.0)
        .collect::<Vec<_>>()
        .try_into()
        .unwrap()
}

/// Masses at the corners of cells gave a plate of n cells `1 + 2/n²` of its inertia, and its roll −1/n² of its frequency: 1 % of ten.
#[test]
fn a_plate_on_springs_rolls_with_its_own_inertia() {
    for (name, cloud, bound) in [
        ("10 × 6 cells", flat([11, 7], [2.0, 1.0]), 4e-6),
        ("2 × 3 cells", flat([3, 4], [2.0, 1.0]), 4e-6),
        ("uneven", disordered_flat([11, 7], [2.0, 1.0]), 4e-6),
        ("scattered", scattered_flat(0.15, [2.0, 1.0]), 4e-6),
    ] {
        let found = rolls(cloud, [2.0, 1.0], 0.01);
        println!("{name}: {found:?}");
        assert!(found.iter().all(|error| error.abs() < bound), "{name}: {found:?}");
    }
}

/// A completely free square plate, ν = 0.3, `ω a² √(ρt/D)`: 13.468, 19.596, 24.270, 34.801 twice (Leissa 1973, thin).
#[test]
fn a_free_plate_swings_as_its_edges_let_it() {
    let exact = [13.468, 19.596, 24.270, 34.801, 34.801];
    let thickness = 0.005;
    let stiffness =
        common::YOUNG * thickness * thickness / 12.0 / (1.0 - common::POISSON.powi(2)) / common::DENSITY;
    let mut worst = Vec::new();
    for n in [11, 21] {
        let found = lowest(free_shell(flat([n, n], [1.0, 1.0]), CELL, thickness), 11, -10.0 * stiffness);
        let mut values: Vec<f64> = found.iter().map(|v| (v.abs() / stiffness).sqrt()).collect();
        values.sort_by(f64::total_cmp);
        let errors: Vec<f64> = values[6..].iter().zip(exact).map(|(v, e)| v / e - 1.0).collect();
        println!("{n}: {errors:?}");
        worst.push(errors.iter().fold(0.0, |most: f64, error| most.max(error.abs())));
    }
    // Second order in the cell. By masses at the corners 3.9 and 1.07 %.
    assert!(worst[0] < 0.01 && worst[1] < 0.3 * worst[0], "{worst:?}");
}

/// All of a sheet as one body, under a couple.
fn rigid(cloud: Cloud, thickness: f64, couple: Vec3) -> Shell {
    let middle = cloud.positions.iter().sum::<Vec3>() / cloud.len() as f64;
    let loads: Vec<Box<dyn sph_shell::Load>> =
        vec![Box::new(RigidLoad { set: 0, force: Vec3::zeros(), couple })];
    let particles = (0..cloud.len() as u32).collect();
    let body = Shell::builder(common::shell_parts(
        cloud,
        CELL,
        thickness,
        &shell_kinematics::StretchCorrected,
        Vec::new(),
        loads,
    ));
    body.rigid(vec![RigidSet { particles, at: middle, ..RigidSet::default() }]).build().unwrap()
}

/// From rest under a steady couple about an axis the spin is `C T/J`; the directors too turn with the thickness alone. By cells of ten
/// the corners gave 1.02, directors of the size of a cell one percent more.
#[test]
fn a_rigid_plate_flips_with_its_own_inertia() {
    let (thickness, lengths) = (0.01_f64, [2.0_f64, 1.0]);
    let mass = common::DENSITY * thickness * lengths[0] * lengths[1];
    let square = [
        lengths[1].powi(2) + thickness.powi(2),
        lengths[0].powi(2) + thickness.powi(2),
        lengths[0].powi(2) + lengths[1].powi(2),
    ];
    for (name, cloud) in [
        ("10 × 6 cells", flat([11, 7], lengths)),
        ("one cell", flat([2, 2], lengths)),
        ("uneven", disordered_flat([11, 7], lengths)),
    ] {
        for axis in 0..3 {
            let (inertia, duration) = (mass * square[axis] / 12.0, 1.0);
            let couple = 0.6 * inertia;
            let mut body = rigid(cloud.clone(), thickness, Vec3::ith(axis, couple));
            let run = Transient { duration, record_every: 1e-4, damping: 0.0, safety: 0.9 };
            common::records(run, &mut body).unwrap();
            let far =
                |x: &dyn Fn(usize) -> Vec3| (x(body.len() - 1) - x(0)).cross(&Vec3::ith(axis, 1.0)).norm();
            let error =
                far(&|a| body.velocity(a)) / far(&|a| body.reference().cloud.positions[a]) / 0.6 - 1.0;
            println!("{name}, {axis}: {error:.1e}");
            assert!(error.abs() < 1e-4, "{name}, {axis}: {error:.1e}");
        }
    }
}

/// What marches make of a plate of n cells a side: `1 + 2/n²` by its corners, `1/n²` more about its own axes by directors of the size of a
/// cell; about its edge four times as much inertia has the same error. Rigid cells have none, nor has a shell that cannot turn.
#[test]
fn the_error_of_the_inertia_of_marches_is_reported() {
    let (n, thickness) = (10.0_f64, 1e-4);
    let reported = |supports| {
        let cloud = flat([11, 11], [1.0, 1.0]);
        let body =
            common::shell(cloud, CELL, thickness, &shell_kinematics::StretchCorrected, supports, Vec::new());
        body.turning_inertia().unwrap()
    };
    let free = reported(Vec::new());
    assert!((free.whole - 1.0 - 3.0 / (n * n)).abs() < 1e-6 && free.free == Some(free.whole), "{free:?}");
    let edge = |support: fn(Vec<u32>) -> sph_shell::Supported| {
        let sides = flat([11, 11], [1.0, 1.0]).sides.unwrap();
        reported(vec![support(sides.edge(sph_core::Side::U0).to_vec())])
    };
    let hinged = edge(|particles| common::supported(particles, sph_shell::Hinged)).free.unwrap();
    assert!((hinged - 1.0 - 0.75 / (n * n)).abs() < 1e-6, "{hinged}");
    let clamped = edge(|particles| common::supported(particles, sph_shell::Clamped));
    assert!(clamped.free.is_none() && clamped.whole == free.whole, "{clamped:?}");
    let stiff = rigid(flat([11, 11], [1.0, 1.0]), thickness, Vec3::zeros()).turning_inertia().unwrap();
    assert!((stiff.whole - 1.0).abs() < 1e-12, "{stiff:?}");
    // A curved sheet has no error that its chords make.
    let cloud = common::curved([21, 21]);
    let reported = free_shell(cloud, CELL, 0.01).turning_inertia().unwrap();
    // Of 20 cells a side, as of a plate.
    assert!((reported.whole - 1.0075).abs() < 1e-3, "{reported:?}");
}
