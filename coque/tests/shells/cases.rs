//! Load cases of linear answers: against scenes of one case each, superposed, in another order, mirrored; on solids; what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use crate::common::refused::refused;
use crate::common::{Replaced, overridden, ran, text};
use coque::accuracy::{Asked, ClimbError};
use coque::{Ended, Outcome, Scene, Silent};

const SLAB: &str = "two-span-cases.toml";

/// A case, and the keys of a load with its numbers times a factor.
type Acts = (&'static str, fn(f64) -> String);

/// What acts on the plate: its case, and its line with all numbers times a factor.
const LOADS: [Acts; 5] = [
    ("pushed", |f| format!("on = \"corner\", force = {{ total = [{:?}, {:?}, {:?}] }}", 0.4 * f, 0.2 * f, f)),
    ("pushed", |f| format!("on = \"v1\", couple = {{ moment = {:?}, axis = [1, 0, 0] }}", 0.3 * f)),
    ("blown", |f| format!("on = \"all\", pressure = {{ value = {:?}, follower = true }}", 20.0 * f)),
    ("heavy", |f| format!("on = \"all\", gravity = {{ acceleration = [0, 0, {:?}] }}", -9.81 * f)),
    ("warm", |f| {
        format!("on = \"all\", temperature = {{ change = {:?}, difference = {:?} }}", 5.0 * f, 8.0 * f)
    }),
];

/// A plate askew to its loads, with follower pressure, heat, a couple, weight and a moved particle, and columns of many kinds: with a case to each, or
/// with some times factors and without cases.
fn plate(factors: Option<&[(&str, f64)]>) -> String {
    let factor = |name: &str| match factors {
        None => Some(1.0),
        Some(factors) => factors.iter().find(|(own, _)| *own == name).map(|(_, factor)| *factor),
    };
    let case = |name: &str| if factors.is_none() { format!(", case = \"{name}\"") } else { String::new() };
    let lines = LOADS
        .iter()
        .filter_map(|(name, line)| Some(format!("{{ {}{} }},\n", line(factor(name)?), case(name))));
    let loads: String = lines.collect();
    let by = 1e-4 * factor("lifted").unwrap_or_default();
    format!(
        r#"
title = "Plate"
units = {{ length = "m", force = "N", time = "s" }}
geometry.plate = {{ lengths = [0.4, 0.3], particles = [7, 6] }}
material.elastic = {{ young = 70e9, poisson = 0.3, density = 2700.0, expansion = 2e-5 }}
section.homogeneous = {{ thickness = 0.004 }}
sets.corner = {{ nearest = [0.4, 0.3, 0.0] }}
supports = [
    {{ on = "u0", clamped = {{}} }},
    {{ on = "u1v0", moved = {{ direction = [0, 0, 1], by = {by:?} }}{} }},
]
loads = [
{loads}]
curve = [
    {{ name = "w", of = "displacement", on = "corner", direction = [0.1, 0.3, 1.0] }},
    {{ name = "far", of = "displacement", on = "all", direction = [0, 0, 1], take = "max" }},
    {{ name = "x", of = "position", on = "corner", direction = [1, 0, 0] }},
    {{ name = "turn", of = "rotation", on = "corner", direction = [0, 1, 0] }},
    {{ name = "R", of = "reaction", on = "u0", direction = [0, 0, 1] }},
    {{ name = "S", of = "von-mises", on = "all", take = "max" }},
]
"#,
        case("lifted")
    )
}
const COMBINED: &str = r#"
[[analysis.linear.combinations]]
name = "all"
of = { pushed = 1.35, blown = -2.0, heavy = 1.0, warm = 0.5, lifted = 1.5 }
[[analysis.linear.combinations]]
name = "two"
of = { blown = 1.5, pushed = 0.9 }
"#;

fn solved(text: &str) -> Outcome {
    let outcome = ran(Scene::parse(text, "cases.toml"));
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

/// Rows by name of the case, without its number.
fn rows(outcome: &Outcome) -> BTreeMap<String, Vec<f64>> {
    let cases = &outcome.summary.cases.as_ref().unwrap().cases;
    let rows = cases.iter().zip(&outcome.curve.rows);
    rows.map(|(case, row)| (case.set.name.clone(), row[1..].to_vec())).collect()
}

/// The row of the plate under some of its loads, each times a factor, in a scene without cases.
fn alone(factors: &[(&str, f64)]) -> Vec<f64> {
    solved(&format!("{}\nanalysis.linear = {{}}\n", plate(Some(factors)))).curve.rows[0].clone()
}

/// Greatest difference of two rows over the size of each number.
fn off(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let one = |(x, y): (&f64, &f64)| (x - y).abs() / x.abs().max(y.abs()).max(1e-12);
    a.iter().zip(b).map(one).fold(0.0, f64::max)
}

/// Columns but for the number of solves and of pivots.
fn measured(row: &[f64]) -> Vec<f64> {
    [&row[1..2], &row[4..]].concat()
}

#[test]
fn each_case_is_the_scene_with_its_loads_alone_and_one_factor_serves_all() {
    let outcome = solved(&format!("{}analysis.linear = {{}}\n", plate(None)));
    let found = rows(&outcome);
    assert_eq!((outcome.summary.record.factorisations, outcome.summary.record.solves), (1, 5));
    for case in ["pushed", "blown", "heavy", "warm", "lifted"] {
        let [a, b] = [&found[case], &alone(&[(case, 1.0)])].map(|row| measured(row));
        assert!(off(&a, &b) < 1e-9, "{case}: {a:?} {b:?}");
    }
}

/// Directors that turn, and an edge that turns as one body, each in a case beside a force: the scene with that motion alone, and standing still under the force.
#[test]
fn motions_that_turn_are_cases() {
    let scene = |motion: &str, [by, force]: [f64; 2], cases: [&str; 2]| {
        let [turn, push] = cases;
        format!(
            "title = 'Plate'
            units = {{ length = 'm', force = 'N', time = 's' }}
            geometry.plate = {{ lengths = [0.4, 0.3], particles = [7, 6] }}
            material.elastic = {{ young = 70e9, poisson = 0.3, density = 2700.0 }}
            section.homogeneous = {{ thickness = 0.004 }}
            supports = [
                {{ on = 'u0', clamped = {{}} }},
                {{ on = 'u1', {motion}, by = {by:?} }}{turn} }},
            ]
            loads = [{{ on = 'all', gravity = {{ acceleration = [0, 0, {force:?}] }}{push} }}]
            analysis.linear = {{}}
            sets.middle = {{ nearest = [0.2, 0.15, 0.0] }}
            curve = [
                {{ name = 'w', of = 'displacement', on = 'middle', direction = [0.1, 0.3, 1.0] }},
                {{ name = 'turn', of = 'rotation', on = 'u1', direction = [0.5, 1, 0] }},
                {{ name = 'R', of = 'reaction', on = 'u0', direction = [0, 0, 1] }},
            ]"
        )
    };
    let cases = [", case = 'turn'", ", case = 'push'"];
    for motion in [
        "rotated = { axis = [0, 1, 0]",
        "turned = { axis = [0, 1, 0], point = [0.4, 0, 0]",
        "turned = { axis = [1, 0.2, 0], point = [0.4, 0.1, 0]",
    ] {
        let found = rows(&solved(&scene(motion, [0.05, -9.81], cases)));
        for (case, size) in [("turn", [0.05, 0.0]), ("push", [0.0, -9.81])] {
            let alone = solved(&scene(motion, size, [""; 2])).curve.rows[0].clone();
            let [a, b] = [&found[case], &alone].map(|row| measured(row));
            // In sizes of the greater of both cases: what symmetry makes zero is rounding.
            for (at, (a, b)) in a.iter().zip(&b).enumerate() {
                let size = found.values().map(|row| measured(row)[at].abs()).fold(0.0, f64::max);
                assert!(size > 0.0 && (a - b).abs() < 1e-9 * size, "{motion}, {case}, {at}: {a} {b}");
            }
        }
    }
}

