//! The linear answer: one factorisation at the unloaded body, and what is read along it: probes and forces.

use implicit_statics::{
    ConjugateOptions, EquilibriumError, Inertia, Newton, NewtonOptions, conjugate_response,
};
use sph_core::Vec3;

use super::modes::{keep_enlarged, scaled};
use super::path::loaded;
use crate::WarningKind;
use crate::bodies::{Configuration, Probe, Resultant, StaticBody, extent};
use crate::fields::CaseShown;
use crate::run::Run;
use crate::run::glue_watch;
use crate::run::outcome::Ended;
use crate::run::record::{ConjugateSummary, Energies};
use crate::scene::{Linear, LinearSolver};

/// Largest displacement, in reaches of the body (thicknesses), of the states between which probes and forces are
/// differentiated.
///
/// A probe reads `v(ε)` along the motion; the linear value adds to `v(0)` the slope there, by central differences over
/// ε and 2ε: `(4 s(ε) − s(2ε)) / 3` with `s(ε) = (v(ε) − v(−ε)) / 2ε`. Rounding of positions is 2e-16 of the extent
/// over this many thicknesses, and more in forces, where stretching is stiff: the reaction of the Scordelis-Lo roof is
/// off by 1e-7, 1e-8, 6e-10 at 1e-4, 1e-3, 1e-2 thicknesses. One difference alone cuts off the stretch that bending
/// brings about, (displacement over thickness)²: 2e-6 there at 1e-2. The two cut off its square.
const REACH: f64 = 1e-2;

/// Part of that at which glue is looked at: second-order ways of stiff glue are squares of it.
const SMALL: f64 = 1e-2;

/// Finds the linear answer at level one and reads the curve's one row.
pub(crate) fn linear(wanted: &Linear, system: &mut dyn StaticBody, run: &mut Run<'_>) -> Ended {
    if run.tell(0.0, 0, 0.0, 0.0).is_break() {
        return INTERRUPTED;
    }
    let (response, way) = match solved(wanted, system) {
        Ok(found) => found,
        Err(cause) => return run.unbalanced(0, 0.0, cause),
    };
    // The load that is applied, or the force that brings the prescribed motion about.
    let force = run.driven.map_or(1.0, |driven| driven.by / driven.moved(system, &response));
    let motion = scaled(&response, force);
    let Some(answer) = read(&motion, force, system, run) else { return INTERRUPTED };
    let mut row = vec![1.0, answer.internal, 1.0];
    match way {
        Way::Factor(inertia) => {
            row.push(inertia.negative as f64);
            warning_stability(inertia, run);
        }
        Way::Iterated(found) => run.record.conjugate_gradients = Some(found),
    }
    answer.warn(None, system, run);
    row.extend(&answer.columns);
    run.supports = answer.supports;
    run.push(row);
    run.record.energies = Energies::at_rest(answer.internal);
    run.record.newton_iterations = 1;
    answer.show(&motion, None, system, run);
    Ended::Done
}

/// How a run ends that was asked to before it had an answer.
pub(super) const INTERRUPTED: Ended = Ended::Interrupted { time: 0.0, level: 0.0 };

/// A linear answer, read.
pub(super) struct Answer {
    /// What the columns of the scene measure.
    pub columns: Vec<f64>,
    /// Internal energy \[F L\].
    pub internal: f64,
    /// What the supports exert, of a body that tells.
    pub supports: Option<Resultant>,
    /// Forces that fields show; none where nobody takes any.
    forces: Vec<f64>,
    /// The places of the particles \[L\].
    there: Vec<Vec3>,
    /// Largest displacement of a particle \[L\].
    largest: f64,
}

