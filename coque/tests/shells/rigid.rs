//! Rigid sets in scenes: a heavy end, supports and weights of bodies, motion in time, refusals.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{Replaced, column, last, overridden, ran, run};
use coque::{Checked, Ended, Outcome};

fn done(outcome: Outcome) -> Outcome {
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

/// The frequencies that the scene tells of the beam with its body. A strip of n cells is too
/// stiff by .12/n² of its first frequency, from 20 to 160 cells: 7.7e-5 here, which masses lumped at its ends would take back in part.
#[test]
fn the_template_finds_the_frequencies_of_the_beam() {
    let omega = column(&done(run("heavy-end.toml", &[])), "circular_frequency");
    for (exact, bound) in [(22.4587, 1e-4), (185.0862, 2e-3), (546.384, 4e-3)] {
        let off = omega.iter().map(|found| (found / exact - 1.0).abs()).fold(f64::INFINITY, f64::min);
        println!("{exact}: {off:.1e}");
        assert!(off < bound, "{exact}: {off}");
    }
}

const STRIP: &str = r#"
title = "Strip between a clamp and a flange"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [2.0, 0.5], particles = [17, 5] }
orientation = { axis = [1, 2, 3], degrees = 40.0 }
material.elastic = { young = 1e9, poisson = 0.3, density = 1000.0 }
section.homogeneous.thickness = 0.05
rigid = [{ on = "u1", at = [2.3, 0.25, 0.2], mass = 40.0, inertia = [0.5, 0.7, 0.9], products = [0.1, 0, 0] }]
supports = [{ on = "u0", clamped = {} }, { on = "u1", clamped = {} }]
loads = [{ on = "all", gravity = { acceleration = [1, -2, -10] } }]
curve = [{ name = "w", of = "displacement", on = "all", direction = [0, 0, 1], take = "min" },
         { name = "R", of = "reaction", on = "u1", direction = [0, 0, 1] },
         { name = "M", of = "reaction-moment", on = "u1", direction = [0, 1, 0], about = [2, 0.25, 0] },
         { name = "M0", of = "reaction-moment", on = "u0", direction = [0, 1, 0], about = [2, 0.25, 0] }]
analysis.static = { levels = 1 }
"#;

fn strip(replaced: Replaced) -> Outcome {
    done(ran(overridden(STRIP, "strip.toml", replaced)))
}

/// A clamped body holds its set as clamped particles do, and bears the weight of its own mass with its moment.
#[test]
fn a_clamped_body_is_a_clamped_edge_and_bears_its_own_weight() {
    let (body, plain) = (strip(&[]), strip(&[("rigid", "[]")]));
    let weight = 40.0 * 10.0;
    assert!((last(&body, "w") / last(&plain, "w") - 1.0).abs() < 1e-9, "{}", last(&body, "w"));
    let more = last(&body, "R") - last(&plain, "R");
    // About the edge the body's force has the arm (.3, 0, .2): r × f = (·, .2 f_x − .3 f_z, ·), and the clamp bears the opposite.
    let moment = last(&body, "M") - last(&plain, "M");
    println!("{} {}", more / weight, moment / -(0.2 * 40.0 + 0.3 * weight));
    assert!((more / weight - 1.0).abs() < 1e-9, "{more}");
    assert!((moment / -(0.2 * 40.0 + 0.3 * weight) - 1.0).abs() < 1e-9, "{moment}");
    let supports = body.summary.supports.unwrap();
    let all = 40.0 + 2.0 * 0.5 * 0.05 * 1000.0;
    assert!(
        (supports.force.iter().map(|f| f * f).sum::<f64>().sqrt() / (all * 105.0_f64.sqrt()) - 1.0).abs()
            < 1e-9
    );
}

/// Loads on a body do work unless its supports hold them.
#[test]
fn a_load_on_a_body_is_reported_to_do_no_work_where_the_body_is_held() {
    let push = "[{ on = 'u1', couple = { moment = 1, axis = [0, 1, 0] } }]";
    let warned = |supports| {
        let scene = overridden(STRIP, "strip.toml", &[("loads", push), ("supports", supports)]).unwrap();
        let model = scene.build(1).unwrap();
        model.warnings().iter().any(|warning| format!("{:?}", warning.kind) == "NoWork")
    };
    assert!(!warned("[{ on = 'u0', clamped = {} }]"));
    assert!(warned("[{ on = 'u0', clamped = {} }, { on = 'u1', clamped = {} }]"));
}