/// One factor and a solve for each case are forecast, none of a combination; and no accuracy, as no errors are found.
#[test]
fn a_forecast_counts_cases() {
    let scene = Scene::parse(&format!("{}{COMBINED}", plate(None)), "cases.toml").unwrap();
    let estimate = scene.build(1).unwrap().estimate();
    assert_eq!((estimate.steps, estimate.solves), (Some([1.0; 2]), Some([5.0; 2])));
    let iterated = [("analysis.linear.solver".to_string(), "conjugate-gradients".to_string())];
    let text = format!("{}{COMBINED}", plate(None));
    let iterated =
        Scene::with_overrides(&text, "cases.toml", &iterated).unwrap().build(1).unwrap().estimate();
    assert_eq!(iterated.solves, Some([5.0; 2]));
    assert_eq!(iterated.seconds, Some([5.0 * iterated.seconds_a_step; 2]));
    let asked = Asked { accuracy: 0.01, within: std::time::Duration::from_secs(1), lattices: 2, threads: 1 };
    let refused = scene.forecast(&asked, &mut |_, _| ControlFlow::Continue(()));
    assert!(matches!(refused, Err(ClimbError::Silent(why)) if why.contains("without `case`")));
    let outcome = scene.build(1).unwrap().run(&mut Silent);
    let errors = scene.errors(&outcome, 1, &mut Silent);
    assert!(errors.without.iter().any(|why| why.contains("without `case`")) && errors.columns.is_empty());
}

