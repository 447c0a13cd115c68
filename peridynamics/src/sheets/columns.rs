//! The sweep over columns: what the sheets, the shear of pairs and the thickness ask of places and directors.

use std::borrow::Cow;
use std::sync::Arc;

use parallel::ByChunk;
use sph_core::Vec3;

use super::shear::{Pair, Shear};
use crate::bonds::images::Images;
use crate::bonds::network::Row;

/// What columns store by themselves.
#[derive(Clone, Debug)]
pub(crate) struct Columns {
    /// Height z₀ of the upper sheet above the mid-surface \[L\].
    pub height: f64,
    /// `E t Aᵢ` \[F L\].
    pub stiffness: Vec<f64>,
    /// `½ d₀·d₀` at rest \[–\].
    pub rest: Vec<f64>,
    pub shear: Shear,
    /// What planes of symmetry make of the columns.
    pub images: Option<Arc<Images>>,
    /// Energy of each chunk of columns.
    pub energies: Vec<f64>,
}

impl Columns {
    /// The points of a sheet, `x + z₀ d` of the upper side 1 or `x − z₀ d` of the lower side −1.
    pub fn points(&self, rows: &[Row], side: f64) -> Vec<Row> {
        let (places, directors) = rows.split_at(self.rest.len());
        let z = side * self.height;
        let point = |(x, d): (&Row, &Row)| [x[0] + z * d[0], x[1] + z * d[1], x[2] + z * d[2], 0.0];
        places.iter().zip(directors).map(point).collect()
    }

