//! What a cut costs, against counts by hand.

mod lattice;

use lattice::{Numbering, Shares, block, sheet};

/// Whether ghosts over own and partners are these, as printed in so many digits.
fn holds(found: &Shares, ghosts: f64, partners: f64) {
    assert!((found.ghosts_over_own - ghosts).abs() <= 0.5e-3, "{found:?}");
    assert!((found.partners - partners).abs() <= 0.05, "{found:?}");
}

/// Sheets in rows: a border is one row, cut in one place; so a share has two of them, those at the ends one.
#[test]
fn rows_of_a_sheet() {
    for pack in [1, 4] {
        let found = sheet(1000, pack, Numbering::Rows, 64);
        // 2·63 borders of 1000 points and the cut's own ones, of 10⁶; 2·63/64 partners.
        holds(&found, 0.126, 1.97);
        // 10⁶ points are 1953⅛ chunks, some share has 31 of 30.5.
        assert!((found.most_over_mean - 31.0 * 512.0 * 64.0 / 1e6).abs() < 1e-9);
        // One border has 1000 points, one more where it is cut; packs add up to three at each of its two ends.
        assert!((2000..=2 * 1007).contains(&found.sent), "{found:?}");
    }
    // Bytes of six numbers: 4.9, 15.3 and 48 kB a step for 10⁴, 10⁵ and 10⁶ points on two peers.
    for (side, sent) in [(100, 101), (316, 317), (1000, 1001)] {
        let found = sheet(side, 1, Numbering::Rows, 2);
        assert!(found.sent.abs_diff(sent) <= 1, "{found:?}");
        assert!(sheet(side, 4, Numbering::Rows, 2).sent <= sent + 6);
    }
}

/// Along the curve shares are compact. A share of the grid of 8 × 8 squares of 125 points has 125 ghosts a side and one a corner: .028.
/// Pieces of the curve are cut at chunks instead, which leaves a tenth more; in rows there are four times as many.
#[test]
fn the_curve_on_a_sheet() {
    let squares = (2 * 7 * 8 * 125 * 2 + 7 * 7 * 4) as f64 / 1e6;
    let found = sheet(1000, 1, Numbering::Curve, 64);
    assert!((squares - 0.0282).abs() < 5e-5);
    holds(&found, 0.0306, 5.31);
    // Packs of four cells beside each other along the curve reach farther into other shares.
    holds(&sheet(1000, 4, Numbering::Curve, 64), 0.0493, 5.3);
}

/// Blocks with a horizon of three spacings.
#[test]
fn blocks() {
    // Slabs of eight and of one layer: three layers on either side, of which the ends lack some.
    holds(&block(64, Numbering::Rows, 8), 14.0 * 3.0 / 64.0, 14.0 / 8.0);
    holds(&block(64, Numbering::Rows, 64), (6.0 * 64.0 - 2.0 * (3.0 + 2.0 + 1.0)) / 64.0, 5.8125);
    // Octants: three faces of three layers, three edges and a corner rounded by the ball of the horizon.
    let (edge, corner) = (within(2), within(3));
    let octant = 3 * 3 * 32 * 32 + 3 * 32 * edge + corner;
    holds(&block(64, Numbering::Curve, 8), octant as f64 / 32_f64.powi(3), 7.0);
    // Cubes of 16 points a side, four along each axis, with one or two neighbours along it: faces, edges, corners; (2 + 3 + 3 + 2)³/64 − 1 partners.
    let mut ghosts = 0;
    for cube in 0..64_usize {
        let [a, b, c] = [cube % 4, cube / 4 % 4, cube / 16].map(|i| [1, 2, 2, 1][i]);
        ghosts += 3 * 16 * 16 * (a + b + c) + 16 * edge * (a * b + b * c + c * a) + corner * a * b * c;
    }
    holds(&block(64, Numbering::Curve, 64), ghosts as f64 / 64_f64.powi(3), 14.625);
}

/// Points with so many coordinates, all above zero, within three spacings.
fn within(dimensions: u32) -> usize {
    let square = |n: usize, i: u32| (n / 3_usize.pow(i) % 3 + 1).pow(2);
    (0..3_usize.pow(dimensions))
        .filter(|&n| (0..dimensions).map(|i| square(n, i)).sum::<usize>() <= 9)
        .count()
}
