//! The linear analysis, the general support and the twisted strip: against beams, plates, the obstacle course of shells.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{Replaced, last, ran, scene};
use coque::{Checked, Ended, Outcome, Rendering, Scene, SceneError, WarningKind, render};

fn solved(scene: Result<Checked, SceneError>) -> Outcome {
    let outcome = ran(scene);
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

fn run(name: &str, replaced: Replaced) -> Outcome {
    solved(scene(name, replaced))
}

fn strip(rest: &str) -> Outcome {
    solved(Scene::parse(&format!("{STRIP}{rest}\n{GAUGES}"), "strip.toml"))
}

/// A cantilever strip without Poisson's ratio: a beam. L = 10, EI = E b h³ / 12 = 1000 \[N m²\].
const STRIP: &str = r#"
title = "Strip"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [10.0, 1.0], particles = [41, 5] }
material.elastic = { young = 12e6, poisson = 0.0, density = 10.0 }
section.homogeneous.thickness = 0.1
sets.tip = { nearest = [10.0, 0.5, 0.0] }
supports = [{ on = "u0", clamped = {} }]
"#;
const EI: f64 = 1000.0;
const GAUGES: &str = r#"
[[curve]]
name = "w"
of = "displacement"
on = "tip"
direction = [0, 0, 1]
[[curve]]
name = "z"
of = "position"
on = "tip"
direction = [1, 0, 1]
[[curve]]
name = "turn"
of = "rotation"
on = "tip"
direction = [0, -1, 0]
[[curve]]
name = "d_x"
of = "director"
on = "tip"
direction = [1, 0, 0]
[[curve]]
name = "root"
of = "reaction"
on = "u0"
direction = [0, 0, 1]
[[curve]]
name = "push"
of = "reaction"
on = "tip"
direction = [0, 0, 1]
"#;

fn pushed(force: f64, analysis: &str) -> Outcome {
    strip(&format!("loads = [{{ on = \"u1\", force = {{ total = [0, 0, {force:?}] }} }}]\n{analysis}"))
}

#[test]
fn a_cantilever_bends() {
    let outcome = pushed(3.0, "analysis.linear = {}");
    assert_eq!(outcome.curve.rows.len(), 1);
    assert_eq!(outcome.summary.analysis, "linear");
    assert_eq!(outcome.curve.columns[0].title(), "level [-]");
    assert_eq!((last(&outcome, "level"), last(&outcome, "negative_pivots")), (1.0, 0.0));
    // PL³/3EI and PL²/2EI.
    let (w, turn) = (1000.0 * 3.0 / (3.0 * EI), 100.0 * 3.0 / (2.0 * EI));
    for (name, exact) in [("w", w), ("turn", turn), ("d_x", -turn)] {
        assert!((last(&outcome, name) / exact - 1.0).abs() < 0.01, "{name}: {}", last(&outcome, name));
    }
    // Reference position and displacement together, along (1, 0, 1)/√2.
    let z = (10.0 + last(&outcome, "w")) / 2f64.sqrt();
    assert!((last(&outcome, "z") / z - 1.0).abs() < 1e-10);
    assert!((last(&outcome, "root") / -3.0 - 1.0).abs() < 1e-8, "{}", last(&outcome, "root"));
    let energy = 0.5 * 3.0 * last(&outcome, "w");
    assert!((last(&outcome, "internal") / energy - 1.0).abs() < 1e-3);
    // A tenth of the diagonal.
    let tip = outcome.shapes[0].positions.iter().map(|x| x.z.abs()).fold(0.0, f64::max);
    assert!((tip / (0.1 * 101f64.sqrt()) - 1.0).abs() < 1e-6, "{tip}");
}

#[test]
fn a_linear_answer_is_the_limit_of_small_loads() {
    let linear = pushed(3.0, "analysis.linear = {}");
    // At a millionth of the load the tip is a thousandth of the thickness down: (w/t)² is 1e-10.
    let small = pushed(3.0, "analysis.static.levels = [1e-6]");
    for name in ["w", "turn", "d_x", "root"] {
        let ratio = 1e6 * last(&small, name) / last(&linear, name);
        assert!((ratio - 1.0).abs() < 1e-6, "{name}: {ratio}");
    }
}

#[test]
fn a_factor_on_the_load_is_one_on_the_answer() {
    let [one, four, three] = [1.0, 4.0, 3.0].map(|force| pushed(force, "analysis.linear = {}"));
    assert_eq!(16.0 * last(&one, "internal"), last(&four, "internal"));
    for name in ["w", "turn", "d_x", "root"] {
        // A power of two changes no digit.
        assert_eq!(4.0 * last(&one, name), last(&four, name), "{name}");
        assert!((3.0 * last(&one, name) / last(&three, name) - 1.0).abs() < 1e-9, "{name}");
    }
}

