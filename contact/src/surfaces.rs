//! Surfaces that may touch each other, or one that may touch itself: what touches, energy, forces, tangent.

mod acting;
mod following;
mod reaching;
mod remembering;
mod rubbing;

use sph_core::Vec3;

use crate::edges::{Crossing, Line, crossing, of_edges};
use crate::euler::{Feature, Touched};
use crate::law::Law;
use crate::list::List;
use crate::mesh::{Mesh, Neighbours};
use crate::pair::Pair;
use crate::patches::Patches;
use rubbing::Rubbing;

/// Reach along the surface over the contact distance within which parts of one surface never touch.
const ALONG: f64 = 1.6;

/// A node of one of the bodies: the number of the body, and that of the node in it.
pub type Node = (usize, u32);

/// How two surfaces touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touching {
    /// Distance D at which faces touch, of like shells their thickness \[L\].
    pub distance: f64,
    /// The law.
    pub law: Law,
    /// Stiffness κ of a unit of area \[F/L³\].
    pub stiffness: f64,
    /// How much farther than D parts are listed \[L\]; lists are renewed when something has moved by half of it.
    pub skin: f64,
    /// Whether edges that cross between vertices push each other apart, in analyses without a tangent.
    pub edges: bool,
}

/// Two surfaces, or one with itself, that may touch.
///
/// Each vertex acts on the faces of the other surface, in two passes whose shares are inverse to the mean areas of vertices: both
/// are as stiff. Particles without faces act on the faces of the other alone, with all of the stiffness. Who uses it says where nodes are and takes
/// forces on nodes; a body is a number, zero where there is one.
#[derive(Clone, Debug)]
pub struct SurfaceContact {
    meshes: Vec<Mesh>,
    patches: Vec<Patches>,
    touching: Touching,
    passes: Vec<Pass>,
    /// Parts near each other at rest, of a surface with itself.
    near: Option<Neighbours>,
    crossings: List,
    /// Product of the lengths of edges at rest, squared, is taken from these \[L²\].
    lengths: Vec<Vec<f64>>,
    /// Stiffness of a pair of edges \[F/L\].
    of_edges: f64,
    /// Where nodes were when lists were made, body by body.
    listed: Vec<Vec<Vec3>>,
    /// Where vertices are: those that are named in lists, as they were last looked at.
    places: Vec<Vec<Vec3>>,
    /// Those, ascending.
    involved: Vec<Vec<u32>>,
    lists: u64,
    /// Greatest way of two nodes towards each other since then \[L\].
    way: f64,
    touched: Touched,
    contacts: Vec<Contact>,
    pushed: Vec<Pushed>,
    rubbing: Option<Box<Rubbing>>,
    /// Factor on bounds of stiffness: what friction adds where faces tilt \[–\].
    tilted: f64,
}

/// Vertices of one body against the faces of another, or of the same.
#[derive(Clone, Debug)]
struct Pass {
    of: usize,
    on: usize,
    /// Share σ of the stiffness \[–\].
    share: f64,
    list: List,
}

/// A vertex on a feature.
#[derive(Clone, Copy, Debug)]
struct Contact {
    pass: usize,
    vertex: u32,
    feature: Feature,
    pair: Pair,
    /// How often it counts.
    coefficient: f64,
    /// ψ′ \[F\] and ψ″ \[F/L\].
    slope: f64,
    curvature: f64,
    depth: f64,
}

/// Two edges that push, by number.
#[derive(Clone, Copy, Debug)]
struct Pushed {
    edges: [u32; 2],
    crossing: Crossing,
    /// Distance from which they push \[L\].
    within: f64,
}

/// What surfaces do to each other.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfaceTouch {
    /// Energy \[F L\].
    pub energy: f64,
    /// Greatest depth over D \[–\]; mid-surfaces meet at one.
    pub greatest_depth: f64,
    /// Area of vertices that touch, times their shares \[L²\].
    pub area: f64,
}

