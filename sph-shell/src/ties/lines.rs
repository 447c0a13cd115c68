//! In which direction an edge runs.

use nalgebra::{Matrix3, SymmetricEigen};
use sph_core::{Cloud, Vec3};

/// Direction of an edge at each of its particles, as long as its edges on both sides, of either sign; nothing at others.
///
/// Those of a junction have one line, from neighbour to neighbour where there are two, so also around a corner. Of more, those count that run
/// along the first axis of all, as far as they do.
pub(super) fn lines(cloud: &Cloud, edge: &[u32]) -> Vec<Vec3> {
    let count = cloud.len();
    let mut on_edge = vec![false; count];
    edge.iter().filter(|&&a| (a as usize) < count).for_each(|&a| on_edge[a as usize] = true);
    let mut first: Vec<usize> = (0..count).collect();
    for group in &cloud.joined {
        group.iter().for_each(|&a| first[a as usize] = group[0] as usize);
    }
    let mut arms: Vec<Vec<(usize, Vec3)>> = vec![Vec::new(); count];
    for (a, b) in cloud.cells.iter().flat_map(|cell| cell.edges()) {
        let [a, b] = [a as usize, b as usize];
        if on_edge[a] && on_edge[b] {
            for (from, to) in [(a, b), (b, a)] {
                let arms = &mut arms[first[from]];
                if !arms.iter().any(|arm| arm.0 == first[to]) {
                    arms.push((first[to], cloud.positions[to] - cloud.positions[from]));
                }
            }
        }
    }
    (0..count).map(|a| if on_edge[a] { line(&arms[first[a]]) } else { Vec3::zeros() }).collect()
}

/// The line of the arms of one particle.
fn line(arms: &[(usize, Vec3)]) -> Vec3 {
    match arms {
        [] => Vec3::zeros(),
        [one] => one.1,
        [one, other] => one.1 - other.1,
        _ => {
            let squares = arms.iter().map(|(_, arm)| arm * arm.transpose()).sum::<Matrix3<f64>>();
            let axes = SymmetricEigen::new(squares);
            let axis: Vec3 = axes.eigenvectors.column(axes.eigenvalues.imax()).into();
            arms.iter().map(|(_, arm)| arm * (arm.dot(&axis) / arm.norm())).sum()
        }
    }
}