#[test]
fn a_motion_drives_it_by_the_force_it_takes() {
    let supports = "supports = [{ on = \"u0\", clamped = {} }";
    let moved = ", { on = \"tip\", moved = { direction = [0, 0, 2], by = 0.5 } }]";
    let text = format!("{STRIP}analysis.linear = {{}}\n{GAUGES}")
        .replace(&format!("{supports}]"), &format!("{supports}{moved}"));
    let outcome = solved(Scene::parse(&text, "strip.toml"));
    assert!((last(&outcome, "w") / 0.5 - 1.0).abs() < 1e-9);
    let force = 3.0 * EI * 0.5 / 1000.0;
    assert!((last(&outcome, "push") / force - 1.0).abs() < 0.01, "{}", last(&outcome, "push"));
    assert!((last(&outcome, "push") / last(&outcome, "root") + 1.0).abs() < 1e-8);
    assert!((last(&outcome, "internal") / (0.25 * last(&outcome, "push")) - 1.0).abs() < 1e-8);
    assert_eq!(outcome.curve.columns[0].title(), "level [-]");
}

#[test]
fn every_energy_has_a_linear_answer() {
    for formulation in ["stress-point.support = 1.4", "nodal.order = 1", "nodal.order = 3"] {
        let outcome = pushed(3.0, &format!("formulation.{formulation}\nanalysis.linear = {{}}"));
        assert!((last(&outcome, "w") - 1.0).abs() < 0.02, "{formulation}: {}", last(&outcome, "w"));
    }
}

/// The four supports of a square plate whose edges stay down and straight: hard simple supports.
fn simply_supported() -> Vec<(String, String)> {
    [("u0", "[0, 1, 0]"), ("u1", "[0, 1, 0]"), ("v0", "[1, 0, 0]"), ("v1", "[1, 0, 0]")]
        .into_iter()
        .enumerate()
        .map(|(i, (edge, normal))| {
            let held = format!("{{ displacement = [[0, 0, 1]], director = [{normal}] }}");
            (format!("supports[{}]", i + 1), format!("{{ on = \"{edge}\", held = {held} }}"))
        })
        .collect()
}

#[test]
fn plates_of_any_thickness_bend() {
    // Central deflections of Mindlin's theory (benchmarks-ref, plate_static_square).
    for (supports, cases) in [
        (simply_supported(), [(0.2, 0.00490431), (0.01, 0.00406446), (0.001, 0.00406237)]),
        (Vec::new(), [(0.2, 0.00217216), (0.01, 0.00126785), (0.001, 0.00126534)]),
    ] {
        for (t, exact) in cases {
            let t: f64 = t;
            let [thickness, young] = [t, 10.92 / t.powi(3)].map(|x| format!("{x:?}"));
            let mut replaced =
                vec![("section.homogeneous.thickness", &*thickness), ("material.elastic.young", &*young)];
            replaced.extend(supports.iter().map(|(path, value)| (&**path, &**value)));
            let w = last(&run("plate.toml", &replaced), "w_centre");
            assert!((w / exact - 1.0).abs() < 5e-3, "t = {t}: {w} {exact}");
        }
    }
}

#[test]
fn a_held_edge_turns_with_the_scene_and_bears_the_load() {
    let mut replaced = vec![("geometry.plate.particles", "[13, 11]")];
    let supports = simply_supported();
    replaced.extend(supports.iter().map(|(path, value)| (&**path, &**value)));
    let bears = "[{ name = \"w_centre\", of = \"displacement\", on = \"centre\", direction = [0, 0, 1] }, { name = \"R\", of = \"reaction\", on = \"all\", direction = [0, 0, 1] }]";
    replaced.push(("curve", bears));
    let flat = run("plate.toml", &replaced);
    replaced.push(("orientation", "{ axis = [1, 2, 3], degrees = 50 }"));
    let turned = run("plate.toml", &replaced);
    // Rounding of a plate a hundred times as long as thick, of its turned positions and forces.
    assert!((last(&turned, "w_centre") / last(&flat, "w_centre") - 1.0).abs() < 1e-8);
    assert!((last(&flat, "R") + 1.0).abs() < 1e-8, "{}", last(&flat, "R"));
    assert!((last(&turned, "R") + 1.0).abs() < 1e-7, "{}", last(&turned, "R"));
}

