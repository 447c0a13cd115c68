//! Units: a scene declares one consistent set; they name the columns of results and change no number.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Units of length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema, Serialize)]
pub enum Length {
    /// Metre.
    #[serde(rename = "m")]
    Metre,
    /// Centimetre.
    #[serde(rename = "cm")]
    Centimetre,
    /// Millimetre.
    #[serde(rename = "mm")]
    Millimetre,
    /// Inch.
    #[serde(rename = "in")]
    Inch,
    /// Foot.
    #[serde(rename = "ft")]
    Foot,
    /// None: a dimensionless problem.
    #[serde(rename = "-")]
    None,
}

/// Units of force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema, Serialize)]
pub enum Force {
    /// Newton.
    #[serde(rename = "N")]
    Newton,
    /// Kilonewton.
    #[serde(rename = "kN")]
    Kilonewton,
    /// Meganewton.
    #[serde(rename = "MN")]
    Meganewton,
    /// Pound-force.
    #[serde(rename = "lbf")]
    PoundForce,
    /// None: a dimensionless problem.
    #[serde(rename = "-")]
    None,
}

/// Units of time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema, Serialize)]
pub enum Time {
    /// Second.
    #[serde(rename = "s")]
    Second,
    /// Millisecond.
    #[serde(rename = "ms")]
    Millisecond,
    /// Microsecond.
    #[serde(rename = "us")]
    Microsecond,
    /// None: a dimensionless problem.
    #[serde(rename = "-")]
    None,
}

/// One consistent set of units. The unit of mass follows: force · time² / length.
///
/// All three have a unit or none has: a length in metres with a force in `-` would be inconsistent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Units {
    /// Unit of length \[L\].
    pub length: Length,
    /// Unit of force \[F\].
    pub force: Force,
    /// Unit of time \[T\].
    pub time: Time,
    /// Whether forces, energies and fluxes are those of a unit of depth: plane bodies without a thickness of their own.
    #[serde(skip)]
    pub by_depth: bool,
}

/// What a column of results measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// \[–\].
    Ratio,
    /// \[L\].
    Length,
    /// \[F\].
    Force,
    /// \[T\].
    Time,
    /// \[F L\].
    Energy,
    /// \[rad\].
    Angle,
    /// \[1/T\].
    Rate,
    /// \[L/T\].
    Speed,
    /// \[L/T²\].
    Acceleration,
    /// \[1/L\].
    Curvature,
    /// \[F/L\].
    ForcePerLength,
    /// \[F L/L\].
    MomentPerLength,
    /// \[F/L²\].
    Stress,
    /// \[L²\].
    Area,
    /// \[L³\].
    Volume,
    /// \[F T²/L⁴\].
    Density,
    /// \[L³/T\].
    Flux,
    /// \[L²/T\].
    FluxByDepth,
    /// \[Θ\].
    Temperature,
    /// \[F L/T\].
    HeatFlow,
    /// \[F/T\].
    HeatByLength,
    /// \[F/(L T)\].
    HeatByArea,
}

impl Quantity {
    /// The same by a unit of depth.
    pub fn by_depth(self) -> Self {
        match self {
            Self::Force => Self::ForcePerLength,
            Self::Energy => Self::MomentPerLength,
            Self::Flux => Self::FluxByDepth,
            other => other,
        }
    }

    /// How its unit is written with those of length, force and time, of an angle in radians.
    pub(super) fn form(self, length: &str, force: &str, time: &str) -> String {
        match self {
            Self::Ratio => "-".into(),
            Self::Angle => "rad".into(),
            Self::Length => length.into(),
            Self::Force => force.into(),
            Self::Time => time.into(),
            Self::Rate => format!("1/{time}"),
            Self::Energy => format!("{force} {length}"),
            Self::Speed => format!("{length}/{time}"),
            Self::Acceleration => format!("{length}/{time}²"),
            Self::Curvature => format!("1/{length}"),
            Self::ForcePerLength => format!("{force}/{length}"),
            Self::MomentPerLength => format!("{force} {length}/{length}"),
            Self::Stress => format!("{force}/{length}²"),
            Self::Area => format!("{length}²"),
            Self::Volume => format!("{length}³"),
            Self::Density => format!("{force} {time}²/{length}⁴"),
            Self::Flux => format!("{length}³/{time}"),
            Self::FluxByDepth => format!("{length}²/{time}"),
            Self::Temperature => "Θ".into(),
            Self::HeatFlow => format!("{force} {length}/{time}"),
            Self::HeatByLength => format!("{force}/{time}"),
            Self::HeatByArea => format!("{force}/({length} {time})"),
        }
    }

