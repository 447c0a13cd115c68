//! A sum is the double nearest to the exact one: in any order, over any split, whatever its numbers are.

mod random;
mod whole;

use peers::{CHUNK, Exact};
use random::Random;
use whole::Whole;

fn exact(values: &[f64]) -> Exact {
    let mut sum = Exact::new();
    values.iter().for_each(|&x| sum.add(x));
    sum
}

fn bits(values: &[f64]) -> u64 {
    exact(values).value().to_bits()
}

/// 2ⁿ, subnormal ones too.
fn two(n: i32) -> f64 {
    if n < -1022 { f64::from_bits(1 << (n + 1074)) } else { f64::from_bits(((n + 1023) as u64) << 52) }
}

/// Numbers of one kind: any bits, alike, subnormal, few bits, all bits, with their opposites.
fn numbers(random: &mut Random, kind: usize, count: usize) -> Vec<f64> {
    let one = |random: &mut Random| loop {
        let bits = random.bits();
        let x = match kind {
            0 => f64::from_bits(bits),
            1 => random.unit(),
            2 => f64::from_bits(bits & 0x800F_FFFF_FFFF_FFFF),
            3 => f64::from_bits(bits & 0xFFF0_0000_0000_0000),
            4 => f64::from_bits(bits | 0x000F_FFFF_FFFF_FFFF),
            // Within three digits of each other.
            _ => f64::from_bits((bits & 0x80FF_FFFF_FFFF_FFFF) + (0x390 << 52)),
        };
        if x.is_finite() {
            return x;
        }
    };
    let mut found: Vec<f64> = (0..count).map(|_| one(random)).collect();
    if random.below(2) == 0 {
        // All but a few cancel.
        let opposites: Vec<f64> = found.iter().skip(random.below(3)).map(|x| -x).collect();
        found.extend(opposites);
    }
    found
}

#[test]
fn any_order_and_any_split_give_the_nearest_double() {
    let mut random = Random(1);
    for set in 0..3000 {
        let count = if set % 50 == 0 { 700 } else { random.below(30) };
        let mut values = numbers(&mut random, set % 6, count);
        let found = exact(&values).value();
        Whole::of(&values).nearest_is(found);
        for _ in 0..4 {
            random.shuffle(&mut values);
            let mut parts = vec![Exact::new(); 1 + random.below(7)];
            for &x in &values {
                let part = random.below(parts.len());
                parts[part].add(x);
            }
            // As a tree of random shape, by merging or word by word.
            while parts.len() > 1 {
                let mut part = parts.swap_remove(random.below(parts.len()));
                let into = random.below(parts.len());
                if random.below(2) == 0 {
                    parts[into].merge(&part);
                } else {
                    let words = parts[into].words_mut().iter_mut();
                    words.zip(part.words_mut()).for_each(|(word, other)| *word += *other);
                }
            }
            assert_eq!(parts[0].value().to_bits(), found.to_bits(), "set {set}");
        }
    }
}

/// Every place of a double in the digits, by itself, beside its neighbours, halved and taken away.
#[test]
fn every_exponent_lies_where_it_should() {
    let patterns =
        [0, 1, 0x000F_FFFF_FFFF_FFFF, 0x000A_AAAA_AAAA_AAAA, 0x0005_5555_5555_5555, 1 << 51, 1 << 20];
    for exponent in 0..0x7FF_u64 {
        for pattern in patterns {
            for sign in [0, 1] {
                let x = f64::from_bits(sign << 63 | exponent << 52 | pattern);
                let plus_zero = x + 0.0;
                assert_eq!(bits(&[x]), plus_zero.to_bits());
                assert_eq!(bits(&[x, 1.0, -x]), 1_f64.to_bits());
                for sum in
                    [[x, x.next_up(), 0.0], [x, x, x], [x, -x.next_down(), 0.0], [x, 0.5 * x, two(-1074)]]
                {
                    if sum.iter().all(|x| x.is_finite()) {
                        Whole::of(&sum).nearest_is(exact(&sum).value());
                    }
                }
            }
        }
    }
}

#[test]
fn what_cancels_leaves_the_rest() {
    for (values, sum) in [
        (&[1e308, 1.0, -1e308][..], 1.0),
        (&[1e308, 1e308, -1e308, -1e308, -3e-310], -3e-310),
        (&[1.0, 1e100, 1.0, -1e100], 2.0),
        (&[f64::MAX, f64::MAX, f64::MAX, -f64::MAX, -f64::MAX], f64::MAX),
        (&[-f64::MAX, -f64::MAX, two(-1074), f64::MAX, f64::MAX], two(-1074)),
        (&[0.1, 0.2, 0.3, -0.6], 2_f64.powi(-55)), // 0.1 + 0.2 + 0.3 = 0.6 + 2⁻⁵⁵ in doubles
        (&[-0.0, -0.0], 0.0),
        (&[], 0.0),
    ] {
        assert_eq!(bits(values), sum.to_bits(), "{values:?}");
        let opposite: Vec<f64> = values.iter().map(|x| -x).collect();
        assert_eq!(bits(&opposite), (0.0 - sum).to_bits(), "{opposite:?}");
    }
}

