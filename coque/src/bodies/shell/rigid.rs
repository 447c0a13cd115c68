//! Which rigid motions the supports leave free: rank of their constraints on the six of them.

use nalgebra::{Matrix6, SymmetricEigen, Vector6};
use sph_core::{Cloud, Vec3};
use sph_shell::{DirectorHold, Holds};

/// Eigenvalues below this part of the largest count as zero: far above rounding, far below any support that
/// holds at least one spacing away from a free axis.
const FREE: f64 = 1e-10;

/// Rigid motions `u = τ + ω × (x − c)`, `δd = ω × d` that violate no support, in words; each sheet of the cloud may
/// move by itself.
pub(crate) fn free_motions(cloud: &Cloud, supports: &[(Vec<u32>, Holds)]) -> Vec<String> {
    let pieces = cloud.pieces();
    let of_piece = |piece: &Vec<u32>| {
        let free = motions_of(cloud, piece, supports);
        if pieces.len() == 1 {
            return free;
        }
        free.into_iter().map(|motion| format!("{motion} of the sheet with particle {}", piece[0])).collect()
    };
    pieces.iter().flat_map(of_piece).collect()
}

/// Free rigid motions of one sheet.
fn motions_of(cloud: &Cloud, piece: &[u32], supports: &[(Vec<u32>, Holds)]) -> Vec<String> {
    let place = |&a: &u32| cloud.positions[a as usize];
    let centre: Vec3 = piece.iter().map(place).sum::<Vec3>() / piece.len() as f64;
    let size = piece.iter().map(|a| (place(a) - centre).norm()).fold(0.0, f64::max);
    // Rows [e, (x − c) × e / size]: what support direction e sees of (τ, ω·size).
    let mut normal = Matrix6::<f64>::zeros();
    let mut row = |translation: Vec3, rotation: Vec3| {
        let row = Vector6::from_iterator(translation.iter().chain(rotation.iter()).copied());
        normal += row * row.transpose();
    };
    for (particles, holds) in supports {
        for &a in particles.iter().filter(|a| piece.binary_search(a).is_ok()) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use sph_core::{Cell, EndWeights, Plate, lattice};
    use sph_shell::{Clamped, Held, Hinged, Support, SymmetryPlane};

    fn free(supports: &[(Vec<u32>, Holds)]) -> Vec<String> {
        let cloud = lattice(&Plate { lengths: [2.0, 1.0] }, [5, 3], EndWeights::Trapezoid).unwrap();
        free_motions(&cloud, supports)
    }

    #[test]
    fn nothing_held_leaves_six() {
        assert_eq!(free(&[]).len(), 6);
    }

    #[test]
    fn a_hinged_edge_turns_about_itself() {
        let hinge = (vec![0, 1, 2], Hinged.holds());
        assert_eq!(free(&[hinge]), ["rotation about the line through [0, 0.5, 0] along [0, 1, 0]"]);
    }

    #[test]
    fn one_clamped_particle_can_still_drill() {
        // The director holds two rotations; the third turns about it.
        assert_eq!(
            free(&[(vec![0], Clamped.holds())]),
            ["rotation about the line through [0, 0, 0] along [0, 0, 1]"]
        );
        assert!(free(&[(vec![0, 1, 2], Clamped.holds())]).is_empty());
    }

    #[test]
    fn two_mirror_planes_leave_their_common_line() {
        let x = (vec![0, 1, 2], SymmetryPlane { normal: Vec3::x() }.holds());
        let y = (vec![0, 3, 6, 9, 12], SymmetryPlane { normal: Vec3::y() }.holds());
        assert_eq!(free(&[x, y]), ["translation along z"]);
    }

    #[test]
    fn held_directions_count_one_by_one() {
        let held = |displacement, director| Held { displacement, director }.holds();
        let down = (vec![0, 2, 14], held(vec![Vec3::z()], None));
        assert_eq!(
            free(std::slice::from_ref(&down)),
            ["translation along x", "translation along y", "rotation about z"]
        );
        let wall = (vec![0, 2], held(vec![Vec3::x()], None));
        assert_eq!(free(&[down, wall]), ["translation along y"]);
        // A director in the plane normal to x does not turn about y.
        let turn = (vec![0], held(vec![Vec3::x(), Vec3::y(), Vec3::z()], Some(Vec3::x())));
        assert_eq!(free(&[turn]).len(), 2);
    }

    #[test]
    fn each_sheet_needs_supports_of_its_own() {
        let plate = lattice(&Plate { lengths: [2.0, 1.0] }, [5, 3], EndWeights::Trapezoid).unwrap();
        let mut positions = plate.positions.clone();
        positions.extend(plate.positions.iter().map(|x| x + Vec3::new(0.0, 0.0, 3.0)));
        let mut cells = plate.cells.clone();
        cells.extend(plate.cells.iter().map(|cell| Cell::quadrangle(cell.corners.map(|b| b + 15))));
        let cloud = Cloud::from_cells(positions, None, cells).unwrap();
        let clamp = |first| (vec![first, first + 1, first + 2], Clamped.holds());
        assert!(free_motions(&cloud, &[clamp(0), clamp(15)]).is_empty());
        let free = free_motions(&cloud, &[clamp(0)]);
        assert_eq!(free.len(), 6);
        assert_eq!(free[0], "translation along x of the sheet with particle 15");
    }
}
