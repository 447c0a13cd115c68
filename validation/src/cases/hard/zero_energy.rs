//! zero-energy: six zero modes and no more, and the lowest elastic modes in place, lattice or not, thick or thin.

use std::time::Instant;

use benchmarks_ref::reference;
use nalgebra::Schur;
use sph_shell::Shell;

use crate::Found;
use crate::Outcome;
use crate::cases::shell::plate::of_thickness;
use crate::judge::measure::largest;
use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::{CELL, NODAL_1, NODAL_2, STRONG_12, STRONG_085, WIDE_30};
use crate::support::studies::{ENERGY, SHOWN, dense_tangent, figure, free, jittered, outcome, study};
use crate::{JudgeError, Metric};

const NAME: &str = "worst of three frequencies";
const THICKNESSES: [f64; 2] = [0.1, 0.01];
/// Modes asked for: six rigid ones, three that are judged, and three more in which a zero mode too many would show.
const MODES: usize = 12;
/// A frequency below this part of the first elastic one counts as zero: rounding leaves 1e-3 of it and less.
const ZERO: f64 = 0.02;
const DEFECT: &str = "imaginary part";
const ASYMMETRY: &str = "asymmetry of the operator";
const SOFT: &str = "lowest frequency over exact";

pub fn case() -> Case {
    Case {
        name: "zero-energy",
        title: "Free square plate on 11×11 particles: zero modes and the lowest elastic ones",
        about: "Modes of the unloaded free plate. A pattern that the strains do not see would be a seventh zero mode, a \
                control that is too stiff would lift the first elastic ones. The strong form has no energy: of its operator \
                all eigenvalues are found, which should be real and positive.",
        citation: "Ritz series of this project's reference file; thin limit Leissa 1969",
        variants: variants(),
        headline: Some(Headline::new(NAME, 0.05)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for thickness in THICKNESSES {
        for jitter in [false, true] {
            for method in ENERGY {
                let plate = of_thickness(method, 11, thickness)
                    .set("supports", "[]")
                    .set("analysis.modal.modes", MODES)
                    .on(&format!("t {thickness}"))
                    .judged(move |run, _| modes(run, thickness, jitter));
                let plate = if method == CELL { plate.quick() } else { plate };
                variants.push(if jitter { jittered(plate, "plate") } else { plate });
            }
        }
        for method in [STRONG_12, STRONG_085] {
            let plate = free(of_thickness(method, 7, thickness)).on(&format!("t {thickness}"));
            variants.push(
                study(plate, move |shell| strong(shell, thickness)).judged(|run, _| known_failure(run)),
            );
        }
    }
    variants
}

fn modes(run: &Run, thickness: f64, jitter: bool) -> Result<Vec<Metric>, JudgeError> {
    let exact = lowest(thickness)?;
    let found = run.column("circular_frequency")?;
    let zero = found.iter().filter(|&&omega| omega < ZERO * exact[0]).count();
    let errors = exact.iter().zip(found.get(zero..).unwrap_or_default());
    let worst = (found.len() >= zero + exact.len())
        .then(|| largest(errors.map(|(exact, omega)| Some(100.0 * (omega / exact - 1.0).abs()))))
        .flatten();
    Ok(vec![
        Metric::error("zero modes beyond six", Some(zero as f64 - 6.0), "-")
            .within(0.0, "a free body has six rigid motions and no other motion without energy"),
        frequencies(run, jitter, Metric::error(NAME, worst, "%")),
    ])
}

fn frequencies(run: &Run, jitter: bool, metric: Found) -> Metric {
    match run.variant.method.as_str() {
        NODAL_1 => metric.within(
            10.0,
            "known failure of the 5 % that are asked: gradients of first order are too soft on short waves, 8.7 % on 11×11, 2.2 % on \
             21×21, 1.0 % on 31×31: of second order, and no mode too many",
        ),
        NODAL_2 if jitter => metric.within(
            10.0,
            "known failure of the 5 % that are asked: off the lattice the areas do not integrate linear functions and order 2 keeps \
             order 1 only: the error of nodal 1, 9.0 % on 11×11, 2.4 % on 21×21, 1.1 % on 31×31",
        ),
        WIDE_30 if jitter => metric.within(
            5.5,
            "known failure of the 5 % that are asked by .1 %: the widest kernel on the coarsest cloud; 1.3 % on 21×21",
        ),
        _ => metric.within(5.0, "required of this project: lowest elastic modes within 5 %"),
    }
}

/// First three frequencies of the free square plate \[√(D/ρha⁴)\].
fn lowest(thickness: f64) -> Result<Vec<f64>, JudgeError> {
    let table = reference("plate_vibration_square")?;
    for row in 0..table.rows.len() {
        if table.rows[row][0].as_str() == Some("FFFF") && table.number(row, "h/a")? == thickness {
            return (1..=3).map(|mode| Ok(table.number(row, &format!("lambda{mode}"))?)).collect();
        }
    }
    Ok(Vec::new())
}

/// All eigenvalues of the strong form's operator, which is not symmetric.
fn strong(mut shell: Shell, thickness: f64) -> Result<Outcome, String> {
    let started = Instant::now();
    let matrix = dense_tangent(&mut shell);
    let asymmetry = (&matrix - matrix.transpose()).norm() / matrix.norm();
    let values = Schur::try_new(matrix, 1e-13, 100_000)
        .ok_or("the eigenvalues of the strong form did not converge")?
        .complex_eigenvalues();
    let first = lowest(thickness).map_err(|e| e.to_string())?[0];
    let mut sizes: Vec<f64> = values.iter().map(|value| value.norm()).collect();
    sizes.sort_by(f64::total_cmp);
    // One value a particle belongs to the fixed length of its director, six to rigid motion.
    let lowest_elastic = sizes[shell.len() + 6].sqrt();
    let top = sizes[sizes.len() - 1];
    // A pair of conjugate ω² makes two motions, one of which grows.
    let imaginary = values.iter().fold(0.0_f64, |most, value| most.max(value.im.abs()));
    let negative = values.iter().fold(0.0_f64, |most, value| most.max(-value.re));
    let figures = [
        (ASYMMETRY, "-", asymmetry),
        (DEFECT, "%", 100.0 * imaginary / top),
        ("negative part", "%", 100.0 * negative / top),
        (SOFT, "-", lowest_elastic / first),
    ];
    Ok(outcome(&shell, 0, started, &figures, None))
}

fn known_failure(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let soft = figure(run, SOFT, "-")?;
    let soft = if run.is(STRONG_12) {
        soft.within(
            0.5,
            "known failure: a pattern that the strains hardly see, .33 to .34 of the first elastic frequency",
        )
    } else {
        soft.shown("the narrower kernel sees the pattern")
    };
    let operator = Metric::at_least(ASYMMETRY, run.column(ASYMMETRY)?.last().copied(), "-", 0.05).within(
        0.0,
        "known failure: the published pair sums derive from no energy; where it vanished it would be mended",
    );
    Ok(vec![
        soft,
        operator,
        figure(run, DEFECT, "%")?.shown("of the largest eigenvalue ω²: such pairs of modes flutter and grow"),
        figure(run, "negative part", "%")?.shown(SHOWN),
    ])
}
