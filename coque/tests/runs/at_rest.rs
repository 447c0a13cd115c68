//! What is called settled is an equilibrium, or says that it is not: for any damping, any period, and unstable states.
//!
//! `cargo test --workspace --test runs at_rest -- --nocapture` prints the table of docs/at-rest.md.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use coque::{Ended, Outcome, Scene, Silent, WarningKind};

const PATH: &str = "analysis.explicit.quasi-static";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn text(scene: &str) -> String {
    fs::read_to_string(root().join("scenes").join(scene)).unwrap()
}

fn run(text: &str, set: &[(String, String)]) -> Outcome {
    let outcome = Scene::with_overrides(text, "test.toml", set).unwrap().build(1).unwrap().run(&mut Silent);
    assert_eq!(outcome.ended, Ended::Done);
    outcome
}

fn set(pairs: &[(&str, &str)]) -> Vec<(String, String)> {
    pairs.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect()
}

fn last(outcome: &Outcome, column: &str) -> f64 {
    let at = outcome.curve.columns.iter().position(|known| known.name == column).unwrap();
    outcome.curve.rows.last().unwrap()[at]
}

fn warned(outcome: &Outcome, kind: WarningKind) -> bool {
    outcome.summary.record.warnings.iter().any(|warning| warning.kind == kind)
}

/// A coarse shell, its period and one number that is read off.
struct Problem {
    scene: &'static str,
    grid: (&'static str, &'static str),
    level: &'static str,
    period: f64,
    column: &'static str,
}

const PROBLEMS: [Problem; 3] = [
    Problem {
        scene: "ring.toml",
        grid: ("geometry.plate.particles", "[9, 3]"),
        level: "[0.125]",
        period: 17.9,
        column: "W_tip",
    },
    Problem {
        scene: "panel.toml",
        grid: ("geometry.cylinder.particles", "[7, 7]"),
        level: "[0.2]",
        period: 0.031,
        column: "P",
    },
    Problem {
        scene: "plate.toml",
        grid: ("geometry.plate.particles", "[9, 9]"),
        level: "[1.0]",
        period: 0.175,
        column: "w_centre",
    },
];

/// Damping, period in parts of the right one, ramp, hold.
const ROWS: [(&str, f64, f64, f64); 20] = [
    ("{ ratio = 0.01 }", 1.0, 1.0, 8.0),
    ("{ ratio = 0.1 }", 1.0, 1.0, 8.0),
    ("{ ratio = 0.3 }", 1.0, 1.0, 8.0),
    ("{ ratio = 1.0 }", 1.0, 1.0, 8.0),
    ("{ ratio = 3.0 }", 1.0, 1.0, 8.0),
    ("{ ratio = 10.0 }", 1.0, 1.0, 8.0),
    ("{ ratio = 100.0 }", 1.0, 1.0, 8.0),
    ("{ ratio = 100.0 }", 1.0, 1.0, 150.0),
    ("'kinetic'", 1.0, 1.0, 8.0),
    ("{ ratio = 1.0 }", 1.0, 0.05, 8.0),
    ("{ ratio = 1.0 }", 1.0, 3.0, 8.0),
    ("'kinetic'", 1.0, 0.05, 8.0),
    ("{ ratio = 0.1 }", 0.1, 1.0, 8.0),
    ("{ ratio = 1.0 }", 0.1, 1.0, 8.0),
    ("{ ratio = 1.0 }", 0.1, 1.0, 150.0),
    ("'kinetic'", 0.1, 1.0, 8.0),
    ("'kinetic'", 0.1, 1.0, 80.0),
    ("{ ratio = 0.1 }", 3.0, 1.0, 8.0),
    ("{ ratio = 10.0 }", 3.0, 1.0, 8.0),
    ("{ ratio = 1.0 }", 10.0, 1.0, 8.0),
];

