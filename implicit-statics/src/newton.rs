//! Newton's method at a fixed load level, or with the level as one more unknown and one more equation.

mod answers;
mod bordered;
mod parts;
mod stages;

pub(crate) use bordered::Constraint;
pub(crate) use parts::within_reach;

use stages::{Iterated, Phase};

use crate::effort::Effort;
use crate::error::require;
use crate::options::NewtonOptions;
use crate::vectors::{dot, norm};
use crate::{Equilibrium, EquilibriumError, Inertia, SymmetricSolver};

/// A residual above this share of the one before no longer converges …
const STALLED: f64 = 0.25;
/// … and is rounding of the forces when the correction is below this share of the way: one more would square it.
const AT_REST: f64 = 1e-8;
/// What an iterate reached by the factor of another one leaves of the bound: corrections by its own would leave as little.
const BY_ANOTHER: f64 = 0.1;

/// Part of the forces of heat up to which a residual is the rounding of their sums.
pub(crate) const ROUNDING: f64 = 1e-13;

/// Part of what a stiff tool would press if nothing gave way that counts beside the forces of balances: rounding of places times its stiffness is less.
const GIVES_WAY: f64 = 1e-4;

/// How an equilibrium was reached.
#[derive(Debug, Clone, PartialEq)]
pub struct Converged {
    /// Load level \[–\].
    pub level: f64,
    /// Iterations (solves) made.
    pub iterations: usize,
    /// ‖external − internal‖ of every iterate, the first before any correction \[F\].
    pub residuals: Vec<f64>,
    /// Bound that the last one met \[F\].
    pub bound: f64,
    /// Inertia of the tangent at the equilibrium.
    pub inertia: Inertia,
}

/// A change of state along tangent increments, with the change of level.
#[derive(Debug, Clone, PartialEq)]
pub struct Increment {
    /// Sum of the increments of the unknowns.
    pub motion: Vec<f64>,
    /// Change of level.
    pub level: f64,
}

/// `K⁻¹ p`, p the load rate at the present state: the linear answer to a unit of level. The state stays.
pub fn linear_response<E: Equilibrium + ?Sized>(
    system: &mut E,
    level: f64,
) -> Result<Vec<f64>, EquilibriumError> {
    Newton::new(system, &NewtonOptions::default())?.response(system, level)
}

/// Newton's method with its solver, its buffers and its sense of scale; keep one for all steps of a path.
pub struct Newton {
    /// How it iterates.
    pub options: NewtonOptions,
    pub(crate) solver: SymmetricSolver,
    pub(crate) step: usize,
    values: Vec<f64>,
    internal: Vec<f64>,
    external: Vec<f64>,
    rate: Vec<f64>,
    residual: Vec<f64>,
    force_scale: f64,
    travelled: Vec<f64>,
    first_way: f64,
    /// What was factorised and solved so far.
    pub effort: Effort,
    /// Most negative pivots of a tangent since the last correction began.
    pub(crate) most_negative: usize,
    /// Level at which the tangent of the present state was factorised, if it was.
    factored: Option<f64>,
    /// The response to the load by the factor at hand, once it was asked for.
    answer: Option<Vec<f64>>,
    /// The state in which the last path ended.
    left: Vec<f64>,
}

impl Newton {
    /// Reads the pattern and analyses it once.
    pub fn new<E: Equilibrium + ?Sized>(
        system: &E,
        options: &NewtonOptions,
    ) -> Result<Self, EquilibriumError> {
        require(options.tolerance > 0.0, "newton tolerance", options.tolerance, "positive")?;
        require((0.0..1.0).contains(&options.keep), "newton keep", options.keep, "at least 0 and below 1")?;
        require(options.iterations > 0, "newton iterations", options.iterations as f64, "one at least")?;
        let n = system.unknowns();
        let pattern = system.pattern();
        Ok(Self {
            options: options.clone(),
            solver: SymmetricSolver::placed(n, &pattern, system.coordinates().as_deref())?,
            step: 0,
            values: vec![0.0; pattern.len()],
            internal: vec![0.0; n],
            external: vec![0.0; n],
            rate: vec![0.0; n],
            residual: vec![0.0; n],
            force_scale: 0.0,
            travelled: vec![0.0; n],
            first_way: 0.0,
            effort: Effort::default(),
            most_negative: 0,
            factored: None,
            answer: None,
            left: Vec::new(),
        })
    }

