//! Coulomb friction of surfaces on each other: elastic stick to an anchor in the material of the other side, slip beyond μ N, and what is lost.
//!
//! ```text
//! r = x − anchor,   s = r − d n = foot − anchor      the anchor a point of a face, the foot the nearest place at a distance d
//! U = ½ k (|r|² − d²)                                k = κ A σ, as stiff as contact is across the face
//! forces  −k s on the vertex,  k r on the anchor,  −k d n on the foot
//! k |s| > μ N:   s ← s μN/(k |s|),  anchor ← foot − s in the present face
//! lost  U_trial − U − ½ k (s_trial − s)·(s_trial − s_old)    ½ k s_old² where it parts
//! ```
//!
//! U changes under no motion that is rigid, so that what sticks keeps momentum and angular momentum to rounding although the forces of a pair act a
//! distance d apart. In a plane what is lost is `½ k (s_old + s)·(s_trial − s)`: the mean of the forces before and after, times the slip.
//! Over a fold the foot leaps, U does not: s_trial counts as no more than `√(|r|² − d²)` there.
//! A vertex between two parts of the other surface, which share no corner, has an anchor in each; N is all that a part pushes it with.

use nalgebra::Matrix3;
use sph_core::Vec3;

use super::{Contact, Node, Pass, SurfaceContact, corners_of};
use crate::euler::Feature;
use crate::grips::{Grip, Grips, along_sides, in_space};
use crate::mesh::Mesh;

/// Friction of surfaces on each other.
#[derive(Clone, Debug)]
pub(super) struct Rubbing {
    coefficient: f64,
    pub(super) grips: Grips,
    rubs: Vec<Rub>,
    /// A face at each edge and at each vertex, body by body.
    at_edge: Vec<Vec<u32>>,
    at_vertex: Vec<Vec<u32>>,
    /// Energy lost at each node until the last commit, body by body \[F L\].
    pub(super) lost: Vec<Vec<f64>>,
    /// Piece of each contact of a vertex; which of its kept grips are spoken for.
    pieces: Vec<usize>,
    taken: Vec<bool>,
}

/// A vertex that pulls at its anchor.
#[derive(Clone, Copy, Debug)]
struct Rub {
    /// The contact whose foot is that of the vertex.
    contact: usize,
    grip: Grip,
    /// k \[F/L\].
    stiffness: f64,
    /// From the anchor to the vertex, and to its foot \[L\].
    r: Vec3,
    stretch: Vec3,
    /// Where it slips: the direction, and the stretch over that of the trial \[–\].
    slip: Option<(Vec3, f64)>,
}

/// What the friction of a vertex is found from.
struct Seen<'a, At> {
    meshes: &'a [Mesh],
    passes: &'a [Pass],
    contacts: &'a [Contact],
    /// Stiffness of a unit of area.
    stiffness: f64,
    at: At,
}

impl<At: Fn(Node) -> Vec3> Seen<'_, At> {
    /// Corners of a face of the other side of a pass.
    fn corners(&self, pass: u32, face: u32) -> [Vec3; 3] {
        let on = self.passes[pass as usize].on;
        let mesh = &self.meshes[on];
        mesh.faces()[face as usize].map(|corner| mesh.place(corner, |a| (self.at)((on, a))))
    }

    /// k of a vertex.
    fn stiffness(&self, (pass, vertex): (u32, u32)) -> f64 {
        let pass = &self.passes[pass as usize];
        self.stiffness * self.meshes[pass.of].surface().vertices()[vertex as usize].area * pass.share
    }
}

impl Rubbing {
    fn new(coefficient: f64, meshes: &[Mesh]) -> Self {
        let first = |count: usize, parts: &[[u32; 3]]| {
            let mut at = vec![0; count];
            for (face, parts) in parts.iter().enumerate().rev() {
                parts.iter().for_each(|&part| at[part as usize] = face as u32);
            }
            at
        };
        let at_edge = meshes.iter().map(|mesh| first(mesh.edges().len(), mesh.sides()));
        let at_vertex = meshes.iter().map(|mesh| first(mesh.surface().vertices().len(), mesh.faces()));
        let nodes = |mesh: &Mesh| mesh.nodes().max().map_or(0, |a| a as usize + 1);
        Self {
            coefficient,
            grips: Grips::default(),
            rubs: Vec::new(),
            at_edge: at_edge.collect(),
            at_vertex: at_vertex.collect(),
            lost: meshes.iter().map(|mesh| vec![0.0; nodes(mesh)]).collect(),
            pieces: Vec::new(),
            taken: Vec::new(),
        }
    }

