//! Places on the middle surface, each a weighted mean of particles.

use crate::packs::Row;

/// Places on the middle surface, `x = Σ N_a x_a` with `Σ N_a = 1`.
#[derive(Clone, Debug, Default)]
pub(super) struct Places {
    /// Where each place ends in `weights`.
    ends: Vec<u32>,
    weights: Vec<(u32, f64)>,
}

impl Places {
    /// Number of places.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// One more place.
    pub fn push(&mut self, weights: impl IntoIterator<Item = (u32, f64)>) {
        self.weights.extend(weights.into_iter().filter(|(_, weight)| *weight != 0.0));
        self.ends.push(self.weights.len() as u32);
    }

    /// Particles of a place, with their weights.
    pub fn weights(&self, place: usize) -> &[(u32, f64)] {
        let start = place.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.weights[start as usize..self.ends[place] as usize]
    }

    /// The mean of a quantity of the particles at a place.
    pub fn mean(&self, place: usize, rows: &[Row]) -> Row {
        self.weights(place).iter().fold([0.0; 6], |sum, &(particle, weight)| {
            let row = &rows[particle as usize];
            std::array::from_fn(|k| sum[k] + weight * row[k])
        })
    }

    /// The transpose of [`Places::mean`]: shares what acts on a place over its particles.
    pub fn share(&self, place: usize, force: &Row, rows: &mut [Row]) {
        for &(particle, weight) in self.weights(place) {
            let row = &mut rows[particle as usize];
            (0..6).for_each(|k| row[k] += weight * force[k]);
        }
    }

    /// Bytes of all lists.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.ends[..]) + size_of_val(&self.weights[..])
    }
}
