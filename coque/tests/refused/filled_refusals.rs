//! What a user reads when a surface from a file encloses no solid, and what does not go with one.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::refused::refused;
use crate::common::solids::BAR;

/// The bar as a surface from a file.
fn bar() -> String {
    BAR.replace(
        "block = { lengths = [4.0, 1.0, 1.0], spacing = 0.25 }",
        "filled = { file = \"tests/refused/surfaces/bar.obj\", spacing = 0.25 }",
    )
}

#[test]
fn surfaces_that_enclose_no_solid() {
    insta::assert_snapshot!(refused(
        &bar(),
        &[
            ("no such file", "bar.obj", "rod.obj"),
            ("no format", "bar.obj", "bar.step"),
            ("open", "bar.obj", "open.obj"),
            ("inside out", "bar.obj", "inside-out.obj"),
            ("turned to the other side", "spacing = 0.25", "spacing = 0.25, flip = true"),
            ("a solid in a solid", "bar.obj", "solid-in-solid.obj"),
            ("two that pass through each other", "bar.obj", "crossing.obj"),
            ("a group with a name of every solid", "bar.obj", "twice-named.obj"),
            ("two pieces at rest", "bar.obj", "apart.obj"),
            ("thinner than a spacing", "spacing = 0.25", "spacing = 4.0"),
            ("too many cells", "spacing = 0.25", "spacing = 1e-4"),
            ("no spacing", ", spacing = 0.25", ""),
            ("a spacing of zero", "spacing = 0.25", "spacing = 0.0"),
        ],
    ));
}

#[test]
fn what_does_not_go_with_a_surface() {
    let shapes = "geometry.block = { lengths = [4.0, 1.0, 1.0], spacing = 0.25 }\nmaterial";
    let hole = "geometry.cut_outs = [{ ball = { centre = [2, 0.5, 0.5], radius = 0.3 } }]\nmaterial";
    let fragments = "contact = { distance = 0.2 }\nformulation";
    insta::assert_snapshot!(refused(
        &bar(),
        &[
            ("two shapes", "material", shapes),
            ("a cut-out", "material", hole),
            (
                "a tool without bonds",
                "state-based = { horizon = 3.015 }",
                "galerkin = {}\ntools = [{ name = \"flat\", plane = { point = [0, 0, 2], normal = [0, 0, -1] } }]"
            ),
            ("two sheets", "state-based = { horizon = 3.015 }", "two-sheets = {}"),
            ("balanced weights", "horizon = 3.015", "horizon = 3.015, correction = \"balanced\""),
            ("a set that is none", "on = \"x0\", clamped", "on = \"xO\", clamped"),
            (
                "a depth under a group",
                "on = \"x1\", traction = { value = [1.0, 0.0, 0.0]",
                "on = \"part0\", traction = { value = [1.0, 0.0, 0.0], depth = 0.2"
            ),
            (
                "a layer under a group",
                "curve",
                "sets.end = { layer = { face = \"surface\", depth = 0.2 } }\ncurve"
            ),
            (
                "a pressure that follows",
                "traction = { value = [1.0, 0.0, 0.0] }",
                "pressure = { value = 1.0, follower = true }"
            ),
            (
                "a tool",
                "formulation",
                "tools = [{ name = \"flat\", plane = { point = [0, 0, 2], normal = [0, 0, -1] } }]\nformulation"
            ),
            ("contact at rest", "formulation", fragments),
        ],
    ));
}

#[test]
fn turns_and_pressures_of_solids() {
    insta::assert_snapshot!(refused(
        BAR,
        &[
            (
                "a turn of what is held",
                "clamped = {} }",
                "clamped = {} }, { on = \"x0\", turned = { axis = [1, 0, 0], by = 5 } }"
            ),
            (
                "two turns",
                "clamped = {} }",
                "turned = { axis = [1, 0, 0], by = 5 } }, { on = \"x0\", turned = { axis = [0, 1, 0], by = 5 } }",
            ),
            ("no axis", "clamped = {}", "turned = { axis = [0, 0, 0], by = 5 }"),
            ("directors alone", "clamped = {}", "rotated = { axis = [1, 0, 0], by = 5 }"),
            (
                "a pressure in a set",
                "on = \"x1\", traction = { value = [1.0, 0.0, 0.0] }",
                "on = \"all\", pressure = { value = 1.0 }"
            ),
            (
                "numbers by particle",
                "traction = { value = [1.0, 0.0, 0.0] }",
                "pressure = { values = \"p\" }"
            ),
        ],
    ));
}

/// A pressure follows parts of a surface that have names; a load by area wants a part of it at its nodes. The same on a region at the surface is borne.
#[test]
fn loads_by_area_want_a_surface() {
    let sets = "sets.inner = { box = { min = [1.4, 0.3, 0.3], max = [2.6, 0.7, 0.7] } }\n\
                sets.skin = { box = { min = [1.0, -0.1, 0.7], max = [3.0, 1.1, 1.1] } }\ncurve";
    let still = bar().replacen("curve", sets, 1);
    let load = "on = \"x1\", traction = { value = [1.0, 0.0, 0.0] }";
    let said = |text: &str, to: &str| refused(text, &[(to, load, to)]).replace("\n  │ ", " ");
    for to in [
        "on = \"inner\", traction = { value = [1.0, 0.0, 0.0] }",
        "on = \"inner\", pressure = { value = 1.0 }",
    ] {
        let said = said(&still, to);
        assert!(said.contains("`loads[0].on`") && said.contains("nothing of the surface"), "{said}");
    }
    let marched = still.replace(
        "analysis.static = { levels = 1 }",
        "analysis.explicit.quasi-static = { levels = 1, period = 10.0 }",
    );
    assert_ne!(marched, still);
    for on in ["skin", "all", "inner"] {
        let said = said(&marched, &format!("on = \"{on}\", pressure = {{ value = 1e-3, follower = true }}"));
        assert!(
            said.contains("`loads[0].on`") && said.contains("no part of the surface with a name"),
            "{said}"
        );
    }
    for (text, to) in [
        (&still, "on = \"skin\", traction = { value = [1.0, 0.0, 0.0] }"),
        (&still, "on = \"skin\", pressure = { value = 1.0 }"),
        (&marched, "on = \"x1\", pressure = { value = 1e-3, follower = true }"),
        (&marched, "on = \"surface\", pressure = { value = 1e-3, follower = true }"),
    ] {
        let scene = coque::Scene::parse(&text.replacen(load, to, 1), "scene.toml");
        assert!(scene.and_then(|scene| scene.build(1).map(drop)).is_ok(), "{to}");
    }
}
