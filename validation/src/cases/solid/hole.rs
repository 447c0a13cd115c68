//! plate-with-hole: plane stress, the displacements of Kirsch's solution on an outer layer one horizon deep, a square of ten
//! radii.

use std::error::Error;
use std::time::Instant;

use benchmarks_ref::kirsch::Hole;
use implicit_statics::{Equilibrium, linear_response};
use peridynamics::{Correction, Elastic, Law, Space};
use sph_core::{CutOut, Vec3};

use crate::judge::{Case, Headline, Lattices, Outcome, Run, Runs, Variant};
use crate::methods::{PAIRWISE, STATE};
use crate::support::solids::{formulation, found, lattice, moved, nodes, parts, system};
use crate::{JudgeError, Metric};

const YOUNG: f64 = 200e9;
const RADIUS: f64 = 1.0;
/// Remote stress over E.
const STRAIN: f64 = 1e-6;

const ERROR: &str = "displacement";
const STRAIN_THERE: &str = "hoop strain of the first row over exact";

/// The plate, its closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "plate-with-hole",
        title: "Plate with a round hole in tension",
        about: "L2 error of the displacement farther than a horizon from the hole, 5 and 10 spacings a radius. The strain of \
                the first row is shown: a family cut by a curved face is corrected for uniform strains only, and small \
                horizons are the better ones at a hole.",
        citation: "Kirsch 1898; Timoshenko and Goodier 1951",
        variants: variants(),
        headline: Some(Headline::new(ERROR, 0.2)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for (method, law) in [(PAIRWISE, Law::BondBased), (STATE, Law::StateBased)] {
        for (horizon, resolution) in [(3.015, 5), (3.015, 10), (1.5, 5), (1.5, 10)] {
            let grid = format!("R/Δx {resolution}, δ/Δx {horizon}");
            let plate = move |resolution: usize| {
                holed(law, Correction::Even, horizon, resolution).map_err(|e| e.to_string())
            };
            let bound = if resolution == 5 { 2.0 } else { 1.0 };
            let judged = move |run: &Run, _: &Runs| -> Result<Vec<Metric>, JudgeError> {
                Ok(vec![
                    Metric::error(ERROR, run.last(ERROR)?.map(|part| 100.0 * part), "%")
                        .within(bound, "of first order in the horizon; two and one percent are asked"),
                    Metric::compared(STRAIN_THERE, run.last(STRAIN_THERE)?, "-", 1.0)
                        .shown("three or four nodes inside the horizon see the curved face"),
                ])
            };
            variants.push(
                Variant::study_on(method, &grid, Lattices::of(resolution, plate))
                    .quick_if(resolution == 5)
                    .judged(judged),
            );
        }
    }
    variants
}

/// The plate with so many spacings a radius.
///
/// # Errors
/// A body or a system that is refused.
fn holed(
    law: Law,
    correction: Correction,
    horizon: f64,
    resolution: usize,
) -> Result<Outcome, Box<dyn Error>> {
    let started = Instant::now();
    let dx = RADIUS / resolution as f64;
    let poisson = if law == Law::BondBased { 1.0 / 3.0 } else { 0.3 };
    let material = Elastic { young: YOUNG, poisson, density: 7850.0 };
    let (side, delta) = (10.0 * RADIUS, horizon * dx);
    let corner = Vec3::new(-0.5 * side, -0.5 * side, 0.0);
    let disc = CutOut::Ball { centre: Vec3::zeros(), radius: RADIUS };
    let block = lattice(2, corner, [side, side, 1.0], dx).block()?.without(&[disc]);
    let outer = nodes(&block, |x| x.x.abs().max(x.y.abs()) > 0.5 * side - delta);
    let mut formulation = formulation(Space::PlaneStress, law, correction);
    formulation.horizon = horizon;
    let mut parts = parts(block.clone(), material, formulation);
    for &node in &outer {
        let u = kirsch(&block.positions[node as usize], poisson);
        for axis in [Vec3::x(), Vec3::y()] {
            parts.supports.push(moved(vec![node], axis, u.dot(&axis)));
        }
    }
    let mut system = system(parts)?;
    let answer = linear_response(&mut system, 0.0)?;
    system.update(&answer);
    system.evaluate(1.0);
    let u = |node: usize| system.solid().displacement(node);
    let (mut error, mut size) = (0.0, 0.0);
    for (node, x) in block.positions.iter().enumerate() {
        if x.norm() > RADIUS + delta && x.x.abs().max(x.y.abs()) <= 0.5 * side - delta {
            let exact = kirsch(x, poisson);
            error += (u(node) - exact).norm_squared();
            size += exact.norm_squared();
        }
    }
    let first = block.positions.iter().filter(|x| x.x.abs() < 0.6 * dx && x.y > 0.0);
    let y = first.fold(f64::INFINITY, |least, x| least.min(x.y));
    let pair = nodes(&block, |x| x.x.abs() < 0.6 * dx && (x.y - y).abs() < 0.1 * dx);
    let [left, right] = pair[..] else { return Err("the hole lies between two columns".into()) };
    let [left, right] = [left as usize, right as usize];
    let [from, to] = [&block.positions[left], &block.positions[right]];
    let strain = (u(right) - u(left)).x / (kirsch(to, poisson) - kirsch(from, poisson)).x;
    Ok(found(system.solid(), started, &[(ERROR, (error / size).sqrt()), (STRAIN_THERE, strain)]))
}

/// Kirsch's displacement of the plate under tension along x.
fn kirsch(x: &Vec3, poisson: f64) -> Vec3 {
    let hole = Hole { young: YOUNG, poisson, radius: RADIUS, tension: STRAIN * YOUNG };
    let [along, across] = hole.displacement([x.x, x.y]);
    Vec3::new(along, across, 0.0)
}
