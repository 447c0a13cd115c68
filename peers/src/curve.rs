//! Order along a Hilbert curve: particles near each other in space get numbers near each other.
//!
//! The curve goes through all cells of a square or cube of 2ᵇ cells a side, each once, from one to a neighbour (\[skilling2004\]). A piece of it
//! is compact, so a model numbered along it is cut into compact shares for any number of peers: the order belongs to the model, the
//! cut to the run.

/// The particles in the order of the curve, from their places \[L\] in a plane or in space. The box of the curve is the smallest
/// square or cube from their lowest corner that holds all; of particles in one cell the one with the lower number comes first.
///
/// Places have to be finite: a coordinate that is none counts as the lower corner's.
///
/// ```
/// let corners = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
/// assert_eq!(peers::along_curve(&corners), [0, 3, 1, 2]); // once round
/// ```
pub fn along_curve<const D: usize>(places: &[[f64; D]]) -> Vec<u32> {
    let bits = const { bits(D) };
    let (mut low, mut high) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
    for place in places {
        for i in 0..D {
            (low[i], high[i]) = (low[i].min(place[i]), high[i].max(place[i]));
        }
    }
    let side = (0..D).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    let (cells, last) = ((1_u64 << bits) as f64, ((1_u64 << bits) - 1) as u32);
    // Conversion takes what is no number to zero.
    let cell = |place: &[f64; D]| -> [u32; D] {
        std::array::from_fn(|i| (((place[i] - low[i]) / side * cells) as u32).min(last))
    };
    let mut keyed: Vec<(u64, u32)> =
        (0..).zip(places).map(|(a, place)| (key(cell(place), bits), a)).collect();
    keyed.sort_unstable();
    keyed.into_iter().map(|(_, a)| a).collect()
}

/// Bits of a coordinate, so that a key has 64 at most.
const fn bits(dimension: usize) -> u32 {
    match dimension {
        2 => 32,
        3 => 21,
        _ => panic!("a curve in a plane or in space"),
    }
}

/// How far along the curve a cell lies, in cells: `AxestoTranspose` of \[skilling2004\], its bits then interleaved.
fn key<const D: usize>(mut x: [u32; D], bits: u32) -> u64 {
    let masks = || (1..bits).rev().map(|bit| 1_u32 << bit);
    for bit in masks() {
        let lower = bit - 1;
        for i in 0..D {
            if x[i] & bit != 0 {
                x[0] ^= lower;
            } else {
                let exchanged = (x[0] ^ x[i]) & lower;
                x[0] ^= exchanged;
                x[i] ^= exchanged;
            }
        }
    }
    for i in 1..D {
        x[i] ^= x[i - 1];
    }
    let inverted = masks().filter(|bit| x[D - 1] & bit != 0).fold(0, |inverted, bit| inverted ^ (bit - 1));
    let mut key = 0;
    for bit in (0..bits).rev() {
        for x in x {
            key = key << 1 | u64::from((x ^ inverted) >> bit & 1);
        }
    }
    key
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The curve meets every cell once and goes from each to one that shares a side with it.
    fn walks<const D: usize>(bits: u32) {
        let side = 1_u32 << bits;
        let mut cells = vec![None; (side as usize).pow(D as u32)];
        for n in 0..cells.len() as u32 {
            let cell: [u32; D] = std::array::from_fn(|i| n / side.pow(i as u32) % side);
            let met = cells[key(cell, bits) as usize].replace(cell);
            assert_eq!(met, None, "two cells with one key");
        }
        assert_eq!(cells[0], Some([0; D]));
        for pair in cells.windows(2) {
            let (Some(a), Some(b)) = (pair[0], pair[1]) else { panic!("a key without a cell") };
            let steps: u32 = (0..D).map(|i| a[i].abs_diff(b[i])).sum();
            assert_eq!(steps, 1, "from {a:?} to {b:?}");
        }
    }

    #[test]
    fn the_curve_walks_from_cell_to_neighbouring_cell() {
        for bits in 1..=7 {
            walks::<2>(bits);
        }
        for bits in 1..=5 {
            walks::<3>(bits);
        }
    }

    /// All bits of the coordinates count: the outermost cells of the finest curves.
    #[test]
    fn keys_of_the_finest_curves_fill_their_bits() {
        assert_eq!(key([0, 0], 32), 0);
        assert_eq!(key([u32::MAX, 0], 32), u64::MAX, "a curve ends beside where it began");
        assert_eq!(key([(1 << 21) - 1, 0, 0], 21), (1 << 63) - 1);
    }

    /// The box of the curve is a square: a strip of 256 × 16 points is gone through in pieces of 16 × 16, whatever its place and its size.
    #[test]
    fn a_strip_is_gone_through_in_squares() {
        let strip = |spacing: f64| -> Vec<[f64; 2]> {
            (0..4096)
                .map(|a| [-3.0 + spacing * f64::from(a % 256), 7.0 + spacing * f64::from(a / 256)])
                .collect()
        };
        let order = along_curve(&strip(1.0));
        assert!(order.chunks(256).all(|square| square.iter().all(|a| a % 256 / 16 == square[0] % 256 / 16)));
        assert_eq!(order, along_curve(&strip(2_f64.powi(-7))));
    }

    /// The outermost points of a cube stay in it.
    #[test]
    fn corners_of_a_cube_are_gone_round() {
        let corners: Vec<[f64; 3]> = (0..8_u8).map(|a| [a & 1, a >> 1 & 1, a >> 2].map(f64::from)).collect();
        let order = along_curve(&corners);
        assert_eq!(order[0], 0);
        assert!(order.windows(2).all(|pair| (pair[0] ^ pair[1]).count_ones() == 1), "{order:?}");
    }

    #[test]
    fn order_bears_lines_points_and_what_is_no_number() {
        assert_eq!(along_curve::<2>(&[]), [0_u32; 0]);
        assert_eq!(along_curve(&[[3.0, 4.0]; 3]), [0, 1, 2]);
        let line: Vec<_> = (0..100).map(|i| [7.0, 1e-3 * f64::from(i), 7.0]).collect();
        let mut order = along_curve(&line);
        if order[0] != 0 {
            order.reverse();
        }
        assert_eq!(order.len(), 100);
        let odd = [[f64::NAN, 0.0], [0.0, f64::INFINITY], [1.0, f64::NEG_INFINITY], [2.0, 3.0]];
        let mut order = along_curve(&odd);
        order.sort_unstable();
        assert_eq!(order, [0, 1, 2, 3]);
    }
}