/// Two places that are nearest to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deepest {
    /// The node of a vertex, or one of the four about it.
    pub node: Node,
    /// Where the vertex is, and the place that it touches \[L\].
    pub places: [Vec3; 2],
    /// Depth of faces in each other over D \[–\].
    pub depth: f64,
}

impl SurfaceContact {
    /// A surface with itself, where its nodes are at rest \[L\]. Parts that lie nearer than 1.6 D along the surface, or a cell, never touch.
    pub fn itself(mesh: Mesh, rest: &[Vec3], touching: Touching) -> Self {
        let near = mesh.neighbours(rest, ALONG * touching.distance);
        let pass = Pass { of: 0, on: 0, share: 0.5, list: List::default() };
        Self::of(vec![mesh], &[rest], touching, vec![pass], Some(near))
    }

    /// Two surfaces, where the nodes of both are at rest \[L\].
    pub fn between(meshes: [Mesh; 2], rest: [&[Vec3]; 2], touching: Touching) -> Self {
        let [a, b] = [0, 1].map(|i: usize| meshes[i].mean_area());
        let pass = |of: usize, share: f64| Pass { of, on: 1 - of, share, list: List::default() };
        let passes = match [0, 1].map(|i: usize| meshes[i].is_of_points()) {
            [true, false] => vec![pass(0, 1.0)],
            [false, true] => vec![pass(1, 1.0)],
            _ => vec![pass(0, b / (a + b)), pass(1, a / (a + b))],
        };
        Self::of(meshes.into(), &rest, touching, passes, None)
    }

    fn of(
        meshes: Vec<Mesh>,
        rest: &[&[Vec3]],
        touching: Touching,
        passes: Vec<Pass>,
        near: Option<Neighbours>,
    ) -> Self {
        let areas = [0, meshes.len() - 1].map(|i| meshes[i].mean_area());
        let length = |(mesh, rest): (&Mesh, &&[Vec3])| {
            let place = |v: u32| mesh.place(v, |a| rest[a as usize]);
            let of = |&[a, b]: &[u32; 2]| (place(b) - place(a)).norm_squared();
            mesh.edges().iter().map(of).collect()
        };
        Self {
            lengths: meshes.iter().zip(rest).map(length).collect(),
            of_edges: 2.0 * touching.stiffness * areas[0] * areas[1] / (areas[0] + areas[1]),
            patches: meshes.iter().map(Patches::new).collect(),
            meshes,
            touching,
            passes,
            near,
            crossings: List::default(),
            listed: Vec::new(),
            places: Vec::new(),
            involved: Vec::new(),
            lists: 0,
            way: 0.0,
            touched: Touched::default(),
            contacts: Vec::new(),
            pushed: Vec::new(),
            rubbing: None,
            tilted: 1.0,
        }
    }

    /// How they touch.
    pub fn touching(&self) -> &Touching {
        &self.touching
    }

    /// The surfaces.
    pub fn meshes(&self) -> &[Mesh] {
        &self.meshes
    }

    /// Finds what touches where nodes are now; forces and tangent are those of this state until the next look.
    pub fn look(&mut self, at: impl Fn(Node) -> Vec3) -> SurfaceTouch {
        self.follow(&at);
        self.contacts.clear();
        self.pushed.clear();
        let mut sum = SurfaceTouch::default();
        if self.least_gap() <= self.way {
            self.put_places(&at);
            self.meet(&mut sum);
            if self.touching.edges {
                sum.energy += self.cross();
            }
        }
        if self.rubbing.is_some() {
            sum.energy += self.rub(&at);
        }
        sum
    }

