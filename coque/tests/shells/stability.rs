//! What static runs say of limit points, bifurcations and states that no shell can be in.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{column, overridden, ran, text};
use coque::{Ended, Failure, Outcome, Scene, WarningKind};
use explicit_dynamics::MarchError;

/// A quarter of the force \[N\].
const FORCE: f64 = 750.0;

/// The hinged panel under a dead force at its crown, a quarter of 3 kN: more than it can bear.
fn panel(analysis: &str) -> Outcome {
    let text = text("panel.toml");
    let (head, rest) = text.split_once("[[supports]]\non = \"u0v0\"").unwrap();
    let (_, tail) = rest.split_once("[[curve]]").unwrap();
    let load = format!("[[loads]]\non = \"u0v0\"\nforce = {{ total = [0.0, 0.0, -{FORCE:?}] }}\n");
    let scene = format!("{head}{load}[analysis]\n{analysis}\n[[curve]]{tail}");
    ran(overridden(&scene, "panel.toml", &[("geometry.cylinder.particles", "[11, 11]")]))
}

fn warned(outcome: &Outcome) -> Vec<WarningKind> {
    outcome.summary.record.warnings.iter().map(|warning| warning.kind).collect()
}

#[test]
fn a_level_beyond_the_snap_names_the_limit_point_before_it() {
    let outcome = panel("static.levels = 10");
    assert_eq!(outcome.ended, Ended::Done, "the far side is an equilibrium, and is kept");
    let w = column(&outcome, "w_crown");
    assert!(w[7] < 9.0 && w[8] > 27.0, "{w:?}");
    assert!(column(&outcome, "negative_pivots").iter().all(|&count| count == 0.0), "nothing else tells");
    let [limit] = &outcome.summary.record.critical[..] else {
        panic!("{:?}", outcome.summary.record.critical)
    };
    assert_eq!(limit.kind, "limit point");
    // The path by arc length passes the same point.
    let path = panel("arc-length = { until = 0.9, steps = 200 }");
    let found = &path.summary.record.critical[0];
    assert!((limit.level / found.level - 1.0).abs() < 1e-6, "{limit:?} {found:?}");
    assert_eq!(warned(&outcome), [WarningKind::PassedCritical]);
    let message = &outcome.summary.record.warnings[0].message;
    for word in [&limit.place() as &str, "load level 0.8 ", "another branch", "[analysis.arc-length]"] {
        assert!(message.contains(word), "{word}: {message}");
    }
    assert_eq!(warned(&path), [], "a path over limit points is what was asked for");
}

/// A relaxation goes along with the snap: the energy that it sets free tells it, on coarse levels and on fine ones.
#[test]
fn a_relaxation_names_the_levels_between_which_it_snapped() {
    for (levels, between) in [("10", [0.7, 0.8]), ("[0.3, 0.6, 0.73, 0.75, 0.76, 1.0]", [0.73, 0.75])] {
        let outcome = panel(&format!("relaxation = {{ levels = {levels}, tolerance = 1e-5 }}"));
        assert_eq!(outcome.ended, Ended::Done);
        let [snap] = &outcome.summary.record.critical[..] else {
            panic!("{:?}", outcome.summary.record.critical)
        };
        let reported = snap.between.unwrap();
        assert!(
            (reported[0] - between[0]).abs() < 1e-12 && (reported[1] - between[1]).abs() < 1e-12,
            "{snap:?}"
        );
        assert_eq!(
            (snap.kind.as_str(), warned(&outcome)),
            ("change of branch", vec![WarningKind::PassedCritical])
        );
        let message = &outcome.summary.record.warnings[0].message;
        println!("{message}");
        for word in ["snapped", "times the energy", "another branch", "[analysis.arc-length]"] {
            assert!(message.contains(word), "{word}: {message}");
        }
        // The load's work by the trapezoidal rule is stored and, what the snap sets free, damped; between levels it is off by .1 and .5 %.
        let (levels, w) = (column(&outcome, "level"), column(&outcome, "w_crown"));
        let pairs = levels.windows(2).zip(w.windows(2));
        let work: f64 = pairs.map(|(level, w)| 0.5 * FORCE * (level[0] + level[1]) * (w[1] - w[0])).sum();
        let energies = &outcome.summary.record.energies;
        println!("{work} {energies:?}");
        assert!(energies.dissipated > 0.0);
        assert!((energies.external / work - 1.0).abs() < 0.015, "{work} {energies:?}");
        assert_eq!(energies.external, energies.internal + energies.dissipated);
    }
}

