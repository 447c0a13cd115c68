//! The points of a rigid body that a fluid wets: rows behind its faces, as those of walls; in a plane behind its outline.

use std::collections::{BTreeMap, BTreeSet};

use rigid_body::{MassProperties, Outline, WetPoints};
use sph_core::{LineSide, SpaceError, Vec3, block_rows, polyline_rows, surface_rows};

use crate::bodies::fluid::parts::{liquid, rows_deep};
use crate::bodies::refusal::body_error;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{FluidScene, RigidGeometry, RigidScene};

/// Part by which the volume of a prism may differ from its outline times its width.
const EVEN: f64 = 1e-6;
/// Sine of the turn at a corner of an outline below which it is none.
const STRAIGHT: f64 = 1e-9;

/// The points of a body of these masses, and the width of a plane one.
pub(super) fn wet_points(
    scene: &BodyInScene<'_>,
    rigid: &RigidScene,
    (outline, mass): (&Outline, &MassProperties),
    fluid: &FluidScene,
) -> Result<WetPoints, SceneError> {
    let (dimensions, spacing, deep) = (fluid.dimensions(), fluid.geometry.spacing(), rows_deep(fluid));
    let path = format!("geometry.{}", rigid.geometry.word());
    let refused = |error: SpaceError| body_error(scene, &path, &error.to_string());
    let low = lowest(outline);
    let lengths = -lowest_of(outline, -1.0) - low;
    let plane = dimensions == 2;
    let rows = |deep: usize| -> Result<Vec<Vec3>, SceneError> {
        let lines = match &rigid.geometry {
            RigidGeometry::Box(_) => block_rows(lengths.into(), &low, dimensions, spacing, deep),
            _ if plane => {
                let corners = prism(outline).ok_or_else(|| no_prism(scene, &path))?;
                polyline_rows(&corners, LineSide::Left, spacing, deep)
            }
            _ => {
                let (vertices, triangles) = (&outline.vertices, triangles(outline));
                let outside = low - Vec3::repeat(lengths.max());
                surface_rows(vertices, &triangles, &outside, spacing, deep)
            }
        };
        let mut points = lines.map_err(refused)?;
        if plane {
            points.iter_mut().for_each(|point| point.z = mass.centre.z);
        }
        Ok(points)
    };
    let points = rows(deep)?;
    let key = |x: &Vec3| [x.x, x.y, x.z].map(f64::to_bits);
    let front: BTreeSet<[u64; 3]> = rows(1)?.iter().map(key).collect();
    let first = points.iter().map(|x| front.contains(&key(x))).collect();
    let liquid = liquid(fluid);
    Ok(WetPoints {
        points,
        first,
        area: if plane { spacing } else { spacing * spacing },
        width: plane.then_some(lengths.z),
        impedance: liquid.density * liquid.sound_speed,
    })
}

/// Least coordinates of a surface.
fn lowest(outline: &Outline) -> Vec3 {
    lowest_of(outline, 1.0)
}

/// The same of its coordinates times a sign.
fn lowest_of(outline: &Outline, sign: f64) -> Vec3 {
    let none = Vec3::repeat(f64::INFINITY);
    outline.vertices.iter().fold(none, |low, x| low.inf(&(x * sign)))
}

fn no_prism(scene: &BodyInScene<'_>, path: &str) -> SceneError {
    let message = "a surface that is no prism along z, which has no one outline in the plane of the fluid; use a box, or a mesh of straight sides \
                   along z with flat ends and no hole";
    body_error(scene, path, message)
}

/// Triangles of all faces, quadrangles cut in two.
fn triangles(outline: &Outline) -> Vec<[u32; 3]> {
    let of = |cell: &sph_core::Cell| {
        let [a, b, c, d] = cell.corners;
        let second = (cell.count == 4).then_some([a, c, d]);
        std::iter::once([a, b, c]).chain(second)
    };
    outline.cells.iter().flat_map(of).collect()
}