#[test]
fn a_symmetry_plane_is_a_held_direction_and_turn() {
    let coarse = ("geometry.sphere.particles", "[9, 9]");
    let held = "{ on = \"v0\", held = { displacement = [[0, 2, 0]], director = [[0, 2, 0]] } }";
    let [plane, general] =
        [vec![coarse], vec![coarse, ("supports[0]", held)]].map(|r| run("hemisphere.toml", &r));
    assert_eq!(plane.curve, general.curve);
    // The plane from two supports on the same edge, one for the direction, one for the turn.
    let [up, turn] = ["displacement", "director"]
        .map(|key| format!("{{ on = \"v0\", held = {{ {key} = [[0, 1, 0]] }} }}"));
    let other = "{ on = \"v1\", symmetry = { normal = [1, 0, 0] } }";
    let point = "{ on = \"u0v0\", held = { displacement = [[0, 0, 1]] } }";
    let supports = format!("[{up}, {turn}, {other}, {point}]");
    assert_eq!(plane.curve, run("hemisphere.toml", &[coarse, ("supports", &supports)]).curve);
}

#[test]
fn the_obstacle_course_at_some_441_particles() {
    let thin = ("section.homogeneous.thickness", "0.0032");
    let [y, small_y] = ["[0, 1, 0]", "[0, 1e-6, 0]"].map(|force| ("loads[0].force.total", force));
    let small_z = ("loads[0].force.total", "[0, 0, 1e-6]");
    // Scene, overrides, column, published value, error allowed (benchmarks-ref, linear_obstacle_course).
    let cases: [(&str, Replaced, &str, f64, f64); 7] = [
        ("scordelis-lo.toml", &[], "w_edge", 0.3024, 0.01),
        ("hemisphere.toml", &[], "outward", 0.0940, 0.01),
        ("pinched-cylinder.toml", &[], "w_load", 1.8248e-5, 0.03),
        ("twisted-beam.toml", &[], "W_tip", 0.005424, 0.02),
        ("twisted-beam.toml", &[y], "V_tip", 0.001754, 0.02),
        ("twisted-beam.toml", &[thin, small_z], "W_tip", 0.005256, 0.02),
        ("twisted-beam.toml", &[thin, small_y], "V_tip", 0.001294, 0.02),
    ];
    for (name, replaced, column, published, allowed) in cases {
        let error = last(&run(name, replaced), column) / published - 1.0;
        assert!(error.abs() < allowed, "{name} {replaced:?}: {error:.4}");
    }
}

#[test]
fn columns_and_plates_buckle() {
    let levels = |name: &str, replaced: &[(&str, &str)]| run(name, replaced).curve.column("level").unwrap();
    let across = "[[0, 1, 0], [0, 0, 1]]";
    let sides = [("supports[2].held.displacement", across), ("supports[3].held.displacement", across)];
    // Euler's loads; thin-plate theory (benchmarks-ref, plate_stability).
    for (found, exact) in [
        (levels("column-buckling.toml", &[]), [1.0, 9.0]),
        (levels("plate-buckling.toml", &[]), [11.057, 11.959]),
        (levels("plate-buckling.toml", &sides), [6.863, 9.325]),
    ] {
        for (found, exact) in found.iter().zip(exact) {
            assert!((found / exact - 1.0).abs() < 0.01, "{found} {exact}");
        }
    }
}

#[test]
fn plates_vibrate() {
    // Six lowest ω a² √(ρt/D) of Mindlin's theory (benchmarks-ref, plate_vibration_square); the thin limit for 1e-4.
    let supported = simply_supported();
    let supported: Vec<_> = supported.iter().map(|(path, value)| (&**path, &**value)).collect();
    let cases: [(Replaced, f64, [f64; 6]); 4] = [
        (&supported, 0.1, [19.065, 45.4827, 45.4827, 69.7944, 85.038, 85.038]),
        (&supported, 1e-4, [19.7391, 49.3475, 49.3476, 78.9557, 98.6942, 98.6943]),
        (&[], 0.1, [32.5243, 62.0386, 62.0386, 86.949, 102.434, 103.412]),
        (&[], 0.01, [35.9424, 73.2392, 73.2392, 107.892, 131.13, 131.762]),
    ];
    for (supports, t, exact) in cases {
        let numbers = [t, 10.92 / t.powi(3), 1.0 / t].map(|x| format!("{x:?}"));
        let keys = ["section.homogeneous.thickness", "material.elastic.young", "material.elastic.density"];
        let mut replaced = vec![("analysis.modal.modes", "6")];
        replaced.extend(keys.into_iter().zip(numbers.iter().map(|number| &**number)));
        replaced.extend(supports);
        let found = run("plate.toml", &replaced).curve.column("circular_frequency").unwrap();
        for (found, exact) in found.iter().zip(exact) {
            assert!((found / exact - 1.0).abs() < 0.02, "t = {t}: {found} {exact}");
        }
    }
}

