//! A term of a tangent beside its pattern: a number times a vector with itself, as what is enclosed couples all that encloses it.

use crate::vectors::dot;

/// `c g gᵀ`, added to a tangent.
#[derive(Clone, Debug, PartialEq)]
pub struct RankOne {
    /// c, in units of the tangent where g has none.
    pub factor: f64,
    /// g, a number for each unknown.
    pub along: Vec<f64>,
}

impl RankOne {
    /// `out += share c g (g·x)`.
    pub fn add_product(&self, share: f64, x: &[f64], out: &mut [f64]) {
        let along = share * self.factor * dot(&self.along, x);
        out.iter_mut().zip(&self.along).for_each(|(sum, g)| *sum += along * g);
    }

    /// `out += |c| |g| (|g|·|x|)`: with ones for x the sums over the rows of magnitudes.
    pub fn add_magnitudes(&self, x: &[f64], out: &mut [f64]) {
        let along: f64 = self.along.iter().zip(x).map(|(g, x)| (g * x).abs()).sum();
        let along = self.factor.abs() * along;
        out.iter_mut().zip(&self.along).for_each(|(sum, g)| *sum += along * g.abs());
    }
}
