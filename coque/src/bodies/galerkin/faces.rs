//! Where loads press: sides of the block, or what of them lies in the region of a set, cells on its border cut by it.

use sph_core::{FacePoint, Hexahedra, Vec3};

use super::places::Places;
use crate::bodies::solid::sets::NodeSets;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::sets::OF_SOLIDS;
use crate::scene::{OnPlane, Region};

/// Part of a spacing within which a corner lies on the border of a region.
const SLACK: f64 = 1e-9;
/// Part of the area of a face that is none.
const NOTHING: f64 = 1e-9;

/// All x with `normal · x ≤ reach`.
struct HalfSpace {
    normal: Vec3,
    reach: f64,
}

impl Places {
    /// Points of the part of a surface under a load on a set: the part that has its name, else what is nearest to its nodes; none of a block. What lies
    /// in planes of symmetry along the axes is loaded where a face is named only.
    ///
    /// # Errors
    /// [`SceneError::Set`] where nothing is left.
    pub fn of_surface(
        &self,
        scene: &BodyInScene<'_>,
        sets: &NodeSets<'_>,
        (path, name): (&str, &str),
    ) -> Result<Option<Vec<FacePoint>>, SceneError> {
        let Some((filled, _)) = &self.filled else { return Ok(None) };
        let mut planes = Vec::new();
        for support in &scene.supports {
            let Some(mirror) = support.symmetry else { continue };
            let normal = Vec3::from(mirror.normal).normalize();
            if let Some(axis) = (0..3).find(|&axis| normal[axis].abs() > 1.0 - SLACK) {
                let node = sets.at(&support.at("on"), support.on)?[0];
                planes.push((axis, self.block.positions[node as usize][axis]));
            }
        }
        let facets = sets.facets(name, sets.at(path, name)?, &planes).unwrap_or_default();
        if !facets.is_empty() {
            return Ok(Some(filled.face_points(&facets)));
        }
        let bound = "but nothing of the surface lies at its nodes";
        let repair = "use `surface`, a group of the file, or a region that holds a part of the surface";
        Err(SceneError::Set(sets.scene().source.fault(path, &format!("\"{name}\""), bound, repair)))
    }

    /// Faces of background cells under a load on a set: of a side of the block all; of a region what it holds of every side on which
    /// it holds a whole face, or of the only side that it meets. Corners of faces that are cut are added to those of the cells.
    ///
    /// # Errors
    /// [`SceneError::Set`] where nothing is left.
    pub fn faces(
        &self,
        cells: &mut Hexahedra,
        sets: &NodeSets<'_>,
        path: &str,
        name: &str,
    ) -> Result<Vec<[u32; 4]>, SceneError> {
        if let Some(number) = OF_SOLIDS[1..].iter().position(|known| *known == name) {
            return Ok(self.cells.faces[number].clone());
        }
        let region = sets.scene().sets.get(name).copied();
        if region.is_some_and(|region| region.near.is_some() || region.made().is_some()) {
            let bound = "but what acts by area acts on sides of the block, boxes, planes and layers: their borders cut faces straight";
            let repair = "give each side and box a load of its own, or use `force`, which acts on nodes";
            let fault = sets.scene().source.fault(path, &format!("\"{name}\""), bound, repair);
            return Err(SceneError::Set(fault));
        }
        if region.is_none() {
            return Ok(self.cells.faces.iter().flatten().copied().collect()); // `all`
        }
        let sides = self.cells.faces.each_ref().map(|side| {
            let pieces = side.iter().map(|face| self.cut(face, region)).collect::<Vec<_>>();
            (pieces.iter().any(|piece| matches!(piece, Piece::Whole)), pieces)
        });
        let meets = |pieces: &[Piece]| pieces.iter().any(|piece| !matches!(piece, Piece::Nothing));
        let lone = sides.iter().filter(|(_, pieces)| meets(pieces)).count() == 1;
        let mut out = Vec::new();
        for (side, (whole, pieces)) in self.cells.faces.iter().zip(&sides) {
            if *whole || lone {
                side.iter().zip(pieces).for_each(|(face, piece)| piece.add(face, cells, &mut out));
            }
        }
        if !out.is_empty() {
            return Ok(out);
        }
        let bound = "but it holds no whole face of a cell on the outside";
        let repair =
            "let it hold all of at least one outer face, or meet one side of the block only, or use `force`";
        Err(SceneError::Set(sets.scene().source.fault(path, &format!("\"{name}\""), bound, repair)))
    }

