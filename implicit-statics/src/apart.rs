//! How far two states of a system are apart, over the way to one of them.

use crate::Equilibrium;
use crate::vectors::{difference, dot};

/// How far the present state is from the one found, over the way there: by motions, since a history has
/// units of its own; by states where motions are not offered.
pub(crate) fn apart<E: Equilibrium + ?Sized>(
    system: &E,
    found: &[f64],
    motion: &[f64],
    begun: &[f64],
) -> f64 {
    let over = |rest: &[f64], way: &[f64]| (dot(rest, rest) / dot(way, way)).sqrt();
    let mut rest = vec![0.0; motion.len()];
    if system.motion_to(found, &mut rest) {
        return over(&rest, motion);
    }
    over(&difference(&system.save(), found), &difference(found, begun))
}
