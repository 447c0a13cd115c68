//! Small scenes of Galerkin solids.

/// A bar in space, held at one end and pulled at the other.
pub const BAR: &str = r#"title = "Bar"
units = { length = "m", force = "N", time = "s" }
analysis.static = { levels = 1 }
supports = [{ on = "x0", clamped = {} }]
loads = [{ on = "x1", traction = { value = [0.001, 0.0, 0.0] } }]
curve = [{ name = "u", of = "displacement", on = "x1", direction = [1.0, 0.0, 0.0] }]
[bodies.bar.solid]
geometry.block = { lengths = [2.0, 1.0, 1.0], spacing = 0.5 }
material.elastic = { young = 1.0, poisson = 0.3, density = 1.0 }
formulation.galerkin = { support.ellipsoid = 2.5 }
"#;

/// Part of a thick cylinder, orthotropic.
pub const ARC: &str = r#"title = "Arc"
units = { length = "m", force = "N", time = "s" }
analysis.linear = {}
supports = [{ on = "x0", clamped = {} }]
loads = [{ on = "x1", traction = { value = [0.001, 0.0, 0.0] } }]
[bodies.arc.solid]
geometry.arc = { radius = 2.0, angles = [0.0, 60.0], length = 1.0, thickness = 1.0, cells = [4, 2, 2] }
formulation.galerkin = { support.tensor = [2.5, 2.5, 2.5] }
[bodies.arc.solid.material.orthotropic]
young = [2.0, 1.0, 1.0]
poisson = [0.3, 0.3, 0.3]
shear = [0.4, 0.4, 0.4]
density = 1.0
axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
"#;
