//! strip-bending: an infinite strip, so many nodes thick: the stiffness in its plane and in bending that its lattice has.
//!
//! Layer k at the height z of the strip has `u_x = ε x, u_z = g_k` or `u_x = κ x z, u_z = −κ x²/2 + g_k`. To first order the
//! extension of a bond ξ from that layer to layer l does not depend on x,
//!
//! ```text
//! e = [ξ_x² ε + ξ_z (g_l − g_k)]/r          e = [κ ξ_x² (z + ½ξ_z) + ξ_z (g_l − g_k)]/r
//! ```
//!
//! so that one column tells the energy of all. Its layers move across the strip until no force is left on them; the energy
//! a unit length is then that of a thin strip, `½ E t ε²` or `½ E t³/12 κ²`, times a ratio.
//!
//! With weights that are exact for unit strains and a horizon of 1.5 spacings the ratios have a closed form. Bonds join
//! neighbouring layers only, and λ = μ. A node holds `½ 2μ κ² z²` in the bonds of its layer; the bonds between two layers,
//! in whose middle z̄ they feel the strain, hold `½ f ⅔μ κ² z̄²` once the layers are at rest, f = 1 inside, and f = 3/2
//! at the faces, where a node has all its weight on one side. With E = 8μ/3 the sums over n layers give
//!
//! ```text
//! membrane 1          bending 1 − 13/(4n²) + 3/n³
//! ```

use std::error::Error;
use std::time::Instant;

use benchmarks_ref::reference;
use nalgebra::{DMatrix, DVector};
use peridynamics::{Correction, Elastic, Formulation, Influence, Law, Solid, Space, Volumes};
use sph_core::Vec3;

use crate::figures::{Axis, Chart, Figure, GREEN, GREY, Line, Mark, Series, VERMILION};
use crate::judge::{Case, Headline, Outcome, Run, Runs, Variant};
use crate::methods::PAIRWISE;
use crate::support::marched::{in_time, method};
use crate::support::solids::{found, lattice, parts};
use crate::{JudgeError, Metric};

const TABLE: &str = "pd_strip_bending";
const LAYERS: [usize; 6] = [3, 4, 5, 8, 10, 20];
const HORIZONS: [f64; 3] = [1.5, 2.015, 3.015];
const MEMBRANE: &str = "membrane";
const BENDING: &str = "bending";
/// Strain, and curvature times spacing: extensions keep nine digits, and their squares nothing.
const SMALL: f64 = 1e-6;
const YOUNG: f64 = 1.0;

/// The strips, the sums of another program, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "strip-bending",
        title: "Infinite strip of 3 to 20 layers of nodes: stiffness in its plane and in bending",
        about: "Without correction and with factors of the energy: figures of a sum over one column that another program made. \
                With weights that are exact for unit strains: what they leave of a strain that varies across the strip. \
                Bending is too soft by a part that falls with the square of the layers over the horizon, since a bond \
                feels the strain in its middle and not at its node: 20 layers bend .8 % too softly at a horizon of 1.5 \
                spacings, 2.4 % at 3.015. So a thin plate is not made of layers.",
        citation: "lattice sums in this project's reference file",
        variants: variants(),
        headline: Some(Headline::new(MEMBRANE, 0.0005)),
        figures,
        ..Case::default()
    }
}

#[derive(Clone, Copy)]
struct Strip {
    law: Law,
    correction: Correction,
    volumes: Volumes,
    horizon: f64,
}

fn variants() -> Vec<Variant> {
    let mut strips = Vec::new();
    for horizon in HORIZONS {
        for volumes in [Volumes::Whole, Volumes::Partial] {
            for correction in [Correction::None, Correction::EnergyFactor] {
                strips.push(Strip { law: Law::BondBased, correction, volumes, horizon });
            }
        }
        for law in [Law::BondBased, Law::StateBased] {
            strips.push(Strip { law, correction: Correction::Even, volumes: Volumes::Partial, horizon });
        }
    }
    let variant = |strip: Strip| {
        let run = move || strip.run().map_err(|e| e.to_string());
        let variant = Variant::study(method(strip.law), &strip.grid(), run).quick();
        variant.judged(move |run, _| strip.judged(run))
    };
    strips.into_iter().map(variant).collect()
}

impl Strip {
    fn grid(&self) -> String {
        let Self { correction, volumes, horizon, .. } = self;
        format!("δ/Δx {horizon} {volumes:?} {correction:?}").to_lowercase()
    }

    fn poisson(&self) -> f64 {
        if self.law == Law::BondBased { 1.0 / 3.0 } else { 0.3 }
    }

