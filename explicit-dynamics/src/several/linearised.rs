//! Several systems in mass-scaled coordinates, one behind the other.

use std::ops::Range;

use super::interaction::Joinable;
use super::system::Several;
use crate::linearised::{LinearisedDynamics, MassScaled};

impl<S: Joinable + ?Sized> Several<S> {
    /// Where the coordinates of each system stand.
    fn ranges(&self) -> Vec<Range<usize>> {
        let mut end = 0;
        let range = |unknowns: usize| {
            end += unknowns;
            end - unknowns..end
        };
        self.systems.iter().map(|system| LinearisedDynamics::unknowns(&**system)).map(range).collect()
    }
}

impl<S: Joinable + ?Sized> LinearisedDynamics for Several<S> {
    fn unknowns(&self) -> usize {
        self.systems.iter().map(|system| LinearisedDynamics::unknowns(&**system)).sum()
    }

    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        let ranges = self.ranges();
        for (system, range) in self.systems.iter_mut().zip(&ranges) {
            system.apply(&v[range.clone()], &mut out[range.clone()]);
        }
        self.interactions.add_tangent(&self.systems, &ranges, v, out);
    }
}

impl<S: Joinable + ?Sized> MassScaled for Several<S> {
    /// What they exert on each other is among the external forces of each.
    fn out_of_balance(&self, out: &mut [f64]) {
        for (system, range) in self.systems.iter().zip(self.ranges()) {
            system.out_of_balance(&mut out[range]);
        }
    }

    fn rates(&self, out: &mut [f64]) {
        for (system, range) in self.systems.iter().zip(self.ranges()) {
            system.rates(&mut out[range]);
        }
    }

    fn displaced(&self) -> f64 {
        self.systems.iter().map(|system| system.displaced().powi(2)).sum::<f64>().sqrt()
    }
}
