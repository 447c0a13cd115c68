//! Preloads in a scene: modes, buckling and paths of what was loaded before; what is refused; what the summary says.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{Replaced, column, last, overridden, ran, run, scene};
use coque::{Ended, Outcome, Rendering, WarningKind, render};

const TENSION: (&str, &str) = ("loads[0].force.total", "[39.4784, 0, 0]");

fn done(outcome: Outcome) -> Outcome {
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

fn lowest(replaced: Replaced) -> f64 {
    column(&done(run("pulled-strip.toml", replaced)), "circular_frequency")[0]
}

/// The square of a frequency grows by the tension over the buckling load; the end may be pulled or moved.
#[test]
fn a_tension_raises_the_frequencies_of_a_strip() {
    let pulled = done(run("pulled-strip.toml", &[TENSION]));
    let preload = pulled.summary.record.preload.clone().unwrap();
    assert!(preload.points == 1 && preload.newton_iterations > 0 && preload.negative_pivots == 0);
    // ½ N u with the shortening of a force that does not turn, u = NL/EA.
    assert!(
        (preload.internal / (0.5 * 39.4784_f64.powi(2) * 10.0 / 1.2e5) - 1.0).abs() < 2e-3,
        "{preload:?}"
    );
    let line = "force on u1, applied before the analysis".to_string();
    assert!(pulled.summary.body.modelled.contains(&line));
    let unloaded = lowest(&[("loads[0].preload", "false")]);
    let ratio = column(&pulled, "circular_frequency")[0] / unloaded;
    // 41 particles: the lattice buckles 1e-3 above Euler's load.
    assert!((ratio / 5.0_f64.sqrt() - 1.0).abs() < 1e-3, "{ratio}");
    // The end in place of the force: the stretch is N/EA but for its square.
    let moved = "{ on = \"u1\", moved = { direction = [1, 0, 0], by = 3.2899e-3 }, preload = true }";
    let by_motion = lowest(&[("loads", "[]"), ("supports[+]", moved)]);
    assert!((by_motion / (ratio * unloaded) - 1.0).abs() < 1e-3, "{by_motion}");
}

/// Half of the load is there already: the other half remains, for the linearised levels and along the path.
#[test]
fn a_column_with_half_of_its_load_buckles_at_the_other_half() {
    let half = "{ on = \"u1\", force = { total = [-1.23370055, 0, 0] }, preload = true }";
    let whole = last(&done(run("column-buckling.toml", &[("analysis.buckling.modes", "1")])), "level");
    let modes = ("analysis.buckling.modes", "1");
    let rest = last(&done(run("column-buckling.toml", &[("loads[+]", half), modes])), "level");
    assert!((whole - rest - 0.5).abs() < 1e-4, "{whole} {rest}");
    let path = ("analysis", "{ arc-length = { until = 0.7, radius = 0.2 } }");
    let followed = done(run("column-buckling.toml", &[("loads[+]", half), path]));
    let point = &followed.summary.record.critical[0];
    assert!((point.level - rest).abs() < 1e-4, "{} {rest}", point.level);
    assert_eq!(column(&followed, "level")[0], 0.0);
}

const PUSHED: &str = r#"
title = "Stretched, then pushed"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [2.0, 0.5], particles = [17, 5] }
material.elastic = { young = 1e6, poisson = 0.3, density = 10.0 }
section.homogeneous.thickness = 0.02
supports = [
    { on = "u0", clamped = {} },
    { on = "u1", moved = { direction = [1, 0, 0], by = 0.01 }, preload = true },
    { on = "u1", moved = { direction = [0, 1, 0], by = 0.02 } },
]
loads = [
    { on = "all", pressure = { value = 20.0, follower = true }, preload = true },
    { on = "v0", force = { total = [0, 0, -10] } },
]
curve = [
    { name = "u", of = "displacement", on = "u1", direction = [1, 0, 0] },
    { name = "v", of = "displacement", on = "u1", direction = [0, 1, 0] },
    { name = "w", of = "displacement", on = "centre-column", direction = [0, 0, 1] },
    { name = "pull", of = "reaction", on = "u1", direction = [1, 0, 0] },
]
analysis.static = { levels = 2, tolerance = 1e-10 }
"#;

