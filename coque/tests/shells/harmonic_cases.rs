//! Steady vibration under load cases: each against the scene with its loads alone, combinations with phases, about a preload; what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::refused::refused;
use crate::common::{overridden, ran};
use crate::harmonic::PLATE;
use coque::{Ended, Outcome};

/// Loads of the plate with their cases.
const LOADS: [(&str, &str); 3] = [
    ("push", "on = \"here\", force = { total = [0.4, 0.2, 1.0] }"),
    ("blow", "on = \"all\", pressure = { value = 3.0 }"),
    ("twist", "on = \"there\", couple = { moment = 0.05, axis = [0.3, 0.2, 1.0] }"),
];
const COMBINED: &str = "combinations = [\
    { name = \"both\", of = { push = 1.5, blow = -0.5 } }, \
    { name = \"turning\", of = { push = 1.0, blow = 0.7, twist = 2.0 }, phases = { blow = 90.0, twist = -30.0 } }]";

/// The plate by some damping and modes, under all loads with a case to each, or under some of them times factors without cases.
fn plate(how: &str, factors: Option<&[f64]>) -> Outcome {
    plate_beside(how, factors, "")
}

/// The same beside a further load.
fn plate_beside(how: &str, factors: Option<&[f64]>, beside: &str) -> Outcome {
    let scaled = |(_, load): &(&str, &str), by: f64| -> String {
        match *load {
            load if load.contains("force") => {
                format!(
                    "{{ on = \"here\", force = {{ total = [{:?}, {:?}, {:?}] }} }}",
                    0.4 * by,
                    0.2 * by,
                    by
                )
            }
            load if load.contains("pressure") => {
                format!("{{ on = \"all\", pressure = {{ value = {:?} }} }}", 3.0 * by)
            }
            _ => format!(
                "{{ on = \"there\", couple = {{ moment = {:?}, axis = [0.3, 0.2, 1.0] }} }}",
                0.05 * by
            ),
        }
    };
    let loads: Vec<String> = match factors {
        None => LOADS.iter().map(|(case, load)| format!("{{ {load}, case = \"{case}\" }}")).collect(),
        Some(factors) => {
            let some = LOADS.iter().zip(factors).filter(|(_, factor)| **factor != 0.0);
            some.map(|(load, factor)| scaled(load, *factor)).collect()
        }
    };
    let combined = if factors.is_none() { format!(", {COMBINED}") } else { String::new() };
    let analysis = format!("{{ frequencies = [20.0, 60.0, 150.0, 400.0], {how}{combined} }}");
    let replaced = [("loads", format!("[{beside}{}]", loads.join(", "))), ("analysis.harmonic", analysis)];
    let replaced = replaced.each_ref().map(|(path, value)| (*path, value.as_str()));
    let outcome = ran(overridden(PLATE, "plate.toml", &replaced));
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

const WAYS: [&str; 4] = [
    "damping.structural = 0.05",
    "damping.rayleigh = { mass = 3.0, stiffness = 1e-5 }",
    "modes = 4, damping.structural = 0.05",
    "modes = 4, damping.ratio = 0.02",
];

/// Rows of a case, without its number.
fn of_case(outcome: &Outcome, number: f64) -> Vec<Vec<f64>> {
    let own = outcome.curve.rows.iter().filter(|row| row[0] == number);
    own.map(|row| row[1..].to_vec()).collect()
}

/// Columns as real and imaginary parts, from the first measured one on.
fn complex(row: &[f64]) -> Vec<[f64; 2]> {
    let part = |&[size, phase]: &[f64; 2]| {
        let (sin, cos) = libm::sincos(phase);
        [size * cos, size * sin]
    };
    row[6..].as_chunks::<2>().0.iter().map(part).collect()
}

/// Greatest distance of rows in their columns, each over the size of the other, and in their energies over all of them.
fn off(rows: &[Vec<f64>], other: &[Vec<f64>]) -> f64 {
    assert!(rows.len() == other.len() && !rows.is_empty());
    let one = |(a, b): (&Vec<f64>, &Vec<f64>)| {
        let columns = complex(a).into_iter().zip(complex(b));
        let columns = columns.map(|(a, b)| {
            let [x, y] = [a[0] - b[0], a[1] - b[1]];
            (x * x + y * y).sqrt() / (b[0] * b[0] + b[1] * b[1]).sqrt()
        });
        let whole: f64 = b[2..6].iter().map(|energy| energy.abs()).sum();
        columns.chain((2..6).map(|k| (a[k] - b[k]).abs() / whole)).fold(0.0, f64::max)
    };
    rows.iter().zip(other).map(one).fold(0.0, f64::max)
}

/// Every case, and a combination in phase, equals the scene under its loads alone: by one factor a frequency, by one set of modes.
#[test]
fn cases_and_sums_are_runs_of_their_own() {
    for how in WAYS {
        let outcome = plate(how, None);
        assert_eq!(outcome.curve.rows.len(), 4 * 5);
        for (number, factors) in
            [(1.0, [1.0, 0.0, 0.0]), (2.0, [0.0, 1.0, 0.0]), (3.0, [0.0, 0.0, 1.0]), (4.0, [1.5, -0.5, 0.0])]
        {
            let alone = plate(how, Some(&factors)).curve.rows;
            let off = off(&of_case(&outcome, number), &alone);
            println!("{how}, {number}: {off:.1e}");
            assert!(off < 1e-9, "{how}, {number}: {off:.1e}");
        }
    }
}

/// About a tension that is there in all cases, and that shifts what they do.
#[test]
fn cases_vibrate_about_a_preload() {
    let tension = "{ on = \"u1\", force = { total = [2e4, 0.0, 0.0] }, preload = true }, ";
    for how in [WAYS[0], WAYS[2]] {
        let outcome = plate_beside(how, None, tension);
        let alone = plate_beside(how, Some(&[0.0, 1.0, 0.0]), tension).curve.rows;
        let (found, slack) = (of_case(&outcome, 2.0), of_case(&plate(how, None), 2.0));
        assert!(off(&found, &alone) < 1e-9, "{how}: {:.1e}", off(&found, &alone));
        assert!(off(&found, &slack) > 0.01, "{how}");
    }
}

/// A combination with phases is the run under the cosines plus a quarter of a cycle times that under the sines; damping takes what the loads bring in.
#[test]
fn phases_turn_what_cases_do() {
    let (sin, cos) = libm::sincos((-30.0_f64).to_radians());
    for how in WAYS {
        let found = of_case(&plate(how, None), 5.0);
        let real = plate(how, Some(&[1.0, 0.0, 2.0 * cos])).curve.rows;
        let imaginary = plate(how, Some(&[0.0, 0.7, 2.0 * sin])).curve.rows;
        for (row, (a, b)) in found.iter().zip(real.iter().zip(&imaginary)) {
            for (own, (a, b)) in complex(row).iter().zip(complex(a).iter().zip(complex(b))) {
                let [x, y] = [a[0] - b[1] - own[0], a[1] + b[0] - own[1]];
                let size = (a[0] * a[0] + a[1] * a[1]).sqrt() + (b[0] * b[0] + b[1] * b[1]).sqrt();
                assert!((x * x + y * y).sqrt() < 1e-9 * size, "{how}: {own:?} {a:?} {b:?}");
            }
            assert!((row[4] / row[5] - 1.0).abs() < 1e-9, "{how}: {row:?}");
            assert!(row[2] > 0.0 && row[3] > 0.0);
        }
    }
}

/// The summary names cases and combinations, with the greatest amplitude of each column and its frequency.
#[test]
fn the_summary_has_the_peak_of_each_column_in_each_case() {
    let outcome = plate(WAYS[0], None);
    let cases = &outcome.summary.vibration.as_ref().unwrap().cases;
    let names: Vec<&str> = cases.iter().map(|case| case.set.name.as_str()).collect();
    assert_eq!(names, ["push", "blow", "twist", "both", "turning"]);
    for (number, case) in (1..).zip(cases) {
        assert_eq!(case.peaks.len(), 6);
        let rows = of_case(&outcome, f64::from(number));
        for (k, peak) in case.peaks.iter().enumerate() {
            let greatest = rows.iter().max_by(|a, b| a[6 + 2 * k].total_cmp(&b[6 + 2 * k])).unwrap();
            assert_eq!((peak.amplitude, peak.frequency), (greatest[6 + 2 * k], greatest[0]));
            assert_eq!(peak.column.name, ["w", "turn", "v", "R", "M", "m"][k]);
        }
    }
}

#[test]
fn what_does_not_vibrate_in_cases_is_refused() {
    let scene = PLATE
        .replace("[0.4, 0.2, 1.0] } }]", "[0.4, 0.2, 1.0] }, case = \"push\" }]")
        .replace("structural = 0.05 }", "structural = 0.05, combinations = [{ name = \"c\", of = { push = 2.0 }, phases = { push = 10.0 } }] }");
    let said = refused(
        &scene,
        &[
            ("a phase of no case", "phases = { push", "phases = { pull"),
            (
                "a base beside cases",
                "structural = 0.05,",
                "structural = 0.05, base.acceleration = [0, 0, 1],",
            ),
            ("fields", "title = \"Plate\"", "title = \"Plate\"\noutput.fields = {}"),
            (
                "a preload with a case",
                "loads = [",
                "loads = [{ on = \"all\", pressure = { value = 1.0 }, preload = true, case = \"own\" }, ",
            ),
        ],
    );
    insta::assert_snapshot!(said);
}
