//! Constants that many packs have in common, kept once.
//!
//! Cells of a lattice on a plane or a cylinder are equal to the last bit in many places; kept once, their constants stay in the
//! cache while the sweep passes. Where all differ, they follow each other in the order in which the sweep reads them.

use std::collections::HashMap;

use shell_kinematics::{LANES, Pack};

/// The constants of every pack, equal ones once.
#[derive(Clone, Debug)]
pub(crate) struct Shared<T> {
    distinct: Vec<T>,
    /// Which of them each pack has.
    of: Vec<u32>,
}

impl<T> Shared<T> {
    /// The constants of all packs in order; `numbers` are those by which they are distinguished.
    pub fn new<N: IntoIterator<Item = Pack>>(
        all: impl IntoIterator<Item = T>,
        numbers: impl Fn(&T) -> N,
    ) -> Self {
        let (mut seen, mut distinct, mut of) = (Interned::default(), Vec::new(), Vec::new());
        for constants in all {
            let place = seen.place(numbers(&constants), distinct.len() as u32);
            if place as usize == distinct.len() {
                distinct.push(constants);
            }
            of.push(place);
        }
        Self { distinct, of }
    }

    /// The constants of a pack.
    #[inline(always)]
    pub fn get(&self, pack: usize) -> &T {
        &self.distinct[self.of[pack] as usize]
    }

    /// The bytes of all.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.distinct[..]) + size_of_val(&self.of[..])
    }
}

/// Numbers that came before, by their bits, and where they are kept.
#[derive(Default)]
pub(crate) struct Interned(HashMap<Vec<[u64; LANES]>, u32>);

impl Interned {
    /// Where equal numbers are kept; `next` if they come for the first time.
    pub fn place(&mut self, numbers: impl IntoIterator<Item = Pack>, next: u32) -> u32 {
        let bits = numbers.into_iter().map(|pack| pack.lanes().map(f64::to_bits)).collect();
        *self.0.entry(bits).or_insert(next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_constants_are_kept_once_and_zeros_of_either_sign_are_distinguished_apart() {
        let all = [1.0, 0.0, 1.0, -0.0, 2.0, 0.0].map(Pack::splat);
        let shared = Shared::new(all, |pack| [*pack]);
        assert_eq!(shared.distinct.len(), 4);
        for (pack, constants) in all.iter().enumerate() {
            assert_eq!(shared.get(pack).lanes().map(f64::to_bits), constants.lanes().map(f64::to_bits));
        }
    }
}
