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

/// The hemisphere with a hole, a quarter.
pub const HEMISPHERE: Shape = Shape {
    name: "hemisphere",
    scene: scenes::HEMISPHERE,
    geometry: "sphere",
    keys: "radius = 10.0, polar = [18.0, 90.0], azimuth = [0.0, 90.0]",
    counts: [21, 21],
    spacing: 0.61,
};
