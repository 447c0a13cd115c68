//! From a scene to what the particles are made of and how they are sampled: section, axes, strain measure, formulation.

use shell_kinematics::{
    IntegratedSection, Isotropic, IsotropicSection, LayeredSection, MaterialError, Orthotropic, Ply,
};
use sph_core::{CubicSpline, Vec3};
use sph_shell::{Formulation, Reach};

use crate::bodies::shell::build::Builder;
use crate::scene::error::SceneError;
use crate::scene::{self, MaterialSection};

impl Builder<'_> {
    pub(crate) fn section(&self) -> Result<Box<dyn shell_kinematics::Section>, SceneError> {
        let refuse = |path: &'static str| move |e: MaterialError| self.scene.body_error(path, &e.to_string());
        Ok(match self.scene.shell().material_section(&self.scene.body_scope())? {
            MaterialSection::Homogeneous(elastic, section) => {
                let material =
                    Isotropic::new(elastic.young, elastic.poisson).map_err(refuse("material.elastic"))?;
                let refuse = refuse("section.homogeneous");
                match section.gauss_points {
                    None => Box::new(IsotropicSection::new(material, section.thickness).map_err(refuse)?),
                    Some(points) => {
                        Box::new(IntegratedSection::new(material, section.thickness, points).map_err(refuse)?)
                    }
                }
            }
            MaterialSection::Layered(m, section) => {
                let across = m.shear_across.unwrap_or(m.shear);
                let material = Orthotropic::new(m.young_along, m.young_across, m.poisson, m.shear, across)
                    .map_err(refuse("material.orthotropic"))?;
                let ply = |ply: &scene::Ply| Ply {
                    material,
                    thickness: ply.thickness,
                    angle: ply.angle.to_radians(),
                };
                let plies: Vec<Ply> = section.plies.iter().map(ply).collect();
                Box::new(LayeredSection::new(&plies).map_err(refuse("section.layered"))?)
            }
        })
    }

    pub(crate) fn material_axis(&self) -> Option<Vec3> {
        match &self.scene.shell().section {
            scene::Section::Homogeneous(_) => None,
            scene::Section::Layered(section) => Some(self.turned(section.axis)),
        }
    }

    pub(crate) fn strain(&self) -> Result<&'static dyn shell_kinematics::StrainMeasure, SceneError> {
        let name = self.scene.shell().formulation.curvature();
        let path = format!("formulation.{}.curvature", self.scene.shell().formulation.word());
        shell_kinematics::strain_measure(name)
            .ok_or_else(|| self.scene.body_error(&path, &format!("no strain measure is called {name}")))
    }

    pub(crate) fn formulation(&self) -> Formulation {
        // The scene has been checked: an unknown kernel cannot come this far.
        let kernel =
            self.scene.shell().formulation.kernel().and_then(sph_core::kernel).unwrap_or(&CubicSpline);
        match &self.scene.shell().formulation {
            scene::Formulation::StressPoint(f) => Formulation::StressPoint(match f.support {
                scene::Reach::Cell => Reach::Cell,
                scene::Reach::Wide(reach) => Reach::Kernel(kernel, reach),
            }),
            scene::Formulation::Nodal(f) => Formulation::Nodal {
                order: f.order,
                smoothing: f.smoothing_length(),
                consistent: f.divergence_consistent(),
                kernel,
            },
            scene::Formulation::StrongForm(f) => {
                Formulation::StrongForm { smoothing: f.smoothing, viscosity: f.viscosity, kernel }
            }
        }
    }
}