    /// Rows with places and directors of images behind them; of displacements, without `shift`, with those of displacements.
    pub fn extended<'a>(&self, rows: &'a [Row], shift: bool) -> Cow<'a, [Row]> {
        let Some(images) = &self.images else { return Cow::Borrowed(rows) };
        let (places, directors) = rows.split_at(self.rest.len());
        let behind = |rows: &[Row], shift: bool| {
            let vectors: Vec<Vec3> = rows.iter().map(|row| Vec3::new(row[0], row[1], row[2])).collect();
            images.extended(&vectors, shift).split_off(rows.len())
        };
        let images = behind(places, shift).into_iter().chain(behind(directors, false));
        Cow::Owned(rows.iter().copied().chain(images.map(|v| [v.x, v.y, v.z, 0.0])).collect())
    }

    /// The column of a row of places or directors, and what a displacement of it makes of that row along the axes.
    pub fn source(&self, row: usize) -> (usize, [f64; 3]) {
        let count = self.rest.len();
        match &self.images {
            // Behind the nodes an image has the number of its row, less those of the directors.
            Some(images) if row >= 2 * count => (images.source(row - count), images.signs(row - count)),
            _ => (row % count, [1.0; 3]),
        }
    }

    /// The strain `½ (d·d − d₀·d₀)` of the thickness.
    #[inline(always)]
    pub fn thickening(&self, column: usize, d: &Row) -> f64 {
        0.5 * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - self.rest[column]
    }

    /// Forces on all rows from those of the two sheets on their nodes; returns the energy of shear and thickness \[F L\].
    pub fn gather(&mut self, rows: &[Row], sheets: [&[Row]; 2], forces: &mut [Row], threads: usize) -> f64 {
        let mut energies = std::mem::take(&mut self.energies);
        let (places, directors) = forces.split_at_mut(self.rest.len());
        let chunk = |first: usize, ((places, directors), ByChunk(energy)): Chunk<'_>| {
            let [energy, ..] = energy else { return };
            *energy = 0.0;
            for (i, (of_x, of_d)) in places.iter_mut().zip(directors).enumerate() {
                let column = first + i;
                *energy += self.column(column, rows, sheets.map(|forces| &forces[column]), of_x, of_d);
            }
        };
        parallel::chunks(threads, ((places, directors), ByChunk(&mut energies)), chunk);
        let stored = energies.iter().sum();
        self.energies = energies;
        stored
    }

    /// Second derivatives at `rows` times the motions of `along` of all rows, from those of the two sheets on their nodes.
    pub fn gather_tangent(&self, rows: &[Row], along: &[Row], sheets: [&[Row]; 2], out: &mut [Row]) {
        let count = self.rest.len();
        let (places, directors) = out.split_at_mut(count);
        for i in 0..count {
            let (x, d, u, e) = (&rows[i], &rows[count + i], &along[i], &along[count + i]);
            let (mut on_x, mut on_d) = ([0.0; 3], [0.0; 3]);
            for pair in self.shear.of(i) {
                let (j, turned) = (pair.other as usize, pair.turned as usize);
                let bond = pair.sheared((x, d), (&rows[j], &rows[turned]));
                let sum: [f64; 3] = std::array::from_fn(|k| e[k] + along[turned][k]);
                let apart: [f64; 3] = std::array::from_fn(|k| along[j][k] - u[k]);
                let strain: f64 = (0..3).map(|k| bond.across[k] * apart[k] + bond.along[k] * sum[k]).sum();
                let (change, twist) = (pair.stiffness * strain, pair.stiffness * bond.strain * pair.half);
                for k in 0..3 {
                    on_x[k] -= change * bond.across[k] + twist * sum[k];
                    on_d[k] += change * bond.along[k] + twist * apart[k];
                }
            }
            let pressure = self.stiffness[i] * self.thickening(i, d);
            let change = self.stiffness[i] * (d[0] * e[0] + d[1] * e[1] + d[2] * e[2]);
            let [up, down] = sheets.map(|products| &products[i]);
            for k in 0..3 {
                places[i][k] = (up[k] + down[k]) + on_x[k];
                directors[i][k] =
                    self.height * (up[k] - down[k]) + (on_d[k] + change * d[k] + pressure * e[k]);
            }
        }
    }

    /// What the shear of a column's pairs pulls along an axis that reach through its plane of symmetry on a side \[F\].
    pub fn across(&self, rows: &[Row], column: usize, (axis, side): (usize, i32)) -> f64 {
        let (Some(images), count) = (&self.images, self.rest.len()) else { return 0.0 };
        let behind = |row: usize| row >= 2 * count && images.side(row - count, axis) == side;
        let pairs = self.shear.of(column).iter().filter(|pair| behind(pair.other as usize));
        let of = |pair: &Pair| {
            let end = (&rows[pair.other as usize], &rows[pair.turned as usize]);
            let sheared = pair.sheared((&rows[column], &rows[count + column]), end);
            pair.stiffness * sheared.strain * sheared.across[axis]
        };
        images.counts(column, axis) * pairs.map(of).sum::<f64>()
    }

    /// Energy of the thickness of a column, and half of that of its pairs \[F L\].
    pub fn stored(&self, rows: &[Row], column: usize) -> f64 {
        let mut unused = [[0.0; 4]; 4];
        let [up, down, of_x, of_d] = &mut unused;
        self.column(column, rows, [up, down], of_x, of_d)
    }

    /// Forces on one column; returns its thickness' energy and half of that of its pairs.
    #[inline(always)]
    fn column(&self, i: usize, rows: &[Row], [up, down]: [&Row; 2], of_x: &mut Row, of_d: &mut Row) -> f64 {
        let (x, d) = (&rows[i], &rows[self.rest.len() + i]);
        let (mut on_x, mut on_d, mut stored) = ([0.0; 3], [0.0; 3], 0.0);
        for pair in self.shear.of(i) {
            let bond = pair.sheared((x, d), (&rows[pair.other as usize], &rows[pair.turned as usize]));
            let force = pair.stiffness * bond.strain;
            for k in 0..3 {
                on_x[k] -= force * bond.across[k];
                on_d[k] += force * bond.along[k];
            }
            stored += force * bond.strain;
        }
        let thickening = self.thickening(i, d);
        let pressure = self.stiffness[i] * thickening;
        for k in 0..3 {
            of_x[k] = (up[k] + down[k]) + on_x[k];
            of_d[k] = self.height * (up[k] - down[k]) + (on_d[k] + pressure * d[k]);
        }
        0.25 * stored + 0.5 * pressure * thickening
    }
}

/// Forces on places, on directors, and the energy of a chunk.
type Chunk<'a> = ((&'a mut [Row], &'a mut [Row]), ByChunk<'a, f64>);
