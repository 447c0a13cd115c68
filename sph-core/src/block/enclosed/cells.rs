//! A closed surface as nodes for shape functions, and the cells over which integrals are taken, cut by the surface.
//!
//! Nodes stand at the corners of the cells of a cubic lattice that are half full at least, the outermost on the surface (snapped.rs). Integrals
//! do not see where they stand: a whole cell has Gauss's points, n³ of them. One that the surface cuts is divided into as many parts, each with
//! the volume and the centroid of what of it lies inside (clip.rs): weights are not negative, and fields of the first degree
//! are integrated exactly, others to the square of a part. Of the surface each part has the piece in it, with its area at its centroid;
//! where the surface is a whole face of a cell it has Gauss's points too, so that a box in planes of the lattice is the block.

use std::collections::BTreeMap;

use super::clip::{Cut, Piece};
use super::shared::{BESIDE, Misfit, NODE, ROUNDING, TWICE, centre, nearest, steps};
use super::snapped::{Snapped, snap};
use super::{ClosedSurface, Facet, Laid, MOST_CELLS, SurfaceFault};
use crate::Vec3;
use crate::block::hexahedra::{FacePoint, Hexahedra, VolumePoint};
use crate::block::{Block, BlockLattice};
use crate::neighbours::CellList;
use crate::surface::cell::Cell;

/// Part of a face of a cell that is missing from a whole one by rounding.
const WHOLE: f64 = 1e-9;
/// Depth under a piece at which it is looked which part of a cell it is in, in parts.
const UNDER: f64 = 1e-6;
/// Difference of unit normals of triangles in one plane.
const ALIKE: f64 = 1e-7;
/// Most points of a rule along an edge.
const MOST_POINTS: usize = 4;

/// Nodes in a surface, and the cells over which integrals are taken.
#[derive(Clone, Debug)]
pub struct FilledCells {
    /// The nodes, with their shares of the volume; faces and cells of a plane are empty.
    pub block: Block,
    /// The box round the surface, with the spacing of the nodes.
    pub bounds: BlockLattice,
    /// Corners of each cell as nodes, some of them alike; those of a cell less than half full are all the node nearest to it.
    pub cells: Vec<[u32; 8]>,
    /// Cells that are half full at least, the first of all.
    pub half_full: usize,
    /// Points of each cell, as many of each; those outside have no volume.
    pub points: Vec<Vec<VolumePoint>>,
    /// Outer faces of the cells that are half full, between nodes on the surface.
    pub outer: Vec<Cell>,
    /// The surface in pieces, each with the node nearest to it, in the order of triangles.
    pub facets: Vec<Facet>,
    /// Nodes with each triangle that they lie on, ascending.
    pub touching: Vec<(u32, u32)>,
    /// Which triangles lie in each plane of the box: x0, x1, y0, y1, z0, z1.
    pub flat: [Vec<bool>; 6],
    /// Part of the volume that lies in fins and tips thinner than half a spacing and is farther from nodes than the cell beside, with a place of it.
    pub away: Option<(f64, Vec3)>,
    /// The corner of least coordinates of the lattice \[L\].
    origin: Vec3,
    /// Gauss points along an edge.
    rule: usize,
}

impl ClosedSurface {
    /// Nodes about `spacing` apart \[L\] in it and on it, and cells with `rule`³ points, 1 to 4 along an edge. The lattice is that of
    /// [`ClosedSurface::filled`].
    ///
    /// # Errors
    /// As [`ClosedSurface::filled`]; the parts of cells count as cells.
    pub fn filled_cells(&self, spacing: f64, rule: usize) -> Result<FilledCells, SurfaceFault> {
        let rule = rule.clamp(1, MOST_POINTS);
        let laid = self.laid(spacing)?;
        let parts = laid.counts.map(|count| count * rule);
        let cells = parts.iter().map(|&count| count as f64).product();
        if cells > MOST_CELLS {
            return Err(SurfaceFault::Cells { cells });
        }
        let fine = self.cut(&laid.origin, spacing / rule as f64, parts);
        let place = |cells: [f64; 3]| laid.origin + Vec3::from(cells) * spacing;
        let twice = |part: &usize| !(-TWICE..=1.0 + TWICE).contains(&fine.inside[*part][0]);
        if let Some(part) = (0..fine.inside.len()).find(twice) {
            return Err(Misfit::Overlap(centre(&fine, part).map(|x| x / rule as f64)).at(place));
        }
        let cut = gathered(&fine, laid.counts, rule);
        let is_node: Vec<bool> = cut.inside.iter().map(|inside| inside[0] >= NODE).collect();
        let snapped = snap(self, (&laid, spacing), &cut, (&is_node, &triangles(&fine, &cut, rule)));
        let built = Built { laid: &laid, spacing, rule, fine: &fine, cut: &cut, is_node: &is_node };
        let (cells, half_full, volumes, away) = built.cells(&snapped).map_err(|fault| fault.at(place))?;
        let points = built.points();
        let outer = built.outer(&snapped);
        let block = Block {
            dimensions: 3,
            positions: snapped.places,
            volumes,
            spacing: [spacing; 3],
            cells: Vec::new(),
            faces: Default::default(),
        };
        let facets = self.facets(&fine, (&laid.origin, spacing / rule as f64), &block);
        let away = away.map(|(cells, at)| (cells * spacing.powi(3) / self.volume().0, place(at)));
        let (bounds, flat, touching, origin) = (laid.bounds, laid.flat, snapped.touching, laid.origin);
        Ok(FilledCells {
            block,
            bounds,
            cells,
            half_full,
            points,
            outer,
            facets,
            touching,
            flat,
            away,
            origin,
            rule,
        })
    }

