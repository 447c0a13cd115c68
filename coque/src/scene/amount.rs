//! Numbers with a unit of their own, `"5 mm"`, in the units of the scene.
//!
//! A unit is a product of powers of length, force and time; mass is F T²/L. What a number is multiplied by is a ratio of whole numbers, and both
//! are kept apart: `7850 kg/m^3` is 7.85e-9 N s²/mm⁴ to the last bit.

use super::column_unit::sizes;
use super::units::Units;

/// Powers of length, force and time.
pub(super) type Powers = [i32; 3];

/// Units that are made of metres, newtons and seconds: symbol, powers, how many of these they are, of which one is how many of them.
const DERIVED: [(&str, Powers, [f64; 2]); 14] = [
    ("Pa", [-2, 1, 0], [1.0, 1.0]),
    ("kPa", [-2, 1, 0], [1e3, 1.0]),
    ("MPa", [-2, 1, 0], [1e6, 1.0]),
    ("GPa", [-2, 1, 0], [1e9, 1.0]),
    ("J", [1, 1, 0], [1.0, 1.0]),
    ("kJ", [1, 1, 0], [1e3, 1.0]),
    ("mJ", [1, 1, 0], [1.0, 1e3]),
    ("kg", [-1, 1, 2], [1.0, 1.0]),
    ("g", [-1, 1, 2], [1.0, 1e3]),
    ("t", [-1, 1, 2], [1e3, 1.0]),
    ("Hz", [0, 0, -1], [1.0, 1.0]),
    ("kHz", [0, 0, -1], [1e3, 1.0]),
    ("min", [0, 0, 1], [60.0, 1.0]),
    ("h", [0, 0, 1], [3600.0, 1.0]),
];

/// What a unit measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dimension {
    /// A product of powers.
    Of(Powers),
    /// An angle.
    Angle {
        /// Whether it is in degrees, in place of radians.
        degrees: bool,
    },
}

impl Dimension {
    /// What the description of a key says that it has, such as `F/L²`; none for anything else.
    pub fn described(text: &str) -> Option<Self> {
        match text {
            "degrees" => return Some(Self::Angle { degrees: true }),
            "rad" => return Some(Self::Angle { degrees: false }),
            "–" => return Some(Self::Of([0; 3])),
            _ => {}
        }
        let powers = factors(text)?.into_iter().try_fold([0; 3], |mut powers: Powers, (word, power)| {
            let axis = ["L", "F", "T"].iter().position(|known| *known == word)?;
            powers[axis] += power;
            Some(powers)
        });
        powers.map(Self::Of)
    }

    /// As a word of a refusal.
    pub fn word(self, units: &Units) -> String {
        match self {
            Self::Angle { .. } => "an angle, in deg or rad".into(),
            Self::Of([0, 0, 0]) => "a number without a unit".into(),
            Self::Of(powers) => {
                let symbols = [units.length.symbol(), units.force.symbol(), units.time.symbol()];
                let side = |sign: i32| {
                    let some = symbols.iter().zip(powers).filter(move |(_, power)| power * sign > 0);
                    let one = move |(symbol, power): (&&str, i32)| match power.abs() {
                        1 => (*symbol).to_string(),
                        power => format!("{symbol}^{power}"),
                    };
                    some.map(one).collect::<Vec<_>>()
                };
                let (over, under) = (side(1).join(" "), side(-1));
                let over = if over.is_empty() { "1".into() } else { over };
                let unit = [vec![over], under].concat().join("/");
                format!("{unit} or another unit of its dimension")
            }
        }
    }
}

/// A number and the unit behind it, if a text is so made; `5` alone and expressions are not.
pub(super) fn split(text: &str) -> Option<(f64, &str)> {
    let (number, unit) = text.trim().split_once(char::is_whitespace)?;
    let unit = unit.trim();
    let begins = unit.starts_with(|c: char| c.is_alphabetic() || c == '°') || unit.starts_with("1/");
    let digit = number.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    let number = number.parse::<f64>().ok().filter(|number| digit && number.is_finite())?;
    begins.then_some((number, unit))
}

/// A number in a unit, in the units of a scene, and what it measures; none for a unit that is not known, in a
/// scene without units, and beyond the numbers that arithmetic holds.
pub(super) fn in_units_of(number: f64, unit: &str, own: &Units) -> Option<(f64, Dimension)> {
    match unit {
        "deg" | "°" => return Some((number, Dimension::Angle { degrees: true })),
        "rad" => return Some((number, Dimension::Angle { degrees: false })),
        _ => {}
    }
    let own = sizes(own)?;
    let (mut powers, mut ratio) = ([0; 3], [1.0, 1.0]);
    for (word, power) in factors(unit)? {
        let (of_word, size) = unit_named(word)?;
        let mut multiply = |[over, under]: [f64; 2], power: i32| {
            let [over, under] = if power < 0 { [under, over] } else { [over, under] };
            (0..power.abs()).for_each(|_| {
                ratio[0] *= over;
                ratio[1] *= under;
            });
        };
        multiply(size, power);
        for axis in 0..3 {
            powers[axis] += power * of_word[axis];
            // Sizes of base units are whole numbers of a small one: one of the two ratios is whole where units are metric.
            let [given, own] = [METRE_NEWTON_SECOND[axis], own[axis]];
            let size = if given >= own { [given / own, 1.0] } else { [1.0, own / given] };
            multiply(size, power * of_word[axis]);
        }
    }
    let found = number * ratio[0] / ratio[1];
    found.is_finite().then_some((found, Dimension::Of(powers)))
}

