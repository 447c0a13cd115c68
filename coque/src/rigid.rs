//! Which rigid motions the supports leave free: rank of their constraints on the six of them.

use nalgebra::{Matrix6, SymmetricEigen, Vector6};
use sph_core::{Cloud, Vec3};
use sph_shell::{DirectorHold, Holds};

/// Eigenvalues below this part of the largest count as nought: far above rounding, far below any support that
/// holds at least one spacing away from a free axis.
const FREE: f64 = 1e-10;

/// Rigid motions `u = τ + ω × (x − c)`, `δd = ω × d` that violate no support, in words.
pub(crate) fn free_motions(cloud: &Cloud, supports: &[(Vec<u32>, Holds)]) -> Vec<String> {
    let centre: Vec3 = cloud.positions.iter().sum::<Vec3>() / cloud.len() as f64;
    let size = cloud.positions.iter().map(|x| (x - centre).norm()).fold(0.0, f64::max);
    // Rows [e, (x − c) × e / size]: what support direction e sees of (τ, ω·size).
    let mut normal = Matrix6::<f64>::zeros();
    let mut row = |translation: Vec3, rotation: Vec3| {
        let row = Vector6::from_iterator(translation.iter().chain(rotation.iter()).copied());
        normal += row * row.transpose();
    };
    for (particles, holds) in supports {
        for &a in particles {
            let arm = (cloud.positions[a as usize] - centre) / size;
            let d = cloud.frames[a as usize].n;
            for e in &holds.translations {
                row(*e, arm.cross(e));
            }
            match holds.director {
                DirectorHold::Free => {}
                DirectorHold::InPlane(n) => row(Vec3::zeros(), d.cross(&n)),
                DirectorHold::Fixed => {
                    let frame = cloud.frames[a as usize];
                    row(Vec3::zeros(), frame.t1);
                    row(Vec3::zeros(), frame.t2);
                }
            }
        }
    }
    let eigen = SymmetricEigen::new(normal);
    let bound = FREE * eigen.eigenvalues.max();
    let free: Vec<Vector6<f64>> = (0..6)
        .filter(|&i| eigen.eigenvalues[i] <= bound)
        .map(|i| eigen.eigenvectors.column(i).into_owned())
        .collect();
    name(&free)
}

/// Names a space of free motions by the canonical ones in it, or else by its own vectors.
fn name(free: &[Vector6<f64>]) -> Vec<String> {
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
        let (kind, axis) = if turn.norm() < 1e-6 {
            ("translation along", shift)
        } else {
            ("rotation about an axis along", turn)
        };
        let axis = axis / axis.amax();
        format!("{kind} [{:.3}, {:.3}, {:.3}]", axis.x + 0.0, axis.y + 0.0, axis.z + 0.0)
    };
    free.iter().map(describe).collect()
}
