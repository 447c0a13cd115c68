//! A study by its number of cells: it runs on other lattices as well, which tell its errors as those beside a scene do.

use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};
use std::sync::Arc;

use super::outcome::Outcome;

/// Spacings of the other lattices over its own: first those of marches in a plane, then those that `coque run --error` tries of all scenes.
const MARCHED: [f64; 2] = [1.5, 2.25];
const WANTED: [[f64; 2]; 4] =
    [[SQRT_2, 2.0], [2.0, FRAC_1_SQRT_2], [SQRT_2, FRAC_1_SQRT_2], [FRAC_1_SQRT_2, 0.5]];
/// By how much a spacing may differ from the one wanted, as a factor.
const NEAR: f64 = 1.2;
/// Fewest cells.
const FEWEST: usize = 3;

/// A study of a body that has so many cells along a length.
#[derive(Clone)]
pub struct Lattices {
    /// Cells along that length, on its own lattice.
    pub cells: usize,
    /// What numbers of cells are multiples of, so that the other lengths are whole numbers of cells.
    pub step: usize,
    /// Whether it is a march of a fluid in a plane.
    pub marched: bool,
    /// The study with so many cells.
    pub run: Arc<dyn Fn(usize) -> Result<Outcome, String> + Send + Sync>,
}

impl Lattices {
    /// Of a study without time with so many cells.
    pub fn of(cells: usize, run: impl Fn(usize) -> Result<Outcome, String> + Send + Sync + 'static) -> Self {
        Self { cells, step: 1, marched: false, run: Arc::new(run) }
    }

    /// Of a march of a fluid in a plane.
    pub fn marched(
        cells: usize,
        step: usize,
        run: impl Fn(usize) -> Result<Outcome, String> + Send + Sync + 'static,
    ) -> Self {
        Self { step, marched: true, ..Self::of(cells, run) }
    }

    /// Numbers of cells of the other lattices.
    ///
    /// # Errors
    /// In words, where there are none.
    pub fn others(&self) -> Result<[usize; 2], String> {
        let marched = Some(MARCHED).filter(|_| self.marched);
        let both = |wanted: [f64; 2]| Some([self.nearest(wanted[0])?, self.nearest(wanted[1])?]);
        let found = marched.into_iter().chain(WANTED).find_map(both);
        found.ok_or_else(|| format!("no number of cells beside {} by steps of {}", self.cells, self.step))
    }

    /// The number of cells whose spacing is nearest to so many of its own.
    fn nearest(&self, wanted: f64) -> Option<usize> {
        let off = |cells: usize| (libm::log(self.cells as f64 / cells as f64 / wanted)).abs();
        let tried = (1..=2 * self.cells / self.step).map(|count| count * self.step);
        let near = tried.filter(|&cells| cells >= FEWEST && off(cells) <= libm::log(NEAR));
        near.min_by(|&a, &b| off(a).total_cmp(&off(b)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_other_lattices_are_coarser_where_there_are_cells_enough() {
        let of = |cells, step, marched| {
            let none = Lattices::of(cells, |_| Err("not run".into()));
            Lattices { step, marched, ..none }.others()
        };
        assert_eq!(of(20, 1, false), Ok([14, 10]));
        assert_eq!(of(24, 1, true), Ok([16, 11]));
        assert_eq!(of(40, 8, true), Ok([24, 16]));
        // Four cells have room for one coarser lattice, three for none.
        assert_eq!(of(4, 1, false), Ok([3, 6]));
        assert_eq!(of(3, 1, false), Ok([4, 6]));
        assert!(of(8, 8, false).is_err());
    }
}
