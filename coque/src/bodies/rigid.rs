//! Which rigid motions are left free: rank of what is held on the six of them.

use nalgebra::{DMatrix, DVector, Matrix6, SymmetricEigen, Vector6};
use sph_core::Vec3;

/// Eigenvalues below this part of the largest count as zero: far above rounding, far below any support that
/// holds at least one spacing away from a free axis.
const FREE: f64 = 1e-10;

/// One thing that a support holds.
#[derive(Clone, Copy)]
pub(crate) enum Hold {
    /// The displacement of a particle along a direction.
    Displacement(u32, Vec3),
    /// The displacement along a direction of a point that goes with them.
    DisplacementAt(Vec3, Vec3),
    /// A turn about an axis.
    Turn(Vec3),
}

/// A place that goes with the piece of a particle.
#[derive(Clone, Copy)]
pub(crate) struct End {
    /// The particle.
    pub particle: u32,
    /// The place at rest \[L\].
    pub at: Vec3,
}

/// A spring between two places along a direction.
pub(crate) struct Link {
    /// The places.
    pub ends: [End; 2],
    /// Unit vector.
    pub along: Vec3,
}

/// A piece in its own measures.
struct Piece {
    centre: Vec3,
    size: f64,
}

impl Piece {
    fn of(positions: &[Vec3], piece: &[u32]) -> Self {
        let place = |&a: &u32| positions[a as usize];
        let centre: Vec3 = piece.iter().map(place).sum::<Vec3>() / piece.len() as f64;
        let size = piece.iter().map(|a| (place(a) - centre).norm()).fold(0.0, f64::max);
        Self { centre, size }
    }

    /// What the displacement along e at a place sees of (τ, ω·size): `[e, (x − c) × e/size]`.
    fn row(&self, x: &Vec3, e: &Vec3) -> Vector6<f64> {
        both(e, &((x - self.centre) / self.size).cross(e))
    }
}

fn both(translation: &Vec3, rotation: &Vec3) -> Vector6<f64> {
    Vector6::from_iterator(translation.iter().chain(rotation.iter()).copied())
}

/// Rigid motions `u = τ + ω × (x − c)` of some particles that violate nothing that is held, in words.
pub(crate) fn free_of(positions: &[Vec3], piece: &[u32], holds: Vec<Hold>) -> Vec<String> {
    free_of_pieces(positions, &[piece.to_vec()], &[holds], &[]).into_iter().flatten().collect()
}

/// The same of pieces, each for itself, that stretch no link between two.
pub(crate) fn free_of_pieces(
    positions: &[Vec3],
    pieces: &[Vec<u32>],
    holds: &[Vec<Hold>],
    links: &[Link],
) -> Vec<Vec<String>> {
    let all: Vec<Piece> = pieces.iter().map(|piece| Piece::of(positions, piece)).collect();
    let of = |particle: u32| pieces.iter().position(|piece| piece.binary_search(&particle).is_ok());
    let mut joined: Vec<usize> = (0..pieces.len()).collect();
    let mut rows: Vec<Vec<(usize, Vector6<f64>)>> = Vec::new();
    for (i, (piece, holds)) in all.iter().zip(holds).enumerate() {
        rows.extend(holds.iter().map(|hold| {
            let row = match hold {
                Hold::Displacement(a, e) => piece.row(&positions[*a as usize], e),
                Hold::DisplacementAt(x, e) => piece.row(x, e),
                Hold::Turn(axis) => both(&Vec3::zeros(), axis),
            };
            vec![(i, row)]
        }));
    }
    for Link { ends, along } in links {
        let [Some(i), Some(j)] = ends.map(|end| of(end.particle)) else { continue };
        rows.push(vec![(i, -all[i].row(&ends[0].at, along)), (j, all[j].row(&ends[1].at, along))]);
        let (from, to) = (joined[i].max(joined[j]), joined[i].min(joined[j]));
        joined.iter_mut().filter(|group| **group == from).for_each(|group| *group = to);
    }
    let mut free = vec![Vec::new(); pieces.len()];
    for group in 0..pieces.len() {
        let members: Vec<usize> = (0..pieces.len()).filter(|&i| joined[i] == group).collect();
        if members.is_empty() {
            continue;
        }
        let mut normal = DMatrix::<f64>::zeros(6 * members.len(), 6 * members.len());
        for row in rows.iter().filter(|row| members.contains(&row[0].0)) {
            let mut whole = DVector::<f64>::zeros(6 * members.len());
            for (i, part) in row {
                let Ok(place) = members.binary_search(i) else { continue };
                let mut own = whole.fixed_rows_mut::<6>(6 * place);
                own += part;
            }
            normal.ger(1.0, &whole, &whole, 1.0);
        }
        let eigen = SymmetricEigen::new(normal);
        let bound = FREE * eigen.eigenvalues.max();
        let loose: Vec<usize> = (0..6 * members.len()).filter(|&i| eigen.eigenvalues[i] <= bound).collect();
        for (place, &i) in members.iter().enumerate() {
            let parts = loose.iter().map(|&k| {
                let column = eigen.eigenvectors.column(k);
                column.fixed_rows::<6>(6 * place).into_owned()
            });
            free[i] = name(&spanned(parts, members.len() > 1), &all[i].centre, all[i].size);
        }
    }
    free
}

/// Orthonormal vectors of the space that some span: themselves where they are all of it, else those of one piece of several.
fn spanned(parts: impl Iterator<Item = Vector6<f64>>, several: bool) -> Vec<Vector6<f64>> {
    if !several {
        return parts.collect();
    }
    let square = parts.fold(Matrix6::zeros(), |sum: Matrix6<f64>, v| sum + v * v.transpose());
    let eigen = SymmetricEigen::new(square);
    let kept = (0..6).filter(|&i| eigen.eigenvalues[i] > FREE.sqrt());
    kept.map(|i| eigen.eigenvectors.column(i).into_owned()).collect()
}

/// Names a space of free motions by the canonical ones in it, or else by its own vectors.
fn name(free: &[Vector6<f64>], centre: &Vec3, size: f64) -> Vec<String> {
    let canonical = [
        "translation along x",
        "translation along y",
        "translation along z",
        "rotation about x",
        "rotation about y",
        "rotation about z",
    ];
    // A canonical motion is free when it lies in the space: its projection keeps its length.
    let known: Vec<String> = (0..6)
        .filter(|&i| free.iter().map(|v| v[i] * v[i]).sum::<f64>() > 1.0 - 1e-6)
        .map(|i| canonical[i].to_string())
        .collect();
    if known.len() == free.len() {
        return known;
    }
    let describe = |v: &Vector6<f64>| {
        let (shift, turn) = (v.fixed_rows::<3>(0).into_owned(), v.fixed_rows::<3>(3).into_owned());
        if turn.norm() < 1e-6 {
            return format!("translation along {}", text(&direction(&shift)));
        }
        let axis = centre + turn.cross(&shift) * (size / turn.norm_squared());
        format!("rotation about the line through {} along {}", text(&axis), text(&direction(&turn)))
    };
    free.iter().map(describe).collect()
}

/// A vector scaled so that its greatest component is one.
fn direction(v: &Vec3) -> Vec3 {
    v / v[v.iamax()]
}

fn text(v: &Vec3) -> String {
    // Adding zero turns −0 into 0.
    let [x, y, z] = [v.x, v.y, v.z].map(|c| (c * 1e3).round() / 1e3 + 0.0);
    format!("[{x}, {y}, {z}]")
}
