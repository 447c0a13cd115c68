//! What a contact between bodies does now, to be read.

use contact::Felt;
use sph_core::Vec3;

use super::contact::TouchingBodies;
use crate::bodies::{ContactNow, With};

impl TouchingBodies {
    /// The bodies that touch, the first side first.
    fn bodies(&self) -> [usize; 2] {
        let mut own = (0..self.particles.len()).filter(|&body| !self.particles[body].is_empty());
        std::array::from_fn(|_| own.next().unwrap_or_default())
    }

    /// Adds what each particle of a body feels, where it is one of the two.
    pub fn felt(&self, body: usize, felt: &mut [Felt]) {
        let Some(side) = self.bodies().iter().position(|own| *own == body) else { return };
        let mut own = vec![Felt::default(); felt.len()];
        self.contact.felt(side, &mut own);
        felt.iter_mut().zip(&own).for_each(|(sum, own)| sum.join(own));
    }

    /// Gaps at some particles of a body, where it is one of the two, all particles of a body being at `places` \[L\].
    pub fn gaps(
        &self,
        body: usize,
        particles: &[u32],
        places: impl Fn(usize) -> Vec<Vec3>,
    ) -> Option<Vec<f64>> {
        let bodies = self.bodies();
        let side = bodies.iter().position(|own| *own == body)?;
        let at = bodies.map(places);
        Some(self.contact.gaps(side, particles, |(side, a)| at[side][a as usize]))
    }

    /// What it does now, all particles of a body being at `places` \[L\].
    pub fn now(&self, places: impl Fn(usize) -> Vec<Vec3>) -> ContactNow {
        let bodies = self.bodies();
        let place = (self.touch.greatest_depth > ContactNow::DEEP).then(|| {
            let at = bodies.map(places);
            Some(self.contact.deepest(|(side, a)| at[side][a as usize])?.places[0])
        });
        ContactNow {
            body: bodies[0],
            with: With::Body(bodies[1]),
            stiffness: self.contact.touching().stiffness,
            by_thickness: None,
            depth: self.touch.greatest_depth,
            area: self.touch.area,
            place: place.flatten(),
        }
    }
}