    /// Finds which vertices touch what; adds to what surfaces do to each other.
    fn meet(&mut self, sum: &mut SurfaceTouch) {
        let Self { meshes, touching, passes, touched, contacts, places, way, .. } = self;
        let Touching { distance, law, stiffness, .. } = *touching;
        for (number, pass) in passes.iter().enumerate() {
            let (own, other) = (&meshes[pass.of], &meshes[pass.on]);
            let (points, places) = (&places[pass.of][..], &places[pass.on][..]);
            let place = |v: u32| places[v as usize];
            for (vertex, faces) in pass.list.after(*way) {
                let point = points[vertex as usize];
                touched.find(other, &point, distance, faces, place);
                if touched.terms.is_empty() {
                    continue;
                }
                let area = own.surface().vertices()[vertex as usize].area * pass.share;
                let stiff = stiffness * area;
                for &(feature, coefficient) in &touched.terms {
                    let pair = pair_of(other, feature, point, place);
                    let (depth, coefficient) = (1.0 - pair.distance / distance, f64::from(coefficient));
                    let [energy, slope, curvature] = law.at(depth);
                    sum.energy += coefficient * stiff * distance * distance * energy;
                    sum.greatest_depth = sum.greatest_depth.max(depth);
                    let slope = -coefficient * stiff * distance * slope;
                    let curvature = coefficient * stiff * curvature;
                    contacts.push(Contact {
                        pass: number,
                        vertex,
                        feature,
                        pair,
                        coefficient,
                        slope,
                        curvature,
                        depth,
                    });
                }
                sum.area += area;
            }
        }
    }

    /// Finds which edges push; their energy \[F L\].
    fn cross(&mut self) -> f64 {
        let Self { meshes, crossings, lengths, of_edges: stiffness, pushed, places, way, touching, .. } =
            self;
        let last = meshes.len() - 1;
        let [own, other] = [0, last].map(|body| (&meshes[body], &places[body][..]));
        let ends = |(mesh, places): (&Mesh, &[Vec3]), edge: u32| {
            mesh.edges()[edge as usize].map(|v| places[v as usize])
        };
        let mut sum = 0.0;
        for (edge, partners) in crossings.after(*way) {
            let ([a, b], rim) = (ends(own, edge), own.0.is_rim(edge as usize));
            let line = Line::through([a, b]);
            for partner in partners {
                let [c, d] = ends(other, partner);
                let within = of_edges(touching.distance, rim && other.0.is_rim(partner as usize));
                if !line.is_near([c, d], within) {
                    continue;
                }
                let rest = lengths[0][edge as usize] * lengths[last][partner as usize];
                if let Some(crossing) = crossing([a, b, c, d], within, *stiffness, rest) {
                    sum += crossing.energy;
                    pushed.push(Pushed { edges: [edge, partner], crossing, within });
                }
            }
        }
        sum
    }

    /// Bytes that it holds.
    pub fn bytes(&self) -> usize {
        let lists = self.passes.iter().map(|pass| pass.list.bytes()).sum::<usize>() + self.crossings.bytes();
        let places =
            self.listed.iter().chain(&self.places).map(|places| size_of_val(&places[..])).sum::<usize>();
        let mesh = |mesh: &Mesh| {
            size_of_val(mesh.surface().vertices()) + size_of_val(mesh.faces()) * 2 + size_of_val(mesh.edges())
        };
        lists
            + places
            + self.meshes.iter().map(mesh).sum::<usize>()
            + self.patches.iter().map(Patches::bytes).sum::<usize>()
            + self.near.as_ref().map_or(0, Neighbours::bytes)
            + self.rubbing_bytes()
    }
}

/// Vertices of a feature and how many they are.
#[inline]
fn corners_of(mesh: &Mesh, feature: Feature) -> ([u32; 3], usize) {
    match feature {
        Feature::Face(face) => (mesh.faces()[face as usize], 3),
        Feature::Edge(edge) => {
            let [a, b] = mesh.edges()[edge as usize];
            ([a, b, b], 2)
        }
        Feature::Vertex(vertex) => ([vertex; 3], 1),
    }
}

/// A point on a feature.
#[inline]
fn pair_of(mesh: &Mesh, feature: Feature, point: Vec3, at: impl Fn(u32) -> Vec3) -> Pair {
    let (corners, _) = corners_of(mesh, feature);
    let [a, b, c] = corners.map(at);
    match feature {
        Feature::Face(_) => Pair::face([point, a, b, c]),
        Feature::Edge(_) => Pair::segment([point, a, b]),
        Feature::Vertex(_) => Pair::points([point, a]),
    }
}
