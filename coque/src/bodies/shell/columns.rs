//! The columns of a curve on a shell: on its particles, or where its strains are sampled.

use std::collections::{BTreeMap, BTreeSet};

use sph_core::{Frame, Vec3};
use sph_shell::{Formulation, Shell};

use super::build::Builder;
use super::cells::CellSets;
use crate::bodies::Probe;
use crate::bodies::plies::{OfPlies, Plies};
use crate::bodies::recovered::{Share, recovery, section};
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
            if column.recovered {
                // On a junction each sheet has its own stress: all particles of a place count.
                return self.at_particles(column, sets.at(self.scene, &path, column.on)?, shell);
            }
            let on = match in_cells {
                true => cells.at(&path, column.on)?,
                false if column.of.is_of_section() => self.beyond(column, sets, shell)?,
                false => {
                    let cloud = &shell.reference().cloud;
                    sets::places(cloud, sets.at(self.scene, &path, column.on)?).collect()
                }
            };
            if matches!(column.of, Measured::BarForce | Measured::BarMoment) {
                self.refuse_unbarred(column, &on, shell)?;
            }
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

    /// A bar is read at particles of its own line, where no other one runs.
    fn refuse_unbarred(
        &self,
        column: &OnSet<'_, scene::Probe>,
        particles: &[u32],
        shell: &Shell,
    ) -> Result<(), SceneError> {
        let mut at = BTreeMap::<u32, BTreeSet<usize>>::new();
        for piece in shell.bar_forces() {
            piece.ends.iter().for_each(|&end| {
                at.entry(end).or_default().insert(piece.stiffener);
            });
        }
        let bars = |a: &&u32| at.get(*a).map_or(0, BTreeSet::len);
        let Some(particle) = particles.iter().find(|a| bars(a) != 1) else { return Ok(()) };
        let x = self.turn_back(&shell.rest_position(*particle as usize));
        let found = if bars(&particle) == 0 { "no stiffener runs" } else { "several stiffeners run" };
        let bound =
            format!("a set of places of one stiffener: at [{:.4}, {:.4}, {:.4}] {found}", x.x, x.y, x.z);
        let repair = "take particles of its line, off the places where others cross it";
        let value = format!("\"{}\"", column.on);
        Err(SceneError::Set(self.scene.source.fault(&column.at("on"), &value, &bound, repair)))
    }

    /// A column of values at particles, from those of the cells round them.
    fn at_particles(
        &self,
        column: &OnSet<'_, scene::Probe>,
        particles: &[u32],
        shell: &Shell,
    ) -> Result<Probe, SceneError> {
        let shares = recovery(shell, particles.iter().copied());
        let cells: BTreeSet<u32> = shares.iter().flatten().map(|share| share.cell).collect();
        let cells = Vec::from_iter(cells);
        let place = |cell: u32| cells.partition_point(|&other| other < cell);
        let of_cells = |own: Vec<Share>| own.into_iter().map(|share| (place(share.cell), share)).collect();
        let cloud = &shell.reference().cloud;
        let at_rest = |(&a, own): (&u32, &Vec<Share>)| {
            let along = self.in_surface(column, &cloud.frames[a as usize], &cloud.positions[a as usize])?;
            Ok(PointAtRest { along, section: section(shell, own), area: 0.0, initial: [0.0; 6] })
        };
        let points = particles.iter().zip(&shares).map(at_rest).collect::<Result<_, SceneError>>()?;
        let recovered = shares.into_iter().map(of_cells).collect();
        let sampled = Sampled { of: column.of, face: column.face, points, recovered, plies: None };
        let direction = column.direction.map_or_else(Vec3::zeros, |v| self.turned(v).normalize());
        let probe = Probe::of_column(self.scene.scene, column, cells, direction);
        Ok(Probe { sampled: Some(sampled), ..probe })
    }

    /// The direction of a column in a frame of the surface, a unit vector; zero where it has none.
    fn in_surface(
        &self,
        column: &OnSet<'_, scene::Probe>,
        frame: &Frame,
        place: &Vec3,
    ) -> Result<[f64; 2], SceneError> {
        /// A direction closer to the normal than this has none in the surface.
        const ACROSS: f64 = 1e-6;
        let Some(direction) = column.direction else { return Ok([0.0; 2]) };
        let e = self.turned(direction).normalize();
        let [a, b] = [e.dot(&frame.t1), e.dot(&frame.t2)];
        let size = libm::hypot(a, b);
        if size >= ACROSS {
            return Ok([a / size, b / size]);
        }
        let x = self.turn_back(place);
        let bound = format!(
            "along the surface, on which it stands at [{:.4}, {:.4}, {:.4}]: what strains make has components in it",
            x.x, x.y, x.z
        );
        let path = column.at("direction");
        let repair = "take a direction in the surface, or a set on which it lies so";
        Err(self.scene.source.value(&path, format!("{direction:?}"), &bound, repair))
    }

    /// What is known at rest of the points of a column.
    fn sampled(
        &self,
        column: &OnSet<'_, scene::Probe>,
        points: &[u32],
        shell: &Shell,
    ) -> Result<Sampled, SceneError> {
        let at_rest = |&p: &u32| {
            let point = &shell.reference().operator.points[p as usize];
            let section = shell.section_at(p as usize);
            let along = self.in_surface(column, &point.frame, &point.position)?;
            let initial = section.initial;
            let section = [section.thickness, section.height];
            Ok(PointAtRest { along, section, area: point.weight, initial })
        };
        let plies = match column.of.is_of_plies() {
            true => Some(self.plies_of(column, points, shell)?),
            false => None,
        };
        let points = points.iter().map(at_rest).collect::<Result<_, SceneError>>()?;
        Ok(Sampled { of: column.of, face: column.face, points, recovered: Vec::new(), plies })
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

    /// The particles of a set that lie beyond a cut at rest, where the set lies on both sides of it and nothing else joins it beyond.
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
        let sides = [beyond.is_empty(), beyond.len() == all.len()];
        if let Some(side) = sides.into_iter().position(|empty| empty) {
            let lies = if side == 0 { "no particle of it lies beyond" } else { "all of it lies beyond" };
            let bound = format!("a cut through the set \"{}\": {lies}", column.on);
            let repair = "move its point into the set, or take a set that lies on both sides";
            let value = format!("{:?}", through.point);
            return Err(self.scene.source.value(&column.at("through.point"), value, &bound, repair));
        }
        let Some(other) = joined_beyond(&beyond, &is_beyond, shell) else { return Ok(beyond) };
        let x = self.turn_back(&shell.rest_position(other));
        let bound = format!(
            "but beyond the cut it hangs together with a particle that is not in it, at [{:.4}, {:.4}, {:.4}]: what these bear from \
             each other goes through no cut",
            x.x, x.y, x.z
        );
        let repair = "take on = \"all\", or a set that nothing else joins beyond the cut, such as one leg of a frame to its end";
        let value = format!("\"{}\"", column.on);
        Err(SceneError::Set(self.scene.source.fault(&column.at("on"), &value, &bound, repair)))
    }
}

/// A particle beyond a cut that is none of `beyond` and shares a stencil or a junction with one of them: forces that are summed over these alone
/// would hold what goes between the two.
fn joined_beyond(beyond: &[u32], is_beyond: &dyn Fn(usize) -> bool, shell: &Shell) -> Option<usize> {
    let mut within = vec![false; shell.len()];
    beyond.iter().for_each(|&a| within[a as usize] = true);
    let other = |particles: &[u32]| {
        let mut all = particles.iter().map(|&a| a as usize);
        let other = all.clone().find(|&a| !within[a] && is_beyond(a))?;
        all.any(|a| within[a]).then_some(other)
    };
    let reference = shell.reference();
    let operator = &reference.operator;
    let of_points = (0..operator.points.len()).find_map(|p| other(operator.stencil(p).particles));
    of_points.or_else(|| reference.cloud.joined.iter().find_map(|group| other(group)))
}
