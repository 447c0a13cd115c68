//! Numbers with a bound that every scene keeps: refused while a scene is read, and bounds of its schema.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;
use std::ops::Deref;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{Deserialize, Deserializer, Error, Unexpected, Visitor};
use serde::ser::{Serialize, Serializer};
use serde_json::json;

/// Beyond these, products of five numbers leave the range of `f64`. Inside lie the densities, F T²/L⁴, that units of length,
/// force and time nine powers of ten away ask for.
pub(super) const LEAST: f64 = 1e-60;
pub(super) const GREATEST: f64 = 1e60;

/// A number that a scene gives: with decimals, or whole.
pub trait Number: Copy + fmt::Debug + fmt::Display + PartialOrd + Serialize + 'static {
    /// What serde calls it.
    const WORD: &'static str;
    /// What the schema calls it.
    const SCHEMA: &'static str;
    /// A number with decimals as one.
    fn of_f64(x: f64) -> Option<Self>;
    /// A whole number as one.
    fn of_i64(n: i64) -> Option<Self>;
    /// As a number with decimals.
    fn as_f64(self) -> f64;
}

impl Number for f64 {
    const WORD: &'static str = "f64";
    const SCHEMA: &'static str = "number";

    fn of_f64(x: f64) -> Option<Self> {
        Some(x)
    }

    fn of_i64(n: i64) -> Option<Self> {
        Some(n as f64)
    }

    fn as_f64(self) -> f64 {
        self
    }
}

impl Number for usize {
    const WORD: &'static str = "usize";
    const SCHEMA: &'static str = "integer";

    fn of_f64(_: f64) -> Option<Self> {
        None
    }

    fn of_i64(n: i64) -> Option<Self> {
        n.try_into().ok()
    }

    fn as_f64(self) -> f64 {
        self as f64
    }
}

/// A number that does not keep its bound.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{value} must be {bound}; {repair}")]
pub struct OutOfBounds {
    value: f64,
    pub(super) bound: String,
    pub(super) repair: &'static str,
}

/// Bounds of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// Above zero, and of a size that arithmetic can hold.
    Positive,
    /// Zero, or the same.
    NotNegative,
    /// Between two numbers, both excluded.
    Between(f64, f64),
    /// From one number to another, both included.
    Within(f64, f64),
}

impl Range {
    /// What is asked for and not kept, and what to do about it.
    fn refuses(self, x: f64, repair: &'static str) -> Option<OutOfBounds> {
        let sized = x == 0.0 || (LEAST..=GREATEST).contains(&x.abs());
        let bound = match self {
            Self::Positive if x <= 0.0 => "positive".into(),
            Self::NotNegative if x < 0.0 => "zero or positive".into(),
            Self::Positive | Self::NotNegative if !sized => {
                let repair = "choose other units if the number is meant";
                let bound = format!("zero or between {LEAST:e} and {GREATEST:e} in size");
                return Some(OutOfBounds { value: x, bound, repair });
            }
            Self::Between(low, high) if !(low < x && x < high) => {
                format!("between {low} and {high}, both excluded")
            }
            Self::Within(low, high) if !(low <= x && x <= high) => format!("from {low} to {high}"),
            _ => return None,
        };
        Some(OutOfBounds { value: x, bound, repair })
    }
}

/// A bound with the repair that belongs to a key.
pub trait Bound: Copy + fmt::Debug + PartialEq + 'static {
    /// Whole, or with decimals.
    type Number: Number;
    /// What is allowed.
    const RANGE: Range;
    /// What to do about a number beyond it.
    const REPAIR: &'static str;
}

/// A number that keeps a bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded<B: Bound>(B::Number, PhantomData<B>);

/// What was found, what is allowed and what to do, between marks that no message of serde has.
pub(super) const MARK: char = '\u{1f}';

impl<B: Bound> Bounded<B> {
    /// The number, if it keeps the bound.
    ///
    /// # Errors
    /// [`OutOfBounds`] if it does not.
    pub fn new(x: B::Number) -> Result<Self, OutOfBounds> {
        B::RANGE.refuses(x.as_f64(), B::REPAIR).map_or(Ok(Self(x, PhantomData)), Err)
    }

    /// A default that is known to keep the bound.
    pub(crate) const fn usual(x: B::Number) -> Self {
        Self(x, PhantomData)
    }

    /// The number.
    pub fn get(self) -> B::Number {
        self.0
    }

    fn read<E: Error>(x: B::Number) -> Result<Self, E> {
        Self::new(x).map_err(|OutOfBounds { bound, repair, .. }| {
            E::custom(format!("{MARK}{x}{MARK}{bound}{MARK}{repair}"))
        })
    }
}

/// The numbers of a list.
pub(crate) fn numbers<B: Bound>(list: &[Bounded<B>]) -> Vec<B::Number> {
    list.iter().map(|number| number.get()).collect()
}

