//! How a surface with open rims bounds a volume: the field whose flux through whatever closes them is none, or constant.
//!
//! With `div F = 1` the flux of F through a surface that moves by v changes by `∫ v·n dA`, as the volume does, and by `∮ F·(v × dl)` along its
//! rims. The second must vanish for every motion v that is left to a rim: on a plane of symmetry it does where F lies in the plane. So
//!
//! ```text
//! P (x − o)·(t × e) = 0     for both ends x of every edge e of a rim and every direction t in which an end may move
//! ```
//!
//! is solved for o by least squares, with P a third of one, then without an axis that is held (a tube between walls), then along one alone.

use nalgebra::{Matrix3, SymmetricEigen};
use sph_core::{Cell, Vec3};

use super::volume::Field;

/// What a rim may leave of the flux, over the size of the rim \[–\].
const CLOSED: f64 = 1e-6;
/// Directions this close are one.
const ALIKE: f64 = 1e-6;
/// Eigenvalues below this part of the largest are zero.
const NONE: f64 = 1e-9;

/// An end of an edge of a rim.
pub(super) struct RimEnd {
    pub particle: u32,
    /// Where it is at rest \[L\].
    pub place: Vec3,
    /// Edge of the rim from there.
    pub edge: Vec3,
    /// Directions that span those in which it may move.
    pub free: [Vec3; 3],
    /// Directions in which it is held.
    pub held: Vec<Vec3>,
}

/// Edges of some cells that belong to one of them alone, by the numbers that stand for particles at one place; else a particle at which the cells
/// are no surface with two sides: an edge has three of them, or two that face opposite ways.
pub(super) fn rims<'a>(
    cells: impl Iterator<Item = &'a Cell>,
    stands_for: impl Fn(u32) -> u32,
) -> Result<Vec<[u32; 2]>, u32> {
    let mut edges: Vec<([u32; 2], bool, [u32; 2])> = Vec::new();
    for cell in cells {
        for (a, b) in cell.edges() {
            let (one, two) = (stands_for(a), stands_for(b));
            edges.push(([one.min(two), one.max(two)], one < two, [a, b]));
        }
    }
    edges.sort_unstable();
    let mut rims = Vec::new();
    for alike in edges.chunk_by(|one, other| one.0 == other.0) {
        match alike {
            [alone] => rims.push(alone.2),
            [one, two] if one.1 != two.1 => {}
            _ => return Err(alike[0].2[0]),
        }
    }
    Ok(rims)
}

/// The field about the middle of a closed surface, or one whose flux through what closes the rims does not change; else a particle of a rim that
/// is free to change it.
pub(super) fn closing(middle: Vec3, rim: &[RimEnd]) -> Result<Field, u32> {
    let mut first = None;
    for matrix in candidates(rim) {
        match about(middle, matrix, rim) {
            Ok(field) => return Ok(field),
            Err(particle) => first = first.or(Some(particle)),
        }
    }
    Err(first.unwrap_or_default())
}

/// A third of one, half of it without each held direction, all of it along the line square to two of them.
fn candidates(rim: &[RimEnd]) -> Vec<Matrix3<f64>> {
    let mut held: Vec<Vec3> = Vec::new();
    for n in rim.iter().flat_map(|end| &end.held) {
        if held.iter().all(|known| known.cross(n).norm() > ALIKE) {
            held.push(*n);
        }
    }
    let one = Matrix3::identity();
    let without = held.iter().map(|n| (one - n * n.transpose()) * 0.5);
    let pairs = held.iter().enumerate().flat_map(|(i, m)| held[..i].iter().map(move |n| m.cross(n)));
    let along = pairs.filter(|line| line.norm() > ALIKE).map(|line| line.normalize());
    let along: Vec<Matrix3<f64>> = along.map(|line| line * line.transpose()).collect();
    std::iter::once(one / 3.0).chain(without).chain(along).collect()
}

