//! crease: two plates that meet at an angle: bent across the fold, along it, twisted, and free; against closed forms.

use std::f64::consts::PI;

use coque::{Warning, warnings};
use implicit_statics::{natural_modes, unwatched};
use sph_core::{Cloud, Vec3};
use sph_shell::{Clamped, Held, Load, StaticShell, Supported, SymmetryPlane};

use crate::judge::{Case, Headline, MET, Run, Runs, Variant};
use crate::methods::{NODAL_2, NODAL_3, STATIC, WIDE_14};
use crate::metric_names::ERROR;
use crate::support::meshes::{Mesh, nearest, particles};
use crate::support::sheets::{Answer, MaterialSection, force, linear, shell_of, supported};
use crate::support::studies::{finding, off, or_failed};
use crate::{JudgeError, Metric, Outcome};

/// Angles between the two plates \[°\]; 180 would be flat.
const ANGLES: [f64; 3] = [150.0, 90.0, 30.0];
const YOUNG: f64 = 1e6;
/// Cells from the fold to the edge.
const CELLS: usize = 10;
/// Thickness over the width of a plate, which is one.
const THICKNESS: f64 = 0.01;
/// Modes asked for: six rigid ones, and three in which a zero mode too many would show.
const MODES: usize = 9;

/// The problems, their closed forms, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "crease",
        title: "Two plates that meet at an angle",
        about: "Two plates of width one meet at 150°, 90° and 30°, in a mesh of quadrangles that the reader brings in; beyond a turn of 30° \
                each plate has particles of its own along the fold, tied, and one with the mean of the normals for stencils that \
                reach across. Bent across the fold (two bars, a force at the end), bent along \
                it (angle section under an end moment), twisted (angle section, GJ = ⅔Gbt³), and free (six zero modes and no \
                seventh).",
        citation: "bars by the force method; bending of thin-walled sections; torsion of St Venant",
        variants: variants(),
        headline: Some(Headline::new(ERROR, 0.01)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for problem in [&ACROSS, &ALONG, &TWIST] {
        for (at, angle) in ANGLES.into_iter().enumerate() {
            let fold = Fold::of(angle);
            variants.push(problem.on(fold, "lattice"));
            variants.push(problem.on(fold.jittered(), "jitter 0.25"));
            if problem.name == ACROSS.name {
                for (method, known) in [
                    (WIDE_14, [MET, 4.087, -47.42]),
                    (NODAL_2, [-2.61, -18.03, -73.89]),
                    (NODAL_3, [-5.351, -20.18, -77.75]),
                ] {
                    variants.push(problem.on(Fold { method, ..fold }, "lattice").known(known[at], REACH));
                }
                variants.push(problem.on(Fold { cells: 2 * CELLS, ..fold }, "lattice of 20 cells"));
            }
        }
    }
    for angle in ANGLES {
        let (fold, jittered) = (Fold::of(angle), Fold::of(angle).jittered());
        variants.push(fold.study("free", free, "lattice").judged(modes));
        variants.push(jittered.study("free", free, "jitter 0.25").judged(modes));
    }
    variants
}

/// Zero modes of a free body beyond its rigid ones.
fn modes(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let reason = "a free body has six rigid motions and no other motion without energy";
    Ok(vec![
        Metric::error(ERROR, run.last("beyond six")?, "-").within(0.0, reason),
        Metric::error("first frequency", run.last("first")?, "√(D/ρt)").shown("shown beside"),
    ])
}

const REACH: &str = "stencils wider than a cell reach across the fold and take the particles of the other plate for particles of the plane \
                     at the point";

/// Finds the outcome of a creased plate, or why there is none.
type Study = fn(&Fold) -> Result<Outcome, String>;

/// A problem of a creased plate with one exact displacement.
struct Creased {
    name: &'static str,
    run: Study,
    /// How far off it may be \[%\], and why.
    asked: (f64, &'static str),
}

const ACROSS: Creased = Creased {
    name: "across",
    run: across,
    asked: (2.0, "required of this project: within 2 %; a frame of two bars by ten cells a bar"),
};
const ALONG: Creased = Creased {
    name: "along",
    run: along,
    asked: (
        2.0,
        "one sampling point a cell sees no bending in its plane: (Δ/b)² of the inertia, 1 % with ten cells; twice that for \
         disorder",
    ),
};
const TWIST: Creased = Creased {
    name: "twist",
    run: twist,
    asked: (
        1.5,
        "Kirchhoff's law leaves out the edge layers of shear: torsion of a flat bar, 0.63 t/b for each direction",
    ),
};
impl Creased {
    fn on(&self, fold: Fold, cloud: &str) -> Variant {
        let variant = fold.study(self.name, self.run, cloud);
        variant.off(|run, _| Ok(off(run.last("ratio")?))).asked(self.asked.0, self.asked.1)
    }
}

/// A creased plate.
#[derive(Clone, Copy)]
struct Fold {
    /// Angle between the plates \[°\].
    angle: f64,
    /// Cells from the fold to an edge.
    cells: usize,
    /// Particles inside a plate are moved by up to this part of the spacing.
    jitter: f64,
    method: &'static str,
}

impl Fold {
    /// With particles in rows, and the default method.
    fn of(angle: f64) -> Self {
        Self { angle, cells: CELLS, jitter: 0.0, method: STATIC }
    }

