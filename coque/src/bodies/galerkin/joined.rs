//! A Galerkin solid beside other bodies: all of it is that of the solid.

use implicit_statics::Joinable;

use super::solid::GalerkinSolid;

impl Joinable for GalerkinSolid {
    fn places(&self, particles: &[u32], out: &mut [[f64; 3]]) {
        self.galerkin.places(particles, out);
    }

    fn put(&mut self, level: f64) {
        Joinable::put(&mut self.galerkin, level);
    }

    fn release(&mut self) {
        self.galerkin.release();
    }

    fn exert(&mut self, particles: &[u32], forces: &[[f64; 3]]) {
        self.galerkin.exert(particles, forces);
    }

    fn motion_of(&self, particle: u32) -> Vec<(usize, [f64; 3])> {
        self.galerkin.motion_of(particle)
    }
}