/// Reads columns, energy and forces along a motion from rest, which so many times the load at level one bring about; the body is left at rest. None if
/// the run is to end.
pub(super) fn read(
    motion: &[f64],
    force: f64,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
) -> Option<Answer> {
    let rest = system.save();
    let there = moved(system, &rest, motion, loaded(run, 1.0));
    let largest = farthest(system, &there);
    let step = if largest > 0.0 { REACH * system.linear_reach() / largest } else { 1.0 };
    let (columns, fields) = (run.probes.iter().map(Probe::part_count).sum::<usize>(), run.frames.is_some());
    // Rotations are counted on from the first reading, at rest.
    let mut readings: [Vec<f64>; 5] = Default::default();
    let mut energies = [0.0; 5];
    for ((reading, energy), k) in readings.iter_mut().zip(&mut energies).zip([0.0, 1.0, 2.0, -1.0, -2.0]) {
        if run.tell(0.0, 1, 0.0, 0.0).is_break() {
            return None;
        }
        system.restore(&rest);
        system.update(&scaled(motion, k * step));
        *energy = system.refresh(loaded(run, k * step));
        reading.extend(run.probes.iter_mut().flat_map(|probe| probe.parts(system)));
        reading.extend(system.support_resultant().into_iter().flat_map(|r| [r.force, r.moment]).flatten());
        if fields {
            reading.extend(system.forces());
        }
    }
    note_glue(system, &rest, motion, step, run);
    let [here, ahead, beyond, behind, before] = readings;
    system.restore(&rest);
    let internal = if system.has_moving_supports() || system.stress_forces(1.0) > 0.0 {
        // Held values that move do work as well, and heat stores where it is held: the energy grows with the square of the level.
        let [here, ahead, beyond, behind, before] = energies;
        (16.0 * (ahead + behind) - (beyond + before) - 30.0 * here) / (24.0 * step * step)
    } else {
        let mut load = vec![0.0; motion.len()];
        system.load_rate(0.0, &mut load);
        0.5 * force * load.iter().zip(motion).map(|(f, u)| f * u).sum::<f64>()
    };
    let linear = |i: usize| {
        let (near, far) = (ahead[i] - behind[i], beyond[i] - before[i]);
        here[i] + (8.0 * near - far) / (12.0 * step)
    };
    let mut parts = (0..columns).map(linear);
    let probes = run.probes.iter().map(|probe| {
        let own: Vec<f64> = parts.by_ref().take(probe.part_count()).collect();
        probe.of_parts(&own)
    });
    let values = probes.collect();
    let borne =
        system.support_resultant().map(|_| -> [f64; 6] { std::array::from_fn(|k| linear(columns + k)) });
    let supports = borne.map(|[a, b, c, d, e, f]| Resultant { force: [a, b, c], moment: [d, e, f] });
    let after = columns + borne.map_or(0, |borne| borne.len());
    let forces = (after..here.len()).map(linear).collect();
    Some(Answer { columns: values, internal, supports, forces, there, largest })
}

impl Answer {
    /// Warns of an answer too large to be linear; `to` names the load case.
    pub fn warn(&self, to: Option<&str>, system: &dyn StaticBody, run: &mut Run<'_>) {
        warning_size(to, system, &self.there, self.largest, run);
    }

    /// Keeps the shape, and offers the frame of a motion, of a load case where there are some.
    pub fn show(
        &self,
        motion: &[f64],
        case: Option<CaseShown<'_>>,
        system: &mut dyn StaticBody,
        run: &mut Run<'_>,
    ) {
        let number = case.as_ref().map_or(1.0, |case| case.number);
        keep_enlarged(system.configuration().rest, &self.there, number, run);
        let level = loaded(run, 1.0);
        if let Some(frames) = &mut run.frames {
            let rest = system.save();
            moved(system, &rest, motion, level);
            frames.offer_linear(system, &self.forces, case);
            system.restore(&rest);
        }
    }
}

/// Notes what glue does in the linear answer, by a motion so small that turns do not count.
fn note_glue(system: &mut dyn StaticBody, rest: &[f64], motion: &[f64], step: f64, run: &mut Run<'_>) {
    if system.glue().is_empty() {
        return;
    }
    let small = SMALL * step;
    system.restore(rest);
    system.update(&scaled(motion, small));
    system.refresh(loaded(run, small));
    glue_watch::note(&*system, 1.0 / small, &mut run.record);
}

/// How a linear answer was found.
pub(super) enum Way {
    /// By a factor of the tangent, with the signs of its pivots.
    Factor(Inertia),
    /// By iterations, which count no pivots.
    Iterated(ConjugateSummary),
}