    fn jittered(self) -> Self {
        Self { jitter: 0.25, ..self }
    }

    fn study(self, name: &str, run: Study, cloud: &str) -> Variant {
        let grid = format!("{name} {}° {cloud}", self.angle);
        Variant::study(self.method, &grid, move || Ok(or_failed(run(&self))))
    }

    /// The directions in which the plates leave the fold, which lies along x through the origin, and their normals.
    fn plates(&self) -> [(Vec3, Vec3); 2] {
        let (sin, cos) = libm::sincos(0.5 * self.angle.to_radians());
        let plate = |side: f64| (Vec3::new(0.0, side * sin, -cos), Vec3::new(0.0, side * cos, sin));
        [plate(-1.0), plate(1.0)]
    }

    /// Particles over x from 0 to `length` \[L\]; the flat mesh is moved about before it is bent.
    fn cloud(&self, length: f64) -> Result<Cloud, String> {
        let step = 1.0 / self.cells as f64;
        let columns = (length / step).round() as usize;
        let flat = |u: f64, v: f64| Vec3::new(length * u, 2.0 * v - 1.0, 0.0);
        let stays =
            |x: &Vec3| x.x < 1e-9 || x.x > length - 1e-9 || x.y.abs() > 1.0 - 1e-9 || x.y.abs() < 1e-9;
        let [left, right] = self.plates();
        let bend = |x: &Vec3| Vec3::x() * x.x + if x.y < 0.0 { left.0 * -x.y } else { right.0 * x.y };
        let mesh = Mesh::blocks([columns, 2 * self.cells], &[&flat]);
        let mesh = mesh.jittered(self.jitter * step, 1, stays).mapped(bend);
        if self.method == STATIC { mesh.cloud() } else { mesh.undivided() }
    }

    /// Displacements of all particles under the loads \[L\].
    fn respond(
        &self,
        cloud: &Cloud,
        poisson: f64,
        supports: Vec<Supported>,
        loads: Vec<Box<dyn Load>>,
    ) -> Result<Answer, String> {
        let body = MaterialSection { young: YOUNG, poisson, thickness: THICKNESS, density: 1.0 };
        linear(shell_of(body, cloud.clone(), self.method, supports, loads)?)
    }