/// The crown pushed down step by step: at 12.7 mm its force falls and nothing snaps, at half of that the panel jumps at 17 mm.
#[test]
fn a_pushed_panel_snaps_where_its_path_turns_back_and_only_there() {
    let pushed = |thickness: &'static str, levels: &'static str| {
        let replaced = [
            ("geometry.cylinder.particles", "[11, 11]"),
            ("section.homogeneous.thickness", thickness),
            ("analysis", levels),
        ];
        ran(overridden(&text("panel.toml"), "panel.toml", &replaced))
    };
    for levels in ["5", "10", "30"] {
        let levels = format!("{{ relaxation = {{ levels = {levels}, tolerance = 1e-5 }} }}").leak();
        assert_eq!(warned(&pushed("12.7", levels)), [], "{levels}");
    }
    let outcome = pushed("6.35", "{ relaxation = { levels = 30, tolerance = 1e-5 } }");
    println!("{:?} {:?}", outcome.summary.record.critical, outcome.summary.record.warnings);
    assert_eq!(warned(&outcome), [WarningKind::PassedCritical]);
    let between = outcome.summary.record.critical[0].between.unwrap();
    assert!(between.iter().all(|level| (level * 30.0 - 17.0).abs() < 1.5), "{between:?} of 30 mm");
}

/// Turns by a full circle, in steps of 45° and more, leave a path as little as small ones do.
#[test]
fn what_turns_far_without_a_snap_is_not_doubted() {
    for (name, levels) in
        [("ring.toml", "6"), ("ring.toml", "16"), ("thin-ring.toml", "10"), ("hemisphere.toml", "4")]
    {
        let replaced =
            [("analysis", format!("{{ relaxation = {{ levels = {levels}, tolerance = 1e-5 }} }}"))];
        let coarse = match name {
            "ring.toml" => vec![("geometry.plate.particles", "[25, 3]")],
            "thin-ring.toml" => vec![("geometry.plate.particles", "[25, 3]")],
            _ => vec![("geometry.sphere.particles", "[9, 9]")],
        };
        let replaced: Vec<_> = replaced.iter().map(|(k, v)| (*k, v.as_str())).chain(coarse).collect();
        let outcome = ran(overridden(&text(name), name, &replaced));
        assert_eq!(outcome.ended, Ended::Done, "{name}");
        let warned = warned(&outcome);
        assert!(
            !warned.contains(&WarningKind::PassedCritical),
            "{name}: {:?}",
            outcome.summary.record.warnings
        );
    }
}

/// A straight bar held to its axis, pressed by a dead force; the force of Green–Lagrange strains is greatest at a
/// stretch of 1/√3: EA/(3√3).
const BAR: &str = r#"
title = "Bar"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [1.0, 0.2], particles = [11, 3] }
material.elastic = { young = 1000.0, poisson = 0.0, density = 1.0 }
section.homogeneous.thickness = 0.1
supports = [
    { on = "all", held = { displacement = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], director = [[1.0, 0.0, 0.0]] } },
    { on = "u0", clamped = {} },
]
loads = [{ on = "u1", force = { total = [-20.0, 0.0, 0.0] } }]
curve = [{ name = "u", of = "displacement", on = "u1", direction = [1.0, 0.0, 0.0] }]
"#;
/// 1/(3√3), in the unit of the bar's load, which is EA.
const GREATEST: f64 = 0.192_450_089_729_875_25;

fn bar(analysis: &str) -> Outcome {
    ran(Scene::parse(&format!("{BAR}analysis.{analysis}\n"), "bar.toml"))
}

#[test]
fn a_bar_pressed_beyond_its_greatest_load_does_not_go_through_its_clamp() {
    let outcome = bar("static.levels = [0.1, 0.18, 0.3]");
    let Ended::Diverged(Failure::Balance { .. }) = &outcome.ended else {
        panic!("{:?}, u = {:?}", outcome.ended, column(&outcome, "u"))
    };
    let (level, u) = (column(&outcome, "level"), column(&outcome, "u"));
    assert_eq!(level, [0.0, 0.1, 0.18], "the last good state is kept");
    // The stretch λ = 1 + u of these levels solves λ(1 − λ²)/2 = level.
    let stretch = 1.0 + u[2];
    assert!((0.5 * stretch * (1.0 - stretch * stretch) - 0.18).abs() < 1e-6, "{u:?}");
    assert!(level[2] < GREATEST && stretch > 1.0 / 3.0_f64.sqrt());
}

#[test]
fn a_march_that_pushes_the_bar_through_its_clamp_names_the_cell() {
    let (head, _) = BAR.split_once("loads = ").unwrap();
    let (_, curve) = BAR.split_once("\ncurve = ").unwrap();
    let head = head
        .replace("\n]\n", "\n    { on = \"u1\", moved = { direction = [-1.0, 0.0, 0.0], by = 2.28 } },\n]\n");
    let march = "explicit.quasi-static = { levels = [0.1, 0.3, 1.0], period = 2.0, tolerance = 1e-6 }";
    let outcome = ran(Scene::parse(&format!("{head}curve = {curve}analysis.{march}\n"), "bar.toml"));
    let Ended::Diverged(Failure::March(MarchError::OutOfBounds { found, last_good, .. })) = &outcome.ended
    else {
        panic!("{:?}", outcome.ended)
    };
    assert!(found.place.starts_with("cell "), "{found}");
    assert!(last_good.is_some());
    let u = column(&outcome, "u");
    assert!(u.iter().all(|u| *u > -0.9), "no row of a state out of bounds: {u:?}");
}