#[test]
fn one_case_has_the_bits_of_the_scene_without() {
    for name in ["scordelis-lo.toml", "bimetal-strip.toml", "plate-clamped-solid.toml"] {
        let own = text(name);
        let linear: Replaced = &[("analysis", "{ linear = {} }")];
        let count = overridden(&own, name, linear).unwrap().loads.len();
        let paths: Vec<String> = (0..count).map(|i| format!("loads[{i}].case")).collect();
        let cases: Vec<(&str, &str)> =
            paths.iter().map(|path| (path.as_str(), "only")).chain([linear[0]]).collect();
        let [without, with] = [linear, &cases[..]].map(|replaced| ran(overridden(&own, name, replaced)));
        assert_eq!(with.curve.rows.len(), 1, "{name}");
        assert_eq!(without.curve.rows[0], with.curve.rows[0][1..], "{name}");
        assert_eq!(without.shapes[0].positions, with.shapes[0].positions, "{name}");
    }
}

#[test]
fn a_combination_is_a_run_under_loads_times_their_factors() {
    let found = rows(&solved(&format!("{}{COMBINED}", plate(None))));
    let all = [("pushed", 1.35), ("blown", -2.0), ("heavy", 1.0), ("warm", 0.5), ("lifted", 1.5)];
    let two = [("blown", 1.5), ("pushed", 0.9)];
    for (name, factors) in [("all", &all[..]), ("two", &two)] {
        let [a, b] = [&found[name], &alone(factors)].map(|row| measured(row));
        assert!(off(&a, &b) < 1e-9, "{name}: {a:?} {b:?}");
    }
}

/// Iterations end at 1e-9 in the energy norm; a reaction, stiffnesses times ways, keeps 2e-7.
#[test]
fn by_conjugate_gradients_they_are_the_same() {
    let slab = text(SLAB);
    let direct = rows(&ran(overridden(&slab, SLAB, &[])));
    let iterated = ran(overridden(&slab, SLAB, &[("analysis.linear.solver", "conjugate-gradients")]));
    for (name, row) in rows(&iterated) {
        let own = &direct[&name];
        // Without the count of pivots.
        assert!(off(&[&own[..2], &own[4..]].concat(), &[&row[..2], &row[3..]].concat()) < 1e-6, "{name}");
    }
}

#[test]
fn the_order_of_cases_changes_no_bit() {
    let one = format!("{}{COMBINED}", plate(None));
    let (head, rest) = one.split_once("loads = [\n").unwrap();
    let (loads, rest) = rest.split_once("]\ncurve").unwrap();
    let turned: Vec<&str> = loads.lines().rev().collect();
    let other = format!("{head}loads = [\n{}\n]\ncurve{rest}", turned.join("\n"));
    let [a, b] = [one, other].map(|text| solved(&text));
    let names = |outcome: &Outcome| -> Vec<String> {
        outcome.summary.cases.as_ref().unwrap().cases.iter().map(|case| case.set.name.clone()).collect()
    };
    assert_ne!(names(&a), names(&b));
    // The force and the couple of one case change places too: their sum is rounded otherwise.
    let (a, b) = (rows(&a), rows(&b));
    for name in ["blown", "heavy", "warm", "lifted"] {
        assert_eq!(a[name], b[name], "{name}");
    }
    assert!(off(&a["all"], &b["all"]) < 1e-12 && off(&a["pushed"], &b["pushed"]) < 1e-12);
}

/// The slab is its own mirror image, people change sides, and so do the columns, what is least and greatest of them, and where.
#[test]
fn a_mirrored_envelope_is_the_envelope_mirrored() {
    let outcome = ran(overridden(&text(SLAB), SLAB, &[]));
    let envelope = &outcome.summary.cases.as_ref().unwrap().envelope;
    let of = |name: &str| envelope.iter().find(|own| own.column.name == name).unwrap();
    let mirrored = |name: &str| match name {
        "left-span" => "right-span".to_string(),
        "right-span" => "left-span".to_string(),
        other => other.to_string(),
    };
    for (a, b) in [("R_left", "R_right"), ("w_left", "w_right"), ("R_middle", "R_middle")] {
        let (a, b) = (of(a), of(b));
        assert!((a.least / b.least - 1.0).abs() < 1e-9 && (a.greatest / b.greatest - 1.0).abs() < 1e-9);
        assert_eq!(
            [&a.least_in, &a.greatest_in].map(|name| mirrored(name)),
            [b.least_in.clone(), b.greatest_in.clone()]
        );
    }
    let mut table = Vec::new();
    outcome.summary.cases.as_ref().unwrap().write_csv(&outcome.curve, &mut table).unwrap();
    let table = String::from_utf8(table).unwrap();
    let first: Vec<&str> = table.lines().map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(first[..3], ["case", "weight", "people-left"]);
    assert_eq!(first[first.len() - 4..], ["(least)", "(least in)", "(greatest)", "(greatest in)"]);
}

