//! Hill's criterion of 1948 in plane stress, by the r-values of three directions.
//!
//! ```text
//! P = ⅔ [[G+H, −H, 0], [−H, F+H, 0], [0, 0, 2N]]
//! H = r0/(1+r0)    G = 1/(1+r0)    F = r0/(r90(1+r0))    N = (r0+r90)(1+2r45)/(2 r90(1+r0))
//! ```
//!
//! r is the plastic strain across a bar over that through its thickness, as it is pulled at 0, 45 and 90° from the first axis; the yield stress is that
//! of a bar along the first axis. r = 1 everywhere is von Mises' criterion.

use super::modes::Modes;
use crate::section::{Isotropic, MaterialError};

/// r-values of a rolled sheet at 0, 45 and 90° from its rolling direction \[–\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RValues([f64; 3]);

impl RValues {
    /// At 0, 45 and 90°.
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless all are positive and finite.
    pub fn new(r0: f64, r45: f64, r90: f64) -> Result<Self, MaterialError> {
        for (what, value) in
            [("the r-value at 0°", r0), ("the r-value at 45°", r45), ("the r-value at 90°", r90)]
        {
            if !(value > 0.0 && value.is_finite()) {
                return Err(MaterialError::Constant { what, value, bound: "positive and finite" });
            }
        }
        Ok(Self([r0, r45, r90]))
    }

    /// P11, P22, P12, P66.
    fn criterion(&self) -> [f64; 4] {
        let [r0, r45, r90] = self.0;
        let [h, f] = [r0 / (1.0 + r0), r0 / (r90 * (1.0 + r0))];
        let n = (r0 + r90) * (1.0 + 2.0 * r45) / (2.0 * r90 * (1.0 + r0));
        [1.0, f + h, -h, 2.0 * n].map(|entry| entry * 2.0 / 3.0)
    }
}

impl Modes {
    /// The basis of isotropic elasticity with Hill's criterion, in the axes of the sheet.
    ///
    /// `V = √C Q` with Q the eigenvectors of `√C P √C`: √C has the mean and the difference as its own.
    pub fn hill(elastic: &Isotropic, r: &RValues) -> Self {
        let [p11, p22, p12, p66] = r.criterion();
        let [mean, half] =
            [1.0 - elastic.poisson, 1.0 + elastic.poisson].map(|share| 0.5 * (elastic.young / share).sqrt());
        let [own, other] = [mean + half, mean - half];
        // √C P √C of the first two components.
        let a = own * own * p11 + 2.0 * own * other * p12 + other * other * p22;
        let c = other * other * p11 + 2.0 * own * other * p12 + own * own * p22;
        let b = own * other * (p11 + p22) + (own * own + other * other) * p12;
        let [middle, apart] = [0.5 * (a + c), 0.5 * (a - c)];
        let radius = (apart * apart + b * b).sqrt();
        let (sin, cos) = libm::sincos(0.5 * libm::atan2(b, apart));
        let shear = elastic.shear();
        Self {
            basis: [
                [own * cos + other * sin, other * cos - own * sin, 0.0],
                [other * cos + own * sin, own * cos - other * sin, 0.0],
                [0.0, 0.0, shear.sqrt()],
            ],
            yielding: [middle + radius, middle - radius, p66 * shear],
        }
    }

    /// The same for axes that lie at an angle \[rad\] from the first axis of a point, positive towards the second.
    pub fn turned(&self, angle: f64) -> Self {
        let (s, c) = libm::sincos(angle);
        let [along, across, mixed] = self.basis;
        let row = |factors: [f64; 3]| {
            std::array::from_fn(|i| factors[0] * along[i] + factors[1] * across[i] + factors[2] * mixed[i])
        };
        let basis = [
            row([c * c, s * s, -2.0 * s * c]),
            row([s * s, c * c, 2.0 * s * c]),
            row([s * c, -s * c, c * c - s * s]),
        ];
        Self { basis, ..*self }
    }
}
