//! From the heat of a scene to the surface that conducts it, and to the temperatures that loads take of it.

use sph_core::Cloud;
use sph_shell::{Conduction, Conductor, Radiation, spread};

use super::build::Builder;
use super::heated::Heated;
use crate::bodies::refusal::model_error;
use crate::bodies::sets;
use crate::scene::error::SceneError;
use crate::scene::scope::Scope;
use crate::scene::{Analysis, Heat, HeatScene, Layered, Material, MaterialSection, ShellScene, faces_count};

/// How cells conduct, and how thick they are \[L\].
type Conducting = (Vec<Conductor>, Vec<f64>);

impl Builder<'_> {
    /// The surface with all that the scene says of its heat.
    ///
    /// # Errors
    /// [`SceneError`] for sets without cells or without an edge, particles held at two temperatures, and pieces whose temperature nothing tells.
    pub(super) fn conduction(&self, shell: Heated<'_>) -> Result<Conduction, SceneError> {
        let (conductors, thickness) = self.conductors(shell)?;
        let refuse = |path: &str, message: String| model_error(self.scene.source, path, &message);
        let made = Conduction::new(shell.cloud, &conductors);
        let mut conduction = made.map_err(|error| refuse("heat", error.to_string()))?;
        let scope = self.scene.body_scope();
        for (number, cells) in self.owned(shell.flat, shell.cells, &scope)?.into_iter().enumerate() {
            if let Material::Elastic(elastic) = &self.part(number, &scope).0.material
                && let Some(table) = elastic.by_temperature.as_ref().and_then(|own| own.conductivity.as_ref())
            {
                conduction.by_temperature(&cells, table.clone());
            }
        }
        for (i, own) in self.scene.scene.heat.iter().enumerate() {
            let put = |conduction: &mut Conduction| self.put(own, i, &thickness, shell, conduction);
            match own.amplitude.clone() {
                Some(course) => conduction.in_course(course, put)?,
                None => put(&mut conduction)?,
            }
        }
        let starts = matches!(self.scene.analysis, Analysis::Heat(Heat { transient: Some(run) }) if run.start.is_some());
        match conduction.untold() {
            Some(particle) if !starts => {
                let message = format!(
                    "nothing tells the temperature of the piece with particle {particle}, which no cell joins to the others; hold a set of it, or give it a film"
                );
                Err(refuse("heat", message))
            }
            _ => Ok(conduction),
        }
    }

    /// Heat that particles store by degree \[F L/Θ\]; nothing of materials that do not say what they store.
    ///
    /// # Errors
    /// [`SceneError`] for parts whose sets are no cells.
    pub(super) fn heat_capacities(&self, shell: Heated<'_>) -> Result<Vec<(u32, f64)>, SceneError> {
        let scope = self.scene.body_scope();
        let mut by_area = vec![0.0; shell.cloud.cells.len()];
        for (number, cells) in self.owned(shell.flat, shell.cells, &scope)?.into_iter().enumerate() {
            let (own, at) = self.part(number, &scope);
            let by_volume = |material: &Material| material.heat_by_volume().unwrap_or_default();
            match own.material_section(&at)? {
                MaterialSection::Homogeneous(_, section) => {
                    let thick = self.thicknesses(section, &at, &cells, shell.flat)?;
                    let by_volume = by_volume(&own.material);
                    cells.iter().zip(thick).for_each(|(&cell, t)| by_area[cell as usize] = by_volume * t);
                }
                MaterialSection::Layered(material, section) => {
                    let plies = section.plies.iter();
                    let sum = plies.map(|ply| ply.thickness.get() * by_volume(ply.material(material))).sum();
                    cells.iter().for_each(|&cell| by_area[cell as usize] = sum);
                }
                _ => return Err(self.no_conductor(&at)),
            }
        }
        let all = Vec::from_iter(0..shell.cloud.cells.len() as u32);
        Ok(spread(shell.cloud, &all, |cell| by_area[cell as usize]))
    }

    /// The shell as it is in the cells that are its own, or those of a part.
    fn part<'s>(&self, number: usize, scope: &Scope<'s>) -> (ShellScene, Scope<'s>) {
        match number.checked_sub(1) {
            None => (self.scene.shell.clone(), scope.clone()),
            Some(part) => (self.scene.shell.in_part(part), scope.below(&format!("parts[{part}]"))),
        }
    }

    /// Puts one condition on the surface.
    fn put(
        &self,
        own: &HeatScene,
        number: usize,
        thickness: &[f64],
        shell: Heated<'_>,
        conduction: &mut Conduction,
    ) -> Result<(), SceneError> {
        let (path, on) = (format!("heat[{number}].on"), self.scene.own_set(&own.on));
        let areas = || Ok::<_, SceneError>(spread(shell.cloud, &shell.cells.at(&path, on)?, |_| 1.0));
        let particles = shell.sets.at(self.scene, &path, on)?;
        if let Some(temperature) = own.held {
            return conduction
                .hold(particles, temperature)
                .map_err(|error| model_error(self.scene.source, &path, &format!("{error}; hold it once")));
        }
        if let Some(flow) = own.flow {
            let shares = match edge(shell, on, particles) {
                Some(lengths) => lengths,
                None => areas()
                    .unwrap_or_else(|_| sets::places(shell.cloud, particles).map(|a| (a, 1.0)).collect()),
            };
            let whole: f64 = shares.iter().map(|(_, share)| share).sum();
            let heat: Vec<_> = shares.into_iter().map(|(a, share)| (a, flow * share / whole)).collect();
            conduction.supply(&heat);
        }
        if let Some(flux) = own.flux {
            let heat: Vec<_> = areas()?.into_iter().map(|(a, area)| (a, flux * area)).collect();
            conduction.supply(&heat);
        }
        if let Some(flux) = own.edge_flux {
            let Some(lengths) = edge(shell, on, particles) else {
                let bound =
                    "which does not lie along an edge: no cross-section is there for heat to enter by";
                let fault = self.scene.source.fault(
                    &path,
                    &format!("\"{on}\""),
                    bound,
                    "name an edge, or use `flow` or `flux`",
                );
                return Err(SceneError::Set(fault));
            };
            let thick = at_particles(thickness, shell.cloud);
            let heat: Vec<_> =
                lengths.into_iter().map(|(a, length)| (a, flux * length * thick[a as usize])).collect();
            conduction.supply(&heat);
        }
        if let Some(film) = &own.film {
            conduction.film(&areas()?, faces_count(film.faces) * film.coefficient.get(), film.ambient);
        }
        if let Some(given) = &own.radiation {
            let factor = faces_count(given.faces) * given.emissivity * given.constant.get();
            let radiation = Radiation { factor, surroundings: given.surroundings, zero: given.zero };
            conduction.radiate(&areas()?, radiation);
        }
        Ok(())
    }

    fn conductors(&self, of: Heated<'_>) -> Result<Conducting, SceneError> {
        let scope = self.scene.body_scope();
        let count = of.cloud.cells.len();
        let (mut all, mut thick) = (vec![Conductor::isotropic(0.0); count], vec![0.0; count]);
        for (number, cells) in self.owned(of.flat, of.cells, &scope)?.into_iter().enumerate() {
            let (shell, at) = self.part(number, &scope);
            let mut give = |cell: u32, conductor: Conductor, thickness: f64| {
                (all[cell as usize], thick[cell as usize]) = (conductor, thickness);
            };
            match shell.material_section(&at)? {
                MaterialSection::Homogeneous(elastic, section) => {
                    let conductivity = elastic.conductivity.map_or(0.0, |own| own.get());
                    for (&cell, t) in cells.iter().zip(self.thicknesses(section, &at, &cells, of.flat)?) {
                        give(cell, Conductor::isotropic(conductivity * t), t);
                    }
                }
                MaterialSection::Layered(material, section) => {
                    let conductor =
                        Conductor { tensor: of_plies(section, material), axis: self.material_axis(&shell) };
                    let t = section.plies.iter().map(|ply| ply.thickness.get()).sum();
                    cells.iter().for_each(|&cell| give(cell, conductor, t));
                }
                _ => return Err(self.no_conductor(&at)),
            }
        }
        Ok((all, thick))
    }

    /// The checks leave a shell that conducts no other.
    fn no_conductor(&self, at: &Scope<'_>) -> SceneError {
        model_error(
            self.scene.source,
            &at.path("section"),
            "a section that does not conduct heat; give [section.homogeneous]",
        )
    }
}