    /// A displacement over the exact one, of so many particles.
    fn found(&self, cloud: &Cloud, ratio: f64, warnings: Vec<Warning>) -> Outcome {
        Outcome { warnings, ..finding(cloud.len(), 1.0 / self.cells as f64, &[("ratio", ratio)]) }
    }
}

/// Particles on the place of one: each sheet of a junction has its own.
fn sheets(cloud: &Cloud, a: u32) -> f64 {
    cloud.joined.iter().find(|group| group.contains(&a)).map_or(1.0, |group| group.len() as f64)
}

fn on_fold(x: &Vec3) -> bool {
    x.y.abs() < 1e-9 && x.z.abs() < 1e-9
}

/// Two bars, the first clamped, a unit force across the second at its end; ν = 0, width ½.
///
/// With c and s of the turn from bar to bar: `δ = (4/3 + c + c²/3)/EI + s²/EA + (1 + c²)/κGA`.
fn across(fold: &Fold) -> Result<Outcome, String> {
    let width = 0.5;
    let cloud = fold.cloud(width)?;
    let [left, right] = fold.plates();
    let clamp = particles(&cloud, |x| x.dot(&left.0) > 1.0 - 1e-9);
    let tip = particles(&cloud, |x| x.dot(&right.0) > 1.0 - 1e-9);
    let corner = |a: u32| {
        let x = cloud.positions[a as usize].x;
        x < 1e-9 || x > width - 1e-9
    };
    let shares: Vec<(u32, f64)> = tip.into_iter().map(|a| (a, if corner(a) { 0.5 } else { 1.0 })).collect();
    let whole: f64 = shares.iter().map(|share| share.1).sum();
    let loads = vec![force(shares.clone(), right.1)];
    let Answer { motion, warnings } = fold.respond(&cloud, 0.0, vec![supported(clamp, Clamped)], loads)?;
    let mean = shares.iter().map(|&(a, share)| share * motion[a as usize].dot(&right.1)).sum::<f64>() / whole;
    let (sin, cos) = libm::sincos(PI - fold.angle.to_radians());
    let (area, inertia) = (width * THICKNESS, width * THICKNESS.powi(3) / 12.0);
    let exact = (4.0 / 3.0 + cos + cos * cos / 3.0) / (YOUNG * inertia)
        + sin * sin / (YOUNG * area)
        + (1.0 + cos * cos) / (5.0 / 6.0 * 0.5 * YOUNG * area);
    Ok(fold.found(&cloud, mean / exact, warnings))
}

/// An angle section under an end moment in its plane of symmetry; ν = 0: `w = ML²/2EI` at the fold.
fn along(fold: &Fold) -> Result<Outcome, String> {
    let (length, step) = (3.0, 1.0 / fold.cells as f64);
    let cloud = fold.cloud(length)?;
    let [left, right] = fold.plates();
    let rise = left.0.z;
    let inertia = 2.0 * (THICKNESS * rise.powi(2) + THICKNESS.powi(3) * left.1.z.powi(2)) / 12.0;
    let (mut loads, mut moment) = (Vec::new(), 0.0);
    for a in particles(&cloud, |x| x.x > length - 1e-9) {
        let x = cloud.positions[a as usize] - Vec3::x() * length;
        // Traction as the height over the centroid; an edge hands the value at its middle in halves to its ends.
        let height = x.z - 0.5 * rise;
        let part = match x.norm() {
            r if r < 1e-9 => (height + 0.5 * step * rise) / sheets(&cloud, a),
            r if r > 1.0 - 1e-9 => 0.5 * (height - 0.5 * step * rise),
            _ => height,
        };
        loads.push((a, part));
        moment += part * height;
    }
    let loads = loads.into_iter().map(|(a, part)| force(vec![(a, 1.0)], Vec3::x() * (part / moment)));
    // Beside the symmetry plane only a rigid motion is held, where nothing pulls.
    let foot = nearest(&cloud, Vec3::zeros());
    let held = |displacement| Held { displacement, director: None };
    let supports = vec![
        supported(particles(&cloud, |x| x.x < 1e-9), SymmetryPlane { normal: Vec3::x() }),
        supported(vec![foot], held(vec![Vec3::y(), Vec3::z()])),
        supported(vec![nearest(&cloud, right.0)], held(vec![right.1])),
    ];
    let Answer { motion, warnings } = fold.respond(&cloud, 0.0, supports, loads.collect())?;
    let tip = motion[nearest(&cloud, Vec3::x() * length) as usize].z;
    Ok(fold.found(&cloud, -tip * 2.0 * YOUNG * inertia / (length * length), warnings))
}

/// An angle section twisted by forces at the corners of one end: `w = Fxy/2D(1−ν)` in each plate.
fn twist(fold: &Fold) -> Result<Outcome, String> {
    let (length, poisson) = (2.0, 0.3);
    let cloud = fold.cloud(length)?;
    let seam = particles(&cloud, on_fold);
    let held = |displacement| Held { displacement, director: None };
    let foot = vec![nearest(&cloud, Vec3::zeros())];
    let mut supports =
        vec![supported(seam, held(vec![Vec3::y(), Vec3::z()])), supported(foot, held(vec![Vec3::x()]))];
    let mut loads = Vec::new();
    let [left, right] = fold.plates();
    // One sense of turning about the fold for both.
    for (direction, sense) in [(left.0, left.1), (right.0, -right.1)] {
        supports.push(supported(vec![nearest(&cloud, direction)], held(vec![sense])));
        loads.push(force(vec![(nearest(&cloud, direction + Vec3::x() * length), 1.0)], sense));
    }
    let Answer { motion, warnings } = fold.respond(&cloud, poisson, supports, loads)?;
    let tip = motion[nearest(&cloud, right.0 + Vec3::x() * length) as usize].dot(&-right.1);
    let bending = YOUNG * THICKNESS.powi(3) / (12.0 * (1.0 - poisson * poisson));
    Ok(fold.found(&cloud, tip * 2.0 * bending * (1.0 - poisson) / length, warnings))
}

/// The free creased plate of length one: zero modes beyond six, and the first frequency \[√(D/ρt)\].
fn free(fold: &Fold) -> Result<Outcome, String> {
    let cloud = fold.cloud(1.0)?;
    let body = MaterialSection { young: YOUNG, poisson: 0.3, thickness: THICKNESS, density: 1.0 };
    let shell = shell_of(body, cloud.clone(), fold.method, Vec::new(), Vec::new())?;
    let warnings = warnings(&shell);
    let unit = YOUNG * THICKNESS.powi(2) / (12.0 * 0.91);
    let modes = natural_modes(&mut StaticShell::new(shell), 0.0, MODES, -0.1 * unit, &mut unwatched);
    let modes = modes.map_err(|error| error.to_string())?.modes;
    // The flat plate of 2 × 1 begins at 29 of these units; zero modes are below 1e-8.
    let zero = modes.iter().filter(|mode| mode.eigenvalue < 0.1 * unit).count();
    let first = modes.get(zero).map_or(f64::NAN, |mode| (mode.eigenvalue / unit).sqrt());
    let figures = [("beyond six", zero as f64 - 6.0), ("first", first)];
    Ok(Outcome { warnings, ..finding(cloud.len(), 1.0 / fold.cells as f64, &figures) })
}
