//! Particles that overlap are refused.

use sph_core::Vec3;

use crate::error::FluidError;
use crate::fluid::Fluid;

/// Distance below which particles overlap, in spacings.
const OVERLAP: f64 = 0.5;

impl Fluid {
    /// Refuses particles of the fluid too near to each other or to a boundary.
    pub(crate) fn check_overlap(&self) -> Result<(), FluidError> {
        let bound = OVERLAP * self.spacing;
        let too_near = |a: &Vec3, b: &Vec3| (a - b).norm() < bound;
        let positions = &self.present.positions;
        for (particle, at) in positions.iter().enumerate() {
            let cell = self.grid.cell(&(*at).into());
            let refuse = |other: String, place: &Vec3| {
                let distance = (at - place).norm() / self.spacing;
                Err(FluidError::Overlap { particle, other, distance })
            };
            for &(from, to) in self.grid.beside(cell, &self.sorted.starts).filled() {
                let near =
                    |&&other: &&u32| other as usize > particle && too_near(at, &positions[other as usize]);
                if let Some(&other) = self.sorted.order[from as usize..to as usize].iter().find(near) {
                    return refuse(format!("particle {other} of the fluid"), &positions[other as usize]);
                }
            }
            let boundary = &self.boundary;
            for &(from, to) in self.grid.beside(cell, &boundary.sorted.starts).filled() {
                let near = |&&other: &&u32| too_near(at, &boundary.points[other as usize]);
                if let Some(&other) = boundary.sorted.order[from as usize..to as usize].iter().find(near) {
                    return refuse(boundary.name(other as usize), &boundary.points[other as usize]);
                }
            }
        }
        Ok(())
    }
}
