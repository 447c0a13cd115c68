//! Particles that overlap are refused.

use sph_core::Vec3;

use crate::error::FluidError;
use crate::fluid::Fluid;
use crate::sorted::opposite;

/// Distance below which particles overlap, in spacings.
const OVERLAP: f64 = 0.5;

impl Fluid {
    /// Refuses particles of the fluid too near to each other or to a boundary.
    pub(crate) fn check_overlap(&self) -> Result<(), FluidError> {
        let bound = OVERLAP * self.spacing;
        let too_near = |a: &Vec3, b: &Vec3| (a - b).norm() < bound;
        let positions = &self.present.positions;
        let standing = |number: usize| self.copies.place(number, |i| positions[i]);
        for (particle, at) in positions.iter().enumerate() {
            let cell = self.grid.cell(&(*at).into());
            let refuse = |other: String, place: &Vec3| {
                let distance = (at - place).norm() / self.spacing;
                Err(FluidError::Overlap { particle, other, distance })
            };
            for &(from, to) in self.grid.beside(cell, &self.sorted.starts).filled() {
                let near =
                    |&&other: &&u32| other as usize > particle && too_near(at, &standing(other as usize));
                if let Some(&other) = self.sorted.order[from as usize..to as usize].iter().find(near) {
                    let own = self.copies.source(other as usize);
                    return refuse(format!("particle {own} of the fluid"), &standing(other as usize));
                }
            }
            let (boundary, mut sees) = (&self.boundary, 0);
            boundary.thin.iter().for_each(|thin| sees |= thin.sees((*at).into())[0]);
            for &(from, to) in self.grid.beside(cell, &boundary.sorted.starts).filled() {
                for slot in from as usize..to as usize {
                    let other = boundary.sorted.order[slot] as usize;
                    // Rows behind the other face of a thin structure may stand in the fluid of this one.
                    let hidden =
                        boundary.sorted.faces.get(slot).is_some_and(|&face| opposite(face) & sees != 0);
                    let place = boundary.copies.place(other, |i| boundary.points[i]);
                    if !hidden && too_near(at, &place) {
                        return refuse(boundary.name(boundary.copies.source(other)), &place);
                    }
                }
            }
        }
        Ok(())
    }
}
