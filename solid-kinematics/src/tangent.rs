//! Derivatives of the first Piola stress by the deformation gradient.

use crate::Tensor;
use crate::error::PointError;
use crate::plastic::Softening;
use crate::strain_rotation::{cayley, cosine, decompose, half_turn, parts, spin_product};
use crate::update::{Formulation, Material, PointState, StressMeasure, Trial, Update, inverse};
use crate::voigt::{PLACES, strains, stress_tensor};

/// `∂P_iJ/∂F_kL` at row `3i + J`, column `3k + L` \[F/L²\].
pub type PointTangent = [[f64; 9]; 9];

/// Which derivative of the stress is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case"),
    schemars(rename = "GalerkinTangent")
)]
pub enum Tangent {
    /// That of the rate equation at the present state, symmetric, exact where a step begins.
    #[default]
    Continuum,
    /// That of the update over the step; not symmetric within it.
    Consistent,
}

impl Material {
    /// Derivative of the stress of a trial that started from a state.
    ///
    /// # Errors
    /// [`PointError`], where [`Material::trial`] fails.
    pub fn tangent(
        &self,
        kind: Tangent,
        from: &PointState,
        trial: &Trial,
    ) -> Result<PointTangent, PointError> {
        match (self.formulation, kind) {
            (Formulation::StVenant, _) => Ok(self.st_venant(trial)),
            (Formulation::StrainRotation { measure, .. }, Tangent::Continuum) => {
                Ok(self.continuum(measure, from, trial))
            }
            (Formulation::StrainRotation { update, measure }, Tangent::Consistent) => {
                self.consistent(update, measure, from, trial)
            }
        }
    }

    /// `A_iJkL = F⁻¹_Jj F⁻¹_Ll A_ijkl`, `A_ijkl = C_ijkl + δ_ik τ_jl − ½(δ_ik τ_jl + δ_il τ_jk + δ_jk τ_il + δ_jl τ_ik)`
    /// \[mcmeeking1975\], C less what flow takes of it over the step.
    fn continuum(&self, measure: StressMeasure, from: &PointState, trial: &Trial) -> PointTangent {
        let mut turned = self.moduli.turned(&trial.state.axes);
        if let Some(softening) = self.softening(from, trial) {
            let softening = softening.turned(&trial.state.axes);
            for column in 0..6 {
                let mut strain = [0.0; 6];
                strain[column] = 1.0;
                let taken = softening.stress(&strain);
                (0..6).for_each(|row| turned[row][column] -= taken[row]);
            }
        }
        let volume = match measure {
            StressMeasure::Kirchhoff => 1.0,
            StressMeasure::Literal => trial.state.gradient.determinant(),
        };
        let t = &trial.kirchhoff;
        let mut space = [[0.0; 9]; 9];
        for i in 0..3 {
            for j in 0..3 {
                let row = &mut space[3 * i + j];
                for k in 0..3 {
                    for l in 0..3 {
                        row[3 * k + l] = volume * turned[PLACES[i][j]][PLACES[k][l]];
                    }
                }
                for m in 0..3 {
                    let half = 0.5 * t[(j, m)];
                    row[3 * i + m] += half; // δ_ik τ_jl, less its half
                    row[3 * m + i] -= half; // δ_il τ_jk
                    let half = 0.5 * t[(i, m)];
                    row[3 * j + m] -= half; // δ_jk τ_il
                    row[3 * m + j] -= half; // δ_jl τ_ik
                }
            }
        }
        pull_back(&space, &trial.inverse)
    }

    /// What flow takes from the moduli over the step of a trial.
    fn softening(&self, from: &PointState, trial: &Trial) -> Option<Softening> {
        let state = &trial.state;
        self.plastic.as_ref().and_then(|plastic| plastic.softening(&from.flow, (&state.stress, &state.flow)))
    }

    /// `A_iJkL = δ_ik S_JL + F_iM C_MJNL F_kN`.
    fn st_venant(&self, trial: &Trial) -> PointTangent {
        let state = &trial.state;
        let moduli = self.moduli.turned(&state.axes);
        let stress = state.axes * stress_tensor(&state.stress) * state.axes.transpose();
        let f = &state.gradient;
        let mut left = [[0.0; 6]; 9];
        for i in 0..3 {
            for j in 0..3 {
                for b in 0..6 {
                    left[3 * i + j][b] = (0..3).map(|m| f[(i, m)] * moduli[PLACES[m][j]][b]).sum();
                }
            }
        }
        let mut out = [[0.0; 9]; 9];
        for row in 0..9 {
            for k in 0..3 {
                for l in 0..3 {
                    out[row][3 * k + l] = (0..3).map(|n| left[row][PLACES[n][l]] * f[(k, n)]).sum();
                }
            }
            let (i, j) = (row / 3, row % 3);
            (0..3).for_each(|l| out[row][3 * i + l] += stress[(j, l)]);
        }
        out
    }

