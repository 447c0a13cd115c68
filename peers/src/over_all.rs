//! What a model records and what decides in it, over all who march it: sums of chunks, products of vectors, maxima.

use crate::CHUNK;
use crate::exact::Exact;
use crate::greatest::Greatest;
use crate::peers::Peers;

impl dyn Peers {
    /// Adds numbers of chunks over all, exactly; all call it. Each gives the sums of its own chunks.
    pub fn sum<const N: usize>(&mut self, mut numbers: impl Iterator<Item = [f64; N]>) -> [f64; N] {
        // Of two numbers at most the plain sum is the nearest to the exact one; that of zeros is +0.
        let [first, second, third] = [numbers.next(), numbers.next(), numbers.next()];
        if self.count() == 1 && third.is_none() {
            let [first, second] = [first, second].map(|own| own.unwrap_or([0.0; N]));
            return std::array::from_fn(|k| 0.0 + first[k] + second[k]);
        }
        let mut sums = [const { Exact::new() }; N];
        for own in [first, second, third].into_iter().flatten().chain(numbers) {
            sums.iter_mut().zip(own).for_each(|(sum, number)| sum.add(number));
        }
        self.add(&mut sums, &mut []);
        sums.map(|sum| sum.value())
    }

    /// `a·b` of vectors of which each gives its own part, whole chunks of particles with so many numbers each.
    pub fn dot(&mut self, a: &[f64], b: &[f64], width: usize) -> f64 {
        let chunks = a.chunks(CHUNK * width).zip(b.chunks(CHUNK * width));
        let product = |(a, b): (&[f64], &[f64])| [a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>()];
        let [sum] = self.sum(chunks.map(product));
        sum
    }

    /// The greatest of values of all with its number; −∞ where nobody has one.
    pub fn greatest_of(&mut self, own: impl Iterator<Item = (f64, usize)>) -> (f64, usize) {
        let of = |best: Greatest, (value, number)| best.or(Greatest::of(value, number as u64));
        let mut found = [own.fold(Greatest::NONE, of)];
        self.greatest(&mut found);
        (found[0].value(), found[0].number() as usize)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Alone, CHUNK, Cut, Peers, together};

    #[test]
    fn what_is_found_over_all_is_what_one_finds() {
        for particles in [0, 10, CHUNK + 1, 3 * CHUNK, 9 * CHUNK + 7] {
            let a: Vec<f64> = (0..2 * particles).map(|i| (1.0 + i as f64).sqrt() - 30.0).collect();
            let b: Vec<f64> = a.iter().map(|x| x * x - 7.0).collect();
            let find = |mut peers: Box<dyn Peers>| {
                let own = Cut::even(particles, peers.count()).own(peers.rank());
                let part = 2 * own.start..2 * own.end;
                let sums = a[part.clone()].chunks(2 * CHUNK).map(|chunk| [chunk.iter().sum(), -0.0]);
                let sums: [f64; 2] = peers.sum(sums);
                let dot = peers.dot(&a[part.clone()], &b[part], 2);
                let (greatest, number) = peers.greatest_of(own.map(|i| (-(a[2 * i] + 20.0).abs(), i)));
                ([sums[0], sums[1], dot, greatest].map(f64::to_bits), number)
            };
            let alone = find(Box::new(Alone));
            assert_eq!(f64::from_bits(alone.0[1]).to_bits(), 0, "zeros add up to +0");
            for count in 1..=5 {
                assert_eq!(together(count, find).unwrap(), vec![alone; count], "{particles} by {count}");
            }
        }
    }
}
