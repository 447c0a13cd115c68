//! Modes and buckling of touched states, contact as a preload left it: closed forms, other names for the same, what is doubtful, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{Replaced, column, refusal, run};
use coque::{Ended, Outcome, WarningKind};

const BEAM: &str = "propped-cantilever.toml";
const COLUMN: &str = "column-between-tools.toml";
const FAR: &str = "{ name = 'far', sphere = { centre = [0.3, 0.0, 9.0], radius = 1.0 } }";

fn done(outcome: Outcome) -> Outcome {
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

fn frequencies(replaced: Replaced) -> Vec<f64> {
    column(&done(run(BEAM, replaced)), "circular_frequency")
}

fn levels(replaced: Replaced) -> Vec<f64> {
    column(&done(run(COLUMN, replaced)), "level")
}

fn near(found: &[f64], wanted: &[f64], tolerance: f64) {
    let off = found.iter().zip(wanted).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
    assert!(found.len() == wanted.len() && off < tolerance, "{found:?} {wanted:?}: {off:.1e}");
}

fn contact_warnings(outcome: &Outcome) -> Vec<&str> {
    let all = outcome.summary.record.warnings.iter();
    all.filter(|own| own.kind == WarningKind::FrozenContact).map(|own| &own.message[..]).collect()
}

/// β L of a clamped–propped beam, √(B/ρt) = √.1: 2e-4, 6e-4 and 1.2e-3 off, the lattice of 80 cells. Lifted off its flat it is a cantilever.
#[test]
fn an_end_that_bears_on_a_flat_is_propped() {
    let of = |roots: [f64; 3]| roots.map(|root| root * root * 0.1_f64.sqrt());
    let propped = done(run(BEAM, &[]));
    near(&column(&propped, "circular_frequency"), &of([3.926602, 7.068583, 10.210176]), 3e-3);
    assert!(propped.summary.record.warnings.is_empty(), "{:?}", propped.summary.record.warnings);
    assert!(propped.summary.record.contacts[0].greatest_area > 0.0);
    let free = frequencies(&[("loads[0].force.total", "[0.0, 0.0, 0.0001]")]);
    near(&free, &of([1.875104, 4.694091, 7.854757]), 3e-3);
}

/// 4 π²B/L² and what the halves bear that are clamped at the middle, 2.0457 times that: 7e-4 and 1.4e-3 off.
#[test]
fn a_column_that_tools_grip_buckles_in_halves() {
    let found = levels(&[]);
    near(&found, &[1.0, 2.0457, 4.0], 6e-3);
    near(&levels(&[("tools", "[]")])[..1], &[0.25], 6e-3);
}

/// What the tools press with hardly counts (round ones bear a part of the force along the column: 1e-4), nor which is named first, nor one that
/// is far: the same bits there, nor the side from which a flat bears.
#[test]
fn a_grip_is_a_grip() {
    let found = levels(&[]);
    near(&levels(&[("tools[0].moved", "[0, 0, -6e-6]")]), &found, 3e-4);
    let tool = |name: &str, z: f64, moved: &str| {
        format!(
            "{{ name = '{name}', capsule = {{ ends = [[0.5, -1, {z}], [0.5, 1, {z}]], radius = 0.05 }}{moved} }}"
        )
    };
    let (above, below) =
        (tool("above", 0.055, ", moved = [0, 0, -2e-6], preload = true"), tool("below", -0.055, ""));
    near(&levels(&[("tools", &format!("[{below}, {above}]"))]), &found, 1e-10);
    assert_eq!(levels(&[("tools[+]", FAR)]), found);
    let bears = frequencies(&[]);
    assert_eq!(frequencies(&[("tools[+]", FAR)]), bears);
    // From above in place of from below.
    let mirrored = [
        ("tools[0].plane", "{ point = [0, 0, 0.007], normal = [0, 0, -1] }"),
        ("loads[0].force.total", "[0.0, 0.0, 0.1]"),
    ];
    near(&frequencies(&mirrored), &bears, 1e-8);
}

/// Friction holds an end that would slide along its flat: the frequency along the strip is that of a bar with both ends held, ½ c/L, in place of ¼.
#[test]
fn what_grips_sticks() {
    let along = |friction: &'static str| {
        let held = "[{ on = 'all', held = { displacement = [[0, 1, 0]] } }, { on = 'u0', clamped = {} }]";
        // So thick that its frequency along is among the first; contact far stiffer than the strip.
        let thick = [("section.homogeneous.thickness", "0.4"), ("tools[0].plane.point", "[0, 0, -0.201]")];
        let replaced = [
            ("supports", held),
            ("tools[0].friction", friction),
            ("tools[0].stiffness", "1e4"),
            ("loads[0].force.total", "[0.0, 0.0, -1000.0]"),
            ("analysis.modal.modes", "6"),
        ];
        done(run(BEAM, &[&thick[..], &replaced].concat()))
    };
    let speed = (1.2e7_f64 / 1000.0).sqrt();
    // Measured 1e-4 and 2.7e-3 off.
    let has = |outcome: &Outcome, part: f64| {
        let wanted = std::f64::consts::TAU * part * speed;
        column(outcome, "circular_frequency").iter().any(|own| (own / wanted - 1.0).abs() < 8e-3)
    };
    let [rough, smooth] = [along("0.5"), along("0")];
    assert!(has(&smooth, 0.25) && !has(&smooth, 0.5), "{:?}", column(&smooth, "circular_frequency"));
    assert!(has(&rough, 0.5) && !has(&rough, 0.25), "{:?}", column(&rough, "circular_frequency"));
}

