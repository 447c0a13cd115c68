//! A fluid that goes round through periodic sides: places in its box, ways across its sides.

use sph_core::Vec3;

use crate::fluid::Fluid;
use crate::periods::{Periodic, Periods};

impl Fluid {
    /// The box of its periodic sides.
    pub fn periods(&self) -> Option<&Periods> {
        self.periodic.as_ref().map(|periodic| &periodic.periods)
    }

    /// The place in the box of periodic sides that a place is \[L\].
    pub fn within(&self, at: Vec3) -> Vec3 {
        self.periods().map_or(at, |periods| at + periods.back(&at))
    }

    /// The shortest of the ways that a way is across periodic sides \[L\].
    pub(crate) fn shortest(&self, way: Vec3) -> Vec3 {
        self.periods().map_or(way, |periods| periods.shortest(way))
    }

    /// Gravity without its components along periodic axes, which weigh on nothing \[L/T²\].
    pub fn gravity_across(&self) -> Vec3 {
        self.periods().map_or(self.gravity, |periods| periods.across(&self.gravity))
    }

    /// The way of a particle from its place at the start, through periodic sides \[L\].
    pub fn displacement(&self, particle: usize) -> Vec3 {
        let first = self.openings.as_ref().map_or(&self.rest, |openings| &openings.since);
        let here = self.positions()[particle] - first[particle];
        let Some(Periodic { periods, gone }) = &self.periodic else { return here };
        here + periods.lengths.component_mul(&Vec3::from(gone[particle]))
    }

    /// Takes particles that have left by periodic sides in by the opposite ones.
    pub(crate) fn go_round(&mut self) {
        let Some(Periodic { periods, gone }) = &mut self.periodic else { return };
        for (position, gone) in self.present.positions.iter_mut().zip(gone) {
            let beyond = periods.beyond(position);
            if beyond == [0.0; 3] {
                continue;
            }
            *position += periods.back(position);
            for k in 0..3 {
                gone[k] += beyond[k];
                // Rounding must not leave it on the far side.
                if beyond[k] < 0.0 && position[k] >= periods.low[k] + periods.lengths[k] {
                    position[k] = periods.low[k];
                    gone[k] += 1.0;
                }
            }
        }
    }
}
