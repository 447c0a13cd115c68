//! The same scene on particles in rows, moved about, scattered, and graded.

use super::scenes;
use crate::judge::Variant;

/// How particles are placed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cloud {
    /// On a lattice.
    Lattice,
    /// On a lattice, moved at random by up to a part of the spacing; the seed.
    Jitter(f64, u64),
    /// At random, none near another; the seed.
    Scattered(u64),
    /// On a lattice whose last spacing is ten times the first, both ways.
    Graded,
}

impl Cloud {
    /// Name in the survival table.
    pub fn name(self) -> String {
        match self {
            Self::Lattice => "lattice".into(),
            Self::Jitter(fraction, seed) => format!("jitter {fraction} #{seed}"),
            Self::Scattered(seed) => format!("Poisson #{seed}"),
            Self::Graded => "graded 1:10".into(),
        }
    }

    /// Keys of a geometry with so many particles, or with particles so far apart.
    fn keys(self, [u, v]: [usize; 2], spacing: f64) -> String {
        match self {
            Self::Lattice => format!("particles = [{u}, {v}]"),
            Self::Jitter(fraction, seed) => {
                format!("particles = [{u}, {v}], disorder = {{ fraction = {fraction:?}, seed = {seed} }}")
            }
            Self::Scattered(seed) => format!("scattered = {{ spacing = {spacing:?}, seed = {seed} }}"),
            Self::Graded => format!("particles = [{u}, {v}], grading = [10.0, 10.0]"),
        }
    }
}

/// A scene whose particles may be placed in several ways.
#[derive(Clone, Copy)]
pub struct Shape {
    /// Name in the survival table.
    pub name: &'static str,
    /// The scene.
    pub scene: &'static str,
    /// Its geometry.
    pub geometry: &'static str,
    /// Keys of the geometry, particles left out.
    pub keys: &'static str,
    /// Particles of a lattice.
    pub counts: [usize; 2],
    /// Spacing of scattered particles, about as many as on the lattice \[L\].
    pub spacing: f64,
}

impl Shape {
    /// Name of the shape on a cloud.
    pub fn label(&self, cloud: Cloud) -> String {
        format!("{} {}", self.name, cloud.name())
    }

    /// The scene with a method on a cloud.
    pub fn on(&self, method: &str, cloud: Cloud) -> Variant {
        let places = cloud.keys(self.counts, self.spacing);
        Variant::new(method, self.scene, self.geometry, self.counts)
            .set(&format!("geometry.{}", self.geometry), format!("{{ {}, {places} }}", self.keys))
            .named(self.label(cloud))
    }
}

/// The square plate, the hemisphere with a hole and the hinged panel (a quarter of both), the strip of the ring, the open cylinder.
#[rustfmt::skip] // a table
mod shapes {
    use super::{scenes, Shape};

    pub const PLATE: Shape = Shape { name: "plate", scene: scenes::PLATE, geometry: "plate", keys: "lengths = [1.0, 1.0]", counts: [21, 21], spacing: 0.05 };
    pub const HEMISPHERE: Shape = Shape { name: "hemisphere", scene: scenes::HEMISPHERE, geometry: "sphere",
        keys: "radius = 10.0, polar = [18.0, 90.0], azimuth = [0.0, 90.0]", counts: [21, 21], spacing: 0.61 };
    pub const PANEL: Shape = Shape { name: "panel", scene: scenes::PANEL, geometry: "cylinder",
        keys: "radius = 2540.0, angles = [0.0, 5.729577951308232], length = 254.0", counts: [21, 21], spacing: 12.7 };
    pub const STRIP: Shape = Shape { name: "ring", scene: scenes::RING, geometry: "plate", keys: "lengths = [10.0, 1.0]", counts: [50, 3], spacing: 0.22 };
    pub const CYLINDER: Shape = Shape { name: "open cylinder", scene: scenes::OPEN_CYLINDER, geometry: "cylinder",
        keys: "radius = 4.953, angles = [0.0, 90.0], length = 5.175", counts: [25, 17], spacing: 0.33 };
}
pub use shapes::{CYLINDER, HEMISPHERE, PANEL, PLATE, STRIP};
