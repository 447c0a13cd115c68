//! A closed surface filled with nodes of a cubic lattice; the surface cuts their volumes.
//!
//! A cell of the lattice has the volume and the first moments of what of it lies inside, found from the surface alone (clip.rs). It becomes a
//! node at the centroid of that, or is shared out to nodes beside it where there is little (shared.rs). So volume, centroid and area of the
//! body are those of the surface, to rounding.

mod carried;
mod cells;
mod clip;
mod closed;
mod crossing;
mod features;
mod nearest;
mod shared;
mod snapped;
mod spread;

use std::collections::BTreeMap;

pub use carried::Carried;
pub use cells::FilledCells;
pub use closed::{ClosedSurface, SurfaceFault};
pub use spread::{Spread, spread};

use self::clip::{Cut, Piece, cut};
use self::shared::{Shared, share_out};
use super::{Block, BlockLattice, NodePlaces};
use crate::Vec3;

/// Distance from a plane of the box round a surface, in spacings, within which a vertex lies in it.
const IN_PLANE: f64 = 1e-6;
/// Part of a cell beyond a whole number of them that is rounding.
const WHOLE: f64 = 1e-9;
/// Most cells of a lattice: ten million take half a gigabyte while they are cut.
const MOST_CELLS: f64 = 1e7;

/// A part of the surface with the node that bears it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// The node.
    pub node: u32,
    /// The triangle that it is a part of.
    pub triangle: u32,
    /// Outward normal times area \[L²\].
    pub area: Vec3,
    /// Its centroid \[L\].
    pub place: Vec3,
}

/// The nodes inside a surface.
#[derive(Clone, Debug)]
pub struct Filled {
    /// The nodes. Faces are what of the surface lies in the planes of the box round it.
    pub block: Block,
    /// The box round the surface, with the spacing of the nodes.
    pub bounds: BlockLattice,
    /// The surface as nodes bear it, in the order of triangles.
    pub facets: Vec<Facet>,
    /// Which triangles lie in each plane of the box: x0, x1, y0, y1, z0, z1.
    pub flat: [Vec<bool>; 6],
    /// Part of the volume that lies in fins and tips thinner than half a spacing and is borne by nodes farther off than the cell beside,
    /// with a place of it.
    pub away: Option<(f64, Vec3)>,
}

/// A lattice round a surface.
struct Laid {
    counts: [usize; 3],
    bounds: BlockLattice,
    /// Which triangles lie in each plane of the box.
    flat: [Vec<bool>; 6],
    /// Its corner of least coordinates \[L\].
    origin: Vec3,
}

impl Laid {
    /// Where a side of the box is \[L\].
    fn plane(&self, side: usize) -> f64 {
        let axis = side / 2;
        self.bounds.origin[axis] + if side % 2 == 1 { self.bounds.lengths[axis] } else { 0.0 }
    }

    /// Whether the outermost corners of the lattice lie in a side of the box.
    fn in_lattice(&self, side: usize, spacing: f64) -> bool {
        let axis = side / 2;
        let end = if side % 2 == 1 { self.counts[axis] } else { 0 };
        let lattice = self.origin[axis] + end as f64 * spacing;
        (lattice - self.plane(side)).abs() <= IN_PLANE * spacing
    }
}

impl ClosedSurface {
    /// The box round it, as a lattice of this spacing.
    pub fn bounds(&self, spacing: f64) -> BlockLattice {
        let [low, high] = self.corners();
        BlockLattice {
            dimensions: 3,
            lengths: (high - low).into(),
            spacing: [spacing; 3],
            origin: low,
            nodes: NodePlaces::Centres,
            grading: [1.0; 3],
            disorder: 0.0,
            seed: 0,
        }
    }

    /// Cells along each axis of the lattice of this spacing that holds it.
    ///
    /// # Errors
    /// [`SurfaceFault::Cells`] for a spacing that is not positive, and for more cells than ten million.
    pub fn cells(&self, spacing: f64) -> Result<[usize; 3], SurfaceFault> {
        let [low, high] = self.corners();
        let counts = (high - low).map(|length| (length / spacing - WHOLE).ceil().max(1.0));
        let cells = counts.product();
        if spacing > 0.0 && cells <= MOST_CELLS {
            Ok([0, 1, 2].map(|axis| counts[axis] as usize))
        } else {
            Err(SurfaceFault::Cells { cells })
        }
    }