    /// Finds equilibrium at a load level from the present state. After a failure the state is as before.
    ///
    /// Held values that move are put there at once, which is right for small changes only: [`crate::follow`] predicts.
    pub fn at_level<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
    ) -> Result<Converged, EquilibriumError> {
        let saved = system.save();
        let mut increment = Increment { motion: vec![0.0; system.unknowns()], level: 0.0 };
        let outcome = self.correct(system, level, &mut increment, &Constraint::Level, false);
        match &outcome {
            Ok(_) => {
                self.accept(&increment);
                self.keep(system);
            }
            Err(_) => self.go_back(system, &saved),
        }
        outcome
    }

    /// Factorises the tangent of the present state, unless that was the last thing done.
    pub(crate) fn tangent<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
    ) -> Result<Inertia, EquilibriumError> {
        if self.factored != Some(level) {
            if system.pattern_changed(level) {
                self.analyse(system)?;
            }
            system.tangent(level, &mut self.values);
            self.solver.factor_with(&self.values, &system.beside_pattern(level))?;
            self.effort.factorisations += 1;
            (self.factored, self.answer) = (Some(level), None);
            self.most_negative = self.most_negative.max(self.solver.inertia().negative);
        }
        Ok(self.solver.inertia())
    }

    /// The signs of the pivots of the last factor.
    pub fn inertia(&self) -> Inertia {
        self.solver.inertia()
    }

    /// Tells what forces and motions to expect before any are known: those of the linear first step.
    pub(crate) fn expect(&mut self, change: f64, response: &[f64]) {
        self.force_scale = (change * norm(&self.rate)).abs();
        self.first_way = (change * self.length(response)).abs();
    }

    /// The scale of residuals by forces that were expected \[F\]. Of a tool that moves they are what it would press if nothing gave way, a hundred times
    /// what it presses and more, beside which residuals would pass far from balance: a part of them is left, for rounding where little presses.
    pub(crate) fn of_expected<E: Equilibrium + ?Sized>(system: &E, force: f64) -> f64 {
        if system.has_moving_tools() { GIVES_WAY * force } else { force }
    }

    /// Moves the state.
    pub(crate) fn advance<E: Equilibrium + ?Sized>(&mut self, system: &mut E, motion: &[f64]) {
        system.update(motion);
        self.factored = None;
    }

    /// Comes back to a saved state.
    pub(crate) fn go_back<E: Equilibrium + ?Sized>(&mut self, system: &mut E, saved: &[f64]) {
        system.restore(saved);
        self.factored = None;
    }

    /// Takes note of a step that is kept.
    pub(crate) fn accept(&mut self, increment: &Increment) {
        for (sum, motion) in self.travelled.iter_mut().zip(&increment.motion) {
            *sum += motion;
        }
    }

    /// Iterates to equilibrium and constraint from the present state at a level, or as far as the part goes ([`Phase`]).
    ///
    /// Where the system keeps factors, one serves as long as residuals fall fast; it serves the first correction as well if
    /// the state was predicted along the bend of its path. A correction by it that makes things worse is taken back.
    fn iterate<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        at: &mut f64,
        increment: &mut Increment,
        (constraint, bent): (&Constraint, bool),
        phase: Phase,
    ) -> Result<Iterated, EquilibriumError> {
        let mut level = *at;
        let (mut seen, mut share) = (0, 1.0);
        let keeps = system.keeps_factor()
            && self.options.keep > 0.0
            && !matches!(constraint, Constraint::Sphere { .. });
        let mut residuals: Vec<f64> = Vec::new();
        let mut rest = f64::INFINITY;
        // Where the last correction began, if it was by the factor of another state.
        let mut before: Option<(Vec<f64>, Increment, f64)> = None;
        for iterations in 0.. {
            let size = self.residual(system, level)?;
            residuals.push(size);
            let expected =
                Self::of_expected(system, norm(&self.rate) * increment.level.abs()).max(self.force_scale);
            let mut scale = norm(&self.external).max(expected);
            if scale == 0.0 {
                scale = residuals[0];
            }
            let asked =
                phase.tolerance(&self.options) * scale * if before.is_some() { BY_ANOTHER } else { 1.0 };
            let at_rest = rest <= AT_REST && size > STALLED * residuals[iterations - 1];
            let least = ROUNDING * system.stress_forces(level);
            let bound = if at_rest { asked.max(size) } else { asked }.max(least);
            let moved = iterations > 0 || !matches!(constraint, Constraint::Level) || size <= least;
            if size <= bound && moved {
                if let Err(found) = system.within_bounds() {
                    return Err(EquilibriumError::OutOfBounds { step: self.step, level, found });
                }
                let inertia =
                    if self.options.inertia { self.tangent(system, level)? } else { self.solver.inertia() };
                self.force_scale = self.force_scale.max(norm(&self.external)).max(norm(&self.internal));
                *at = level;
                return Ok(Iterated::Balanced(Converged { level, iterations, residuals, bound, inertia }));
            }
            let last = iterations == phase.iterations(&self.options);
            if last && phase == Phase::Stage
                || phase.walks(
                    [iterations, phase.iterations(&self.options)],
                    || system.front(level),
                    &mut seen,
                    share,
                )
            {
                *at = level;
                return Ok(Iterated::Cut(residuals));
            }
            if last {
                return Err(self.not_converged(level, bound, residuals));
            }

            let serves = match iterations.checked_sub(1) {
                None => bent,
                Some(last) => size <= self.options.keep * residuals[last],
            };
            if let Some((state, made, at)) = before.take().filter(|_| size > residuals[iterations - 1]) {
                self.go_back(system, &state);
                (*increment, level) = (made, at);
                self.residual(system, level)?;
                residuals[iterations] = norm(&self.residual);
            }
            if self.factored.is_none() {
                if keeps && serves && self.solver.is_regular() {
                    before = Some((system.save(), increment.clone(), level));
                } else {
                    self.tangent(system, level)?;
                }
            } // else a load step starts: the tangent before it serves
            let mut correction = self.correction(system, level, increment, constraint)?;
            if let Constraint::Level = constraint {
                within_reach(system, &mut correction.motion);
            }
            level += correction.level;
            increment.level += correction.level;
            share = match constraint {
                Constraint::Level if self.options.line_search => {
                    self.search(system, level, &correction.motion)?
                }
                _ => {
                    self.advance(system, &correction.motion);
                    1.0
                }
            };
            for (sum, motion) in increment.motion.iter_mut().zip(&correction.motion) {
                *sum += share * motion;
            }
            rest = share * self.length(&correction.motion) / self.way(increment);
        }
        unreachable!("the loop ends by its bound")
    }

    /// Refuses a step under load after which the response to the load points back: it passed a limit point.
    pub(crate) fn same_side<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
        increment: &Increment,
    ) -> Result<(), EquilibriumError> {
        let response = self.response(system, level)?;
        let unit = |v: &[f64]| v.iter().zip(self.solver.scale()).map(|(q, s)| q / s).collect::<Vec<f64>>();
        let (way, response) = (unit(&increment.motion), unit(&response));
        let product = dot(&way, &response) * increment.level.signum();
        let cosine = product / (norm(&way) * norm(&response));
        let step = self.step;
        if cosine < 0.0 { Err(EquilibriumError::Fold { step, level, cosine }) } else { Ok(()) }
    }

    /// Length of a motion with every unknown in the unit of its own stiffness.
    pub(crate) fn length(&self, motion: &[f64]) -> f64 {
        let scale = self.solver.scale();
        motion.iter().zip(scale).map(|(q, s)| (q / s) * (q / s)).sum::<f64>().sqrt()
    }

    /// Norm of `external − internal` at the present state \[F\].
    fn residual<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
    ) -> Result<f64, EquilibriumError> {
        system.internal(level, &mut self.internal);
        system.external(level, &mut self.external);
        for i in 0..self.residual.len() {
            self.residual[i] = self.external[i] - self.internal[i];
        }
        match self.residual.iter().position(|r| !r.is_finite()) {
            None => Ok(norm(&self.residual)),
            Some(unknown) => {
                let (step, name) = (self.step, system.name_unknown(unknown));
                Err(EquilibriumError::Force { step, level, name })
            }
        }
    }
}