#[test]
fn a_twisted_strip_may_be_disordered() {
    let disorder = ("geometry.twisted.disorder", "{ fraction = 0.2, seed = 4 }");
    let w = last(&run("twisted-beam.toml", &[disorder]), "W_tip");
    assert!((w / 0.005424 - 1.0).abs() < 0.02, "{w}");
}

/// Name, file, overrides.
type Case<'a> = (&'a str, &'a str, Replaced<'a>);

/// The strip moves by P L³/3EI: what is not small against its length is reported, with a motion as with a load, of shells and of solids.
#[test]
fn an_answer_too_large_to_be_linear_is_reported() {
    let reported = |outcome: &Outcome| {
        outcome.summary.record.warnings.iter().any(|warning| warning.kind == WarningKind::LargeLinear)
    };
    // Deflections of .13, .17 and 28 lengths.
    for (force, large) in [(3.9, false), (5.1, true), (840.0, true)] {
        let outcome = pushed(force, "analysis.linear = {}");
        assert_eq!(reported(&outcome), large, "{force}");
    }
    let outcome = pushed(840.0, "analysis.linear = {}");
    let message = &outcome.summary.record.warnings[0].message;
    assert!(message.contains("by 27.86 of its extent and turns fibres by 41.99 rad"), "{message}");
    let bar = |formulation: &str, force: f64| {
        solved(Scene::parse(
            &format!(
                "title = \"Beam\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\nanalysis.linear = {{}}\n\
                 supports = [{{ on = \"x0\", clamped = {{}} }}]\n\
                 loads = [{{ on = \"x1\", traction = {{ value = [0, 0, {force}] }} }}]\n[bodies.beam.solid]\n\
                 geometry.block = {{ lengths = [4.0, 1.0, 1.0], spacing = 0.25, nodes = \"edges\" }}\n\
                 material.elastic = {{ young = 1000.0, poisson = 0.25, density = 1.0 }}\n{formulation}\n"
            ),
            "beam.toml",
        ))
    };
    for formulation in ["formulation.state-based = { horizon = 2.015 }", "formulation.galerkin = {}"] {
        // P L³/3EI is .26 F.
        assert!(!reported(&bar(formulation, 1.0)) && reported(&bar(formulation, 10.0)), "{formulation}");
    }
}

#[test]
fn what_is_refused() {
    let linear = ("analysis.linear", "{}");
    let cases: [Case; 16] = [
        ("an option of linear", "plate.toml", &[("analysis.linear.levels", "2")]),
        ("linear without tangent", "plate.toml", &[("formulation", "{ strong-form = {} }")]),
        ("nothing drives linear", "plate.toml", &[("loads", "[]")]),
        ("course in time", "plate.toml", &[("loads[0].amplitude", "{ ramp = 1.0 }")]),
        (
            "free to move",
            "plate.toml",
            &[("supports", "[{ on = \"u0\", held = { displacement = [[0, 0, 1]] } }]")],
        ),
        ("holds nothing", "plate.toml", &[("supports[0].held", "{}")]),
        ("no direction", "plate.toml", &[("supports[0].held.displacement", "[[0, 0, 0]]")]),
        (
            "four directions",
            "plate.toml",
            &[("supports[0].held.displacement", "[[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]")],
        ),
        (
            "parallel directions",
            "plate.toml",
            &[("supports[0].held.displacement", "[[1, 0, 0], [-2, 0, 0]]")],
        ),
        (
            "directions in a plane",
            "plate.toml",
            &[("supports[0].held.displacement", "[[1, 0, 0], [0, 1, 0], [1, 1, 0]]")],
        ),
        ("two directors", "plate.toml", &[("supports[0].held.director", "[[1, 0, 0], [0, 1, 0]]")]),
        ("director of no direction", "plate.toml", &[("supports[0].held.director", "[[0, 0, 0]]")]),
        ("director out of its plane", "plate.toml", &[("supports[0].held.director", "[[0, 0, 1]]")]),
        (
            "held motion",
            "panel.toml",
            &[linear, ("supports[2]", "{ on = \"v0\", held = { displacement = [[0, 1, 1]] } }")],
        ),
        ("no width", "twisted-beam.toml", &[("geometry.twisted.width", "0.0")]),
        ("more than a turn", "twisted-beam.toml", &[("geometry.twisted.twist", "400")]),
    ];
    let mut all = String::new();
    for (name, file, replaced) in cases {
        let message = match scene(file, replaced).and_then(|scene| scene.build(1)) {
            Ok(_) => "not refused".into(),
            Err(error) => render(&error, Rendering { width: 100, colour: false }),
        };
        all.push_str(&format!("━━━ {name} ━━━\n{}\n", message.trim_end()));
    }
    assert!(!all.contains("not refused"), "{all}");
    insta::assert_snapshot!(all);
}
