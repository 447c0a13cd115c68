//! From the changes of temperature of a scene to those of the cells of a shell; isotropic materials, how they expand and what they bear.

use shell_kinematics::{Isotropic, MaterialError};
use sph_core::Cloud;
use sph_shell::{Conduction, LoadCase};

use super::arrays::{by_cell, by_particle};
use super::build::Builder;
use super::cells::CellSets;
use crate::bodies::refusal::model_error;
use crate::scene::error::SceneError;
use crate::scene::scope::Scope;
use crate::scene::{Elastic, Temperature};

/// An isotropic material with its expansion and its strength.
///
/// # Errors
/// [`MaterialError`] for numbers out of bounds.
pub(super) fn isotropic(young: f64, elastic: &Elastic) -> Result<Isotropic, MaterialError> {
    let material = Isotropic::new(young, elastic.poisson)?;
    let material = elastic.strength.map_or(material, |strength| material.strong(strength.get()));
    elastic.expansion.map_or(Ok(material), |expansion| material.expanding(expansion))
}

impl Builder<'_> {
    /// Notes by how much each of so many cells is warmer once all loads are there in full.
    pub(super) fn warm(&mut self, temperatures: &[sph_shell::Temperature], cells: usize) {
        if !temperatures.is_empty() {
            self.warmed = vec![0.0; cells];
        }
        for own in temperatures {
            for (&cell, [change, _]) in own.cells.iter().zip(&own.changes) {
                self.warmed[cell as usize] += change;
            }
        }
    }

    /// An isotropic material of a modulus \[F/L²\], with its numbers at the temperature of a cell.
    ///
    /// # Errors
    /// [`SceneError`] for temperatures beyond a table, and for numbers that make no material.
    pub(super) fn isotropic_at(
        &self,
        young: f64,
        elastic: &Elastic,
        at: &Scope<'_>,
        cell: u32,
    ) -> Result<Isotropic, SceneError> {
        let made = match &elastic.by_temperature {
            None => isotropic(young, elastic),
            Some(own) => {
                let there = own.reference + self.warmed.get(cell as usize).copied().unwrap_or_default();
                let [factor, poisson, expansion] = own.factors(there).map_err(|key| {
                    let path = format!("material.elastic.by_temperature.{key}");
                    let value = format!("no factor at {there:.6}, the temperature of cell {cell}");
                    let repair = "let the table go from the lowest to the highest temperature of the loads, and over `reference`";
                    at.value(&path, value, "a table with the temperature of every cell", repair)
                })?;
                let there = Elastic {
                    poisson: poisson * elastic.poisson,
                    expansion: elastic.expansion.map(|own| expansion * own),
                    ..elastic.clone()
                };
                isotropic(factor * young, &there)
            }
        };
        let path = at.path("material.elastic");
        made.map_err(|error| model_error(self.scene.source, &path, &error.to_string()))
    }

    /// The changes of temperature of the scene, in the order of its loads; some are what the shell conducts.
    ///
    /// # Errors
    /// [`SceneError`] for sets without cells, and for arrays that do not belong to the particles.
    pub(super) fn temperatures(
        &self,
        sets: &CellSets<'_>,
        cloud: &Cloud,
        conduction: Option<&Conduction>,
    ) -> Result<Vec<sph_shell::Temperature>, SceneError> {
        let mut all = Vec::new();
        // Found once, whichever loads take them up.
        let mut found: Option<Vec<f64>> = None;
        for load in &self.scene.loads {
            let Some(Temperature { change, difference, values, conducted }) = &load.temperature else {
                continue;
            };
            let cells = sets.at(&load.at("on"), load.on)?;
            let own = [*change, *difference].map(Option::unwrap_or_default);
            let conducted = conducted.as_ref().zip(conduction);
            let changes = match (values, conducted) {
                (None, Some((own, conduction))) => {
                    let values = match found.take() {
                        Some(values) => values,
                        None => conduction.steady().map(|found| found.values).map_err(|error| {
                            let path = load.at("temperature.conducted");
                            model_error(self.scene.source, &path, &error.to_string())
                        })?,
                    };
                    let means = by_cell(found.insert(values), &cells, cloud).into_iter();
                    means.map(|temperature| [temperature - own.over, 0.0]).collect()
                }
                (None, None) => vec![own; cells.len()],
                (Some(name), _) => {
                    let path = load.at("temperature.values");
                    let scope = self.scene.scope();
                    let factors = by_particle(self.scene.scene, &scope, &path, name, cloud.len())?;
                    by_cell(factors, &cells, cloud)
                        .into_iter()
                        .map(|factor| own.map(|x| factor * x))
                        .collect()
                }
            };
            let case = if load.preload { LoadCase::Preload } else { LoadCase::Loading };
            all.push(sph_shell::Temperature { cells, changes, case });
        }
        Ok(all)
    }
}
