//! Which rigid motions are left free: rank of what is held on the six of them.

use nalgebra::{Matrix6, SymmetricEigen, Vector6};
use sph_core::Vec3;

/// Eigenvalues below this part of the largest count as zero: far above rounding, far below any support that
/// holds at least one spacing away from a free axis.
const FREE: f64 = 1e-10;

/// One thing that a support holds.
pub(crate) enum Hold {
    /// The displacement of a particle along a direction.
    Displacement(u32, Vec3),
    /// The displacement along a direction of a point that goes with them.
    DisplacementAt(Vec3, Vec3),
    /// A turn about an axis.
    Turn(Vec3),
}

/// Rigid motions `u = τ + ω × (x − c)` of some particles that violate nothing that is held, in words.
pub(crate) fn free_of(positions: &[Vec3], piece: &[u32], holds: &[Hold]) -> Vec<String> {
    let place = |&a: &u32| positions[a as usize];
    let centre: Vec3 = piece.iter().map(place).sum::<Vec3>() / piece.len() as f64;
    let size = piece.iter().map(|a| (place(a) - centre).norm()).fold(0.0, f64::max);
    // Rows [e, (x − c) × e / size]: what support direction e sees of (τ, ω·size).
    let mut normal = Matrix6::<f64>::zeros();
    let mut row = |translation: Vec3, rotation: Vec3| {
        let row = Vector6::from_iterator(translation.iter().chain(rotation.iter()).copied());
        normal += row * row.transpose();
    };
    for hold in holds {
        match hold {
            Hold::Displacement(a, e) => row(*e, ((place(a) - centre) / size).cross(e)),
            Hold::DisplacementAt(x, e) => row(*e, ((x - centre) / size).cross(e)),
            Hold::Turn(axis) => row(Vec3::zeros(), *axis),
        }
    }
    let eigen = SymmetricEigen::new(normal);
    let bound = FREE * eigen.eigenvalues.max();
    let free: Vec<Vector6<f64>> = (0..6)
        .filter(|&i| eigen.eigenvalues[i] <= bound)
        .map(|i| eigen.eigenvectors.column(i).into_owned())
        .collect();
    name(&free, &centre, size)
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
