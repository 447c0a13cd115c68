//! What interactions keep in the state of several bodies.

use super::parts::Parts;
use crate::bodies::body::StateArray;

/// What each interaction keeps, by name; nothing of those that keep nothing.
pub(in crate::bodies) fn kept_between(kept: &[Vec<f64>]) -> Vec<StateArray<'static>> {
    let kept = kept.iter().enumerate().filter(|(_, kept)| !kept.is_empty());
    let array = |(number, numbers): (usize, &Vec<f64>)| StateArray {
        name: name(number).into(),
        numbers: numbers.clone().into(),
    };
    kept.map(array).collect()
}

/// Takes that up, after the bodies have taken up their states; false if it is that of others.
pub(in crate::bodies) fn take_up_between<P: Parts + ?Sized>(
    parts: &mut P,
    arrays: &[StateArray<'_>],
) -> bool {
    let kept = |number: usize| -> &[f64] {
        let own = arrays.iter().find(|array| array.name == name(number));
        own.map_or(&[], |array| &array.numbers)
    };
    let kept: Vec<&[f64]> = (0..parts.kept().len()).map(kept).collect();
    parts.take_up(&kept)
}

/// Name of what an interaction keeps.
fn name(number: usize) -> String {
    format!("between bodies, {number}")
}
