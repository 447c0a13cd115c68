//! Particles where a scene places them on a shape: a lattice with its options, or scattered.

use nalgebra::{Matrix3, Rotation3};
use sph_core::{Cloud, EndWeights, Patch, SpaceError, Vec3};

use crate::bodies::refusal::body_error;
use crate::scene::body_in_scene::ShellInScene;
use crate::scene::bounded::{Grading, Polar, Positive};
use crate::scene::error::SceneError;
use crate::scene::{Formulation, Geometry, Placing};

/// Cubic end weights where gradients are cubic, on uniform lattices; other clouds have areas of their own.
pub(crate) fn end_weights(scene: &ShellInScene<'_>) -> EndWeights {
    let Placing { disorder, grading, scattered, .. } = scene.shell.geometry.placing();
    let uniform = scattered.is_none() && disorder.is_none() && grading.is_none();
    match &scene.shell.formulation {
        Formulation::Nodal(f) if *f.order == 3 && uniform => EndWeights::Gregory,
        _ => EndWeights::Trapezoid,
    }
}

/// The particles, not turned yet.
pub(crate) fn place(scene: &ShellInScene<'_>, weights: EndWeights) -> Result<Cloud, SceneError> {
    let radians = |angles: [f64; 2]| angles.map(f64::to_radians);
    let patch: Box<dyn Patch> = match &scene.shell.geometry {
        Geometry::Plate(plate) => Box::new(sph_core::Plate { lengths: plate.lengths.map(Positive::get) }),
        Geometry::Cylinder(c) => Box::new(sph_core::Cylinder {
            radius: c.radius.get(),
            angles: radians(c.angles),
            length: c.length.get(),
        }),
        Geometry::Sphere(s) => Box::new(sph_core::Sphere {
            radius: s.radius.get(),
            polar: radians(s.polar.map(Polar::get)),
            azimuth: radians(s.azimuth),
        }),
        Geometry::Twisted(s) => Box::new(sph_core::Twisted {
            length: s.length.get(),
            width: s.width.get(),
            twist: s.twist.to_radians(),
        }),
        Geometry::Mesh(_) => {
            return Err(body_error(scene, "geometry.mesh", "a mesh has no rows of particles"));
        }
    };
    let geometry = &scene.shell.geometry;
    let (cloud, key) = match geometry.placing().scattered {
        Some(s) => (sph_core::poisson_cloud(&*patch, s.spacing.get(), s.seed), "scattered.spacing"),
        // The checks leave one of the two; a lattice of nothing is refused below.
        None => lattice(scene, &*patch, geometry.particles().unwrap_or_default(), weights),
    };
    let path = format!("geometry.{}.{key}", geometry.word());
    cloud.map_err(|e| body_error(scene, &path, &e.to_string()))
}

/// The particles where `placed` puts them in space.
pub(crate) fn placed(scene: &ShellInScene<'_>, cloud: Cloud) -> Cloud {
    let Some(placed) = scene.shell.placed else { return cloud };
    let [u, v] = [placed.u, placed.v].map(|v| Vec3::from(v).normalize());
    let normal = u.cross(&v).normalize();
    // The checks leave the two at right angles but for rounding.
    let turn = Matrix3::from_columns(&[u, normal.cross(&u), normal]);
    cloud.transformed(&Rotation3::from_matrix_unchecked(turn), &Vec3::from(placed.origin))
}

/// A lattice as the scene asks for it, and the key to blame.
fn lattice(
    scene: &ShellInScene<'_>,
    patch: &dyn Patch,
    counts: [usize; 2],
    weights: EndWeights,
) -> (Result<Cloud, SpaceError>, &'static str) {
    let Placing { disorder, grading, .. } = scene.shell.geometry.placing();
    if disorder.is_none() && grading.is_none() {
        return (sph_core::lattice(patch, counts, weights), "particles");
    }
    let (fraction, seed) = disorder.map_or((0.0, 0), |d| (d.fraction.get(), d.seed));
    let graded =
        sph_core::Graded::new(patch, counts, grading.map_or([1.0, 1.0], |grading| grading.map(Grading::get)));
    let cloud = graded.and_then(|graded| sph_core::jittered_lattice(&graded, counts, fraction, seed));
    (cloud, if disorder.is_some() { "disorder" } else { "grading" })
}
