//! unstructured: plates, hemispheres and closed caps on meshes without a lattice: triangles, blocks, slivers, poles.

use std::ops::ControlFlow;

use coque::doubts;
use explicit_dynamics::{Damping, LevelReached, Observer, QuasiStatic, Record};
use sph_core::{Cloud, Vec3};
use sph_shell::{Clamped, Held, Pressure, Shell, SymmetryPlane};

use super::common::{ERROR, Miss, NODAL, UNEVEN, asked, finding, last, off, or_failed};
use super::meshes::{Mesh, nearest, octant, particles, poled_octant};
use super::sheets::{Answer, Matter, force, linear, shell_of, supported};
use crate::case::{Case, Headline, Run, Variant};
use crate::cases::dial::{CELL, NODAL_2, NODAL_3, STATIC, WIDE_14};
use crate::cases::hemisphere::BRICKS;
use crate::outcome::Outcome;
use crate::{JudgeError, Metric};

/// Thickness over side, and central deflection of the clamped plate in q a⁴/D (`plate_static_square`).
const PLATES: [(f64, f64); 2] = [(0.01, 0.00126785), (1e-4, 0.00126534)];
/// Displacement under a force of the hemisphere without hole \[macneal1985\]: 0.0924.
const WHOLE: f64 = 0.0924;

/// Makes a mesh, if the cloud behind it can be made.
type Maker = fn() -> Result<Mesh, String>;

/// The meshes of the square, each with about as many particles as the lattice of 21×21.
#[rustfmt::skip] // one line a mesh
const MESHES: [(&str, Maker); 9] = [
    ("blocks, 3 in the middle", || Ok(Mesh::star(3, 11))),
    ("blocks, 5 in the middle", || Ok(Mesh::star(5, 9))),
    ("rows of triangles", || Ok(Mesh::rows_of_triangles(20))),
    ("crossed triangles", || Ok(Mesh::crossed(14))),
    ("cut blocks", || Ok(Mesh::star(3, 11).triangles())),
    ("smoothed Poisson triangles", || smoothed(1)),
    ("smoothed Poisson triangles #2", || smoothed(2)),
    ("zigzag of 20°", || Ok(Mesh::zigzag(20, 20.0))),
    ("zigzag of 10°", || Ok(Mesh::zigzag(20, 10.0))),
];

/// The problems, their references, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "unstructured",
        title: "Meshes without a lattice",
        about: "Meshes that the reader brings in: blocks round a node of three or five cells, rows of triangles, squares cut \
                crosswise, triangles of a scattered and smoothed cloud, rows that zigzag until corners are of 20° and 10°, cells of \
                1:20. The clamped plate and the hemisphere with a hole on each; the whole hemisphere and a closed cap under \
                pressure on an octant of three blocks without a pole and on one with triangles round a pole.",
        citation: "Timoshenko and Woinowsky-Krieger 1959; MacNeal and Harder 1985, bricks; equilibrium of a stretched sphere",
        variants: variants(),
        each,
        together: |_| Ok(Vec::new()),
        headline: Some(Headline { metric: ERROR, floor: 0.01, published: || Ok(Vec::new()) }),
        figures: |_| Ok(Vec::new()),
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    let mut add = |method: &'static str, grid: &str, run: Box<Study>| {
        variants.push(Variant::study(method, grid, move || Ok(or_failed(run(method)))));
    };
    for (name, mesh) in MESHES {
        for (thickness, _) in PLATES {
            let grid = format!("plate {name} h/a {thickness}");
            add(STATIC, &grid, Box::new(move |method| plate(method, &mesh()?, thickness)));
        }
        let grid = format!("hemisphere {name}");
        add(STATIC, &grid, Box::new(move |method| belt(method, &mesh()?)));
    }
    let (name, mesh) = MESHES[0];
    for method in [WIDE_14, NODAL_2, NODAL_3] {
        let grid = format!("plate {name} h/a 0.01");
        add(method, &grid, Box::new(move |method| plate(method, &mesh()?, 0.01)));
    }
    add(WIDE_14, &format!("hemisphere {name}"), Box::new(move |method| belt(method, &mesh()?)));
    for (thickness, _) in PLATES {
        let grid = format!("plate rectangles of 1:20 h/a {thickness}");
        add(STATIC, &grid, Box::new(move |method| plate(method, &Mesh::square([10, 200]), thickness)));
    }
    for (name, mesh) in OCTANTS {
        add(STATIC, &format!("whole hemisphere {name}"), Box::new(move |method| whole(method, &mesh())));
        if !name.ends_with("20 triangles") {
            add(CELL, &format!("closed cap {name}"), Box::new(move |method| blown_up(method, &mesh())));
        }
    }
    variants
}

/// What a method finds on a mesh.
type Study = dyn Fn(&str) -> Result<Outcome, String> + Send + Sync;

/// Makes an octant of a sphere.
type Octant = fn() -> Mesh;

