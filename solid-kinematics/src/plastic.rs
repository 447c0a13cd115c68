//! Flow by von Mises' criterion: the radial return of a step and its derivative.
//!
//! A step that would end at the stress σᵗ if nothing flowed has `ξᵗ = dev σᵗ − β`, β the back stress, and `qᵗ = √(3/2) |ξᵗ|`. Where `qᵗ ≤ K(α)`
//! it is elastic. Else backward Euler \[simo1998\], §3.3, keeps the direction `n = ξᵗ/|ξᵗ|` and leaves one equation for the growth Δα of the
//! equivalent plastic strain,
//!
//! ```text
//! qᵗ − (3G + H_k) Δα − K(α + Δα) = 0        σ = σᵗ − √6 G Δα n        β ← β + √(2/3) H_k Δα n
//! dσ = (C − 2G (a I_dev + b n ⊗ n)) dε      a = 3G Δα/qᵗ              b = 1/(1 + (K′ + H_k)/3G) − a
//! ```

use std::fmt::Debug;
use std::sync::Arc;

use crate::Tensor;
use crate::elastic::Moduli;
use crate::error::ElasticError;
use crate::voigt::{PAIRS, stress_tensor};

/// Share of the yield stress within which a point that does not flow in a step stands on the surface: it goes on flowing, as far as the
/// derivative knows, where rounding would toss a coin.
const ON_SURFACE: f64 = 1e-9;
/// Residual over the stress at which the growth is found.
const ROUNDING: f64 = 1e-15;
/// Steps of Newton's method, or halves of the bracket, at most: 4 to 12 are usual.
const MOST: usize = 80;

/// The yield stress K as a function of the equivalent plastic strain α, positive and never falling.
pub trait YieldCurve: Debug + Send + Sync {
    /// K and its slope at α, both \[F/L²\].
    fn at(&self, strain: f64) -> [f64; 2];

    /// `∫₀^α (K(a) − K(0)) da`, by convention what hardening stores \[F/L²\].
    fn stored(&self, strain: f64) -> f64;
}

/// What flow has left at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Flow {
    /// Equivalent plastic strain α \[–\].
    pub strain: f64,
    /// Back stress β in material axes \[F/L²\].
    pub back: [f64; 6],
}

/// How a material yields: by von Mises' criterion, along its normal.
#[derive(Clone, Debug)]
pub struct Plastic {
    curve: Arc<dyn YieldCurve>,
    shear: f64,
    kinematic: f64,
}

impl Plastic {
    /// Flow of a material with these moduli; the back stress grows by `kinematic` a plastic strain in uniaxial tension \[F/L²\].
    ///
    /// # Errors
    /// [`ElasticError::Preferred`] of moduli with preferred directions, [`ElasticError::Constant`] of a `kinematic` that is negative or not finite.
    pub fn new(moduli: &Moduli, curve: Arc<dyn YieldCurve>, kinematic: f64) -> Result<Self, ElasticError> {
        let shear = moduli.shear().ok_or(ElasticError::Preferred)?;
        if !(kinematic >= 0.0 && kinematic.is_finite()) {
            let (what, bound) = ("the modulus of kinematic hardening", "zero or positive, and finite");
            return Err(ElasticError::Constant { what, value: kinematic, bound });
        }
        Ok(Self { curve, shear, kinematic })
    }

    /// Stress and flow where a step would end at a stress if nothing flowed, in material axes.
    pub(crate) fn returned(&self, stress: &[f64; 6], from: &Flow) -> ([f64; 6], Flow) {
        let (direction, q) = effective(stress, &from.back);
        if q <= self.curve.at(from.strain)[0] {
            return (*stress, *from);
        }
        let growth = self.growth(q, from.strain);
        let fall = 6.0_f64.sqrt() * self.shear * growth;
        let rise = (2.0 / 3.0_f64).sqrt() * self.kinematic * growth;
        let back = std::array::from_fn(|i| from.back[i] + rise * direction[i]);
        let stress = std::array::from_fn(|i| stress[i] - fall * direction[i]);
        (stress, Flow { strain: from.strain + growth, back })
    }

