//! The steady answer by one factor at each frequency.

use super::motion::{CycleEnergies, EnergyForms, HarmonicMotion};
use super::{Complex, HarmonicDamping};
use crate::error::require;
use crate::rank_one::RankOne;
use crate::{Equilibrium, EquilibriumError, Inertia, SymmetricSolver};

/// Solves for the steady answer of a system, frequency by frequency.
///
/// With damping `A = X + iY`, `X = K − ω²M`, `Y = Im κ K + ωαM`, is complex symmetric. Its two parts are solved together by the real symmetric
/// matrix of twice the unknowns, each beside its other part \[day2001\]:
///
/// ```text
/// |  X  −Y | | Re u |   | p |
/// | −Y  −X | | Im u | = | 0 |
/// ```
///
/// which the factor `L B Lᵀ` with exchanges serves as it is. Without damping X alone is solved, and the signs of its pivots count the natural
/// frequencies below ω.
pub struct DirectResponse {
    solver: SymmetricSolver,
    forms: EnergyForms,
    load: Vec<f64>,
    damping: HarmonicDamping,
    inertia: Inertia,
}

impl DirectResponse {
    /// Of the present state of a system, and the load of its level one; ordered and analysed once.
    ///
    /// # Errors
    /// [`EquilibriumError::Option`] for a ratio, which modes alone have; of the analysis of the pattern.
    pub fn new<E: Equilibrium + ?Sized>(
        system: &mut E,
        level: f64,
        damping: HarmonicDamping,
    ) -> Result<Self, EquilibriumError> {
        if let HarmonicDamping::Ratio(ratio) = damping {
            require(false, "damping ratio", ratio, "left out of a direct answer: modes alone have one")?;
        }
        let (n, forms) = (system.unknowns(), EnergyForms::of(system, level));
        let (pattern, stiffness) = (&forms.pattern, &forms.stiffness);
        let mut load = vec![0.0; n];
        system.load_rate(level, &mut load);
        let places = system.coordinates();
        let mut first = vec![0.0; n];
        let on_diagonal = pattern.iter().zip(stiffness).filter(|((row, column), _)| row == column);
        on_diagonal.for_each(|(&(row, _), k)| first[row] = k.abs());
        // Scaled by K: at some frequency an entry of K − ω²M may be next to nothing.
        let solver = if damping == HarmonicDamping::None {
            let mut solver = SymmetricSolver::placed(n, pattern, places.as_deref())?;
            solver.refer_to(&first);
            solver
        } else {
            let places = places.map(|places| twice(&places));
            let mut solver = SymmetricSolver::placed(2 * n, &doubled(pattern), places.as_deref())?;
            solver.refer_to(&twice(&first));
            solver
        };
        Ok(Self { solver, forms, load, damping, inertia: Inertia::default() })
    }

    /// The answer at a circular frequency \[1/T\].
    ///
    /// # Errors
    /// [`EquilibriumError::Resonance`] where nothing damps and ω is a natural frequency within rounding; of the solver.
    pub fn at(&mut self, omega: f64) -> Result<HarmonicMotion, EquilibriumError> {
        self.factorise(omega)?;
        let load = std::mem::take(&mut self.load);
        let answer = self.under(&load, omega);
        self.load = load;
        answer
    }

    /// Makes the factor at a circular frequency \[1/T\].
    ///
    /// # Errors
    /// Of the solver.
    pub fn factorise(&mut self, omega: f64) -> Result<(), EquilibriumError> {
        let EnergyForms { pattern, stiffness, beside, masses } = &self.forms;
        let (square, (mass, loss)) = (omega * omega, self.damping.at(omega));
        let of = |(row, column): (usize, usize), k: f64| {
            let m = if row == column { masses[row] } else { 0.0 };
            Complex::new(k - square * m, loss * k + omega * mass * m)
        };
        let entries = pattern.iter().zip(stiffness);
        if self.damping == HarmonicDamping::None {
            let values: Vec<f64> = entries.map(|(&place, &k)| of(place, k).re).collect();
            self.inertia = self.solver.factor_with(&values, beside)?;
            return Ok(());
        }
        let mut values = Vec::with_capacity(4 * pattern.len());
        for (&place, &k) in entries {
            let a = of(place, k);
            values.extend([a.re, -a.im]);
            values.extend((place.0 != place.1).then_some(-a.im));
            values.push(-a.re);
        }
        let beside: Vec<RankOne> = beside.iter().flat_map(|term| doubled_term(term, loss)).collect();
        self.inertia = self.solver.factor_with(&values, &beside)?;
        Ok(())
    }

