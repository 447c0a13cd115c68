//! Which particles each peer owns: the numbering of the model, cut at whole chunks.

use std::ops::Range;

use crate::CHUNK;

/// A cut of a model: the owner of rank r has the particles from border r up to border r + 1. All peers hold the whole of it.
///
/// A peer may own nothing: of fewer chunks than peers some get none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cut {
    borders: Vec<usize>,
}

impl Cut {
    /// A cut at these borders, from zero to the number of particles, where chunks do not matter: cells of a fluid.
    ///
    /// # Panics
    /// If there are no two borders, the first is not zero, or one is less than that before it.
    pub fn at(borders: Vec<usize>) -> Self {
        assert!(
            borders.len() > 1 && borders[0] == 0,
            "borders of a cut begin at zero and have an end: {borders:?}"
        );
        assert!(borders.is_sorted(), "borders of a cut ascend: {borders:?}");
        Self { borders }
    }

    /// As many whole chunks for each, as near as it goes: of c chunks the share of rank r begins at chunk ⌊c r/peers⌋.
    ///
    /// # Panics
    /// If there are no peers.
    pub fn even(particles: usize, peers: usize) -> Self {
        let chunks = particles.div_ceil(CHUNK);
        Self::at((0..=peers).map(|rank| (chunks * rank / peers * CHUNK).min(particles)).collect())
    }

    /// Shares of equal weight in whole chunks: each border is the one nearest to its part of the whole, of two the lower. Weights
    /// are work, in any unit: packs a particle, candidates of a cell; if all are zero chunks count.
    ///
    /// # Panics
    /// If there are no peers.
    pub fn by_weights(weights: &[u32], peers: usize) -> Self {
        let mut before = vec![0_u128];
        for chunk in weights.chunks(CHUNK) {
            let weight: u64 = chunk.iter().copied().map(u64::from).sum();
            before.push(before[before.len() - 1] + u128::from(weight));
        }
        let whole = before[before.len() - 1];
        if whole == 0 {
            return Self::even(weights.len(), peers);
        }
        let border = |rank: usize| {
            let (peers, part) = (peers as u128, whole * rank as u128);
            let above = before.partition_point(|before| before * peers < part);
            let lower = above > 0 && part - before[above - 1] * peers <= before[above] * peers - part;
            ((above - usize::from(lower)) * CHUNK).min(weights.len())
        };
        Self::at((0..=peers).map(border).collect())
    }

    /// Number of peers.
    pub fn peers(&self) -> usize {
        self.borders.len() - 1
    }

    /// Number of particles of all.
    pub fn particles(&self) -> usize {
        self.borders[self.peers()]
    }

    /// The particles that a rank owns.
    ///
    /// # Panics
    /// If there is no such rank.
    pub fn own(&self, rank: usize) -> Range<usize> {
        self.borders[rank]..self.borders[rank + 1]
    }

    /// The rank that owns a particle.
    ///
    /// # Panics
    /// If there is no such particle.
    pub fn owner(&self, particle: usize) -> usize {
        assert!(particle < self.particles(), "particle {particle} of {}", self.particles());
        self.borders.partition_point(|&border| border <= particle) - 1
    }

    /// Weight of the heaviest share over the mean of all \[–\]: one peer waits for no other if it is 1.
    pub fn most_over_mean(&self, weights: &[u32]) -> f64 {
        let share = |rank| weights[self.own(rank)].iter().copied().map(u64::from).sum::<u64>();
        let (mut most, mut whole) = (0, 0);
        for weight in (0..self.peers()).map(share) {
            (most, whole) = (most.max(weight), whole + weight);
        }
        if whole == 0 { 1.0 } else { most as f64 * self.peers() as f64 / whole as f64 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every particle has one owner, and all borders but the last are those of chunks.
    #[test]
    fn shares_are_whole_chunks_and_tile_the_model() {
        for particles in [0, 1, CHUNK, CHUNK + 1, 9100, 20 * CHUNK] {
            let uneven: Vec<u32> = (0..particles).map(|a| 1 + (a % 97 + a / 700) as u32).collect();
            for peers in 1..=9 {
                for cut in [Cut::even(particles, peers), Cut::by_weights(&uneven, peers)] {
                    assert_eq!((cut.peers(), cut.particles()), (peers, particles));
                    let mut next = 0;
                    for rank in 0..peers {
                        let own = cut.own(rank);
                        assert_eq!(own.start, next);
                        assert!(own.end % CHUNK == 0 || own.end == particles);
                        assert!(own.clone().all(|particle| cut.owner(particle) == rank));
                        next = own.end;
                    }
                    assert_eq!(next, particles);
                }
            }
        }
    }

    /// A border is never farther than half a chunk from its part of the whole, so a share is off its mean by one chunk at most.
    #[test]
    fn shares_are_even_to_a_chunk() {
        let weights: Vec<u32> = (0..100 * CHUNK).map(|a| if a < 30 * CHUNK { 30 } else { 10 }).collect();
        let whole: u64 = weights.iter().copied().map(u64::from).sum();
        for peers in 1..=40 {
            let cut = Cut::by_weights(&weights, peers);
            let heaviest = cut.most_over_mean(&weights) * whole as f64 / peers as f64;
            assert!(heaviest <= whole as f64 / peers as f64 + (30 * CHUNK) as f64 + 0.5, "{peers}");
        }
        // 30 chunks of weight three, 70 of weight one: a half is 80 units, 26⅔ chunks of the first.
        assert_eq!(Cut::by_weights(&weights, 2), Cut::at(vec![0, 27 * CHUNK, 100 * CHUNK]));
        assert_eq!(Cut::by_weights(&weights, 2).most_over_mean(&weights), 81.0 / 80.0);
        // A half of three chunks lies between two borders: the lower.
        assert_eq!(Cut::by_weights(&[1; 3 * CHUNK], 2), Cut::at(vec![0, CHUNK, 3 * CHUNK]));
        assert_eq!(Cut::by_weights(&[0; 4 * CHUNK], 2), Cut::even(4 * CHUNK, 2));
    }
}