    /// Δα: Newton's method within a bracket. Of a concave curve it comes from below without leaving it; of linear hardening it is there at once.
    fn growth(&self, q: f64, strain: f64) -> f64 {
        let stiff = 3.0 * self.shear + self.kinematic;
        let (mut low, mut high) = (0.0, (q - self.curve.at(strain)[0]) / stiff);
        let mut growth = 0.0;
        for _ in 0..MOST {
            let [bound, slope] = self.curve.at(strain + growth);
            let left = q - stiff * growth - bound;
            if left.abs() <= ROUNDING * q {
                break;
            }
            if left > 0.0 {
                low = growth;
            } else {
                high = growth;
            }
            let next = growth + left / (stiff + slope);
            growth = if (low..=high).contains(&next) { next } else { 0.5 * (low + high) };
        }
        growth
    }

    /// What flow takes from the moduli over a step that ends at a stress and a flow; nothing where it did not flow and does not stand at the surface.
    pub(crate) fn softening(&self, from: &Flow, (stress, to): (&[f64; 6], &Flow)) -> Option<Softening> {
        let (direction, q) = effective(stress, &to.back);
        let [bound, slope] = self.curve.at(to.strain);
        let growth = to.strain - from.strain;
        if growth <= 0.0 && q < bound * (1.0 - ON_SURFACE) {
            return None;
        }
        let stiff = 3.0 * self.shear;
        let turned = stiff * growth / (q + (stiff + self.kinematic) * growth);
        let along = 1.0 / (1.0 + (slope + self.kinematic) / stiff) - turned;
        let shear = 2.0 * self.shear;
        Some(Softening { deviator: shear * turned, along: shear * along, direction })
    }

    /// Energy per volume that hardening has stored, `∫(K − K(0)) dα + ¾ β:β/H_k` \[F/L²\].
    pub fn hardened(&self, flow: &Flow) -> f64 {
        let back = if self.kinematic > 0.0 { 0.75 * square(&flow.back) / self.kinematic } else { 0.0 };
        self.curve.stored(flow.strain) + back
    }

    /// Energy per volume dissipated, `K(0) α` \[F/L²\]: what backward Euler's work of a step leaves beside what is stored.
    pub fn dissipated(&self, flow: &Flow) -> f64 {
        self.curve.at(0.0)[0] * flow.strain
    }
}

/// What flow takes from the moduli: `2G (a I_dev + b n ⊗ n)`.
pub(crate) struct Softening {
    /// 2G a \[F/L²\].
    deviator: f64,
    /// 2G b \[F/L²\].
    along: f64,
    /// n.
    direction: [f64; 6],
}

impl Softening {
    /// The same, its direction turned from material axes into space.
    pub fn turned(self, axes: &Tensor) -> Self {
        let n = axes * stress_tensor(&self.direction) * axes.transpose();
        Self { direction: PAIRS.map(|pair| n[pair]), ..self }
    }

    /// The stress that it takes from that of a strain, shears twice \[F/L²\].
    pub fn stress(&self, strain: &[f64; 6]) -> [f64; 6] {
        let mean = strain[..3].iter().sum::<f64>() / 3.0;
        let along: f64 = self.along * self.direction.iter().zip(strain).map(|(n, e)| n * e).sum::<f64>();
        std::array::from_fn(|i| {
            let deviator = if i < 3 { strain[i] - mean } else { 0.5 * strain[i] };
            self.deviator * deviator + along * self.direction[i]
        })
    }
}

/// ξ over its length, and `q = √(3/2) |ξ|`.
fn effective(stress: &[f64; 6], back: &[f64; 6]) -> ([f64; 6], f64) {
    let mean = stress[..3].iter().sum::<f64>() / 3.0;
    let over: [f64; 6] =
        std::array::from_fn(|i| if i < 3 { stress[i] - mean - back[i] } else { stress[i] - back[i] });
    let length = square(&over).sqrt();
    (over.map(|x| if length > 0.0 { x / length } else { 0.0 }), 1.5_f64.sqrt() * length)
}

/// `s : s`.
fn square(s: &[f64; 6]) -> f64 {
    let of = |part: &[f64]| part.iter().map(|x| x * x).sum::<f64>();
    of(&s[..3]) + 2.0 * of(&s[3..])
}
