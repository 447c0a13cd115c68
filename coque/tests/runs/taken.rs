//! What a column takes of the values of its particles.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{last, overridden, ran};
use coque::Outcome;

const PLATE: &str = r#"
title = "Cantilever twisted by a force on a corner"
units = { length = "-", force = "-", time = "-" }
geometry.plate = { lengths = [2.0, 1.0], particles = [9, 5] }
material.elastic = { young = 1e5, poisson = 0.3, density = 1.0 }
section.homogeneous = { thickness = 0.1 }
supports = [{ on = "u0", clamped = {} }]
loads = [{ on = "u1v0", force = { total = [0, 0, -0.1] } }]
analysis.linear = {}
curve = [
    { name = "loaded", of = "displacement", on = "u1v0", direction = [0, 0, 1] },
    { name = "light", of = "displacement", on = "u1v1", direction = [0, 0, 1] },
    { name = "left-out", of = "displacement", on = "u1", direction = [0, 0, 1] },
    { name = "mean", of = "displacement", on = "u1", take = "mean", direction = [0, 0, 1] },
    { name = "sum", of = "displacement", on = "u1", take = "sum", direction = [0, 0, 1] },
    { name = "max", of = "displacement", on = "u1", take = "max", direction = [0, 0, 1] },
    { name = "min", of = "displacement", on = "u1", take = "min", direction = [0, 0, 1], factor = 2.0 },
    { name = "P", of = "reaction", on = "u0", direction = [0, 0, 1] },
    { name = "P-sum", of = "reaction", on = "u0", take = "sum", direction = [0, 0, 1] },
    { name = "P-mean", of = "reaction", on = "u0", take = "mean", direction = [0, 0, 1] },
]
"#;

const UNITS: &str = "{ length = \"m\", force = \"N\", time = \"s\" }";

fn plate(analysis: &str) -> Outcome {
    ran(overridden(PLATE, "plate.toml", &[("analysis", analysis)]))
}

#[test]
fn a_column_is_written_in_the_unit_that_it_names() {
    let plain = ran(overridden(PLATE, "plate.toml", &[("analysis", "{ linear = {} }"), ("units", UNITS)]));
    let named = [("curve.6.unit", "\"mm\""), ("curve.7.unit", "\"kN\"")];
    let named = [&[("analysis", "{ linear = {} }"), ("units", UNITS)], &named[..]].concat();
    let named = ran(overridden(PLATE, "plate.toml", &named));
    let title = |name: &str| named.curve.columns.iter().find(|c| c.name == name).unwrap().title();
    assert_eq!([title("min"), title("P"), title("max")], ["min [mm]", "P [kN]", "max [m]"]);
    // One rounding of the ratio, one of the product.
    for (name, per) in [("min", 1e3), ("P", 1e-3), ("max", 1.0)] {
        let (written, own) = (last(&named, name), last(&plain, name));
        assert!((written / (per * own) - 1.0).abs() < 1e-15, "{name}: {written} for {own}");
    }
    // A ratio: the number as the factor makes it, without a unit.
    let ratio = [("units", UNITS), ("curve.6.unit", "\"-\""), ("curve.6.factor", "0.25")];
    let ratio =
        ran(overridden(PLATE, "plate.toml", &[&[("analysis", "{ linear = {} }")], &ratio[..]].concat()));
    let of_plain = plain.curve.columns.iter().position(|c| c.name == "min").unwrap();
    assert_eq!(ratio.curve.columns[of_plain].title(), "min [-]");
    let bare = [("units", UNITS), ("curve.7.unit", "\"-\"")];
    let refused = overridden(PLATE, "plate.toml", &bare).unwrap_err().to_string();
    assert!(refused.contains("beside a `factor`"), "{refused}");
    let refused = overridden(PLATE, "plate.toml", &[("curve.6.unit", "\"mm\"")]).unwrap_err().to_string();
    assert!(refused.contains("the scene has no units"), "{refused}");
}

#[test]
fn a_column_takes_what_it_says() {
    for analysis in ["{ linear = {} }", "{ static = { levels = 1 } }"] {
        let bent = plate(analysis);
        // The edge twists: one of its corners goes down most.
        let (most, least) = (last(&bent, "light"), last(&bent, "loaded"));
        assert!(least < 1.05 * most && most < 0.0, "{least}, {most}");
        let close = |name: &str, wanted: f64| {
            let found = last(&bent, name);
            assert!((found / wanted - 1.0).abs() < 1e-9, "{name} in {analysis}: {found} for {wanted}");
        };
        close("sum", 5.0 * last(&bent, "mean"));
        close("max", most);
        close("min", 2.0 * least);
        close("P", 0.1);
        close("P-mean", 0.02);
        for (left_out, given) in [("left-out", "mean"), ("P", "P-sum")] {
            assert_eq!(last(&bent, left_out).to_bits(), last(&bent, given).to_bits());
        }
    }
}
