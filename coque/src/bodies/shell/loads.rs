//! Loads of a scene as those of the shell: on particles, on edges, on cells, on rigid bodies.

use sph_core::{Cloud, EndWeights, Vec3};
use sph_shell::{AppliedLoad, Content, CoupleAxis, DrillingCouple, EdgeCouple, Enclosed};

use super::build::Builder;
use super::cells::CellSets;
use super::imported::Imported;
use super::sections::Sections;
use crate::bodies::sets::{self, Sets};
use crate::scene::error::SceneError;
use crate::scene::{self, Axis, LoadKind};

/// Cosine between the axis of a couple and a normal up to which it stands across: rounding.
const ACROSS: f64 = 1e-6;

impl Builder<'_> {
    /// The loads of a shell, each of its scene but heat once and in their order.
    pub(super) fn loads(
        &self,
        sets: &Sets,
        cells: &CellSets<'_>,
        sections: &Sections,
        cloud: &Cloud,
        weights: EndWeights,
        imported: Option<&Imported>,
    ) -> Result<Vec<AppliedLoad>, SceneError> {
        let mut loads = Vec::new();
        // Heat exerts no forces: `Builder::temperatures` has it.
        for load in self.scene.loads.iter().filter(|load| !load.heats()) {
            let path = load.at("on");
            let of_case = |applied: AppliedLoad| match load.preload {
                true => AppliedLoad { load: Box::new(sph_shell::Preloaded(applied.load)), ..applied },
                false => applied,
            };
            if load.acts_on_cells() {
                let factors = self.factors(load, cloud.len())?;
                let cells = cells.at(&path, load.on)?;
                let found = self.load_on_cells(load, cells, factors, sections, cloud);
                loads.extend(found.into_iter().map(of_case));
                continue;
            }
            let particles = sets.at(self.scene, &path, load.on)?;
            let edge = match imported {
                None => sets::edge(load.on, particles, cloud, weights),
                Some(imported) => imported.edge(self.scene, &path, load, particles)?,
            };
            let shares = edge.unwrap_or_else(|| sets::places(cloud, particles).map(|a| (a, 1.0)).collect());
            for (_, kind) in load.kinds() {
                let amplitude = load.amplitude.clone().unwrap_or_default();
                let found = match self.load_on_body(&kind, load.on) {
                    Some(on_body) => Some(Box::new(on_body) as _),
                    None => {
                        let shares = match &kind {
                            LoadKind::Couple(couple) => {
                                self.at_junctions(&path, couple, shares.clone(), cloud)?
                            }
                            _ => shares.clone(),
                        };
                        self.load(kind, shares, cloud)
                    }
                };
                loads.extend(found.map(|load| of_case(AppliedLoad { load, amplitude })));
            }
        }
        Ok(loads)
    }

    /// Where sheets meet, which turn together there, a couple acts on the one across whose normal its axis stands, that of the others turning with it.
    ///
    /// # Errors
    /// [`SceneError::Choice`] where there is none: what turns one sheet about its normal would bend the others, by whichever comes first.
    fn at_junctions(
        &self,
        path: &str,
        couple: &scene::Couple,
        mut shares: Vec<(u32, f64)>,
        cloud: &Cloud,
    ) -> Result<Vec<(u32, f64)>, SceneError> {
        let Axis::Fixed(axis) = couple.axis else { return Ok(shares) };
        let axis = self.turned(axis).normalize();
        if cloud.joined.is_empty() || DrillingCouple::new(cloud, shares.clone(), axis, 1.0).turns_a_line() {
            return Ok(shares);
        }
        let normal = |a: u32| cloud.frames[a as usize].n;
        let along = |a: u32| normal(a).dot(&axis).abs();
        for (particle, _) in &mut shares {
            let Some(group) = cloud.joined.iter().find(|group| group.contains(particle)) else { continue };
            let alike = group.iter().all(|&a| normal(a).cross(&normal(*particle)).norm() <= ACROSS);
            if along(*particle) <= ACROSS || alike {
                continue;
            }
            match group.iter().find(|&&a| along(a) <= ACROSS) {
                Some(&across) => *particle = across,
                None => {
                    let bound = "an axis across one of the sheets that meet at a particle of the set: it turns all of them together";
                    let repair = "give the couple to a rigid set, or to a line of particles whole";
                    let value = "a couple about another axis";
                    let fault = self.scene.source.fault(path, value, bound, repair);
                    return Err(SceneError::Choice(fault));
                }
            }
        }
        Ok(shares)
    }

    fn load(
        &self,
        kind: LoadKind,
        shares: Vec<(u32, f64)>,
        cloud: &Cloud,
    ) -> Option<Box<dyn sph_shell::Load>> {
        Some(match kind {
            LoadKind::Force(force) => Box::new(sph_shell::Force { shares, total: self.turned(force.total) }),
            LoadKind::Couple(couple) => {
                let moment = couple.moment;
                match couple.axis {
                    Axis::Edge => Box::new(EdgeCouple { edge: shares, moment, axis: CoupleAxis::Edge }),
                    Axis::Fixed(axis) => {
                        let axis = self.turned(axis).normalize();
                        Box::new(DrillingCouple::new(cloud, shares, axis, moment))
                    }
                }
            }
            LoadKind::Pressure(p) => Box::new(sph_shell::Pressure { value: p.value(), follower: p.follower }),
            LoadKind::Gravity(g) => {
                Box::new(sph_shell::Gravity { acceleration: self.turned(g.acceleration) })
            }
            // They act on cells.
            LoadKind::Traction(_) | LoadKind::Gas(_) | LoadKind::Volume(_) | LoadKind::Temperature(_) => {
                return None;
            }
        })
    }

    /// What acts on some cells.
    fn load_on_cells(
        &self,
        load: &scene::Load,
        cells: Vec<u32>,
        factors: Vec<f64>,
        sections: &Sections,
        cloud: &Cloud,
    ) -> Vec<AppliedLoad> {
        let areas = || sph_shell::spread(cloud, &cells, |_| 1.0);
        let sum = |shares: &[(u32, f64)]| shares.iter().map(|(_, share)| share).sum::<f64>();
        let dead = |shares: Vec<(u32, f64)>, total: Vec3| Box::new(sph_shell::Force { shares, total });
        let of = |(_, kind): (&str, LoadKind)| -> Option<Box<dyn sph_shell::Load>> {
            Some(match kind {
                LoadKind::Force(force) => dead(areas(), self.turned(force.total)),
                LoadKind::Traction(traction) => {
                    let shares = areas();
                    let total = self.turned(traction.value) * sum(&shares);
                    dead(shares, total)
                }
                LoadKind::Gravity(gravity) => {
                    let masses = sph_shell::spread(cloud, &cells, |cell| sections.area_density(cell));
                    let total = self.turned(gravity.acceleration) * sum(&masses);
                    dead(masses, total)
                }
                LoadKind::Pressure(p) => Box::new(sph_shell::PressurePatch {
                    pressure: sph_shell::Pressure { value: p.value(), follower: p.follower },
                    cells: cells.clone(),
                    factors: factors.clone(),
                }),
                LoadKind::Gas(gas) => {
                    let (pressure, ambient) = (gas.pressure, gas.ambient.get());
                    let content = Content::Gas { pressure, ambient, exponent: gas.exponent() };
                    Box::new(Enclosed::new(cells.clone(), content, gas.beside.get()))
                }
                LoadKind::Volume(volume) => {
                    let (added, bulk_modulus) = (volume.added, volume.bulk_modulus.get());
                    let content = Content::Liquid { added, bulk_modulus };
                    Box::new(Enclosed::new(cells.clone(), content, volume.beside.get()))
                }
                LoadKind::Couple(_) | LoadKind::Temperature(_) => return None,
            })
        };
        let amplitude = || load.amplitude.clone().unwrap_or_default();
        let loads = load.kinds().into_iter().filter_map(of);
        loads.map(|load| AppliedLoad { load, amplitude: amplitude() }).collect()
    }
}
