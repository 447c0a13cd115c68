//! Where in a scene the cause of a refusal of the shell stands.

use sph_core::SpaceError;
use sph_shell::ShellError;

use super::build::Builder;
use crate::bodies::refusal::model_error;
use crate::scene::body_in_scene::OnSet;
use crate::scene::error::SceneError;
use crate::scene::{Formulation, Section, Support};

impl Builder<'_> {
    /// Puts a refusal of the shell where the scene causes it.
    pub(super) fn refusal(&self, error: &ShellError) -> SceneError {
        let reach = match &self.scene.shell.formulation {
            Formulation::StressPoint(_) => "formulation.stress-point.support",
            Formulation::Nodal(_) => "formulation.nodal.smoothing",
            Formulation::StrongForm(_) => "formulation.strong-form.smoothing",
        };
        let supports = || self.scene.supports.iter();
        let motion = supports().find_map(|s| s.motion().map(|(word, _)| s.at(word)));
        let of_body = |path: &str| self.scene.body_scope().path(path);
        let path = match error {
            ShellError::Space(
                SpaceError::Undetermined { .. } | SpaceError::TooFew { .. } | SpaceError::NotConverged { .. },
            ) => of_body(reach),
            ShellError::Space(SpaceError::AxisNormal { .. }) => match self.scene.shell.section {
                Section::Stiffness(_) => of_body("section.stiffness.axis"),
                _ => of_body("section.layered.axis"),
            },
            ShellError::Space(_)
            | ShellError::Area { .. }
            | ShellError::ParallelDirectors { .. }
            | ShellError::WetSpacing(_)
            | ShellError::NoRows
            | ShellError::NotAStrip { .. } => {
                of_body(&format!("geometry.{}", self.scene.shell.geometry.word()))
            }
            ShellError::JunctionOfWideStencils | ShellError::NotShared(_) => of_body("formulation"),
            ShellError::Density(_) => {
                of_body(&format!("material.{}.density", self.scene.shell.material.word()))
            }
            ShellError::Contradiction { .. } | ShellError::TwoMotions(_) => {
                motion.unwrap_or_else(|| "supports".into())
            }
            &(ShellError::OutOfPlane { support, .. }
            | ShellError::SectionAlongAxis { support, .. }
            | ShellError::HeldDirector { rotated: support, .. }) => {
                let present = |s: &&OnSet<'_, Support>| {
                    s.spring.is_none()
                        && self.scene.shell.rigid_body(s.on).is_none()
                        && (s.moved.is_none() || self.scene.sole_motion().is_none())
                };
                let found = supports().filter(present).nth(support).or(supports().next());
                found.map_or("supports".into(), |support| support.path.clone())
            }
            &(ShellError::TieTooFar { tie, .. }
            | ShellError::TieTooCoarse { tie, .. }
            | ShellError::TieWithoutEdge { tie }) => of_body(&format!("ties[{tie}]")),
            ShellError::TieOfWideStencils | ShellError::TieHeld { .. } | ShellError::TieInACircle { .. } => {
                of_body("ties")
            }
            &(ShellError::RigidOnALine { set } | ShellError::RigidInertia { set, .. }) => {
                of_body(&format!("rigid[{set}]"))
            }
            &ShellError::RigidOpposed { set, .. } => {
                let on = self.scene.shell.rigid.get(set).map(|body| body.on.as_str());
                let found = supports().find(|s| Some(s.on) == on && s.motion().is_some());
                found.map_or("supports".into(), |support| support.path.clone())
            }
            ShellError::RigidOfWideStencils
            | ShellError::RigidTwice { .. }
            | ShellError::RigidHeld { .. }
            | ShellError::RigidHangs { .. }
            | ShellError::RigidInPart { .. } => of_body("rigid"),
            ShellError::TwoRegions { .. } => of_body("parts"),
            ShellError::StressAxis { number, .. } => of_body(&format!("initial_stress[{number}].axis")),
            ShellError::StressOfWideStencils => of_body("initial_stress"),
            ShellError::Stiffener(cause) => of_body(&format!("stiffeners[{}]", cause.number())),
            ShellError::OwnLaw(_) => of_body("section"),
            ShellError::Enclosed(cause) => {
                let mut loads = self.scene.loads.iter().filter(|load| !load.heats());
                loads.nth(cause.load()).map_or("loads".into(), |load| load.at("on"))
            }
            ShellError::Heat(cause) => {
                let mut loads = self.scene.loads.iter().filter(|load| load.heats());
                loads.nth(cause.number()).map_or("loads".into(), |load| load.at("temperature"))
            }
            ShellError::Mass { .. } => of_body("masses"),
            ShellError::Spring { .. }
            | ShellError::SpringOnItself { .. }
            | ShellError::SpringOfBody { .. } => "supports".into(),
            ShellError::SpringAlongDirector { .. } => {
                let turning = |s: &Support| s.spring.as_ref().is_some_and(|spring| spring.axis.is_some());
                let found = supports().find(|support| turning(support));
                found.map_or("supports".into(), |support| support.at("spring.axis"))
            }
            ShellError::Tool(_)
            | ShellError::ToolStiffness(_)
            | ShellError::ToolFriction(_)
            | ShellError::ToolWithoutCells
            | ShellError::ToolOnOffset { .. } => of_body("tools"),
            ShellError::ContactStiffness(_)
            | ShellError::ContactOfThicknesses { .. }
            | ShellError::ContactWithoutCells
            | ShellError::ContactOnOffset { .. }
            | ShellError::ContactOfTies => "contact[0]".into(),
            ShellError::RegionsWithoutCells => of_body("formulation"),
            ShellError::WetFromAfar => of_body("geometry"),
            ShellError::NoSuchParticle { .. }
            | ShellError::NoSuchCell { .. }
            | ShellError::EmptySet(_)
            | ShellError::NotAnEdge(_)
            | ShellError::DrillingAlone(_) => "loads".into(),
        };
        model_error(self.scene.source, &path, &error.to_string())
    }
}
