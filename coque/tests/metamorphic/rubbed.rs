//! Friction between two shells: one moved against the other or the other against it, whichever is named first, where both slip and where both stick.

use super::{Outcome, difference, judge, ran};

/// A plate pressed on a wider one of unlike cells, and then drawn along by one of them.
const DRAWN: &str = r#"
title = "A plate drawn over another"
units = { length = "m", force = "N", time = "s" }
analysis.static = { levels = [0.05, 0.3, 1.0] }
contact = [{ between = ["base", "sled"], friction = 0.3 }]
bodies.base.shell.geometry.plate = { lengths = [1.6, 1.4], particles = [15, 13] }
bodies.base.shell.placed = { origin = [-0.3, -0.2, 0.0], u = [1.0, 0.0, 0.0], v = [0.0, 1.0, 0.0] }
bodies.base.shell.material.elastic = { young = 1e6, poisson = 0.3, density = 1.0 }
bodies.base.shell.section.homogeneous = { thickness = 0.1 }
bodies.sled.shell.geometry.plate = { lengths = [1.0, 1.0], particles = [7, 7] }
bodies.sled.shell.placed = { origin = [0.0, 0.0, 0.1], u = [1.0, 0.0, 0.0], v = [0.0, 1.0, 0.0] }
bodies.sled.shell.material.elastic = { young = 1e6, poisson = 0.3, density = 1.0 }
bodies.sled.shell.section.homogeneous = { thickness = 0.1 }
loads = [{ on = "sled.all", force = { total = [0.0, 0.0, -20.0] } }]

[[curve]]
name = "T"
of = "contact-force"
on = "base.all"
direction = [1.0, 0.0, 0.0]

[[curve]]
name = "N"
of = "contact-force"
on = "sled.all"
direction = [0.0, 0.0, 1.0]

[[curve]]
name = "lost"
of = "friction-loss"
on = "base.all"
"#;

fn drawn(base: f64, sled: f64, between: &str) -> Outcome {
    let hold = |on: &str, by: f64, others: &str| {
        let moved = format!("{{ on = '{on}', moved = {{ direction = [1, 0, 0], by = {by:.6} }} }}");
        let held = format!("{{ on = '{on}', held = {{ displacement = [[1, 0, 0]{others} }} }}");
        if by == 0.0 {
            held
        } else {
            format!("{{ on = '{on}', held = {{ displacement = [{} }} }}, {moved}", &others[2..])
        }
    };
    let supports = format!(
        "[{}, {}]",
        hold("base.all", base, ", [0, 1, 0], [0, 0, 1]]"),
        hold("sled.u0", sled, ", [0, 1, 0]]")
    );
    ran(DRAWN, &[("supports", &supports), ("contact[0].between", between)], 1)
}

/// A fifth of a cell: it sticks at first, and slips at the end with μ N. Newton's method stops at a part of the forces.
#[test]
fn a_plate_drawn_over_another_is_the_other_drawn_under_it() {
    let (over, under) = (drawn(0.0, 0.03, "['base', 'sled']"), drawn(-0.03, 0.0, "['sled', 'base']"));
    let last = |name: &str| over.curve.column(name).unwrap().last().copied().unwrap();
    let first = over.curve.column("T").unwrap()[1];
    assert!(first > 0.05 * last("T") && last("lost") > 0.0, "{first}");
    assert!((last("T") / last("N") - 0.3).abs() < 3e-3, "{} {}", last("T"), last("N"));
    let mut failures = Vec::new();
    let ones = vec![1.0; over.curve.columns.len()];
    judge(&mut failures, "drawn", "plate", difference(&over, &under, &ones), 1e-6);
    assert!(failures.is_empty(), "{failures:#?}");
}