impl<B: Bound> Deref for Bounded<B> {
    type Target = B::Number;

    fn deref(&self) -> &B::Number {
        &self.0
    }
}

impl<B: Bound> fmt::Display for Bounded<B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<B: Bound> Serialize for Bounded<B> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.serialize(serializer)
    }
}

impl<'de, B: Bound> Deserialize<'de> for Bounded<B> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reader<B>(PhantomData<B>);
        impl<B: Bound> Visitor<'_> for Reader<B> {
            type Value = Bounded<B>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(B::Number::WORD)
            }

            fn visit_f64<E: Error>(self, x: f64) -> Result<Bounded<B>, E> {
                let number = B::Number::of_f64(x);
                Bounded::read(number.ok_or_else(|| E::invalid_type(Unexpected::Float(x), &self))?)
            }

            fn visit_i64<E: Error>(self, n: i64) -> Result<Bounded<B>, E> {
                let number = B::Number::of_i64(n);
                Bounded::read(number.ok_or_else(|| E::invalid_value(Unexpected::Signed(n), &self))?)
            }
        }
        // Read as whatever it is: errors of the visitor then have the place of the value.
        deserializer.deserialize_any(Reader(PhantomData))
    }
}

impl<B: Bound> JsonSchema for Bounded<B> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Bounded".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let mut schema = Schema::default();
        schema.insert("type".into(), B::Number::SCHEMA.into());
        let mut bound = |word: &str, x: f64| {
            let whole = B::Number::of_f64(x).is_none();
            schema.insert(word.into(), if whole { json!(x as i64) } else { json!(x) });
        };
        match B::RANGE {
            Range::Positive => bound("exclusiveMinimum", 0.0),
            Range::NotNegative => bound("minimum", 0.0),
            Range::Between(low, high) => {
                bound("exclusiveMinimum", low);
                bound("exclusiveMaximum", high);
            }
            Range::Within(low, high) => {
                bound("minimum", low);
                bound("maximum", high);
            }
        }
        schema
    }
}

impl Default for NotNegative {
    fn default() -> Self {
        Self::usual(0.0)
    }
}

