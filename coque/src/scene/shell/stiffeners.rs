//! Stiffeners of a shell: bars along lines of its particles.

use schemars::JsonSchema;
use serde::Deserialize;

use super::material::Material;
use crate::scene::bounded::{NotNegative, Positive, StiffenerShare};

/// A bar along a line of particles, such as a stringer, a frame or a ring; it goes with their places and directors.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StiffenerScene {
    /// Particle set, a line: neighbours are those that share an edge of a cell.
    pub on: String,
    /// What it is made of; left out, the elastic material of the shell.
    pub material: Option<StiffenerMaterial>,
    /// Its cross-section.
    pub section: StiffenerSection,
    /// Side of a homogeneous shell of one thickness on whose face a rectangle stands; `top` is where normals point to.
    pub side: Option<StiffenerSide>,
    /// Height of its centroid over the particles, along their normals \[L\], in place of a side; zero lies in their surface.
    pub eccentricity: Option<f64>,
    /// Part of it that is modelled: 0.5 on a plane of symmetry that halves it.
    #[serde(default)]
    pub share: StiffenerShare,
    /// Bends in the surface too; left out, the surface bears that alone.
    pub in_surface: Option<StiffenerInSurface>,
}

/// Bending of a stiffener in the surface, about the normal.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StiffenerInSurface {
    /// Sets with ends of it at which its direction stays as at rest: of a stiffener that is built in there, or crosses a plane of symmetry.
    #[serde(default)]
    pub held: Vec<String>,
}

/// Materials of stiffeners.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum StiffenerMaterial {
    /// Isotropic linear elasticity.
    Elastic(StiffenerElastic),
}

/// Isotropic linear elasticity of a stiffener.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StiffenerElastic {
    /// Young's modulus \[F/L²\].
    pub young: Positive,
    /// Poisson's ratio \[–\].
    pub poisson: f64,
    /// Mass per volume \[F T²/L⁴\].
    pub density: Positive,
}

/// Cross-section of a stiffener.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum StiffenerSection {
    /// A rectangle.
    Rectangle(StiffenerRectangle),
    /// Any, by its numbers.
    Profile(StiffenerProfile),
}

/// A rectangle: shear with the factor 5/6, torsion of St Venant.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StiffenerRectangle {
    /// Along the surface, across the stiffener \[L\].
    pub width: Positive,
    /// Across the surface \[L\].
    pub height: Positive,
}

/// Numbers of a cross-section, about its centroid.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StiffenerProfile {
    /// Area \[L²\].
    pub area: Positive,
    /// Second moment of area about the axis across the stiffener in the surface: of bending with the surface \[L⁴\].
    pub inertia: Positive,
    /// Torsion constant J, moment over shear modulus and twist by length \[L⁴\].
    pub torsion: Positive,
    /// Second moment of area about the normal of the surface \[L⁴\]; counts in rotary inertia, in what twist lengthens, and where it bends in the surface.
    #[serde(default)]
    pub lateral: NotNegative,
    /// Area of transverse shear \[L²\]; left out, five sixths of the area.
    pub shear_area: Option<Positive>,
}

/// Sides of a shell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StiffenerSide {
    /// To which normals point.
    Top,
    /// The other.
    Bottom,
}

impl Default for StiffenerShare {
    fn default() -> Self {
        Self::usual(1.0)
    }
}

impl StiffenerScene {
    /// Its material: its own, or that of an elastic shell.
    pub(crate) fn elastic(&self, shell: &Material) -> Option<StiffenerElastic> {
        match (self.material, shell) {
            (Some(StiffenerMaterial::Elastic(own)), _) => Some(own),
            (None, Material::Elastic(shell)) => {
                let (young, poisson, density) = (shell.young, shell.poisson, shell.density);
                Some(StiffenerElastic { young, poisson, density })
            }
            (None, _) => None,
        }
    }
}
