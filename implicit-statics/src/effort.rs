//! What a search for eigenpairs costs, who may end it, and what it proves.

use std::ops::ControlFlow;

use crate::rank_one::RankOne;
use crate::{EquilibriumError, Inertia, SymmetricSolver};

/// Work done so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Effort {
    /// Factorisations.
    pub factorisations: usize,
    /// Solves with a factor.
    pub solves: usize,
}

impl Effort {
    /// What was done after an earlier look.
    pub fn since(&self, before: &Self) -> Self {
        let factorisations = self.factorisations - before.factorisations;
        Self { factorisations, solves: self.solves - before.solves }
    }

    /// Adds what another search took.
    pub fn add(&mut self, other: &Self) {
        self.factorisations += other.factorisations;
        self.solves += other.solves;
    }
}

/// Asked before every factorisation and before solves, of which up to four are one; `Break` ends the search with [`EquilibriumError::Stopped`].
pub type Watch<'a> = dyn FnMut(&Effort) -> ControlFlow<()> + 'a;

/// A [`Watch`] that never ends anything.
pub fn unwatched(_: &Effort) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Eigenvalues found, and the proof that none is missing.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum<M> {
    /// The modes.
    pub modes: Vec<M>,
    /// How many eigenvalues lie where, by the inertia of two factors (Sylvester's law): as many as were found there.
    pub counted: Counted,
    /// What it took.
    pub effort: Effort,
}

/// A count of eigenvalues by inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Counted {
    /// Lower end of the interval, in the unit of the eigenvalue.
    pub from: f64,
    /// Its upper end.
    pub to: f64,
    /// Eigenvalues between the two.
    pub number: usize,
}

/// A solver that counts and asks.
pub(crate) struct CountingSolver<'a> {
    solver: SymmetricSolver,
    watch: &'a mut Watch<'a>,
    pub effort: Effort,
}

impl<'a> CountingSolver<'a> {
    pub fn new(
        unknowns: usize,
        pattern: &[(usize, usize)],
        places: Option<&[[f64; 3]]>,
        watch: &'a mut Watch<'a>,
    ) -> Result<Self, EquilibriumError> {
        let solver = SymmetricSolver::placed(unknowns, pattern, places)?;
        Ok(Self { solver, watch, effort: Effort::default() })
    }

    /// Asks whether to go on.
    pub fn ask(&mut self) -> Result<(), EquilibriumError> {
        match (self.watch)(&self.effort) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(EquilibriumError::Stopped { solves: self.effort.solves }),
        }
    }

    pub fn factor(&mut self, values: &[f64], beside: &[RankOne]) -> Result<Inertia, EquilibriumError> {
        self.ask()?;
        self.effort.factorisations += 1;
        self.solver.factor_with(values, beside)
    }

    pub fn solve(&mut self, right: &mut [f64]) -> Result<(), EquilibriumError> {
        self.ask()?;
        self.effort.solves += 1;
        self.solver.solve(right)
    }

    /// The same for some right sides, as many at a time as read the factor once.
    pub fn solve_some(&mut self, rights: &mut [Vec<f64>]) -> Result<(), EquilibriumError> {
        let mut left = rights;
        while let [first, rest @ ..] = left {
            self.ask()?;
            left = match rest {
                [b, c, d, rest @ ..] => {
                    self.effort.solves += 4;
                    self.solver.solve_all([first, b, c, d])?;
                    rest
                }
                [b, rest @ ..] => {
                    self.effort.solves += 2;
                    self.solver.solve_all([first, b])?;
                    rest
                }
                [] => {
                    self.effort.solves += 1;
                    self.solver.solve(first)?;
                    &mut []
                }
            };
        }
        Ok(())
    }

    /// As [`SymmetricSolver::scale`].
    pub fn scale(&self) -> &[f64] {
        self.solver.scale()
    }
}
