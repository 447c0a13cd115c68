//! From the heat of a scene to the bonds that conduct it.

use std::collections::BTreeMap;

use heat_conduction::{Capacity, Conduction, ConductionError, Network, Radiation};
use peridynamics::{Solid, SolidError};
use sph_core::Vec3;

use super::sets::NodeSets;
use crate::bodies::conducting::HeatOf;
use crate::bodies::hot::refuse_nothing_left;
use crate::bodies::refusal::model_error;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, HeatScene, SolidScene};

/// Heat that runs along bonds.
pub(super) struct BondHeat(Conduction<Network>);

impl HeatOf<Solid> for BondHeat {
    type Conducts = Network;

    fn heat(&self) -> &Conduction<Network> {
        &self.0
    }

    fn pieces(&self) -> Vec<Vec<u32>> {
        self.0.conductor().pieces()
    }

    /// `(1/2V) Σ g (Tᵢ − Tⱼ) ξ`, exact within for temperatures that are linear in space.
    fn flux(&self, solid: &Solid, parameters: &[f64]) -> Vec<Vec3> {
        let block = solid.block();
        let mut out = vec![Vec3::zeros(); block.len()];
        for &(a, b, conductance) in self.0.conductor().pairs() {
            let (a, b) = (a as usize, b as usize);
            let way = (block.positions[b] - block.positions[a])
                * (0.5 * conductance * (parameters[a] - parameters[b]));
            out[a] += way / block.volumes[a];
            out[b] += way / block.volumes[b];
        }
        out
    }
}

/// The bonds with all that the scene says of their heat, and what nodes store by degree where time passes; none where the scene says nothing.
///
/// # Errors
/// [`SceneError`] for sets without a face, nodes held at two temperatures, pieces whose temperature nothing tells.
pub(super) fn conduction(
    scene: &BodyInScene<'_>,
    wanted: &SolidScene,
    solid: &Solid,
    sets: &NodeSets<'_>,
) -> Result<Option<(BondHeat, Capacity)>, SceneError> {
    if scene.scene.heat.is_empty() {
        return Ok(None);
    }
    let [conductivity, ..] = wanted.material.conductivity().unwrap_or_default();
    let refused = |error: SolidError| model_error(scene.source, "heat", &error.to_string());
    let mut heat = Conduction::new(solid.conduction(conductivity).map_err(refused)?);
    for (i, own) in scene.scene.heat.iter().enumerate() {
        let before = own.amplitude.clone().map(|course| heat.begin_course(course));
        put(scene, own, i, (solid, sets), &mut heat)?;
        before.into_iter().for_each(|before| heat.end_course(before));
    }
    let run = if let Analysis::Heat(heat) = scene.analysis { heat.transient } else { None };
    let pieces = heat.conductor().pieces();
    match heat.untold(&pieces) {
        Some(node) if run.is_none_or(|run| run.start.is_none()) => {
            let message = format!(
                "nothing tells the temperature of the piece with node {node}, which no bond joins to the others; hold a set of it, or give it a film"
            );
            return Err(model_error(scene.source, "heat", &message));
        }
        _ => {}
    }
    let stores = run.and_then(|_| wanted.material.heat_by_volume());
    let own = stores.map(|stores| solid.block().volumes.iter().map(|volume| stores * volume).collect());
    Ok(Some((BondHeat(heat), Capacity { own: own.unwrap_or_default(), pairs: Vec::new() })))
}

/// The strain that each node would have were it free, by all changes of temperature at level one \[–\]; none where nothing is warmed.
///
/// # Errors
/// [`SceneError`] for a set without nodes, and where no temperatures are conducted.
pub(super) fn free_strains(
    scene: &BodyInScene<'_>,
    wanted: &SolidScene,
    solid: &Solid,
    (sets, conduction): (&NodeSets<'_>, Option<&BondHeat>),
) -> Result<Option<Vec<f64>>, SceneError> {
    let expansion = wanted.material.elastic().and_then(|elastic| elastic.expansion).unwrap_or_default();
    let mut out: Option<Vec<f64>> = None;
    for load in &scene.loads {
        let Some(temperature) = &load.temperature else { continue };
        let sum = out.get_or_insert_with(|| vec![0.0; solid.len()]);
        let nodes = sets.at(&load.at("on"), load.on)?;
        let Some((own, conduction)) = temperature.conducted.as_ref().zip(conduction) else {
            let change = temperature.change.unwrap_or_default();
            nodes.iter().for_each(|&node| sum[node as usize] += expansion * change);
            continue;
        };
        let refused = |error: ConductionError| {
            model_error(scene.source, &load.at("temperature.conducted"), &error.to_string())
        };
        let found = conduction.0.steady().map_err(refused)?;
        nodes
            .iter()
            .for_each(|&node| sum[node as usize] += expansion * (found.values[node as usize] - own.over));
    }
    refuse_nothing_left(scene, out.iter().flatten())?;
    Ok(out)
}

/// Puts one condition on the nodes.
fn put(
    scene: &BodyInScene<'_>,
    own: &HeatScene,
    number: usize,
    (solid, sets): (&Solid, &NodeSets<'_>),
    heat: &mut Conduction<Network>,
) -> Result<(), SceneError> {
    let (path, on) = (format!("heat[{number}].on"), own.on.as_str());
    let nodes = sets.at(&path, on)?;
    if let Some(temperature) = own.held {
        return heat
            .hold(nodes, temperature)
            .map_err(|error| model_error(scene.source, &path, &format!("{error}; hold it once")));
    }
    let volume = |node: u32| solid.block().volumes[node as usize];
    if let Some(source) = own.source {
        nodes.iter().for_each(|&node| heat.supply(node, source * volume(node)));
        return Ok(());
    }
    let areas = areas(sets, on, nodes);
    if let Some(flow) = own.flow {
        let shares =
            if areas.is_empty() { nodes.iter().map(|&node| (node, volume(node))).collect() } else { areas };
        let whole: f64 = shares.iter().map(|(_, share)| share).sum();
        shares.into_iter().for_each(|(node, share)| heat.supply(node, flow * share / whole));
        return Ok(());
    }
    if areas.is_empty() {
        let bound = "but no face lies in it: no area is there for heat to enter by";
        let repair = "name a face, or use `flow`, or `source` by volume";
        return Err(SceneError::Set(scene.source.fault(&path, &format!("\"{on}\""), bound, repair)));
    }
    for (node, area) in areas {
        if let Some(flux) = own.flux {
            heat.supply(node, flux * area);
        }
        if let Some(film) = &own.film {
            heat.film(node, film.coefficient.get() * area, film.ambient);
        }
        if let Some(given) = &own.radiation {
            let factor = given.emissivity * given.constant.get() * area;
            heat.radiate(node, Radiation { factor, surroundings: given.surroundings, zero: given.zero });
        }
    }
    Ok(())
}

/// Areas of the faces of a set, by node \[L²\]: of a block those of a face or of all, of a surface that nodes fill those of its part.
fn areas(sets: &NodeSets<'_>, on: &str, nodes: &[u32]) -> Vec<(u32, f64)> {
    let mut out = BTreeMap::<u32, f64>::new();
    match sets.facets(on, nodes, &[]) {
        Some(facets) => {
            facets.iter().for_each(|facet| *out.entry(facet.node).or_default() += facet.area.norm());
        }
        None if on == "all" => sets.outside().for_each(|(node, area)| *out.entry(node).or_default() += area),
        None => sets.face(on).iter().for_each(|&(node, area)| *out.entry(node).or_default() += area),
    }
    out.into_iter().collect()
}
