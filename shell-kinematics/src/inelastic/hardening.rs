//! Hardening: the yield stress as a function of the equivalent plastic strain.

use super::functions::{above_zero, exp, ln};
use crate::pack::Number;
use crate::section::MaterialError;

/// How the yield stress K grows with the equivalent plastic strain α; it starts above zero and never falls.
#[derive(Clone, Debug, PartialEq)]
pub struct Hardening(Curve);

/// The curves, with constants that were checked.
#[derive(Clone, Debug, PartialEq)]
enum Curve {
    Linear { initial: f64, slope: f64 },
    Voce { initial: f64, rise: f64, rate: f64 },
    Swift { factor: f64, offset: f64, exponent: f64 },
    Table { initial: f64, bends: Vec<Bend>, until: f64 },
}

/// Where the slope of a table changes.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Bend {
    strain: f64,
    /// By how much the slope grows there \[F/L²\].
    change: f64,
}

/// Yield stress and its slope, both \[F/L²\].
#[derive(Clone, Copy, Debug)]
pub(super) struct Yield<P> {
    pub stress: P,
    pub slope: P,
}

/// A number that is positive and finite.
pub(super) fn positive(what: &'static str, value: f64) -> Result<f64, MaterialError> {
    let ok = value > 0.0 && value.is_finite();
    if ok { Ok(value) } else { Err(MaterialError::Constant { what, value, bound: "positive and finite" }) }
}

/// A number that is zero, or positive and finite.
pub(super) fn not_negative(what: &'static str, value: f64) -> Result<f64, MaterialError> {
    let ok = value >= 0.0 && value.is_finite();
    if ok {
        Ok(value)
    } else {
        Err(MaterialError::Constant { what, value, bound: "zero or positive, and finite" })
    }
}

impl Hardening {
    /// `K = σ_y + H α`; H = 0 is perfect plasticity \[F/L²\].
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless `σ_y > 0` and `H ≥ 0`, both finite.
    pub fn linear(yield_stress: f64, slope: f64) -> Result<Self, MaterialError> {
        let initial = positive("the yield stress", yield_stress)?;
        Ok(Self(Curve::Linear { initial, slope: not_negative("the slope of linear hardening", slope)? }))
    }

    /// `K = σ_y + Q (1 − e^(−bα))`, Voce's saturation by Q \[F/L²\] at the rate b \[–\].
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless `σ_y > 0`, `Q ≥ 0` and `b > 0`, all finite.
    pub fn voce(yield_stress: f64, rise: f64, rate: f64) -> Result<Self, MaterialError> {
        Ok(Self(Curve::Voce {
            initial: positive("the yield stress", yield_stress)?,
            rise: not_negative("the rise of Voce's hardening", rise)?,
            rate: positive("the rate of Voce's hardening", rate)?,
        }))
    }

    /// `K = k (e0 + α)ⁿ`, Swift's power law: k \[F/L²\], e0 and n \[–\].
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless `k > 0`, `e0 > 0` and `0 ≤ n ≤ 1`, all finite.
    pub fn swift(factor: f64, offset: f64, exponent: f64) -> Result<Self, MaterialError> {
        if !(0.0..=1.0).contains(&exponent) {
            let what = "the exponent of Swift's hardening";
            return Err(MaterialError::Constant { what, value: exponent, bound: "from 0 to 1" });
        }
        Ok(Self(Curve::Swift {
            factor: positive("the factor of Swift's hardening", factor)?,
            offset: positive("the offset of Swift's hardening", offset)?,
            exponent,
        }))
    }

