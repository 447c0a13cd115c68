//! Natural frequencies by shift and invert, with the count that proves them complete.

use crate::added_mass::AddedMass;
use crate::effort::{Counted, CountingSolver, Spectrum, Watch};
use crate::eigen::{End, Krylov, Operator, Ritz};
use crate::error::require;
use crate::pattern::product;
use crate::rank_one::RankOne;
use crate::vectors::dot;
use crate::{Equilibrium, EquilibriumError};

/// How far beyond the last eigenvalue they are counted, relative to its distance from the shift: half of the gap to
/// the next one, within these.
const BEYOND: [f64; 2] = [1e-6, 1e-2];
/// Times the ends of the count are moved on where one of them falls on an eigenvalue.
const MOVES: usize = 4;
/// Times eigenvalues are sought again after the count said that some are missing.
const ROUNDS: usize = 6;

/// A mode of free vibration.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Eigenvalue ω² \[1/T²\]; negative where the state is unstable.
    pub eigenvalue: f64,
    /// An exact eigenvalue lies within this part of its distance from the shift \[–\].
    pub residual: f64,
    /// Shape, with unit mass: `φᵀMφ = 1`.
    pub shape: Vec<f64>,
}

impl Mode {
    /// Circular frequency ω \[1/T\]; 0 where the state is unstable.
    pub fn circular_frequency(&self) -> f64 {
        self.eigenvalue.max(0.0).sqrt()
    }
}

/// Modes of vibration about the present state with ω² nearest to `shift` \[1/T²\], in order of distance.
///
/// `(K − σM)⁻¹M` is iterated; a shift of 0 gives the lowest modes of a stable, supported structure. Where rigid
/// motions are free, shift a little below zero. Unknowns without mass follow statically.
pub fn natural_modes<'a, E: Equilibrium + ?Sized>(
    system: &mut E,
    level: f64,
    count: usize,
    shift: f64,
    watch: &'a mut Watch<'a>,
) -> Result<Spectrum<Mode>, EquilibriumError> {
    modes_beside(system, level, None, (count, shift), watch)
}

/// The same with the mass that a medium beside it adds: `K φ = ω² (M + Mₐ) φ`, shapes with unit mass of both.
pub fn natural_modes_with<'a, E: Equilibrium + ?Sized>(
    system: &mut E,
    level: f64,
    added: &mut AddedMass,
    (count, shift): (usize, f64),
    watch: &'a mut Watch<'a>,
) -> Result<Spectrum<Mode>, EquilibriumError> {
    modes_beside(system, level, Some(added), (count, shift), watch)
}

fn modes_beside<'a, E: Equilibrium + ?Sized>(
    system: &mut E,
    level: f64,
    added: Option<&mut AddedMass>,
    (count, shift): (usize, f64),
    watch: &'a mut Watch<'a>,
) -> Result<Spectrum<Mode>, EquilibriumError> {
    let pattern = system.pattern();
    let mut values = vec![0.0; pattern.len()];
    system.tangent(level, &mut values);
    let masses = system.vibrating_masses();
    let mut beside = system.beside_pattern(level);
    let n = masses.len();
    let solver = match &added {
        None => CountingSolver::new(n, &pattern, system.coordinates().as_deref(), watch)?,
        Some(added) => {
            let reach = added.reach();
            require(reach <= n, "unknown of an added mass", reach as f64, "one of the system's")?;
            let all = n + added.nodes();
            beside.iter_mut().for_each(|term| term.along.resize(all, 0.0));
            CountingSolver::new(all, &added.beside(n, &pattern), None, watch)?
        }
    };
    let stiffness = Stiffness { pattern: &pattern, values: &values, beside: &beside };
    modes_of(solver, stiffness, Masses { own: &masses, added }, count, shift).map_err(|error| match error {
        // A node of the medium has no name.
        EquilibriumError::Singular { unknown, .. } if unknown >= n => error,
        error => error.named(system, 0, level),
    })
}

