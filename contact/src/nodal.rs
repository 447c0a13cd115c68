//! What nodes feel of contact, to be read: depth, area, normal force, friction, grip; and gaps.

use sph_core::{CellList, Vec3};

use crate::friction::Friction;
use crate::nearest::on_triangle;
use crate::pose::{Pose, ToolFrame};
use crate::surfaces::{Node, SurfaceContact};
use crate::tool::Face;
use crate::touch::ToolContact;

/// Contact distances D up to which gaps of surfaces are looked for.
const REACH: f64 = 10.0;
/// The same of a surface with itself: beyond, parts that lie along the surface are as near.
const REACH_ITSELF: f64 = 0.5;
/// Part of the most that friction bears at which it counts as slipping.
const SLIPS: f64 = 1.0 - 1e-9;

/// Whether a node that touches is held by friction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Grip {
    /// It touches nothing.
    #[default]
    Apart,
    /// All of what touches at it sticks.
    Sticks,
    /// Some of it slips, or is smooth.
    Slips,
}

/// What a node feels of contact: its own vertex, and its share of the middles of quadrilaterals about it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NodalContact {
    /// Greatest depth of any of them over the distance at which faces touch \[–\], zero where none touches.
    pub depth: f64,
    /// Area of those that touch \[L²\].
    pub area: f64,
    /// Area of all of them \[L²\].
    pub of: f64,
    /// Normal forces on the node, their sizes summed over all that it touches \[F\].
    pub pressed: f64,
    /// Force of friction on the node \[F\].
    pub rubbed: Vec3,
    /// Whether friction holds it.
    pub grip: Grip,
}

impl NodalContact {
    /// Takes in what the node feels of another contact.
    pub fn join(&mut self, other: &Self) {
        self.depth = self.depth.max(other.depth);
        self.area += other.area;
        self.of = self.of.max(other.of);
        self.pressed += other.pressed;
        self.rubbed += other.rubbed;
        self.grip = self.grip.max(other.grip);
    }

    /// A share of it, of a node that several carry.
    pub fn share(&self, share: f64) -> Self {
        let [area, of, pressed] = [self.area, self.of, self.pressed].map(|whole| share * whole);
        Self { area, of, pressed, rubbed: self.rubbed * share, ..*self }
    }

    /// Normal forces over the area \[F/L²\], those of both faces summed; zero where there is no area.
    pub fn pressure(&self) -> f64 {
        if self.of > 0.0 { self.pressed / self.of } else { 0.0 }
    }

    /// Friction over the area \[F/L²\].
    pub fn shear(&self) -> Vec3 {
        if self.of > 0.0 { self.rubbed / self.of } else { Vec3::zeros() }
    }
}

impl ToolContact {
    /// What each particle feels of the tool in a pose; friction as it was last evaluated.
    pub fn nodal_contact(
        &self,
        friction: Option<&Friction>,
        pose: &Pose,
        at: impl Fn(u32) -> Vec3,
        nodal: &mut [NodalContact],
    ) {
        let frame = ToolFrame::new(&self.tool, pose);
        for (number, vertex) in (0..).zip(self.surface.vertices()) {
            let Face { distance, .. } = self.tool.face(&vertex.place(&at), &pose.moved);
            let depth = 1.0 - distance / vertex.half;
            let mut own = NodalContact { of: vertex.area * vertex.share(), ..NodalContact::default() };
            if depth > 0.0 {
                let [_, slope, _] = self.law.at(depth);
                let stiff = self.stiffness * vertex.area;
                let pressed = stiff * vertex.half * slope;
                let (stretch, most) = friction.and_then(|own| own.held(number)).unwrap_or_default();
                let rubbed = frame.turned(&stretch) * -stiff;
                let slips = rubbed.norm() >= SLIPS * most * pressed;
                let grip = if slips { Grip::Slips } else { Grip::Sticks };
                let (pressed, rubbed) = (pressed * vertex.share(), rubbed * vertex.share());
                own = NodalContact { depth, area: own.of, pressed, rubbed, grip, ..own };
            }
            for &a in vertex.nodes() {
                let sum = &mut nodal[a as usize];
                let of = sum.of + own.of;
                sum.join(&own);
                sum.of = of;
            }
        }
    }