    /// Rows of equivalent plastic strain \[–\] and yield stress \[F/L²\], joined by straight lines; the last slope is kept beyond the last row.
    ///
    /// # Errors
    /// [`MaterialError::Constant`] for fewer than two rows, [`MaterialError::Row`] unless the first strain is zero, strains rise and stresses are
    /// positive and do not fall, all finite.
    pub fn table(rows: &[[f64; 2]]) -> Result<Self, MaterialError> {
        let &[[_, initial], _, ..] = rows else {
            let (what, value) = ("the number of rows of a hardening table", rows.len() as f64);
            return Err(MaterialError::Constant { what, value, bound: "at least 2" });
        };
        let refused =
            |row: usize, what, value, bound| Err(MaterialError::Row { row: row + 1, what, value, bound });
        for (row, &[strain, stress]) in rows.iter().enumerate() {
            let before = row.checked_sub(1).map(|row| rows[row]);
            if !strain.is_finite() || before.is_none() && strain != 0.0 {
                return refused(row, "the plastic strain", strain, "zero in the first row, and finite");
            }
            if before.is_some_and(|[last, _]| strain <= last) {
                return refused(row, "the plastic strain", strain, "above that of the row before");
            }
            if !(stress > 0.0 && stress.is_finite()) {
                return refused(row, "the yield stress", stress, "positive and finite");
            }
            if before.is_some_and(|[_, last]| stress < last) {
                return refused(row, "the yield stress", stress, "at least that of the row before");
            }
        }
        let mut slope = 0.0;
        let bends = rows.windows(2).map(|pair| {
            let next = (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]);
            let bend = Bend { strain: pair[0][0], change: next - slope };
            slope = next;
            bend
        });
        let until = rows[rows.len() - 1][0];
        Ok(Self(Curve::Table { initial, bends: bends.collect(), until }))
    }

    /// The plastic strain beyond which a table says nothing \[–\]; none of other curves.
    pub fn until(&self) -> Option<f64> {
        if let Curve::Table { until, .. } = &self.0 { Some(*until) } else { None }
    }

    /// Yield stress where nothing has flowed \[F/L²\].
    pub fn initial(&self) -> f64 {
        self.at(0.0).stress
    }

    /// K(α) \[F/L²\].
    pub fn stress<P: Number>(&self, alpha: P) -> P {
        self.at(alpha).stress
    }

    /// K'(α) \[F/L²\].
    pub fn slope<P: Number>(&self, alpha: P) -> P {
        self.at(alpha).slope
    }

    /// K and K' at α.
    #[inline(always)]
    pub(super) fn at<P: Number>(&self, alpha: P) -> Yield<P> {
        match &self.0 {
            Curve::Linear { initial, slope } => {
                Yield { stress: alpha * *slope + alpha.all(*initial), slope: alpha.all(*slope) }
            }
            Curve::Voce { initial, rise, rate } => {
                let left = exp(alpha * -rate) * *rise;
                Yield { stress: alpha.all(initial + rise) - left, slope: left * *rate }
            }
            Curve::Swift { factor, offset, exponent } => {
                let strain = alpha + alpha.all(*offset);
                let stress = exp(ln(strain) * *exponent) * *factor;
                Yield { stress, slope: stress * *exponent / strain }
            }
            Curve::Table { initial, bends, .. } => {
                let zero = alpha.all(0.0);
                let mut out = Yield { stress: alpha.all(*initial), slope: alpha.all(bends[0].change) };
                out.stress += alpha * bends[0].change;
                for bend in &bends[1..] {
                    let beyond = alpha - alpha.all(bend.strain);
                    out.stress += beyond.max(zero) * bend.change;
                    out.slope += above_zero(beyond) * bend.change;
                }
                out
            }
        }
    }

    /// `∫₀^α (K(a) − K(0)) da` \[F/L²\]: by convention what hardening stores.
    #[inline(always)]
    pub fn stored<P: Number>(&self, alpha: P) -> P {
        match &self.0 {
            Curve::Linear { slope, .. } => alpha * alpha * (0.5 * slope),
            Curve::Voce { rise, rate, .. } => {
                alpha * *rise - (alpha.all(1.0) - exp(alpha * -rate)) * (rise / rate)
            }
            Curve::Swift { factor, offset, exponent } => {
                let power = |strain: P| exp(ln(strain) * (exponent + 1.0)) * (factor / (exponent + 1.0));
                let start = alpha.all(*offset);
                power(alpha + start) - power(start) - alpha * self.initial()
            }
            Curve::Table { bends, .. } => {
                let zero = alpha.all(0.0);
                let mut sum = zero;
                for bend in bends {
                    let beyond = (alpha - alpha.all(bend.strain)).max(zero);
                    sum += beyond * beyond * (0.5 * bend.change);
                }
                sum
            }
        }
    }
}