/// The field of a matrix that the rim leaves closed, or the particle that leaves it most open.
fn about(middle: Vec3, matrix: Matrix3<f64>, rim: &[RimEnd]) -> Result<Field, u32> {
    let conditions = || {
        rim.iter().flat_map(|end| {
            end.free.iter().map(move |t| (end.particle, end.place, end.edge.norm(), t.cross(&end.edge)))
        })
    };
    let (mut sum, mut right) = (Matrix3::zeros(), Vec3::zeros());
    for (_, x, length, across) in conditions() {
        let row = matrix * across / length;
        sum += row * row.transpose();
        right += row * row.dot(&(x - middle));
    }
    let SymmetricEigen { eigenvalues, eigenvectors } = SymmetricEigen::new(sum);
    let mut origin = middle;
    for k in 0..3 {
        if eigenvalues[k] > NONE * sum.trace() {
            let v = eigenvectors.column(k);
            origin += v * (v.dot(&right) / eigenvalues[k]);
        }
    }
    let size = rim.iter().map(|end| (end.place - middle).norm()).fold(0.0, f64::max);
    let mut worst = (CLOSED * size, None);
    for (particle, x, length, across) in conditions() {
        let left = (matrix * (x - origin)).dot(&across).abs() / length;
        if left > worst.0 {
            worst = (left, Some(particle));
        }
    }
    worst.1.map_or(Ok(Field { origin, matrix }), Err)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn end(particle: u32, place: [f64; 3], edge: [f64; 3], held: &[[f64; 3]]) -> RimEnd {
        let held: Vec<Vec3> = held.iter().map(|&n| Vec3::from(n)).collect();
        let free = [Vec3::x(), Vec3::y(), Vec3::z()]
            .map(|axis| held.iter().fold(axis, |rest, n| rest - n * n.dot(&rest)));
        RimEnd { particle, place: place.into(), edge: edge.into(), free, held }
    }

    const X: [f64; 3] = [1.0, 0.0, 0.0];
    const Y: [f64; 3] = [0.0, 1.0, 0.0];
    const Z: [f64; 3] = [0.0, 0.0, 1.0];

    /// The rim of an eighth of a sphere lies in three planes: the field vanishes where they meet, wherever that is.
    #[test]
    fn an_eighth_is_closed_about_the_point_on_its_planes() {
        let rim = [
            end(0, [5.0, 3.0, 2.0], [0.0, 0.5, 0.0], &[Z]),
            end(1, [4.0, 4.0, 2.0], [-0.5, 0.5, 0.0], &[Z]),
            end(2, [4.0, 3.0, 3.0], [0.0, 0.0, 0.4], &[Y, X]),
            end(3, [5.0, 3.0, 3.0], [-0.3, 0.0, 0.3], &[Y]),
            end(4, [4.0, 5.0, 3.0], [0.0, -0.3, 0.4], &[X]),
        ];
        let field = closing(Vec3::new(9.0, 8.0, 7.0), &rim).unwrap();
        assert!((field.origin - Vec3::new(4.0, 3.0, 2.0)).norm() < 1e-12, "{field:?}");
        assert!((field.matrix - Matrix3::identity() / 3.0).norm() < 1e-15);
    }

    /// Two parallel walls leave no point on both: the field runs along them. A wall the other way is none that rims slide on.
    #[test]
    fn a_tube_between_walls_takes_the_field_across_its_axis() {
        let rim = |held: [f64; 3]| {
            [0.0, 3.0].map(|z| {
                [
                    end(0, [1.0, 0.0, z], [0.0, 0.5, 0.0], &[held]),
                    end(1, [0.0, 1.0, z], [-0.5, 0.0, 0.0], &[held]),
                ]
            })
        };
        let field = closing(Vec3::zeros(), rim(Z).as_flattened()).unwrap();
        assert!((field.matrix - Matrix3::from_diagonal(&Vec3::new(0.5, 0.5, 0.0))).norm() < 1e-12);
        assert!(closing(Vec3::zeros(), rim(X).as_flattened()).is_err());
    }

    /// A quarter of a ring between walls: across the axis, about the axis. A sheet between four walls: along the line that lies in all.
    #[test]
    fn quarters_and_sheets_between_walls() {
        let corner = |z: f64| {
            [
                end(0, [3.0, 1.0, z], [0.0, 0.5, 0.0], &[Z]),
                end(1, [3.0, 1.0, z], [0.0, 0.0, 0.5], &[Y]),
                end(2, [2.0, 2.0, z], [0.0, 0.0, 0.5], &[X]),
            ]
        };
        let field = closing(Vec3::zeros(), [corner(0.0), corner(4.0)].as_flattened()).unwrap();
        assert!((field.origin.x - 2.0).abs() < 1e-12 && (field.origin.y - 1.0).abs() < 1e-12, "{field:?}");
        let sheet = [
            end(0, [0.0, 0.5, 1.0], [0.0, 0.5, 0.0], &[X]),
            end(1, [1.0, 0.5, 1.0], [0.0, 0.5, 0.0], &[X]),
            end(2, [0.5, 0.0, 1.0], [0.5, 0.0, 0.0], &[Y]),
            end(3, [0.5, 1.0, 1.0], [0.5, 0.0, 0.0], &[Y]),
        ];
        let field = closing(Vec3::zeros(), &sheet).unwrap();
        assert!((field.matrix - Matrix3::from_diagonal(&Vec3::z())).norm() < 1e-12, "{field:?}");
    }

    /// Held rims ask for nothing; free ones are named.
    #[test]
    fn held_rims_are_closed_and_free_ones_named() {
        let place = [1.0, 2.0, 0.0];
        assert!(closing(Vec3::zeros(), &[end(5, place, X, &[X, Y, Z])]).is_ok());
        let rim = [end(6, [1.0, 0.0, 0.0], Y, &[]), end(7, [0.0, 2.0, 1.0], X, &[])];
        assert!(closing(Vec3::zeros(), &rim).is_err());
    }

    /// Edges that two cells share are inside, also where two particles stand for one place; a third cell, or one that faces the other way, makes it
    /// no surface.
    #[test]
    fn rims_are_edges_of_one_cell() {
        let cells = [Cell { corners: [0, 1, 2, 3], count: 4 }, Cell { corners: [4, 5, 6, 6], count: 3 }];
        let apart = rims(cells.iter(), |a| a).unwrap();
        assert_eq!(apart.len(), 7);
        let joined = |a: u32| match a {
            4 => 2,
            5 => 1,
            other => other,
        };
        assert_eq!(rims(cells.iter(), joined).unwrap().len(), 5);
        let turned = Cell { corners: [5, 4, 6, 6], count: 3 };
        assert!(rims([cells[0], turned].iter(), joined).is_err());
        let fin = Cell { corners: [4, 5, 7, 7], count: 3 };
        assert!(rims([cells[0], cells[1], fin].iter(), joined).is_err());
    }
}
