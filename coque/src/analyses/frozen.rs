//! What is doubtful about modes of a touched state, in which contact is frozen: how far a motion may go before that is wrong.

use contact::{FrontChange, Turn};
use implicit_statics::BucklingMode;

use crate::bodies::StaticBody;

/// Amplitude over the thickness below which a change of what touches is said. Where it changes a frequency follows the amplitude; a plate is linear
/// otherwise up to some tenths of its thickness.
const AMPLITUDE: f64 = 0.01;

/// What is doubtful about modes of vibration: those that change what touches at a small amplitude, to either side.
pub(super) fn of_vibration(system: &mut dyn StaticBody, shapes: &[&[f64]]) -> Option<String> {
    let thickness = system.linear_reach();
    let mut first: Option<(usize, f64, FrontChange)> = None;
    let mut numbers = Vec::new();
    for (number, shape) in shapes.iter().enumerate() {
        let back: Vec<f64> = shape.iter().map(|u| -u).collect();
        let either = [system.first_change(shape), system.first_change(&back)];
        let Some(change) = either.into_iter().flatten().reduce(FrontChange::sooner) else { continue };
        let amplitude = change.share * greatest_way(system, shape);
        if amplitude >= AMPLITUDE * thickness {
            continue;
        }
        numbers.push((number + 1).to_string());
        if first.is_none_or(|(_, least, _)| amplitude < least) {
            first = Some((number + 1, amplitude, change));
        }
    }
    let (number, amplitude, change) = first?;
    Some(format!(
        "contact is taken to stay as the preload left it, and mode {number} {} at an amplitude of {amplitude:.2e}, {:.2e} of the thickness \
         (less than {AMPLITUDE} in modes {}): beyond it the frequency follows the amplitude. Press harder, or march it by \
         [analysis.explicit.transient]",
        said(&change),
        amplitude / thickness,
        numbers.join(", "),
    ))
}

/// What is doubtful about buckling levels: contact that changes before them.
pub(super) fn of_buckling(system: &mut dyn StaticBody, modes: &[BucklingMode]) -> Option<String> {
    let lowest = modes.first()?;
    let change = system.first_change(&lowest.before).filter(|change| change.share < 1.0)?;
    Some(format!(
        "contact is taken to stay as the preload left it, and the load {} at {:.4} of the level {:.4}, by the linear answer: what touches \
         is another before the body buckles. Follow the path by levels of [analysis.static]",
        said(&change),
        change.share,
        lowest.level,
    ))
}

/// Greatest way of a particle in a motion \[L\].
fn greatest_way(system: &mut dyn StaticBody, motion: &[f64]) -> f64 {
    let (rest, start) = (system.save(), system.configuration().present);
    system.update(motion);
    let present = system.configuration().present;
    system.restore(&rest);
    start.iter().zip(&present).map(|(from, to)| (to - from).norm()).fold(0.0, f64::max)
}

fn said(change: &FrontChange) -> String {
    let FrontChange { turn, place, .. } = change;
    let at = format!("at [{:.4}, {:.4}, {:.4}]", place.x, place.y, place.z);
    match turn {
        Turn::Opens => format!("opens it {at}"),
        Turn::Closes => format!("closes it {at}"),
        Turn::Slips => format!("makes it slip {at}"),
    }
}
