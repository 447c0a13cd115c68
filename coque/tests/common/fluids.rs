//! Small scenes of fluids: a dam break, and a gate between water and air, of a shell and of a solid.

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
