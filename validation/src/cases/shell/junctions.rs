//! junctions: frames, boxes and stiffened plates from meshes whose sheets share nodes where they meet.

use sph_core::{Cloud, Vec3};
use sph_shell::{Clamped, Held};

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::metric_names::ERROR;
use crate::support::meshes::{Mesh, particles};
use crate::support::sheets::{Answer, MaterialSection, force, linear, shell_of, supported};
use crate::support::studies::{finding, off, or_failed};
use crate::{JudgeError, Metric, Outcome};

/// The problems, their references, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "junctions",
        title: "Sheets that meet along a line",
        about: "Meshes in which sheets share nodes; each keeps its own director there, tied to those of the others. A right-angled \
                frame and a stem on a bar against beams, a box in torsion against St Venant, a box whose section is distorted and \
                plates on ribs against fine shells of elements, all linear.",
        citation: "beams in series; T/G(a³t + 4at³/3); eight-node elements S8R of CalculiX, refined until the fourth digit stands",
        variants: variants(),
        each,
        headline: Some(Headline::new(ERROR, 0.01)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let study = |grid: &str, run: fn() -> Result<Outcome, String>| {
        Variant::study(STATIC, grid, move || Ok(or_failed(run())))
    };
    vec![
        study("L, 10 cells a leg", || frame(10)).quick(),
        study("L, 20 cells a leg", || frame(20)),
        study("T, 10 cells a leg", || stem(10)).quick(),
        study("T, 20 cells a leg", || stem(20)),
        study("torsion of a box, 4 a side", || boxed(4, false)).quick(),
        study("torsion of a box, 8 a side", || boxed(8, false)),
        study("distortion of a box, 8 a side", || boxed(8, true)),
        study("distortion of a box, 16 a side", || boxed(16, true)),
        study("plate on a blade, 16×4", || ribbed(16, 4, false)).quick(),
        study("plate on a blade, 32×8", || ribbed(32, 8, false)),
        study("plate on a flange, 32×8", || ribbed(32, 8, true)),
    ]
}

/// Errors of the displacement along the loads; of plates that beside the rib, where it is worse \[%\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[
        ("L, 10 cells a leg", 0.0625), ("L, 20 cells a leg", 0.0156),
        ("T, 10 cells a leg", 0.387), ("T, 20 cells a leg", 0.0967),
        ("torsion of a box, 4 a side", 0.0066), ("torsion of a box, 8 a side", 0.0106),
        ("distortion of a box, 8 a side", 0.632), ("distortion of a box, 16 a side", 0.145),
        ("plate on a blade, 16×4", 1.60), ("plate on a blade, 32×8", 0.37),
        ("plate on a flange, 32×8", 0.55),
    ]),
]);

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let reason = "of second order in the spacing, as that of a sheet by itself";
    let error = off(run.last("ratio")?).map(f64::abs);
    Ok(vec![Metric::error(ERROR, error, "%").near(MEASURED.of(run)?, reason)])
}

/// A flat sheet `origin + s u + t v`, s and t in \[0, 1\], and its cells along u and v.
pub(super) type Part = (Vec3, [Vec3; 2], [usize; 2]);

/// Sheets in one mesh: nodes on one place are one.
pub(super) fn welded(parts: &[Part]) -> Result<Cloud, String> {
    let mut mesh = Mesh::default();
    let mut known = std::collections::BTreeMap::new();
    for &(origin, [u, v], [m, n]) in parts {
        let mut node = |i: usize, j: usize| {
            let place = origin + u * (i as f64 / m as f64) + v * (j as f64 / n as f64);
            let key = [place.x, place.y, place.z].map(|x| (x * 1e7).round() as i64);
            *known.entry(key).or_insert_with(|| {
                mesh.places.push(place);
                mesh.places.len() as u32 - 1
            })
        };
        for (i, j) in (0..m).flat_map(|i| (0..n).map(move |j| (i, j))) {
            mesh.faces.push(vec![node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]);
        }
    }
    mesh.cloud()
}

const X: Vec3 = Vec3::new(1.0, 0.0, 0.0);
const Y: Vec3 = Vec3::new(0.0, 1.0, 0.0);
const Z: Vec3 = Vec3::new(0.0, 0.0, 1.0);

