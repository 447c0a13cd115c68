//! Uneven cells: a disordered sheet that is rolled up keeps its lengths, and finds that it does.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::free_shell;
use sph_core::{Plate, Vec3, jittered_lattice};
use sph_shell::{Formulation, PointResult, Reach};

const SPACING: f64 = 0.1;

/// Standard deviation over the cells of the largest-spread membrane strain, of what chords find and of what the shell finds,
/// on a sheet rolled to a cylinder whose axis leans by `lean` to the edges.
fn spreads(lean: f64, turn: f64) -> (f64, f64) {
    let patch = Plate { lengths: [20.0 * SPACING, 15.0 * SPACING] };
    let cloud = jittered_lattice(&patch, [21, 16], 0.3, 5).unwrap();
    let mut body = free_shell(cloud, Formulation::StressPoint(Reach::Cell), common::THICKNESS);
    let k = turn / SPACING;
    let (along, across) = (Vec3::new(lean.cos(), lean.sin(), 0.0), Vec3::new(-lean.sin(), lean.cos(), 0.0));
    for a in 0..body.len() {
        let x = body.position(a);
        let (u, v) = (x.dot(&along), x.dot(&across));
        let (sin, cos) = (k * u).sin_cos();
        let rolled = along * (sin / k) + across * v + Vec3::z() * ((1.0 - cos) / k);
        body.set_state(a, rolled, Vec3::z() * cos - along * sin);
    }
    let operator = &body.reference().operator;
    let chord = |p: usize| {
        let stencil = operator.stencil(p);
        let sum = |g: &[f64]| -> Vec3 {
            stencil.particles.iter().zip(g).map(|(&b, g)| body.position(b as usize) * *g).sum()
        };
        let [x1, x2] = [sum(stencil.g1), sum(stencil.g2)];
        [0.5 * (x1.dot(&x1) - 1.0), 0.5 * (x2.dot(&x2) - 1.0)]
    };
    let count = operator.points.len();
    let mut found = vec![PointResult::default(); count];
    body.point_results(&mut found);
    // Traces do not depend on the frames of the cells.
    let of_chords: Vec<f64> = (0..count).map(|p| chord(p).iter().sum()).collect();
    let of_shell: Vec<f64> = found.iter().map(|r| r.membrane[0] + r.membrane[1]).collect();
    (spread(&of_chords), spread(&of_shell))
}

fn spread(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / values.len() as f64).sqrt()
}

#[test]
fn a_rolled_disordered_sheet_is_evenly_strained() {
    for lean in [0.0, 0.6] {
        for turn in [0.05, 0.2] {
            let (chords, shell) = spreads(lean, turn);
            // Chords find strains of the size of the loss, (kΔ)²/24 and its like; four averages over nine neighbours leave a
            // thirtieth of their variance in the mean, .18 of the spread, and more at the edges.
            assert!(chords > turn * turn / 200.0, "lean {lean}, turn {turn}: {chords:.1e}");
            assert!(shell < 0.25 * chords, "lean {lean}, turn {turn}: {shell:.1e} of {chords:.1e}");
        }
    }
}
