//! The columns of a curve on a shell: on its particles, or where its strains are sampled.

use sph_core::Vec3;
use sph_shell::{Formulation, Shell};

use super::build::Builder;
use super::cells::CellSets;
use crate::bodies::Probe;
use crate::bodies::sampled::{PointAtRest, Sampled};
use crate::bodies::sets::{self, Sets};
use crate::scene;
use crate::scene::body_in_scene::OnSet;
use crate::scene::error::SceneError;

impl Builder<'_> {
    pub(super) fn probes(
        &self,
        sets: &Sets,
        cells: &CellSets<'_>,
        shell: &Shell,
    ) -> Result<Vec<Probe>, SceneError> {
        let probe = |column: &OnSet<'_, scene::Probe>| {
            let path = column.at("on");
            let in_cells =
                column.of.is_of_strains() && matches!(shell.formulation(), Formulation::StressPoint(_));
            let on = match in_cells {
                true => cells.at(&path, column.on)?,
                false => {
                    let cloud = &shell.reference().cloud;
                    sets::places(cloud, sets.at(self.scene, &path, column.on)?).collect()
                }
            };
            // Only a number leaves out its direction.
            let direction = column.direction.map_or_else(Vec3::zeros, |v| self.turned(v).normalize());
            let sampled =
                if column.of.is_of_strains() { Some(self.sampled(column, &on, shell)?) } else { None };
            let about = self.turned(column.about.unwrap_or_default());
            let probe = Probe::of_column(self.scene.scene, column, on, direction);
            Ok(Probe { about, sampled, ..probe })
        };
        self.scene.curve.iter().map(probe).collect()
    }

    /// What is known at rest of the points of a column.
    fn sampled(
        &self,
        column: &OnSet<'_, scene::Probe>,
        points: &[u32],
        shell: &Shell,
    ) -> Result<Sampled, SceneError> {
        /// A direction closer to the normal than this has none in the surface.
        const ACROSS: f64 = 1e-6;
        let at_rest = |&p: &u32| {
            let point = &shell.reference().operator.points[p as usize];
            let section = shell.section_at(p as usize);
            let mut along = [0.0; 2];
            if let Some(direction) = column.direction {
                let e = self.turned(direction).normalize();
                let [a, b] = [e.dot(&point.frame.t1), e.dot(&point.frame.t2)];
                let size = libm::hypot(a, b);
                if size < ACROSS {
                    let x = self.turn_back(&point.position);
                    let bound = format!(
                        "along the surface, on which it stands at [{:.4}, {:.4}, {:.4}]: what strains make has components in it",
                        x.x, x.y, x.z
                    );
                    let path = column.at("direction");
                    let repair = "take a direction in the surface, or a set on which it lies so";
                    let value = format!("{direction:?}");
                    return Err(self.scene.source.value(&path, value, &bound, repair));
                }
                along = [a / size, b / size];
            }
            let initial = section.initial;
            let section = [section.thickness, section.height];
            Ok(PointAtRest { along, section, area: point.weight, initial })
        };
        let points = points.iter().map(at_rest).collect::<Result<_, SceneError>>()?;
        Ok(Sampled { of: column.of, face: column.face, points })
    }
}