/// Frames: legs of length one, width and thickness \[L\], ν = 0.
const BEAM: MaterialSection = MaterialSection { young: 1e6, poisson: 0.0, thickness: 0.01, density: 1.0 };
const WIDE: f64 = 0.3;

/// Flexibilities of a frame's leg: of bending `1/EI`, of stretch `1/EA` and of shear `6/5GA`.
fn flexibilities() -> [f64; 3] {
    let MaterialSection { young, thickness, .. } = BEAM;
    let area = WIDE * thickness;
    [12.0 / (young * area * thickness * thickness), 1.0 / (young * area), 12.0 / (5.0 * young * area)]
}

/// Shares of a line of particles by their length along y.
fn shares(cloud: &Cloud, line: Vec<u32>) -> Vec<(u32, f64)> {
    let end = |a: u32| {
        let y = cloud.positions[a as usize].y;
        !(1e-9..=WIDE - 1e-9).contains(&y)
    };
    line.into_iter().map(|a| (a, if end(a) { 0.5 } else { 1.0 })).collect()
}

/// Mean displacement along a direction by shares.
fn along(Answer { motion, .. }: &Answer, shares: &[(u32, f64)], direction: Vec3) -> f64 {
    let whole: f64 = shares.iter().map(|share| share.1).sum();
    shares.iter().map(|&(a, share)| share * motion[a as usize].dot(&direction)).sum::<f64>() / whole
}

fn found(cloud: &Cloud, ratio: f64, answer: Answer) -> Outcome {
    Outcome { warnings: answer.warnings, ..finding(cloud.len(), cloud.spacing(), &[("ratio", ratio)]) }
}

/// A right-angled frame, clamped at one end, a unit force across the far leg: `δ = 4/3EI + 1/EA + 6/5GA`.
fn frame(n: usize) -> Result<Outcome, String> {
    let cloud = welded(&[(Vec3::zeros(), [X, Y * WIDE], [n, 2]), (X, [Z, Y * WIDE], [n, 2])])?;
    let tip = shares(&cloud, particles(&cloud, |x| x.z > 1.0 - 1e-9));
    let clamp = supported(particles(&cloud, |x| x.x < 1e-9), Clamped);
    let shell = shell_of(BEAM, cloud.clone(), STATIC, vec![clamp], vec![force(tip.clone(), -X)])?;
    let answer = linear(shell)?;
    let [bending, stretch, shear] = flexibilities();
    let exact = 4.0 / 3.0 * bending + stretch + shear;
    Ok(found(&cloud, along(&answer, &tip, -X) / exact, answer))
}

/// A stem on a bar that is clamped at both ends: the halves of the bar bear the couple of the joint.
fn stem(n: usize) -> Result<Outcome, String> {
    let bar = (-X, [X * 2.0, Y * WIDE], [2 * n, 2]);
    let cloud = welded(&[bar, (Vec3::zeros(), [Z, Y * WIDE], [n, 2])])?;
    let tip = shares(&cloud, particles(&cloud, |x| x.z > 1.0 - 1e-9));
    let clamp = supported(particles(&cloud, |x| x.x.abs() > 1.0 - 1e-9), Clamped);
    let shell = shell_of(BEAM, cloud.clone(), STATIC, vec![clamp], vec![force(tip.clone(), X)])?;
    let answer = linear(shell)?;
    let [bending, stretch, shear] = flexibilities();
    // A couple ½ at the held end of each half: V from w = 0, then the turn.
    let hold = 0.25 * bending / (bending / 3.0 + shear);
    let turn = 0.5 * bending * (1.0 - hold);
    let exact = bending / 3.0 + shear + turn + 0.5 * stretch;
    Ok(found(&cloud, along(&answer, &tip, X) / exact, answer))
}