    /// Nodes about `spacing` apart \[L\] in it.
    ///
    /// The lattice begins where the surface is flat at one end of the box round it, else its middle is that of the box: so it turns and
    /// mirrors with the body, and a half has the lattice of the half.
    ///
    /// # Errors
    /// [`SurfaceFault::Cells`]; [`SurfaceFault::Overlap`] for a surface that encloses some part twice, [`SurfaceFault::Thin`] for one that
    /// is too thin there for a node.
    pub fn filled(&self, spacing: f64) -> Result<Filled, SurfaceFault> {
        let Laid { counts, bounds, flat, origin } = self.laid(spacing)?;
        let cut = self.cut(&origin, spacing, counts);
        let place = |cells: [f64; 3]| origin + Vec3::from(cells) * spacing;
        let Shared { nodes, borne, away } = share_out(&cut).map_err(|fault| fault.at(place))?;
        let square = spacing * spacing;
        let normals = self.normals();
        let facet = |(node, number, part): (u32, usize, f64)| {
            let Piece { triangle, area, centroid, .. } = cut.pieces[number];
            Facet {
                node,
                triangle,
                area: normals[triangle as usize] * (part * area * square),
                place: place(centroid),
            }
        };
        let facets: Vec<Facet> = borne.into_iter().map(facet).collect();
        let block = Block {
            dimensions: 3,
            positions: nodes.iter().map(|node| place(node.place)).collect(),
            volumes: nodes.iter().map(|node| node.volume * square * spacing).collect(),
            spacing: [spacing; 3],
            cells: Vec::new(),
            faces: faces(&flat, &facets),
        };
        let away = away.map(|(cells, at)| (cells * square * spacing / self.volume().0, place(at)));
        Ok(Filled { block, bounds, facets, flat, away })
    }

    /// The lattice of this spacing that holds it.
    fn laid(&self, spacing: f64) -> Result<Laid, SurfaceFault> {
        let counts = self.cells(spacing)?;
        let bounds = self.bounds(spacing);
        let flat: [Vec<bool>; 6] = std::array::from_fn(|face| self.flat(&bounds, face));
        // What the lattice is longer than the body lies beyond its curved ends.
        let beyond = |axis: usize| {
            let [low, high] = [0, 1].map(|upper| flat[2 * axis + upper].contains(&true));
            let part = match (low, high) {
                (true, false) => 0.0,
                (false, true) => 1.0,
                _ => 0.5,
            };
            part * (spacing * counts[axis] as f64 - bounds.lengths[axis])
        };
        let origin = bounds.origin - Vec3::from([0, 1, 2].map(beyond));
        Ok(Laid { counts, bounds, flat, origin })
    }

    /// What it cuts out of the cells of a lattice.
    fn cut(&self, origin: &Vec3, spacing: f64, counts: [usize; 3]) -> Cut {
        let [i, j, k] = self.around(origin, spacing);
        let triangles = self.triangles.iter().map(|corners| {
            corners.map(|corner| {
                let x = self.vertices[corner as usize];
                [i(x.x), j(x.y), k(x.z)]
            })
        });
        cut(counts, triangles)
    }

    /// Outward unit normals of the triangles.
    fn normals(&self) -> Vec<Vec3> {
        self.triangles.iter().map(|corners| self.area(corners).normalize()).collect()
    }

    /// Coordinates in cells of a lattice.
    fn around(&self, origin: &Vec3, spacing: f64) -> [impl Fn(f64) -> f64 + use<>; 3] {
        [0, 1, 2].map(|axis| {
            let origin = origin[axis];
            move |x: f64| (x - origin) / spacing
        })
    }

    /// Which triangles lie in a plane of the box round it.
    fn flat(&self, bounds: &BlockLattice, face: usize) -> Vec<bool> {
        let (axis, upper) = (face / 2, (face % 2) as f64);
        let plane = bounds.origin[axis] + upper * bounds.lengths[axis];
        let near = IN_PLANE * bounds.spacing[axis];
        let lies = |corner: &u32| (self.vertices[*corner as usize][axis] - plane).abs() <= near;
        self.triangles.iter().map(|corners| corners.iter().all(lies)).collect()
    }
}

/// What of the surface lies in each plane of the box round it, by nodes.
fn faces(flat: &[Vec<bool>; 6], facets: &[Facet]) -> [Vec<(u32, f64)>; 6] {
    flat.each_ref().map(|flat| {
        let of_face = by_node(facets.iter().filter(|facet| flat[facet.triangle as usize]));
        of_face.into_iter().map(|(node, area, _)| (node, area)).collect()
    })
}

/// Area of facets and outward normal times area by nodes, ascending \[L²\].
pub fn by_node<'a>(facets: impl Iterator<Item = &'a Facet>) -> Vec<(u32, f64, Vec3)> {
    let mut all = BTreeMap::<u32, (f64, Vec3)>::new();
    for facet in facets {
        let (area, vector) = all.entry(facet.node).or_default();
        *area += facet.area.norm();
        *vector += facet.area;
    }
    all.into_iter().map(|(node, (area, vector))| (node, area, vector)).collect()
}
