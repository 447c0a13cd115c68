//! What a run has found, its rows and shapes apart: kept in checkpoints, written into summaries, read by the judge.

use implicit_statics::Inertia;
use serde::{Deserialize, Serialize};

use crate::bodies::{FluidFigures, Spanned};
use crate::{Warning, WarningKind};

/// What a run has found so far, its rows and shapes apart.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RunRecord {
    /// Time steps; without time the converged points of the path, the evaluations of a relaxation, or the modes.
    pub steps: u64,
    /// Newton iterations; zero for analyses in time.
    pub newton_iterations: u64,
    /// Factorisations of the tangent along a path, those of trials that failed and of the search for critical points too; zero for analyses
    /// without a path. A factor is kept while it serves, which takes more iterations.
    #[serde(default)]
    pub factorisations: u64,
    /// Solves with a factor, counted likewise.
    #[serde(default)]
    pub solves: u64,
    /// Critical points found on a path without time.
    pub critical: Vec<CriticalSummary>,
    /// Greatest stable step of the reference configuration \[T\]; zero if none was found, or without time.
    pub stable_step: f64,
    /// Fraction of the stable step that was used; zero without time.
    pub safety: f64,
    /// Time the run took, over all its sessions \[s\].
    pub wall_seconds: f64,
    /// What conjugate gradients took; none where the tangent was factored.
    pub conjugate_gradients: Option<ConjugateSummary>,
    /// What was applied before the analysis; none without a preload.
    pub preload: Option<PreloadSummary>,
    /// What broke at its limit on a path of equilibria; none where nothing did.
    pub breaking: Option<BreakingSummary>,
    /// Energies at the last record.
    pub energies: Energies,
    /// How well the energies of a march balance; none without time.
    pub balance: Option<BalanceSummary>,
    /// What each contact did; empty without contact.
    pub contacts: Vec<ContactSummary>,
    /// What glue between bodies did; empty without any.
    pub glue: Vec<GlueSummary>,
    /// Steps in time that contact made shorter; none where it did not.
    pub shortened: Option<ShortenedSummary>,
    /// How each load level ended; empty without levels.
    pub levels: Vec<LevelSummary>,
    /// What may be wrong with the numbers above, and why.
    pub warnings: Vec<Warning>,
    /// The count of modes; none for other analyses.
    pub counted: Option<CountSummary>,
    /// Figures of a fluid and its coupling; none for other bodies.
    pub fluid: Option<FluidFigures>,
    /// Frames of fields written; zero without `output.fields`.
    pub frames: u64,
}

impl RunRecord {
    /// Adds a warning.
    pub(crate) fn warn(&mut self, kind: WarningKind, message: String) {
        self.warnings.push(Warning::new(kind, message));
    }

    /// Why numbers fall short of what was asked although the run reached its end; none where they do not.
    pub fn falls_short(&self) -> Option<String> {
        let levels: Vec<String> = self.not_settled().iter().map(f64::to_string).collect();
        if !levels.is_empty() {
            return Some(format!("not settled: {}", levels.join(", ")));
        }
        let broken = self.warnings.iter().any(|warning| warning.kind == WarningKind::BrokenAtRest);
        broken.then(|| {
            "bonds broke in states of balance: the force is no more exact than the warning says".into()
        })
    }

    /// Load levels that were left before the motion had died.
    pub fn not_settled(&self) -> Vec<f64> {
        self.levels.iter().filter(|level| !level.settled).map(|level| level.level).collect()
    }
}

/// What conjugate gradients took for a linear answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ConjugateSummary {
    /// Iterations.
    pub iterations: u64,
    /// Residual over load at the end, both in the norm of the preconditioner: near the error in the energy norm \[–\].
    pub residual: f64,
    /// Unknowns of each level of multigrid, finest first.
    pub unknowns: Vec<usize>,
}

/// How a preload was brought up; counts here are none of those of the run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PreloadSummary {
    /// Equilibria found on the way, its end included.
    pub points: u64,
    /// Newton iterations.
    pub newton_iterations: u64,
    /// Internal energy under it \[F L\].
    pub internal: f64,
    /// Negative pivots of the tangent under it: the directions in which that state is unstable.
    pub negative_pivots: usize,
    /// Critical points on the way; levels are parts of the preload.
    pub critical: Vec<CriticalSummary>,
}

