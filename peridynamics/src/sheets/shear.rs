//! Transverse shear of pairs of columns.

use sph_core::Vec3;

use crate::bonds::families::{Families, Seen};
use crate::bonds::network::Row;
use crate::formulation::Influence;
use crate::material::Moduli;

/// What a Mindlin plate makes of the uniform shear of its thickness.
const SHEAR_FACTOR: f64 = 5.0 / 6.0;

/// Pairs of columns that shear, each from both ends.
#[derive(Clone, Debug)]
pub(crate) struct Shear {
    /// First pair of each column, and the end.
    pub starts: Vec<u32>,
    pub pairs: Vec<Pair>,
}

/// A pair seen from one of its columns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    /// The place of the column at the other end: its row.
    pub other: u32,
    /// The row of its director.
    pub turned: u32,
    /// k \[F L\] of the whole pair.
    pub rigidity: f64,
    /// k at present: half of it with a broken bond in one sheet, none with both broken.
    pub stiffness: f64,
    /// `½/r` \[1/L\].
    pub half: f64,
    /// γ₀, of the pair at rest \[–\].
    pub rest: f64,
}

/// A pair at the present.
pub(crate) struct Sheared {
    /// `½ (xⱼ − xᵢ)/r`, what γ is per director \[–\].
    pub along: [f64; 3],
    /// `½ (dᵢ + dⱼ)/r`, what γ is per place of the other column \[1/L\].
    pub across: [f64; 3],
    /// γ.
    pub strain: f64,
}

impl Pair {
    /// The pair between a column and another, each a place and a director; γ changes its sign from end to end, not its value.
    #[inline(always)]
    pub fn sheared(&self, (x, d): (&Row, &Row), (y, e): (&Row, &Row)) -> Sheared {
        let along: [f64; 3] = std::array::from_fn(|k| (y[k] - x[k]) * self.half);
        let sum: [f64; 3] = std::array::from_fn(|k| d[k] + e[k]);
        let strain = along[0] * sum[0] + along[1] * sum[1] + along[2] * sum[2] - self.rest;
        Sheared { along, across: sum.map(|sum| sum * self.half), strain }
    }
}

impl Shear {
    /// Joins the columns of all families; places and directors are those at rest, behind them those of images, areas those that
    /// the plate has of its columns; thickness and bending stiffness are those of the plate.
    pub fn new(
        families: &Families,
        influence: Influence,
        (places, directors): (&[Vec3], &[Vec3]),
        areas: &[f64],
        moduli: &Moduli,
        thickness: f64,
    ) -> Self {
        // D = E/(1 − ν²) t³/12, in a plane λ + 2μ = E/(1 − ν²).
        let bending = (moduli.lambda + 2.0 * moduli.mu) * thickness.powi(3) / 12.0;
        let share = |bond: &Seen| influence.weight(bond.length, families.reach) * families.volume(bond);
        let whole: Vec<f64> =
            (0..families.len()).map(|node| families.bonds(node).map(|bond| share(&bond)).sum()).collect();
        let areas = &*families.whole(areas);
        let (count, images) = (families.len(), places.len() - families.len());
        let pair = |bond: Seen| {
            let Seen { node, other, length: r, .. } = bond;
            let area = areas[node] * share(&bond) / whole[node]
                + areas[other] * share(&families.back(&bond)) / whole[families.source(other)];
            let compliance = 1.0 / (SHEAR_FACTOR * moduli.mu * thickness) + r * r / (12.0 * bending);
            let rigidity = families.share(node) * 2.0 * area / compliance;
            let (stiffness, half) = (rigidity, 0.5 / r);
            // Rows are places and directors, then those of images.
            let rows =
                if other < count { [other, count + other] } else { [count + other, count + images + other] };
            let [row_of_other, turned] = rows.map(|row| row as u32);
            let mut pair = Pair { other: row_of_other, turned, rigidity, stiffness, half, rest: 0.0 };
            let row = |v: &Vec3| [v.x, v.y, v.z, 0.0];
            let [x, d] = [&places[node], &directors[node]].map(row);
            let [y, e] = [&places[other], &directors[other]].map(row);
            pair.rest = pair.sheared((&x, &d), (&y, &e)).strain;
            pair
        };
        let bonds = (0..families.len()).flat_map(|node| families.bonds(node));
        Self { starts: families.starts.clone(), pairs: bonds.map(pair).collect() }
    }

    /// Pairs of a column.
    #[inline(always)]
    pub fn of(&self, column: usize) -> &[Pair] {
        &self.pairs[self.starts[column] as usize..self.starts[column + 1] as usize]
    }
}
