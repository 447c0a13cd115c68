//! A rigid body in a scene: its surface, its mass, how it sets out.

use schemars::JsonSchema;
use serde::Deserialize;

use super::per_axis::PerAxis;
use super::shell::mesh::Mesh;
use super::tools::ToolScene;
use super::velocity::Velocity;
use crate::scene::bounded::Positive;

/// A rigid body with a closed surface, which moves in six ways. Exactly one of `density` and `mass` is given.
///
/// The set `all` is the body itself, at its centre of mass: supports hold and move it there, a force acts there, a couple turns it, a column
/// measures its motion. Regions pick vertices of its surface, on which forces act and to which springs go.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RigidScene {
    /// Its surface.
    pub geometry: RigidGeometry,
    /// Density of what the surface encloses; mass, centre and inertia are those of the faces, exactly \[F T²/L⁴\].
    pub density: Option<Positive>,
    /// Mass, spread evenly over what the surface encloses \[F T²/L\].
    pub mass: Option<Positive>,
    /// Moments of inertia about the centre, along x, y and z or one for all, beside `mass`; left out, those of an even spread \[F T² L\].
    pub inertia: Option<PerAxis>,
    /// Off-diagonal terms xy, yz, zx of the same tensor, `−∫xy dm` and so on, beside `inertia` \[F T² L\].
    pub products: Option<[f64; 3]>,
    /// Velocity at the start, in transient runs.
    pub velocity: Option<Velocity>,
    /// What lies on its surface and gives way where tools press on it: a rigid body has no stiffness of contact of its own.
    pub coat: Option<Coat>,
    /// Rigid tools that it may touch, in marches; with `coat`.
    #[serde(default)]
    pub tools: Vec<ToolScene>,
}

/// An elastic coat of a rigid body, of no mass: its stiffness by area is E over its thickness.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Coat {
    /// Young's modulus E \[F/L²\].
    pub young: Positive,
    /// Thickness \[L\]; the surface of the body is its outer face.
    pub thickness: Positive,
}

/// Closed surfaces of rigid bodies.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum RigidGeometry {
    /// A ball of triangles, vertices on the ball.
    Ball(RigidBall),
    /// A box along the axes.
    Box(RigidBox),
    /// A closed surface from a file, with faces that look outwards.
    Mesh(Mesh),
}

/// A ball.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RigidBall {
    /// Its centre \[L\].
    pub centre: [f64; 3],
    /// Its radius \[L\].
    pub radius: Positive,
    /// About the distance between vertices \[L\].
    pub spacing: Positive,
}

/// A box along the axes.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RigidBox {
    /// Least coordinates \[L\].
    pub min: [f64; 3],
    /// Greatest coordinates \[L\].
    pub max: [f64; 3],
    /// About the distance between vertices \[L\].
    pub spacing: Positive,
}

impl RigidScene {
    /// Mass over the volume that is enclosed; none of a mass in a mesh, whose volume is read later \[F T²/L⁴\].
    pub(crate) fn mean_density(&self) -> Option<f64> {
        let volume = match &self.geometry {
            RigidGeometry::Ball(ball) => 4.0 / 3.0 * std::f64::consts::PI * ball.radius.get().powi(3),
            RigidGeometry::Box(own) => (0..3).map(|k| own.max[k] - own.min[k]).product(),
            RigidGeometry::Mesh(_) => f64::INFINITY,
        };
        let spread = self.mass.map(|mass| mass.get() / volume).filter(|_| volume.is_finite());
        self.density.map(|density| density.get()).or(spread)
    }
}

impl RigidGeometry {
    /// Its key.
    pub(crate) fn word(&self) -> &'static str {
        match self {
            Self::Ball(_) => "ball",
            Self::Box(_) => "box",
            Self::Mesh(_) => "mesh",
        }
    }

    /// About the number of vertices that it asks for; none before a mesh is read.
    pub(crate) fn particles(&self) -> f64 {
        match self {
            Self::Ball(ball) => 2.0 + 11.1 * (ball.radius.get() / ball.spacing.get()).powi(2),
            Self::Box(own) => {
                let edge = |k: usize| (own.max[k] - own.min[k]) / own.spacing.get();
                2.0 + 2.0 * (edge(0) * edge(1) + edge(1) * edge(2) + edge(2) * edge(0))
            }
            Self::Mesh(_) => 0.0,
        }
    }
}
