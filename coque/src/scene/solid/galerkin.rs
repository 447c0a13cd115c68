//! How a solid is carried without bonds: an element-free Galerkin method on strain and rotation.

use schemars::JsonSchema;
use serde::Deserialize;
pub use solid_kinematics::{Tangent as GalerkinTangent, Update as GalerkinUpdate};
pub use sr_galerkin::{Essential as GalerkinEssential, Volumes as GalerkinVolumes};

use crate::scene::bounded::GaussPoints;
use crate::scene::per_axis::PerAxis;

/// Options of the element-free Galerkin method.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Galerkin {
    /// Polynomials that the shape functions reproduce.
    #[serde(default)]
    pub basis: GalerkinBasis,
    /// Axis across a thin part, of `plate17`; left out, `z`.
    pub across: Option<Across>,
    /// Where a node has weight; left out, an ellipsoid of 2.5 spacings, of `plate17` a box of 3.5 along the plate and 2.5 across, widened
    /// where nodes do not determine the basis.
    pub support: Option<GalerkinSupport>,
    /// Weight of a node by its distance: `csrbf2`, or a kernel of shells.
    #[serde(default = "csrbf2")]
    pub kernel: String,
    /// How stress follows deformation.
    #[serde(default)]
    pub law: GalerkinLaw,
    /// Where in a step strain and rotation of an increment are taken; left out, `midpoint`.
    pub update: Option<GalerkinUpdate>,
    /// Derivative that Newton's method iterates with; a step that `continuum` does not find is made again with the other.
    #[serde(default)]
    pub tangent: GalerkinTangent,
    /// Gauss points along an edge of a cell, 1 to 4.
    #[serde(default = "three")]
    pub gauss: GaussPoints,
    /// How supports are imposed.
    #[serde(default)]
    pub essential: GalerkinEssential,
    /// Where the change of volume is taken; left out, `shared`, of a material that yields `mean`.
    pub volumes: Option<GalerkinVolumes>,
}

/// Polynomials that shape functions reproduce.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum GalerkinBasis {
    /// `1, x, y, z`: locks in bending of thin parts.
    Linear,
    /// All ten up to degree two, for solids.
    #[default]
    Quadratic,
    /// The quadratic basis and seven cubic terms, for thin plates.
    Plate17,
}

/// An axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Across {
    /// The first axis.
    X,
    /// The second.
    Y,
    /// The third.
    #[default]
    Z,
}

/// Where a node has weight, in spacings.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum GalerkinSupport {
    /// A ball; its radius over the greatest spacing \[–\].
    Sphere(f64),
    /// An ellipsoid; its radii over the spacings along the axes \[–\].
    Ellipsoid(PerAxis),
    /// A box with a product of weights; half its edges over the spacings along the axes \[–\].
    Tensor(PerAxis),
}

impl Galerkin {
    /// The least radius of the support of its shape functions, in spacings \[–\].
    pub fn narrowest(&self) -> f64 {
        let radii = self.support.as_ref().map_or_else(|| vec![2.5], |support| support.said().1);
        radii.into_iter().fold(f64::INFINITY, f64::min)
    }
}

impl GalerkinSupport {
    /// Its word, and its radii as they were given.
    pub fn said(&self) -> (&'static str, Vec<f64>) {
        let radii = |radii: &PerAxis| match radii {
            PerAxis::Same(radius) => vec![*radius],
            PerAxis::Each(list) => list.clone(),
        };
        match self {
            Self::Sphere(radius) => ("sphere", vec![*radius]),
            Self::Ellipsoid(given) => ("ellipsoid", radii(given)),
            Self::Tensor(given) => ("tensor", radii(given)),
        }
    }
}

/// How stress follows deformation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum GalerkinLaw {
    /// Increments of strain and rotation lead Kirchhoff's stress.
    #[default]
    StrainRotation,
    /// The same with the change of volume counted, as the source has it to the letter.
    Literal,
    /// St Venant's: Green's strain from rest, without history.
    StVenant,
}