/// Under the same weight by relaxation: where Newton's method finds it.
#[test]
fn a_body_comes_to_rest_where_it_is_in_balance() {
    let free = [("supports", "[{ on = 'u0', clamped = {} }]"), ("material.elastic.young", "1e10")];
    let still = strip(&free);
    let [a, b] = free;
    let relaxed = strip(&[a, b, ("analysis", "{ relaxation = { levels = 1 } }")]);
    assert!((last(&relaxed, "w") / last(&still, "w") - 1.0).abs() < 1e-4, "{}", last(&relaxed, "w"));
}

/// A load on a body, and one on the strip, applied before the rest: the path ends where one load case ends.
#[test]
fn a_path_goes_on_from_a_preload_on_a_body() {
    let loads = |first: bool| {
        format!(
            "[{{ on = 'u1', force = {{ total = [300, 0, -50] }}, preload = {first} }}, \
             {{ on = 'all', gravity = {{ acceleration = [0, 0, -10] }}, preload = {first} }}, \
             {{ on = 'u1', couple = {{ moment = 40, axis = [0, 1, 0] }} }}]"
        )
    };
    let path = |first| {
        let loads = loads(first);
        strip(&[
            ("supports", "[{ on = 'u0', clamped = {} }, { on = 'u1', held = { director = [[0, 1, 0]] } }]"),
            ("loads", &loads),
            ("analysis", "{ static = { levels = 2, tolerance = 1e-10 } }"),
        ])
    };
    let (apart, once) = (path(true), path(false));
    assert_eq!(column(&apart, "level"), [0.0, 0.5, 1.0]);
    assert!(apart.summary.record.preload.as_ref().unwrap().newton_iterations > 0);
    assert!(
        column(&apart, "w")[0] < -1e-3 && (last(&apart, "w") / column(&apart, "w")[0] - 1.0).abs() > 1e-2
    );
    for name in ["w", "R", "M", "M0", "internal"] {
        let (a, b) = (last(&apart, name), last(&once, name));
        println!("{name}: {a:.6e} {:.1e}", a - b);
        // Newton's tolerance; what the free body bears is zero but for it.
        assert!((a - b).abs() < 1e-8 * b.abs() + 1e-7, "{name}: {a} {b}");
    }
}

/// The square of the frequency of a heavy end grows by the tension that acts through the body, N/(ML) a string's share.
#[test]
fn a_tension_through_a_body_raises_its_frequencies() {
    let modes = |tension: &str| {
        let load = format!("[{{ on = 'u1', force = {{ total = [{tension}, 0, 0] }}, preload = true }}]");
        let squares = column(
            &done(run(
                "pulled-strip.toml",
                &[
                    ("rigid", "[{ on = 'u1' }]"),
                    ("supports[1]", "{ on = 'u1', held = { displacement = [[0, 1, 0], [0, 0, 1]] } }"),
                    ("loads", load.as_str()),
                    ("analysis.modal.modes", "1"),
                ],
            )),
            "circular_frequency",
        );
        squares[0].powi(2)
    };
    let ratio = modes("39.4784") / modes("0");
    println!("{ratio}");
    // As without the body, for the edge of a strip without Poisson's ratio stays straight: 1 + N/N_cr, the lattice of 41 within 2e-3.
    assert!((ratio / 5.0 - 1.0).abs() < 2e-3, "{ratio}");
}

fn refused(replaced: Replaced) -> String {
    let text = overridden(STRIP, "strip.toml", replaced);
    text.and_then(|scene: Checked| scene.build(1)).map(|_| ()).unwrap_err().to_string()
}

#[test]
fn what_a_body_cannot_have_is_refused() {
    let near = "[{ on = 'u1' }, { on = 'u1' }]";
    let twice = refused(&[("rigid", near), ("supports", "[{ on = 'u0', clamped = {} }]")]);
    assert!(twice.contains("two rigid sets"), "{twice}");
    let held = refused(&[("supports", "[{ on = 'u0', clamped = {} }, { on = 'v0', hinged = {} }]")]);
    assert!(held.contains("support of its own") && held.contains("rigid"), "{held}");
    let moved = refused(&[(
        "supports",
        "[{ on = 'u0', clamped = {} }, { on = 'u1', clamped = {} }, { on = 'u1', moved = { direction = [1, 0, 0], by = 1 } }]",
    )]);
    assert!(moved.contains("another holds"), "{moved}");
    let section = refused(&[(
        "supports",
        "[{ on = 'u0', clamped = {} }, { on = 'u1', diaphragm = { axis = [1, 0, 0], whole-section = true } }]",
    )]);
    assert!(
        section.contains("supports[1].diaphragm.whole-section") && section.contains("rigid set"),
        "{section}"
    );
    let alone = refused(&[("rigid", "[{ on = 'u1v1' }]"), ("supports", "[{ on = 'u0', clamped = {} }]")]);
    assert!(alone.contains("side by side"), "{alone}");
    let mass = refused(&[("rigid", "[{ on = 'u1', mass = -1 }]")]);
    assert!(mass.contains("rigid[0].mass"), "{mass}");
    let wide = refused(&[("formulation", "{ stress-point = { support = 1.4 } }")]);
    assert!(wide.contains("rigid[0]"), "{wide}");
}