/// The linear answer by the solver that is asked for.
pub(super) fn solved(
    wanted: &Linear,
    system: &mut dyn StaticBody,
) -> Result<(Vec<f64>, Way), EquilibriumError> {
    match wanted.solver {
        LinearSolver::Direct => {
            let mut newton = Newton::new(&*system, &NewtonOptions::default())?;
            let response = newton.response(system, 0.0)?;
            Ok((response, Way::Factor(newton.inertia())))
        }
        LinearSolver::ConjugateGradients => {
            let usual = ConjugateOptions::default();
            let options = ConjugateOptions {
                iterations: wanted.iterations.map_or(usual.iterations, |most| most.get()),
                ..usual
            };
            let found = conjugate_response(system, 0.0, &options)?;
            let (iterations, residual, unknowns) = (found.iterations as u64, found.residual, found.levels);
            Ok((found.response, Way::Iterated(ConjugateSummary { iterations, residual, unknowns })))
        }
    }
}

/// Warns of a body that would leave its place under no load at all.
pub(super) fn warning_stability(inertia: Inertia, run: &mut Run<'_>) {
    if inertia.negative > 0 {
        let message = format!(
            "the unloaded body is not stable (negative pivots of its tangent: {}): the linear answer is one to a state that it would leave \
             at the least disturbance; see what pushes it, such as an initial stress or a spring that gives way",
            inertia.negative
        );
        run.record.warn(WarningKind::Unstable, message);
    }
}

/// Largest displacement over the extent of the body, and largest turn of a fibre, up to which a linear answer is taken without a word.
///
/// An elastica of length L under an end force moves by `w/L = α/3 − .038 α³`, `α = P L²/EI`: the linear α/3 is 1.02 (w/L)² too much,
/// 2.3 % at .15. A fibre that turns by θ is counted too long by `θ²/2`, 12 % at .5.
const LARGE: [f64; 2] = [0.15, 0.5];

/// Warns of an answer, to a load case where there are some, that is too large to be linear; `largest` is the largest displacement of the places `there`.
fn warning_size(to: Option<&str>, system: &dyn StaticBody, there: &[Vec3], largest: f64, run: &mut Run<'_>) {
    let Configuration { rest, cells, .. } = system.configuration();
    // Of fibres between neighbours of a cell; what a fibre moves by across itself, over its length.
    let sides = cells.iter().flat_map(|cell| {
        let corners = cell.particles();
        (0..corners.len()).map(move |i| [corners[i], corners[(i + 1) % corners.len()]].map(|a| a as usize))
    });
    let turn = sides.map(|[a, b]| {
        let (fibre, motion) = (rest[b] - rest[a], there[b] - there[a] - (rest[b] - rest[a]));
        fibre.cross(&motion).norm() / fibre.norm_squared()
    });
    let (moved, turned) = (largest / extent(rest), turn.fold(0.0, f64::max));
    if moved <= LARGE[0] && turned <= LARGE[1] {
        return;
    }
    let turns =
        if cells.is_empty() { String::new() } else { format!(" and turns fibres by {turned:.2} rad") };
    let message = format!(
        "the linear answer{} moves the body by {moved:.2} of its extent{turns}, beyond {} and {} rad: it is no longer small and may be far off: a linear \
         answer grows with its load without end, already {:.0} % too far for a strip that bends by {} of its length. Lower the load, or \
         follow it with [analysis.static]",
        to.map_or_else(String::new, |name| format!(" to `{name}`")),
        LARGE[0],
        LARGE[1],
        102.0 * LARGE[0] * LARGE[0],
        LARGE[0],
    );
    run.record.warn(WarningKind::LargeLinear, message);
}

/// Puts a motion of the unknowns on the state at rest, held values at a level; the positions there \[L\].
fn moved(system: &mut dyn StaticBody, rest: &[f64], motion: &[f64], level: f64) -> Vec<Vec3> {
    system.restore(rest);
    system.update(motion);
    if system.has_moving_supports() {
        system.refresh(level);
    }
    system.configuration().present
}

/// Largest displacement of a particle \[L\].
fn farthest(system: &dyn StaticBody, present: &[Vec3]) -> f64 {
    let start = system.configuration().rest;
    start.iter().zip(present).map(|(from, to)| (to - from).norm()).fold(0.0, f64::max)
}