    /// Pieces of the surface, each with the node nearest to it.
    fn facets(&self, fine: &Cut, (origin, spacing): (&Vec3, f64), block: &Block) -> Vec<Facet> {
        let near = CellList::new(&block.positions, block.spacing[0]);
        let normals = self.normals();
        let facet = |piece: &Piece| {
            let place = origin + Vec3::from(piece.centroid) * spacing;
            let node = near.nearest_particle(&place).unwrap_or_default();
            let area = normals[piece.triangle as usize] * (piece.area * spacing * spacing);
            Facet { node, triangle: piece.triangle, area, place }
        };
        fine.pieces.iter().map(facet).collect()
    }
}

/// Whole cells of their parts; the pieces of the surface stay with those.
fn gathered(fine: &Cut, counts: [usize; 3], rule: usize) -> Cut {
    let mut out = Cut { counts, inside: vec![[0.0; 4]; counts.iter().product()], pieces: Vec::new() };
    let (size, volume) = (1.0 / rule as f64, 1.0 / rule.pow(3) as f64);
    for (part, own) in fine.inside.iter().enumerate() {
        let at = fine.place(part);
        let cell = out.number(at.map(|n| n / rule));
        let inside = &mut out.inside[cell];
        inside[0] += own[0] * volume;
        for axis in 0..3 {
            let middle = ((at[axis] % rule) as f64 + 0.5) * size - 0.5;
            inside[1 + axis] += volume * (size * own[1 + axis] + own[0] * middle);
        }
    }
    out
}

/// Triangles in each cell, ascending.
fn triangles(fine: &Cut, cut: &Cut, rule: usize) -> Vec<Vec<u32>> {
    let mut out = vec![Vec::new(); cut.inside.len()];
    for piece in &fine.pieces {
        let own = &mut out[cut.number(fine.place(piece.cell).map(|n| n / rule))];
        if own.last() != Some(&piece.triangle) {
            own.push(piece.triangle);
        }
    }
    out
}

/// What of a lattice lies inside.
struct Built<'a> {
    laid: &'a Laid,
    spacing: f64,
    rule: usize,
    fine: &'a Cut,
    cut: &'a Cut,
    is_node: &'a [bool],
}

/// Corners of the cells, how many are half full, volumes of the nodes, what is far away from them \[cells\] and where.
type Cells = (Vec<[u32; 8]>, usize, Vec<f64>, Option<(f64, [f64; 3])>);

