//! Supports of shape functions that nodes do not fill: widened where nothing was said, else refused with a width that works.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{last, overridden};
use coque::Silent;

/// A quarter of a thick tube under internal pressure, in plane strain.
const TUBE: &str = r#"title = "Quarter tube"
units = { length = "m", force = "N", time = "s" }
analysis.linear = {}
supports = [{ on = "x0", symmetry = { normal = [1, 0, 0] } }, { on = "x1", symmetry = { normal = [0, 0, 1] } }, { on = "y0", symmetry = { normal = [0, 1, 0] } }, { on = "y1", symmetry = { normal = [0, 1, 0] } }]
loads = [{ on = "z0", pressure = { value = 1.0, follower = true } }]
curve = [{ name = "u", of = "displacement", on = "inner", direction = [0, 0, 1] }]
sets.inner = { nearest = [0.0, 0.0, 0.5] }
[bodies.tube.solid]
geometry.arc = { radius = 1.0, angles = [0.0, 90.0], length = 0.5, thickness = 1.0, cells = [8, 2, 4] }
material.elastic = { young = 1e3, poisson = 0.3, density = 1.0 }
formulation.galerkin = { }
"#;

/// The opening of the tube under supports and cells, and whether its support was widened.
fn opened(supports: &str, cells: &str) -> (f64, bool) {
    let replaced = [("supports", supports), ("bodies.tube.solid.geometry.arc.cells", cells)];
    let outcome = overridden(TUBE, "tube.toml", &replaced).unwrap().build(1).unwrap().run(&mut Silent);
    let widened = outcome.summary.body.modelled.iter().any(|line| line.contains("times as wide as said"));
    (last(&outcome, "u"), widened)
}

/// Images behind planes of symmetry are nodes as well. Lamé's displacement of the inner face is
/// `(1 + ν) p a²/(E (b² − a²)) ((1 − 2ν) r + b²/r)` at r = a.
#[test]
fn a_quarter_of_a_tube_is_wide_enough_by_itself() {
    let (a, b, nu) = (0.5_f64, 1.5_f64, 0.3);
    let lame = (1.0 + nu) * a * a / (1e3 * (b * b - a * a)) * ((1.0 - 2.0 * nu) * a + b * b / a);
    let planes = "[{ on = 'x0', symmetry = { normal = [1, 0, 0] } }, { on = 'x1', symmetry = { normal = [0, 0, 1] } }, \
                  { on = 'y0', symmetry = { normal = [0, 1, 0] } }, { on = 'y1', symmetry = { normal = [0, 1, 0] } }]";
    // The mesh: −17, −4.9 and −.76 % were measured.
    for (cells, off) in [("[5, 3, 3]", 0.2), ("[8, 2, 4]", 0.06), ("[16, 2, 6]", 0.01)] {
        let (u, widened) = opened(planes, cells);
        assert!((u / lame - 1.0).abs() < off && !widened, "{cells}: {} {widened}", u / lame);
    }
    let held = "[{ on = 'x1', clamped = {} }]";
    for (cells, expected) in [("[5, 3, 3]", true), ("[6, 2, 4]", true), ("[16, 2, 4]", false)] {
        let (u, widened) = opened(held, cells);
        assert!(u.is_finite() && widened == expected, "{cells}: {u} {widened}");
    }
}

#[test]
fn a_support_that_was_asked_for_is_refused_with_one_that_works() {
    let cells = ("bodies.tube.solid.geometry.arc.cells", "[6, 2, 4]");
    let held = ("supports", "[{ on = 'x1', clamped = {} }]");
    let with = |value: &str| {
        let support = ("bodies.tube.solid.formulation.galerkin.support.ellipsoid", value);
        overridden(TUBE, "tube.toml", &[cells, held, support])
            .unwrap()
            .build(1)
            .err()
            .map(|error| error.to_string())
    };
    let found = with("2.5").expect("a refusal");
    assert!(found.contains("support.ellipsoid") && found.contains("do not determine"), "{found}");
    let works = found.split("must be about ").nth(1).unwrap().split(' ').next().unwrap().to_string();
    assert_eq!(with(&works), None, "{works}");
    let found =
        overridden(TUBE, "tube.toml", &[("bodies.tube.solid.geometry.arc.cells", "[8, 1, 4]")]).unwrap();
    let found = found.build(1).expect_err("a refusal").to_string();
    assert!(found.contains("geometry.arc.cells") && found.contains("[8, 2, 4] at least"), "{found}");
}
