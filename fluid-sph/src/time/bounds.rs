//! What a fluid may not leave: the speed of sound, its density, its domain.

use explicit_dynamics::{OutOfBounds, OutOfRange};
use sph_core::Vec3;

use crate::fluid::Fluid;
use crate::sharing::moving;
use crate::start::outside;

impl Fluid {
    /// The particles that this one moves.
    fn own(&self) -> impl Iterator<Item = usize> {
        let moves = moving(&self.share, &self.openings);
        (0..self.present.densities.len()).filter(|&i| moves.get(i).is_none_or(|moves| *moves))
    }

    pub(super) fn check_speeds(&self) -> Result<(), OutOfBounds> {
        let bound = self.liquid.sound_speed;
        let square = |i: usize| {
            let square = self.present.velocities[i].norm_squared();
            (if square.is_nan() { f64::INFINITY } else { square }, self.share.number(i))
        };
        let fastest = self.own().map(square).reduce(|best, next| if next.0 > best.0 { next } else { best });
        let (square, particle) = self.share.greatest_of(fastest).unwrap_or((0.0, 0));
        let speed = square.sqrt();
        if speed <= bound { Ok(()) } else { Err(OutOfBounds::Speed { particle, speed, bound }) }
    }

    /// The first particle for which something holds.
    fn first(&self, holds: impl Fn(usize) -> bool) -> Option<usize> {
        // Numbers are exact as values; the least is the greatest of their opposites.
        let number = |i: usize| (-(self.share.number(i) as f64), self.share.number(i));
        self.share.greatest_of(self.own().find(|&i| holds(i)).map(number)).map(|(_, particle)| particle)
    }

    pub(super) fn check_configuration(&self) -> Result<(), OutOfBounds> {
        let place = |particle: usize| format!("particle {particle}");
        let ratio = |i: usize| self.present.densities[i] / self.liquid.density;
        if let Some(particle) = self.first(|i| !(0.5..=2.0).contains(&ratio(i))) {
            let [value] = self.share.reported(particle, |i| [ratio(i)]);
            let bound = "between 0.5 and 2: raise the speed of sound or refine";
            return Err(OutOfRange {
                place: place(particle),
                what: "density over that at rest",
                value,
                bound,
            }
            .into());
        }
        if let Some(domain) = &self.domain {
            let positions = &self.present.positions;
            let outside = |at: &Vec3| outside(self.dimensions, domain, at);
            if let Some(particle) = self.first(|i| outside(&positions[i])) {
                let [low, high] = domain;
                let at = self.share.reported(particle, |i| positions[i].into());
                let beyond = |k: &usize| !(at[*k] >= low[*k] && at[*k] <= high[*k]);
                let axis = (0..self.dimensions).find(beyond).unwrap_or(0);
                let what = ["first coordinate", "second coordinate", "third coordinate"][axis];
                let bound = "inside the domain: close the walls or enlarge the domain";
                return Err(OutOfRange { place: place(particle), what, value: at[axis], bound }.into());
            }
        }
        if self.openings.as_ref().is_some_and(|openings| openings.full) {
            let (place, what, value) = ("the fluid".to_owned(), "number of particles", self.len() as f64);
            let bound =
                "less than it has room for: more comes in than goes out; give it more room (most_particles)";
            return Err(OutOfRange { place, what, value, bound }.into());
        }
        if let Some((value, _)) = self.collapsed() {
            let (place, what) = ("the fluid".to_owned(), "stable step");
            let bound = "at least 1e-4 h/c of a quiet fluid: particles collide or boundaries move too fast";
            return Err(OutOfRange { place, what, value, bound }.into());
        }
        Ok(())
    }
}
