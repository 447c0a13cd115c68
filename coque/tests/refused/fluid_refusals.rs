//! What a user reads when a scene with a fluid is wrong: one broken scene each, rendered as in a terminal.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::fluids::{DAM, GATE, SHELL_GATE};
use crate::common::refused::refused;
use coque::Scene;

#[test]
fn sound_scenes_are_read() {
    for text in [DAM, GATE, SHELL_GATE] {
        Scene::parse(text, "scene.toml").unwrap();
    }
}

#[test]
fn broken_fluids() {
    let drop =
        "[bodies.tank.walls]\ngeometry.basin = { min = [0.0, 0.0], max = [0.4, 0.4], open = [\"y1\"] }\n";
    let second = "[bodies.oil.fluid]\ngeometry.block = { lengths = [0.1, 0.2], spacing = 0.02 }\n\
                  material.liquid = { density = 900.0, sound_speed = 20.0 }\n";
    insta::assert_snapshot!(refused(
        DAM,
        &[
            ("a length between rows", "lengths = [0.1, 0.2]", "lengths = [0.11, 0.2]"),
            ("one length", "lengths = [0.1, 0.2]", "lengths = [0.1]"),
            ("no spacing", ", spacing = 0.02", ""),
            ("negative spacing", "spacing = 0.02", "spacing = -0.02"),
            ("too many particles", "spacing = 0.02", "spacing = 1e-5"),
            ("origin in space", "spacing = 0.02", "spacing = 0.02, origin = [0.0, 0.0, 0.0]"),
            (
                "two shapes",
                "geometry.block = {",
                "geometry.disc = { centre = [0, 0], radius = 0.1, spacing = 0.02 }\ngeometry.block = {"
            ),
            (
                "a disc between rows",
                "geometry.block = { lengths = [0.1, 0.2], spacing",
                "geometry.disc = { centre = [0.1, 0.1], radius = 0.07, spacing"
            ),
            (
                "an annulus inside out",
                "geometry.block = { lengths = [0.1, 0.2], spacing",
                "geometry.annulus = { centre = [0.1, 0.1], inner = 0.2, outer = 0.1, spacing"
            ),
            (
                "no blocks",
                "geometry.block = { lengths = [0.1, 0.2], spacing = 0.02 }",
                "geometry.blocks = { spacing = 0.02, parts = [] }"
            ),
            ("no density", "density = 1000.0, ", ""),
            ("slow sound", "sound_speed = 20.0", "sound_speed = 5.0"),
            ("slow sound for its start", "[bodies.tank", "velocity.linear = [10.0, 0.0, 0.0]\n[bodies.tank"),
            ("out of the plane", "[bodies.tank", "velocity.linear = [0.0, 0.0, 0.1]\n[bodies.tank"),
            ("gravity out of the plane", "[0.0, -10.0, 0.0]", "[0.0, -10.0, 1.0]"),
            (
                "gravity with a course",
                "[0.0, -10.0, 0.0] }",
                "[0.0, -10.0, 0.0] }, amplitude = { ramp = 1.0 }"
            ),
            (
                "smoothing",
                "material.liquid",
                "formulation.weakly-compressible = { smoothing = 0.5 }\nmaterial.liquid"
            ),
            (
                "courant",
                "material.liquid",
                "formulation.weakly-compressible = { courant = 0.6 }\nmaterial.liquid"
            ),
            (
                "unknown method",
                "material.liquid",
                "formulation.weakly-compressible = { method = \"rk4\" }\nmaterial.liquid"
            ),
            ("an inflow", "material.liquid", "inflow = { speed = 1.0 }\nmaterial.liquid"),
            ("a support", "sets.gauge", "supports = [{ on = \"water.all\", clamped = {} }]\nsets.gauge"),
            (
                "a force",
                "gravity = { acceleration = [0.0, -10.0, 0.0] } }]",
                "gravity = { acceleration = [0.0, -10.0, 0.0] } }, { on = \"water.all\", force = { total = [1, 0, 0] } }]"
            ),
            (
                "without time",
                "analysis.explicit.transient = { duration = 0.05, record_every = 0.01 }",
                "analysis.static = { levels = 1 }"
            ),
            ("two fluids", "[bodies.water.fluid]", &format!("{second}[bodies.water.fluid]")),
            ("coupling of nothing", "loads =", "coupling = { impedance = false }\nloads ="),
            ("nothing on an open side", "on = \"tank.x0\"", "on = \"tank.y1\""),
            ("no such side", "on = \"tank.x0\"", "on = \"tank.z0\""),
            ("a set of no body", "on = \"water.all\"", "on = \"watre.all\""),
            ("a column of all", "on = \"water.all\"", "on = \"all\""),
            ("a set without a body", "of = \"tank\", nearest", "nearest"),
            (
                "a set far from the fluid",
                "{ of = \"tank\", nearest = [0.4, 0.02, 0.0] }",
                "{ of = \"tank\", box = { min = [1, 1, 0], max = [2, 2, 0] } }"
            ),
            ("reaction of a fluid", "of = \"position\"", "of = \"reaction\""),
            (
                "level of a fluid",
                "of = \"position\", on = \"water.all\", take = \"max\", direction = [1, 0, 0]",
                "of = \"level\", on = \"water.all\""
            ),
            (
                "a direction of a pressure",
                "of = \"pressure\", on",
                "of = \"pressure\", direction = [1, 0, 0], on"
            ),
            ("a point of a force", "of = \"force\", on", "of = \"force\", about = [0, 0, 0], on"),
            (
                "a flux through nothing",
                "of = \"pressure\", on = \"gauge\"",
                "of = \"flux\", on = \"water.all\""
            ),
            (
                "a flux of walls",
                "of = \"pressure\", on",
                "of = \"flux\", through = { point = [0, 0, 0], normal = [1, 0, 0] }, on"
            ),
            (
                "a flux across the plane",
                "of = \"pressure\", on = \"gauge\"",
                "of = \"flux\", on = \"water.all\", through = { point = [0, 0, 0], normal = [1, 0, 1] }"
            ),
            (
                "a section inside out",
                "of = \"pressure\", on = \"gauge\"",
                "of = \"flux\", on = \"water.all\", through = { point = [0, 0, 0], normal = [1, 0, 0], min = [0, 1, 0], \
                 max = [1, 0, 0] }"
            ),
            (
                "a direction of a flux",
                "of = \"pressure\", on = \"gauge\"",
                "of = \"flux\", direction = [1, 0, 0], on = \"water.all\", through = { point = [0, 0, 0], normal = [1, 0, 0] }"
            ),
            (
                "a section of a pressure",
                "of = \"pressure\", on",
                "of = \"pressure\", through = { point = [0, 0, 0], normal = [1, 0, 0] }, on"
            ),
            ("a point of a position", "of = \"position\", on", "of = \"position\", at = [0, 0, 0], on"),
            ("a point of a set", "of = \"pressure\", on", "of = \"pressure\", at = [0, 0, 0], on"),
            ("a plot of nothing", "loads =", "output.plot = { x = \"time\", y = \"fornt\" }\nloads ="),
            (
                "walls alone",
                "[bodies.water.fluid]\ngeometry.block = { lengths = [0.1, 0.2], spacing = 0.02 }\nmaterial.liquid = { density = 1000.0, sound_speed = 20.0 }\n",
                ""
            ),
            (
                "walls in space",
                "min = [0.0, 0.0], max = [0.4, 0.4]",
                "min = [0.0, 0.0, 0.0], max = [0.4, 0.4, 0.4]"
            ),
            ("a name that is no set", drop, ""),
        ],
    ));
}

