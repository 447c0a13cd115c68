//! Sections: from strains to stress resultants and energy; the isotropic plane-stress one in closed form.

use std::any::Any;

use crate::expansion::Expansion;
use crate::memory::Memory;
use crate::pack::{Number, Pack};
use crate::strains::{Resultants, Strains};
use crate::tangent::{Matrix8, ZERO8};

/// Stiffness scales by which zero-energy control and estimates are sized.
#[derive(Clone, Copy, Debug)]
pub struct SectionScales {
    /// Thickness t \[L\].
    pub thickness: f64,
    /// Bending stiffness \[F L\], isotropic `D_b = Et³/12(1−ν²)`.
    pub bending: f64,
    /// Transverse shear stiffness \[F/L\], isotropic `(5/6) G t`.
    pub shear: f64,
    /// Greatest membrane stiffness of any direction \[F/L\], isotropic `Et/(1−ν²)`; the fastest wave has
    /// `c² = membrane/(ρt)`.
    pub membrane: f64,
}

/// What the shell is made of, per area of its mid-surface.
pub trait Section: Any + Send + Sync {
    /// Resultants from strains; they must be the derivative of [`Section::energy`].
    fn resultants(&self, strains: &Strains) -> Resultants;

    /// `C = ∂σ/∂ε`, symmetric.
    fn tangent(&self, strains: &Strains) -> Matrix8;

    /// Stored energy per reference area \[F/L\].
    fn energy(&self, strains: &Strains) -> Pack;

    /// Stiffness scales.
    fn scales(&self) -> SectionScales;

    /// Whether stresses run linearly through the thickness, so that those at the faces follow from the resultants.
    fn homogeneous(&self) -> bool {
        false
    }

    /// Whether resultants are linear in the strains, without coupling of shear to the rest: a few numbers then stand for the section of a point.
    fn linear(&self) -> bool {
        false
    }

    /// What it does as it is heated; none where its material does not say.
    fn expansion(&self) -> Option<Expansion> {
        None
    }

    /// Its memory; none of a section that answers to strains alone. Of one with memory the formulas above are those of a point that nothing has
    /// strained before, and its [`crate::HistoryPack`] has those of any other.
    fn memory(&self) -> Option<&dyn Memory> {
        None
    }
}

/// The formulas of a [`Section`] for numbers of one kind.
///
/// Any section has them for packs; one whose resultants are written for any [`Number`] runs in whatever registers a
/// caller brings.
pub trait SectionOf<P> {
    /// [`Section::resultants`].
    fn resultants_of(&self, strains: &Strains<P>) -> Resultants<P>;

    /// [`Section::energy`] \[F/L\].
    fn energy_of(&self, strains: &Strains<P>) -> P;
}

impl SectionOf<Pack> for dyn Section {
    #[inline(always)]
    fn resultants_of(&self, strains: &Strains) -> Resultants {
        self.resultants(strains)
    }

    #[inline(always)]
    fn energy_of(&self, strains: &Strains) -> Pack {
        self.energy(strains)
    }
}

/// The tangent of a section whose resultants are linear in the strains: its columns are its answers to unit strains.
///
/// What [`Section::tangent`] of such a section returns, one of another crate included.
pub fn linear_tangent(section: &impl Section) -> Matrix8 {
    let mut out = ZERO8;
    for column in 0..8 {
        let unit: [Pack; 8] = std::array::from_fn(|i| Pack::splat(if i == column { 1.0 } else { 0.0 }));
        let strains = Strains {
            membrane: [unit[0], unit[1], unit[2]],
            curvature: [unit[3], unit[4], unit[5]],
            shear: [unit[6], unit[7]],
        };
        let Resultants { membrane, moment, shear } = section.resultants(&strains);
        for (row, value) in membrane.into_iter().chain(moment).chain(shear).enumerate() {
            out[row][column] = value;
        }
    }
    out
}

