//! The greatest of values, each with the number of the particle that has it: the same whatever the order and the grouping.

/// A value and the global number of whoever has it.
///
/// Not-a-number counts as +∞, so that it is never lost; −0 counts as +0. Of equal values the one with the least number is the
/// greatest. The least of values is the greatest of their opposites.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Greatest {
    value: f64,
    number: u64,
}

impl Greatest {
    /// What one gives who has no value: less than all others.
    pub const NONE: Self = Self { value: f64::NEG_INFINITY, number: u64::MAX };

    /// A value of the particle of this global number.
    pub fn of(value: f64, number: u64) -> Self {
        Self { value: if value.is_nan() { f64::INFINITY } else { value + 0.0 }, number }
    }

    /// The value, never not-a-number.
    pub fn value(self) -> f64 {
        self.value
    }

    /// The global number of the particle that has it.
    pub fn number(self) -> u64 {
        self.number
    }

    /// The greater of two.
    pub fn or(self, other: Self) -> Self {
        let other_is = other.value > self.value || other.value == self.value && other.number < self.number;
        if other_is { other } else { self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_order_finds_the_same() {
        let all = [
            Greatest::of(-3.0, 4),
            Greatest::of(0.0, 9),
            Greatest::of(-0.0, 7),
            Greatest::NONE,
            Greatest::of(f64::NEG_INFINITY, 2),
            Greatest::of(f64::NAN, 8),
            Greatest::of(f64::INFINITY, 6),
        ];
        for a in all {
            assert_eq!(a.or(Greatest::NONE), a);
            for b in all {
                assert_eq!(a.or(b), b.or(a));
                assert!(a.or(b) == a || a.or(b) == b);
                for c in all {
                    assert_eq!(a.or(b).or(c), a.or(b.or(c)));
                }
            }
        }
        let greatest = all[..4].iter().fold(Greatest::NONE, |found, &other| found.or(other));
        assert_eq!((greatest.value().to_bits(), greatest.number()), (0, 7), "the least number; +0 for −0");
        let greatest = all.iter().fold(Greatest::NONE, |found, &other| found.or(other));
        assert_eq!((greatest.value(), greatest.number()), (f64::INFINITY, 6));
        assert_eq!(all[4].or(all[3]).number(), 2, "a value of −∞ is a value");
    }
}