#[test]
fn broken_walls() {
    let motion = |text: &str| format!("motion.{text}\ngeometry.basin");
    insta::assert_snapshot!(refused(
        DAM,
        &[
            ("min above max", "min = [0.0, 0.0], max = [0.4, 0.4]", "min = [0.0, 0.5], max = [0.4, 0.4]"),
            ("other dimensions", "max = [0.4, 0.4]", "max = [0.4, 0.4, 0.4]"),
            ("unknown side", "open = [\"y1\"]", "open = [\"top\"]"),
            ("no side left", "open = [\"y1\"]", "open = [\"x0\", \"x1\", \"y0\", \"y1\"]"),
            (
                "one point",
                "basin = { min = [0.0, 0.0], max = [0.4, 0.4], open = [\"y1\"] }",
                "polyline = { points = [[0, 0]], side = \"left\" }"
            ),
            (
                "a point twice",
                "basin = { min = [0.0, 0.0], max = [0.4, 0.4], open = [\"y1\"] }",
                "polyline = { points = [[0, 0], [0, 0]], side = \"left\" }"
            ),
            (
                "no side of a line",
                "basin = { min = [0.0, 0.0], max = [0.4, 0.4], open = [\"y1\"] }",
                "polyline = { points = [[0, 0], [1, 0]] }"
            ),
            ("a motion of nothing", "geometry.basin", &motion("rotation = { axis = [0, 0, 1], by = 4.0 }")),
            (
                "a sudden motion",
                "geometry.basin",
                &motion("translation = { by = [0.1, 0, 0], amplitude = \"constant\" }")
            ),
            (
                "out of the plane",
                "geometry.basin",
                &motion("translation = { by = [0.1, 0, 0.1], amplitude = { ramp = 1.0 } }")
            ),
            (
                "a turn out of the plane",
                "geometry.basin",
                &motion("rotation = { axis = [1, 0, 0], by = 4.0, amplitude = { sine = { period = 1.0 } } }")
            ),
            ("a support", "sets.gauge", "supports = [{ on = \"tank.x0\", clamped = {} }]\nsets.gauge"),
            (
                "a load",
                "gravity = { acceleration = [0.0, -10.0, 0.0] } }]",
                "gravity = { acceleration = [0.0, -10.0, 0.0] } }, { on = \"tank.x0\", force = { total = [1, 0, 0] } }]"
            ),
        ],
    ));
}