/// A body that is turned, or moved, in every analysis: the columns of the same set without `rigid`, and of one analysis as of the other.
#[test]
fn a_body_is_moved_in_every_analysis() {
    let supports = |motion: &str| format!("[{{ on = 'u0', clamped = {{}} }}, {{ on = 'u1', {motion} }}]");
    let free = [("loads", "[]"), ("rigid", "[{ on = 'u1', at = [2.3, 0.25, 0.2], mass = 4, inertia = 1 }]")];
    let solve = |motion: &str, more: Replaced| {
        let supports = supports(motion);
        let all: Vec<(&str, &str)> =
            [("supports", supports.as_str())].into_iter().chain(free).chain(more.iter().copied()).collect();
        strip(&all)
    };
    let turned = "turned = { axis = [0, 1, 0], point = [1.9, 0.25, 0.1], by = 5 }";
    let plain = solve(turned, &[("rigid", "[]")]);
    let path = "{ arc-length = { until = 1, radius = 0.2 } }";
    // The path ends at Newton's tolerance, 1e-9 of the largest forces that it met.
    for (analysis, bound) in
        [("{ static = { levels = 1 } }", 1e-9), (path, 2e-7), ("{ relaxation = { levels = 1 } }", 2e-4)]
    {
        let body = solve(turned, &[("analysis", analysis)]);
        for name in ["w", "R", "M", "M0"] {
            let (found, wanted) = (last(&body, name), last(&plain, name));
            println!("{analysis} {name}: {:.1e}", found / wanted - 1.0);
            assert!((found / wanted - 1.0).abs() < bound, "{analysis} {name}: {found} {wanted}");
        }
    }
    let error = |by: &str| {
        let slight = turned.replace("by = 5", by);
        let (linear, still) = (solve(&slight, &[("analysis", "{ linear = {} }")]), solve(&slight, &[]));
        (last(&linear, "M") / last(&still, "M") - 1.0).abs()
    };
    let errors = ["by = 1e-3", "by = 1e-4"].map(error);
    println!("linear: {errors:?}");
    // The turn stretches the strip as well, and its tension stiffens it in proportion to the angle.
    assert!(errors[0] < 1e-3 && (errors[0] / errors[1] - 10.0).abs() < 0.1, "{errors:?}");
    // One direction at the reference point: the rest of the body goes as it will.
    let moved = "moved = { direction = [0, 0, 1], by = 0.1 }";
    let path = solve(moved, &[("analysis", "{ arc-length = { until = 1, radius = 0.2 } }")]);
    let force = last(&solve(moved, &[]), "R");
    assert!(force.abs() > 1.0 && (last(&path, "R") / force - 1.0).abs() < 1e-8, "{force}");
    let pushed = format!("[{{ on = 'u1', force = {{ total = [0, 0, {force}] }} }}]");
    let pushed = strip(&[free[1], ("supports", "[{ on = 'u0', clamped = {} }]"), ("loads", &pushed)]);
    let (found, wanted) = (last(&pushed, "internal"), last(&solve(moved, &[]), "internal"));
    println!("pushed: {:.1e}", found / wanted - 1.0);
    assert!((found / wanted - 1.0).abs() < 1e-8, "{found} {wanted}");
    // Modes: what is prescribed stands still, here along one direction beside the centre of mass.
    let held = "held = { displacement = [[0, 0, 1]] }";
    let modes = [("analysis", "{ modal = { modes = 3 } }"), ("curve", "[]")];
    let (one, two) = (solve(moved, &modes), solve(held, &modes));
    let [one, two] = [one, two].map(|modes| column(&modes, "circular_frequency"));
    let apart = one.iter().zip(&two).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
    println!("modes: {apart:.1e}");
    // The particles of what is prescribed are put anew, to round-off.
    assert!(one.len() == 3 && apart < 1e-12, "{one:?} {two:?}");
    // In time.
    let smooth = format!("{turned}, amplitude = {{ smooth = 0.05 }}");
    let angle = "[{ name = 'a', of = 'rotation', on = 'u1', direction = [0, 1, 0] }]";
    let march = "{ explicit.transient = { duration = 0.06, record_every = 0.01 } }";
    let swung = solve(&smooth, &[("analysis", march), ("curve", angle)]);
    assert!((last(&swung, "a") - 5.0_f64.to_radians()).abs() < 1e-12, "{}", last(&swung, "a"));
}
