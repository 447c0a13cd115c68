//! What a user reads when the scene of a Galerkin solid is wrong: one broken scene each, rendered as in a terminal.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::galerkin::{ARC, BAR};
use crate::common::refused::refused;

#[test]
fn broken_shape_functions() {
    insta::assert_snapshot!(refused(
        BAR,
        &[
            ("unknown basis", "support.ellipsoid = 2.5", "basis = \"cubic\""),
            ("axis without a plate", "support.ellipsoid = 2.5", "across = \"y\""),
            ("unknown axis", "support.ellipsoid = 2.5", "basis = \"plate17\", across = \"w\""),
            ("narrow support", "support.ellipsoid = 2.5", "support.ellipsoid = 1.0"),
            ("wide support", "support.ellipsoid = 2.5", "support.sphere = 9.0"),
            ("two radii", "support.ellipsoid = 2.5", "support.tensor = [2.5, 2.5]"),
            ("two supports", "support.ellipsoid = 2.5", "support = { sphere = 2.5, tensor = 2.5 }"),
            ("too few nodes near", "support.ellipsoid = 2.5", "support.ellipsoid = 1.2"),
            ("a basis that the nodes do not determine", "spacing = 0.5", "spacing = [0.5, 0.5, 1.0]"),
            ("unknown kernel", "support.ellipsoid = 2.5", "kernel = \"gauss\""),
            ("no Gauss point", "support.ellipsoid = 2.5", "gauss = 0"),
            ("unknown update", "support.ellipsoid = 2.5", "update = \"end\""),
            (
                "update without history",
                "support.ellipsoid = 2.5",
                "law = \"st-venant\", update = \"midpoint\""
            ),
            ("unknown law", "support.ellipsoid = 2.5", "law = \"hooke\""),
            ("unknown tangent", "support.ellipsoid = 2.5", "tangent = \"secant\""),
            ("unknown essential", "support.ellipsoid = 2.5", "essential = \"penalty\""),
        ],
    ));
}

#[test]
fn broken_solids() {
    insta::assert_snapshot!(refused(
        BAR,
        &[
            ("one row of nodes", "lengths = [2.0, 1.0, 1.0]", "lengths = [2.0, 1.0, 0.1]"),
            ("a plane", "lengths = [2.0, 1.0, 1.0]", "lengths = [2.0, 1.0]"),
            ("negative length", "lengths = [2.0, 1.0, 1.0]", "lengths = [2.0, -1.0, 1.0]"),
            ("no length at all", "lengths = [2.0, 1.0, 1.0]", "lengths = [nan, 1.0, 1.0]"),
            ("nodes inside", "spacing = 0.5", "spacing = 0.5, nodes = \"centres\""),
            ("no stiffness", "young = 1.0", "young = 0.0"),
            ("incompressible", "poisson = 0.3", "poisson = 0.5"),
            ("below minus one", "poisson = 0.3", "poisson = -1.0"),
            ("no density", "density = 1.0", "density = 0.0"),
            ("fracture", "material", "fracture.energy = 1.0\nmaterial"),
            ("a crack", "material", "cracks = [{ corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0]] }]\nmaterial"),
            (
                "a hole",
                "material",
                "geometry.cut_outs = [{ ball = { centre = [1, 0.5, 0.5], radius = 0.1 } }]\nmaterial"
            ),
            ("contact", "material", "contact = {}\nmaterial"),
            (
                "in time",
                "analysis.static = { levels = 1 }",
                "analysis.explicit.quasi-static = { levels = 1, period = 1 }"
            ),
            ("damage", "of = \"displacement\"", "of = \"damage\""),
            ("velocity", "of = \"displacement\"", "of = \"velocity\""),
            ("a thickness in the files", "[bodies", "[output]\nfields = { extruded = true }\n[bodies"),
            ("no step", "levels = 1 }", "levels = 0 }"),
        ],
    ));
}

#[test]
fn broken_conditions_of_solids() {
    insta::assert_snapshot!(refused(
        BAR,
        &[
            ("hinge", "clamped = {}", "hinged = {}"),
            ("rotated", "clamped = {}", "rotated = { axis = [1, 0, 0], by = 1 }"),
            ("director", "clamped = {}", "held = { director = [[1, 0, 0]] }"),
            ("free to turn", "clamped = {}", "held = { displacement = [[1, 0, 0]] }"),
            ("held everywhere", "on = \"x0\"", "on = \"all\""),
            (
                "given two values",
                "[{ on = \"x0\", clamped = {} }]",
                "[{ on = \"x0\", clamped = {} }, { on = \"x0\", moved = { direction = [1, 0, 0], by = 0.1 } }]",
            ),
            ("traction inside", "on = \"x1\", traction", "on = \"all\", traction"),
            ("depth", "value = [0.001, 0.0, 0.0]", "value = [0.001, 0.0, 0.0], depth = 0.1"),
            ("dead pressure", "traction = { value = [0.001, 0.0, 0.0] }", "pressure = { value = 1 }"),
            (
                "couple",
                "traction = { value = [0.001, 0.0, 0.0] }",
                "couple = { moment = 1, axis = \"edge\" }"
            ),
            (
                "pressure on everything",
                "on = \"x1\", traction = { value = [0.001, 0.0, 0.0] }",
                "on = \"all\", pressure = { value = 1, follower = true }",
            ),
            (
                "traction on a line",
                "on = \"x1\", traction = { value = [0.001, 0.0, 0.0] } }]",
                "on = \"line\", traction = { value = [0.001, 0.0, 0.0] } }]\n\
                 sets.line = { box = { min = [2, 0, 0], max = [2, 1, 0] } }",
            ),
            ("a load that is no number", "value = [0.001", "value = [inf"),
        ],
    ));
}

#[test]
fn broken_arcs() {
    insta::assert_snapshot!(refused(
        ARC,
        &[
            ("no radius", "radius = 2.0", "radius = 0.0"),
            ("angles out of order", "angles = [0.0, 60.0]", "angles = [60.0, 0.0]"),
            ("no inner face", "thickness = 1.0", "thickness = 4.0"),
            ("no cell", "cells = [4, 2, 2]", "cells = [4, 0, 2]"),
            (
                "an arc of bonds",
                "formulation.galerkin = { support.tensor = [2.5, 2.5, 2.5] }",
                "formulation.state-based = {}"
            ),
            (
                "no shape",
                "geometry.arc = { radius = 2.0, angles = [0.0, 60.0], length = 1.0, thickness = 1.0, cells = [4, 2, 2] }",
                "geometry = {}"
            ),
            (
                "two shapes",
                "formulation",
                "geometry.block = { lengths = [1, 1, 1], spacing = 0.5 }\nformulation",
            ),
            ("negative modulus", "young = [2.0, 1.0, 1.0]", "young = [2.0, -1.0, 1.0]"),
            ("indefinite", "poisson = [0.3, 0.3, 0.3]", "poisson = [1.5, 0.3, 0.3]"),
            (
                "axes in line",
                "axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]",
                "axes = [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]"
            ),
            (
                "an axis without direction",
                "axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]",
                "axes = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]]"
            ),
        ],
    ));
}