    fn run(&self) -> Result<Outcome, Box<dyn Error>> {
        let started = Instant::now();
        let mut rows = Vec::new();
        let mut last = None;
        for layers in LAYERS {
            let mut column = Column::new(self, layers)?;
            let thickness = layers as f64;
            let membrane = 2.0 * column.energy(|x| (x.x, 0.0))? / (YOUNG * thickness);
            let bending =
                24.0 * column.energy(|x| (x.x * x.y, -0.5 * x.x * x.x))? / (YOUNG * thickness.powi(3));
            rows.push(vec![thickness, membrane, bending]);
            last = Some(column.body);
        }
        let body = last.ok_or("no strip")?;
        let columns = [("layers", "-"), (MEMBRANE, "-"), (BENDING, "-")];
        Ok(Outcome { curve: in_time(&columns, rows), ..found(&body, started, &[]) })
    }

    /// Rows of the table for these bonds: membrane and bending ratio.
    fn expected(&self) -> Result<Vec<[f64; 2]>, JudgeError> {
        let correction = match self.correction {
            Correction::None => "no",
            Correction::EnergyFactor => "energy-based",
            Correction::Even | Correction::Balanced => return Ok(Vec::new()),
        };
        let volumes = if self.volumes == Volumes::Partial { "pv" } else { "none" };
        let table = reference(TABLE)?;
        let rows = table.rows.iter().filter_map(|row| {
            let text = |i: usize| row[i].as_str();
            let here = text(0) == Some(correction) && text(1) == Some(volumes);
            let number = |i: usize| row[i].as_f64();
            (here && number(2) == Some(self.horizon)).then(|| Some([number(4)?, number(5)?]))?
        });
        Ok(rows.collect())
    }

    fn judged(&self, run: &Run) -> Result<Vec<Metric>, JudgeError> {
        let (expected, tolerance, reason) = match self.correction {
            Correction::Even => {
                let exact = self.law == Law::BondBased && self.horizon == 1.5;
                let of = |row: usize| if exact { closed_form(LAYERS[row]) } else { self.measured(row) };
                let expected: Vec<_> = (0..LAYERS.len()).map(of).collect();
                let measured = "a figure to notice a change by: half of its last digit";
                if exact { (expected, 2e-10, CLOSED) } else { (expected, 5.1e-5, measured) }
            }
            _ => (self.expected()?, 5.1e-4, "half of the last of three printed digits"),
        };
        if expected.len() != LAYERS.len() {
            return Ok(vec![Metric::error("rows of the table", None, "-").within(0.0, "one for each strip")]);
        }
        let mut metrics = Vec::new();
        for (place, name) in [MEMBRANE, BENDING].into_iter().enumerate() {
            let found = run.column(name)?;
            for (row, layers) in LAYERS.iter().enumerate() {
                let value = found.get(row).copied().filter(|_| run.done());
                let metric =
                    Metric::compared(format!("{name}, {layers} layers"), value, "-", expected[row][place]);
                metrics.push(metric.within(tolerance, reason));
            }
        }
        Ok(metrics)
    }

    /// What was found with weights that are exact for unit strains, where no closed form is known.
    fn measured(&self, row: usize) -> [f64; 2] {
        let place = HORIZONS.iter().position(|&horizon| horizon == self.horizon).unwrap_or(0);
        let table = if self.law == Law::BondBased { &EVEN_PAIRWISE } else { &EVEN_STATE };
        table[place][row]
    }
}

const CLOSED: &str = "the closed form; 4e-11 is what rounding leaves of extensions of a millionth";

/// Membrane and bending of pairwise bonds with exact weights, by horizon and layers.
#[rustfmt::skip] // a table
const EVEN_PAIRWISE: [[[f64; 2]; 6]; 3] = [
    [[1.0, 0.75], [1.0, 0.8438], [1.0, 0.8940], [1.0, 0.9551], [1.0, 0.9705], [1.0, 0.9922]],
    [[1.0, 0.6876], [0.9935, 0.7914], [0.9954, 0.8512], [0.9973, 0.9319], [0.9979, 0.9537], [0.9989, 0.9861]],
    [[1.0, 0.6393], [0.9960, 0.7213], [0.9919, 0.7901], [0.9945, 0.8940], [0.9957, 0.9258], [0.9978, 0.9763]],
];
/// The same of bonds that feel the dilatation at both ends, ν = 0.3.
#[rustfmt::skip] // a table
const EVEN_STATE: [[[f64; 2]; 6]; 3] = [
    [[1.0, 0.7485], [1.0, 0.8426], [1.0, 0.8932], [1.0, 0.9547], [1.0, 0.9702], [1.0, 0.9922]],
    [[1.0, 0.6862], [0.9935, 0.7913], [0.9954, 0.8514], [0.9973, 0.9322], [0.9979, 0.9538], [0.9989, 0.9861]],
    [[1.0, 0.6430], [0.9961, 0.7213], [0.9919, 0.7905], [0.9945, 0.8947], [0.9957, 0.9264], [0.9978, 0.9765]],
];

/// Membrane and bending of pairwise bonds with exact weights at a horizon of 1.5 spacings.
fn closed_form(layers: usize) -> [f64; 2] {
    let n = layers as f64;
    [1.0, 1.0 - 3.25 / (n * n) + 3.0 / (n * n * n)]
}