/// What broke at its limit, one critical set at a time, with a balance between.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BreakingSummary {
    /// Sets that broke.
    pub sets: u64,
    /// Load level at which the first did; with a `moved` support of one node the force.
    pub first_level: f64,
    /// Highest level at which one did.
    pub highest_level: f64,
    /// Greatest force that prescribed motions took as one broke, the root of the sum of squares over nodes \[F\].
    pub greatest_driving_force: f64,
    /// Energy that it takes to bring them to their limits \[F L\].
    pub energy: f64,
    /// Energy set free at constant levels, beyond that \[F L\].
    pub released: f64,
}

impl BreakingSummary {
    /// Nothing broke yet, at this level the first does.
    pub(crate) fn from(level: f64) -> Self {
        let zero = 0.0;
        Self {
            sets: 0,
            first_level: level,
            highest_level: level,
            greatest_driving_force: zero,
            energy: zero,
            released: zero,
        }
    }
}

/// Energies at the last record \[F L\].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Energies {
    /// Kinetic.
    pub kinetic: f64,
    /// Internal.
    pub internal: f64,
    /// Work of loads and prescribed motions.
    pub external: f64,
    /// Taken by damping.
    pub dissipated: f64,
    /// What is missing from the balance.
    pub balance_error: f64,
}

impl Energies {
    /// Along equilibria that start unloaded the work of the loads is the internal energy.
    pub(crate) fn at_rest(internal: f64) -> Self {
        Self { internal, external: internal, ..Self::default() }
    }
}

/// Glue of a set of one body to another, over all records.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GlueSummary {
    /// The set and the body that it joins.
    pub between: String,
    /// Number of particles that are glued.
    pub particles: usize,
    /// Their stiffnesses, summed \[F/L\].
    pub stiffness: f64,
    /// Greatest distance of a particle from where it is held, at a record \[L\].
    pub greatest_gap: f64,
    /// The same over the spacing of the bodies \[–\].
    pub gap_over_spacing: f64,
    /// Greatest energy stored at a record \[F L\].
    pub greatest_energy: f64,
}

/// A contact, over all records.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ContactSummary {
    /// What touches what.
    pub between: String,
    /// Stiffness of a unit of area \[F/L³\].
    pub stiffness: f64,
    /// Which bound that is: "thickness", or "step" in time; none where two bodies give it.
    pub set_by: Option<String>,
    /// Greatest depth at a record over the distance at which faces touch \[–\].
    pub greatest_depth: f64,
    /// When that was \[T\]; zero without time.
    pub time: f64,
    /// At which level.
    pub level: f64,
    /// Where \[L\]; none where nothing was deep.
    pub place: Option<[f64; 3]>,
    /// Greatest area at a record that touched \[L²\].
    pub greatest_area: f64,
    /// Rows of nodes of a solid that it spans; none of what is no solid, and where nothing touched.
    pub rows: Option<RowsSummary>,
}

/// Rows of nodes of a solid that a contact spans from its rim to its middle, over all records at which it touched.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RowsSummary {
    /// Where they were fewest.
    pub fewest: Spanned,
    /// Where they were most.
    pub most: Spanned,
    /// The last level at which they were fewer than those wanted; none where they never were.
    pub coarse_level: Option<f64>,
}

impl RowsSummary {
    /// Takes in what a contact spans at a level; the first of all begins it.
    pub(crate) fn take(known: &mut Option<Self>, now: Spanned, level: f64) {
        let own = known.get_or_insert(Self { fewest: now, most: now, coarse_level: None });
        own.fewest = own.fewest.narrower(now);
        if now.rows > own.most.rows {
            own.most = now;
        }
        if now.is_coarse() {
            own.coarse_level = Some(level);
        }
    }
}

/// Steps in time that contact made shorter than the bodies alone would take.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ShortenedSummary {
    /// How many.
    pub steps: u64,
    /// The shortest over that of the bodies \[–\].
    pub least: f64,
    /// When that was \[T\].
    pub time: f64,
}

/// How well the energies of a march balance, over all of its records.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BalanceSummary {
    /// Greatest energy turned over up to a record: kinetic, internal (below zero where an initial stress is set free) and
    /// dissipated together, or the work from outside \[F L\].
    pub turned_over: f64,
    /// Greatest error of the balance at a record \[F L\].
    pub worst: f64,
    /// When it was met \[T\].
    pub time: f64,
}

