//! Second derivatives of a plate's energy.
//!
//! Those of the two sheets, K₊ and K₋ over their points `x ± z₀ d`, go over to places and directors by the chain rule:
//!
//! ```text
//! K_xx = K₊ + K₋      K_dx = z₀ (K₊ − K₋)      K_dd = z₀² (K₊ + K₋)
//! ```
//!
//! A pair adds `k (∂γ ∂γᵀ + γ ∂²γ)`, of which the second joins places with directors alone, a column `E t A [d dᵀ + ½ (d·d −
//! d₀·d₀) I]`. Sheets are added before anything else: a plate and its mirror image have the same bits.

use super::columns::Columns;
use super::plate::Plate;
use super::shear::Pair;
use crate::bonds::couplings::{Coupling, add_outer};
use crate::bonds::network::Row;
use implicit_statics::BlockPattern;
use sph_core::Vec3;

impl Plate {
    /// Pairs of rows with second derivatives: of columns that share a bond or a dilatation in either sheet, or shear, all
    /// their rows.
    pub fn pattern(&self) -> BlockPattern {
        let [upper, lower] = self.sheets.each_ref().map(|sheet| sheet.network.couplings());
        let count = self.columns.rest.len();
        let mut joined: Vec<Vec<u32>> = vec![Vec::new(); count];
        for a in 0..count {
            let of = |sheet: &BlockPattern| sheet.columns(a).to_vec();
            let shearing =
                self.columns.shear.of(a).iter().map(|pair| self.columns.source(pair.other as usize).0 as u32);
            let mut before =
                [of(&upper), of(&lower), shearing.filter(|&b| (b as usize) < a).collect()].concat();
            before.sort_unstable();
            before.dedup();
            for &b in before.iter().filter(|&&b| (b as usize) < a) {
                joined[b as usize].push(a as u32);
            }
            // What stands there already comes from columns before; later ones add themselves.
            joined[a].extend(before);
        }
        BlockPattern::new(2 * count, |row, partners| {
            let of = &joined[row % count];
            partners.extend(of);
            if row >= count {
                partners.extend(of.iter().map(|&b| b + count as u32));
            }
            partners.retain(|&b| b as usize <= row);
        })
    }

    /// Second derivatives over the pattern; the pulls of bonds, pairs and thickness are those of `stressed`, if it is given.
    pub fn hessian(
        &self,
        (rows, stressed): (&[Row], Option<&[Row]>),
        pattern: &BlockPattern,
        blocks: &mut [Coupling],
        threads: usize,
    ) {
        let count = self.columns.rest.len();
        let of_places = pattern.of(count).start;
        let [upper, lower] = [1.0, -1.0].map(|side| {
            let sheet = &self.sheets[usize::from(side < 0.0)];
            let points = |rows: &[Row]| self.columns.points(rows, side);
            let (here, there) = (points(rows), stressed.map(points));
            let mut out = vec![[[0.0; 3]; 3]; of_places];
            let linearised = sheet.network.linearised(&here, there.as_deref());
            linearised.second_derivatives(pattern, &mut out, threads);
            out
        });
        let z = self.columns.height;
        for (row, column, block) in pattern.pairs() {
            let (a, b) = (row % count, column % count);
            let Some(number) = pattern.find(a.max(b) as u32, a.min(b) as u32) else { continue };
            let (up, down) = (&upper[number], &lower[number]);
            for i in 0..3 {
                for j in 0..3 {
                    let (i_of, j_of) = if a < b { (j, i) } else { (i, j) };
                    let (up, down) = (up[i_of][j_of], down[i_of][j_of]);
                    blocks[block][i][j] = match (row >= count, column >= count) {
                        (false, _) => up + down,
                        (true, false) => z * (up - down),
                        (true, true) => z * z * (up + down),
                    };
                }
            }
        }
        let rows = &*self.columns.extended(rows, true);
        let stressed = stressed.map(|rows| self.columns.extended(rows, true));
        let mut sum = Sum { columns: &self.columns, pattern, blocks };
        for a in 0..count {
            sum.add_column(a, rows, stressed.as_deref().unwrap_or(rows));
        }
    }

    /// The least of present over reference length of whole bonds in either sheet, and the column that has it.
    pub fn shortest_bond(&self, rows: &[Row]) -> (usize, f64) {
        let [upper, lower] = [1.0, -1.0].map(|side| {
            self.sheets[usize::from(side < 0.0)].network.shortest(&self.columns.points(rows, side))
        });
        if lower.1 < upper.1 { lower } else { upper }
    }
}

/// Blocks to which columns and their pairs are added.
struct Sum<'a> {
    columns: &'a Columns,
    pattern: &'a BlockPattern,
    blocks: &'a mut [Coupling],
}

impl Sum<'_> {
    /// Adds what column a has in its own rows, from its thickness and its pairs.
    fn add_column(&mut self, a: usize, rows: &[Row], stressed: &[Row]) {
        let columns = self.columns;
        let turned = columns.rest.len() + a;
        let d = Vec3::from_fn(|k, _| rows[turned][k]);
        let pressure = columns.stiffness[a] * columns.thickening(a, &stressed[turned]);
        let own = self.block(turned, turned);
        add_outer(own, columns.stiffness[a], &d, &d);
        (0..3).for_each(|k| own[k][k] += pressure);
        for pair in columns.shear.of(a) {
            self.add_pair(a, pair, rows, stressed);
        }
    }

    /// Adds the blocks of a pair in the rows of column a.
    fn add_pair(&mut self, a: usize, pair: &Pair, rows: &[Row], stressed: &[Row]) {
        let count = self.columns.rest.len();
        let (b, signs) = self.columns.source(pair.other as usize);
        let signed = |v: &Vec3| Vec3::from_fn(|k, _| v[k] * signs[k]);
        let end = |rows: &[Row]| [rows[pair.other as usize], rows[pair.turned as usize]];
        let sheared = |rows: &[Row]| {
            let [y, e] = end(rows);
            pair.sheared((&rows[a], &rows[count + a]), (&y, &e))
        };
        let (now, k) = (sheared(rows), pair.stiffness);
        let [along, across] = [Vec3::from(now.along), Vec3::from(now.across)];
        let twist = k * sheared(stressed).strain * pair.half;
        add_outer(self.block(a, a), k, &across, &across);
        add_outer(self.block(count + a, count + a), k, &along, &along);
        for (place, sides) in [(a, [-1.0; 3]), (b, signs)] {
            let block = self.block(count + a, place);
            add_outer(block, k, &along, &Vec3::from_fn(|i, _| across[i] * sides[i]));
            (0..3).for_each(|i| block[i][i] += sides[i] * twist);
        }
        if b <= a {
            add_outer(self.block(a, b), -k, &across, &signed(&across));
            add_outer(self.block(count + a, count + b), k, &along, &signed(&along));
        }
    }

    fn block(&mut self, row: usize, column: usize) -> &mut Coupling {
        let place = self.pattern.columns(row).partition_point(|&b| (b as usize) < column);
        &mut self.blocks[self.pattern.of(row).start + place]
    }
}