fn pushed(replaced: Replaced) -> Outcome {
    done(ran(overridden(PUSHED, "pushed.toml", replaced)))
}

/// Rows begin with the preload in full; the end is that of one load case, which has no preload.
#[test]
fn a_path_goes_on_from_the_preload_to_where_one_load_case_ends() {
    let apart = pushed(&[]);
    assert_eq!(column(&apart, "level"), [0.0, 0.5, 1.0]);
    assert!((column(&apart, "u")[0] - 0.01).abs() < 1e-12 && column(&apart, "v")[0].abs() < 1e-12);
    assert!(column(&apart, "w")[0] > 1e-3);
    let once = pushed(&[("supports[1].preload", "false"), ("loads[0].preload", "false")]);
    assert!(once.summary.record.preload.is_none());
    for name in ["u", "v", "w", "pull", "internal"] {
        let (a, b) = (last(&apart, name), last(&once, name));
        // Newton's tolerance.
        assert!((a / b - 1.0).abs() < 1e-8, "{name}: {a} {b}");
    }
}

#[test]
fn a_preload_beyond_its_limits_is_reported() {
    let much = ("loads[0].force.total", "[-12.0, 0, 0]");
    let outcome = run("pulled-strip.toml", &[much]);
    let record = &outcome.summary.record;
    assert_eq!(record.preload.as_ref().unwrap().negative_pivots, 1);
    let reported = record.warnings.iter().any(|warning| {
        warning.kind == WarningKind::PassedCritical
            && warning.message.starts_with("in the preload: beyond the bifurcation")
    });
    assert!(reported, "{:?}", record.warnings);
    assert!((record.preload.as_ref().unwrap().critical[0].level * 12.0 / 9.8696 - 1.0).abs() < 2e-3);
    // Crushed, it has no balance at all.
    let outcome = run("pulled-strip.toml", &[("loads[0].force.total", "[-1e7, 0, 0]")]);
    assert!(
        outcome.summary.ended.starts_with("the preload found no balance after"),
        "{}",
        outcome.summary.ended
    );
}

#[test]
fn what_cannot_be_preloaded_is_refused() {
    let refused =
        |name: &str, replaced: Replaced| match scene(name, replaced).and_then(|scene| scene.build(1)) {
            Ok(_) => panic!("{replaced:?} is not refused"),
            Err(error) => render(&error, Rendering { width: 200, colour: false }),
        };
    let yes = |path: &'static str| (path, "true");
    for (name, replaced, says) in [
        ("pulled-strip.toml", vec![("analysis", "{ linear = {} }")], "none in a linear analysis"),
        ("pulled-strip.toml", vec![("analysis", "{ relaxation = { levels = 1 } }")], "none in a relaxation"),
        (
            "pulled-strip.toml",
            vec![("analysis", "{ explicit.transient = { duration = 1, record_every = 1 } }")],
            "let an `amplitude` bring the load up",
        ),
        ("pulled-strip.toml", vec![yes("supports[0].preload")], "`moved`, `rotated` or `turned` beside it"),
        ("pulled-strip.toml", vec![("supports", "[]")], "leave the shell free to move"),
        ("pulled-strip.toml", vec![("analysis", "{ static = { levels = 1 } }")], "something that drives"),
        ("cantilever-solid.toml", vec![yes("loads[0].preload")], "only shells are preloaded"),
        (
            "pulled-strip.toml",
            vec![
                ("loads[+]", "{ on = \"u1\", force = { total = [-1, 0, 0] } }"),
                ("analysis", "{ buckling = { modes = 1, prebuckling = \"stress\" } }"),
            ],
            "analysis.buckling.prebuckling",
        ),
    ] {
        let text = refused(name, &replaced);
        assert!(text.contains(says), "{says} is not in\n{text}");
    }
}
