//! Small scenes of fluids: a dam break, and a gate between water and air, of a shell and of a solid.

use coque::Outcome;

use super::column;

/// Greatest difference of a column from a factor times another, over the greatest.
pub fn apart(one: &Outcome, other: &Outcome, name: &str, factor: f64) -> f64 {
    let [one, other] = [one, other].map(|outcome| column(outcome, name));
    let most = one.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let pairs = one.iter().zip(&other);
    pairs.map(|(a, b)| (a * factor - b).abs()).fold(0.0, f64::max) / (factor.abs() * most)
}

/// A column of water in a tank.
pub const DAM: &str = r#"title = "Dam break"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.05, record_every = 0.01 }
loads = [{ on = "all", gravity = { acceleration = [0.0, -10.0, 0.0] } }]
sets.gauge = { of = "tank", nearest = [0.4, 0.02, 0.0] }
curve = [
    { name = "front", of = "position", on = "water.all", take = "max", direction = [1, 0, 0] },
    { name = "p", of = "pressure", on = "gauge" },
    { name = "h", of = "level", on = "gauge" },
    { name = "F", of = "force", on = "tank.x0", direction = [1, 0, 0] },
]
[bodies.water.fluid]
geometry.block = { lengths = [0.1, 0.2], spacing = 0.02 }
material.liquid = { density = 1000.0, sound_speed = 20.0 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0], max = [0.4, 0.4], open = ["y1"] }
"#;

/// Water that leans on a gate of a solid, clamped at its top.
pub const GATE: &str = r#"title = "Gate"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.01, record_every = 0.002 }
loads = [{ on = "all", gravity = { acceleration = [0.0, -10.0, 0.0] } }]
sets.root = { of = "gate", box = { min = [0.1, 0.17, 0.0], max = [0.14, 0.2, 0.0] } }
supports = [{ on = "root", clamped = {} }]
curve = [
    { name = "dx", of = "displacement", on = "gate.y0", direction = [1, 0, 0] },
    { name = "F", of = "force", on = "gate.all", direction = [1, 0, 0] },
]
[bodies.water.fluid]
geometry.block = { lengths = [0.1, 0.16], spacing = 0.01 }
material.liquid = { density = 1000.0, sound_speed = 20.0 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0], max = [0.4, 0.3], open = ["y1"] }
[bodies.gate.solid]
geometry.block = { lengths = [0.04, 0.2], spacing = 0.01, origin = [0.1, 0.0] }
material.elastic = { young = 1e6, poisson = 0.3333, density = 1100.0 }
formulation.state-based = { horizon = 3.015, plane = "strain" }
"#;

/// The same with a gate of a shell, a strip across the plane.
pub const SHELL_GATE: &str = r#"title = "Gate of a shell"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.01, record_every = 0.002 }
loads = [{ on = "all", gravity = { acceleration = [0.0, -10.0, 0.0] } }]
supports = [
    { on = "gate.u1", clamped = {} },
    { on = "gate.v0", symmetry = { normal = [0, 0, 1] } },
    { on = "gate.v1", symmetry = { normal = [0, 0, 1] } },
]
curve = [{ name = "dx", of = "displacement", on = "gate.u0", direction = [1, 0, 0] }]
[bodies.water.fluid]
geometry.block = { lengths = [0.1, 0.16], spacing = 0.01 }
material.liquid = { density = 1000.0, sound_speed = 20.0 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0], max = [0.4, 0.3], open = ["y1"] }
[bodies.gate.shell]
geometry.plate = { lengths = [0.2, 0.08], particles = [11, 2] }
placed = { origin = [0.11, 0.0, -0.04], u = [0, 1, 0], v = [0, 0, 1] }
material.elastic = { young = 1e6, poisson = 0.3, density = 1100.0 }
section.homogeneous = { thickness = 0.02 }
"#;