/// A straight column clamped at one end, free to bend, pressed beyond Euler's load: level 1 is π²EI/4L².
const COLUMN: &str = r#"
title = "Column"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [10.0, 1.0], particles = [21, 3] }
material.elastic = { young = 12e6, poisson = 0.0, density = 10.0 }
section.homogeneous.thickness = 0.1
supports = [{ on = "u0", clamped = {} }, { on = "all", held = { displacement = [[0.0, 1.0, 0.0]] } }]
loads = [{ on = "u1", force = { total = [-24.674011002723395, 0.0, 0.0] } }]
"#;

#[test]
fn a_straight_column_beyond_its_load_is_called_unstable() {
    let outcome =
        ran(Scene::parse(&format!("{COLUMN}analysis.static.levels = [0.5, 1.5, 2.0]\n"), "column.toml"));
    assert_eq!(outcome.ended, Ended::Done);
    let [critical] = &outcome.summary.record.critical[..] else {
        panic!("{:?}", outcome.summary.record.critical)
    };
    assert_eq!(critical.kind, "bifurcation");
    assert!((critical.level - 1.0).abs() < 0.01, "{critical:?}");
    assert_eq!(warned(&outcome), [WarningKind::PassedCritical, WarningKind::Unstable], "once each");
    assert!(outcome.summary.record.warnings[1].message.starts_with("from load level 1.5 on"));
}

/// Without a word from the scene a small body is looked at, however short the run; a large one is reported as not looked at.
#[test]
fn what_is_not_looked_at_is_reported() {
    let column = |particles: &str, more: &str| {
        let scene = format!(
            "title = \"Column\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\n\
             geometry.plate = {{ lengths = [1.0, 0.1], particles = {particles} }}\n\
             material.elastic = {{ young = 1e6, poisson = 0.0, density = 1.0 }}\nsection.homogeneous.thickness = 0.01\n\
             supports = [{{ on = \"u0\", clamped = {{}} }}]\n\
             loads = [{{ on = \"u1\", force.total = [-0.0415, 0, 0] }}] # twice the critical one\n\
             [analysis.explicit.quasi-static]\nlevels = [1.0]\nramp = 1.0\n{more}\n"
        );
        ran(Scene::parse(&scene, "column.toml"))
    };
    assert_eq!(warned(&column("[21, 3]", "")), [WarningKind::Unstable]);
    assert_eq!(warned(&column("[21, 3]", "stability = false")), []);
    let large = column("[321, 33]", "period = 0.004");
    assert!(warned(&large).contains(&WarningKind::StabilityUnknown), "{:?}", warned(&large));
    let looked = column("[321, 33]", "period = 0.004\nstability = true");
    assert!(
        warned(&looked).contains(&WarningKind::Unstable)
            && !warned(&looked).contains(&WarningKind::StabilityUnknown)
    );
}

#[test]
fn the_level_of_a_driven_path_is_a_force_with_its_unit() {
    let text = text("panel.toml").replace("[analysis.explicit.quasi-static]", "[other]");
    let (head, rest) = text.split_once("[other]").unwrap();
    let (_, tail) = rest.split_once("[[curve]]").unwrap();
    let scene = format!("{head}[analysis.static]\nlevels = [0.3, 0.4]\n[[curve]]{tail}");
    let outcome = ran(overridden(&scene, "panel.toml", &[("geometry.cylinder.particles", "[9, 9]")]));
    assert_eq!(outcome.ended, Ended::Done);
    let [limit] = &outcome.summary.record.critical[..] else {
        panic!("{:?}", outcome.summary.record.critical)
    };
    assert_eq!((limit.kind.as_str(), limit.unit.as_deref()), ("limit point", Some("N")));
    assert_eq!(limit.place(), format!("a force of {} N", limit.level));
    assert!((4.0 * limit.level / 2222.0 - 1.0).abs() < 5e-3, "a quarter of the panel's limit load");
    assert_eq!(warned(&outcome), [], "what a given displacement holds is stable");
}

/// Where a plate begins to touch, the path of an elastic tube has a kink, half of which the mean of the tangents on either side leaves unexplained.
#[test]
fn a_tool_that_begins_to_touch_is_no_change_of_branch() {
    let elastic = [
        ("material", "{ elastic = { young = 200e3, poisson = 0.3, density = 7.8e-9 } }"),
        ("curve", "[{ name = 'P', of = 'contact-force', on = 'all', direction = [0.0, 0.0, -1.0] }]"),
        ("output", "{}"),
        ("analysis.static.levels", "[0.025, 0.25]"),
    ];
    let outcome = ran(overridden(&text("tube-crushed.toml"), "tube-crushed.toml", &elastic));
    assert_eq!(outcome.ended, Ended::Done);
    assert_eq!(warned(&outcome), []);
    assert!(outcome.summary.record.critical.is_empty(), "{:?}", outcome.summary.record.critical);
}