/// Sizes of metre, newton and second as those of [`sizes`].
const METRE_NEWTON_SECOND: [f64; 3] = [1e6, 1e13, 1e6];

/// Powers of a unit, and how many of metres, newtons and seconds it is.
fn unit_named(word: &str) -> Option<(Powers, [f64; 2])> {
    if let Some((_, powers, size)) = DERIVED.iter().find(|(symbol, ..)| *symbol == word) {
        return Some((*powers, *size));
    }
    let (axis, size) = super::column_unit::base(word)?;
    let mut powers = [0; 3];
    powers[axis] = 1;
    let basis = METRE_NEWTON_SECOND[axis];
    Some((powers, if size >= basis { [size / basis, 1.0] } else { [1.0, basis / size] }))
}

/// Factors of a product such as `F T²/L⁴` with their powers; those after a `/`, of which each takes one, are below the line.
fn factors(text: &str) -> Option<Vec<(&str, i32)>> {
    let mut found = Vec::new();
    for (i, side) in text.split('/').enumerate() {
        let words: Vec<&str> = side.split([' ', '*', '·']).filter(|word| !word.is_empty()).collect();
        // `N/m s` may mean either.
        if words.is_empty() || i > 0 && words.len() > 1 {
            return None;
        }
        for word in words {
            if i == 0 && word == "1" {
                continue;
            }
            let (word, power) = powered(word)?;
            found.push((word, if i == 0 { power } else { -power }));
        }
    }
    Some(found)
}

/// A word and its power, as in `mm^2`, `mm²` or `mm2`.
fn powered(word: &str) -> Option<(&str, i32)> {
    let small = ["²", "³", "⁴", "⁵"].iter().zip(2..);
    for (sign, power) in small {
        if let Some(word) = word.strip_suffix(sign) {
            return Some((word, power));
        }
    }
    match word.split_once('^') {
        Some((word, power)) => Some((word, power.parse().ok().filter(|power| (-5..=5).contains(power))?)),
        None => Some((word, 1)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::units::{Force, Length, Time};

    const METRES: Units =
        Units { length: Length::Metre, force: Force::Newton, time: Time::Second, by_depth: false };
    const MILLIMETRES: Units = Units { length: Length::Millimetre, ..METRES };

    /// Numbers in their own units are those that one writes in the units of the scene, to the last bit.
    #[test]
    fn amounts_are_the_numbers_in_the_units_of_the_scene() {
        let inches = Units { length: Length::Inch, force: Force::PoundForce, ..METRES };
        for (text, units, expected, described) in [
            ("5 mm", METRES, 0.005_f64, "L"),
            ("5 mm", MILLIMETRES, 5.0, "L"),
            ("-2.5 cm", MILLIMETRES, -25.0, "L"),
            ("12 in", METRES, 0.3048, "L"),
            ("1 ft", inches, 12.0, "L"),
            ("210 GPa", MILLIMETRES, 210e3, "F/L²"),
            ("210e3 N/mm^2", METRES, 210e9, "F/L²"),
            ("7850 kg/m^3", MILLIMETRES, 7.85e-9, "F T²/L⁴"),
            ("7850 kg/m³", METRES, 7850.0, "F T²/L⁴"),
            ("8 g/cm^3", METRES, 8000.0, "F T²/L⁴"),
            ("9810 mm/s^2", METRES, 9.81, "L/T²"),
            ("3 m/s/s", MILLIMETRES, 3000.0, "L/T²"),
            ("2 kN m", MILLIMETRES, 2e6, "F L"),
            ("3 ms", METRES, 0.003, "T"),
            ("50 1/s", METRES, 50.0, "1/T"),
            ("2 kHz", METRES, 2000.0, "1/T"),
            ("2 t", METRES, 2000.0, "F T²/L"),
            ("90 deg", METRES, 90.0, "degrees"),
        ] {
            let (number, unit) = split(text).unwrap();
            let (number, dimension) = in_units_of(number, unit, &units).unwrap();
            assert_eq!(number.to_bits(), expected.to_bits(), "{text}: {number}");
            assert_eq!(Some(dimension), Dimension::described(described), "{text}");
        }
        // Pounds by square inch in pascals, to two roundings: 4.448 221 615 260 5 N over 645.16 mm².
        let (pressure, _) = in_units_of(1.0, "lbf/in^2", &METRES).unwrap();
        assert!((pressure / 6_894.757_293_168_361 - 1.0).abs() < 4e-16, "{pressure}");
    }

    #[test]
    fn what_is_no_amount_is_none() {
        for text in ["5", "mm", "5mm", "5 * 3", "${t} mm", "inf m", "5 + m"] {
            assert_eq!(split(text), None, "{text}");
        }
        for unit in ["mn", "N/m s", "m^9", "m^", "/m", "N//m", "m/"] {
            assert_eq!(in_units_of(1.0, unit, &METRES), None, "{unit}");
        }
        let bare = Units { length: Length::None, force: Force::None, time: Time::None, by_depth: false };
        assert_eq!(in_units_of(5.0, "mm", &bare), None);
        for said in ["T, –", "F/L, F L", "time, factor", ""] {
            assert_eq!(Dimension::described(said), None, "{said}");
        }
    }

    #[test]
    fn dimensions_are_said_in_the_units_of_the_scene() {
        let said = |text: &str| Dimension::described(text).unwrap().word(&MILLIMETRES);
        assert_eq!(said("F T²/L⁴"), "N s^2/mm^4 or another unit of its dimension");
        assert_eq!(said("1/T"), "1/s or another unit of its dimension");
        assert_eq!(said("–"), "a number without a unit");
        assert_eq!(said("degrees"), "an angle, in deg or rad");
    }
}