/// Solids of bonds, Galerkin solids, two shells on springs between them: combinations against sums of the rows of cases, whose columns are all linear.
#[test]
fn answers_of_other_bodies_superpose() {
    let solid = |formulation: &str| {
        format!(
            r#"
title = "Block"
units = {{ length = "-", force = "-", time = "-" }}
bodies.block.solid.geometry.block = {{ lengths = [2, 1, 1], spacing = 0.5 }}
bodies.block.solid.material.elastic = {{ young = 1, poisson = 0.25, density = 1 }}
bodies.block.solid.formulation.{formulation}
supports = [{{ on = "x0", clamped = {{}} }}]
loads = [
    {{ on = "x1", traction = {{ value = [0, 1e-3, 0] }}, case = "a" }},
    {{ on = "all", gravity = {{ acceleration = [2e-3, 0, 1e-3] }}, case = "b" }},
]
curve = [{{ name = "u", of = "displacement", on = "x1", direction = [0.3, 0.2, 1] }}, {{ name = "R", of = "reaction", on = "x0", direction = [1, 1, 1] }}]
[[analysis.linear.combinations]]
name = "c"
of = {{ a = 1.5, b = -0.5 }}
"#
        )
    };
    let joined = text("joined-cantilevers.toml");
    let cases = [
        ("analysis", "{ linear = { combinations = [{ name = \"c\", of = { a = 1.5, b = -0.5 } }] } }"),
        ("loads[0].case", "a"),
        ("loads[+]", "{ on = \"all\", gravity = { acceleration = [0, 0, -1] }, case = \"b\" }"),
    ];
    for outcome in [
        solved(&solid("state-based = { horizon = 1.5 }")),
        solved(&solid("galerkin = {}")),
        ran(overridden(&joined, "joined-cantilevers.toml", &cases)),
    ] {
        assert_eq!(outcome.ended, Ended::Done);
        let found = rows(&outcome);
        for at in 4..found["a"].len() {
            let [a, b, c] = ["a", "b", "c"].map(|name| found[name][at]);
            let sum = 1.5 * a - 0.5 * b;
            assert!(c != 0.0 && (c - sum).abs() < 1e-8 * (a.abs() + b.abs()), "{at}: {a} {b} {c}");
        }
    }
}

#[test]
fn what_does_not_superpose_is_refused() {
    let scene = format!("{}{COMBINED}", plate(None));
    let said = refused(
        &scene,
        &[
            ("a load without a case", ", case = \"blown\"", ""),
            ("a support that stands still with a case", "clamped = {} }", "clamped = {}, case = \"blown\" }"),
            ("a motion without a case", ", case = \"lifted\"", ""),
            ("a case that there is not", "blown = -2.0", "blwon = -2.0"),
            ("a combination called like a case", "name = \"two\"", "name = \"warm\""),
            ("a combination of nothing", "of = { blown = 1.5, pushed = 0.9 }", "of = {}"),
            ("a name that is none of a file", "case = \"blown\"", "case = \"blown away/\""),
            (
                "levels",
                "\n[[analysis.linear.combinations]]\nname = \"all\"\nof = { pushed = 1.35, blown = -2.0, heavy = 1.0, warm = 0.5, lifted = 1.5 }\n[[analysis.linear.combinations]]\nname = \"two\"\nof = { blown = 1.5, pushed = 0.9 }\n",
                "\nanalysis.static = { levels = 2 }\n",
            ),
            (
                "a gas",
                "pressure = { value = 20.0, follower = true }",
                "gas = { pressure = 20.0, beside = 1.0 }",
            ),
            (
                "a set moved in two cases",
                "supports = [",
                "supports = [\n{ on = \"u1v0\", moved = { direction = [0, 0, 2], by = 1.0 }, case = \"sunk\" },",
            ),
            ("errors", "title = \"Plate\"", "title = \"Plate\"\nerror = {}"),
            ("figures over no time", "title = \"Plate\"", "title = \"Plate\"\noutput.over_time = true"),
            ("a column called case", "name = \"w\"", "name = \"case\""),
        ],
    );
    insta::assert_snapshot!(said);
}
