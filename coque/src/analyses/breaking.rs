//! What broke at its limit on a path of equilibria: its figures, its warning, and its place in the balance of energy.

use implicit_statics::Breach;

use crate::WarningKind;
use crate::run::record::{BreakingSummary, Energies, RunRecord, place};

/// Takes over what broke, set by set; `unit` is that of the force where the level is one.
pub(super) fn note_breaches(breaches: &[Breach], unit: Option<&str>, found: &mut RunRecord) {
    let Some(first) = breaches.first() else { return };
    if found.breaking.is_none() {
        found.warn(WarningKind::BrokenAtRest, growth(&place(first.level, unit)));
    }
    let so_far = found.breaking.get_or_insert_with(|| BreakingSummary::from(first.level));
    for breach in breaches {
        so_far.sets += 1;
        so_far.highest_level = so_far.highest_level.max(breach.level);
        so_far.greatest_driving_force = so_far.greatest_driving_force.max(breach.driving_force);
        so_far.energy += breach.energy;
        so_far.released += breach.released;
    }
}

/// Energies at rest: what broke, and what it set free, the loads did beside what is stored. `freed` \[F L\] was taken by snaps.
pub(super) fn at_rest(internal: f64, freed: f64, found: &RunRecord) -> Energies {
    let broken = found.breaking.as_ref().map_or(0.0, |breaking| breaking.energy + breaking.released);
    let dissipated = broken + freed;
    Energies { dissipated, external: internal + dissipated, ..Energies::at_rest(internal) }
}

fn growth(first: &str) -> String {
    format!(
        "from {first} on bonds broke in states of balance, the most critical first with a balance between: a crack is held by each row of \
         the lattice until about a fifth to a quarter more is released than it takes, so that it grows at up to 13 % more force than Griffith's \
         at horizons of 3 to 4 spacings (docs/peridynamics.md), and starts from a notch cut along the lattice at a few percent less on coarse \
         ones; what leaps sets free is in `breaking.released`; compare spacings, or use [analysis.explicit.transient], in \
         which a crack runs at its own speed"
    )
}