    /// The answer to a load in one phase, by the factor last made, at its circular frequency.
    ///
    /// # Errors
    /// As of [`DirectResponse::at`].
    pub fn under(&mut self, load: &[f64], omega: f64) -> Result<HarmonicMotion, EquilibriumError> {
        if self.damping == HarmonicDamping::None {
            let mut real = load.to_vec();
            self.solve(&mut real, omega)?;
            let imaginary = vec![0.0; real.len()];
            return Ok(HarmonicMotion { real, imaginary });
        }
        let mut both: Vec<f64> = load.iter().flat_map(|&p| [p, 0.0]).collect();
        self.solve(&mut both, omega)?;
        let part = |k: usize| both.as_chunks::<2>().0.iter().map(|both| both[k]).collect();
        Ok(HarmonicMotion { real: part(0), imaginary: part(1) })
    }

    /// Energies of an answer at its circular frequency.
    pub fn energies(&self, motion: &HarmonicMotion, omega: f64) -> CycleEnergies {
        self.energies_under([&self.load, &[]], motion, omega)
    }

    /// The same of an answer to a load with both parts, the second empty where it is zero.
    pub fn energies_under(&self, load: [&[f64]; 2], motion: &HarmonicMotion, omega: f64) -> CycleEnergies {
        CycleEnergies::of(self.forms.sums(load, motion), omega, self.damping.at(omega))
    }

    /// Signs of the pivots of K: negative ones tell that the state is not stable, zeros that it may move freely.
    ///
    /// # Errors
    /// Of the solver.
    pub fn stability<E: Equilibrium + ?Sized>(&self, system: &E) -> Result<Inertia, EquilibriumError> {
        let places = system.coordinates();
        let mut solver =
            SymmetricSolver::placed(self.forms.masses.len(), &self.forms.pattern, places.as_deref())?;
        solver.factor_with(&self.forms.stiffness, &self.forms.beside)
    }

    /// Natural frequencies below the last one answered for; none where damping leaves them no place on the axis.
    pub fn below(&self) -> Option<usize> {
        (self.damping == HarmonicDamping::None).then_some(self.inertia.negative)
    }

    /// κ: what a force that strains exert is times the elastic one.
    pub fn kappa(&self, omega: f64) -> Complex {
        Complex::new(1.0, self.damping.at(omega).1)
    }

    /// Masses of the unknowns.
    pub fn masses(&self) -> &[f64] {
        &self.forms.masses
    }

    fn solve(&mut self, right: &mut [f64], omega: f64) -> Result<(), EquilibriumError> {
        self.solver.solve(right).map_err(|error| match error {
            EquilibriumError::Singular { .. } => EquilibriumError::Resonance { omega },
            other => other,
        })
    }
}

/// Each item twice, for both parts of an unknown.
fn twice<T: Copy>(list: &[T]) -> Vec<T> {
    list.iter().flat_map(|&item| [item; 2]).collect()
}

/// The lower triangle of the matrix of twice the unknowns, an entry after the other of the pattern.
fn doubled(pattern: &[(usize, usize)]) -> Vec<(usize, usize)> {
    let mut all = Vec::with_capacity(4 * pattern.len());
    for &(row, column) in pattern {
        let (r, c) = (2 * row, 2 * column);
        all.extend([(r, c), (r + 1, c)]);
        all.extend((row != column).then_some((r, c + 1)));
        all.push((r + 1, c + 1));
    }
    all
}

/// `κ c g gᵀ` in the matrix of twice the unknowns: `c` on both diagonal blocks, and `−c Im κ` across, which is half of the difference of what
/// acts on the sum and on the difference of both parts.
fn doubled_term(term: &RankOne, loss: f64) -> Vec<RankOne> {
    let of = |factor: f64, real: f64, imaginary: f64| RankOne {
        factor,
        along: term.along.iter().flat_map(|g| [real * g, imaginary * g]).collect(),
    };
    let across = 0.5 * loss * term.factor;
    let mut all = vec![of(term.factor, 1.0, 0.0), of(-term.factor, 0.0, 1.0)];
    if loss > 0.0 {
        all.extend([of(-across, 1.0, 1.0), of(across, 1.0, -1.0)]);
    }
    all
}
