//! Heat: changes of temperature of cells, which press on what keeps them from expanding.
//!
//! A cell that is warmer by θ stores `ψ = ½ ε·Cε − N_θ·e − M_θ·κ + ψ_θ` ([`shell_kinematics::Expansion`]): to its strains the heat is an initial stress of the
//! resultants −N_θ and −M_θ. These are linear in θ and θ in the level, so that at a level λ
//!
//! ```text
//! f = −∂U/∂q = f(0) + λ f_θ(q)        ∂f/∂λ = f_θ(q) = Σ_p w_p (N_θ·∂e/∂q + M_θ·∂κ/∂q)        K = ∂²U/∂q²
//! ```
//!
//! the tangent is that of a shell under the present stresses, what a level adds to the forces is exact at any state, and ψ_θ is of second degree in λ.
//! Temperatures of a cell add up before their energy is found; each belongs to the preload or to what the level counts ([`LoadCase`]). In a march all of
//! them are there from the start.

use shell_kinematics::{Blocked, Expansion};

use crate::conditions::case::LoadCase;
use crate::conditions::spread::check_cells;
use crate::error::{HeatError, ShellError};
use crate::reference::Reference;

/// A change of temperature of some cells.
#[derive(Clone, Debug)]
pub struct Temperature {
    /// The cells.
    pub cells: Vec<u32>,
    /// Of each cell the change in the middle of its section, and that of the upper face, to which the normal points, less that of the lower \[Θ\].
    pub changes: Vec<[f64; 2]>,
    /// The load case to which it belongs.
    pub case: LoadCase,
}

/// Parts that are there of the initial stress, and of the temperatures of preload and loading \[–\].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shares {
    pub stress: f64,
    pub preload: f64,
    pub loading: f64,
}

/// The temperatures of a shell and what each of its points does about them.
pub(crate) struct Heat {
    /// Sections that differ, with the height of each over the particles \[L\].
    sections: Vec<(Expansion, f64)>,
    /// Section of each point, one up; zero of points that are not heated.
    of_point: Vec<u32>,
    /// Changes at each point by the temperatures of the preload and of the loading; empty where none belongs to it.
    preload: Vec<[f64; 2]>,
    loading: Vec<[f64; 2]>,
}

impl Heat {
    /// Puts temperatures on points, `section` being what one of them has, and its height.
    ///
    /// # Errors
    /// [`ShellError`] for empty sets, cells beyond the cloud, changes that are not one a cell and finite, and sections that do not say how they expand.
    pub fn new(
        temperatures: &[Temperature],
        reference: &Reference,
        section: impl Fn(usize) -> (Option<Expansion>, f64),
    ) -> Result<Self, ShellError> {
        let count = reference.cloud.cells.len();
        let (sections, of_point) = (Vec::new(), vec![0; count]);
        let mut heat = Self { sections, of_point, preload: Vec::new(), loading: Vec::new() };
        for (number, Temperature { cells, changes, case }) in temperatures.iter().enumerate() {
            check_cells("a change of temperature", cells, &reference.cloud)?;
            if changes.len() != cells.len() || !changes.as_flattened().iter().all(|change| change.is_finite())
            {
                return Err(HeatError::Changes { number }.into());
            }
            for &cell in cells {
                if heat.of_point[cell as usize] == 0 {
                    let (expansion, height) = section(cell as usize);
                    let own = (expansion.ok_or(HeatError::NoExpansion { number, cell })?, height);
                    if heat.sections.last() != Some(&own) {
                        heat.sections.push(own);
                    }
                    heat.of_point[cell as usize] = heat.sections.len() as u32;
                }
            }
            let sums = if *case == LoadCase::Preload { &mut heat.preload } else { &mut heat.loading };
            sums.resize(count, [0.0; 2]);
            for (&cell, change) in cells.iter().zip(changes) {
                sums[cell as usize].iter_mut().zip(change).for_each(|(sum, change)| *sum += change);
            }
        }
        Ok(heat)
    }

    /// What keeps a point from straining under parts of the temperatures.
    pub fn blocked(&self, point: usize, shares: &Shares) -> Blocked {
        let Some(section) = (self.of_point[point] as usize).checked_sub(1) else { return Blocked::default() };
        let of = |changes: &[[f64; 2]]| changes.get(point).copied().unwrap_or_default();
        let (before, own) = (of(&self.preload), of(&self.loading));
        let change = |k: usize| shares.preload * before[k] + shares.loading * own[k];
        let (expansion, height) = &self.sections[section];
        expansion.blocked([change(0), change(1)], *height)
    }

    /// Whether a temperature belongs to the preload.
    pub fn preloads(&self) -> bool {
        !self.preload.is_empty()
    }
}
