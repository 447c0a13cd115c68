//! solid-tension: bars in tension with horizons, Poisson's ratios and nodes that are hard on bonds.

use std::error::Error;
use std::time::Instant;

use explicit_dynamics::Amplitude;
use implicit_statics::{Equilibrium, linear_response};
use peridynamics::{AppliedLoad, Correction, Elastic, Law, Space, StaticSolid};
use sph_core::{Block, Vec3};

use crate::judge::{Case, Headline, Outcome, Run, Variant};
use crate::support::marched::method;
use crate::support::solids::{formulation, found, held, lattice, nodes, parts, system};
use crate::{JudgeError, Metric};

const STRAIN: &str = "strain error";
const CONTRACTION: &str = "error of the contraction";
const UNEVEN: &str = "unevenness";
/// Tension over Young's modulus: so little that lengths hardly change.
const LOAD: f64 = 1e-9;

#[derive(Clone, Copy)]
struct Bar {
    space: Space,
    law: Law,
    horizon: f64,
    poisson: f64,
    grading: f64,
    disorder: f64,
}

/// The bars, their closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "solid-tension",
        title: "Bars in tension: horizons of 1.5 to 6 spacings, ν from −.5 to .49, graded and disordered nodes",
        about: "A traction on one end, the other held along the bar on as many layers as the horizon reaches. The strain of the \
                middle third by least squares is held against that of a rod; unevenness is the greatest distance there of a \
                node from the line, over the elongation of the third.",
        citation: "F l/(E A)",
        variants: variants(),
        headline: Some(Headline::new(STRAIN, 0.1)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let plate = |law| Bar {
        space: Space::PlaneStress,
        law,
        horizon: 3.015,
        poisson: if law == Law::BondBased { 1.0 / 3.0 } else { 0.3 },
        grading: 1.0,
        disorder: 0.0,
    };
    let mut bars = Vec::new();
    for law in [Law::BondBased, Law::StateBased] {
        for (horizon, strain) in [(1.5, 1e-4), (2.015, 0.18), (3.015, 0.36), (4.015, 0.43), (6.015, 0.73)] {
            bars.push((format!("δ/Δx {horizon}"), Bar { horizon, ..plate(law) }, strain));
        }
        for (grading, disorder, strain) in [(4.0, 0.0, 0.75), (1.0, 0.1, 0.51), (1.0, 0.25, 1.2)] {
            let words =
                if disorder > 0.0 { format!("jitter {disorder}") } else { format!("graded {grading}") };
            bars.push((words, Bar { grading, disorder, ..plate(law) }, strain));
        }
    }
    for (poisson, strain) in [(-0.5, 1.3), (0.0, 0.74), (0.45, 0.64), (0.49, 0.46)] {
        let bar = Bar { space: Space::Solid, poisson, ..plate(Law::StateBased) };
        bars.push((format!("ν {poisson}"), bar, strain));
    }
    bars.into_iter()
        .map(|(grid, bar, strain)| {
            let run = move || bar.stretched().map_err(|e| e.to_string());
            Variant::study(method(bar.law), &grid, run)
                .quick_if(bar.space != Space::Solid)
                .judged(move |run, _| judged(strain, run))
        })
        .collect()
}

fn judged(strain: f64, run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let percent = |name: &str| -> Result<_, JudgeError> {
        Ok(Metric::error(name, run.last(name)?.map(|part| 100.0 * part), "%"))
    };
    Ok(vec![
        percent(STRAIN)?.near(
            strain,
            "weights are exact for uniform strains; ends, layers and disorder make them others",
        ),
        percent(CONTRACTION)?.shown("the strain across over that along, against Poisson's ratio"),
        percent(UNEVEN)?.shown("what disorder and the ends leave of a straight line"),
    ])
}

impl Bar {
    fn block(&self) -> Result<Block, Box<dyn Error>> {
        let ghosts = self.horizon.ceil();
        let [length, width, depth] = self.size();
        let size = [length + ghosts, width, depth];
        let mut bar = lattice(self.space.dimensions(), Vec3::x() * -ghosts, size, 1.0);
        bar.grading = [self.grading, 1.0, 1.0];
        bar.disorder = self.disorder;
        Ok(bar.block()?)
    }

    fn size(&self) -> [f64; 3] {
        if self.space == Space::Solid { [30.0, 4.0, 4.0] } else { [60.0, 12.0, 1.0] }
    }

    fn stretched(&self) -> Result<Outcome, Box<dyn Error>> {
        let started = Instant::now();
        let block = self.block()?;
        let [length, width, depth] = self.size();
        let ghosts = nodes(&block, |x| x.x < 0.0);
        let material = Elastic { young: 1.0, poisson: self.poisson, density: 1.0 };
        let mut bonds = formulation(self.space, self.law, Correction::Even);
        bonds.horizon = self.horizon;
        let mut parts = parts(block.clone(), material, bonds);
        // Two nodes of one edge of the first layer keep the bar from moving and turning across; they bear nothing.
        let solid = self.space == Space::Solid;
        let edge = if solid { (width * depth - depth) as u32 } else { width as u32 - 1 };
        parts.supports = vec![held(ghosts, &[Vec3::x()]), held(vec![0], &[Vec3::y()])];
        if solid {
            parts.supports.push(held(vec![0, edge], &[Vec3::z()]));
        }
        let forces = block.faces[1].iter().map(|&(node, area)| (node, Vec3::x() * area)).collect();
        parts.loads = vec![AppliedLoad { forces, amplitude: Amplitude::Constant }];
        let mut system = system(parts)?;
        let answer = linear_response(&mut system, 0.0)?;
        system.update(&answer.iter().map(|u| LOAD * u).collect::<Vec<_>>());
        let middle = nodes(&block, |x| x.x > length / 3.0 && x.x < 2.0 * length / 3.0);
        let along = slope(&system, &middle, 0) / LOAD;
        let across = slope(&system, &middle, 1) / LOAD;
        let uneven = unevenness(&system, &middle) / (along * LOAD * length / 3.0);
        let contraction = if self.poisson == 0.0 { -across } else { -across / (along * self.poisson) - 1.0 };
        let figures = [(STRAIN, along - 1.0), (CONTRACTION, contraction), (UNEVEN, uneven)];
        Ok(found(system.solid(), started, &figures))
    }
}

/// The means of coordinate and displacement of nodes along an axis, and the slope of one over the other.
fn line(system: &StaticSolid, nodes: &[u32], axis: usize) -> [f64; 3] {
    let body = system.solid();
    let of = |node: &u32| {
        let node = *node as usize;
        [body.block().positions[node][axis], body.displacement(node)[axis]]
    };
    let count = nodes.len() as f64;
    let [x, u] = [0, 1].map(|k| nodes.iter().map(|node| of(node)[k]).sum::<f64>() / count);
    let (mut xx, mut xu) = (0.0, 0.0);
    for [at, moved] in nodes.iter().map(of) {
        (xx, xu) = (xx + (at - x) * (at - x), xu + (at - x) * (moved - u));
    }
    [x, u, xu / xx]
}

fn slope(system: &StaticSolid, nodes: &[u32], axis: usize) -> f64 {
    line(system, nodes, axis)[2]
}

/// The greatest distance of a displacement along the bar from the line through all \[L\].
fn unevenness(system: &StaticSolid, nodes: &[u32]) -> f64 {
    let [x, u, slope] = line(system, nodes, 0);
    let body = system.solid();
    let off = |&node: &u32| {
        let node = node as usize;
        (body.displacement(node).x - u - slope * (body.block().positions[node].x - x)).abs()
    };
    nodes.iter().map(off).fold(0.0, f64::max)
}
