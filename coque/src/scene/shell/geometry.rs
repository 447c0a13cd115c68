//! Shapes of the mid-surface, how particles are placed on them, orientation.

use nalgebra::Rotation3;
use schemars::JsonSchema;
use serde::Deserialize;
use sph_core::Vec3;

use super::mesh::Mesh;
use crate::scene::bounded::{Angle, Displaced, Grading, Polar, Positive};

/// Shape of the mid-surface. Parameters `u`, `v` run along it; `u0` names the edge at the least `u`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Geometry {
    /// Rectangle.
    Plate(Plate),
    /// Part of a cylinder about the y axis.
    Cylinder(Cylinder),
    /// Part of a sphere about the origin.
    Sphere(Sphere),
    /// Strip twisted about the x axis.
    Twisted(Twisted),
    /// Surface from a file.
    Mesh(Mesh),
}

/// Rectangle in the plane z = 0 from the origin, u along x, v along y.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Plate {
    /// Extent along x and y \[L\].
    pub lengths: [Positive; 2],
    /// A lattice: particles along u and v, those on the edges included.
    pub particles: Option<[usize; 2]>,
    /// Moves the particles of the lattice at random in the surface.
    pub disorder: Option<Disorder>,
    /// Last over first spacing of the lattice along u and v; 1 is uniform.
    pub grading: Option<[Grading; 2]>,
    /// Particles scattered at random, in place of the lattice.
    pub scattered: Option<Scattered>,
}

/// Part of a cylinder about the y axis; `u` is the angle from +z towards +x, `v` runs along y from 0.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// Radius \[L\].
    pub radius: Positive,
    /// First and last angle \[degrees\], 0 at the crown +z.
    pub angles: [f64; 2],
    /// Length along y \[L\].
    pub length: Positive,
    /// A lattice: particles along u and v, those on the edges included.
    pub particles: Option<[usize; 2]>,
    /// Moves the particles of the lattice at random in the surface.
    pub disorder: Option<Disorder>,
    /// Last over first spacing of the lattice along u and v; 1 is uniform.
    pub grading: Option<[Grading; 2]>,
    /// Particles scattered at random, in place of the lattice.
    pub scattered: Option<Scattered>,
}

/// Part of a sphere about the origin; `u` is the polar angle from +z, `v` the azimuth from +x towards +y.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Radius \[L\].
    pub radius: Positive,
    /// First and last polar angle \[degrees\]; the poles themselves are excluded.
    pub polar: [Polar; 2],
    /// First and last azimuth \[degrees\].
    pub azimuth: [f64; 2],
    /// A lattice: particles along u and v, those on the edges included.
    pub particles: Option<[usize; 2]>,
    /// Moves the particles of the lattice at random in the surface.
    pub disorder: Option<Disorder>,
    /// Last over first spacing of the lattice along u and v; 1 is uniform.
    pub grading: Option<[Grading; 2]>,
    /// Particles scattered at random, in place of the lattice.
    pub scattered: Option<Scattered>,
}

/// Strip twisted uniformly about the x axis, its centre line; `u` runs along x, `v` across.
///
/// At the root `u = 0` the width lies along +y and the normal is +z; at the tip both are turned by `twist`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Twisted {
    /// Length along x \[L\].
    pub length: Positive,
    /// Width across \[L\].
    pub width: Positive,
    /// Angle from root to tip, right-handed about +x \[degrees\].
    pub twist: Angle,
    /// A lattice: particles along u and v, those on the edges included.
    pub particles: Option<[usize; 2]>,
    /// Moves the particles of the lattice at random in the surface.
    pub disorder: Option<Disorder>,
    /// Last over first spacing of the lattice along u and v; 1 is uniform.
    pub grading: Option<[Grading; 2]>,
    /// Particles scattered at random, in place of the lattice.
    pub scattered: Option<Scattered>,
}

