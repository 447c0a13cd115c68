//! Images of nodes behind planes of symmetry: half of a body with the shape functions of the whole.
//!
//! Without them moving least squares see nothing behind a plane, and a half has other displacements near it than the whole has. The
//! image of a node has its parameters mirrored, `d′ = R d` with `R = I − 2 n nᵀ`, and no unknowns of its own: what depends on it is that of the
//! node, forces by Rᵀ and stiffness by Rᵀ from the left and R from the right.

use sph_core::{CellList, Support, Vec3};

use solid_kinematics::Tensor;

/// Part of the least radius of the support within which places coincide.
const ON_PLANE: f64 = 1e-9;
/// Sine of the angle to an axis, and part of a radius, that is rounding.
const ROUNDING: f64 = 1e-12;

/// A plane of symmetry, all of the body on one side of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// A point of it \[L\].
    pub point: Vec3,
    /// Its normal; length and sign do not matter.
    pub normal: Vec3,
}

/// Nodes behind planes: numbers from that of the nodes on.
#[derive(Clone, Debug, Default)]
pub(crate) struct Images {
    /// Number of nodes proper.
    nodes: usize,
    /// The node of each image, and what mirrors it.
    of: Vec<(u32, Tensor)>,
    /// Where images stand \[L\].
    pub places: Vec<Vec3>,
    /// Planes: normals into the body, and where they cut them \[L\].
    planes: Vec<(Vec3, f64)>,
}

impl Images {
    /// The images that a support reaches. There are none where the planes do not make one whole of the body: where it has nodes on both
    /// sides of one or two are neither parallel nor perpendicular, nor where the support is another one for the images.
    pub fn new(nodes: &[Vec3], mirrors: &[Mirror], support: &Support) -> Self {
        let none = Self { nodes: nodes.len(), ..Self::default() };
        let least = support.radii.iter().copied().fold(f64::INFINITY, f64::min);
        let slack = ON_PLANE * least;
        let mut planes: Vec<(Vec3, f64)> = Vec::new();
        for mirror in mirrors {
            let normal = mirror.normal.normalize();
            if !keeps(support, &normal) {
                return none;
            }
            let at = normal.dot(&mirror.point);
            let away = |x: &Vec3| normal.dot(x) - at;
            let (low, high) =
                nodes.iter().map(away).fold((0.0_f64, 0.0_f64), |(l, h), d| (l.min(d), h.max(d)));
            if low < -slack && high > slack {
                return none;
            }
            let plane = if low < -slack { (-normal, -at) } else { (normal, at) };
            let oblique = |(other, _): &(Vec3, f64)| {
                let cosine = plane.0.dot(other).abs();
                cosine > ROUNDING && cosine < 1.0 - ROUNDING
            };
            if planes.iter().any(oblique) {
                return none;
            }
            let known =
                |&(n, a): &(Vec3, f64)| (n - plane.0).norm() <= ROUNDING && (a - plane.1).abs() <= slack;
            if !planes.iter().any(known) {
                planes.push(plane);
            }
        }
        let mut out = none.clone();
        let mut places: Vec<Vec3> = nodes.to_vec();
        let mut fresh = 0..nodes.len();
        while !fresh.is_empty() {
            let begin = places.len();
            for (normal, at) in &planes {
                let reach: f64 = (0..3).map(|k| support.radii[k] * normal[k].abs()).sum();
                let known = CellList::new(&places, least);
                let mut near = Vec::new();
                for number in fresh.clone() {
                    let x = places[number];
                    let away = normal.dot(&x) - at;
                    if away <= slack || away >= reach {
                        continue;
                    }
                    let image = x - normal * (2.0 * away);
                    known.within(&image, slack, &mut near);
                    if !near.is_empty() {
                        continue;
                    }
                    let turn = Tensor::identity() - normal * normal.transpose() * 2.0;
                    let (node, before) = out.real(number as u32);
                    out.of.push((node, turn * before));
                    places.push(image);
                }
            }
            fresh = begin..places.len();
        }
        out.places = places.split_off(nodes.len());
        out.planes = planes;
        out
    }

    /// The node of a number, and what mirrors its parameters.
    pub fn real(&self, number: u32) -> (u32, Tensor) {
        match (number as usize).checked_sub(self.nodes) {
            None => (number, Tensor::identity()),
            Some(image) => self.of[image],
        }
    }

    /// Whether a number is that of an image.
    pub fn is_image(&self, number: u32) -> bool {
        number as usize >= self.nodes
    }

    /// Parameters of a node or an image \[L\].
    pub fn parameter(&self, parameters: &[f64], number: u32) -> Vec3 {
        let of = |node: u32| Vec3::from_column_slice(&parameters[3 * node as usize..][..3]);
        match (number as usize).checked_sub(self.nodes) {
            None => of(number),
            Some(image) => self.of[image].1 * of(self.of[image].0),
        }
    }

    /// Adds a force on a node or an image to those on nodes.
    pub fn add(&self, out: &mut [f64], number: u32, force: &Vec3) {
        let (node, force) = self.direction(number, force);
        (0..3).for_each(|k| out[3 * node as usize + k] += force[k]);
    }

    /// The node of a number, and the direction on it that is `direction` there.
    pub fn direction(&self, number: u32, direction: &Vec3) -> (u32, Vec3) {
        match (number as usize).checked_sub(self.nodes) {
            None => (number, *direction),
            Some(image) => (self.of[image].0, self.of[image].1.transpose() * direction),
        }
    }

    /// The normal, into the body, of the plane in which a node is held along a direction, if it is one with images behind.
    pub fn plane(&self, place: &Vec3, direction: &Vec3, slack: f64) -> Option<Vec3> {
        let holds = |(normal, at): &&(Vec3, f64)| {
            (normal.dot(place) - at).abs() <= slack && 1.0 - normal.dot(direction).abs() <= ROUNDING
        };
        self.planes.iter().find(holds).map(|plane| plane.0)
    }

    /// Images that turn the normal of the plane before them: their numbers, that normal, and the foot on the plane.
    pub fn behind(&self) -> Vec<(u32, Vec3, Vec3)> {
        let mut out = Vec::new();
        for (image, ((_, turn), x)) in self.of.iter().zip(&self.places).enumerate() {
            for (normal, at) in &self.planes {
                let away = normal.dot(x) - at;
                if away < 0.0 && normal.dot(&(turn * normal)) < 0.0 {
                    out.push(((self.nodes + image) as u32, *normal, x - normal * away));
                }
            }
        }
        out
    }

    /// Nodes of rising numbers, each once and rising.
    pub fn reals(&self, numbers: &[u32]) -> Vec<u32> {
        let mut out: Vec<u32> = numbers.iter().map(|&number| self.real(number).0).collect();
        out.sort_unstable();
        out.dedup();
        out
    }
}

/// Whether a support is its own mirror image.
fn keeps(support: &Support, normal: &Vec3) -> bool {
    let [a, b, c] = support.radii;
    let round = !support.tensor && (a - b).abs().max((b - c).abs()) <= ROUNDING * a;
    round || normal.iter().filter(|n| n.abs() > ROUNDING).count() == 1
}
