//! A surface on a tool: energy, forces, tangent, and what is measured of them.

use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::friction::{Friction, OnFace};
use crate::law::Law;
use crate::pose::{Pose, ToolFrame};
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
    pub const NONE: Self =
        Self { energy: 0.0, force: Vec3::new(0.0, 0.0, 0.0), greatest_depth: 0.0, area: 0.0 };
}

impl ToolContact {
    /// Adds the forces on the particles, with the tool in a pose; the watch passes over what is far.
    ///
    /// `U = Σ κ A D² φ(s)` with `D = t/2` and `s = (D − g)/D`: the force on a vertex is `κ A D φ′ ∇g`, and friction adds its own along the
    /// face.
    pub fn forces(
        &self,
        watch: &mut Watch,
        friction: Option<&mut Friction>,
        pose: &Pose,
        at: impl Fn(u32) -> Vec3,
        mut add: impl FnMut(u32, Vec3),
    ) -> Touch {
        let (mut touch, frame) = (Touch::NONE, ToolFrame::new(&self.tool, pose));
        let mut sticking = friction.map(Friction::begin);
        let sticks = |number: u32| self.stiffness * self.surface.vertices()[number as usize].area;
        watch.each_near((&self.tool, &self.surface), &pose.moved, &at, |number, vertex| {
            let place = vertex.place(&at);
            let Face { distance, normal } = self.tool.face(&place, &pose.moved);
            let depth = 1.0 - distance / vertex.half;
            if depth <= 0.0 {
                return;
            }
            let [energy, slope, _] = self.law.at(depth);
            let stiff = self.stiffness * vertex.area * vertex.half;
            let mut force = normal * (stiff * slope);
            touch.energy += stiff * vertex.half * energy;
            touch.greatest_depth = touch.greatest_depth.max(depth);
            touch.area += vertex.area;
            if let Some(sticking) = &mut sticking {
                let (stiffness, pressed) = (sticks(number), stiff * slope);
                let on = OnFace { vertex: number, place, normal, stiffness, pressed };
                force += sticking.hold(&frame, &on, sticks);
            }
            touch.force += force;
            let share = force * vertex.share();
            vertex.nodes().iter().for_each(|&a| add(a, share));
        });
        if let Some(sticking) = &mut sticking {
            sticking.part(None, sticks);
        }
        touch
    }

    /// Hands every vertex that touches, by number and with its depth over the distance at which faces touch, to `visit`.
    pub fn each_touching(&self, moved: &Vec3, at: impl Fn(u32) -> Vec3, mut visit: impl FnMut(u32, f64)) {
        for (number, vertex) in (0..).zip(self.surface.vertices()) {
            let depth = 1.0 - self.tool.face(&vertex.place(&at), moved).distance / vertex.half;
            if depth > 0.0 {
                visit(number, depth);
            }
        }
    }

    /// Least gap between the faces of surface and tool \[L\], negative where they are in each other.
    pub fn least_gap(&self, moved: &Vec3, at: impl Fn(u32) -> Vec3) -> f64 {
        let gap = |vertex: &Vertex| self.tool.face(&vertex.place(&at), moved).distance - vertex.half;
        self.surface.vertices().iter().map(gap).fold(f64::INFINITY, f64::min)
    }

    /// Gap between the faces of surface and tool at a particle \[L\], negative where they are in each other; none of a particle without area.
    pub fn gap_at(&self, particle: u32, moved: &Vec3, place: &Vec3) -> Option<f64> {
        let vertex = self.surface.of_particle(particle)?;
        Some(self.tool.face(place, moved).distance - vertex.half)
    }

    /// Hands the derivatives of the force on a particle by the place of another to `put`: `−κ A φ″ ∇g∇gᵀ + κ A D φ′ ∇∇g` of a vertex,
    /// and what friction adds along the face, a share for each of its particles. Pairs of particles of one cell only.
    pub fn tangent(
        &self,
        friction: Option<&Friction>,
        pose: &Pose,
        at: impl Fn(u32) -> Vec3,
        mut put: impl FnMut(u32, u32, &Matrix3<f64>),
    ) {
        self.changes(friction, pose, at, |vertex, [across, along], _| {
            let share = (across + along) * (vertex.share() * vertex.share());
            for &a in vertex.nodes() {
                for &b in vertex.nodes() {
                    put(a, b, &share);
                }
            }
        });
    }

    /// Adds the derivatives of the forces on the particles where the tool moves and turns at a rate \[L/·, rad/·\].
    pub fn rates(
        &self,
        friction: Option<&Friction>,
        pose: &Pose,
        rate: &Pose,
        at: impl Fn(u32) -> Vec3,
        mut add: impl FnMut(u32, Vec3),
    ) {
        let frame = ToolFrame::new(&self.tool, pose);
        self.changes(friction, pose, at, |vertex, [across, along], anchor| {
            let with_tool = rate.moved + frame.turning(anchor) * rate.angle;
            let share = (across * rate.moved + along * with_tool) * -vertex.share();
            vertex.nodes().iter().for_each(|&a| add(a, share));
        });
    }

    /// Greatest stiffness that contact adds at a vertex of the surface while depths stay out of the barrier, `κ A` \[F/L\].
    pub fn bound(&self, vertex: &Vertex) -> f64 {
        self.stiffness * vertex.area
    }

    /// Derivatives of the force on each vertex that touches by its place, of what contact and of what friction exerts, and the anchor of that.
    fn changes(
        &self,
        friction: Option<&Friction>,
        pose: &Pose,
        at: impl Fn(u32) -> Vec3,
        mut visit: impl FnMut(&Vertex, [Matrix3<f64>; 2], &Vec3),
    ) {
        let frame = ToolFrame::new(&self.tool, pose);
        for (number, vertex) in (0..).zip(self.surface.vertices()) {
            let place = vertex.place(&at);
            let Gap { distance, normal, curvature } = self.tool.gap(&place, &pose.moved);
            let depth = 1.0 - distance / vertex.half;
            if depth <= 0.0 {
                continue;
            }
            let [_, slope, second] = self.law.at(depth);
            let stiff = self.stiffness * vertex.area;
            let pressed = stiff * vertex.half * slope;
            let across = curvature * pressed - normal * normal.transpose() * (stiff * second);
            let on = OnFace { vertex: number, place, normal, stiffness: stiff, pressed };
            let (along, anchor) =
                friction.and_then(|friction| friction.stiffness(&frame, &on)).unwrap_or_default();
            visit(vertex, [across, along], &anchor);
        }
    }
}