    /// Nine directional derivatives of the update.
    fn consistent(
        &self,
        update: Update,
        measure: StressMeasure,
        from: &PointState,
        trial: &Trial,
    ) -> Result<PointTangent, PointError> {
        let base = Linearised::at(update, from, trial)?;
        let softening = self.softening(from, trial);
        let volumes = match measure {
            StressMeasure::Kirchhoff => None,
            StressMeasure::Literal => Some((from.gradient.determinant(), trial.state.gradient.determinant())),
        };
        let mut out = [[0.0; 9]; 9];
        for column in 0..9 {
            let mut way = Tensor::zeros();
            way[(column / 3, column % 3)] = 1.0;
            let (strain, turn) = base.along(&way);
            // ε = AᵀSA of the axes A where the strain is taken
            let (a, da) = (base.frame, turn.frame);
            let cross = a.transpose() * base.strain * da;
            let local = a.transpose() * strain * a + cross + cross.transpose();
            let local = strains(&local);
            let mut ds = self.moduli.stress(&local);
            if let Some(softening) = &softening {
                let taken = softening.stress(&local);
                ds = std::array::from_fn(|i| ds[i] - taken[i]);
            }
            if let Some((before, now)) = volumes {
                let mean = 0.5 * (before + now);
                let rate = 0.5 * now * (trial.inverse * way).trace();
                let whole = self.moduli.stress(&strains(&(a.transpose() * base.strain * a)));
                ds = std::array::from_fn(|i| mean * ds[i] + rate * whole[i]);
            }
            let q = trial.state.axes;
            let dq = turn.rotation * from.axes;
            let side = dq * stress_tensor(&trial.state.stress) * q.transpose();
            let kirchhoff = q * stress_tensor(&ds) * q.transpose() + side + side.transpose();
            let piola = (kirchhoff - trial.piola * way.transpose()) * trial.inverse.transpose();
            for row in 0..9 {
                out[row][column] = piola[(row / 3, row % 3)];
            }
        }
        Ok(out)
    }
}

/// The strain and rotation of an increment with what their derivatives need.
struct Linearised {
    update: Update,
    strain: Tensor,
    frame: Tensor,
    axes: Tensor,
    slope: Tensor,
    spin: Tensor,
    /// Inverse of the gradient at which the increment is taken.
    base: Tensor,
}

/// Derivatives of what turns.
struct Turning {
    rotation: Tensor,
    frame: Tensor,
}

impl Linearised {
    fn at(update: Update, from: &PointState, trial: &Trial) -> Result<Self, PointError> {
        let end = &trial.state.gradient;
        let change = end - from.gradient;
        let base = match update {
            Update::Midpoint => inverse(&((end + from.gradient) * 0.5))?,
            Update::StepStart => inverse(&from.gradient)?,
        };
        let slope = change * base;
        let (symmetric, spin) = parts(&slope);
        let (strain, frame) = match update {
            Update::Midpoint => (symmetric, cayley(&(spin * half_turn(&spin))) * from.axes),
            Update::StepStart => (decompose(&slope)?.strain, from.axes),
        };
        Ok(Self { update, strain, frame, axes: from.axes, slope, spin, base })
    }

    /// Derivatives of strain, rotation and frame along a change of the deformation gradient.
    fn along(&self, way: &Tensor) -> (Tensor, Turning) {
        match self.update {
            Update::Midpoint => {
                let (strain, spin) = parts(&((way - self.slope * way * 0.5) * self.base));
                let rotation = cayley_rate(&self.spin, &spin);
                // v = c w, c = 1/(1 + q), q = √(1 + |w|²/4)
                let c = half_turn(&self.spin);
                let q = 1.0 / c - 1.0;
                let rate = -c * c * spin_product(&self.spin, &spin) / (4.0 * q);
                let half = cayley_rate(&(self.spin * c), &(spin * c + self.spin * rate));
                (strain, Turning { rotation, frame: half * self.axes })
            }
            Update::StepStart => {
                let (symmetric, spin) = parts(&(way * self.base));
                let cos = cosine(&self.spin).unwrap_or(0.0).max(f64::EPSILON);
                let share = 1.0 / (1.0 + cos);
                let rate = share * share * spin_product(&self.spin, &spin) / cos;
                let mixed = self.spin * spin + spin * self.spin;
                let square = mixed * share + self.spin * self.spin * rate;
                (symmetric - square, Turning { rotation: spin + square, frame: Tensor::zeros() })
            }
        }
    }
}

/// Derivative of [`cayley`]: `(I − w/2)⁻¹ ½ẇ (I + R)`, `(I − w/2)⁻¹ = ½(I + R)`.
fn cayley_rate(w: &Tensor, rate: &Tensor) -> Tensor {
    let sum = Tensor::identity() + cayley(w);
    sum * rate * sum * 0.25
}

/// `A_iJkL = F⁻¹_Jj F⁻¹_Ll A_ijkl`.
fn pull_back(space: &PointTangent, inverse: &Tensor) -> PointTangent {
    let inverse: [[f64; 3]; 3] = [0, 1, 2].map(|j| [inverse[(j, 0)], inverse[(j, 1)], inverse[(j, 2)]]);
    let mut out = [[0.0; 9]; 9];
    for i in 0..3 {
        let [p, q, r] = [&space[3 * i], &space[3 * i + 1], &space[3 * i + 2]];
        for (j, [a, b, c]) in inverse.into_iter().enumerate() {
            let mut half = [0.0; 9];
            for column in 0..9 {
                half[column] = a * p[column] + b * q[column] + c * r[column];
            }
            let row = &mut out[3 * i + j];
            for k in 0..3 {
                for (l, [d, e, f]) in inverse.into_iter().enumerate() {
                    row[3 * k + l] = d * half[3 * k] + e * half[3 * k + 1] + f * half[3 * k + 2];
                }
            }
        }
    }
    out
}
