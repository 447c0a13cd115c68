//! Small scenes of solids: in space, in a plane, as two sheets.

/// A bar in space, held at one end and pulled at the other.
pub const BAR: &str = r#"title = "Bar"
units = { length = "m", force = "N", time = "s" }
analysis.static = { levels = 1 }
supports = [{ on = "x0", clamped = {} }]
loads = [{ on = "x1", traction = { value = [1.0, 0.0, 0.0] } }]
curve = [{ name = "u", of = "displacement", on = "x1", direction = [1.0, 0.0, 0.0] }]
[bodies.bar.solid]
geometry.block = { lengths = [4.0, 1.0, 1.0], spacing = 0.25 }
material.elastic = { young = 1.0, poisson = 0.3, density = 1.0 }
formulation.state-based = { horizon = 3.015 }
"#;

/// A plate in its plane that breaks.
pub const PLATE: &str = r#"title = "Plate"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 1.0, record_every = 0.1 }
supports = [{ on = "x0", held = { displacement = [[1.0, 0.0, 0.0]] } }]
loads = [{ on = "x1", traction = { value = [1.0, 0.0, 0.0] } }]
curve = [{ name = "d", of = "damage", on = "all", take = "max" }]
[bodies.plate.solid]
geometry.block = { lengths = [4.0, 2.0], spacing = 0.25 }
material.elastic = { young = 1.0, poisson = 0.3333, density = 1.0 }
formulation.bond-based = { horizon = 3.015, plane = "stress" }
fracture = { energy = 1.0 }
cracks = [{ from = [0.0, 1.0], to = [1.0, 1.0] }]
unbreakable = ["x1"]
"#;

/// A thin plate of two sheets.
pub const SHEETS: &str = r#"title = "Sheets"
units = { length = "m", force = "N", time = "s" }
analysis.static = { levels = 1 }
supports = [{ on = "x0", clamped = {} }]
loads = [{ on = "x1", force = { total = [0.0, 0.0, 1.0] } }]
[bodies.plate.solid]
geometry.block = { lengths = [4.0, 2.0], thickness = 0.1, spacing = 0.5 }
material.elastic = { young = 1.0, poisson = 0.3, density = 1.0 }
formulation.two-sheets = {}
"#;