impl Built<'_> {
    /// Cells in which there is anything, those that are half full at least before the others.
    fn taken(&self) -> Vec<usize> {
        let all = || 0..self.cut.inside.len();
        let little = |&cell: &usize| !self.is_node[cell] && self.cut.inside[cell][0] > ROUNDING;
        all().filter(|&cell| self.is_node[cell]).chain(all().filter(little)).collect()
    }

    /// Numbers of the corners of a cell in the lattice: four round its lower face, four above them.
    fn corners(&self, cell: usize) -> [usize; 8] {
        let [i, j, k] = self.cut.place(cell);
        let [_, rows, columns] = self.laid.counts.map(|count| count + 1);
        let at = |a: usize, b: usize, c: usize| ((i + a) * rows + j + b) * columns + k + c;
        let ring = |c| [at(0, 0, c), at(1, 0, c), at(1, 1, c), at(0, 1, c)];
        let ([a, b, c, d], [e, f, g, h]) = (ring(0), ring(1));
        [a, b, c, d, e, f, g, h]
    }

    fn cells(&self, snapped: &Snapped) -> Result<Cells, Misfit> {
        let nodes = |cell: usize| self.corners(cell).map(|corner| snapped.of_corner[corner]);
        let numbers: Vec<u32> = self.is_node.iter().map(|&own| if own { 0 } else { u32::MAX }).collect();
        let (steps, near) = (steps(), CellList::new(&snapped.places, self.spacing));
        let mut volumes = vec![0.0; snapped.places.len()];
        let cubic = self.spacing.powi(3) / 8.0;
        let (mut out, mut half_full) = (Vec::new(), 0);
        let (mut away, mut most) = (0.0, None);
        for cell in self.taken() {
            let inside = self.cut.inside[cell];
            if self.is_node[cell] {
                half_full += 1;
                out.push(nodes(cell));
                nodes(cell).iter().for_each(|&node| volumes[node as usize] += inside[0] * cubic);
                continue;
            }
            let beside = nearest(self.cut, cell, &numbers, &steps)?;
            for (other, part) in &beside.parts {
                nodes(*other).iter().for_each(|&node| volumes[node as usize] += part * inside[0] * cubic);
            }
            if beside.square > BESIDE {
                away += inside[0];
                if most.is_none_or(|(volume, _)| inside[0] > volume) {
                    most = Some((inside[0], centre(self.cut, cell)));
                }
            }
            let place = self.centroid(cell);
            out.push([near.nearest_particle(&place).unwrap_or_default(); 8]);
        }
        match out.is_empty() {
            true => Err(Misfit::Thin(self.laid.counts.map(|count| 0.5 * count as f64))),
            false => Ok((out, half_full, volumes, most.map(|(_, place)| (away, place)))),
        }
    }

    /// Centroid of what of a cell lies inside \[L\].
    fn centroid(&self, cell: usize) -> Vec3 {
        let (middle, [volume, x, y, z]) = (centre(self.cut, cell), self.cut.inside[cell]);
        let place = Vec3::from(middle) + Vec3::new(x, y, z) / volume;
        self.laid.origin + place * self.spacing
    }

    /// Points of the cells, in their order.
    fn points(&self) -> Vec<Vec<VolumePoint>> {
        let rule = self.rule;
        let (size, steps) = (self.spacing / rule as f64, || 0..rule);
        let of = |cell: usize| {
            let at = self.cut.place(cell);
            let first = self.laid.origin + Vec3::from(at.map(|n| n as f64)) * self.spacing;
            let parts = || {
                let all =
                    steps().flat_map(move |a| (0..rule).flat_map(move |b| (0..rule).map(move |c| [a, b, c])));
                all.map(|step| [0, 1, 2].map(|axis| rule * at[axis] + step[axis]))
            };
            let inside = |part| self.fine.inside[self.fine.number(part)];
            if parts().all(|part| (inside(part)[0] - 1.0).abs() <= TWICE) {
                return whole(first, self.spacing, rule);
            }
            let outside = VolumePoint { place: self.centroid(cell), volume: 0.0 };
            let point = |part: [usize; 3]| {
                let [volume, x, y, z] = inside(part);
                if volume <= ROUNDING {
                    return outside;
                }
                let middle = Vec3::from(part.map(|n| n as f64 + 0.5)) + Vec3::new(x, y, z) / volume;
                VolumePoint { place: self.laid.origin + middle * size, volume: volume * size.powi(3) }
            };
            parts().map(point).collect()
        };
        self.taken().into_iter().map(of).collect()
    }

    /// Outer faces of the cells that are half full.
    fn outer(&self, snapped: &Snapped) -> Vec<Cell> {
        let mut out = Vec::new();
        for cell in (0..self.is_node.len()).filter(|&cell| self.is_node[cell]) {
            let at = self.cut.place(cell);
            let [a, b, c, d, e, f, g, h] = self.corners(cell).map(|corner| snapped.of_corner[corner]);
            let sides = [[a, e, h, d], [b, c, g, f], [a, b, f, e], [d, h, g, c], [a, d, c, b], [e, f, g, h]];
            for (side, corners) in sides.into_iter().enumerate() {
                let (axis, upper) = (side / 2, side % 2 == 1);
                let mut beside = at;
                let last = at[axis] == if upper { self.laid.counts[axis] - 1 } else { 0 };
                if !last {
                    beside[axis] = if upper { at[axis] + 1 } else { at[axis] - 1 };
                }
                if last || !self.is_node[self.cut.number(beside)] {
                    out.extend(face(corners));
                }
            }
        }
        out
    }
}