    /// A face to which a feature of a body belongs.
    fn face_of(&self, body: usize, feature: Feature) -> u32 {
        match feature {
            Feature::Face(face) => face,
            Feature::Edge(edge) => self.at_edge[body][edge as usize],
            Feature::Vertex(vertex) => self.at_vertex[body][vertex as usize],
        }
    }

    /// Finds what sticks and what slips; the energy that is stored \[F L\].
    fn find(&mut self, seen: &Seen<'_, impl Fn(Node) -> Vec3>) -> f64 {
        self.grips.trial.clear();
        self.rubs.clear();
        let (mut first, mut next, mut sum) = (0, 0, 0.0);
        let of = |contact: &Contact| (contact.pass as u32, contact.vertex);
        while let Some(contact) = seen.contacts.get(first) {
            let own = of(contact);
            let end = first + seen.contacts[first..].iter().take_while(|other| of(other) == own).count();
            let after = |grip: &Grip| grip.of < own;
            let begin = next + self.grips.kept[next..].iter().take_while(|grip| after(grip)).count();
            let last = begin + self.grips.kept[begin..].iter().take_while(|grip| grip.of == own).count();
            (next..begin).for_each(|number| self.part(seen, number));
            sum += self.hold(seen, own, first..end, begin..last);
            (first, next) = (end, last);
        }
        (next..self.grips.kept.len()).for_each(|number| self.part(seen, number));
        sum
    }

    /// Lets go of a kept grip.
    fn part(&mut self, seen: &Seen<'_, impl Fn(Node) -> Vec3>, number: usize) {
        let grip = self.grips.kept[number];
        let stretch = way(seen.corners(grip.of.0, grip.face), grip.stretch);
        let lost = 0.5 * seen.stiffness(grip.of) * stretch.norm_squared();
        self.grips.trial.push(Grip { lost, holds: false, ..grip });
    }

    /// The friction of a vertex on each part of the other surface that it touches.
    fn hold(
        &mut self,
        seen: &Seen<'_, impl Fn(Node) -> Vec3>,
        own: (u32, u32),
        contacts: std::ops::Range<usize>,
        kept: std::ops::Range<usize>,
    ) -> f64 {
        self.split(seen, contacts.clone());
        self.taken.clear();
        self.taken.resize(kept.len(), false);
        let mut sum = 0.0;
        for piece in 0..contacts.len() {
            if self.pieces[piece] != piece {
                continue;
            }
            let members = || contacts.clone().filter(|number| self.pieces[number - contacts.start] == piece);
            let push = |sum: Vec3, number: usize| {
                sum - seen.contacts[number].pair.normal * seen.contacts[number].slope
            };
            let pressed = members().fold(Vec3::zeros(), push).norm();
            let deeper = |&a: &usize, &b: &usize| seen.contacts[a].depth.total_cmp(&seen.contacts[b].depth);
            let main = members().filter(|&number| seen.contacts[number].coefficient > 0.0).max_by(deeper);
            if let Some(main) = main {
                sum += self.rub(seen, own, (main, pressed), kept.clone());
            }
        }
        for number in kept.clone() {
            if !self.taken[number - kept.start] {
                self.part(seen, number);
            }
        }
        sum
    }

    /// Numbers the pieces of the other surface that a vertex touches by their first contacts: those that share corners are one.
    fn split(&mut self, seen: &Seen<'_, impl Fn(Node) -> Vec3>, contacts: std::ops::Range<usize>) {
        self.pieces.clear();
        self.pieces.extend(0..contacts.len());
        let own = &seen.contacts[contacts];
        let corners =
            |contact: &Contact| corners_of(&seen.meshes[seen.passes[contact.pass].on], contact.feature);
        for i in 1..own.len() {
            let (mine, count) = corners(&own[i]);
            for j in 0..i {
                let (others, many) = corners(&own[j]);
                if mine[..count].iter().any(|corner| others[..many].contains(corner)) {
                    let [a, b] = [self.pieces[i], self.pieces[j]];
                    let (least, most) = (a.min(b), a.max(b));
                    self.pieces[..=i].iter_mut().filter(|piece| **piece == most).for_each(|p| *p = least);
                }
            }
        }
    }

