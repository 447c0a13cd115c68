//! What the plies of a section that yields are made of.

use super::hardening::{Hardening, not_negative};
use super::hill::RValues;
use super::layer::Layer;
use super::modes::Modes;
use super::point::OF_SLICE;
use super::point::{BackStress, MOST_BACK_STRESSES};
use super::rate::Rate;
use super::return_map::PointLaw;
use super::slices::slices;
use crate::layered_section::{Orthotropic, Ply};
use crate::section::{Isotropic, MaterialError};

/// Points through a ply that does not yield: its stresses run linearly, so that two are exact.
const OF_ELASTIC: usize = 2;

/// Isotropic elasticity with von Mises' yield criterion or Hill's, and associated flow.
#[derive(Clone, Debug)]
pub struct Plastic {
    elastic: Isotropic,
    hardening: Hardening,
    kinematic: f64,
    rate: Option<Rate>,
    backs: Vec<BackStress>,
    modes: Modes,
}

impl Plastic {
    /// Von Mises' criterion with isotropic hardening alone.
    pub fn new(elastic: Isotropic, hardening: Hardening) -> Self {
        let modes = Modes::von_mises(&elastic);
        Self { elastic, hardening, kinematic: 0.0, rate: None, backs: Vec::new(), modes }
    }

    /// What it is as long as nothing flows.
    pub fn elastic(&self) -> &Isotropic {
        &self.elastic
    }

    /// The same with linear kinematic hardening beside it: in uniaxial tension the back stress grows by H_k \[F/L²\] a plastic strain.
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless H_k is zero or positive, and finite.
    pub fn kinematic(self, modulus: f64) -> Result<Self, MaterialError> {
        Ok(Self { kinematic: not_negative("the modulus of kinematic hardening", modulus)?, ..self })
    }

    /// The same with back stresses that recover, beside that of linear kinematic hardening.
    ///
    /// # Errors
    /// [`MaterialError::Constant`] for more than three.
    pub fn recovering(self, backs: Vec<BackStress>) -> Result<Self, MaterialError> {
        if backs.len() > MOST_BACK_STRESSES {
            let (what, value) = ("the number of back stresses", backs.len() as f64);
            return Err(MaterialError::Constant { what, value, bound: "three at most" });
        }
        Ok(Self { backs, ..self })
    }

    /// The same with a yield stress that grows with the rate of plastic strain, in steps that take time.
    pub fn rated(self, rate: Rate) -> Self {
        Self { rate: Some(rate), ..self }
    }

    /// The same with Hill's criterion in place of von Mises', in the axes of its ply.
    pub fn anisotropic(self, r: RValues) -> Self {
        Self { modes: Modes::hill(&self.elastic, &r), ..self }
    }
}

/// What a ply of a [`super::PlasticSection`] is made of.
#[derive(Clone, Debug)]
pub enum PlyMaterial {
    /// One that yields, at so many points through the ply, at least 2.
    Plastic(Plastic, usize),
    /// One that does not, the same in all directions.
    Elastic(Isotropic),
    /// One that does not, with a fibre. Its stresses do not change the thickness.
    Orthotropic(Orthotropic),
}

/// One ply of a [`super::PlasticSection`].
#[derive(Clone, Debug)]
pub struct PlasticPly {
    /// What it is made of.
    pub material: PlyMaterial,
    /// Thickness \[L\].
    pub thickness: f64,
    /// Angle of its first axis from the first axis of the point's frame, positive towards the second \[rad\].
    pub angle: f64,
}

impl PlasticPly {
    /// It as long as nothing flows.
    pub fn elastic(&self) -> Ply {
        let material = match &self.material {
            PlyMaterial::Plastic(material, _) => Orthotropic::isotropic(&material.elastic),
            PlyMaterial::Elastic(material) => Orthotropic::isotropic(material),
            PlyMaterial::Orthotropic(material) => *material,
        };
        Ply { material, thickness: self.thickness, angle: self.angle }
    }

    /// Its points about a height \[L\], whose numbers begin at a place of a history.
    ///
    /// # Errors
    /// [`MaterialError::Constant`] for fewer than 2 slices of a material that yields.
    pub(super) fn layer(&self, middle: f64, first: usize) -> Result<Layer, MaterialError> {
        let of = |law: Option<PointLaw>, modes: Modes, count: usize, thinning| Layer {
            of_slice: law.as_ref().map_or(OF_SLICE, PointLaw::numbers),
            law,
            modes,
            first,
            slices: slices(count, self.thickness, middle).collect(),
            thinning,
        };
        Ok(match &self.material {
            PlyMaterial::Plastic(Plastic { elastic, hardening, kinematic, rate, backs, modes }, count) => {
                if *count < 2 {
                    let (what, value) = ("the number of slices of a ply", *count as f64);
                    return Err(MaterialError::Constant { what, value, bound: "at least 2" });
                }
                let modes = modes.turned(self.angle);
                let law = PointLaw::new(&modes, hardening.clone(), *kinematic);
                let law = law.with(backs.clone(), *rate);
                of(Some(law), modes, *count, thinning(elastic, &modes))
            }
            PlyMaterial::Elastic(elastic) => {
                let modes = Modes::von_mises(elastic);
                of(None, modes, OF_ELASTIC, thinning(elastic, &modes))
            }
            PlyMaterial::Orthotropic(material) => {
                of(None, Modes::of_fibre(material).turned(self.angle), OF_ELASTIC, [[0.0; 3]; 2])
            }
        })
    }
}

/// `∂ ln λ₃/∂x` and `∂ ln λ₃/∂e_p`, of `ln λ₃ = −ν/E (σ11 + σ22) − (εp11 + εp22)`.
fn thinning(elastic: &Isotropic, modes: &Modes) -> [[f64; 3]; 2] {
    let trace = modes.of_strains(&[1.0, 1.0, 0.0]);
    let by = |factor: f64| trace.map(|t| -t * factor / elastic.young);
    [by(elastic.poisson), by(1.0 - elastic.poisson)]
}
