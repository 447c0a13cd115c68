//! The points of a rigid body that a fluid wets: rows behind its faces, as those of walls; in a plane behind its outline.

use std::collections::{BTreeMap, BTreeSet};

use rigid_body::{MassProperties, Outline, WetPoints};
use sph_core::{
    LineSide, SpaceError, Vec3, block_rows, leaks, polyline_first_row, polyline_rows, surface_first_row,
    surface_rows,
};

use crate::bodies::fluid::parts::{liquid, rows_deep};
use crate::bodies::refusal::body_error;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{FluidScene, RigidGeometry, RigidScene};
use crate::warning::{Warning, WarningKind};

/// Part by which the volume of a prism may differ from its outline times its width.
const EVEN: f64 = 1e-6;
/// Sine of the angle by which a face of a prism may lean from its axis or from across it: coordinates of a file have six digits or more, edges of its faces a hundredth of its size.
const UPRIGHT: f64 = 1e-4;
/// Sine of the turn at a corner of an outline below which it is none.
const STRAIGHT: f64 = 1e-9;

/// The points of a body of these masses, and the width of a plane one; with a warning where rows behind its faces have gaps.
pub(super) fn wet_points(
    scene: &BodyInScene<'_>,
    rigid: &RigidScene,
    (outline, mass): (&Outline, &MassProperties),
    fluid: &FluidScene,
) -> Result<(WetPoints, Option<Warning>), SceneError> {
    let (dimensions, spacing, deep) = (fluid.dimensions(), fluid.geometry.spacing(), rows_deep(fluid));
    let path = format!("geometry.{}", rigid.geometry.word());
    let refused = |error: SpaceError| body_error(scene, &path, &error.to_string());
    let low = lowest(outline);
    let lengths = -lowest_of(outline, -1.0) - low;
    let plane = dimensions == 2;
    let faces = match &rigid.geometry {
        RigidGeometry::Box(_) => Faces::Box { low, lengths },
        _ if plane => Faces::Prism(prism(outline).ok_or_else(|| no_prism(scene, &path))?),
        _ => Faces::Surface { triangles: triangles(outline), outside: low - Vec3::repeat(lengths.max()) },
    };
    let rows = |deep: usize| -> Result<Vec<Vec3>, SceneError> {
        let lines = match &faces {
            Faces::Box { low, lengths } => block_rows((*lengths).into(), low, dimensions, spacing, deep),
            Faces::Prism(corners) => polyline_rows(corners, LineSide::Left, spacing, deep),
            Faces::Surface { triangles, outside } => {
                surface_rows(&outline.vertices, triangles, outside, spacing, deep)
            }
        };
        lines.map_err(refused)
    };
    let mut points = rows(deep)?;
    if points.is_empty() {
        return Err(thin(scene, &path, spacing));
    }
    // Of a box, rows fit as its edges are checked.
    let wanted = match &faces {
        Faces::Box { .. } => Vec::new(),
        Faces::Prism(corners) => polyline_first_row(corners, LineSide::Left, spacing).map_err(refused)?,
        Faces::Surface { triangles, outside } => {
            surface_first_row(&outline.vertices, triangles, outside, spacing).map_err(refused)?
        }
    };
    let leaky = leaky(leaks(&wanted, &points, dimensions, spacing));
    let mut front = rows(1)?;
    if plane {
        points.iter_mut().chain(&mut front).for_each(|point| point.z = mass.centre.z);
    }
    let key = |x: &Vec3| [x.x, x.y, x.z].map(f64::to_bits);
    let front: BTreeSet<[u64; 3]> = front.iter().map(key).collect();
    let first = points.iter().map(|x| front.contains(&key(x))).collect();
    let liquid = liquid(fluid);
    let wet = WetPoints {
        points,
        first,
        area: if plane { spacing } else { spacing * spacing },
        width: plane.then_some(lengths.z),
        impedance: liquid.density * liquid.sound_speed,
    };
    Ok((wet, leaky))
}

/// What rows stand behind.
enum Faces {
    /// A box from its lowest corner.
    Box { low: Vec3, lengths: Vec3 },
    /// The outline of a prism in the plane.
    Prism(Vec<[f64; 2]>),
    /// Triangles, and a place outside of them.
    Surface { triangles: Vec<[u32; 3]>, outside: Vec3 },
}

/// The refusal of a body without room for a row.
fn thin(scene: &BodyInScene<'_>, path: &str, spacing: f64) -> SceneError {
    let message = format!(
        "a body thinner than a spacing of the fluid, {spacing}, everywhere: no row of points fits behind its faces, and water would go through; \
         make it thicker, use a narrower spacing, or a shell"
    );
    body_error(scene, path, &message)
}

/// The warning of rows with gaps at so many places.
fn leaky(places: usize) -> Option<Warning> {
    let message = || {
        format!(
            "wet points have gaps wider than 1.2 spacings at {places} places, where the body is thinner than a spacing or sharp: \
             fluid may leak; use a narrower spacing"
        )
    };
    (places > 0).then(|| Warning::new(WarningKind::LeakyWall, message()))
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

/// Whether a triangle lies along z or across it, to rounding of its corners; one without an area does.
fn upright([a, b, c]: [Vec3; 3]) -> bool {
    let normal = (b - a).cross(&(c - a));
    let [along, across] = [normal.z.abs(), libm::hypot(normal.x, normal.y)];
    along.min(across) <= UPRIGHT * along.max(across)
}

/// The outline of a prism along z, anticlockwise, its first corner again at its end; none of what is no prism, or has a hole.
///
/// It is the cut at half of the height: each face that the cut crosses gives a piece between two of its edges.
fn prism(outline: &Outline) -> Option<Vec<[f64; 2]>> {
    let (low, high) = (lowest(outline).z, -lowest_of(outline, -1.0).z);
    let middle = 0.5 * (low + high);
    let at = |vertex: u32| outline.vertices[vertex as usize];
    if !triangles(outline).into_iter().all(|corners| upright(corners.map(at))) {
        return None;
    }
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
        let bent = |by: fn(&mut Vec3)| {
            let mut all = cuboid([0.0; 3], [1.0; 3], 0.5);
            all.vertices.iter_mut().for_each(by);
            prism(&all)
        };
        // It leans, tapers, widens linearly towards one end, or is as a file of seven digits has it.
        assert!(bent(|x| x.y += 0.3 * x.z).is_none());
        assert!(bent(|x| x.y *= 1.0 + x.z).is_none());
        assert!(bent(|x| *x = Vec3::new(x.x * (1.0 + x.z), x.y / (1.0 + x.z), x.z)).is_none());
        assert!(bent(|x| x.y += 1e-7 * x.z).is_some());
    }
}
