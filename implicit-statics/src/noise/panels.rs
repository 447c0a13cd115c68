//! Frequencies and weights by which responses to noise are integrated: graded towards each natural frequency.

use super::PowerDensity;

/// Abscissae on (0, 1) and weights on both sides of 0 of Gauss and Legendre with twelve points, exact to the 23rd degree.
const GAUSS: [[f64; 2]; 6] = [
    [0.125_233_408_511_468_9, 0.249_147_045_813_402_8],
    [0.367_831_498_998_180_2, 0.233_492_536_538_354_8],
    [0.587_317_954_286_617_4, 0.203_167_426_723_065_92],
    [0.769_902_674_194_304_7, 0.160_078_328_543_346_23],
    [0.904_117_256_370_474_9, 0.106_939_325_995_318_43],
    [0.981_560_634_246_719_3, 0.047_175_336_386_511_83],
];
/// Least width of a panel over its frequency: below it is rounding.
const NARROWEST: f64 = 1e-13;

/// `[frequency, weight]` by which `∫ |H|² G df` is a sum, over the frequencies of all densities. `peaks` are natural frequencies \[1/T\] and halves of the
/// widths of their peaks.
///
/// Each panel is at most as wide as it is far from a natural frequency, or half of the width of its peak: the poles of H are then no nearer to a
/// panel than half of its length, and twelve points leave 1e-13 of what is integrated.
pub fn frequencies(densities: &[&PowerDensity], peaks: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut ends: Vec<f64> =
        densities.iter().flat_map(|own| own.points.iter().map(|point| point[0])).collect();
    let (Some(first), Some(last)) =
        (ends.iter().copied().reduce(f64::min), ends.iter().copied().reduce(f64::max))
    else {
        return Vec::new();
    };
    // Powers of the frequency, and the pole at rest of what is far above it.
    let mut octave = first;
    while octave < last {
        ends.push(octave);
        octave *= 2.0;
    }
    for &[natural, half] in peaks {
        let least = half.max(NARROWEST * natural);
        ends.push(natural);
        let mut off = least;
        while off < last.max(natural) {
            ends.extend([natural - off, natural + off]);
            off *= 2.0;
        }
    }
    ends.retain(|end| (first..=last).contains(end));
    ends.sort_by(f64::total_cmp);
    ends.dedup_by(|b, a| *b - *a <= NARROWEST * *a);
    let panel = |pair: &[f64]| {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        GAUSS.iter().flat_map(move |&[at, weight]| [-at, at].map(|at| [middle + half * at, half * weight]))
    };
    ends.windows(2).flat_map(panel).collect()
}