/// Meshes of an eighth of a sphere; triangles of 90°/16 = 5.6° round the pole, and of 4.5°, which are refused.
const OCTANTS: [(&str, Octant); 3] = [
    ("three blocks", || octant(11)),
    ("pole of 16 triangles", || poled_octant(16)),
    ("pole of 20 triangles", || poled_octant(20)),
];

/// A scattered cloud whose particles inside have been moved to the mean of their neighbours, as triangles.
fn smoothed(seed: u64) -> Result<Mesh, String> {
    let plate = sph_core::Plate { lengths: [1.0, 1.0] };
    let cloud = sph_core::poisson_cloud(&plate, 0.05, seed).map_err(|error| error.to_string())?;
    Ok(Mesh::of(&cloud).triangles().smoothed(10))
}

/// The clamped plate of bending stiffness one under a unit pressure, in bending alone.
fn plate(method: &str, mesh: &Mesh, thickness: f64) -> Result<Outcome, String> {
    let cloud = mesh.cloud()?;
    let young = 10.92 / thickness.powi(3);
    let matter = Matter { young, poisson: 0.3, thickness, density: 1.0 };
    let on_edge = |x: &Vec3| [x.x, x.y].iter().any(|x| *x < 1e-9 || *x > 1.0 - 1e-9);
    let plane = Held { displacement: vec![Vec3::x(), Vec3::y()], director: None };
    let supports =
        vec![supported(particles(&cloud, |_| true), plane), supported(particles(&cloud, on_edge), Clamped)];
    let middle = nearest(&cloud, Vec3::new(0.5, 0.5, 0.0));
    let at = cloud.positions[middle as usize] - Vec3::new(0.5, 0.5, 0.0);
    let pressure = Pressure { value: 1.0, follower: false };
    let Answer { motion, warnings } =
        linear(shell_of(matter, cloud.clone(), method, supports, vec![Box::new(pressure)])?)?;
    // A particle beside the centre lies lower on the bowl, as in the case disorder.
    let bowl = 1.0 - 7.02 * at.norm_squared();
    let exact = PLATES.iter().find(|(known, _)| *known == thickness).map_or(f64::NAN, |plate| plate.1);
    Ok(Outcome { warnings, ..found(&cloud, motion[middle as usize].z / bowl / exact) })
}

/// The hemisphere with a hole, a quarter; the unit square laid over its angles.
fn belt(method: &str, mesh: &Mesh) -> Result<Outcome, String> {
    let place = |x: &Vec3| {
        let (polar, azimuth) = ((18.0 + 72.0 * x.x).to_radians(), 90.0_f64.to_radians() * x.y);
        Vec3::new(polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin(), polar.cos())
    };
    let cloud = mesh.clone().mapped(place).with_normals(|x| *x).mapped(|x| x * 10.0).cloud()?;
    pinched(method, cloud, BRICKS)
}

/// The hemisphere without hole, a quarter.
fn whole(method: &str, mesh: &Mesh) -> Result<Outcome, String> {
    pinched(method, mesh.clone().mapped(|x| x * 10.0).cloud()?, WHOLE)
}

/// Unit forces out along x and in along y at the equator; the mean of the two displacements over the exact one.
fn pinched(method: &str, cloud: Cloud, exact: f64) -> Result<Outcome, String> {
    let matter = Matter { young: 6.825e7, poisson: 0.3, thickness: 0.04, density: 1.0 };
    let cut = |normal: Vec3| {
        supported(particles(&cloud, |x| x.dot(&normal).abs() < 1e-6), SymmetryPlane { normal })
    };
    let (out, inward) = (nearest(&cloud, Vec3::x() * 10.0), nearest(&cloud, Vec3::y() * 10.0));
    let foot = Held { displacement: vec![Vec3::z()], director: None };
    let supports = vec![cut(Vec3::x()), cut(Vec3::y()), supported(vec![out], foot)];
    let loads = vec![force(vec![(out, 1.0)], Vec3::x()), force(vec![(inward, 1.0)], -Vec3::y())];
    let Answer { motion, warnings } = linear(shell_of(matter, cloud.clone(), method, supports, loads)?)?;
    let mean = 0.5 * (motion[out as usize].x - motion[inward as usize].y);
    Ok(Outcome { warnings, ..found(&cloud, mean / exact) })
}

