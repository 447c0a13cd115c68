//! What the numbers of a record may be in: times first, then what the course multiplies, or factors.

use toml::de::DeTable;

use super::Misread;
use crate::scene::amount::{self, Dimension};
use crate::scene::units::{Length, Units};

/// What a course multiplies that stands beside these keys, or in a table of this name.
const MULTIPLIED: [(&str, &str); 14] = [
    ("acceleration", "L/T²"),
    ("force", "F"),
    ("couple", "F L"),
    ("pressure", "F/L²"),
    ("gas", "F/L²"),
    ("traction", "F/L²"),
    ("gravity", "L/T²"),
    ("volume", "L³"),
    ("moved", "L"),
    ("turn", "rad"),
    ("rotated", "degrees"),
    ("turned", "degrees"),
    ("translation", "L"),
    ("rotation", "degrees"),
];

/// Acceleration of gravity by which records in `g` count \[m/s²\].
const GRAVITY: &str = "m/s^2";
const STANDARD: f64 = 9.806_65;

/// Of an acceleration.
const ACCELERATION: Dimension = Dimension::Of([1, 0, -2]);

/// What the first numbers of a record are.
const TIMES: (&str, Dimension) = ("times", Dimension::Of([0, 0, 1]));
const FREQUENCIES: (&str, Dimension) = ("frequencies", Dimension::Of([0, 0, -1]));

/// What a course multiplies.
#[derive(Clone, Copy)]
pub(super) struct Multiplied {
    /// What its first numbers are: times, or frequencies of a spectrum by those.
    first: (&'static str, Dimension),
    /// Its key, with its dimension; none where there is no one.
    one: Option<(&'static str, Dimension)>,
}

impl Multiplied {
    /// Of the course that stands in a table, or of a spectrum by frequency.
    pub fn beside(path: &str, table: &DeTable<'_>, by_frequency: bool) -> Self {
        let own = path.rsplit('.').next().unwrap_or_default();
        let mut found = MULTIPLIED.iter().filter(|(key, _)| *key == own || table.contains_key(*key));
        let first = found.next().filter(|_| found.next().is_none());
        let one = first.and_then(|(key, described)| Some((*key, Dimension::described(described)?)));
        let first = if by_frequency { FREQUENCIES } else { TIMES };
        Self { first, one }
    }
}

/// Puts times and numbers, in such units, into those of the scene.
///
/// # Errors
/// [`Misread`] for units that are not known, or are none of a time and of what is multiplied.
pub(super) fn convert(
    points: &mut [[f64; 2]],
    [time, number]: &[String; 2],
    multiplied: Multiplied,
    own: Option<&Units>,
) -> Result<(), Misread> {
    for [t, x] in points {
        let (what, wanted) = multiplied.first;
        *t = converted(*t, time, what, own, |dimension, own| {
            (dimension != wanted).then(|| format!("{}, or \"-\", of {what}", wanted.word(own)))
        })?;
        *x = converted(*x, number, what, own, |dimension, own| {
            let Some((key, wanted)) = multiplied.one else {
                return Some("\"-\": the course is a factor on what has no one unit".into());
            };
            let g = if wanted == ACCELERATION { "\"g\", " } else { "" };
            (dimension != wanted)
                .then(|| format!("{g}{}, or \"-\", of a course of `{key}`", wanted.word(own)))
        })?;
    }
    Ok(())
}

/// A number in a unit, in the units of the scene, to the last bit; `bound` says what it should be where it is another dimension.
fn converted(
    number: f64,
    unit: &str,
    first: &str,
    own: Option<&Units>,
    bound: impl Fn(Dimension, &Units) -> Option<String>,
) -> Result<f64, Misread> {
    if unit == "-" {
        return Ok(number);
    }
    let named = format!("\"{unit}\"");
    let Some(own) = own.filter(|units| units.consistent() && units.length != Length::None) else {
        let bound = "\"-\": the scene has no units";
        let repair = "add units = [\"-\", \"-\"] to the record, whose numbers then count as they are";
        return Err(Misread::new("units", named, bound, repair));
    };
    let found = match unit {
        "g" => amount::in_units_of(STANDARD * number, GRAVITY, own),
        _ => amount::in_units_of(number, unit, own),
    };
    let Some((number, dimension)) = found else {
        let bound = "a unit that is known, \"g\" for the acceleration of gravity, or \"-\"";
        let repair = "write a unit such as \"s\", \"m/s^2\", \"cm/s^2\", \"kN\"";
        return Err(Misread::new("units", named, bound, repair));
    };
    match bound(dimension, own) {
        None => Ok(number),
        Some(bound) => {
            let such = if first == FREQUENCIES.0 { "Hz" } else { "s" };
            let repair = format!(
                "the first unit is that of {first}, the second that of numbers; write \"-\" where they are factors, as in units = [\"{such}\", \"-\"]"
            );
            Err(Misread::new("units", named, bound, repair))
        }
    }
}

/// Refuses units of an .AT2 other than its own, which it says itself: others would convert its numbers a second time.
pub(super) fn check_peer(units: &[String; 2]) -> Result<(), Misread> {
    for (unit, (own, of)) in units.iter().zip([("s", "times"), ("g", "numbers")]) {
        if unit != own && unit != "-" {
            let bound = format!("\"{own}\" or \"-\" of the {of} of an .AT2, which are in {own}");
            let repair = "remove it: an .AT2 is read in s and g; \"-\" takes its numbers as they are";
            return Err(Misread::new("units", format!("\"{unit}\""), bound, repair));
        }
    }
    Ok(())
}
