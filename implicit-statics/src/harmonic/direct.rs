//! The steady answer by one factor at each frequency.

use super::motion::{CycleEnergies, HarmonicMotion, quadratic, weighed};
use super::{Complex, HarmonicDamping};
use crate::error::require;
use crate::pattern::product;
use crate::rank_one::RankOne;
use crate::vectors::dot;
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
    pattern: Vec<(usize, usize)>,
    stiffness: Vec<f64>,
    beside: Vec<RankOne>,
    masses: Vec<f64>,
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
        let (n, pattern) = (system.unknowns(), system.pattern());
        let mut stiffness = vec![0.0; pattern.len()];
        system.tangent(level, &mut stiffness);
        let beside = system.beside_pattern(level);
        let mut load = vec![0.0; n];
        system.load_rate(level, &mut load);
        let places = system.coordinates();
        let mut first = vec![0.0; n];
        let on_diagonal = pattern.iter().zip(&stiffness).filter(|((row, column), _)| row == column);
        on_diagonal.for_each(|(&(row, _), k)| first[row] = k.abs());
        // Scaled by K: at some frequency an entry of K − ω²M may be next to nothing.
        let solver = if damping == HarmonicDamping::None {
            let mut solver = SymmetricSolver::placed(n, &pattern, places.as_deref())?;
            solver.refer_to(&first);
            solver
        } else {
            let places = places.map(|places| twice(&places));
            let mut solver = SymmetricSolver::placed(2 * n, &doubled(&pattern), places.as_deref())?;
            solver.refer_to(&twice(&first));
            solver
        };
        let (masses, inertia) = (system.vibrating_masses(), Inertia::default());
        Ok(Self { solver, pattern, stiffness, beside, masses, load, damping, inertia })
    }

    /// The answer at a circular frequency \[1/T\].
    ///
    /// # Errors
    /// [`EquilibriumError::Resonance`] where nothing damps and ω is a natural frequency within rounding; of the solver.
    pub fn at(&mut self, omega: f64) -> Result<HarmonicMotion, EquilibriumError> {
        let (square, (mass, loss)) = (omega * omega, self.damping.at(omega));
        let of = |(row, column): (usize, usize), k: f64| {
            let m = if row == column { self.masses[row] } else { 0.0 };
            Complex::new(k - square * m, loss * k + omega * mass * m)
        };
        let entries = self.pattern.iter().zip(&self.stiffness);
        if self.damping == HarmonicDamping::None {
            let values: Vec<f64> = entries.map(|(&place, &k)| of(place, k).re).collect();
            self.inertia = self.solver.factor_with(&values, &self.beside)?;
            let mut real = self.load.clone();
            self.solve(&mut real, omega)?;
            let imaginary = vec![0.0; real.len()];
            return Ok(HarmonicMotion { real, imaginary });
        }
        let mut values = Vec::with_capacity(4 * self.pattern.len());
        for (&place, &k) in entries {
            let a = of(place, k);
            values.extend([a.re, -a.im]);
            values.extend((place.0 != place.1).then_some(-a.im));
            values.push(-a.re);
        }
        let beside: Vec<RankOne> = self.beside.iter().flat_map(|term| doubled_term(term, loss)).collect();
        self.inertia = self.solver.factor_with(&values, &beside)?;
        let mut both: Vec<f64> = self.load.iter().flat_map(|&p| [p, 0.0]).collect();
        self.solve(&mut both, omega)?;
        let part = |k: usize| both.as_chunks::<2>().0.iter().map(|both| both[k]).collect();
        Ok(HarmonicMotion { real: part(0), imaginary: part(1) })
    }

    /// Energies of an answer at its circular frequency.
    pub fn energies(&self, motion: &HarmonicMotion, omega: f64) -> CycleEnergies {
        let stiff = |x: &[f64]| {
            quadratic(x, |x, image| {
                product(&self.pattern, &self.stiffness, x, image);
                self.beside.iter().for_each(|term| term.add_product(1.0, x, image));
            })
        };
        let stored = stiff(&motion.real) + stiff(&motion.imaginary);
        let moving = weighed(&self.masses, &motion.real) + weighed(&self.masses, &motion.imaginary);
        let out = dot(&self.load, &motion.imaginary);
        CycleEnergies::of([stored, moving, out], omega, self.damping.at(omega))
    }

    /// Signs of the pivots of K: negative ones tell that the state is not stable, zeros that it may move freely.
    ///
    /// # Errors
    /// Of the solver.
    pub fn stability<E: Equilibrium + ?Sized>(&self, system: &E) -> Result<Inertia, EquilibriumError> {
        let places = system.coordinates();
        let mut solver = SymmetricSolver::placed(self.masses.len(), &self.pattern, places.as_deref())?;
        solver.factor_with(&self.stiffness, &self.beside)
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
        &self.masses
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
