//! What is known to make a number wrong, looked for in a shell before it is run and in the shapes it took.
//!
//! One table of rules, [`RULES`]: each has a word and a function from the shell at rest to a message, if there is cause
//! for one. A rule looks once, in time that grows with the number of particles; nothing is looked at in a step. Bounds come
//! from measured errors of more than two percent, each derived beside its rule; scenes that pass them may still be right (a load
//! that does not stir what is doubtful), scenes that do not may be off for reasons that no rule knows.

mod coarse;
mod folded;
mod look;
mod method;
mod offset;
mod patterns;
mod profile;
mod senseless;
mod sheet;
mod tied;

use nalgebra::Rotation3;
use sph_core::{Cell, Cloud};
use sph_shell::{ChordLoss, Shell};

use crate::bodies::Shape;
use crate::scene::Scene;
use crate::warning::{Doubt, Warning};
use look::Look;
pub(crate) use patterns::among_preloaded_modes;
use sheet::Sheet;
pub(crate) use tied::between_lines;

/// A rule: what is doubtful, and whether it is so in a shell at rest.
struct Rule {
    doubt: Doubt,
    of: fn(&Look<'_>) -> Option<String>,
}

/// Every rule, in the order in which warnings are printed.
const RULES: [Rule; 21] = [
    Rule { doubt: Doubt::NoWork, of: senseless::no_work },
    Rule { doubt: Doubt::HeldLoad, of: senseless::held_load },
    Rule { doubt: Doubt::FarNearest, of: senseless::far_nearest },
    Rule { doubt: Doubt::TooThick, of: senseless::too_thick },
    Rule { doubt: Doubt::Overlap, of: senseless::overlap },
    Rule { doubt: Doubt::StrongForm, of: method::strong_form },
    Rule { doubt: Doubt::NodalLocking, of: method::nodal },
    Rule { doubt: Doubt::WideThin, of: method::wide },
    Rule { doubt: Doubt::UnevenCells, of: method::uneven },
    Rule { doubt: Doubt::SharpFold, of: coarse::fold },
    Rule { doubt: Doubt::TiedBothSides, of: tied::both_sides },
    Rule { doubt: Doubt::ShallowSheet, of: tied::shallow },
    Rule { doubt: Doubt::ThinProfile, of: profile::profile },
    Rule { doubt: Doubt::OffsetInertia, of: offset::inertia },
    Rule { doubt: Doubt::ScaledInertia, of: offset::scaled },
    Rule { doubt: Doubt::PatternModes, of: patterns::among_modes },
    Rule { doubt: Doubt::CoarseTurn, of: coarse::turn },
    Rule { doubt: Doubt::CoarseBending, of: coarse::bending },
    Rule { doubt: Doubt::FewParticles, of: coarse::few },
    Rule { doubt: Doubt::SharpCorners, of: coarse::corners },
    Rule { doubt: Doubt::Pole, of: coarse::pole },
];

/// What is doubtful about a shell that no scene describes; see [`crate::Model::warnings`] for the others.
pub fn doubts(shell: &Shell) -> Vec<Warning> {
    found(&Look::at(shell))
}

/// What is doubtful about the shell of a scene, turned by `turn`.
pub(crate) fn doubts_of(scene: &Scene, turn: Rotation3<f64>, shell: &Shell) -> Vec<Warning> {
    found(&Look { scene: Some(scene), turn, ..Look::at(shell) })
}

fn found(look: &Look<'_>) -> Vec<Warning> {
    RULES.iter().filter_map(|rule| Some(Warning::new(rule.doubt, (rule.of)(look)?))).collect()
}

/// What is doubtful about a cloud by itself: folds, cells that lie on each other, narrow sheets at junctions.
pub(crate) fn doubts_of_cloud(cloud: &Cloud) -> Vec<String> {
    let across = sheet::neighbours(&cloud.cells, cloud.len());
    let sheet = Sheet::at(&cloud.positions, &cloud.cells, &across);
    let overlaps = folded::overlaps(&sheet, &cloud.positions, 0.0);
    let narrow =
        [tied::both_sides_of, tied::shallow_of, profile::profile_of].map(|rule| rule(cloud, &across));
    [coarse::fold_of(&sheet), senseless::overlap_of(&overlaps)].into_iter().chain(narrow).flatten().collect()
}

/// What is doubtful about the shapes that a shell of some area \[L²\] at rest took: cells that turn too far from one to the next,
/// and uneven cells that are stretched. Each is told once, for the first shape in which it is so.
pub(crate) fn doubts_of_shapes(cells: &[Cell], loss: ChordLoss, rest: f64, shapes: &[Shape]) -> Vec<Warning> {
    let Some(first) = shapes.first() else { return Vec::new() };
    let across = sheet::neighbours(cells, first.positions.len());
    let (mut turned, mut stretched) = (None, None);
    for shape in shapes {
        let now = Sheet::at(&shape.positions, cells, &across);
        let stretch = now.areas.iter().sum::<f64>() / rest - 1.0;
        turned = turned.or_else(|| coarse::turned(&now, shape.level));
        stretched = stretched.or_else(|| method::stretched(loss, stretch, shape.level));
    }
    let told = [(Doubt::CoarseTurn, turned), (Doubt::UnevenCells, stretched)];
    told.into_iter().filter_map(|(doubt, message)| Some(Warning::new(doubt, message?))).collect()
}

/// A number with its noun.
fn plural(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}