/// Eigenpairs of `K φ = ω² M φ` with diagonal M nearest to a shift; K by its lower triangle.
///
/// The inertia of K − τM at the ends of the interval about the shift counts the eigenvalues within; where it counts
/// more than were found, the missing ones are sought.
pub fn lowest_modes<'a>(
    pattern: &[(usize, usize)],
    stiffness: &[f64],
    masses: &[f64],
    count: usize,
    shift: f64,
    watch: &'a mut Watch<'a>,
) -> Result<Spectrum<Mode>, EquilibriumError> {
    let solver = CountingSolver::new(masses.len(), pattern, None, watch)?;
    let inertia = Masses { own: masses, added: None };
    modes_of(solver, Stiffness { pattern, values: stiffness, beside: &[] }, inertia, count, shift)
}

/// A tangent: entries of its pattern, and what it has beside.
#[derive(Clone, Copy)]
struct Stiffness<'a> {
    pattern: &'a [(usize, usize)],
    values: &'a [f64],
    beside: &'a [RankOne],
}

/// Masses of the unknowns, and what a medium adds.
struct Masses<'a> {
    own: &'a [f64],
    added: Option<&'a mut AddedMass>,
}

/// The same by a solver for the pattern, with the nodes of the medium behind the unknowns.
fn modes_of(
    solver: CountingSolver<'_>,
    stiffness: Stiffness<'_>,
    masses: Masses<'_>,
    count: usize,
    shift: f64,
) -> Result<Spectrum<Mode>, EquilibriumError> {
    let n = masses.own.len();
    let carrying = masses.own.iter().filter(|&&m| m > 0.0).count();
    require(
        count > 0 && count <= carrying,
        "number of modes",
        count as f64,
        "between 1 and the number of unknowns with mass",
    )?;
    let mut vibration = Vibration { solver, stiffness, masses };
    let below = vibration.below(shift)?.0;
    let mut krylov = Krylov::new(&mut vibration, n, &[])?;
    let mut wanted = count;
    for _ in 0..ROUNDS {
        let bound = |pair: &Ritz| pair.residual / pair.value.abs();
        let pairs = krylov.converge(&mut vibration, wanted, End::Magnitude, &bound)?;
        let counted = vibration.count(shift, below, &pairs, wanted)?;
        if counted.number <= wanted {
            let chosen = pairs[..count].iter();
            let modes = chosen.map(|pair| vibration.mode(shift, counted.to, pair, krylov.vector(pair)));
            let modes = modes.collect::<Result<Vec<_>, _>>()?;
            return if counted.number == wanted {
                Ok(Spectrum { modes, counted, effort: vibration.solver.effort })
            } else {
                Err(EquilibriumError::Miscounted { found: wanted, counted: counted.number })
            };
        }
        wanted = counted.number.min(carrying);
        vibration.below(shift)?;
        krylov.restart(&pairs);
        krylov.freshen(&mut vibration, 1)?;
    }
    Err(EquilibriumError::Modes { found: count, wanted, residual: 0.0, bound: crate::eigen::TOLERANCE })
}

struct Vibration<'a, 'w> {
    solver: CountingSolver<'w>,
    stiffness: Stiffness<'a>,
    masses: Masses<'a>,
}

impl Vibration<'_, '_> {
    /// Factorises K − σM; eigenvalues below σ, and those within rounding of it.
    fn below(&mut self, shift: f64) -> Result<(usize, usize), EquilibriumError> {
        let Stiffness { pattern, values, beside } = self.stiffness;
        let mut values = values.to_vec();
        for (&(row, column), value) in pattern.iter().zip(&mut values) {
            if row == column {
                *value -= shift * self.masses.own[row];
            }
        }
        let of_medium = self.masses.added.as_ref().map_or(0, |added| added.append(shift, &mut values));
        let inertia = self.solver.factor(&values, beside)?;
        Ok((inertia.negative.saturating_sub(of_medium), inertia.zero))
    }

