//! A force against the motion that it makes: the same levels of buckling, the force again as reaction.

use super::{common::last, difference, judge, ran};

/// A column without Poisson's ratio: an even pressure on its end and an even push of it are one state.
const COLUMN: &str = r#"
title = "Column"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [10.0, 1.0], particles = [41, 5] }
material.elastic = { young = 12e6, poisson = 0.0, density = 10.0 }
section.homogeneous.thickness = 0.1
supports = [{ on = "u0", clamped = {} }, { on = "all", held = { displacement = [[0, 1, 0]] } },
            { on = "u1", held = { displacement = [[0, 0, 1]] } }]
curve = [{ name = "u", of = "displacement", on = "u1", direction = [1, 0, 0] }, { name = "P", of = "reaction", on = "u0", direction = [1, 0, 0] }]
"#;
const FORCE: (&str, &str) = ("loads", "[{ on = \"u1\", force = { total = [-10, 0, 0] } }]");

/// The support that pushes the end as far as the force does.
fn pushed() -> String {
    let u = last(&ran(COLUMN, &[FORCE, ("analysis", "{ linear = {} }")], 1), "u");
    format!("{{ on = \"u1\", moved = {{ direction = [1, 0, 0], by = {u:e} }} }}")
}

#[test]
fn a_motion_gives_the_force_that_made_it() {
    let (mut failures, pushed) = (Vec::new(), pushed());
    for (name, analysis, bound) in
        [("linear", "{ linear = {} }", 1e-9), ("static", "{ static = { levels = 2 } }", 1e-4)]
    {
        let forced = last(&ran(COLUMN, &[FORCE, ("analysis", analysis)], 1), "P");
        let moved = last(&ran(COLUMN, &[("supports[+]", &pushed), ("analysis", analysis)], 1), "P");
        judge(&mut failures, "force or motion", name, ((moved / forced - 1.0).abs(), "P".into()), bound);
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

/// The sideways degrees of freedom of the end are held in both, so that the mode is the same.
#[test]
fn a_column_that_is_pushed_buckles_at_the_level_of_its_force() {
    let pushed = pushed();
    let buckling = [("analysis", "{ buckling = { modes = 2 } }"), ("curve", "[]")];
    let forced = ran(COLUMN, &[&[FORCE][..], &buckling].concat(), 1);
    let moved = ran(COLUMN, &[&[("supports[+]", &pushed[..])][..], &buckling].concat(), 1);
    let mut failures = Vec::new();
    let ones = vec![1.0; forced.curve.columns.len()];
    judge(&mut failures, "force or motion", "buckling", difference(&forced, &moved, &ones), 1e-3);
    assert!(failures.is_empty(), "{failures:#?}");
}