/// Half a last bit goes to the even one, a little more or less to the nearest, at every exponent.
#[test]
fn ties_go_to_the_even_one() {
    for n in -1021..1023 {
        // The last bit of 2ⁿ is 2ⁿ⁻⁵²; below 2⁻¹⁰²¹ there is no half of it.
        let (one, last, half) = (two(n), two(n - 52), two(n - 53));
        let little = if n < 900 { two(-1074) } else { two(n - 900) };
        for sign in [1.0, -1.0] {
            let sum = |values: [f64; 4]| sign * exact(&values.map(|x| sign * x)).value();
            assert_eq!(sum([one, half, 0.0, 0.0]), one, "even stays");
            assert_eq!(sum([one, last, half, 0.0]), one + 2.0 * last, "odd goes up");
            if half > little {
                assert_eq!(sum([one, half, little, 0.0]), one + last, "more than half");
                assert_eq!(sum([one, last, half, -little]), one + last, "less than half");
            }
            assert_eq!(sum([2.0 * one, -half, 0.0, 0.0]), 2.0 * one, "finer bits below a power of two");
            assert_eq!(sum([2.0 * one, -last, half, 0.0]), 2.0 * one, "a carry through all bits");
        }
    }
}

#[test]
fn subnormal_sums_are_exact() {
    let least = two(-1074);
    assert_eq!(bits(&[least]), 1);
    assert_eq!(bits(&[f64::MIN_POSITIVE, -least]), f64::MIN_POSITIVE.to_bits() - 1);
    assert_eq!(bits(&[f64::MIN_POSITIVE.next_down(), least]), f64::MIN_POSITIVE.to_bits());
    let mut sum = Exact::new();
    (0..100_000).for_each(|_| sum.add(3.0 * least));
    assert_eq!(sum.value().to_bits(), 300_000);
    (0..100_000).for_each(|_| sum.add(-3.0 * least));
    assert_eq!(sum.value().to_bits(), 0);
}

#[test]
fn beyond_the_largest_double_is_infinity() {
    let half = two(970);
    for sign in [1.0, -1.0] {
        let sum = |values: &[f64]| sign * exact(&values.iter().map(|x| sign * x).collect::<Vec<_>>()).value();
        assert_eq!(sum(&[f64::MAX, half.next_down()]), f64::MAX);
        assert_eq!(sum(&[f64::MAX, half, -two(-1074)]), f64::MAX);
        assert_eq!(sum(&[f64::MAX, half]), f64::INFINITY, "a tie, and the largest double is odd");
        assert_eq!(sum(&[f64::MAX; 9]), f64::INFINITY);
        assert_eq!(sum(&[two(1023); 2]), f64::INFINITY);
        // On the way, not at the end.
        assert_eq!(sum(&[f64::MAX, f64::MAX, -f64::MAX, -1.0]), f64::MAX);
    }
}

#[test]
fn what_is_no_number_decides() {
    let (above, below, none) = (f64::INFINITY, f64::NEG_INFINITY, f64::NAN);
    let sum = |values: &[f64]| exact(values).value();
    assert_eq!(sum(&[1.0, above, -1e308, above]), above);
    assert_eq!(sum(&[below, f64::MAX, f64::MAX]), below);
    assert!(sum(&[above, 1.0, below]).is_nan());
    for odd in [none, -none, f64::from_bits(0x7FF0_0000_0000_0001)] {
        assert_eq!(bits(&[1.0, odd]), f64::NAN.to_bits(), "always the same bits");
        assert_eq!(bits(&[above, odd, below]), f64::NAN.to_bits());
    }
    let mut whole = exact(&[above; 3]);
    whole.merge(&exact(&[1.0, 2.0]));
    assert_eq!(whole.value(), above);
    whole.words_mut();
    whole.merge(&exact(&[below; 4]));
    assert!(whole.value().is_nan());
    whole.clear();
    assert_eq!(whole.value().to_bits(), 0);
}

/// A sum merged with itself doubles: far past what digits bear without carries.
#[test]
fn sums_of_sums_bear_any_number() {
    for x in [1.0, -1.0, f64::MIN_POSITIVE, -f64::MAX, 0.1, -1.7e-300] {
        let mut sum = exact(&[x]);
        for n in 1..100 {
            let same = sum.clone();
            sum.merge(&same);
            assert_eq!(sum.value(), x * two(n), "{x:e} 2^{n}");
        }
    }
}

#[test]
fn chunks_are_added_plainly_and_their_sums_exactly() {
    let mut random = Random(7);
    let values: Vec<f64> = (0..9 * CHUNK + 77).map(|_| random.unit() * 1e3).collect();
    let mut chunks = Vec::new();
    for chunk in values.chunks(CHUNK) {
        let mut sum = 0.0;
        chunk.iter().for_each(|x| sum += x);
        chunks.push(sum);
    }
    let mut whole = Exact::new();
    whole.add_in_chunks(values.iter().copied());
    assert_eq!(whole.value().to_bits(), bits(&chunks));
    Whole::of(&chunks).nearest_is(whole.value());
    // Another chunk, another sum: the numbers tell the two apart.
    let other: Vec<f64> = values.chunks(CHUNK / 2).map(|chunk| chunk.iter().sum()).collect();
    assert_ne!(whole.value().to_bits(), bits(&other));
    assert_ne!(whole.value().to_bits(), bits(&values));
    whole.clear();
    whole.add_in_chunks([]);
    assert_eq!(whole.value(), 0.0);
}