    /// What a region holds of a face.
    fn cut(&self, face: &[u32; 4], region: Option<&Region>) -> Piece {
        let Some(region) = region else { return Piece::Whole };
        let spacing = self.block.greatest_spacing();
        let (corners, bounds) = match &region.layer {
            // In the frame of the lattice: an arc is that of a straight block.
            Some(layer) => {
                let side = OF_SOLIDS[1..].iter().position(|known| *known == layer.face).unwrap_or_default();
                let (low, axis) = (side % 2 == 0, side / 2);
                let start = self.lattice.origin[axis];
                let reach = if low {
                    start + layer.depth.get()
                } else {
                    layer.depth.get() - start - self.lattice.lengths[axis]
                };
                let normal = Vec3::ith(axis, if low { 1.0 } else { -1.0 });
                (&self.even, vec![HalfSpace { normal, reach }])
            }
            None => (&self.cells.corners, bounds(region)),
        };
        let own = face.map(|corner| corners[corner as usize]);
        if bounds.is_empty() {
            // A plane without thickness holds what lies in it, a place nothing.
            let on = |plane: OnPlane| {
                let normal = Vec3::from(plane.normal).normalize();
                own.iter().all(|x| (x - Vec3::from(plane.point)).dot(&normal).abs() <= 1e-3 * spacing)
            };
            return if region.plane.is_some_and(on) { Piece::Whole } else { Piece::Nothing };
        }
        let mut polygon = own.to_vec();
        for bound in &bounds {
            polygon = bound.clip(&polygon, SLACK * spacing);
        }
        let (whole, left) = (area(&own), area(&polygon));
        if left >= (1.0 - NOTHING) * whole {
            return Piece::Whole;
        }
        if left <= NOTHING * whole {
            return Piece::Nothing;
        }
        if region.layer.is_some() {
            let space = face.map(|corner| self.cells.corners[corner as usize]);
            polygon.iter_mut().for_each(|x| *x = carried(x, &own, &space));
        }
        Piece::Part(polygon)
    }
}

/// Borders of a box, or of a plane with a thickness.
fn bounds(region: &Region) -> Vec<HalfSpace> {
    if let Some(faces) = region.inside {
        let both = |axis: usize| {
            let (low, high) = (Vec3::ith(axis, -1.0), Vec3::ith(axis, 1.0));
            let (min, max) = (-faces.min[axis], faces.max[axis]);
            [HalfSpace { normal: low, reach: min }, HalfSpace { normal: high, reach: max }]
        };
        return (0..3).flat_map(both).collect();
    }
    let Some(OnPlane { point, normal, within: Some(within) }) = region.plane else { return Vec::new() };
    let normal = Vec3::from(normal).normalize();
    let at = normal.dot(&Vec3::from(point));
    vec![
        HalfSpace { normal, reach: at + within.get() },
        HalfSpace { normal: -normal, reach: within.get() - at },
    ]
}

impl HalfSpace {
    /// What of a plane convex polygon lies within; corners nearer than `slack` lie on the border.
    fn clip(&self, polygon: &[Vec3], slack: f64) -> Vec<Vec3> {
        let beyond = |x: &Vec3| {
            let far = self.normal.dot(x) - self.reach;
            if far.abs() <= slack { 0.0 } else { far }
        };
        let mut out = Vec::with_capacity(polygon.len() + 1);
        for (i, x) in polygon.iter().enumerate() {
            let next = &polygon[(i + 1) % polygon.len()];
            let (here, there) = (beyond(x), beyond(next));
            if here <= 0.0 {
                out.push(*x);
            }
            if here * there < 0.0 {
                out.push(x + (next - x) * (here / (here - there)));
            }
        }
        out
    }
}

/// A point of a rectangle of the straight lattice, on the face that it became.
fn carried(x: &Vec3, straight: &[Vec3; 4], space: &[Vec3; 4]) -> Vec3 {
    let along = |to: Vec3| {
        let edge = to - straight[0];
        (x - straight[0]).dot(&edge) / edge.norm_squared()
    };
    let (u, v) = (along(straight[1]), along(straight[3]));
    (space[0] * (1.0 - u) + space[1] * u) * (1.0 - v) + (space[3] * (1.0 - u) + space[2] * u) * v
}

fn area(polygon: &[Vec3]) -> f64 {
    let fan = polygon.windows(2).skip(1).map(|pair| (pair[0] - polygon[0]).cross(&(pair[1] - polygon[0])));
    0.5 * fan.sum::<Vec3>().norm()
}

/// What a region holds of a face.
enum Piece {
    Nothing,
    Whole,
    /// A convex polygon, round as the corners of the face.
    Part(Vec<Vec3>),
}

impl Piece {
    /// Adds quadrangles, the last with one corner twice where the number of corners is odd.
    fn add(&self, face: &[u32; 4], cells: &mut Hexahedra, out: &mut Vec<[u32; 4]>) {
        let corners = match self {
            Self::Nothing => return,
            Self::Whole => return out.push(*face),
            Self::Part(corners) => corners,
        };
        let (first, count) = (cells.corners.len() as u32, corners.len() as u32);
        cells.corners.extend(corners);
        for at in (1..count - 1).step_by(2) {
            let last = (at + 2).min(count - 1);
            out.push([first, first + at, first + at + 1, first + last]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_are_cut_and_made_into_quadrangles_of_the_same_area() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(|[x, y]| Vec3::new(x, y, 1.0));
        let aslant = HalfSpace { normal: Vec3::new(1.0, 1.0, 0.0), reach: 3.0 };
        let cut = aslant.clip(&square, 1e-9);
        assert!(cut.len() == 5 && (area(&cut) - 3.5).abs() < 1e-14);
        for bound in [3.0, 2.0, 1.0] {
            let cut = HalfSpace { reach: bound, ..aslant }.clip(&square, 1e-9);
            let (mut cells, mut faces) = (Hexahedra::default(), Vec::new());
            Piece::Part(cut.clone()).add(&[0; 4], &mut cells, &mut faces);
            let sum: Vec3 = cells.face_points(&faces, 2).unwrap_or_default().iter().map(|p| p.area()).sum();
            assert!((sum - Vec3::z() * area(&cut)).norm() < 1e-14, "{bound}: {sum}");
        }
    }
}
