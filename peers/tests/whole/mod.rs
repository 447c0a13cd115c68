//! The truth about a sum: schoolbook integers in units of the least subnormal, without anything of the crate.

use std::cmp::Ordering;

/// A natural number, 32 bits a digit, no zeros at its end.
type Natural = Vec<u32>;

/// Doubles added up: those above zero and those below it.
#[derive(Clone, Default)]
pub struct Whole {
    above: Natural,
    below: Natural,
}

impl Whole {
    pub fn of(values: &[f64]) -> Self {
        let mut whole = Self::default();
        values.iter().for_each(|&x| whole.add(x));
        whole
    }

    /// Bit by bit; ±∞ counts as ±2¹⁰²⁴, the double that would follow the largest.
    pub fn add(&mut self, x: f64) {
        let part = if x.is_sign_negative() { &mut self.below } else { &mut self.above };
        let (exponent, fraction) = (x.to_bits() >> 52 & 0x7FF, x.to_bits() & ((1 << 52) - 1));
        assert!(exponent < 0x7FF || fraction == 0, "a number");
        let lowest = exponent.max(1) - 1;
        for bit in (0..52).filter(|bit| fraction >> bit & 1 == 1) {
            add_bit(part, lowest + bit);
        }
        if exponent > 0 {
            add_bit(part, lowest + 52);
        }
    }

    /// How far a double lies from the sum.
    fn distance(&self, x: f64) -> Natural {
        let mut other = self.clone();
        other.add(-x);
        difference(&other.above, &other.below)
    }

    /// Fails unless this is the nearest double, of two the even one.
    pub fn nearest_is(&self, x: f64) {
        assert!(!x.is_nan(), "not a number");
        let own = self.distance(x);
        let zero = self.above == self.below;
        assert!(!zero || x.to_bits() == 0, "a sum of nothing is +0, not {x:?}");
        for other in [x.next_up(), x.next_down()].into_iter().filter(|other| *other != x) {
            let even = x.to_bits() & 1 == 0;
            let further = compare(&self.distance(other), &own);
            // Beyond 2¹⁰²⁴ infinity is right however far.
            let beyond = x.is_infinite() && compare(self.larger(x), &Self::of(&[x.abs()]).above).is_ge();
            assert!(
                beyond || further.is_gt() || even && further.is_eq(),
                "{other:e} is nearer than {x:e}, or as near and even"
            );
        }
    }

    fn larger(&self, x: f64) -> &Natural {
        if x > 0.0 { &self.above } else { &self.below }
    }
}

fn add_bit(number: &mut Natural, bit: u64) {
    let (mut digit, mut one) = ((bit / 32) as usize, 1_u32 << (bit % 32));
    while one > 0 {
        if number.len() <= digit {
            number.resize(digit + 1, 0);
        }
        let (sum, over) = number[digit].overflowing_add(one);
        number[digit] = sum;
        (digit, one) = (digit + 1, u32::from(over));
    }
}

fn compare(a: &Natural, b: &Natural) -> Ordering {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

fn difference(a: &Natural, b: &Natural) -> Natural {
    let (large, small) = if compare(a, b).is_ge() { (a, b) } else { (b, a) };
    let mut found = large.clone();
    let mut borrow = false;
    for (i, digit) in found.iter_mut().enumerate() {
        let (less, first) = digit.overflowing_sub(small.get(i).copied().unwrap_or(0));
        let (less, second) = less.overflowing_sub(u32::from(borrow));
        (*digit, borrow) = (less, first || second);
    }
    while found.last() == Some(&0) {
        found.pop();
    }
    found
}