    /// The vertex that is deepest in the tool in a pose: its depth over half of the thickness \[–\], and where it is.
    pub fn deepest(&self, pose: &Pose, at: impl Fn(u32) -> Vec3) -> Option<(f64, Vec3)> {
        let depth = |vertex: &crate::Vertex| {
            let place = vertex.place(&at);
            (1.0 - self.tool.face(&place, &pose.moved).distance / vertex.half, place)
        };
        self.surface.vertices().iter().map(depth).max_by(|a, b| a.0.total_cmp(&b.0))
    }
}

impl SurfaceContact {
    /// What each node of a body feels, for the state last looked at.
    pub fn nodal_contact(&self, body: usize, nodal: &mut [NodalContact]) {
        for vertex in self.meshes()[body].surface().vertices() {
            vertex.nodes().iter().for_each(|&a| nodal[a as usize].of += vertex.area * vertex.share());
        }
        let mut last = None;
        for number in 0..self.touched() {
            let (of, vertex, depth) = self.vertex_of(number);
            if of == body {
                let own = &self.meshes()[body].surface().vertices()[vertex as usize];
                let area = if last == Some(vertex) { 0.0 } else { own.area * own.share() };
                last = Some(vertex);
                for &a in own.nodes() {
                    let sum = &mut nodal[a as usize];
                    (sum.depth, sum.area, sum.grip) = (sum.depth.max(depth), sum.area + area, Grip::Slips);
                }
            }
            self.each_push(number, |(of, a), force| {
                if of == body {
                    nodal[a as usize].pressed += force;
                }
            });
        }
        // Coefficients of features that cancel leave rounding.
        nodal.iter_mut().for_each(|own| own.pressed = own.pressed.max(0.0));
    }

    /// Gap between the faces of the surfaces at some nodes of a body \[L\], negative where they are in each other: at most ten times the
    /// distance at which faces touch, of a surface with itself half of it, beyond which nothing is looked for.
    pub fn gaps(&self, body: usize, nodes: &[u32], at: impl Fn(Node) -> Vec3) -> Vec<f64> {
        let last = self.meshes().len() - 1;
        let (other, distance) = (last - body.min(last), self.touching().distance);
        let mesh = &self.meshes()[other];
        let places: Vec<Vec3> =
            (0..mesh.surface().vertices().len() as u32).map(|v| mesh.place(v, |a| at((other, a)))).collect();
        let corners = |face: &[u32; 3]| face.map(|corner| places[corner as usize]);
        let middles: Vec<Vec3> =
            mesh.faces().iter().map(|face| corners(face).iter().sum::<Vec3>() / 3.0).collect();
        let size = |(face, middle): (&[u32; 3], &Vec3)| {
            corners(face).iter().fold(0.0_f64, |most, corner| most.max((corner - middle).norm_squared()))
        };
        let largest = mesh.faces().iter().zip(&middles).map(size).fold(0.0, f64::max).sqrt();
        let reach = (1.0 + if self.is_with_itself() { REACH_ITSELF } else { REACH }) * distance;
        let boxes = CellList::new(&middles, reach + largest);
        let mut near = Vec::new();
        let gap = |&a: &u32| {
            let point = at((body, a));
            boxes.within(&point, reach + largest, &mut near);
            let mut least = reach * reach;
            for face in near.iter().map(|&face| &mesh.faces()[face as usize]) {
                if self.may_touch((body, a), face) {
                    least = least.min(on_triangle(&point, corners(face)).1);
                }
            }
            least.sqrt() - distance
        };
        nodes.iter().map(gap).collect()
    }
}
