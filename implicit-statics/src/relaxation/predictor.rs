//! The levels behind, and where they point.

use serde::{Deserialize, Serialize};

use crate::Equilibrium;

/// Highest order of the polynomials through the last equilibria.
const HIGHEST: usize = 3;

/// The last equilibria, and the order of the polynomial through them that would have come nearest to the present one.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Past {
    /// Levels and saved states, the present one last.
    points: Vec<(f64, Vec<f64>)>,
    order: usize,
}

impl Past {
    /// Takes note of the state that the system stands in, and tells whether it is the last one found; what lies behind is forgotten
    /// if it is another.
    pub fn stands_at(&mut self, level: f64, state: &[f64]) -> bool {
        let known = self.points.last().is_some_and(|(at, last)| *at == level && last == state);
        if !known {
            *self = Self { points: vec![(level, state.to_vec())], order: 0 };
        }
        known
    }

    /// Lengths of the states behind.
    pub fn lengths(&self) -> impl Iterator<Item = usize> {
        self.points.iter().map(|(_, state)| state.len())
    }

    /// Whether it points anywhere.
    pub fn points_on(&self) -> bool {
        self.order > 0
    }

    /// No longer points anywhere, until the next equilibrium is found.
    pub fn distrust(&mut self) {
        self.order = 0;
    }

    /// The motion to a level from the last equilibrium, where the system stands.
    pub fn predict<E: Equilibrium + ?Sized>(&self, system: &E, level: f64) -> Option<Vec<f64>> {
        self.by(system, level, self.order)
    }

    /// The same by the polynomial of an order: Lagrange's weights over the motions to the points behind. None without a point
    /// for each, or where the system does not tell such motions.
    fn by<E: Equilibrium + ?Sized>(&self, system: &E, level: f64, order: usize) -> Option<Vec<f64>> {
        let first = self.points.len().checked_sub(order + 1).filter(|_| order > 0)?;
        let points = &self.points[first..];
        let (mut sum, mut way) = (vec![0.0; system.unknowns()], vec![0.0; system.unknowns()]);
        for (i, (at, state)) in points[..order].iter().enumerate() {
            let others = points.iter().enumerate().filter(|&(j, _)| j != i);
            let weight: f64 = others.map(|(_, (other, _))| (level - other) / (at - other)).product();
            if !system.motion_to(state, &mut way) {
                return None;
            }
            sum.iter_mut().zip(&way).for_each(|(sum, way)| *sum += weight * way);
        }
        Some(sum)
    }

    /// Takes the equilibrium at which the system stands over, and sees by it which order would have come nearest.
    pub fn found<E: Equilibrium + ?Sized>(&mut self, system: &mut E, level: f64, masses: &[f64]) {
        let here = system.save();
        let mut way = vec![0.0; system.unknowns()];
        if let Some((_, before)) = self.points.last() {
            system.restore(before);
            if system.motion_to(&here, &mut way) {
                self.order = self.nearest(system, level, &way, masses);
            }
            system.restore(&here);
        }
        self.points.push((level, here));
        self.points.drain(..self.points.len().saturating_sub(HIGHEST + 1));
    }

    /// The order that comes nearest to a way from the last equilibrium. One point behind tells none: a line is tried.
    fn nearest<E: Equilibrium + ?Sized>(&self, system: &E, level: f64, way: &[f64], masses: &[f64]) -> usize {
        let off = |guess: &[f64]| -> f64 {
            guess.iter().zip(way).zip(masses).map(|((guess, way), mass)| mass * (guess - way).powi(2)).sum()
        };
        let mut best = (off(&vec![0.0; way.len()]), usize::from(self.points.len() == 1));
        for order in 1..=HIGHEST {
            let Some(guess) = self.by(system, level, order) else { break };
            let miss = off(&guess);
            if miss < best.0 {
                best = (miss, order);
            }
        }
        best.1
    }
}