    /// Powers of length, force and time in it.
    pub(super) fn powers(self) -> [i32; 3] {
        match self {
            Self::Ratio | Self::Angle | Self::Temperature => [0, 0, 0],
            Self::Length => [1, 0, 0],
            Self::Force | Self::MomentPerLength => [0, 1, 0],
            Self::Time => [0, 0, 1],
            Self::Rate => [0, 0, -1],
            Self::Energy => [1, 1, 0],
            Self::Speed => [1, 0, -1],
            Self::Acceleration => [1, 0, -2],
            Self::Curvature => [-1, 0, 0],
            Self::ForcePerLength => [-1, 1, 0],
            Self::Stress => [-2, 1, 0],
            Self::Area => [2, 0, 0],
            Self::Volume => [3, 0, 0],
            Self::Density => [-4, 1, 2],
            Self::Flux => [3, 0, -1],
            Self::FluxByDepth => [2, 0, -1],
            Self::HeatFlow => [1, 1, -1],
            Self::HeatByLength => [0, 1, -1],
            Self::HeatByArea => [-1, 1, -1],
        }
    }
}

impl Length {
    /// Symbol of the unit.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Centimetre => "cm",
            Self::Millimetre => "mm",
            Self::Inch => "in",
            Self::Foot => "ft",
            Self::None => "-",
        }
    }
}

impl Force {
    /// Symbol of the unit.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Newton => "N",
            Self::Kilonewton => "kN",
            Self::Meganewton => "MN",
            Self::PoundForce => "lbf",
            Self::None => "-",
        }
    }
}

impl Time {
    /// Symbol of the unit.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Second => "s",
            Self::Millisecond => "ms",
            Self::Microsecond => "us",
            Self::None => "-",
        }
    }
}

impl Units {
    /// Whether all three or none have a unit.
    pub fn consistent(&self) -> bool {
        let bare = [self.length == Length::None, self.force == Force::None, self.time == Time::None];
        bare.iter().all(|&b| b) || bare.iter().all(|&b| !b)
    }

    /// Symbol of the unit of a quantity, such as `N cm`, of one by depth `N cm/cm`; `-` without unit.
    pub fn symbol(&self, quantity: Quantity) -> String {
        let quantity = if self.by_depth { quantity.by_depth() } else { quantity };
        match quantity {
            Quantity::Angle => "rad".into(),
            // Either all three have a unit or none has.
            _ if self.length == Length::None => "-".into(),
            _ => quantity.form(self.length.symbol(), self.force.symbol(), self.time.symbol()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_follow_the_declared_set() {
        let units =
            Units { length: Length::Centimetre, force: Force::Newton, time: Time::Second, by_depth: false };
        assert_eq!(units.symbol(Quantity::Energy), "N cm");
        assert_eq!(units.symbol(Quantity::Angle), "rad");
        assert_eq!(units.symbol(Quantity::Stress), "N/cm²");
        assert_eq!(units.symbol(Quantity::MomentPerLength), "N cm/cm");
        assert_eq!(units.symbol(Quantity::Flux), "cm³/s");
        let plane = Units { by_depth: true, ..units };
        let symbols =
            [Quantity::Force, Quantity::Energy, Quantity::Flux, Quantity::Stress].map(|q| plane.symbol(q));
        assert_eq!(symbols, ["N/cm", "N cm/cm", "cm²/s", "N/cm²"]);
        assert!(units.consistent());
    }

    #[test]
    fn half_dimensionless_is_inconsistent() {
        let units = Units { length: Length::None, force: Force::Newton, time: Time::Second, by_depth: false };
        assert!(!units.consistent());
        let bare = Units { length: Length::None, force: Force::None, time: Time::None, by_depth: false };
        assert!(bare.consistent());
        assert_eq!(bare.symbol(Quantity::Energy), "-");
    }
}
