//! lattice-moduli: Young's modulus, Poisson's ratio and shear modulus that families on lattices have, from the energies of
//! unit strains at a node in the middle of a block.

use std::time::Instant;

use benchmarks_ref::reference;
use peridynamics::{Correction, Elastic, Formulation, Influence, Law, Solid, Space, Volumes};
use sph_core::Vec3;

use crate::judge::{Case, Headline, Outcome, Run, Runs, Variant};
use crate::methods::{PAIRWISE, STATE};
use crate::support::solids::{found, lattice, parts};
use crate::{JudgeError, Metric};

const TABLE: &str = "pd_lattice_moduli";
const YOUNG: &str = "E over that asked for";
const POISSON: &str = "Poisson's ratio";
const SHEAR: &str = "G over that asked for";
/// Small enough that the square of a rotation does not count, large enough that rounding does not.
const STRAIN: f64 = 1e-7;

/// Rows of the table that the program has: the influence `exp(−r²/δ²)` is left out.
fn rows() -> Result<Vec<(Formulation, [f64; 3])>, JudgeError> {
    let table = reference(TABLE)?;
    let rows = table.rows.iter().filter_map(|row| {
        let text = |i: usize| row[i].as_str().unwrap_or_default();
        let number = |i: usize| row[i].as_f64();
        let influence = match text(1) {
            "1" => Influence::Constant,
            "1/r" | "-" => Influence::Inverse,
            "1-r/(delta+dx/2)" => Influence::Linear,
            _ => return None,
        };
        let (space, law) = match text(0) {
            "LPS 3D" => (Space::Solid, Law::StateBased),
            _ => (Space::PlaneStress, Law::BondBased),
        };
        let volumes = if text(3) == "pv" { Volumes::Partial } else { Volumes::Whole };
        let (horizon, correction) = (number(2)?, Correction::None);
        let formulation = Formulation { space, law, horizon, volumes, influence, correction };
        Some((formulation, [number(5)?, number(6)?, number(7)?]))
    });
    Ok(rows.collect())
}

/// The rows, and how far they may differ.
pub fn case() -> Case {
    Case {
        name: "lattice-moduli",
        title: "Moduli of families on infinite lattices",
        about: "Energies of six unit strains of one family, uncorrected, against sums that were made by another program: they \
                tell that horizon, partial volumes, influence and law are what they are called. Then the same with weights \
                that are exact for these strains.",
        citation: "lattice sums in this project's reference file",
        variants: variants().unwrap_or_default(),
        headline: Some(Headline::new(YOUNG, 0.01)),
        ..Case::default()
    }
}

fn variants() -> Result<Vec<Variant>, JudgeError> {
    let mut variants = Vec::new();
    for (plain, expected) in rows()? {
        let words = |formulation: &Formulation| {
            let Formulation { horizon, volumes, influence, correction, .. } = formulation;
            format!("{influence:?} δ/Δx {horizon} {volumes:?} {correction:?}").to_lowercase()
        };
        let method = if plain.law == Law::BondBased { PAIRWISE } else { STATE };
        let even = Formulation { correction: Correction::Even, ..plain };
        let nu = if plain.law == Law::BondBased { 1.0 / 3.0 } else { 0.33 };
        for (formulation, [young, poisson, shear], tolerance) in
            [(plain, expected, 1e-4), (even, [1.0, nu, 1.0], 1e-6)]
        {
            let reason = if tolerance < 1e-5 {
                "exact for these strains but for their squares"
            } else {
                "half of the last of four printed digits, and the square of the strain"
            };
            let judged = move |run: &Run, _: &Runs| -> Result<Vec<Metric>, JudgeError> {
                [(YOUNG, young), (POISSON, poisson), (SHEAR, shear)]
                    .into_iter()
                    .map(|(name, expected)| {
                        Ok(Metric::compared(name, run.last(name)?, "-", expected).within(tolerance, reason))
                    })
                    .collect()
            };
            let run = move || moduli(formulation).map_err(|e| e.to_string());
            variants.push(Variant::study(method, &words(&formulation), run).quick().judged(judged));
        }
    }
    Ok(variants)
}

/// Moduli of the family in the middle of a block that no face cuts.
fn moduli(formulation: Formulation) -> Result<Outcome, Box<dyn std::error::Error>> {
    let started = Instant::now();
    let d = formulation.space.dimensions();
    // Density of unit strain energies needs the nodes of a family and of theirs: two horizons from the middle to each face.
    let half = 2.0 * (formulation.horizon + 1.0).ceil();
    let side = 2.0 * half + 1.0;
    let lengths = if d == 3 { [side; 3] } else { [side, side, 1.0] };
    let corner = Vec3::repeat(-0.5 * side);
    let block = lattice(d, corner, lengths, 1.0).block()?;
    let poisson = if formulation.law == Law::BondBased { 1.0 / 3.0 } else { 0.33 };
    let material = Elastic { young: 1.0, poisson, density: 1.0 };
    let mut body = Solid::new(parts(block.clone(), material, formulation))?;
    let middle = (0..block.len())
        .min_by(|&a, &b| {
            let from = |node: usize| {
                let x = block.positions[node];
                x.x * x.x + x.y * x.y + if d == 3 { x.z * x.z } else { 0.0 }
            };
            from(a).total_cmp(&from(b))
        })
        .ok_or("no node")?;
    let mut energy = |gradient: [[f64; 2]; 2]| {
        for (node, x) in block.positions.iter().enumerate() {
            let row = |g: [f64; 2]| STRAIN * (g[0] * x.x + g[1] * x.y);
            body.put(node, x + Vec3::new(row(gradient[0]), row(gradient[1]), 0.0));
        }
        body.evaluate_internal(true);
        body.strain_energy(middle) / (STRAIN * STRAIN)
    };
    // W = ½ C11 ε² along an axis, ½ (C11 + C22 + 2 C12) in both, ½ G γ² in shear.
    let along = 2.0 * energy([[1.0, 0.0], [0.0, 0.0]]);
    let both = energy([[1.0, 0.0], [0.0, 1.0]]);
    let shear = 2.0 * energy([[0.0, 0.5], [0.5, 0.0]]);
    let across = both - along;
    let (young, nu) = match d {
        2 => (along - across * across / along, across / along),
        _ => ((along - across) * (along + 2.0 * across) / (along + across), across / (along + across)),
    };
    let expected = 1.0 / (2.0 * (1.0 + poisson));
    Ok(found(&body, started, &[(YOUNG, young), (POISSON, nu), (SHEAR, shear / expected)]))
}