/// The outline of a prism along z, anticlockwise, its first corner again at its end; none of what is no prism, or has a hole.
///
/// It is the cut at half of the height: each face that the cut crosses gives a piece between two of its edges.
fn prism(outline: &Outline) -> Option<Vec<[f64; 2]>> {
    let (low, high) = (lowest(outline).z, -lowest_of(outline, -1.0).z);
    let middle = 0.5 * (low + high);
    let at = |vertex: u32| outline.vertices[vertex as usize];
    // From the edge at which the cut enters a face to the one at which it leaves, the face looking outwards on the right.
    let mut next: BTreeMap<[u32; 2], [u32; 2]> = BTreeMap::new();
    for cell in &outline.cells {
        let crossed = |up: bool| {
            let mut edges = cell.edges();
            let crosses = move |&(a, b): &(u32, u32)| {
                let (above, later) = (at(a).z >= middle, at(b).z >= middle);
                above != later && later == up
            };
            edges.find(crosses).map(|(a, b)| [a.min(b), a.max(b)])
        };
        if let (Some(down), Some(up)) = (crossed(false), crossed(true)) {
            next.insert(down, up);
        }
    }
    let cut = |[a, b]: [u32; 2]| {
        let (a, b) = (at(a), at(b));
        let place = a.lerp(&b, (middle - a.z) / (b.z - a.z));
        [place.x, place.y]
    };
    let first = *next.keys().next()?;
    let (mut all, mut edge) = (vec![cut(first)], *next.get(&first)?);
    while edge != first && all.len() <= next.len() {
        all.push(cut(edge));
        edge = *next.get(&edge)?;
    }
    if all.len() != next.len() {
        return None;
    }
    let ring = |i: usize| all[i % all.len()];
    let cross = |[ax, ay]: [f64; 2], [bx, by]: [f64; 2], [cx, cy]: [f64; 2]| {
        let ([ux, uy], [vx, vy]) = ([bx - ax, by - ay], [cx - bx, cy - by]);
        (ux * vy - uy * vx, (libm::hypot(ux, uy) * libm::hypot(vx, vy)))
    };
    let area: f64 = (0..all.len())
        .map(|i| {
            let ([ax, ay], [bx, by]) = (ring(i), ring(i + 1));
            0.5 * (ax * by - ay * bx)
        })
        .sum();
    let volume = outline.filled(1.0).ok()?.mass;
    let even = (area.abs() * (high - low) / volume - 1.0).abs() < EVEN;
    let mut corners: Vec<[f64; 2]> = (0..all.len())
        .filter(|&i| {
            let (turn, size) = cross(ring(i + all.len() - 1), ring(i), ring(i + 1));
            turn.abs() > STRAIGHT * size
        })
        .map(ring)
        .collect();
    if area < 0.0 {
        corners.reverse();
    }
    corners.push(*corners.first()?);
    even.then_some(corners)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rigid_body::{ball, cuboid};

    #[test]
    fn a_prism_has_the_outline_of_its_ends_and_a_ball_none() {
        let mut wedge = cuboid([0.0, 0.0, -1.0], [2.0, 1.0, 3.0], 0.5);
        let outline = prism(&wedge).unwrap();
        assert_eq!((outline.len(), outline.first()), (5, outline.last()));
        // A wedge: the upper face twice as long as the lower one.
        wedge.vertices.iter_mut().for_each(|x| x.x *= 1.0 + x.y);
        let outline = prism(&wedge).unwrap();
        assert_eq!(outline.len(), 5);
        let anticlockwise: f64 =
            outline.windows(2).map(|pair| pair[0][0] * pair[1][1] - pair[0][1] * pair[1][0]).sum();
        assert!((0.5 * anticlockwise - 3.0).abs() < 1e-12);
        assert!(prism(&ball([0.0; 3], 1.0, 0.5)).is_none());
        let mut leaning = cuboid([0.0; 3], [1.0; 3], 0.5);
        leaning.vertices.iter_mut().for_each(|x| x.y *= 1.0 + x.z);
        assert!(prism(&leaning).is_none_or(|outline| outline.len() == 5));
    }
}
