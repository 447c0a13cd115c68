//! What a user reads when the scene of a solid is wrong: one broken scene each, rendered as in a terminal.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::refused::refused;
use crate::common::solids::{BAR, PLATE, SHEETS};
use coque::{Rendering, Scene, render};

#[test]
fn broken_blocks() {
    insta::assert_snapshot!(refused(
        BAR,
        &[
            ("one length", "lengths = [4.0, 1.0, 1.0]", "lengths = [4.0]"),
            ("negative length", "lengths = [4.0, 1.0, 1.0]", "lengths = [4.0, -1.0, 1.0]"),
            ("no spacing", ", spacing = 0.25", ""),
            ("zero spacing", "spacing = 0.25", "spacing = 0"),
            ("two spacings for three", "spacing = 0.25", "spacing = [0.25, 0.25]"),
            ("a spacing in words", "spacing = 0.25", "spacing = \"fine\""),
            ("too many nodes", "spacing = 0.25", "spacing = 1e-4"),
            ("one layer", "lengths = [4.0, 1.0, 1.0]", "lengths = [4.0, 1.0, 0.3]"),
            ("origin in a plane", "spacing = 0.25", "spacing = 0.25, origin = [0.0, 0.0]"),
            ("thickness in space", "spacing = 0.25", "spacing = 0.25, thickness = 0.1"),
            ("unknown places", "spacing = 0.25", "spacing = 0.25, nodes = \"corners\""),
            ("strong grading", "spacing = 0.25", "spacing = 0.25, grading = [1.0, 1e4, 1.0]"),
            ("disorder", "spacing = 0.25", "spacing = 0.25, disorder = { fraction = 0.6, seed = 1 }"),
            (
                "all cut out",
                "material",
                "geometry.cut_outs = [{ ball = { centre = [2.0, 0.5, 0.5], radius = 9.0 } }]\nmaterial",
            ),
            (
                "a face cut out",
                "material",
                "geometry.cut_outs = [{ box = { min = [3.5, 0.0, 0.0], max = [4.0, 1.0, 1.0] } }]\nmaterial",
            ),
            (
                "a box inside out",
                "material",
                "geometry.cut_outs = [{ box = { min = [3.5, 0.0, 0.0], max = [3.0, 1.0, 1.0] } }]\nmaterial",
            ),
            (
                "an angle for a polygon",
                "material",
                "geometry.cut_outs = [{ polygon = { corners = [[0, 0], [1, 1]] } }]\nmaterial",
            ),
        ],
    ));
}

#[test]
fn broken_materials_and_formulations() {
    insta::assert_snapshot!(refused(
        BAR,
        &[
            ("short horizon", "horizon = 3.015", "horizon = 1.2"),
            ("plane in space", "horizon = 3.015", "plane = \"stress\""),
            ("sheets in space", "state-based = { horizon = 3.015 }", "two-sheets = {}"),
            ("unknown formulation", "state-based", "state-baste"),
            ("unknown influence", "horizon = 3.015", "influence = \"gauss\""),
            ("incompressible", "poisson = 0.3", "poisson = 0.5"),
            ("below minus one", "poisson = 0.3", "poisson = -1"),
            ("ratio of pairwise forces", "state-based", "bond-based"),
            ("negative modulus", "young = 1.0", "young = -1.0"),
            ("a section", "material", "section.homogeneous.thickness = 1.0\nmaterial"),
            (
                "imperfect bar",
                "material",
                "imperfection = { half_waves = [1, 1], amplitude = 0.1 }\nmaterial"
            ),
        ],
    ));
}

#[test]
fn broken_conditions() {
    insta::assert_snapshot!(refused(
        BAR,
        &[
            ("hinge", "clamped = {}", "hinged = {}"),
            ("diaphragm", "clamped = {}", "diaphragm = { axis = [1, 0, 0] }"),
            ("rotated", "clamped = {}", "rotated = { axis = [1, 0, 0], by = 1 }"),
            ("director", "clamped = {}", "held = { director = [[1, 0, 0]] }"),
            ("couple", "traction = { value = [1.0, 0.0, 0.0] }", "couple = { moment = 1, axis = \"edge\" }"),
            (
                "pressure",
                "traction = { value = [1.0, 0.0, 0.0] }",
                "pressure = { value = 1, follower = true }"
            ),
            ("traction inside", "on = \"x1\", traction", "on = \"all\", traction"),
            ("depth", "value = [1.0, 0.0, 0.0]", "value = [1.0, 0.0, 0.0], depth = 0"),
            ("edge of a shell", "on = \"x0\"", "on = \"u0\""),
            (
                "no such face",
                "[bodies.bar",
                "[sets]\nend = { layer = { face = \"x2\", depth = 1 } }\n[bodies.bar"
            ),
            ("free to turn", "clamped = {}", "held = { displacement = [[1, 0, 0], [0, 1, 0]] }"),
            ("held everywhere", "on = \"x0\"", "on = \"all\""),
            ("no direction", ", direction = [1.0, 0.0, 0.0] }]\n[", " }]\n["),
            ("direction of damage", "of = \"displacement\"", "of = \"damage\""),
            ("rotation", "of = \"displacement\"", "of = \"rotation\""),
            ("velocity without time", "of = \"displacement\"", "of = \"velocity\""),
            ("extruded", "[bodies.bar", "[output.fields]\nextruded = true\n[bodies.bar"),
        ],
    ));
}

