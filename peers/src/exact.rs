//! Sums of doubles without rounding: a fixed-point number wide enough for every double, added digit by digit.
//!
//! A double is an integer of 53 bits times 2ᵖ⁻¹⁰⁷⁴ with 0 ≤ p ≤ 2045 (\[ieee2019\]), so it lies on bits 0 … 2097 of a number that
//! counts in units of 2⁻¹⁰⁷⁴, the least subnormal. [`Exact`] is that number, the complete register of \[kulisch2013\] in the form of \[neal2015\]: 68 digits of 32 bits,
//!
//! ```text
//! S = 2⁻¹⁰⁷⁴ Σ D_k 2³²ᵏ,    k = 0 … 67,    each D_k in 64 bits with a sign
//! ```
//!
//! A double touches three digits, each by less than 2³². No carry is passed on while numbers are added (*carry-save*): digits may
//! grow past 32 bits, and one word counts how many numbers stand in them. When it comes to 2³¹ − 1, digits hold less than
//! `(2³¹ − 1)(2³² − 1) < 2⁶³ − 2³²`, and carries of at most 2³¹ are passed on ([`Exact::words_mut`] does it too): then 67 digits lie
//! in `[0, 2³²)`, the last has the sign, and the whole counts as one number again.
//!
//! All is integers, so that order and grouping do not matter: sums over parts of the numbers, added word by word, are words of the
//! sum of all. That is what peers do with one integer all-reduce.

use std::fmt;

use crate::CHUNK;

/// Digits of 32 bits: 66 for all doubles, two for carries.
const DIGITS: usize = 68;
/// The word that counts what is no number: +∞ in its lower half, −∞ in its upper half, not-a-number in both.
const ENDLESS: usize = DIGITS;
/// The word that counts the numbers in the digits since carries were passed on.
const PENDING: usize = DIGITS + 1;
/// Numbers that digits bear.
const MOST: i64 = (1 << 31) - 1;
/// The bits of a digit.
const DIGIT: i64 = (1 << 32) - 1;

/// A sum of doubles without rounding.
///
/// It takes in any number of doubles, in any order, by itself or merged from parts; the double nearest to the whole is taken once, by
/// [`value`](Self::value). What is not finite is counted aside: a sum with +∞ is +∞, one with −∞ is −∞, one with both or with
/// not-a-number is not-a-number. A sum of zeros is +0.
///
/// Carries are passed on by themselves, each 2³¹ − 1 numbers or merged sums. There is no bound in practice: the last digit bears 2¹⁰⁸
/// of the largest doubles.
///
/// ```
/// let mut sum = peers::Exact::new();
/// for x in [1e308, 1.0, 1e308, -1e308, -1e308] {
///     sum.add(x);
/// }
/// assert_eq!(sum.value(), 1.0);
/// ```
#[derive(Clone)]
pub struct Exact {
    words: [i64; Self::WORDS],
}

impl Exact {
    /// Words of a sum: its digits, the count of what is no number, the count of numbers.
    pub const WORDS: usize = DIGITS + 2;

    /// Nothing yet.
    pub const fn new() -> Self {
        Self { words: [0; Self::WORDS] }
    }

    /// Back to nothing.
    pub fn clear(&mut self) {
        self.words.fill(0);
    }

    /// Takes in one number.
    #[inline]
    pub fn add(&mut self, x: f64) {
        if self.words[PENDING] == MOST {
            self.carry();
        }
        self.words[PENDING] += 1;
        let bits = x.to_bits();
        let exponent = (bits >> 52) & 0x7FF;
        if exponent == 0x7FF {
            return self.count_endless(x);
        }
        let fraction = bits & ((1 << 52) - 1);
        // Subnormals stand where those of exponent one do, without the leading bit.
        let (place, significand) =
            if exponent == 0 { (0, fraction) } else { (exponent - 1, fraction | 1 << 52) };
        // At most 63, which spares the checks of three indices.
        let (digit, shift) = ((place >> 5) as usize & 63, place & 31);
        let rest = significand >> (32 - shift);
        let low = (significand << shift) as i64 & DIGIT;
        let (middle, high) = (rest as i64 & DIGIT, (rest >> 32) as i64);
        // −1 for numbers below zero: (d ^ −1) − (−1) = −d.
        let sign = (bits as i64) >> 63;
        self.words[digit] += (low ^ sign) - sign;
        self.words[digit + 1] += (middle ^ sign) - sign;
        self.words[digit + 2] += (high ^ sign) - sign;
    }

