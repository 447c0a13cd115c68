//! Material, shape functions and options of a Galerkin solid, from the scene's words to those of `sr-galerkin`.

use solid_kinematics::{ElasticError, Formulation, Material, Moduli, StressMeasure, Tensor};
use sph_core::{Basis, Support, Vec3, Weight, kernels};

use super::places::Places;
use crate::scene::{
    Arc, Galerkin, GalerkinBasis, GalerkinLaw, GalerkinSupport, PerAxis, SolidMaterial, SolidScene,
};

/// Moduli and the way in which stress follows deformation.
pub(super) fn material(solid: &SolidScene, galerkin: &Galerkin) -> Result<Material, ElasticError> {
    let moduli = match &solid.material {
        SolidMaterial::Elastic(elastic) => Moduli::isotropic(elastic.young.get(), elastic.poisson)?,
        SolidMaterial::Orthotropic(given) => Moduli::orthotropic(&given.constants())?,
    };
    let update = galerkin.update.unwrap_or_default();
    let formulation = match galerkin.law {
        GalerkinLaw::StrainRotation => {
            Formulation::StrainRotation { update, measure: StressMeasure::Kirchhoff }
        }
        GalerkinLaw::Literal => Formulation::StrainRotation { update, measure: StressMeasure::Literal },
        GalerkinLaw::StVenant => Formulation::StVenant,
    };
    Ok(Material { moduli, formulation })
}

/// Material axes at rest, as columns.
pub(super) fn axes(solid: &SolidScene) -> Tensor {
    let SolidMaterial::Orthotropic(given) = &solid.material else { return Tensor::identity() };
    let Some(axes) = given.axes else { return Tensor::identity() };
    let [first, second] = axes.map(|axis| Vec3::from(axis).normalize());
    // What the check leaves of the second along the first is rounding of the scene.
    let second = (second - first * first.dot(&second)).normalize();
    Tensor::from_columns(&[first, second, first.cross(&second)])
}

pub(super) fn basis(galerkin: &Galerkin) -> Basis {
    match galerkin.basis {
        GalerkinBasis::Linear => Basis::Linear,
        GalerkinBasis::Quadratic => Basis::Quadratic,
        GalerkinBasis::Plate17 => Basis::Plate17 { across: galerkin.across() },
    }
}

/// Where a node has weight. An arc turns its spacings: the support holds those of every angle.
pub(super) fn support(solid: &SolidScene, galerkin: &Galerkin, places: &Places) -> Support {
    let spacing = places.block.spacing;
    let scaled = |radii: &PerAxis| [0, 1, 2].map(|axis| radii.along(axis) * spacing[axis]);
    let angles: Vec<f64> = solid.geometry.arc.as_ref().map(angles_of).unwrap_or_default();
    let turned = |own: [f64; 3], hull: fn(f64, f64) -> f64| {
        let along = |a: f64, b: f64| {
            let of = |angle: &f64| hull(a * libm::cos(*angle), b * libm::sin(*angle));
            angles.iter().map(of).reduce(f64::max).unwrap_or(a)
        };
        [along(own[0], own[2]), own[1], along(own[2], own[0])]
    };
    match galerkin.support() {
        GalerkinSupport::Sphere(radius) => {
            Support::sphere(radius * spacing.iter().copied().fold(0.0, f64::max))
        }
        GalerkinSupport::Ellipsoid(radii) => Support::ellipsoid(turned(scaled(&radii), libm::hypot)),
        GalerkinSupport::Tensor(radii) => Support::tensor(turned(scaled(&radii), |a, b| a.abs() + b.abs())),
    }
}

/// Angles of the columns of an arc \[rad\].
fn angles_of(arc: &Arc) -> Vec<f64> {
    let [first, last] = arc.angles.map(f64::to_radians);
    let columns = arc.cells[0];
    (0..=columns).map(|i| first + (last - first) * i as f64 / columns as f64).collect()
}

pub(super) fn weight(galerkin: &Galerkin) -> Weight {
    let kernel = kernels().into_iter().find(|kernel| kernel.name() == galerkin.kernel);
    kernel.map_or(Weight::Csrbf2, Weight::Kernel)
}