/// Why a material was refused.
#[derive(Clone, Debug, PartialEq)]
pub enum MaterialError {
    /// Young's modulus must be positive and finite.
    Young(f64),
    /// Poisson's ratio must lie strictly between −1 and ½.
    Poisson(f64),
    /// Thickness must be positive and finite.
    Thickness(f64),
    /// Gauss points through the thickness must number 2 to 5.
    GaussPoints(usize),
    /// A modulus of an orthotropic material must be positive and finite.
    Modulus {
        /// Which one.
        what: &'static str,
        /// Value found \[F/L²\].
        value: f64,
    },
    /// The major Poisson's ratio of an orthotropic material must be smaller in size than √(E_L/E_T).
    MajorPoisson {
        /// Value found.
        value: f64,
        /// √(E_L/E_T).
        bound: f64,
    },
    /// A layered section needs a ply.
    NoPlies,
    /// The angle of a ply must be finite.
    Angle(f64),
    /// A matrix of a given stiffness is none of an elastic section.
    Stiffness {
        /// Which one.
        what: &'static str,
        /// What it must be.
        bound: &'static str,
    },
    /// A constant of a law lies outside its bound.
    Constant {
        /// Which one.
        what: &'static str,
        /// Value found, in the units of the constant.
        value: f64,
        /// What it must be.
        bound: &'static str,
    },
    /// A row of a hardening table lies outside its bound.
    Row {
        /// Which row, from one.
        row: usize,
        /// Which column.
        what: &'static str,
        /// Value found.
        value: f64,
        /// What it must be.
        bound: &'static str,
    },
}

impl std::fmt::Display for MaterialError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Young(v) => write!(f, "Young's modulus is {v}; it must be positive and finite"),
            Self::Poisson(v) => write!(f, "Poisson's ratio is {v}; it must lie strictly between -1 and 0.5"),
            Self::Thickness(v) => write!(f, "thickness is {v}; it must be positive and finite"),
            Self::GaussPoints(n) => {
                write!(f, "{n} Gauss points through the thickness; use 2 to 5 (one point carries no bending)")
            }
            Self::Modulus { what, value } => write!(f, "{what} is {value}; it must be positive and finite"),
            Self::MajorPoisson { value, bound } => write!(
                f,
                "the major Poisson's ratio is {value}; it must be smaller in size than √(E_along/E_across) = {bound}"
            ),
            Self::NoPlies => write!(f, "there is no ply; give at least one"),
            Self::Angle(v) => write!(f, "the angle of a ply is {v}; it must be finite"),
            Self::Stiffness { what, bound } => write!(f, "the matrix `{what}` must be {bound}"),
            Self::Constant { what, value, bound } => write!(f, "{what} is {value}; it must be {bound}"),
            Self::Row { row, what, value, bound } => {
                write!(f, "{what} of row {row} of the hardening table is {value}; it must be {bound}")
            }
        }
    }
}

impl std::error::Error for MaterialError {}

/// Isotropic linear elasticity.
#[derive(Clone, Copy, Debug)]
pub struct Isotropic {
    /// Young's modulus E \[F/L²\].
    pub young: f64,
    /// Poisson's ratio ν \[–\].
    pub poisson: f64,
    /// Coefficient of thermal expansion α \[1/Θ\], where it is known.
    pub expansion: Option<f64>,
    /// Yield strength that reserve factors refer to \[F/L²\], where it is known.
    pub strength: Option<f64>,
}

impl Isotropic {
    /// Checks the bounds.
    ///
    /// # Errors
    /// [`MaterialError`] for E ≤ 0, ν outside (−1, ½) or a value that is not finite.
    pub fn new(young: f64, poisson: f64) -> Result<Self, MaterialError> {
        if !(young > 0.0 && young.is_finite()) {
            return Err(MaterialError::Young(young));
        }
        if !(poisson > -1.0 && poisson < 0.5) {
            return Err(MaterialError::Poisson(poisson));
        }
        Ok(Self { young, poisson, expansion: None, strength: None })
    }

    /// The same with a coefficient of thermal expansion \[1/Θ\], Θ a temperature.
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless it is finite.
    pub fn expanding(self, expansion: f64) -> Result<Self, MaterialError> {
        Ok(Self { expansion: Some(finite_expansion(expansion)?), ..self })
    }

    /// The same with a yield strength \[F/L²\], to which reserve factors by von Mises refer; nothing yields.
    pub fn strong(self, strength: f64) -> Self {
        Self { strength: Some(strength), ..self }
    }