#[test]
fn what_settles_is_right_whatever_the_damping_and_the_period() {
    let (mut settled, mut unsettled) = (0, 0);
    println!(
        "scene, damping, period, ramp, hold: error [%], kinetic/internal, out of balance, remaining displacement, steps"
    );
    for Problem { scene, grid, level, period, column } in PROBLEMS {
        let text = text(scene);
        let still = run(&text, &set(&[grid, ("analysis.static.levels", level)]));
        let exact = last(&still, column);
        for (damping, share, ramp, hold) in ROWS {
            let path = format!(
                "{{ levels = {level}, period = {}, ramp = {ramp}, hold = {hold}, damping = {damping} }}",
                share * period
            );
            let outcome = run(&text, &set(&[grid, (PATH, &path)]));
            let error = last(&outcome, column) / exact - 1.0;
            let reached = outcome.summary.record.levels[0];
            let row = format!(
                "{scene}, {damping}, {share}, {ramp}, {hold}: {:.3} %, {:.1e}, {:.1e}, {:.1e}, {}{}",
                100.0 * error,
                reached.kinetic_over_internal,
                reached.out_of_balance,
                reached.remaining_displacement,
                reached.steps,
                if reached.settled { "" } else { ", not settled" }
            );
            println!("{row}");
            assert_eq!(warned(&outcome, WarningKind::NotSettled), !reached.settled, "{row}");
            assert!(!reached.settled || error.abs() < 0.01, "{row}");
            settled += usize::from(reached.settled);
            unsettled += usize::from(!reached.settled);
        }
    }
    // A criterion that all meet, or none, would say nothing.
    assert!(settled > 30 && unsettled > 10, "{settled} settled, {unsettled} did not");
}

#[test]
fn a_period_that_is_not_given_is_found() {
    for Problem { scene, grid, level, period, column } in PROBLEMS {
        let text = text(scene);
        let exact = last(&run(&text, &set(&[grid, ("analysis.static.levels", level)])), column);
        let path = |period: &str| set(&[grid, (PATH, &format!("{{ levels = {level}{period} }}"))]);
        let given = run(&text, &path(&format!(", period = {period}")));
        let outcome = run(&text, &path(""));
        let [reached, known] = [&outcome, &given].map(|outcome| outcome.summary.record.levels[0]);
        let modes = run(&text, &set(&[grid, ("analysis.modal.modes", "1"), ("output", "{}")]));
        let lowest = 1.0 / last(&modes, "frequency");
        let (found, error) = (reached.period.unwrap(), last(&outcome, column) / exact - 1.0);
        println!(
            "{scene}: period {found}, lowest mode {lowest}, given {period}; error {error:.1e}; {:?} evaluations, {:?} by the given",
            reached.evaluations, known.evaluations
        );
        assert!(reached.settled && error.abs() < 0.01, "{scene}: {error} {reached:?}");
        // The loaded ring and plate are as stiff as unloaded ones within a percent or two; the panel has softened.
        let softer = if scene == "panel.toml" { 1.6 } else { 1.05 };
        assert!(found > 0.95 * lowest && found < softer * lowest, "{scene}: {found} {lowest}");
    }
}

/// A cantilever column (EI = 12 500, L = 10) under a load along it, in critical loads, and a part of it across.
fn column(load: f64, across: f64) -> Outcome {
    let critical = std::f64::consts::PI.powi(2) * 12_500.0 / 400.0;
    let force = format!("{{ total = [{}, 0.0, {}] }}", -load * critical, across * load * critical);
    // T₁ = 2π/(3.516/L² √(EI/ρt)).
    let path = "{ levels = [1.0], period = 1.13, stability = true }";
    let probe = "[{ name = \"w\", of = \"displacement\", on = \"u1\", direction = [0.0, 0.0, 1.0] }]";
    run(
        &text("column-buckling.toml"),
        &set(&[
            ("geometry.plate.particles", "[21, 3]"),
            ("section.homogeneous.thickness", "0.5"),
            ("loads.0.force", &force),
            ("curve", probe),
            ("analysis", &format!("{{ explicit = {{ quasi-static = {path} }} }}")),
        ]),
    )
}

