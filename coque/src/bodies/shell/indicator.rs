//! Where the lattice of a shell is too coarse: strains of the cells against what their neighbours make of them \[zienkiewicz1987\].
//!
//! Strains and resultants of the cells round a particle give their mean by area, v_a and w_a, as tensors of space; a cell of strains v and resultants w
//! and area A is off by
//!
//! ```text
//! η² = A/3 · mean over its corners of (v_a − v)·(w_a − w)          a quarter in the place of a third for triangles
//! ```
//!
//! which is what a strain that varies linearly between the corners has beyond its mean. The indicator is √(η²/A) over the root of the mean of v·w over
//! the surface: one where the strain of a cell is off by as much as the shell is strained on average.

use nalgebra::Matrix3;
use sph_core::{Cell, Frame, Vec3};
use sph_shell::{PointResult, Shell};

/// What a linear course between corners has beyond its mean, over the mean of squares at the corners: of quadrangles, of triangles.
const BEYOND: [f64; 2] = [1.0 / 3.0, 1.0 / 4.0];

/// Strains and resultants of a cell or a particle as tensors and vectors of space.
#[derive(Clone, Copy)]
struct Both {
    /// Membrane strains and changes of curvature, membrane forces and moments.
    tensors: [Matrix3<f64>; 4],
    /// Shear strains and forces.
    vectors: [Vec3; 2],
}

impl Both {
    const ZERO: Self = Self {
        tensors: [Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0); 4],
        vectors: [Vec3::new(0.0, 0.0, 0.0); 2],
    };

    fn of(found: &PointResult, frame: &Frame) -> Self {
        let (t1, t2) = (frame.t1, frame.t2);
        let tensor = |[a, b, c]: [f64; 3], shear: f64| {
            t1 * t1.transpose() * a
                + t2 * t2.transpose() * b
                + (t1 * t2.transpose() + t2 * t1.transpose()) * (shear * c)
        };
        let vector = |[a, b]: [f64; 2]| t1 * a + t2 * b;
        Self {
            // Strains have twice the shear.
            tensors: [
                tensor(found.membrane, 0.5),
                tensor(found.curvature, 0.5),
                tensor(found.force, 1.0),
                tensor(found.moment, 1.0),
            ],
            vectors: [vector(found.shear), vector(found.shear_force)],
        }
    }

    /// Adds another one so many times.
    fn add(&mut self, other: &Self, times: f64) {
        self.tensors.iter_mut().zip(&other.tensors).for_each(|(sum, tensor)| *sum += tensor * times);
        self.vectors.iter_mut().zip(&other.vectors).for_each(|(sum, vector)| *sum += vector * times);
    }

    /// Twice the energy of an area \[F/L\].
    fn work(&self) -> f64 {
        let [e, k, n, m] = &self.tensors;
        e.dot(n) + k.dot(m) + self.vectors[0].dot(&self.vectors[1])
    }
}

/// The indicator of each cell \[–\], from strains and resultants at the cells; zero where nothing is strained.
pub(super) fn indicator(shell: &Shell, results: &[PointResult]) -> Vec<f64> {
    let cells = &shell.reference().cloud.cells;
    let points = &shell.reference().operator.points;
    let own: Vec<Both> =
        results.iter().zip(points).map(|(found, point)| Both::of(found, &point.frame)).collect();
    let mut means = vec![(Both::ZERO, 0.0); shell.len()];
    for ((cell, own), point) in cells.iter().zip(&own).zip(points) {
        for &a in cell.particles() {
            let (mean, area) = &mut means[a as usize];
            mean.add(own, point.weight);
            *area += point.weight;
        }
    }
    let off = |(cell, own): (&Cell, &Both)| {
        let corners = cell.particles();
        let sum: f64 = corners
            .iter()
            .map(|&a| {
                let (mean, area) = &means[a as usize];
                let mut off = Both::ZERO;
                off.add(mean, 1.0 / area);
                off.add(own, -1.0);
                off.work().max(0.0)
            })
            .sum();
        BEYOND[usize::from(corners.len() == 3)] * sum / corners.len() as f64
    };
    let (work, area) = own.iter().zip(points).fold((0.0, 0.0), |(work, area), (own, point)| {
        (work + point.weight * own.work(), area + point.weight)
    });
    let scale = if work > 0.0 { area / work } else { 0.0 };
    cells.iter().zip(&own).map(off).map(|density| (density * scale).sqrt()).collect()
}