    /// Plane-stress modulus `E/(1−ν²)` \[F/L²\].
    pub fn plane_stress(&self) -> f64 {
        self.young / (1.0 - self.poisson * self.poisson)
    }

    /// Shear modulus `E/2(1+ν)` \[F/L²\].
    pub fn shear(&self) -> f64 {
        self.young / (2.0 * (1.0 + self.poisson))
    }
}

/// A coefficient of thermal expansion, if it is a number.
pub(crate) fn finite_expansion(value: f64) -> Result<f64, MaterialError> {
    let (what, bound) = ("the coefficient of thermal expansion", "finite");
    if value.is_finite() { Ok(value) } else { Err(MaterialError::Constant { what, value, bound }) }
}

/// Reissner's factor for the parabolic transverse shear stress of a homogeneous section \[–\].
pub const SHEAR_CORRECTION: f64 = 5.0 / 6.0;

/// Homogeneous isotropic section in plane stress, integrated through the thickness in closed form.
#[derive(Clone, Copy, Debug)]
pub struct IsotropicSection {
    membrane: f64,
    bending: f64,
    shear: f64,
    poisson: f64,
    thickness: f64,
    expansion: Option<f64>,
    strength: Option<f64>,
}

impl IsotropicSection {
    /// `N = tC e`, `M = t³/12 C κ`, `Q = (5/6) G t γ`, with `C = E/(1−ν²) [[1,ν,0],[ν,1,0],[0,0,(1−ν)/2]]`.
    ///
    /// # Errors
    /// [`MaterialError::Thickness`] unless the thickness is positive and finite.
    pub fn new(material: Isotropic, thickness: f64) -> Result<Self, MaterialError> {
        if !(thickness > 0.0 && thickness.is_finite()) {
            return Err(MaterialError::Thickness(thickness));
        }
        let membrane = material.plane_stress() * thickness;
        Ok(Self {
            membrane,
            bending: membrane * thickness * thickness / 12.0,
            shear: SHEAR_CORRECTION * material.shear() * thickness,
            poisson: material.poisson,
            thickness,
            expansion: material.expansion,
            strength: material.strength,
        })
    }

    /// What it is made of.
    pub(crate) fn material(&self) -> Isotropic {
        let young = self.membrane / self.thickness * (1.0 - self.poisson * self.poisson);
        Isotropic { young, poisson: self.poisson, expansion: self.expansion, strength: self.strength }
    }
}

/// `C s` of plane stress for a stiffness `c` that already holds `1/(1−ν²)`.
#[inline(always)]
pub(crate) fn plane_stress<P: Number>(c: f64, nu: f64, s: &[P; 3]) -> [P; 3] {
    [(s[0] + s[1] * nu) * c, (s[1] + s[0] * nu) * c, s[2] * (0.5 * (1.0 - nu) * c)]
}

impl<P: Number> SectionOf<P> for IsotropicSection {
    #[inline(always)]
    fn resultants_of(&self, strains: &Strains<P>) -> Resultants<P> {
        Resultants {
            membrane: plane_stress(self.membrane, self.poisson, &strains.membrane),
            moment: plane_stress(self.bending, self.poisson, &strains.curvature),
            shear: [strains.shear[0] * self.shear, strains.shear[1] * self.shear],
        }
    }

    #[inline(always)]
    fn energy_of(&self, strains: &Strains<P>) -> P {
        self.resultants_of(strains).work(strains) * 0.5
    }
}

impl Section for IsotropicSection {
    fn homogeneous(&self) -> bool {
        true
    }

    fn linear(&self) -> bool {
        true
    }

    fn resultants(&self, strains: &Strains) -> Resultants {
        self.resultants_of(strains)
    }

    fn tangent(&self, _: &Strains) -> Matrix8 {
        linear_tangent(self)
    }

    fn expansion(&self) -> Option<Expansion> {
        let stiffness = self.membrane / self.thickness;
        self.expansion.map(|own| Expansion::isotropic(stiffness * (1.0 + self.poisson), own, self.thickness))
    }

    fn energy(&self, strains: &Strains) -> Pack {
        self.energy_of(strains)
    }

    fn scales(&self) -> SectionScales {
        SectionScales {
            thickness: self.thickness,
            bending: self.bending,
            shear: self.shear,
            membrane: self.membrane,
        }
    }
}