/// A strip long enough that its middle column sees no end, and the nodes of that.
struct Column {
    body: Solid,
    middle: Vec<usize>,
    layers: usize,
}

impl Column {
    fn new(strip: &Strip, layers: usize) -> Result<Self, Box<dyn Error>> {
        let &Strip { law, correction, volumes, horizon } = strip;
        let influence = Influence::Inverse;
        let formulation =
            Formulation { space: Space::PlaneStress, law, horizon, volumes, influence, correction };
        // Forces of the middle column need the dilatations of a family, and factors those of theirs.
        let half = 3.0 * (horizon + 1.0).ceil();
        let (length, thickness) = (2.0 * half + 1.0, layers as f64);
        let corner = Vec3::new(-0.5 * length, -0.5 * thickness, 0.0);
        let block = lattice(2, corner, [length, thickness, 1.0], 1.0).block()?;
        let mut middle: Vec<usize> =
            (0..block.len()).filter(|&node| block.positions[node].x.abs() < 0.5).collect();
        middle.sort_by(|&a, &b| block.positions[a].y.total_cmp(&block.positions[b].y));
        let material = Elastic { young: YOUNG, poisson: strip.poisson(), density: 1.0 };
        Ok(Self { body: Solid::new(parts(block, material, formulation))?, middle, layers })
    }

    /// Puts the strip into a multiple of a field, its layers moved; forces across the strip on the layers of the middle column, over
    /// that multiple.
    fn forces(&mut self, field: impl Fn(Vec3) -> (f64, f64), moved: &DVector<f64>) -> DVector<f64> {
        let mut sum = DVector::zeros(self.layers);
        for sign in [1.0, -1.0] {
            self.put(sign * SMALL, &field, moved);
            let across =
                |layer: usize, _| self.body.internal_force(self.middle[layer]).y / (2.0 * sign * SMALL);
            sum += DVector::from_fn(self.layers, across);
        }
        sum
    }

    fn put(&mut self, factor: f64, field: &impl Fn(Vec3) -> (f64, f64), moved: &DVector<f64>) {
        for node in 0..self.body.len() {
            let x = self.body.block().positions[node];
            let layer = (x.y + 0.5 * (self.layers as f64 - 1.0)).round() as usize;
            let (along, across) = field(x);
            self.body.put(node, x + Vec3::new(along, across + moved[layer], 0.0) * factor);
        }
        self.body.evaluate_internal(true);
    }

    /// Energy of the middle column for a field of amplitude one, once its layers are at rest.
    fn energy(&mut self, field: impl Fn(Vec3) -> (f64, f64)) -> Result<f64, Box<dyn Error>> {
        let n = self.layers;
        let still = DVector::zeros(n);
        let mut stiffness = DMatrix::zeros(n, n);
        for layer in 0..n {
            let mut one = still.clone();
            one[layer] = 1.0;
            stiffness.set_column(layer, &self.forces(|_| (0.0, 0.0), &one));
        }
        let lacking = -self.forces(&field, &still);
        // The first layer stays: all of them may move together.
        let free = stiffness.view((1, 1), (n - 1, n - 1)).clone_owned();
        let moves = free.lu().solve(&lacking.rows(1, n - 1)).ok_or("layers that nothing holds together")?;
        let mut moved = still;
        moved.rows_mut(1, n - 1).copy_from(&moves);
        let mut energy = 0.0;
        for sign in [1.0, -1.0] {
            self.put(sign * SMALL, &field, &moved);
            let column = self
                .middle
                .iter()
                .map(|&node| self.body.strain_energy(node) * self.body.block().volumes[node]);
            energy += 0.5 * column.sum::<f64>() / (SMALL * SMALL);
        }
        Ok(energy)
    }
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut series = Vec::new();
    for (correction, words, colour) in [
        (Correction::None, "no correction", GREY),
        (Correction::EnergyFactor, "factors of the energy", GREEN),
        (Correction::Even, "exact for unit strains", VERMILION),
    ] {
        let strip = Strip { law: Law::BondBased, correction, volumes: Volumes::Partial, horizon: 3.015 };
        let Some(run) = runs.get(PAIRWISE, &strip.grid())? else { continue };
        let points = run.column("layers")?.into_iter().zip(run.column(BENDING)?).collect();
        series.push(Series::both(words, points, colour, Mark::Disc));
    }
    series.push(Series::line("thin strip", vec![(3.0, 1.0), (20.0, 1.0)], GREY, Line::Dashed));
    Ok(vec![Figure::Chart(Chart {
        title: "Stiffness in bending over that of a thin strip, δ/Δx 3.015".into(),
        caption: "Bonds that feel their own extension alone, partial volumes.".into(),
        x: Axis::linear("layers of nodes"),
        y: Axis::linear("ratio"),
        series,
    })])
}