/// Radii that bases ask for, over the spacings.
const ELLIPSOID: f64 = 2.5;
const ALONG_PLATE: f64 = 3.5;
const ACROSS_PLATE: f64 = 2.5;
/// Volume of a ball over that of the cube round it.
const BALL: f64 = std::f64::consts::FRAC_PI_6;

impl Galerkin {
    /// Number of the axis across a thin part.
    pub fn across(&self) -> usize {
        self.across.unwrap_or_default() as usize
    }

    /// Fewest cells along an axis whose nodes determine the powers of its coordinate in the basis.
    pub fn least_cells(&self, axis: usize) -> usize {
        match self.basis {
            GalerkinBasis::Linear => 1,
            GalerkinBasis::Quadratic => 2,
            GalerkinBasis::Plate17 => 3 - usize::from(axis == self.across()),
        }
    }

    /// Where a node has weight, the default of its basis where nothing is said.
    pub fn support(&self) -> GalerkinSupport {
        match (&self.support, self.basis) {
            (Some(given), _) => given.clone(),
            (None, GalerkinBasis::Plate17) => {
                let mut radii = vec![ALONG_PLATE; 3];
                radii[self.across()] = ACROSS_PLATE;
                GalerkinSupport::Tensor(PerAxis::Each(radii))
            }
            (None, _) => GalerkinSupport::Ellipsoid(PerAxis::Same(ELLIPSOID)),
        }
    }

    /// About the number of nodes that a point sees.
    pub fn neighbours(&self) -> f64 {
        let (share, radii) = match self.support() {
            GalerkinSupport::Sphere(radius) => (BALL, PerAxis::Same(radius)),
            GalerkinSupport::Ellipsoid(radii) => (BALL, radii),
            GalerkinSupport::Tensor(radii) => (1.0, radii),
        };
        share * (0..3).map(|axis| 2.0 * radii.along(axis)).product::<f64>()
    }

    /// One line that names the method with its options.
    pub fn describe(&self) -> String {
        let basis = match self.basis {
            GalerkinBasis::Linear => "linear",
            GalerkinBasis::Quadratic => "quadratic",
            GalerkinBasis::Plate17 => "plate17",
        };
        let radii = |radii: &PerAxis| match radii {
            PerAxis::Same(radius) => format!("{radius}"),
            PerAxis::Each(list) => format!("{list:?}"),
        };
        let support = match self.support() {
            GalerkinSupport::Sphere(radius) => format!("sphere {radius}"),
            GalerkinSupport::Ellipsoid(given) => format!("ellipsoid {}", radii(&given)),
            GalerkinSupport::Tensor(given) => format!("tensor {}", radii(&given)),
        };
        let update = match self.update.unwrap_or_default() {
            GalerkinUpdate::Midpoint => "midpoint",
            GalerkinUpdate::StepStart => "step-start",
        };
        let law = match self.law {
            GalerkinLaw::StrainRotation => format!("strain and rotation, {update}"),
            GalerkinLaw::Literal => format!("strain and rotation to the letter, {update}"),
            GalerkinLaw::StVenant => "St Venant".into(),
        };
        let essential = match self.essential {
            GalerkinEssential::Collocation => "collocation",
            GalerkinEssential::Direct => "direct supports",
        };
        let volumes = match self.volumes {
            None | Some(GalerkinVolumes::Shared) => "",
            Some(GalerkinVolumes::Mean) => ", volumes by the mean of a cell",
            Some(GalerkinVolumes::Points) => ", volumes by points",
        };
        let (kernel, gauss) = (&self.kernel, self.gauss);
        format!("galerkin, {basis}, {support}, {kernel}, {law}, {essential}, {gauss} Gauss points{volumes}")
    }
}

fn csrbf2() -> String {
    "csrbf2".into()
}

fn three() -> GaussPoints {
    GaussPoints::usual(3)
}
