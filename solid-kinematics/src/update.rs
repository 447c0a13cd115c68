//! Stress at the end of a step from the state at its start and the deformation gradient at its end.

use crate::Tensor;
use crate::elastic::Moduli;
use crate::error::PointError;
use crate::plastic::{Flow, Plastic};
use crate::strain_rotation::{
    StrainRotation, cayley, decompose, half_turn, orthonormal, parts, spin_product,
};
use crate::voigt::{strains, stress_tensor};

/// Where in a step strain and rotation of an increment are taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case"),
    schemars(rename = "GalerkinUpdate")
)]
pub enum Update {
    /// In its middle: second order in the step.
    #[default]
    Midpoint,
    /// At its start, the decomposition to the letter: first order.
    StepStart,
}

/// What the moduli multiply.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StressMeasure {
    /// Kirchhoff's stress follows the strain: `τ^∇J = C:D`.
    #[default]
    Kirchhoff,
    /// The change of volume counts: `τ^∇J = J C:D`, the source to the letter.
    Literal,
}

/// How stress follows deformation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formulation {
    /// Increments of strain and rotation; stress has a history.
    StrainRotation {
        /// Where increments are taken.
        update: Update,
        /// What the moduli multiply.
        measure: StressMeasure,
    },
    /// `S = C:E` of Green's strain from the reference, without history.
    StVenant,
}

/// The state of a point that a step starts from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointState {
    /// Deformation gradient F.
    pub gradient: Tensor,
    /// Material axes as columns, turned with the point; of St Venant's solid those at rest.
    pub axes: Tensor,
    /// Co-rotated Kirchhoff stress in material axes; of St Venant's solid the second Piola stress \[F/L²\].
    pub stress: [f64; 6],
    /// What flow has left.
    pub flow: Flow,
}

impl PointState {
    /// A point at rest with these material axes.
    pub fn rest(axes: Tensor) -> Self {
        Self { gradient: Tensor::identity(), axes, stress: [0.0; 6], flow: Flow::default() }
    }
}

/// A point at the end of a step that is tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    /// Its state there.
    pub state: PointState,
    /// Kirchhoff stress τ in space \[F/L²\].
    pub kirchhoff: Tensor,
    /// First Piola stress `P = τ F⁻ᵀ` \[F/L²\].
    pub piola: Tensor,
    /// F⁻¹.
    pub inverse: Tensor,
    /// |w| of the increment: of the middle of the step 2 tan(θ/2), of its start sin θ.
    pub turn: f64,
}

/// A material with its way to follow deformation.
#[derive(Clone, Debug)]
pub struct Material {
    /// Elastic moduli in material axes.
    pub moduli: Moduli,
    /// How stress follows.
    pub formulation: Formulation,
    /// How it yields, made of the same moduli; none of an elastic one.
    pub plastic: Option<Plastic>,
}

impl Material {
    /// Stress at a deformation gradient, from the state at the start of the step.
    ///
    /// # Errors
    /// [`PointError`].
    pub fn trial(&self, from: &PointState, gradient: &Tensor) -> Result<Trial, PointError> {
        let inverse = inverse(gradient)?;
        let Formulation::StrainRotation { update, measure } = self.formulation else {
            let stress = self.moduli.stress(&green(gradient, &from.axes));
            let piola = gradient * (from.axes * stress_tensor(&stress) * from.axes.transpose());
            let kirchhoff = piola * gradient.transpose();
            let state = PointState { gradient: *gradient, axes: from.axes, stress, flow: from.flow };
            return Ok(Trial { state, kirchhoff, piola, inverse, turn: 0.0 });
        };
        let Increment { strain, rotation, frame, spin } = Increment::between(update, from, gradient)?;
        let local = frame.transpose() * strain * frame;
        let mut change = self.moduli.stress(&strains(&local));
        if measure == StressMeasure::Literal {
            let mean = 0.5 * (gradient.determinant() + from.gradient.determinant());
            change.iter_mut().for_each(|s| *s *= mean);
        }
        let stress = std::array::from_fn(|i| from.stress[i] + change[i]);
        let (stress, flow) = match &self.plastic {
            None => (stress, from.flow),
            Some(plastic) => plastic.returned(&stress, &from.flow),
        };
        // Without a step the bits stay; else axes are left orthonormal to rounding.
        let axes = if spin == Tensor::zeros() { from.axes } else { orthonormal(&(rotation * from.axes)) };
        let kirchhoff = axes * stress_tensor(&stress) * axes.transpose();
        let piola = kirchhoff * inverse.transpose();
        let turn = spin_product(&spin, &spin).sqrt();
        let state = PointState { gradient: *gradient, axes, stress, flow };
        Ok(Trial { state, kirchhoff, piola, inverse, turn })
    }

    /// Energy per volume of rest that the present stress would release on a straight way to zero \[F/L²\]: St Venant's is stored,
    /// that of increments hypoelastic. Of a material that flows what hardening has stored and what is dissipated come to it, so that it is the
    /// work of the way.
    pub fn energy(&self, state: &PointState) -> f64 {
        match self.formulation {
            Formulation::StVenant => self.moduli.energy(&green(&state.gradient, &state.axes)),
            Formulation::StrainRotation { .. } => {
                let elastic = self.moduli.complementary(&state.stress);
                let flowed =
                    |plastic: &Plastic| plastic.hardened(&state.flow) + plastic.dissipated(&state.flow);
                self.plastic.as_ref().map_or(elastic, |plastic| elastic + flowed(plastic))
            }
        }
    }
}

/// Green's strain in material axes.
pub(crate) fn green(gradient: &Tensor, axes: &Tensor) -> [f64; 6] {
    let local = gradient * axes;
    strains(&((local.transpose() * local - axes.transpose() * axes) * 0.5))
}

/// Strain and rotation of an increment, and the axes in which the strain meets the moduli.
pub(crate) struct Increment {
    /// S.
    pub strain: Tensor,
    /// R of the whole step.
    pub rotation: Tensor,
    /// Material axes where the strain is taken, as columns.
    pub frame: Tensor,
    /// w.
    pub spin: Tensor,
}

impl Increment {
    fn between(update: Update, from: &PointState, gradient: &Tensor) -> Result<Self, PointError> {
        let change = gradient - from.gradient;
        match update {
            Update::Midpoint => {
                let slope = change * inverse(&((gradient + from.gradient) * 0.5))?;
                let (strain, spin) = parts(&slope);
                let frame = cayley(&(spin * half_turn(&spin))) * from.axes;
                Ok(Self { strain, rotation: cayley(&spin), frame, spin })
            }
            Update::StepStart => {
                let slope = change * inverse(&from.gradient)?;
                let StrainRotation { strain, rotation } = decompose(&slope)?;
                Ok(Self { strain, rotation, frame: from.axes, spin: parts(&slope).1 })
            }
        }
    }
}

/// The inverse of a deformation gradient that keeps its sides.
pub(crate) fn inverse(gradient: &Tensor) -> Result<Tensor, PointError> {
    let determinant = gradient.determinant();
    match gradient.try_inverse().filter(|_| determinant > 0.0) {
        Some(inverse) => Ok(inverse),
        None => Err(PointError::Inverted { determinant }),
    }
}
