//! What is known of bodies that are built beside each other: the files that they were read from, who looks at their shapes.

use std::ops::Range;

use sph_core::Cell;

use super::built_body::BuiltBody;
use super::model::{Identity, ShapeJudge};
use super::{Description, Shape};
use crate::Warning;

/// Who looks at the shapes of one of several bodies, its particles among all, its cells by its own numbers.
pub(super) type JudgeOfBody = (ShapeJudge, Range<usize>, Vec<Cell>);

/// Looks at the shapes of each body by itself.
pub(super) fn judge_each(judges: Vec<JudgeOfBody>) -> ShapeJudge {
    Box::new(move |_: &[Cell], shapes: &[Shape]| -> Vec<Warning> {
        let look = |(judge, range, cells): &JudgeOfBody| {
            let own = |shape: &Shape| Shape { positions: shape.positions[range.clone()].to_vec(), ..*shape };
            judge(cells, &shapes.iter().map(own).collect::<Vec<_>>())
        };
        judges.iter().flat_map(look).collect()
    })
}

/// The files that surfaces of bodies were read from, and one checksum of theirs.
pub(super) fn identity<B>(made: &[(&str, BuiltBody<B>)]) -> Identity {
    let files: Vec<&str> = made.iter().filter_map(|(_, made)| made.identity.file.as_deref()).collect();
    let sums: Vec<u8> =
        made.iter().filter_map(|(_, made)| made.identity.checksum).flat_map(u32::to_le_bytes).collect();
    Identity {
        file: (!files.is_empty()).then(|| files.join(", ")),
        checksum: (!sums.is_empty()).then(|| crc32fast::hash(&sums)),
    }
}

/// Lines of all bodies, each with the name of its body in front.
pub(super) fn lines<'a>(
    bodies: impl Iterator<Item = (&'a String, &'a Description)>,
    of: fn(&Description) -> &Vec<String>,
) -> Vec<String> {
    bodies.flat_map(|(name, body)| of(body).iter().map(move |line| format!("{name}: {line}"))).collect()
}
