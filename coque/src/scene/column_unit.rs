//! The unit in which a column is written, where it is not that of the scene.

use super::units::{Force, Length, Quantity, Time, Units};

/// Units of length, in micrometres: whole numbers, so that their ratios are right to the last bit.
const LENGTHS: [(Length, f64); 5] = [
    (Length::Metre, 1e6),
    (Length::Centimetre, 1e4),
    (Length::Millimetre, 1e3),
    (Length::Inch, 25_400.0),
    (Length::Foot, 304_800.0),
];

/// Units of force, in 1e-13 N.
const FORCES: [(Force, f64); 4] = [
    (Force::Newton, 1e13),
    (Force::Kilonewton, 1e16),
    (Force::Meganewton, 1e19),
    (Force::PoundForce, 44_482_216_152_605.0),
];

/// Units of time, in microseconds.
const TIMES: [(Time, f64); 3] = [(Time::Second, 1e6), (Time::Millisecond, 1e3), (Time::Microsecond, 1.0)];

/// Units of stress that have a name, in newtons by square metre.
const STRESSES: [(&str, f64); 4] = [("Pa", 1.0), ("kPa", 1e3), ("MPa", 1e6), ("GPa", 1e9)];

/// A unit of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ColumnUnit {
    /// As the title of the column has it.
    pub symbol: String,
    /// How many of it make one of the unit that the scene has for the quantity.
    pub factor: f64,
}

impl ColumnUnit {
    /// The unit that is named, of a quantity in a scene with units; powers may be written `²` or `^2`. None if it is none of the quantity, or
    /// if the scene has no units.
    pub fn named(name: &str, quantity: Quantity, own: &Units) -> Option<Self> {
        let symbol = name.replace("^2", "²").replace("^3", "³").replace("^4", "⁴");
        let own = sizes(own)?;
        let ratio = |sizes: [f64; 3]| -> f64 {
            let powers = quantity.powers();
            let one = |k: usize| {
                let power = (own[k] / sizes[k]).powi(powers[k].abs());
                if powers[k] < 0 { 1.0 / power } else { power }
            };
            (0..3).map(one).product()
        };
        let named = STRESSES.iter().find(|(name, _)| quantity == Quantity::Stress && *name == symbol);
        let factor = match (quantity, symbol.as_str(), named) {
            (_, _, Some((_, pascals))) => ratio([1e6, 1e13, 1e6]) / pascals,
            (Quantity::Angle, "deg", _) => 1.0_f64.to_degrees(),
            _ => {
                let forms = LENGTHS.iter().flat_map(|(length, l)| {
                    FORCES.iter().flat_map(move |(force, f)| {
                        TIMES.iter().map(move |(time, t)| {
                            (quantity.form(length.symbol(), force.symbol(), time.symbol()), [*l, *f, *t])
                        })
                    })
                });
                forms.into_iter().find(|(form, _)| *form == symbol).map(|(_, sizes)| ratio(sizes))?
            }
        };
        Some(Self { symbol, factor })
    }

    /// The units that fit a quantity.
    pub fn fitting(quantity: Quantity) -> String {
        let lengths = LENGTHS.map(|(unit, _)| unit.symbol()).join(", ");
        let forces = FORCES.map(|(unit, _)| unit.symbol()).join(", ");
        let times = TIMES.map(|(unit, _)| unit.symbol()).join(", ");
        let form = quantity.form("LENGTH", "FORCE", "TIME");
        let words = [("FORCE", forces), ("LENGTH", lengths), ("TIME", times)];
        let parts = words.into_iter().filter(|(word, _)| form.contains(word));
        let parts: Vec<String> = parts
            .map(|(word, units)| if form == word { units } else { format!("{word} one of {units}") })
            .collect();
        match quantity {
            Quantity::Angle => "rad, deg".into(),
            Quantity::Ratio => "- alone".into(),
            Quantity::Temperature => "Θ alone, whichever unit the scene has".into(),
            Quantity::Length | Quantity::Force | Quantity::Time => parts.concat(),
            Quantity::Stress => {
                format!("{}; or {form}, {}", STRESSES.map(|(name, _)| name).join(", "), parts.join("; "))
            }
            _ => format!("{form}, {}", parts.join("; ")),
        }
    }
}

/// Sizes of the units of a scene, as those of [`base`]; none if it has no units.
pub(super) fn sizes(own: &Units) -> Option<[f64; 3]> {
    Some([size(&LENGTHS, own.length)?, size(&FORCES, own.force)?, size(&TIMES, own.time)?])
}

/// Which of length, force and time a symbol is a unit of, and its size, a whole number.
pub(super) fn base(symbol: &str) -> Option<(usize, f64)> {
    let lengths = LENGTHS.iter().map(|(unit, size)| (unit.symbol(), 0, *size));
    let forces = FORCES.iter().map(|(unit, size)| (unit.symbol(), 1, *size));
    let times = TIMES.iter().map(|(unit, size)| (unit.symbol(), 2, *size));
    let mut all = lengths.chain(forces).chain(times);
    all.find(|(known, ..)| *known == symbol).map(|(_, axis, size)| (axis, size))
}

/// The size of a unit.
fn size<U: PartialEq>(of: &[(U, f64)], unit: U) -> Option<f64> {
    of.iter().find(|(known, _)| *known == unit).map(|(_, size)| *size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_in_another_unit_is_the_same_value() {
        let metres =
            Units { length: Length::Metre, force: Force::Newton, time: Time::Second, by_depth: false };
        let inches = Units { length: Length::Inch, force: Force::PoundForce, ..metres };
        for (own, quantity, name, symbol, factor) in [
            (metres, Quantity::Length, "mm", "mm", 1e3),
            (metres, Quantity::Force, "kN", "kN", 1e-3),
            (metres, Quantity::Stress, "N/mm^2", "N/mm²", 1e-6),
            (metres, Quantity::Stress, "MPa", "MPa", 1e-6),
            (metres, Quantity::Energy, "kN mm", "kN mm", 1.0),
            (metres, Quantity::Density, "N s^2/mm^4", "N s²/mm⁴", 1e-12),
            (metres, Quantity::Angle, "deg", "deg", 180.0 / std::f64::consts::PI),
            (inches, Quantity::Length, "ft", "ft", 1.0 / 12.0),
            (inches, Quantity::ForcePerLength, "N/m", "N/m", 4.448_221_615_260_5 / 0.0254),
            // One pound by square inch is 6894.757 293 168 361 Pa.
            (inches, Quantity::Stress, "kPa", "kPa", 6.894_757_293_168_361),
        ] {
            let unit = ColumnUnit::named(name, quantity, &own).unwrap();
            assert_eq!(unit.symbol, symbol);
            // At most four ratios and their powers: a dozen roundings of 1.1e-16.
            assert!((unit.factor / factor - 1.0).abs() < 2e-15, "{name}: {} not {factor}", unit.factor);
        }
        assert_eq!(ColumnUnit::named("kN", Quantity::Length, &metres), None);
        let bare = Units { length: Length::None, force: Force::None, time: Time::None, by_depth: false };
        assert_eq!(ColumnUnit::named("mm", Quantity::Length, &bare), None);
    }
}