/// Random displacement of particles in the surface; edge particles slide along their edge, corners stay.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Disorder {
    /// Greatest displacement along u and v, in spacings.
    pub fraction: Displaced,
    /// Seed of the random numbers: the same seed gives the same cloud everywhere.
    pub seed: u64,
}

/// Particles scattered over the surface at random, none near another; those on the edges stand evenly.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scattered {
    /// Distance between particles on the edges, and inside about the side of the square that each stands for \[L\].
    pub spacing: Positive,
    /// Seed of the random numbers: the same seed gives the same cloud everywhere.
    pub seed: u64,
}

/// Rotation about the origin of geometry, supports, loads and probes together.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Orientation {
    /// Axis; its length does not matter.
    pub axis: [f64; 3],
    /// Angle \[degrees\].
    pub degrees: Angle,
}

impl Orientation {
    /// The rotation.
    pub fn rotation(&self) -> Rotation3<f64> {
        // libm: the same bits on every machine.
        let (sin, cos) = libm::sincos(self.degrees.to_radians());
        let k = Vec3::from(self.axis).normalize().cross_matrix();
        Rotation3::from_matrix_unchecked(nalgebra::Matrix3::identity() + k * sin + k * k * (1.0 - cos))
    }
}

/// Where a shape stands: its origin and the directions to which its x and y axes are turned.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Placed {
    /// Where the origin of the shape goes \[L\].
    #[serde(default)]
    pub origin: [f64; 3],
    /// Direction of its x axis, along which `u` of a plate runs; its length does not matter.
    pub u: [f64; 3],
    /// Direction of its y axis, along which `v` of a plate runs, at right angles to `u`; its length does not matter.
    pub v: [f64; 3],
}

impl Geometry {
    /// Key of the shape in a scene.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Plate(_) => "plate",
            Self::Cylinder(_) => "cylinder",
            Self::Sphere(_) => "sphere",
            Self::Twisted(_) => "twisted",
            Self::Mesh(_) => "mesh",
        }
    }

    /// The file of a mesh.
    pub fn mesh(&self) -> Option<&Mesh> {
        match self {
            Self::Mesh(mesh) => Some(mesh),
            _ => None,
        }
    }

    /// How its particles are placed; of those from a file, nothing is said.
    pub fn placing(&self) -> Placing {
        match self {
            &Self::Plate(Plate { particles, disorder, grading, scattered, .. })
            | &Self::Cylinder(Cylinder { particles, disorder, grading, scattered, .. })
            | &Self::Sphere(Sphere { particles, disorder, grading, scattered, .. })
            | &Self::Twisted(Twisted { particles, disorder, grading, scattered, .. }) => {
                Placing { particles, disorder, grading, scattered }
            }
            Self::Mesh(_) => Placing::default(),
        }
    }

    /// Where its lattice and its scattered particles stand, to change them; none of a surface from a file.
    pub(crate) fn placing_mut(&mut self) -> Option<(&mut Option<[usize; 2]>, &mut Option<Scattered>)> {
        match self {
            Self::Plate(Plate { particles, scattered, .. })
            | Self::Cylinder(Cylinder { particles, scattered, .. })
            | Self::Sphere(Sphere { particles, scattered, .. })
            | Self::Twisted(Twisted { particles, scattered, .. }) => Some((particles, scattered)),
            Self::Mesh(_) => None,
        }
    }

    /// Particles along u and v; none where they are scattered or from a file.
    pub fn particles(&self) -> Option<[usize; 2]> {
        self.placing().particles
    }
}

/// How particles are placed on a shape: the keys that all shapes share.
#[derive(Clone, Copy, Debug, Default)]
pub struct Placing {
    /// Particles of a lattice along u and v.
    pub particles: Option<[usize; 2]>,
    /// Disorder of the lattice.
    pub disorder: Option<Disorder>,
    /// Last over first spacing of the lattice along u and v.
    pub grading: Option<[Grading; 2]>,
    /// How particles are scattered in place of a lattice.
    pub scattered: Option<Scattered>,
}