    /// Solves with the last factor; the medium feels nothing but the unknowns.
    fn solve(&mut self, rights: &mut [Vec<f64>]) -> Result<(), EquilibriumError> {
        let unknowns = self.masses.own.len();
        let all = unknowns + self.masses.added.as_ref().map_or(0, |added| added.nodes());
        rights.iter_mut().for_each(|right| right.resize(all, 0.0));
        self.solver.solve_some(rights)?;
        rights.iter_mut().for_each(|right| right.truncate(unknowns));
        Ok(())
    }

    /// Counts eigenvalues about the shift to a little beyond the last wanted one.
    fn count(
        &mut self,
        shift: f64,
        below: usize,
        pairs: &[Ritz],
        wanted: usize,
    ) -> Result<Counted, EquilibriumError> {
        let distance = |k: usize| pairs.get(k).map_or(f64::INFINITY, |pair| 1.0 / pair.value.abs());
        let last = distance(wanted - 1);
        let mut beyond = (0.5 * (distance(wanted) / last - 1.0)).clamp(BEYOND[0], BEYOND[1]);
        loop {
            let [from, to] = [shift - last * (1.0 + beyond), shift + last * (1.0 + beyond)];
            let mut zeros = 0;
            // Nothing lies below a shift without negative pivots.
            let lower = if below > 0 { self.below(from)? } else { (0, 0) };
            let upper = self.below(to)?;
            zeros += lower.1 + upper.1;
            if zeros == 0 || beyond > BEYOND[1] * 4_f64.powi(MOVES as i32) {
                let from = if below > 0 { from } else { f64::NEG_INFINITY };
                return Ok(Counted { from, to, number: upper.0 - lower.0 });
            }
            beyond *= 4.0;
        }
    }

    /// A mode from its pair, with the error bound that one solve with the factor at τ gives: for w = (K − τM)⁻¹(Kφ − λMφ)
    /// an eigenvalue lies within |λ − τ| ‖w‖ of λ, in the norm of M.
    fn mode(&mut self, shift: f64, tau: f64, pair: &Ritz, shape: Vec<f64>) -> Result<Mode, EquilibriumError> {
        let eigenvalue = shift + 1.0 / pair.value;
        let mut left = vec![0.0; shape.len()];
        product(self.stiffness.pattern, self.stiffness.values, &shape, &mut left);
        self.stiffness.beside.iter().for_each(|term| term.add_product(1.0, &shape, &mut left));
        for ((left, mass), value) in left.iter_mut().zip(self.masses.own).zip(&shape) {
            *left -= eigenvalue * mass * value;
        }
        let mut weighed = vec![0.0; left.len()];
        if let Some(added) = &mut self.masses.added {
            added.add_product(&shape, &mut weighed)?;
            left.iter_mut().zip(&weighed).for_each(|(left, weight)| *left -= eigenvalue * weight);
        }
        let mut left = [left];
        self.solve(&mut left)?;
        let [left] = left;
        self.weigh(&left, &mut weighed)?;
        let error = (eigenvalue - tau).abs() * dot(&left, &weighed).max(0.0).sqrt();
        Ok(Mode { eigenvalue, residual: error * pair.value.abs(), shape })
    }
}

impl Operator for Vibration<'_, '_> {
    fn apply(&mut self, vectors: &mut [Vec<f64>]) -> Result<(), EquilibriumError> {
        for v in vectors.iter_mut() {
            let mut out = vec![0.0; v.len()];
            self.weigh(v, &mut out)?;
            *v = out;
        }
        self.solve(vectors)
    }

    fn weigh(&mut self, v: &[f64], out: &mut [f64]) -> Result<(), EquilibriumError> {
        for i in 0..v.len() {
            out[i] = self.masses.own[i] * v[i];
        }
        match &mut self.masses.added {
            Some(added) => added.add_product(v, out),
            None => Ok(()),
        }
    }
}