    #[cold]
    fn count_endless(&mut self, x: f64) {
        let (above, below) = (x.is_nan() || x > 0.0, x.is_nan() || x < 0.0);
        self.words[ENDLESS] += i64::from(above) + (i64::from(below) << 32);
    }

    /// Takes in many numbers by chunks of [`CHUNK`], the last of which may be shorter: within a chunk they are added plainly, in their
    /// order, and each such sum without rounding. That costs no more than a plain sum, and is the same on any number of
    /// peers if what each of them adds begins at a whole chunk of the model, as a [`Cut`](crate::Cut) of the model does. Who has the
    /// sums of chunks already, or adds by chunks of another size of which 512 is a multiple, adds them one by one.
    ///
    /// ```
    /// let (a, b) = ([0.1; 2000], [0.7; 2000]);
    /// let dot = |range: std::ops::Range<usize>| {
    ///     let mut sum = peers::Exact::new();
    ///     sum.add_in_chunks(range.map(|i| a[i] * b[i]));
    ///     sum
    /// };
    /// let (whole, mut left, right) = (dot(0..2000), dot(0..1024), dot(1024..2000));
    /// left.merge(&right);
    /// assert_eq!(left.value().to_bits(), whole.value().to_bits());
    /// ```
    pub fn add_in_chunks<I>(&mut self, values: I)
    where
        I: IntoIterator<Item = f64, IntoIter: ExactSizeIterator>,
    {
        let mut values = values.into_iter();
        while values.len() > 0 {
            self.add(values.by_ref().take(CHUNK).sum());
        }
    }

    /// Takes in all that another has taken in.
    pub fn merge(&mut self, other: &Self) {
        if self.words[PENDING] + other.words[PENDING] > MOST {
            self.carry();
            // One and the other may still be one too many.
            let mut other = other.clone();
            other.carry();
            return self.add_words(&other);
        }
        self.add_words(other);
    }

    fn add_words(&mut self, other: &Self) {
        for (word, other) in self.words.iter_mut().zip(&other.words) {
            *word += other;
        }
    }

    /// The words, with carries passed on: those of up to 2³¹ − 1 sums, added word by word, are the words of the sum of all. Who
    /// adds them elsewhere puts the result in their place.
    ///
    /// ```
    /// let [mut a, mut b] = [0.1, 0.2].map(|x| {
    ///     let mut sum = peers::Exact::new();
    ///     sum.add(x);
    ///     sum
    /// });
    /// a.words_mut().iter_mut().zip(b.words_mut()).for_each(|(a, b)| *a += *b);
    /// assert_eq!(a.value(), 0.1 + 0.2);
    /// ```
    pub fn words_mut(&mut self) -> &mut [i64; Self::WORDS] {
        self.carry();
        &mut self.words
    }

    /// The double nearest to the sum, of two the one whose last bit is zero; ±∞ for what is beyond all doubles.
    pub fn value(&self) -> f64 {
        let mut sum = self.clone();
        sum.carry();
        match (sum.words[ENDLESS] & DIGIT > 0, sum.words[ENDLESS] >> 32 > 0) {
            (true, true) => return f64::NAN,
            (true, false) => return f64::INFINITY,
            (false, true) => return f64::NEG_INFINITY,
            (false, false) => {}
        }
        let below = sum.words[DIGITS - 1] < 0;
        if below {
            sum.words[..DIGITS].iter_mut().for_each(|digit| *digit = -*digit);
            sum.carry();
        }
        let size = sum.rounded();
        if below { -size } else { size }
    }