/// Conductivity times thickness of plies in the axes of their section, the sum of theirs \[F L/(T Θ)\].
fn of_plies(section: &Layered, shell: &Material) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for ply in &section.plies {
        let [along, across] = match ply.material(shell) {
            Material::Elastic(own) => [own.conductivity.map_or(0.0, |k| k.get()); 2],
            Material::Orthotropic(own) => own.conductivity.map_or([0.0; 2], |k| k.map(|k| k.get())),
            _ => [0.0; 2],
        };
        let t = ply.thickness.get();
        let own = Conductor::ply([along * t, across * t], ply.angle.to_radians());
        sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
    }
    sum
}

/// Particles of a set along an edge with their tributary lengths \[L\]; none for other sets.
fn edge(shell: Heated<'_>, on: &str, particles: &[u32]) -> Option<Vec<(u32, f64)>> {
    match shell.imported {
        None => sets::edge(on, particles, shell.cloud, shell.weights),
        Some(imported) => Some(imported.lines(particles)?.into_iter().flatten().collect()),
    }
}

/// The mean over the cells at each particle.
fn at_particles(of_cells: &[f64], cloud: &Cloud) -> Vec<f64> {
    let mut sums = vec![[0.0; 2]; cloud.len()];
    for (cell, number) in cloud.cells.iter().zip(of_cells) {
        cell.particles().iter().for_each(|&a| {
            let [sum, count] = &mut sums[a as usize];
            (*sum, *count) = (*sum + number, *count + 1.0);
        });
    }
    sums.into_iter().map(|[sum, count]| if count > 0.0 { sum / count } else { 0.0 }).collect()
}
