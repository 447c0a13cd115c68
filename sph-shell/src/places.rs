//! Places of a shell by which others hold it: its particles, and behind them its directors, as places of unit length.
//!
//! A force on a director is a couple on its particle, `d × n` by what turns it \[F L\]; its mass is a rotary inertia \[M L²\].

use crate::Shell;
use crate::motion::row_of;

impl Shell {
    /// Whether nothing but the particle turns its director: neither ties nor a rigid set.
    pub fn turns_by_itself(&self, particle: usize) -> bool {
        let dependents = &self.dependents;
        dependents.ties.of(particle).is_none() && dependents.junctions.body_of(particle).is_none()
    }

    /// A place by its number \[L, of a director –\].
    pub(crate) fn place_numbered(&self, number: u32) -> [f64; 3] {
        match row_of(number, self.len()) {
            (a, 0) => self.position(a).into(),
            (a, _) => self.director(a).into(),
        }
    }
}