/// A force that hardly presses lets go at once; a load that pulls the column off its tools before it buckles does so by the linear answer.
#[test]
fn contact_that_would_change_is_warned_of() {
    let pressed = done(run(BEAM, &[]));
    assert!(contact_warnings(&pressed).is_empty());
    let hardly = done(run(BEAM, &[("loads[0].force.total", "[0.0, 0.0, -0.0007]")]));
    let said = contact_warnings(&hardly);
    assert!(said.len() == 1 && said[0].contains("mode 3 opens it at [1.0"), "{said:?}");
    let aside = "{ on = 'all', force = { total = [0.0, 0.0, 400.0], by_area = true } }";
    let pulled = done(run(COLUMN, &[("loads[+]", aside)]));
    let said = contact_warnings(&pulled);
    assert!(said.len() == 1 && said[0].contains("the load opens it at [0.5"), "{said:?}");
    assert!(contact_warnings(&done(run(COLUMN, &[]))).is_empty());
}

/// Half a ring that two forces pinch until its walls meet: its frequencies hang on the force between them, not on how stiff contact is. Measured
/// 3e-4 for four times the stiffness.
#[test]
fn a_ring_pressed_on_itself_vibrates_the_same_however_stiff_its_contact() {
    let of = |contact: &'static str, force: f64| {
        let push = |on: &str, force: f64| {
            format!("{{ on = '{on}', force = {{ total = [0, 0, {force:.1}] }}, preload = true }}")
        };
        let loads = format!("[{}, {}]", push("u0", -force), push("u1", force));
        let modal = ("analysis", "{ modal = { modes = 3 } }");
        let replaced = [
            ("geometry.cylinder.particles", "[41, 3]"),
            ("loads", &loads[..]),
            ("contact", contact),
            modal,
            ("curve", "[]"),
            ("output", "{}"),
        ];
        done(run("ring-in-itself.toml", &replaced))
    };
    let [once, four] = ["[{}]", "[{ stiffness = 4.0 }]"].map(|contact| of(contact, 10.0));
    assert!(once.summary.record.contacts[0].greatest_area > 0.0);
    near(&column(&four, "circular_frequency"), &column(&once, "circular_frequency"), 1e-3);
    // While its walls are apart it is one without contact.
    let [apart, without] = ["[{}]", "[]"].map(|contact| column(&of(contact, 1.0), "circular_frequency"));
    near(&apart, &without, 1e-9);
}

#[test]
fn what_does_not_go_together() {
    let own = "[{ friction = 0.3 }]";
    let cases: [(&str, &str, Replaced); 9] = [
        ("modes without a preload", BEAM, &[("loads[0].preload", "false")]),
        (
            "contact with itself without a preload",
            BEAM,
            &[("loads[0].preload", "false"), ("tools", "[]"), ("contact", "[{}]")],
        ),
        ("a tool that moves with the level", BEAM, &[("tools[0].moved", "[0, 0, 1]")]),
        ("a preload of a tool that stands", BEAM, &[("tools[0].preload", "true")]),
        (
            "a preload in time",
            COLUMN,
            &[("analysis", "{ explicit = { transient = { duration = 1, record_every = 0.1 } } }")],
        ),
        ("friction of the shell on itself", BEAM, &[("contact", own)]),
        ("fields of contact", BEAM, &[("output.fields", "{ contact = true }")]),
        ("a tool that stands in the shell at the start", COLUMN, &[("tools[0].capsule.radius", "0.051")]),
        (
            "two bodies",
            "two-cantilevers.toml",
            &[("analysis", "{ modal = { modes = 2 } }"), ("curve", "[]"), ("output", "{}")],
        ),
    ];
    let said = cases.map(|(name, scene, replaced)| format!("== {name}\n{}\n", refusal(scene, replaced, 100)));
    insta::assert_snapshot!(said.concat());
}
