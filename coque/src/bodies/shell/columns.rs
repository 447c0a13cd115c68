//! The columns of a curve on a shell: on its particles, or where its strains are sampled.

use sph_core::Vec3;
use sph_shell::{Formulation, Shell};

use super::build::Builder;
use super::cells::CellSets;
use crate::bodies::Probe;
use crate::bodies::plies::{OfPlies, Plies};
use crate::bodies::sampled::{PointAtRest, Sampled};
use crate::bodies::sets::{self, Sets};
use crate::scene;
use crate::scene::Measured;
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
                false if column.of.is_of_section() => self.beyond(column, sets, shell)?,
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
        let plies = match column.of.is_of_plies() {
            true => Some(self.plies_of(column, points, shell)?),
            false => None,
        };
        let points = points.iter().map(at_rest).collect::<Result<_, SceneError>>()?;
        Ok(Sampled { of: column.of, face: column.face, points, plies })
    }

    /// The plies at the points of a column, each of which has what is asked of it.
    fn plies_of(
        &self,
        column: &OnSet<'_, scene::Probe>,
        points: &[u32],
        shell: &Shell,
    ) -> Result<(Plies, OfPlies), SceneError> {
        let plies = Plies::of(shell, points.iter().map(|&p| p as usize));
        let ply = column.ply.map(|ply| ply.get() - 1);
        let fault = |key: &str, value: &str, bound: &str, repair: &str| {
            SceneError::Choice(self.scene.source.fault(&column.at(key), value, bound, repair))
        };
        let count = |point: usize| plies.at(point).map_or(0, |own| own.plies().len());
        if let Some(ply) = ply
            && let Some(short) = (0..points.len()).map(count).find(|&count| count <= ply)
        {
            let bound = format!("one of all cells of the set, of which some have {short}");
            let (value, repair) = ((ply + 1).to_string(), "take a set of cells that have as many plies");
            return Err(fault("ply", &value, &bound, repair));
        }
        let whole = |key: &str| fault(key, "nothing", "given", "add it");
        let of = match column.of {
            Measured::PlyStress => OfPlies::Stress(
                ply.ok_or_else(|| whole("ply"))?,
                column.component.ok_or_else(|| whole("component"))?,
                column.face.ok_or_else(|| whole("face"))?,
            ),
            of => {
                let criterion = column.criterion.ok_or_else(|| whole("criterion"))?;
                if !(0..points.len()).any(|point| plies.judged(point, ply)) {
                    let bound = "on cells, or of a ply, of a material with a `strength`";
                    let value = format!("\"{}\"", of.word());
                    return Err(fault(
                        "of",
                        &value,
                        bound,
                        "add `strength` to it, or take another set or ply",
                    ));
                }
                match of {
                    Measured::ReserveFactor => OfPlies::Reserve(ply, criterion),
                    _ => OfPlies::Index(ply, criterion),
                }
            }
        };
        Ok((plies, of))
    }

    /// The particles of a set that lie beyond a cut at rest.
    fn beyond(
        &self,
        column: &OnSet<'_, scene::Probe>,
        sets: &Sets,
        shell: &Shell,
    ) -> Result<Vec<u32>, SceneError> {
        let all = sets.at(self.scene, &column.at("on"), column.on)?;
        // The checks leave no section force without a cut.
        let Some(through) = column.through else { return Ok(all.to_vec()) };
        let (point, normal) = (self.turned(through.point), self.turned(through.normal));
        let is_beyond = |a: usize| (shell.rest_position(a) - point).dot(&normal) > 0.0;
        let beyond: Vec<u32> = all.iter().copied().filter(|&a| is_beyond(a as usize)).collect();
        let sides = [beyond.is_empty(), (0..shell.len()).all(is_beyond)];
        if let Some(side) = sides.into_iter().position(|empty| empty) {
            let lies = if side == 0 { "no particle of the set lies beyond it" } else { "all lie beyond it" };
            let (bound, repair) =
                (format!("a cut through the shell: {lies}"), "move its point into the shell");
            let value = format!("{:?}", through.point);
            return Err(self.scene.source.value(&column.at("through.point"), value, &bound, repair));
        }
        let refuse = |bound: &str, repair: &str| {
            let value = format!("\"{}\"", column.on);
            Err(self.scene.source.value(&column.at("on"), value, bound, repair))
        };
        match reach(shell, is_beyond, &beyond) {
            Reached::Shared => refuse(
                "a set that nothing else joins beyond the cut: forces between it and other particles there would count as well",
                "use \"all\", or a set that holds all that hangs together beyond the plane",
            ),
            Reached::Never => refuse(
                "a set with cells through which the cut runs",
                "move the cut into the set, or use \"all\"",
            ),
            Reached::Cut => Ok(beyond),
        }
    }
}

/// How particles beyond a cut hang together with others.
enum Reached {
    /// With others beyond it, whose forces on them are in the sum.
    Shared,
    /// With none on this side.
    Never,
    /// Through the cut alone.
    Cut,
}

fn reach(shell: &Shell, is_beyond: impl Fn(usize) -> bool, chosen: &[u32]) -> Reached {
    let operator = &shell.reference().operator;
    let mut of_set = vec![false; shell.len()];
    chosen.iter().for_each(|&a| of_set[a as usize] = true);
    let mut reached = Reached::Never;
    for p in 0..operator.points.len() {
        let particles = operator.stencil(p).particles;
        let any = |holds: &dyn Fn(usize) -> bool| particles.iter().any(|&a| holds(a as usize));
        if !any(&|a| of_set[a]) {
            continue;
        }
        if any(&|a| !of_set[a] && is_beyond(a)) {
            return Reached::Shared;
        }
        if any(&|a| !is_beyond(a)) {
            reached = Reached::Cut;
        }
    }
    reached
}