impl BalanceSummary {
    /// Takes in the energies of one more record.
    pub(crate) fn take(&mut self, time: f64, energies: &Energies) {
        let Energies { kinetic, internal, external, dissipated, balance_error } = *energies;
        self.turned_over = self.turned_over.max(kinetic + internal.abs() + dissipated).max(external.abs());
        if balance_error.abs() > self.worst.abs() {
            (self.worst, self.time) = (balance_error, time);
        }
    }

    /// The worst error in parts of what was turned over; zero where nothing was.
    pub fn share(&self) -> f64 {
        if self.worst == 0.0 { 0.0 } else { self.worst / self.turned_over }
    }
}

/// How a load level ended.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LevelSummary {
    /// Load level.
    pub level: f64,
    /// Whether the motion died within the hold.
    pub settled: bool,
    /// Kinetic over internal energy at the end of the hold.
    pub kinetic_over_internal: f64,
    /// Force out of balance over load at the end of the hold; zero without time.
    pub out_of_balance: f64,
    /// Way left to the equilibrium over displacement at the end of the hold; zero without time.
    pub remaining_displacement: f64,
    /// Negative pivots of the tangent: the directions in which the state is unstable; absent where it was not looked at.
    pub negative_pivots: Option<usize>,
    /// Steps spent on the level; iterations of a relaxation, points of a path.
    pub steps: u64,
    /// Evaluations of the forces that the level took; absent where they were not counted.
    pub evaluations: Option<u64>,
    /// Factorisations of the tangent that the level took, those of trials that failed and of the search for critical points too; absent where
    /// there is no path. A factor is kept while it serves: iterations alone do not tell what a level cost.
    pub factorisations: Option<u64>,
    /// Solves with a factor, counted likewise.
    pub solves: Option<u64>,
    /// Period by which a march went at the end of the level, the one given or the one found \[T\]; absent without time.
    pub period: Option<f64>,
}

impl LevelSummary {
    /// An equilibrium found without time.
    pub(crate) fn balanced(level: f64, inertia: Option<Inertia>, steps: u64) -> Self {
        Self {
            level,
            settled: true,
            kinetic_over_internal: 0.0,
            out_of_balance: 0.0,
            remaining_displacement: 0.0,
            negative_pivots: inertia.map(|inertia| inertia.negative),
            steps,
            evaluations: None,
            factorisations: None,
            solves: None,
            period: None,
        }
    }
}

/// A singular tangent met on a path of equilibria.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CriticalSummary {
    /// "limit point", "bifurcation" or "bifurcation, branch taken"; "turning point", "change of branch", "critical points, not located" or "doubtful
    /// step" where a warning says more.
    pub kind: String,
    /// Load level; with a `moved` support the force along the motion.
    pub level: f64,
    /// Unit of the level where it is a force.
    pub unit: Option<String>,
    /// Levels between which it lies, where it was not located.
    pub between: Option<[f64; 2]>,
}

impl CriticalSummary {
    /// Where it lies: `load level 0.5`, or `a force of 127.4 N`.
    pub fn place(&self) -> String {
        place(self.level, self.unit.as_deref())
    }
}

/// A level with what it is: `load level 0.5`, or `a force of 127.4 N`.
pub(crate) fn place(level: f64, unit: Option<&str>) -> String {
    match unit {
        None => format!("load level {level}"),
        Some("-") => format!("a force of {level}"),
        Some(unit) => format!("a force of {level} {unit}"),
    }
}

/// How many modes there are, counted by the signs of pivots (Sylvester's law): as many as were found, none missing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CountSummary {
    /// Lower end of the interval: a level, or a circular frequency squared \[1/T²\]; none where nothing lies below.
    pub from: Option<f64>,
    /// Its upper end.
    pub to: f64,
    /// Modes between the two; those wanted are the nearest to zero of them.
    pub number: usize,
    /// Factorisations that the modes took.
    pub factorisations: usize,
    /// Solves that they took.
    pub solves: usize,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_has_its_unit() {
        assert_eq!(place(0.5, None), "load level 0.5");
        assert_eq!(place(127.4, Some("N")), "a force of 127.4 N");
        assert_eq!(place(127.4, Some("-")), "a force of 127.4");
    }
}