#[test]
fn a_perfect_column_above_its_critical_load_is_warned_of() {
    let outcome = column(2.02, 0.0);
    let reached = outcome.summary.record.levels[0];
    assert!(reached.settled && last(&outcome, "w").abs() < 1e-6, "{reached:?}");
    // The second mode comes at nine times the first load, the first across the width at four times.
    assert_eq!(reached.negative_pivots, Some(1));
    assert!(warned(&outcome, WarningKind::Unstable), "{:?}", outcome.summary.record.warnings);
}

#[test]
fn columns_that_stand_or_have_buckled_are_not_warned_of() {
    let straight = column(0.9, 0.0);
    assert_eq!(straight.summary.record.levels[0].negative_pivots, Some(0));
    assert!(straight.summary.record.warnings.is_empty(), "{:?}", straight.summary.record.warnings);
    let buckled = column(2.02, 0.01);
    assert_eq!(buckled.summary.record.levels[0].negative_pivots, Some(0));
    // Elastica: .795 L, and a little more from the load across.
    assert!(last(&buckled, "w") > 7.9, "{}", last(&buckled, "w"));
    assert!(buckled.summary.record.warnings.is_empty(), "{:?}", buckled.summary.record.warnings);
}

#[test]
fn a_look_at_stability_changes_no_bit_and_what_was_not_looked_at_is_said() {
    let ring = |stability: &str| {
        let path = format!("{{ levels = [0.125, 0.25], period = 17.9{stability} }}");
        run(&text("ring.toml"), &set(&[("geometry.plate.particles", "[9, 3]"), (PATH, &path)]))
    };
    let (looked, not) = (ring(", stability = true"), ring(", stability = false"));
    assert_eq!(looked.curve.rows, not.curve.rows);
    assert_eq!(looked.shapes, not.shapes);
    let pivots = |outcome: &Outcome| -> Vec<_> {
        outcome.summary.record.levels.iter().map(|level| level.negative_pivots).collect()
    };
    assert_eq!((pivots(&looked), pivots(&not)), (vec![Some(0); 2], vec![None; 2]));
    let said = |outcome: &Outcome| {
        outcome.summary.body.left_out.iter().any(|line| line.contains("stability at 2 of 2"))
    };
    assert!(!said(&looked) && said(&not), "{:?}", not.summary.body.left_out);
}

fn coque(name: &str, arguments: &[&str]) -> (Output, PathBuf) {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("at-rest").join(name);
    let _ = fs::remove_dir_all(&out);
    let output = Command::new(env!("CARGO_BIN_EXE_coque"))
        .args(arguments)
        .args(["--out".as_ref(), out.as_os_str()])
        .args(["--set", "geometry.plate.particles=[9, 3]", "--set"])
        .arg(format!("{PATH}.levels=[0.125, 0.25]"))
        .current_dir(root())
        .output()
        .unwrap();
    (output, out)
}

#[test]
fn an_unsettled_run_ends_with_a_code_and_a_last_line_of_its_own() {
    let scene = "scenes/ring.toml";
    let ratio = format!("{PATH}.damping.ratio=100.0");
    let (output, out) = coque("run", &["run", scene, "--set", &ratio]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(4), "{said}");
    assert_eq!(said.lines().last(), Some("not settled: 0.125, 0.25"), "{said}");
    assert!(said.contains("warning: level 0.125 did not settle"), "{said}");
    assert!(out.join("curve.csv").exists());
    let summary: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(out.join("summary.json")).unwrap()).unwrap();
    assert_eq!((&summary["ended"], &summary["warnings"][1]["kind"]), (&"done".into(), &"not-settled".into()));
    assert!(summary["levels"][0]["remaining_displacement"].as_f64().unwrap() > 0.1, "{summary}");

    let over = format!("{PATH}.damping.ratio=1.0,100.0");
    let (output, out) = coque("sweep", &["sweep", scene, "--over", &over]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(4), "{said}");
    assert!(said.contains("2 of 2 runs done") && said.contains("not settled: 1 of them"), "{said}");
    let table = fs::read_to_string(out.join("sweep.csv")).unwrap();
    let rows: Vec<&str> = table.lines().collect();
    assert!(
        rows[1].starts_with("1,1.0,done,,") && rows[2].starts_with("2,100.0,done,not-settled,"),
        "{table}"
    );
}