    /// Passes carries on: all digits but the last come to lie in `[0, 2³²)`.
    fn carry(&mut self) {
        let mut carry = 0;
        for digit in &mut self.words[..DIGITS - 1] {
            let sum = *digit + carry;
            carry = sum >> 32;
            *digit = sum & DIGIT;
        }
        self.words[DIGITS - 1] += carry;
        let (above, below) = (self.words[ENDLESS] & DIGIT > 0, self.words[ENDLESS] >> 32 > 0);
        self.words[ENDLESS] = i64::from(above) + (i64::from(below) << 32);
        self.words[PENDING] = 1;
    }

    /// The double nearest to a sum that is not below zero, with carries passed on.
    fn rounded(&self) -> f64 {
        let digits = &self.words[..DIGITS];
        let Some(top) = digits.iter().rposition(|&digit| digit != 0) else { return 0.0 };
        let digit = |back: usize| top.checked_sub(back).map_or(0, |k| digits[k] as u128);
        let leading = digits[top].ilog2() as usize;
        let highest = 32 * top + leading;
        if highest <= 52 {
            // The bits of such a double are the integer itself, subnormal or of exponent one.
            let [low, high] = [digits[0], digits[1]];
            return f64::from_bits((high << 32 | low) as u64);
        }
        let three = digit(0) << 64 | digit(1) << 32 | digit(2);
        let shift = leading + 64 - 52;
        let (kept, lost, half) = ((three >> shift) as u64, three & ((1 << shift) - 1), 1_u128 << (shift - 1));
        let more = digits[..top.saturating_sub(2)].iter().any(|&digit| digit != 0);
        let up = lost > half || lost == half && (more || kept & 1 == 1);
        // The leading bit of what is kept adds one to the exponent; so does a carry out of it. Beyond all doubles they are more than
        // the bits of infinity, whatever the last digit holds.
        let bits = ((highest as u64 - 52) << 52) + kept + u64::from(up);
        f64::from_bits(bits.min(f64::INFINITY.to_bits()))
    }
}

impl Default for Exact {
    fn default() -> Self {
        Self::new()
    }
}

impl fmt::Debug for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Exact({:?})", self.value())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As many numbers as digits bear, all bits of three digits set: then one more, and a merge of two such sums.
    #[test]
    fn carries_are_passed_on_before_a_digit_overflows() {
        for sign in [1.0, -1.0] {
            // 2⁵³ − 1 at every place of a bit in its digit.
            for place in 0..32 {
                let x = sign * ((1_u64 << 53) - 1) as f64 * 2_f64.powi(place);
                let mut one = Exact::new();
                one.add(x);
                let mut full = Exact { words: one.words.map(|word| word * MOST) };
                assert_eq!(full.words[PENDING], MOST);
                assert_eq!(full.value(), x * MOST as f64, "2³¹ − 1 numbers: {x:e}");
                let mut twice = full.clone();
                twice.merge(&full);
                assert_eq!(twice.value(), 2.0 * (x * MOST as f64));
                assert!(twice.words[PENDING] <= MOST);
                full.add(x);
                assert_eq!(full.value(), x * 2_f64.powi(31));
                assert_eq!(full.words[PENDING], 2, "carries were passed on");
            }
        }
    }

    /// `x (2³¹ − 1)` in doubles is rounded once, as the exact sum is: the check above is one of bits.
    #[test]
    fn what_is_no_number_is_counted_as_long() {
        let mut one = Exact::new();
        one.add(f64::NEG_INFINITY);
        let mut full = Exact { words: one.words.map(|word| word * MOST) };
        assert_eq!(full.value(), f64::NEG_INFINITY);
        full.add(f64::NEG_INFINITY);
        full.merge(&full.clone());
        assert_eq!(full.value(), f64::NEG_INFINITY);
        full.add(f64::INFINITY);
        assert!(full.value().is_nan());
    }
}
