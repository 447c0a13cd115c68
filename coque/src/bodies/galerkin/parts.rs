//! Material, shape functions and options of a Galerkin solid, from the scene's words to those of `sr-galerkin`.

use std::sync::Arc;

use solid_kinematics::{Formulation, Material, Moduli, Plastic as Yielding, StressMeasure, Tensor};
use sph_core::{Basis, Support, Vec3, Weight, kernels};
use sr_galerkin::{Hardened, Volumes};

use super::places::Places;
use crate::bodies::shell::material::hardening;
use crate::scene::{
    Arc as ArcOfCells, Galerkin, GalerkinBasis, GalerkinLaw, GalerkinSupport, Hardening, PerAxis, Plastic,
    SolidMaterial, SolidScene,
};

/// Moduli and the way in which stress follows deformation.
///
/// # Errors
/// What is no material, in words.
pub(super) fn material(solid: &SolidScene, galerkin: &Galerkin) -> Result<Material, String> {
    let isotropic = |young: f64, poisson: f64| Moduli::isotropic(young, poisson);
    let moduli = match &solid.material {
        SolidMaterial::Elastic(elastic) => isotropic(elastic.young.get(), elastic.poisson),
        SolidMaterial::Plastic(plastic) => isotropic(plastic.young.get(), plastic.poisson),
        SolidMaterial::Orthotropic(given) => Moduli::orthotropic(&given.constants()),
    }
    .map_err(|error| error.to_string())?;
    let plastic = match &solid.material {
        SolidMaterial::Plastic(given) => {
            let curve = hardening(&given.hardening).map_err(|error| error.to_string())?;
            let plastic = Yielding::new(&moduli, Arc::new(Hardened(curve)), given.kinematic.get());
            Some(plastic.map_err(|error| error.to_string())?)
        }
        _ => None,
    };
    let update = galerkin.update.unwrap_or_default();
    let formulation = match galerkin.law {
        GalerkinLaw::StrainRotation => {
            Formulation::StrainRotation { update, measure: StressMeasure::Kirchhoff }
        }
        GalerkinLaw::Literal => Formulation::StrainRotation { update, measure: StressMeasure::Literal },
        GalerkinLaw::StVenant => Formulation::StVenant,
    };
    Ok(Material { moduli, formulation, plastic })
}

/// Plastic strain beyond which a table of hardening says nothing \[–\].
pub(super) fn data_until(solid: &SolidScene) -> Option<f64> {
    let SolidMaterial::Plastic(Plastic { hardening: Hardening::Table(rows), .. }) = &solid.material else {
        return None;
    };
    rows.last().map(|[strain, _]| *strain)
}

/// Where the change of volume is taken.
pub(super) fn volumes(solid: &SolidScene, galerkin: &Galerkin) -> Volumes {
    let usual = if solid.material.yields() { Volumes::Mean } else { Volumes::Shared };
    galerkin.volumes.unwrap_or(usual)
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
fn angles_of(arc: &ArcOfCells) -> Vec<f64> {
    let [first, last] = arc.angles.map(f64::to_radians);
    let columns = arc.cells[0];
    (0..=columns).map(|i| first + (last - first) * i as f64 / columns as f64).collect()
}

pub(super) fn weight(galerkin: &Galerkin) -> Weight {
    let kernel = kernels().into_iter().find(|kernel| kernel.name() == galerkin.kernel);
    kernel.map_or(Weight::Csrbf2, Weight::Kernel)
}