#[test]
fn broken_structures_in_a_fluid() {
    insta::assert_snapshot!(
        refused(
            GATE,
            &[
                ("a set of another body", "of = \"gate\", box", "of = \"water\", box"),
                ("a support without a body", "on = \"root\", clamped", "on = \"all\", clamped"),
                ("an unknown set of the second column", "on = \"gate.all\"", "on = \"gate.tip\""),
                ("force on a part", "on = \"gate.all\"", "on = \"gate.x0\""),
                (
                    "pressure on a structure",
                    "of = \"force\", on = \"gate.all\", direction = [1, 0, 0]",
                    "of = \"pressure\", on = \"gate.all\""
                ),
                (
                    "moment on a part",
                    "of = \"force\", on = \"gate.all\"",
                    "of = \"moment\", on = \"gate.x0\""
                ),
                (
                    "another spacing",
                    "lengths = [0.04, 0.2], spacing = 0.01",
                    "lengths = [0.04, 0.2], spacing = 0.02"
                ),
                ("no direction of a force", "on = \"gate.all\", direction = [1, 0, 0]", "on = \"gate.all\""),
                ("a name twice", "name = \"F\"", "name = \"dx\""),
                (
                    "a solid in space",
                    "lengths = [0.04, 0.2], spacing = 0.01, origin = [0.1, 0.0]",
                    "lengths = [0.04, 0.2, 0.04], spacing = 0.01, origin = [0.1, 0.0, 0.0]"
                ),
                ("an unknown order", "loads =", "coupling = { order = \"both\" }\nloads ="),
                ("extruded", "loads =", "output.fields = { extruded = true }\nloads ="),
                ("nothing holds", "max = [0.14, 0.2, 0.0]", "max = [0.14, 0.16, 0.0]"),
                ("a wrong modulus", "young = 1e6", "young = -1e6"),
            ],
        ) + &refused(
            SHELL_GATE,
            &[
                ("a skew place", "u = [0, 1, 0], v = [0, 0, 1]", "u = [0, 1, 1], v = [0, 0, 1]"),
                (
                    "a turned frame",
                    "placed = { origin = [0.11, 0.0, -0.04], u = [0, 1, 0], v = [0, 0, 1] }",
                    "orientation = { axis = [1, 1, 1], degrees = 120 }"
                ),
                ("unknown wet faces", "placed =", "wet = \"left\"\nplaced ="),
                (
                    "a wrong support, the third",
                    "on = \"gate.v1\", symmetry = { normal = [0, 0, 1] }",
                    "on = \"gate.v1\", symmetry = { normal = [0, 0, 0] }"
                ),
            ],
        )
    );
}
