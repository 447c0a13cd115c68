//! Exponential, logarithm and step of any [`Number`], from additions, products and the bits of a number: the same bits in any registers.

use crate::pack::Number;

/// The upper 32 bits of ln 2, so that its product with an exponent is exact.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
/// ln 2 less [`LN_2_HIGH`].
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
/// A number to which another is added and taken off again to round it to the next integer.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;
/// Bits of the mantissa.
const MANTISSA: u32 = 52;
/// The exponent of one.
const BIAS: i64 = 1023;

/// Coefficients of the exponential series, the highest first: `1/13!` to `1/2!`.
const EXPONENTIAL: [f64; 12] = [
    1.0 / 6_227_020_800.0,
    1.0 / 479_001_600.0,
    1.0 / 39_916_800.0,
    1.0 / 3_628_800.0,
    1.0 / 362_880.0,
    1.0 / 40_320.0,
    1.0 / 5_040.0,
    1.0 / 720.0,
    1.0 / 120.0,
    1.0 / 24.0,
    1.0 / 6.0,
    1.0 / 2.0,
];

/// Three components, one after the other: the functions of arrays are compiled apart from the registers of a sweep.
#[inline(always)]
pub(super) fn three<T>(component: impl Fn(usize) -> T) -> [T; 3] {
    [component(0), component(1), component(2)]
}

/// `c₀xⁿ + c₁xⁿ⁻¹ + … + cₙ`.
#[inline(always)]
pub(super) fn polynomial<P: Number>(x: P, coefficients: &[f64]) -> P {
    let mut sum = x.all(0.0);
    for coefficient in coefficients {
        sum = sum * x + x.all(*coefficient);
    }
    sum
}

/// eˣ, to two units in the last place between −700 and 700 and constant beyond.
///
/// `x = k ln 2 + r` with `|r| ≤ ½ ln 2`, where fourteen terms of the series leave 4e-18.
#[inline(always)]
pub(super) fn exp<P: Number>(x: P) -> P {
    let x = x.max(x.all(-700.0)).min(x.all(700.0));
    let round = x.all(TO_INTEGER);
    let k = (x * std::f64::consts::LOG2_E + round) - round;
    let r = x - k * LN_2_HIGH - k * LN_2_LOW;
    let series = polynomial(r, &EXPONENTIAL) * r * r + r + r.all(1.0);
    series * k.each(|k| f64::from_bits(((k as i64 + BIAS) << MANTISSA) as u64))
}

/// ln x of a positive normal number, to two units in the last place of its parts.
///
/// `x = 2ᵏm` with `√½ ≤ m < √2`, and `ln m = 2 artanh s` with `s = (m−1)/(m+1)`, `s² ≤ 0.0295`, where twelve terms leave 2e-18.
#[inline(always)]
pub(super) fn ln<P: Number>(x: P) -> P {
    const ROOT: i64 = std::f64::consts::FRAC_1_SQRT_2.to_bits() as i64;
    let power = |x: f64| (x.to_bits() as i64 - ROOT) >> MANTISSA;
    let k = x.each(|x| power(x) as f64);
    let m = x.each(|x| f64::from_bits((x.to_bits() as i64 - (power(x) << MANTISSA)) as u64));
    let one = x.all(1.0);
    let s = (m - one) / (m + one);
    let mut series = x.all(0.0);
    for term in (1..12).rev() {
        series = (series + x.all(1.0 / f64::from(2 * term + 1))) * (s * s);
    }
    k * LN_2_HIGH + (k * LN_2_LOW + (s + s * series) * 2.0)
}

/// One where a number is above zero by more than 1e-300, zero elsewhere.
#[inline(always)]
pub(super) fn above_zero<P: Number>(x: P) -> P {
    (x * 1e300).max(x.all(0.0)).min(x.all(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two units in the last place of the libm functions over their range; the ends of the range of the exponential are kept.
    #[test]
    fn exponential_and_logarithm_are_those_of_libm() {
        let mut worst = [0.0_f64; 2];
        for i in 0..200_000 {
            let x = -600.0 + 0.006 * f64::from(i);
            worst[0] = worst[0].max((exp(x) / libm::exp(x) - 1.0).abs());
            let (y, small) = (libm::exp(x), 1.0 + 1e-5 * f64::from(i));
            for y in [y, small] {
                worst[1] = worst[1].max((ln(y) - libm::log(y)).abs() / libm::log(y).abs().max(1e-3));
            }
        }
        println!("{worst:?}");
        // 2.2e-16 and 4.4e-16: the functions compared with err by as much.
        assert!(worst[0] < 7e-16 && worst[1] < 9e-16, "{worst:?}");
        assert_eq!((exp(0.0), ln(1.0)), (1.0, 0.0));
        assert_eq!((exp(-1e9), exp(1e9)), (exp(-700.0), exp(700.0)));
    }

    #[test]
    fn the_step_is_zero_at_zero() {
        assert_eq!([-1.0, -1e-20, 0.0, 1e-20, 1e20].map(above_zero), [0.0, 0.0, 0.0, 1.0, 1.0]);
    }
}
