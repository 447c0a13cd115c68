//! A surface on a tool: energy, forces, tangent, and what is measured of them.

use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::law::Law;
use crate::surface::{Surface, Vertex};
use crate::tool::{Face, Gap, ToolShape};
use crate::watch::Watch;

/// A surface and a tool that may touch.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolContact {
    /// The tool, checked.
    pub tool: ToolShape,
    /// The surface.
    pub surface: Surface,
    /// The law.
    pub law: Law,
    /// Stiffness κ of a unit of area \[F/L³\].
    pub stiffness: f64,
}

/// What a surface and a tool do to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Energy \[F L\].
    pub energy: f64,
    /// Force on the surface \[F\].
    pub force: Vec3,
    /// Greatest depth over the distance at which faces touch \[–\]; mid-surfaces come through at one.
    pub greatest_depth: f64,
    /// Area that touches \[L²\].
    pub area: f64,
}

impl Touch {
    /// Far from each other.
    const NONE: Self = Self { energy: 0.0, force: Vec3::new(0.0, 0.0, 0.0), greatest_depth: 0.0, area: 0.0 };
}

impl ToolContact {
    /// Adds the forces on the particles, with the tool moved by a translation \[L\]; the watch passes over what is far.
    ///
    /// `U = Σ κ A D² φ(s)` with `D = t/2` and `s = (D − g)/D`: the force on a vertex is `κ A D φ′ ∇g`.
    pub fn forces(
        &self,
        watch: &mut Watch,
        moved: &Vec3,
        at: impl Fn(u32) -> Vec3,
        mut add: impl FnMut(u32, Vec3),
    ) -> Touch {
        let mut touch = Touch::NONE;
        watch.each_near(self, moved, &at, |vertex| {
            let Face { distance, normal } = self.tool.face(&vertex.place(&at), moved);
            let depth = 1.0 - distance / vertex.half;
            if depth <= 0.0 {
                return;
            }
            let [energy, slope, _] = self.law.at(depth);
            let stiff = self.stiffness * vertex.area * vertex.half;
            let force = normal * (stiff * slope);
            touch.energy += stiff * vertex.half * energy;
            touch.force += force;
            touch.greatest_depth = touch.greatest_depth.max(depth);
            touch.area += vertex.area;
            let share = force * vertex.share();
            vertex.nodes().iter().for_each(|&a| add(a, share));
        });
        touch
    }

    /// Least gap between the faces of surface and tool \[L\], negative where they are in each other.
    pub fn least_gap(&self, moved: &Vec3, at: impl Fn(u32) -> Vec3) -> f64 {
        let gap = |vertex: &Vertex| self.tool.face(&vertex.place(&at), moved).distance - vertex.half;
        self.surface.vertices().iter().map(gap).fold(f64::INFINITY, f64::min)
    }

    /// Hands the derivatives of the force on a particle by the place of another to `put`: `−κ A φ″ ∇g∇gᵀ + κ A D φ′ ∇∇g` of a vertex,
    /// a share for each of its particles. Pairs of particles of one cell only.
    pub fn tangent(
        &self,
        moved: &Vec3,
        at: impl Fn(u32) -> Vec3,
        mut put: impl FnMut(u32, u32, &Matrix3<f64>),
    ) {
        for vertex in self.surface.vertices() {
            let Some(change) = self.change(vertex, moved, &at) else { continue };
            let share = change * (vertex.share() * vertex.share());
            for &a in vertex.nodes() {
                for &b in vertex.nodes() {
                    put(a, b, &share);
                }
            }
        }
    }

    /// Adds the derivatives of the forces on the particles where the tool moves at a rate \[L/·\].
    pub fn rates(&self, moved: &Vec3, rate: &Vec3, at: impl Fn(u32) -> Vec3, mut add: impl FnMut(u32, Vec3)) {
        for vertex in self.surface.vertices() {
            let Some(change) = self.change(vertex, moved, &at) else { continue };
            let share = change * rate * -vertex.share();
            vertex.nodes().iter().for_each(|&a| add(a, share));
        }
    }

    /// Greatest stiffness that contact adds at a vertex of the surface while depths stay out of the barrier, `κ A` \[F/L\].
    pub fn bound(&self, vertex: &Vertex) -> f64 {
        self.stiffness * vertex.area
    }

    /// Derivative of the force on a vertex by its place, where it touches.
    fn change(&self, vertex: &Vertex, moved: &Vec3, at: impl Fn(u32) -> Vec3) -> Option<Matrix3<f64>> {
        let Gap { distance, normal, curvature } = self.tool.gap(&vertex.place(at), moved);
        let depth = 1.0 - distance / vertex.half;
        (depth > 0.0).then(|| {
            let [_, slope, second] = self.law.at(depth);
            let stiff = self.stiffness * vertex.area;
            curvature * (stiff * vertex.half * slope) - normal * normal.transpose() * (stiff * second)
        })
    }
}