/// A cube of water on a square plate in space, clamped all round and wet on its upper face.
pub const CUBE: &str = r#"title = "Cube of water on a plate"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.004, record_every = 0.001 }
loads = [{ on = "all", gravity = { acceleration = [0.0, 0.0, -10.0] } }]
supports = [
    { on = "plate.u0", clamped = {} },
    { on = "plate.u1", clamped = {} },
    { on = "plate.v0", clamped = {} },
    { on = "plate.v1", clamped = {} },
]
curve = [
    { name = "F", of = "force", on = "plate.all", direction = [0, 0, 1] },
    { name = "Mx", of = "moment", on = "plate.all", direction = [1, 0, 0] },
    { name = "Mc", of = "moment", on = "plate.all", direction = [1, 0, 0], about = [0.1, 0.1, 0.0] },
    { name = "w", of = "displacement", on = "plate.all", take = "min", direction = [0, 0, 1] },
    { name = "p", of = "pressure", on = "water.all", at = [0.1, 0.1, 0.05] },
    { name = "h", of = "level", on = "water.all", at = [0.1, 0.1, 0.0] },
    { name = "Q", of = "flux", on = "water.all", through = { point = [0.1, 0.0, 0.0], normal = [1, 0, 0] } },
]
[bodies.water.fluid]
geometry.block = { lengths = [0.2, 0.2, 0.2], spacing = 0.02 }
material.liquid = { density = 1000.0, sound_speed = 20.0 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0, -0.06], max = [0.2, 0.2, 0.3], open = ["z0", "z1"] }
[bodies.plate.shell]
geometry.plate = { lengths = [0.2, 0.2], particles = [11, 11] }
placed = { origin = [0.0, 0.0, -0.01], u = [1, 0, 0], v = [0, 1, 0] }
wet = "front"
material.elastic = { young = 1e8, poisson = 0.3, density = 2700.0 }
section.homogeneous = { thickness = 0.02 }
"#;

/// A piston that pushes a fifth of the water's length, with a smooth course.
pub const PISTON: &str = r#"title = "Piston"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 1.0, record_every = 0.005 }
loads = [{ on = "all", gravity = { acceleration = [0.0, -10.0, 0.0] } }]
curve = [
    { name = "Q", of = "flux", on = "water.all", through = { point = [0.1, 0, 0], normal = [1, 0, 0], max = [1, 0.3, 1] } },
    { name = "h", of = "level", on = "water.all", at = [0.15, 0.0, 0.0] },
    { name = "x", of = "position", on = "piston.all", take = "max", direction = [1, 0, 0] },
    { name = "F", of = "force", on = "piston.all", direction = [1, 0, 0] },
]
[bodies.water.fluid]
geometry.block = { lengths = [0.2, 0.1], spacing = 0.01 }
material.liquid = { density = 1000.0, sound_speed = 15.0 }
[bodies.tank.walls]
geometry.basin = { min = [-0.1, 0.0], max = [0.2, 0.2], open = ["x0", "y1"] }
[bodies.piston.walls]
geometry.block = { lengths = [0.03, 0.2], origin = [-0.03, 0.0] }
motion.translation = { by = [0.04, 0.0, 0.0], amplitude = { smooth = 0.6 } }
"#;

/// A tank that rolls by a table, with a gauge high on its dry right wall, and one below the water.
pub const ROLLING: &str = r#"title = "Rolling tank"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.2, record_every = 0.02 }
loads = [{ on = "all", gravity = { acceleration = [0.0, -10.0, 0.0] } }]
curve = [
    { name = "dry", of = "level", on = "tank.all", at = [0.7, 0.35, 0.0] },
    { name = "wet", of = "pressure", on = "tank.all", at = [0.3, 0.0, 0.0] },
    { name = "fixed", of = "pressure", on = "water.all", at = [0.3, 0.0, 0.0] },
    { name = "corner", of = "position", on = "corner", direction = [0, 1, 0] },
]
[sets]
corner = { of = "tank", nearest = [0.4, 0.4, 0.0] }
[bodies.water.fluid]
geometry.block = { lengths = [0.4, 0.1], spacing = 0.02 }
material.liquid = { density = 1000.0, sound_speed = 20.0 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0], max = [0.4, 0.4], open = ["y1"] }
[bodies.tank.walls.motion.rotation]
axis = [0, 0, 1]
centre = [0.2, 0.1, 0.0]
by = 20.0
amplitude = { table = [[0.0, 0.0], [0.1, 0.5], [0.2, 1.0]] }
"#;