/// Names bounds: the number, what is allowed, what to do.
macro_rules! bounds {
    ($($(#[$doc:meta])* $name:ident: $number:ty, $range:expr, $repair:expr;)*) => {
        /// The bounds by name.
        pub mod bound {
            $($(#[$doc])* #[derive(Clone, Copy, Debug, PartialEq)] pub struct $name;)*
        }
        $(
            $(#[$doc])*
            pub type $name = Bounded<bound::$name>;

            impl Bound for bound::$name {
                type Number = $number;
                const RANGE: Range = $range;
                const REPAIR: &'static str = $repair;
            }
        )*
    };
}

bounds! {
    /// A number above zero.
    Positive: f64, Range::Positive, "give a number above zero";
    /// A number not below zero.
    NotNegative: f64, Range::NotNegative, "leave it out for zero";
    /// An angle within one turn either way \[degrees\].
    Angle: f64, Range::Within(-360.0, 360.0), "give the angle within one turn";
    /// The same of the fibre of a ply, from the axis of the section \[degrees\].
    PlyAngle: f64, Range::Within(-360.0, 360.0), "in degrees from the axis; give the angle within one turn";
    /// An angle from a pole \[degrees\].
    Polar: f64, Range::Between(0.0, 180.0), "leave a small hole at the pole, such as 1 degree";
    /// Share of the stable step \[–\].
    Safety: f64, Range::Between(0.0, 1.0), "0.8 is usual; at 1 the step is at the limit of stability";
    /// Share of energy or load up to which a state counts as rest \[–\].
    Rest: f64, Range::Between(0.0, 1.0), "1e-8 is usual";
    /// Share of an answer that may be missing \[–\].
    Missing: f64, Range::Between(0.0, 1.0), "5e-3 is usual";
    /// Residual over load \[–\].
    Residual: f64, Range::Between(0.0, 1.0), "leave it out for the usual 1e-9";
    /// Residual over load of a relaxation \[–\].
    RelaxedResidual: f64, Range::Between(0.0, 1.0), "leave it out for the usual 1e-6";
    /// Share of a spacing \[–\].
    Displaced: f64, Range::Within(0.0, 0.49), "beyond half a spacing neighbours would change places";
    /// Last spacing over the first, of a shell \[–\].
    Grading: f64, Range::Within(0.001, 1000.0), "it is the last spacing over the first: 1 is uniform, 10 and 0.1 are strong";
    /// The same of a block \[–\].
    BlockGrading: f64, Range::Within(0.001, 1000.0), "it is the last spacing over the first: 1 is even, 3 and 0.3 are strong";
    /// Smoothing length of a shell in spacings \[–\]: below a stencil cannot hold its neighbours, beyond it smears every curvature.
    Smoothing: f64, Range::Within(0.6, 3.0), "in units of the particle spacing; 1.2 to 1.5 is usual";
    /// Horizon of bonds in spacings \[–\].
    Horizon: f64, Range::Within(1.4, 10.0), "in units of the spacing; 1.5 suits sheets, 3.015 cracks; below 1.4 no bond leaves the axes";
    /// Distance of contact in spacings \[–\].
    Near: f64, Range::Within(0.1, 1.0), "in units of the spacing; beyond 1 neighbours at rest would repel";
    /// Stretch of a bond that is shortened \[–\].
    Shortening: f64, Range::Between(-1.0, 0.0), "it is negative, as in -0.1; leave it out and bonds do not break in compression";
    /// Smoothing length of a fluid in spacings \[–\].
    FluidSmoothing: f64, Range::Within(1.0, 3.0), "1.55 is usual; 2 covers fluid that is stretched twofold and costs half as much again";
    /// Artificial viscosity of a fluid \[–\].
    Viscosity: f64, Range::Within(0.0, 1.0), "0.02 is usual; 0.1 hides a third of the energy at walls";
    /// Diffusion of density \[–\].
    Diffusion: f64, Range::Within(0.0, 0.5), "0.1 is usual; 0 leaves pressures noisy";
    /// Share of the neighbours' velocity \[–\].
    Shared: f64, Range::Within(0.0, 1.0), "0 is usual, 0.5 in the published method";
    /// Courant number \[–\].
    Courant: f64, Range::Within(0.001, 0.5), "0.3 is usual; at 0.6 still water does not stay at rest";
    /// How much higher the peak of a spectrum of waves is than that of a sea raised to the full \[–\].
    Peakedness: f64, Range::Within(1.0, 10.0), "3.3 is usual, 1 is the spectrum of Pierson and Moskowitz";
    /// Waves of which a sea is the sum.
    Components: usize, Range::Within(8.0, 1000.0), "64 is usual; a sea of few waves repeats itself";
    /// Depth over half of a thickness up to which contact sets in softly \[–\].
    Rounding: f64, Range::Within(0.0, 0.125), "0.05 is usual in time, 0 without; it has to end well before the barrier at one half";
    /// Coefficient of friction \[–\].
    FrictionCoefficient: f64, Range::Within(0.0, 2.0), "0.1 to 0.6 are usual; leave it out for a smooth tool";
    /// Part of a stiffener that is modelled \[–\].
    StiffenerShare: f64, Range::Within(1e-6, 1.0), "0.5 is the half of one that a plane of symmetry cuts along, 1 all of it";
    /// Iterations of Newton's method, which converges in some ten or not at all.
    Iterations: usize, Range::Within(1.0, 1000.0), "leave it out for the usual number";
    /// Iterations of a relaxation: one that takes more does not come to rest.
    RelaxationIterations: usize, Range::Within(1.0, 1e9), "leave it out for the usual 100000";
    /// Iterations of conjugate gradients.
    GradientIterations: usize, Range::Within(1.0, 1e9), "leave it out for the usual 5000";
    /// Steps of a path, which keeps every point.
    Steps: usize, Range::Within(1.0, 1e6), "a few hundred are usual";
    /// Modes, which are found together and kept whole.
    Modes: usize, Range::Within(1.0, 1000.0), "the lowest few modes are usual";
    /// Frequencies of a range.
    Points: usize, Range::Within(2.0, 1e6), "a few hundred are usual";
    /// Part of the critical damping \[–\].
    DampingRatio: f64, Range::Between(0.0, 1.0), "0.01 to 0.05 are usual; leave `damping` out for none";
    /// Energy lost in a cycle over 2π times the greatest that is stored \[–\].
    LossFactor: f64, Range::Between(0.0, 2.0), "0.01 to 0.1 are usual; leave `damping` out for none";
    /// Gauss points along an edge of a cell.
    GaussPoints: usize, Range::Within(1.0, 4.0), "3 is usual";
    /// Gauss points through a thickness.
    ThroughThickness: usize, Range::Within(2.0, 5.0), "one point carries no bending; leave it out for the closed form";
    /// Slices through the thickness of a section that yields.
    Slices: usize, Range::Within(2.0, 100.0), "6 is usual, 10 for springback, 40 for a thousandth";
    /// Exponent of a law of hardening \[–\].
    Exponent: f64, Range::Within(0.0, 1.0), "0.1 to 0.3 are usual; 0 is perfect plasticity";
    /// Number of a ply, from the lowest.
    PlyNumber: usize, Range::Within(1.0, 10000.0), "plies are counted from the lowest, which is 1";
    /// Order of shape functions.
    Order: usize, Range::Within(1.0, 3.0), "orders 1, 2 and 3 exist";
    /// Number of a buckling mode: further ones are expensive, and seldom what a body is bent like.
    ModeNumber: usize, Range::Within(1.0, 100.0), "1 is the first to buckle";
}