    /// Lets a vertex stick to its anchor or slip from it: the grip among its kept ones on the same side that is nearest; the energy that is
    /// stored. What has none yet has its anchor where it is.
    fn rub(
        &mut self,
        seen: &Seen<'_, impl Fn(Node) -> Vec3>,
        own: (u32, u32),
        (main, pressed): (usize, f64),
        kept: std::ops::Range<usize>,
    ) -> f64 {
        let contact = &seen.contacts[main];
        let pass = &seen.passes[contact.pass];
        let (normal, distance) = (contact.pair.normal, contact.pair.distance);
        let place = seen.meshes[pass.of].place(contact.vertex, |a| (seen.at)((pass.of, a)));
        let foot = place - normal * distance;
        let mut best: Option<(usize, Vec3, f64)> = None;
        for number in kept.clone().filter(|number| !self.taken[number - kept.start]) {
            let grip = &self.grips.kept[number];
            let anchor = in_space(seen.corners(own.0, grip.face), grip.anchor);
            let away = (foot - anchor).norm_squared();
            if (place - anchor).dot(&normal) > 0.0 && best.is_none_or(|(.., least)| away < least) {
                best = Some((number, anchor, away));
            }
        }
        let face = self.face_of(pass.on, contact.feature);
        let corners = seen.corners(own.0, face);
        let at_foot = along_sides(corners, &(foot - corners[0]));
        let Some((number, anchor, _)) = best else {
            let (anchor, stretch) = (at_foot, [0.0; 2]);
            self.grips.trial.push(Grip { of: own, face, anchor, stretch, lost: 0.0, holds: true });
            return 0.0;
        };
        self.taken[number - kept.start] = true;
        let grip = self.grips.kept[number];
        let stiffness = seen.stiffness(own);
        let stretch = foot - anchor;
        let along = stretch - normal * normal.dot(&stretch);
        let (size, most) = (along.norm(), self.coefficient * pressed / stiffness);
        // |r|² − d² without the difference of two large numbers.
        let square = |s: &Vec3| s.norm_squared() + 2.0 * distance * normal.dot(s);
        if size <= most {
            let kept = along_sides(seen.corners(own.0, grip.face), &stretch);
            let grip = Grip { stretch: kept, lost: 0.0, holds: true, ..grip };
            self.grips.trial.push(grip);
            let r = place - anchor;
            self.rubs.push(Rub { contact: main, grip, stiffness, r, stretch, slip: None });
            return 0.5 * stiffness * square(&stretch);
        }
        let direction = along / size;
        let in_face = along_sides(corners, &direction);
        let long = way(corners, in_face).norm();
        let scale = if long > 0.0 { most / long } else { 0.0 };
        let left = in_face.map(|part| part * scale);
        let new = way(corners, left);
        let old = way(seen.corners(own.0, grip.face), grip.stretch);
        let trial = direction * size.min(square(&stretch).max(0.0).sqrt());
        let lost = square(&stretch) - square(&new) - (trial - new).dot(&(trial - old));
        let lost = 0.5 * stiffness * lost;
        let anchor = [at_foot[0] - left[0], at_foot[1] - left[1]];
        let grip = Grip { of: own, face, anchor, stretch: left, lost, holds: true };
        self.grips.trial.push(grip);
        let slip = Some((direction, most / size));
        let r = normal * distance + new;
        self.rubs.push(Rub { contact: main, grip, stiffness, r, stretch: new, slip });
        0.5 * stiffness * square(&new)
    }
}

/// A way along the sides of a face.
fn way(corners: [Vec3; 3], along: [f64; 2]) -> Vec3 {
    in_space(corners, along) - corners[0]
}

