//! Bodies bent like a buckling mode before they are loaded: how far they bend further, which way, and what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{Replaced, column, last, overridden, ran, refused::refused};
use coque::{Ended, Outcome};

/// A strip of a shell, hinged at both ends and pressed by `P` times Euler's load at level one.
const STRIP: &str = r#"title = "Hinged column"
units = { length = "m", force = "N", time = "s" }
[geometry.plate]
lengths = [10.0, 1.0]
particles = [41, 3]
[material.elastic]
young = 1.2e6
poisson = 0.0
density = 1.0
[section.homogeneous]
thickness = 0.1
[imperfection]
mode = 1
amplitude = 0.01
[sets]
middle = { plane = { point = [5.0, 0.0, 0.0], normal = [1.0, 0.0, 0.0] } }
[[supports]]
on = "u0"
held = { displacement = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] }
[[supports]]
on = "u1"
held = { displacement = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] }
[[loads]]
on = "u1"
force = { total = [-9.869604401089358, 0.0, 0.0] }
[analysis.static]
levels = [0.25, 0.5, 0.75]
[[curve]]
name = "w"
of = "displacement"
on = "middle"
direction = [0.0, 0.0, 1.0]
"#;

/// The same as a strip of a plate of two sheets, as narrow.
const SHEETS: &str = r#"title = "Hinged column of two sheets"
units = { length = "m", force = "N", time = "s" }
[bodies.strip.solid]
geometry.block = { lengths = [10.0, 1.0], thickness = 0.1, spacing = 0.25 }
material.elastic = { young = 1.2e6, poisson = 0.0, density = 1.0 }
formulation.two-sheets = {}
imperfection = { mode = 1, amplitude = 0.01 }
[sets]
middle = { plane = { point = [5.0, 0.0, 0.0], normal = [1.0, 0.0, 0.0] } }
[[supports]]
on = "x0"
held = { displacement = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] }
[[supports]]
on = "x1"
held = { displacement = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] }
[[loads]]
on = "x1"
force = { total = [-9.869604401089358, 0.0, 0.0] }
[analysis.static]
levels = [0.25, 0.5, 0.75]
[[curve]]
name = "w"
of = "displacement"
on = "middle"
direction = [0.0, 0.0, 1.0]
"#;

/// A bar of bonds in its plane, six layers, clamped at its foot; its load is Euler's for that.
const BONDS: &str = r#"title = "Clamped column of bonds"
units = { length = "m", force = "N", time = "s" }
[bodies.bar.solid]
geometry.block = { lengths = [10.0, 0.6], spacing = 0.1, nodes = "edges" }
material.elastic = { young = 1000.0, poisson = 0.3, density = 1.0 }
formulation.state-based = { horizon = 2.015, plane = "stress" }
imperfection = { mode = 1, amplitude = 0.01 }
[sets]
end = { plane = { point = [10.0, 0.0, 0.0], normal = [1.0, 0.0, 0.0] } }
[[supports]]
on = "x0"
clamped = {}
[[loads]]
on = "x1"
force = { total = [-0.4441321980490211, 0.0, 0.0] }
[analysis.static]
levels = [0.25, 0.5, 0.75]
[[curve]]
name = "w"
of = "displacement"
on = "end"
direction = [0.0, 1.0, 0.0]
"#;

fn answer(text: &str, replaced: Replaced) -> Outcome {
    let outcome = ran(overridden(text, "scene.toml", replaced));
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

/// The critical level of the same body without imperfection.
fn critical(text: &str) -> f64 {
    let perfect = text.replace("[imperfection]\nmode = 1\namplitude = 0.01\n", "");
    let perfect = perfect.replace("imperfection = { mode = 1, amplitude = 0.01 }\n", "");
    last(&answer(&perfect, &[("analysis", "{ buckling = { modes = 1 } }")]), "level")
}

/// A column bent by w₀ like its mode bends by w₀ P/(P_cr − P) further, whatever its P_cr is.
#[test]
fn bent_columns_follow_the_perturbed_path() {
    for (name, text, [euler, bound]) in
        [("shell", STRIP, [0.01, 3e-4]), ("sheets", SHEETS, [0.01, 3e-4]), ("bonds", BONDS, [0.05, 0.015])]
    {
        let critical = critical(text);
        assert!((critical - 1.0).abs() < euler, "{name}: {critical}");
        let bent = answer(text, &[]);
        for (level, w) in column(&bent, "level").into_iter().zip(column(&bent, "w")).skip(1) {
            let further = w.abs() / (0.01 * level / (critical - level)) - 1.0;
            println!("{name} {level}: {further:.2e}");
            // Thin: of second order in the slope of .01, measured 2e-4 at most. The bar is six layers deep: the greatest displacement
            // is at a corner, which moves along the bar too, and weights are those of the bent lattice; measured 9e-3.
            assert!(further.abs() < bound, "{name} {level}: {further:.2e}");
        }
    }
}

/// Amplitude on the other side: the mirror image. Turned in space with its loads: the same. Without mode, on two sheets, the sine that
/// the mode is.
#[test]
fn the_way_a_body_is_bent_does_not_depend_on_the_solver() {
    for (text, key) in [(STRIP, "imperfection"), (SHEETS, "bodies.strip.solid.imperfection")] {
        let [one, other] =
            ["0.01", "-0.01"].map(|a| last(&answer(text, &[(&format!("{key}.amplitude"), a)]), "w"));
        assert!(one > 0.0 && (one + other).abs() < 1e-9 * one, "{one} {other}");
    }
    let straight = last(&answer(STRIP, &[]), "w");
    // The middle of the half-wave hardly turns: by how much, and to which side, is rounding, another at each angle.
    for degrees in (1..60).step_by(7) {
        let orientation = format!("{{ axis = [1.0, 2.0, 3.0], degrees = {degrees} }}");
        let turned = last(&answer(STRIP, &[("orientation", &orientation)]), "w");
        println!("{degrees}: {:.1e}", turned / straight - 1.0);
        // Rounding of a mode, measured 8e-12.
        assert!((turned / straight - 1.0).abs() < 3e-11, "{degrees}: {straight} {turned}");
    }
    let finer = last(&answer(STRIP, &[("geometry.plate.particles", "[61, 3]")]), "w");
    assert!(finer > 0.0 && (finer / straight - 1.0).abs() < 0.02, "{straight} {finer}");
    let second = last(&answer(STRIP, &[("imperfection.mode", "2")]), "w");
    assert!(second.abs() < 1e-3 * straight, "{second}: two half-waves leave the middle in its place");
}

#[test]
fn what_cannot_be_bent_like_a_mode_is_refused() {
    insta::assert_snapshot!(refused(
        STRIP,
        &[
            ("sines on a shell", "mode = 1", "half_waves = [1, 1]"),
            ("neither", "mode = 1\n", ""),
            ("no such mode", "mode = 1", "mode = 0"),
            ("no load", "[[loads]]\non = \"u1\"\nforce = { total = [-9.869604401089358, 0.0, 0.0] }\n", ""),
            ("tension", "total = [-9.869604401089358", "total = [9.869604401089358"),
        ],
    ));
}
