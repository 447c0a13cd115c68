//! What is known to make a number wrong, looked for in a shell before it is run and in the shapes it took.
//!
//! One table of rules, [`RULES`]: each has a word and a function from the shell at rest to a message, if there is cause
//! for one. A rule looks once, in time that grows with the number of particles; nothing is looked at in a step. Bounds come
//! from measured errors of more than two percent, each derived beside its rule; scenes that pass them may still be right (a load
//! that does not stir what is doubtful), scenes that do not may be off for reasons that no rule knows.

mod bars;
mod coarse;
mod contact;
mod folded;
mod hot;
mod look;
mod meaningless;
mod method;
mod offset;
mod patterns;
mod profile;
mod sheet;
mod tied;

use nalgebra::Rotation3;
use sph_core::{Cell, Cloud};
use sph_shell::{ChordLoss, Shell};

use crate::bodies::Shape;
use crate::scene::body_in_scene::ShellInScene;
use crate::warning::{Warning, WarningKind};
use look::Look;
pub(crate) use patterns::among_preloaded_modes;
use sheet::Sheet;
pub(crate) use tied::between_lines;

/// A rule: what is doubtful, and whether it is so in a shell at rest.
struct Rule {
    kind: WarningKind,
    of: fn(&Look<'_>) -> Option<String>,
}

/// Every rule, in the order in which warnings are printed.
const RULES: [Rule; 26] = [
    Rule { kind: WarningKind::NoWork, of: meaningless::no_work },
    Rule { kind: WarningKind::HeldLoad, of: meaningless::held_load },
    Rule { kind: WarningKind::FarNearest, of: meaningless::far_nearest },
    Rule { kind: WarningKind::TooThick, of: meaningless::too_thick },
    Rule { kind: WarningKind::Overlap, of: meaningless::overlap },
    Rule { kind: WarningKind::StrongForm, of: method::strong_form },
    Rule { kind: WarningKind::NodalLocking, of: method::nodal },
    Rule { kind: WarningKind::WideThin, of: method::wide },
    Rule { kind: WarningKind::UnevenCells, of: method::uneven },
    Rule { kind: WarningKind::FewSlices, of: method::few_slices },
    Rule { kind: WarningKind::SharpFold, of: coarse::fold },
    Rule { kind: WarningKind::TiedBothSides, of: tied::both_sides },
    Rule { kind: WarningKind::ShallowSheet, of: tied::shallow },
    Rule { kind: WarningKind::ThinProfile, of: profile::profile },
    Rule { kind: WarningKind::DeepStiffener, of: bars::deep },
    Rule { kind: WarningKind::OffsetInertia, of: offset::inertia },
    Rule { kind: WarningKind::ScaledInertia, of: offset::scaled },
    Rule { kind: WarningKind::PatternModes, of: patterns::among_modes },
    Rule { kind: WarningKind::CoarseTurn, of: coarse::turn },
    Rule { kind: WarningKind::CoarseBending, of: coarse::bending },
    Rule { kind: WarningKind::FewParticles, of: coarse::few },
    Rule { kind: WarningKind::SharpCorners, of: coarse::corners },
    Rule { kind: WarningKind::Pole, of: coarse::pole },
    Rule { kind: WarningKind::CoarseContact, of: contact::coarse },
    Rule { kind: WarningKind::LargeStrain, of: hot::hot },
    Rule { kind: WarningKind::WholeHeat, of: hot::whole },
];

/// What is doubtful about a shell that no scene describes; see [`crate::Model::warnings`] for the others.
pub fn warnings(shell: &Shell) -> Vec<Warning> {
    found(&Look::at(shell))
}

/// What is doubtful about the shell of a scene, turned by `turn`.
pub(crate) fn warnings_of(scene: &ShellInScene<'_>, turn: Rotation3<f64>, shell: &Shell) -> Vec<Warning> {
    found(&Look { scene: Some(scene), turn, ..Look::at(shell) })
}

fn found(look: &Look<'_>) -> Vec<Warning> {
    RULES.iter().filter_map(|rule| Some(Warning::new(rule.kind, (rule.of)(look)?))).collect()
}

/// What is doubtful about a cloud by itself: folds, cells that lie on each other, narrow sheets at junctions.
pub(crate) fn warnings_of_cloud(cloud: &Cloud) -> Vec<String> {
    let across = sheet::neighbours(&cloud.cells, cloud.len());
    let sheet = Sheet::at(&cloud.positions, &cloud.cells, &across);
    let overlaps = folded::overlaps(&sheet, &cloud.positions, 0.0);
    let narrow =
        [tied::both_sides_of, tied::shallow_of, profile::profile_of].map(|rule| rule(cloud, &across));
    [coarse::fold_of(&sheet), meaningless::overlap_of(&overlaps)]
        .into_iter()
        .chain(narrow)
        .flatten()
        .collect()
}

/// What is doubtful about the shapes that a shell of some area \[L²\] at rest took: cells that turn too far from one to the next,
/// and uneven cells that are stretched. Each is reported once, for the first shape in which it is so.
pub(crate) fn warnings_of_shapes(
    cells: &[Cell],
    loss: ChordLoss,
    rest: f64,
    shapes: &[Shape],
) -> Vec<Warning> {
    let Some(first) = shapes.first() else { return Vec::new() };
    let across = sheet::neighbours(cells, first.positions.len());
    let (mut turned, mut stretched) = (None, None);
    for shape in shapes {
        let now = Sheet::at(&shape.positions, cells, &across);
        let stretch = now.areas.iter().sum::<f64>() / rest - 1.0;
        turned = turned.or_else(|| coarse::turned(&now, shape.level));
        stretched = stretched.or_else(|| method::stretched(loss, stretch, shape.level));
    }
    let reported = [(WarningKind::CoarseTurn, turned), (WarningKind::UnevenCells, stretched)];
    reported.into_iter().filter_map(|(kind, message)| Some(Warning::new(kind, message?))).collect()
}

/// A number with its noun.
fn plural(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}
