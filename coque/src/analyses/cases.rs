//! Linear answers to several load cases by one factor, and to combinations of them by superposition.
//!
//! A case is the scene with the loads and motions of that case alone, a combination the scene with each of them times its factor
//! ([`Checked::under`](crate::scene::Checked)): its body is built anew, for what acts on it is found there, and shares unknowns and tangent with that of all
//! others. So the tangent is assembled and factorised once, of the body under all cases together, at rest. Each case takes one solve with its own
//! load rate, a combination none: its motion is `Σ f_c u_c`. What is measured is then read along that motion as of any linear answer, and a
//! combination equals a run under loads times factors but for the rounding of one solve.

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use implicit_statics::{EquilibriumError, Newton, NewtonOptions};

use super::linear::{Answer, INTERRUPTED, Way, read, solved, warning_stability};
use crate::bodies::{Ready, StaticBody};
use crate::fields::CaseShown;
use crate::run::Run;
use crate::run::cases_summary::{CaseSummary, CasesSummary};
use crate::run::outcome::{Ended, Failure};
use crate::run::record::{ConjugateSummary, Energies};
use crate::scene::{Analysis, Checked, Linear, LinearSolver, LoadSet};

/// Answers to load cases and combinations, one after the other.
pub(super) struct Cases {
    scene: Checked,
    threads: usize,
    sets: Vec<LoadSet>,
    /// Answers made.
    made: usize,
    /// The factor; none before it is made, and of conjugate gradients.
    newton: Option<Newton>,
    /// Motions of the cases, by name.
    motions: BTreeMap<String, Vec<f64>>,
}

impl Cases {
    /// Of a scene with load cases.
    pub fn new(scene: Checked, threads: usize) -> Self {
        let sets = scene.load_sets();
        Self { scene, threads, sets, made: 0, newton: None, motions: BTreeMap::new() }
    }

    /// Finds the next answer; `Break` with the last one, or where it is not found. `system` is the body under all cases.
    pub fn advance(&mut self, system: &mut dyn StaticBody, run: &mut Run<'_>) -> ControlFlow<Ended> {
        let Analysis::Linear(wanted) = &self.scene.analysis else { return ControlFlow::Break(Ended::Done) };
        let wanted = wanted.clone();
        let done = self.made as f64 / self.sets.len() as f64;
        if run.tell(done, self.made as u64, 0.0, 0.0).is_break() {
            return ControlFlow::Break(INTERRUPTED);
        }
        if self.made == 0
            && let Err(cause) = self.factorise(&wanted, system, run)
        {
            return ControlFlow::Break(run.unbalanced(0, 0.0, cause));
        }
        let Some(set) = self.sets.get(self.made).cloned() else { return ControlFlow::Break(Ended::Done) };
        let failed = |cause: String| {
            ControlFlow::Break(Ended::Diverged(Failure::Case { name: set.name.clone(), cause }))
        };
        let model = match self.scene.under(&set).build(self.threads) {
            Ok(model) => model,
            Err(error) => return failed(error.to_string()),
        };
        let Ready::Static(mut body) = model.body else { return failed("it marches".into()) };
        let motion = match self.motion(&set, &wanted, body.as_mut(), run) {
            Ok(motion) => motion,
            Err(cause) => return ControlFlow::Break(run.unbalanced(self.made as u64, 0.0, cause)),
        };
        // Rotations are counted on from the first reading: each answer has its own.
        run.probes = model.probes;
        let Some(answer) = read(&motion, 1.0, body.as_mut(), run) else {
            return ControlFlow::Break(INTERRUPTED);
        };
        self.made += 1;
        self.record(&set, &answer, run);
        answer.warn(Some(&set.name), body.as_ref(), run);
        let counts = set.combines == self.sets.iter().any(|set| set.combines);
        let shown = CaseShown { number: self.made as f64, name: &set.name, counts };
        answer.show(&motion, Some(shown), body.as_mut(), run);
        if self.made == self.sets.len()
            && let Some(frames) = &mut run.frames
        {
            frames.offer_envelope(body.as_ref(), self.made);
        }
        let failed = run.frames.as_ref().is_some_and(|frames| frames.failure.is_some());
        if failed || self.made == self.sets.len() {
            return ControlFlow::Break(Ended::Done);
        }
        if !set.combines {
            self.motions.insert(set.name, motion);
        }
        ControlFlow::Continue(())
    }

    /// Makes the one factor, where the solver has one.
    fn factorise(
        &mut self,
        wanted: &Linear,
        system: &mut dyn StaticBody,
        run: &mut Run<'_>,
    ) -> Result<(), EquilibriumError> {
        if wanted.solver == LinearSolver::Direct {
            let mut newton = Newton::new(&*system, &NewtonOptions::default())?;
            warning_stability(newton.factorise(system, 0.0)?, run);
            run.record.factorisations = 1;
            self.newton = Some(newton);
        }
        Ok(())
    }

    /// The motion under a set: solved for of a case, superposed of a combination.
    fn motion(
        &mut self,
        set: &LoadSet,
        wanted: &Linear,
        body: &mut dyn StaticBody,
        run: &mut Run<'_>,
    ) -> Result<Vec<f64>, EquilibriumError> {
        if set.combines {
            let mut sum = vec![0.0; body.unknowns()];
            for (case, factor) in &set.of {
                let own = self.motions.get(case).into_iter().flatten();
                sum.iter_mut().zip(own).for_each(|(sum, u)| *sum += factor * u);
            }
            return Ok(sum);
        }
        run.record.newton_iterations += 1;
        match &mut self.newton {
            Some(newton) => {
                run.record.solves += 1;
                newton.response_of(body, 0.0)
            }
            None => {
                let (response, way) = solved(wanted, body)?;
                if let Way::Iterated(found) = way {
                    let all = &mut run.record.conjugate_gradients;
                    *all = Some(match all.take() {
                        None => found,
                        Some(before) => ConjugateSummary {
                            iterations: before.iterations + found.iterations,
                            residual: before.residual.max(found.residual),
                            ..before
                        },
                    });
                }
                Ok(response)
            }
        }
    }

    /// Adds the row and the figures of an answer.
    fn record(&self, set: &LoadSet, answer: &Answer, run: &mut Run<'_>) {
        let mut row = vec![self.made as f64, 1.0, answer.internal, if set.combines { 0.0 } else { 1.0 }];
        row.extend(self.newton.as_ref().map(|newton| newton.inertia().negative as f64));
        row.extend(&answer.columns);
        let columns = run.curve.columns[row.len() - answer.columns.len()..].to_vec();
        let summary = run.cases.get_or_insert_with(|| CasesSummary::over(&self.sets, columns));
        summary.take(
            CaseSummary { set: set.clone(), internal: answer.internal, supports: answer.supports },
            &answer.columns,
        );
        run.record.energies = Energies::at_rest(answer.internal);
        run.push(row);
    }
}
