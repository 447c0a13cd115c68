//! How supports of systems lead the places of what acts between them.

use super::interaction::Joinable;
use super::system::Several;
use crate::equilibrium::Equilibrium;

/// Part of a level over which places are differentiated: those of a straight motion are right to rounding, those of a turn to its square.
const PART: f64 = 1e-3;

impl<S: Joinable + ?Sized> Several<S> {
    /// The ways of all places by a unit of level at fixed unknowns \[L\], interaction by interaction; nothing for one that does not ask.
    pub(super) fn led(&mut self, level: f64) -> Vec<Vec<[f64; 3]>> {
        let asks = self.acting.iter().any(|acting| acting.interaction().is_led());
        if !asks || !self.has_moving_supports() {
            return vec![Vec::new(); self.acting.len()];
        }
        let mut seen = |level: f64| -> Vec<Vec<[f64; 3]>> {
            let Self { systems, acting, .. } = self;
            systems.iter_mut().for_each(|system| system.put(level));
            let places = |acting: &mut super::acting::Acting| match acting.interaction().is_led() {
                true => acting.seen(systems),
                false => Vec::new(),
            };
            acting.iter_mut().map(places).collect()
        };
        let (before, after) = (seen(level - PART), seen(level + PART));
        let way = |(a, b): (&[f64; 3], &[f64; 3])| std::array::from_fn(|k| (b[k] - a[k]) / (2.0 * PART));
        let ways = |(a, b): (&Vec<[f64; 3]>, &Vec<[f64; 3]>)| a.iter().zip(b).map(way).collect();
        before.iter().zip(&after).map(ways).collect()
    }
}
