//! What is looked at of glue where a run records, and when it is too soft.

use super::record::{GlueSummary, RunRecord};
use crate::WarningKind;
use crate::bodies::Body;

/// Share of the energy stored that is that of glue from which on a run says so. Bodies that give way by their glue as well have that share of their
/// displacement from it, where forces drive them.
const SOFT: f64 = 0.02;

/// Notes what glue does; `scale` is how much greater the motion is in the answer.
pub(crate) fn note(body: &dyn Body, scale: f64, found: &mut RunRecord) {
    for (number, now) in body.glue().into_iter().enumerate() {
        if number == found.glue.len() {
            found.glue.push(GlueSummary {
                between: now.between,
                particles: now.particles,
                stiffness: now.stiffness,
                greatest_gap: 0.0,
                gap_over_spacing: 0.0,
                greatest_energy: 0.0,
            });
        }
        let own = &mut found.glue[number];
        own.greatest_energy = own.greatest_energy.max(scale * scale * now.energy);
        own.greatest_gap = own.greatest_gap.max(scale * now.gap);
        own.gap_over_spacing = own.greatest_gap / now.spacing;
    }
}

/// Says which glue was soft in a run that has ended, whose energy was so great at most \[F L\].
pub(crate) fn judge(found: &mut RunRecord, internal: f64) {
    let share = |own: &GlueSummary| own.greatest_energy / internal;
    let soft = |own: &&GlueSummary| internal > 0.0 && share(own) > SOFT;
    let said = |own: &GlueSummary| {
        format!(
            "the glue of {} stores {:.1} % of the energy ({} % and more are soft) and gives way by {:.2e} of a spacing: displacements are \
             greater by about that share of their own than those of bodies that are one; give it a greater `stiffness`, in time \
             at the price of shorter steps, or glue more rows of particles",
            own.between,
            100.0 * share(own),
            100.0 * SOFT,
            own.gap_over_spacing,
        )
    };
    let messages: Vec<String> = found.glue.iter().filter(soft).map(said).collect();
    messages.into_iter().for_each(|message| found.warn(WarningKind::SoftGlue, message));
}