/// Gauss's points of a cell from its lowest corner.
fn whole(first: Vec3, spacing: f64, rule: usize) -> Vec<VolumePoint> {
    let planes = [0, 1, 2].map(|axis| vec![first[axis], first[axis] + spacing]);
    let cell = Hexahedra::between(&planes).and_then(|cells| cells.volume_points(rule));
    cell.map(|mut points| points.swap_remove(0)).unwrap_or_default()
}

/// A face between the different ones of its corners; none where these are two.
fn face(corners: [u32; 4]) -> Option<Cell> {
    let mut own: Vec<u32> = Vec::with_capacity(4);
    corners.iter().for_each(|corner| {
        if !own.contains(corner) {
            own.push(*corner)
        }
    });
    match own[..] {
        [a, b, c, d] => Some(Cell::quadrangle([a, b, c, d])),
        [a, b, c] => Some(Cell::triangle([a, b, c])),
        _ => None,
    }
}

impl FilledCells {
    /// Points of a part of the surface: of whole faces of cells in planes of the box Gauss's, two along an edge at least, of others one for what lies in a part
    /// of a cell in one plane, however triangles divide it.
    pub fn face_points(&self, facets: &[Facet]) -> Vec<FacePoint> {
        let (spacing, low) = (self.block.spacing[0], self.bounds.origin);
        let facets = &self.joined(facets);
        let side_of = |facet: &Facet| (0..6).find(|&side| self.flat[side][facet.triangle as usize]);
        let mut faces: BTreeMap<(usize, [i64; 3]), Vec<usize>> = BTreeMap::new();
        let mut out = Vec::with_capacity(facets.len());
        for (number, facet) in facets.iter().enumerate() {
            let Some(side) = side_of(facet) else {
                out.push(of_piece(facet));
                continue;
            };
            let mut at =
                [0, 1, 2].map(|axis| ((facet.place[axis] - self.origin[axis]) / spacing).floor() as i64);
            at[side / 2] = 0;
            faces.entry((side, at)).or_default().push(number);
        }
        let rule = self.rule.max(2);
        for ((side, at), own) in faces {
            let area: f64 = own.iter().map(|&number| facets[number].area.norm()).sum();
            if (area - spacing * spacing).abs() > WHOLE * spacing * spacing {
                out.extend(own.iter().map(|&number| of_piece(&facets[number])));
                continue;
            }
            let axis = side / 2;
            let mut first = self.origin + Vec3::from(at.map(|n| n as f64)) * spacing;
            first[axis] = low[axis] + if side % 2 == 1 { self.bounds.lengths[axis] } else { 0.0 };
            let [mut u, mut v] = [1, 2].map(|k| Vec3::ith((axis + k) % 3, spacing));
            if side % 2 == 0 {
                (u, v) = (v, u);
            }
            let corners = vec![first, first + u, first + u + v, first + v];
            let square = Hexahedra { corners, ..Hexahedra::default() };
            out.extend(square.face_points(&[[0, 1, 2, 3]], rule).unwrap_or_default());
        }
        out
    }
}

impl FilledCells {
    /// Pieces with those in the same part of a cell and in the same plane made one.
    fn joined(&self, facets: &[Facet]) -> Vec<Facet> {
        let size = self.block.spacing[0] / self.rule as f64;
        let mut parts: BTreeMap<[i64; 3], Vec<(Vec3, Facet)>> = BTreeMap::new();
        for facet in facets {
            let normal = facet.area.normalize();
            // From within the body: a piece may lie in a side of the part.
            let inside = (facet.place - normal * (UNDER * size) - self.origin) / size;
            let own = parts.entry([0, 1, 2].map(|axis| inside[axis].floor() as i64)).or_default();
            match own.iter_mut().find(|(other, _)| (normal - other).norm() <= ALIKE) {
                None => own.push((normal, *facet)),
                Some((_, other)) => {
                    let [a, b] = [other.area.norm(), facet.area.norm()];
                    other.place = (other.place * a + facet.place * b) / (a + b);
                    other.area += facet.area;
                }
            }
        }
        parts.into_values().flatten().map(|own| own.1).collect()
    }
}

/// A piece of the surface as one point: the product of its tangents is its area.
fn of_piece(facet: &Facet) -> FacePoint {
    let area = facet.area.norm();
    let normal = facet.area / area;
    let axis = (0..3).min_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs())).unwrap_or_default();
    let first = normal.cross(&Vec3::ith(axis, 1.0)).normalize() * area.sqrt();
    FacePoint { place: facet.place, tangents: [first, normal.cross(&first)] }
}