#[test]
fn broken_planes_and_cracks() {
    insta::assert_snapshot!(refused(
        PLATE,
        &[
            ("no plane", ", plane = \"stress\"", ""),
            ("ratio of pairwise forces", "plane = \"stress\"", "plane = \"strain\""),
            ("out of the plane: load", "value = [1.0, 0.0, 0.0]", "value = [1.0, 0.0, 1.0]"),
            ("out of the plane: support", "[[1.0, 0.0, 0.0]]", "[[0.0, 0.0, 1.0]]"),
            ("no face z1", "on = \"x1\", traction", "on = \"z1\", traction"),
            ("crack in space", "from = [0.0, 1.0]", "from = [0.0, 1.0, 0.0]"),
            ("half a crack", ", to = [1.0, 1.0]", ""),
            ("no crack", "to = [1.0, 1.0]", "to = [0.0, 1.0]"),
            ("no limit", "energy = 1.0", ""),
            ("two limits", "energy = 1.0", "energy = 1.0, stretch = { tension = 0.1 }"),
            ("negative energy", "energy = 1.0", "energy = -1.0"),
            ("negative stretch", "energy = 1.0", "stretch = { tension = -0.1 }"),
            ("positive compression", "energy = 1.0", "stretch = { tension = 0.1, compression = 0.1 }"),
            ("stretch by work", "energy = 1.0", "stretch = { tension = 0.1 }, by = \"work\""),
            ("nothing to spare", "fracture = { energy = 1.0 }\n", ""),
            ("no such set", "unbreakable = [\"x1\"]", "unbreakable = [\"x3\"]"),
            ("far contact", "cracks", "contact = { distance = 1.5 }\ncracks"),
            (
                "spin out of the plane",
                "cracks",
                "velocity = { spin = { axis = [1, 0, 0], rate = 1.0 } }\ncracks",
            ),
        ],
    ));
    let corners = "[[0, 0, 0.5], [1, 0, 0.5], [0, 1, 0.5], [1, 1, 0.5]]";
    let crossed = format!("cracks = [{{ corners = {corners} }}]\nmaterial");
    insta::assert_snapshot!(
        "broken_cracks_in_space",
        refused(
            BAR,
            &[
                ("crossed corners", "material", &crossed),
                (
                    "a segment in space",
                    "material",
                    "cracks = [{ from = [0, 0, 0], to = [1, 0, 0] }]\nmaterial"
                ),
            ],
        )
    );
}

#[test]
fn broken_sheets() {
    insta::assert_snapshot!(refused(
        SHEETS,
        &[
            ("no thickness", "thickness = 0.1, ", ""),
            ("contact of sheets", "material", "contact = {}\nmaterial"),
            ("no waves", "material", "imperfection = { half_waves = [0, 1], amplitude = 0.1 }\nmaterial"),
            ("free to turn", "clamped = {}", "held = { displacement = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] }"),
        ],
    ));
}

/// Contact is not in the tangent, nor in the masses of a relaxation.
#[test]
fn contact_needs_time() {
    let text = BAR.replacen("material", "contact = { distance = 0.9 }\nmaterial", 1);
    for (analysis, refuses) in [
        ("static = { levels = 1 }", true),
        ("linear = {}", true),
        ("arc-length = { until = 1 }", true),
        ("relaxation = { levels = 1 }", true),
        ("modal = { modes = 1 }", true),
        ("buckling = { modes = 1 }", true),
        ("explicit.quasi-static = { levels = 1, period = 1.0 }", false),
    ] {
        let text = text.replacen("static = { levels = 1 }", analysis, 1);
        let built = Scene::parse(&text, "scene.toml").and_then(|scene| scene.build(1));
        let said = built.err().map(|error| render(&error, Rendering { width: 100, colour: false }));
        let Some(said) = said else {
            assert!(!refuses, "{analysis} is not refused");
            continue;
        };
        let reported =
            ["`bodies.bar.solid.contact`", "it is not in the tangent", "[analysis.explicit]", "───"];
        assert!(refuses && reported.iter().all(|words| said.contains(words)), "{analysis}: {said}");
    }
}
