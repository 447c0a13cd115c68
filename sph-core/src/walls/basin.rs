//! Walls along the axes: a box round a fluid, an obstacle in it.

use super::wall_rows::{check, check_count, check_dimensions, divisions};
use crate::Vec3;
use crate::error::SpaceError;

/// A place along one axis: coordinate \[L\], and number of the row of wall that it is, none inside a basin.
type Place = (f64, Option<usize>);

/// Rows of wall particles round a box, the first half a spacing outside its faces, those of the last axis running
/// fastest.
///
/// `min` and `max` are the corners of the box from inside \[L\]; a plane box lies at the z of `min`. Sides in `open`,
/// in the order x0, x1, y0, y1, z0, z1, have no wall, and the walls beside them end at their edge. Particles stand
/// `spacing` \[L\] apart across a wall; along it at the nearest spacing that divides the length of the box, as a
/// [`BlockLattice`](crate::BlockLattice) does. Corners between two walls are filled.
///
/// # Errors
/// [`SpaceError::OutOfRange`] for lengths and spacings that are not positive, dimensions other than two and three,
/// rows out of \[1, 20\], a box all of whose sides are open, and more than 10⁸ particles.
pub fn basin_rows(
    min: &Vec3,
    max: &Vec3,
    open: [bool; 6],
    dimensions: usize,
    spacing: f64,
    rows: usize,
) -> Result<Vec<Vec3>, SpaceError> {
    check(spacing, rows)?;
    check_dimensions(dimensions)?;
    let mut places: [Vec<Place>; 3] = [const { Vec::new() }; 3];
    for (axis, places) in places.iter_mut().enumerate() {
        if axis >= dimensions {
            places.push((min[axis], None));
            continue;
        }
        let length = checked_length(max[axis] - min[axis])?;
        check_count(length / spacing)?;
        let outside = |row: usize| (row as f64 + 0.5) * spacing;
        let cells = divisions(length, spacing);
        let inside = |i: usize| min[axis] + length * ((i as f64 + 0.5) / cells as f64);
        if !open[2 * axis] {
            places.extend((0..rows).rev().map(|row| (min[axis] - outside(row), Some(row))));
        }
        places.extend((0..cells).map(|i| (inside(i), None)));
        if !open[2 * axis + 1] {
            places.extend((0..rows).map(|row| (max[axis] + outside(row), Some(row))));
        }
    }
    let closed = open[..2 * dimensions].iter().filter(|open| !**open).count();
    if closed == 0 {
        return Err(SpaceError::OutOfRange { what: "closed sides of a basin", value: 0.0, bound: "[1, 6]" });
    }
    products(&places, |row| row.is_some())
}

/// Rows of wall particles in a solid block, the first half a spacing inside its faces; the block is hollow behind the
/// last.
///
/// The block has edges `lengths` \[L\] and its corner of least coordinates at `origin` \[L\]; a plane block lies at
/// the z of the origin. Between the first rows on either side particles stand at the nearest to `spacing` \[L\] that
/// divides the distance. The rows close corners and edges.
///
/// # Errors
/// [`SpaceError::OutOfRange`] for lengths and spacings that are not positive, a block thinner than a spacing,
/// dimensions other than two and three, rows out of \[1, 20\] and more than 10⁸ particles.
pub fn block_rows(
    lengths: [f64; 3],
    origin: &Vec3,
    dimensions: usize,
    spacing: f64,
    rows: usize,
) -> Result<Vec<Vec3>, SpaceError> {
    check(spacing, rows)?;
    check_dimensions(dimensions)?;
    let mut places: [Vec<Place>; 3] = [const { Vec::new() }; 3];
    for (axis, places) in places.iter_mut().enumerate() {
        if axis >= dimensions {
            places.push((origin[axis], None));
            continue;
        }
        let length = checked_length(lengths[axis])?;
        check_count(length / spacing)?;
        let between = length - spacing;
        // A block one particle thick may fall short by rounding.
        if between < -1e-9 * spacing {
            let (what, bound) = ("length of a wall block over the spacing", "[1, ∞)");
            return Err(SpaceError::OutOfRange { what, value: length / spacing, bound });
        }
        if between < 0.5 * spacing {
            places.push((origin[axis] + 0.5 * length, Some(0)));
            continue;
        }
        let gaps = divisions(between, spacing);
        places.extend((0..=gaps).map(|i| {
            let x = origin[axis] + 0.5 * spacing + between * (i as f64 / gaps as f64);
            (x, Some(i.min(gaps - i)))
        }));
    }
    products(&places, |depth| depth.is_some_and(|depth| depth < rows))
}

/// A length, or why it is none.
fn checked_length(length: f64) -> Result<f64, SpaceError> {
    if length > 0.0 && length.is_finite() {
        return Ok(length);
    }
    Err(SpaceError::OutOfRange { what: "length of a wall", value: length, bound: "(0, ∞)" })
}

/// The points of the lattice of three rows of places that stand in the wall along one axis at least.
fn products(
    places: &[Vec<Place>; 3],
    in_wall: impl Fn(Option<usize>) -> bool,
) -> Result<Vec<Vec3>, SpaceError> {
    let [along_x, along_y, along_z] = places.each_ref();
    let across: Vec<Place> = along_z.iter().copied().filter(|place| in_wall(place.1)).collect();
    let points: f64 = places.iter().map(|places| places.len() as f64).product();
    let free = |places: &Vec<Place>| places.iter().filter(|place| !in_wall(place.1)).count() as f64;
    let count = points - places.iter().map(free).product::<f64>();
    check_count(count)?;
    let mut particles = Vec::with_capacity(count as usize);
    for (x, in_x) in along_x {
        for (y, in_y) in along_y {
            let column = if in_wall(*in_x) || in_wall(*in_y) { along_z } else { &across };
            particles.extend(column.iter().map(|(z, _)| Vec3::new(*x, *y, *z)));
        }
    }
    Ok(particles)
}
