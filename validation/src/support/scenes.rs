//! The scenes that several cases run.

/// A strip rolled into a ring by an end couple, t/L = 1/10.
pub const RING: &str = include_str!("../../../scenes/ring.toml");
/// The same with the curvature measure of the paper.
pub const RING_GREEN_LAGRANGE: &str = include_str!("../../../scenes/ring-green-lagrange.toml");
/// The same at t/L = 1/120.
pub const THIN_RING: &str = include_str!("../../../scenes/thin-ring.toml");
/// A thin cantilever under a dead end force.
pub const CANTILEVER_END_SHEAR: &str = include_str!("../../../scenes/cantilever-end-shear.toml");
/// A hinged cylindrical panel pushed in at its crown.
pub const PANEL: &str = include_str!("../../../scenes/panel.toml");
/// A hemisphere with a hole under two pairs of forces.
pub const HEMISPHERE: &str = include_str!("../../../scenes/hemisphere.toml");
/// A cylinder with free ends pulled out by two forces.
pub const OPEN_CYLINDER: &str = include_str!("../../../scenes/open-cylinder.toml");
/// A cylinder between diaphragms pinched until its wall buckles inward.
pub const PINCHED_CYLINDER_LARGE: &str = include_str!("../../../scenes/pinched-cylinder-large.toml");
/// A clamped square plate under pressure.
pub const PLATE: &str = include_str!("../../../scenes/plate.toml");
