//! A rule about beams of thin walls: profiles with too few cells a wall to bend in the planes of their walls.

use std::collections::HashSet;

use nalgebra::{Matrix2, Vector2};
use sph_core::{Cell, Cloud, Vec3};

use super::look::Look;
use super::tied::{Tied, place};

/// Part of the bending stiffness of a profile that may be missing. Of an I-beam with eight cells a plate 1.6 % is; lateral buckling,
/// in which bending, warping and twist are too soft at once, then comes more than 2 % too early.
const LOSS: f64 = 0.015;
/// Length of the body over the size of its profile from which it is a beam.
const SLENDER: f64 = 3.0;
/// Bound on how far a profile may stand out of its plane, in its size: what winds through a mesh is no cross-section.
const FLAT: f64 = 0.05;

/// Profiles that bend too easily.
pub(super) fn profile(look: &Look<'_>) -> Option<String> {
    profile_of(&look.cloud(), &look.across)
}

/// The same of a cloud alone.
///
/// One point a cell knows the mean stretch of the cell: of the second moment of a profile, `∫yyᵀ ds`, the own part of each cell,
/// `h hᵀ|h|/12` with h across the cell, is missing. Of one wall of n cells that is 1/n², of an I-beam about its weak axis as much,
/// about the other a fifth of it. Walls count as equally thick.
pub(super) fn profile_of(cloud: &Cloud, across: &[[u32; 4]]) -> Option<String> {
    let tied = Tied::of(cloud, across)?;
    let mut known = HashSet::new();
    let mut worst: Option<(f64, usize)> = None;
    for &(cell, edge) in tied.cells_at.values().flatten() {
        let Some(cut) = tied.cut(cell, edge % 2, &mut known) else { continue };
        let (loss, at) = (tied.loss(&cut), cut.iter().map(|wall| wall.0).min()?);
        // The first of equal profiles, whatever the order of the map.
        let more = |(most, first): (f64, usize)| loss > most + 1e-9 || (loss > most - 1e-9 && at < first);
        if worst.is_none_or(more) {
            worst = Some((loss, at));
        }
    }
    let (loss, at) = worst.filter(|(loss, _)| *loss > LOSS)?;
    Some(format!(
        "a profile of thin walls (the cut at {}) has too few cells a wall: one point a cell sees no bending in its plane, and bent \
         about its weak axis the profile may be {:.1} % too soft, in lateral buckling more; the error falls with the square of the cells, {:.1} times \
         as many a wall leave 1 %",
        place(&cloud.cells[at].geometry(&cloud.positions).centroid),
        100.0 * loss,
        (100.0 * loss).sqrt()
    ))
}

impl Tied<'_> {
    /// Cells, each with the first of the two opposite edges crossed, that are reached from one by crossing edges and junctions: a
    /// cut through all walls. None where it was made before, meets a triangle, or meets a cell both ways.
    fn cut(
        &self,
        cell: usize,
        way: usize,
        known: &mut HashSet<(usize, usize)>,
    ) -> Option<Vec<(usize, usize)>> {
        let (mut found, mut next, mut sound) = (Vec::new(), vec![(cell, way)], true);
        while let Some((c, way)) = next.pop() {
            if !known.insert((c, way)) {
                continue;
            }
            let cell = &self.cloud.cells[c];
            if cell.count != 4 {
                sound = false;
                continue;
            }
            found.push((c, way));
            for (i, edge) in cell.edges().enumerate().filter(|(i, _)| i % 2 == way) {
                if let Some(all) = self.places(edge).and_then(|places| self.cells_at.get(&places)) {
                    next.extend(all.iter().map(|&(c, i)| (c, i % 2)));
                }
                let other = self.across[c][i] as usize;
                let back = self.across.get(other).and_then(|row| row.iter().position(|&d| d as usize == c));
                next.extend(back.map(|i| (other, i % 2)));
            }
        }
        let cells: HashSet<usize> = found.iter().map(|cell| cell.0).collect();
        (sound && !found.is_empty() && cells.len() == found.len()).then_some(found)
    }

    /// The part of the bending stiffness that is missing about the axis for which it is most; zero where the cut is not the profile
    /// of a beam.
    fn loss(&self, cut: &[(usize, usize)]) -> f64 {
        let corner = |cell: &Cell, i: usize| self.cloud.positions[cell.corners[i % 4] as usize];
        let (mut along, mut walls) = (Vec3::zeros(), Vec::new());
        for &(c, way) in cut {
            let cell = &self.cloud.cells[c];
            let [p, q, r, s] = [0, 1, 2, 3].map(|i| corner(cell, way + i));
            let edges = (q - p) + (r - s);
            along += if along.dot(&edges) < 0.0 { -edges } else { edges };
            walls.push(((p + q + r + s) / 4.0, (r + s - p - q) / 2.0));
        }
        let Some(along) = along.try_normalize(0.0) else { return 0.0 };
        let first =
            walls.iter().map(|wall| wall.1.cross(&along)).max_by(|a, b| a.norm().total_cmp(&b.norm()));
        let Some(one) = first.and_then(|across| across.try_normalize(0.0)) else { return 0.0 };
        let flat = |x: &Vec3| Vector2::new(x.dot(&one), x.dot(&along.cross(&one)));
        let whole: f64 = walls.iter().map(|wall| wall.1.norm()).sum();
        let middle = walls.iter().map(|wall| wall.0 * wall.1.norm()).sum::<Vec3>() / whole;
        let (mut seen, mut missing) = (Matrix2::zeros(), Matrix2::zeros());
        let (mut size, mut out) = (0.0_f64, 0.0_f64);
        for (centre, width) in &walls {
            let (arm, own) = (flat(&(centre - middle)), flat(width));
            seen += arm * arm.transpose() * width.norm();
            missing += own * own.transpose() * (width.norm() / 12.0);
            size = size.max(2.0 * (arm.norm() + 0.5 * own.norm()));
            out = out.max((centre - middle).dot(&along).abs());
        }
        let reach = self.cloud.positions.iter().map(|x| x.dot(&along));
        let (low, high) = reach.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        if out > FLAT * size || high - low < SLENDER * size {
            return 0.0;
        }
        // λ in missing − λ (seen + missing): with S = seen + missing = L Lᵀ, the eigenvalues of L⁻¹ missing L⁻ᵀ.
        let Some(root) = (seen + missing).cholesky().and_then(|factor| factor.l().try_inverse()) else {
            return 0.0;
        };
        (root * missing * root.transpose()).symmetric_eigenvalues().max()
    }
}