/// A closed sphere under a pressure that follows, marched to rest; `λ² − 1 = (1−ν) pRλ/Et` with pR/Et = 0.1.
fn blown_up(method: &str, mesh: &Mesh) -> Result<Outcome, String> {
    let cloud = mesh.cloud()?;
    let matter = Matter { young: 1e6, poisson: 0.3, thickness: 0.01, density: 1.0 };
    let axes = [Vec3::x(), Vec3::y(), Vec3::z()];
    let cut = |normal: Vec3| {
        supported(particles(&cloud, |x| x.dot(&normal).abs() < 1e-6), SymmetryPlane { normal })
    };
    let pressure = Pressure { value: 1000.0, follower: true };
    let mut shell = shell_of(matter, cloud.clone(), method, axes.map(cut).into(), vec![Box::new(pressure)])?;
    let warnings = doubts(&shell);
    // What scenes do if they say nothing; the period is the time sound takes round the sphere, 2πR/c.
    let run = QuasiStatic {
        levels: vec![0.5, 1.0],
        period: 0.006,
        ramp: 1.0,
        dwell: 8.0,
        damping: Damping::Ratio(1.0),
        tolerance: 1e-8,
        accuracy: 5e-3,
        safety: 0.8,
    };
    let mut rest = Rest(true);
    let clock = run.march(&mut shell, &mut rest).map_err(|error| error.to_string())?;
    if !rest.0 {
        return Err("still moving at the end of a hold".into());
    }
    let half: f64 = 0.5 * 0.7 * 0.1;
    let stretch = half + (1.0 + half * half).sqrt();
    let grown = (0..shell.len()).map(|a| shell.displacement(a).dot(&cloud.positions[a]) / (stretch - 1.0));
    let (low, high) = grown.fold((f64::INFINITY, 0.0_f64), |(low, high), w| (low.min(w), high.max(w)));
    // The worst particle, poles and corners of blocks included.
    let worst = if (high - 1.0).abs() > (low - 1.0).abs() { high } else { low };
    Ok(Outcome { steps: clock.steps, warnings, ..found(&cloud, worst) })
}

/// Whether every level came to rest.
struct Rest(bool);

impl Observer<Shell> for Rest {
    fn record(&mut self, _: &mut Shell, _: &Record) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn level(&mut self, reached: &LevelReached) {
        self.0 &= reached.settled;
    }
}

fn found(cloud: &Cloud, ratio: f64) -> Outcome {
    finding(cloud.len(), cloud.spacing(), &[("ratio", ratio)])
}

/// What is asked \[%\], and why.
fn bound(grid: &str) -> (f64, &'static str) {
    match grid {
        _ if grid.starts_with("plate rectangles") => (0.5, "asked: plates within half a percent"),
        _ if grid.starts_with("plate") => {
            (1.0, "asked: half a percent of lattices at 21², twice that of disorder")
        }
        _ if grid.starts_with("hemisphere") => (1.5, "asked: 1 % at 21², half more for uneven spacings"),
        _ if grid.starts_with("whole") => (1.5, "the published value has three digits; 1 % as with a hole"),
        _ => (2.2, "chords in two directions cut .0008 of the radius, w/R = .036, as in the case loads"),
    }
}

/// Why a method misses what is asked.
fn cause(run: &Run) -> &'static str {
    let grid = run.variant.grid.as_str();
    match run.variant.method.as_str() {
        NODAL_2 | NODAL_3 => NODAL,
        WIDE_14 if run.done() => {
            "the kernel reaches other particles than those of the cell, as in the case disorder"
        }
        WIDE_14 => {
            "the conditions of a consistent divergence contradict each other on a curved disordered cloud: refused, with the \
             advice to use cells"
        }
        _ if grid.ends_with("20 triangles") => {
            "corners of 4.5°, less than the 5° that cells need: refused, with face and bound; strains would be sampled along one line"
        }
        _ if grid.starts_with("closed") => {
            "triangles hand the pressure to their corners in thirds, ⅓pπΔ² to the pole, where flat facets of slope Δ/2R under N = pR/2 \
             bear ¼pπΔ²: the pole alone moves out until bending bears the rest"
        }
        _ if grid.starts_with("hemisphere") => UNEVEN,
        _ => {
            "sharp cells are long cells: the error grows about as the square of the slanted edge, alike for both thicknesses, \
             so that it is no shear locking. Not isolated further"
        }
    }
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let error = if run.done() { off(last(run, "ratio")?) } else { None };
    Ok(asked(run, error, bound(&run.variant.grid), &MISSES, cause(run)))
}

/// Runs that miss what is asked.
#[rustfmt::skip]
const MISSES: [Miss; 16] = [
    (STATIC, "hemisphere blocks, 3 in the middle", -3.064),
    (STATIC, "hemisphere rows of triangles", -2.563),
    (STATIC, "hemisphere crossed triangles", -1.818),
    (STATIC, "hemisphere cut blocks", -1.871),
    (STATIC, "plate zigzag of 20° h/a 0.01", -6.992),
    (STATIC, "plate zigzag of 20° h/a 0.0001", -7.023),
    (STATIC, "hemisphere zigzag of 20°", -39.76),
    (STATIC, "plate zigzag of 10° h/a 0.01", -26.85),
    (STATIC, "plate zigzag of 10° h/a 0.0001", -26.94),
    (STATIC, "hemisphere zigzag of 10°", -83.48),
    (WIDE_14, "plate blocks, 3 in the middle h/a 0.01", 1.388),
    (NODAL_2, "plate blocks, 3 in the middle h/a 0.01", 12.19),
    (NODAL_3, "plate blocks, 3 in the middle h/a 0.01", -2.636),
    (WIDE_14, "hemisphere blocks, 3 in the middle", f64::NAN),
    (CELL, "closed cap pole of 16 triangles", 10.02),
    (STATIC, "whole hemisphere pole of 20 triangles", f64::NAN),
];