/// A box of section one by one, five long, a unit torque at its free end: from all walls, or from two webs, which distorts it.
fn boxed(n: usize, distorted: bool) -> Result<Outcome, String> {
    let body = MaterialSection { young: 1e6, poisson: 0.3, thickness: 0.05, density: 1.0 };
    let corner = -(X + Z) * 0.5;
    let wall = |origin: Vec3, across: Vec3| (origin, [across, Y * 5.0], [n, 5 * n]);
    let walls = [wall(corner, X), wall(corner + Z, X), wall(corner, Z), wall(corner + X, Z)];
    let cloud = welded(&walls)?;
    // Outward normal of each wall and the direction of its force; four with a quarter of the torque, two with a half.
    let sides = [(X, -Z), (-X, Z), (Z, X), (-Z, -X)];
    let (sides, each) = if distorted { (&sides[..2], 1.0) } else { (&sides[..], 0.5) };
    let on_corner = |x: &Vec3| x.x.abs() > 0.5 - 1e-9 && x.z.abs() > 0.5 - 1e-9;
    let (mut loads, mut shared) = (Vec::new(), Vec::new());
    for &(out, direction) in sides {
        let edge = particles(&cloud, |x| x.y > 5.0 - 1e-9 && x.dot(&out) > 0.5 - 1e-9);
        // Two sheets stand at a corner, each with half of its half cell.
        let share = |a: u32| if on_corner(&cloud.positions[a as usize]) { 0.25 } else { 1.0 };
        let shares: Vec<(u32, f64)> = edge.into_iter().map(|a| (a, share(a))).collect();
        loads.push(force(shares.clone(), direction * each));
        shared.push((shares, direction));
    }
    let foot = particles(&cloud, |x| x.y < 1e-9);
    let held = |displacement| Held { displacement, director: None };
    let supports = if distorted {
        vec![supported(foot, Clamped)]
    } else {
        // Three corners keep the foot in its plane: a square box does not warp.
        let three = particles(&cloud, |x| x.y < 1e-9 && on_corner(x) && x.x + x.z < 0.5);
        vec![supported(foot, held(vec![X, Z])), supported(three, held(vec![Y]))]
    };
    let answer = linear(shell_of(body, cloud.clone(), STATIC, supports, loads)?)?;
    let work: f64 = shared.iter().map(|(shares, direction)| each * along(&answer, shares, *direction)).sum();
    let t = body.thickness;
    let torsion = 5.0 * 2.0 * (1.0 + body.poisson) / (body.young * (t + 4.0 * t.powi(3) / 3.0));
    // S8R, extrapolated.
    let exact = if distorted { 1.786e-3 } else { torsion };
    Ok(found(&cloud, work / exact, answer))
}

/// A square plate under pressure, its edges held across, on a rib along its middle: the deflection a quarter of the width aside.
fn ribbed(n: usize, m: usize, flange: bool) -> Result<Outcome, String> {
    let body = MaterialSection { young: 2e11, poisson: 0.3, thickness: 0.01, density: 1.0 };
    let mut parts = vec![(Vec3::zeros(), [X, Y], [n, n]), (Y * 0.5, [X, -Z * 0.1], [n, m])];
    if flange {
        parts.push((Y * 0.47 - Z * 0.1, [X, Y * 0.06], [n, 4]));
    }
    let cloud = welded(&parts)?;
    let edge = particles(&cloud, |x| x.z.abs() < 1e-9 && (x.x.min(x.y) < 1e-9 || x.x.max(x.y) > 1.0 - 1e-9));
    let one = |x: f64, y: f64| particles(&cloud, |p| (p - X * x - Y * y).norm() < 1e-9);
    let held = |displacement| Held { displacement, director: None };
    let supports = vec![
        supported(edge, held(vec![Z])),
        supported(one(0.0, 0.0), held(vec![X, Y])),
        supported(one(1.0, 0.0), held(vec![Y])),
    ];
    // A quarter of every cell of the plate on each of its corners.
    let mut shares = vec![0.0; cloud.len()];
    let on_plate = |a: &u32| cloud.positions[*a as usize].z.abs() < 1e-9;
    for cell in cloud.cells.iter().filter(|cell| cell.particles().iter().all(on_plate)) {
        cell.particles().iter().for_each(|&a| shares[a as usize] += 0.25);
    }
    let shares = (0..).zip(shares).filter(|share| share.1 > 0.0).collect();
    let answer = linear(shell_of(body, cloud.clone(), STATIC, supports, vec![force(shares, -Z * 1e4)])?)?;
    let aside = one(0.5, 0.25).into_iter().map(|a| (a, 1.0)).collect::<Vec<_>>();
    // S8R, extrapolated.
    let exact = if flange { 2.130e-4 } else { 2.638e-4 };
    Ok(found(&cloud, along(&answer, &aside, -Z) / exact, answer))
}