impl SurfaceContact {
    /// The same with Coulomb friction of a coefficient μ \[–\]; without for zero.
    pub fn with_friction(mut self, coefficient: f64) -> Self {
        if coefficient > 0.0 {
            self.rubbing = Some(Box::new(Rubbing::new(coefficient, &self.meshes)));
            let area = self.meshes.iter().map(Mesh::mean_area).fold(f64::INFINITY, f64::min);
            // What tilts a face moves the foot by the distance of the vertex over half of a cell, two vertices of which make up its area.
            self.tilted = 1.0 + 2.0 * self.touching.distance * self.touching.distance / area;
        }
        self
    }

    /// Whether there is friction, whose anchors are history.
    pub fn remembers(&self) -> bool {
        self.rubbing.is_some()
    }

    /// Coefficient of friction \[–\].
    pub fn friction(&self) -> f64 {
        self.rubbing.as_ref().map_or(0.0, |rubbing| rubbing.coefficient)
    }

    /// Finds what sticks and slips among what touches; the energy that anchors store \[F L\].
    pub(super) fn rub(&mut self, at: impl Fn(Node) -> Vec3) -> f64 {
        let Self { meshes, passes, contacts, touching, rubbing, .. } = self;
        let Some(rubbing) = rubbing else { return 0.0 };
        rubbing.find(&Seen { meshes, passes, contacts, stiffness: touching.stiffness, at })
    }

    /// Hands the forces of friction to `add`.
    pub(super) fn rubbing_forces(&self, mut add: impl FnMut(Node, Vec3)) {
        for rub in self.rubbing.iter().flat_map(|rubbing| &rubbing.rubs) {
            let Rub { stiffness, r, stretch, .. } = *rub;
            let contact = &self.contacts[rub.contact];
            let at_foot = contact.pair.normal * contact.pair.distance;
            self.each_place(contact, |place, body, nodes, share| {
                let force = match place {
                    0 => stretch * -stiffness,
                    _ => at_foot * (stiffness * contact.pair.weights[place]),
                } * share;
                nodes.iter().for_each(|&a| add((body, a), force));
            });
            let [u, v] = rub.grip.anchor;
            self.each_corner(rub.grip.of.0, rub.grip.face, |corner, node, share| {
                add(node, r * (stiffness * share * [1.0 - u - v, u, v][corner]));
            });
        }
    }

    /// Hands the derivatives of the forces of friction to `put`, without those of N and of the place of the anchor: stick
    /// `k (w w 1 − ∂²½d²)`, in slip times μN/(k |s_trial|) and less the part along the slip.
    pub(super) fn rubbing_tangent(
        &self,
        at: impl Fn(Node) -> Vec3,
        mut put: impl FnMut(Node, Node, &Matrix3<f64>),
    ) {
        for rub in self.rubbing.iter().flat_map(|rubbing| &rubbing.rubs) {
            let contact = &self.contacts[rub.contact];
            let (places, count) = self.places_of(contact, &at);
            let (pair, k) = (&contact.pair, rub.stiffness);
            let second = pair.second(&places[..count], pair.distance, 1.0);
            let [u, v] = rub.grip.anchor;
            let weights = match contact.feature {
                Feature::Face(face) if rub.slip.is_none() && face == rub.grip.face => {
                    [1.0, u + v - 1.0, -u, -v]
                }
                _ => pair.weights,
            };
            let (factor, dragged) = match rub.slip {
                Some((direction, ratio)) => (ratio * k, pair.dragged(&places[..count], &direction)),
                None => (k, [Vec3::zeros(); 4]),
            };
            self.each_pair(contact, |[a, b], node, to, share| {
                let block = Matrix3::identity() * (weights[a] * weights[b])
                    - second[a][b]
                    - dragged[a] * dragged[b].transpose();
                put(node, to, &(block * -(factor * share)));
            });
        }
    }

    /// Bytes of what friction holds.
    pub(super) fn rubbing_bytes(&self) -> usize {
        self.rubbing.as_ref().map_or(0, |rubbing| {
            let lists = rubbing.at_edge.iter().chain(&rubbing.at_vertex).map(|list| size_of_val(&list[..]));
            let lost = rubbing.lost.iter().map(|lost| size_of_val(&lost[..]));
            rubbing.grips.bytes()
                + size_of::<Rub>() * rubbing.rubs.capacity()
                + lists.chain(lost).sum::<usize>()
        })
    }
}