/// A tank in space that rolls about a skew axis; a gauge stands where a particle of its dry wall does.
pub const ROLLING_IN_SPACE: &str = r#"title = "Rolling tank in space"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.1, record_every = 0.02 }
loads = [{ on = "all", gravity = { acceleration = [0.0, 0.0, -10.0] } }]
curve = [
    { name = "dry", of = "level", on = "tank.all", at = [0.31, 0.15, 0.25] },
    { name = "z", of = "position", on = "corner", direction = [0, 0, 1] },
]
[sets]
corner = { of = "tank", nearest = [0.31, 0.15, 0.25] }
[bodies.water.fluid]
geometry.block = { lengths = [0.1, 0.1, 0.1], spacing = 0.02 }
material.liquid = { density = 1000.0, sound_speed = 25.0 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0, 0.0], max = [0.3, 0.3, 0.3], open = ["z1"] }
[bodies.tank.walls.motion.rotation]
axis = [1, -2, 0.5]
centre = [0.2, 0.1, 0.0]
by = 20.0
amplitude = { table = [[0.0, 0.0], [0.1, 1.0]] }
"#;

/// Two shells behind water: it presses the first onto the second, and that onto a sill.
pub const PAIR: &str = r#"title = "Two gates and a sill"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.06, record_every = 0.002 }
loads = [{ on = "all", gravity = { acceleration = [0.0, -10.0, 0.0] } }]
supports = [
    { on = "first.u1", clamped = {} },
    { on = "first.v0", symmetry = { normal = [0, 0, 1] } },
    { on = "first.v1", symmetry = { normal = [0, 0, 1] } },
    { on = "second.u1", clamped = {} },
    { on = "second.v0", symmetry = { normal = [0, 0, 1] } },
    { on = "second.v1", symmetry = { normal = [0, 0, 1] } },
]
contact = [{ between = ["first", "second"] }, { between = ["second", "sill"] }]
curve = [
    { name = "F", of = "contact-force", on = "first.all", direction = [1, 0, 0] },
    { name = "G", of = "contact-force", on = "second.all", direction = [1, 0, 0] },
    { name = "dx", of = "displacement", on = "second.u0", direction = [1, 0, 0] },
    { name = "depth", of = "greatest-depth", on = "second.all" },
    { name = "gap", of = "contact-gap", on = "first.all" },
]
[bodies.water.fluid]
geometry.block = { lengths = [0.1, 0.16], spacing = 0.01 }
material.liquid = { density = 1000.0, sound_speed = 20.0 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0], max = [0.4, 0.3], open = ["y1"] }
[bodies.sill.walls]
geometry.block = { lengths = [0.05, 0.05], origin = [0.15, 0.0] }
[bodies.first.shell]
geometry.plate = { lengths = [0.2, 0.08], particles = [11, 2] }
placed = { origin = [0.11, 0.0, -0.04], u = [0, 1, 0], v = [0, 0, 1] }
material.elastic = { young = 4e5, poisson = 0.3, density = 1100.0 }
section.homogeneous = { thickness = 0.02 }
[bodies.second.shell]
geometry.plate = { lengths = [0.2, 0.08], particles = [14, 2] }
placed = { origin = [0.138, 0.0, -0.04], u = [0, 1, 0], v = [0, 0, 1] }
material.elastic = { young = 4e5, poisson = 0.3, density = 1100.0 }
section.homogeneous = { thickness = 0.02 }
"#;

/// A box afloat that drifts and rolls.
pub const AFLOAT: &str = r#"title = "A box afloat"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.2, record_every = 0.01 }
loads = [{ on = "all", gravity = { acceleration = [0.0, -10.0, 0.0] } }]
curve = [
    { name = "x", of = "displacement", on = "float.all", direction = [1, 0, 0] },
    { name = "y", of = "displacement", on = "float.all", direction = [0, 1, 0] },
    { name = "roll", of = "rotation", on = "float.all", direction = [0, 0, 1] },
    { name = "lift", of = "force", on = "float.all", direction = [0, 1, 0] },
]
[bodies.water.fluid]
geometry.block = { lengths = [0.6, 0.2], spacing = 0.02 }
material.liquid = { density = 1000.0, sound_speed = 20.0 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0], max = [0.6, 0.4], open = ["y1"] }
[bodies.float.rigid]
geometry.box = { min = [0.16, 0.14, -0.04], max = [0.32, 0.26, 0.04], spacing = 0.04 }
density = 500.0
velocity = { linear = [0.2, 0.0, 0.0], spin = { axis = [0, 0, 1], point = [0.24, 0.2, 0.0], rate = 2.0 } }
"#;
