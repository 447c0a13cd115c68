//! From the heat of a scene to the solid that conducts it, and to what warms it.

use heat_conduction::{Capacity, Conducts, Radiation};
use solid_kinematics::Tensor;
use sph_core::{FacePoint, Vec3};
use sr_galerkin::{Conduction, Galerkin, GalerkinError, Gradients};

use super::parts::axes;
use super::places::Places;
use super::solid::GalerkinSolid;
use crate::bodies::conducting::HeatOf;
use crate::bodies::hot::refuse_nothing_left;
use crate::bodies::refusal::model_error;
use crate::bodies::solid::sets::NodeSets;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, HeatScene, SolidScene};

impl HeatOf<GalerkinSolid> for Conduction {
    type Conducts = Gradients;

    fn heat(&self) -> &heat_conduction::Conduction<Gradients> {
        Conduction::heat(self)
    }

    /// All of it is one.
    fn pieces(&self) -> Vec<Vec<u32>> {
        vec![(0..Conduction::heat(self).conductor().parameters() as u32).collect()]
    }

    fn flux(&self, solid: &GalerkinSolid, parameters: &[f64]) -> Vec<Vec3> {
        Conduction::flux(self, solid.galerkin(), parameters)
    }
}

/// A solid on which heat is put.
#[derive(Clone, Copy)]
pub(super) struct Heated<'a> {
    pub scene: &'a BodyInScene<'a>,
    pub solid: &'a SolidScene,
    pub galerkin: &'a Galerkin,
    pub places: &'a Places,
    pub sets: &'a NodeSets<'a>,
}

impl Heated<'_> {
    /// The solid with all that the scene says of its heat, and what it stores by degree where time passes; none where the scene says nothing.
    ///
    /// # Errors
    /// [`SceneError`] for sets without a face, nodes held at two temperatures, and a temperature that nothing tells.
    pub fn asked(&self) -> Result<Option<(Conduction, Capacity)>, SceneError> {
        if self.scene.scene.heat.is_empty() {
            return Ok(None);
        }
        let run = if let Analysis::Heat(heat) = self.scene.analysis { heat.transient } else { None };
        let conduction = self.conduction(run.is_some_and(|run| run.start.is_some()))?;
        let Some(stores) = run.and_then(|_| self.solid.material.heat_by_volume()) else {
            return Ok(Some((conduction, Capacity::default())));
        };
        let refused = |error: GalerkinError| model_error(self.scene.source, "heat", &error.to_string());
        let capacity = conduction.capacity(self.galerkin, stores).map_err(refused)?;
        Ok(Some((conduction, capacity)))
    }

    fn conduction(&self, starts: bool) -> Result<Conduction, SceneError> {
        let axes = axes(self.solid);
        let along = self.solid.material.conductivity().unwrap_or_default();
        let tensor = axes * Tensor::from_diagonal(&Vec3::from(along)) * axes.transpose();
        let mut conduction = self.galerkin.conduction(&tensor);
        for (i, own) in self.scene.scene.heat.iter().enumerate() {
            let put = |conduction: &mut Conduction| self.put(own, i, conduction);
            match own.amplitude.clone() {
                Some(course) => conduction.in_course(course, put)?,
                None => put(&mut conduction)?,
            }
        }
        if conduction.is_untold() && !starts {
            let message =
                "nothing tells the temperature of the solid; hold a set of it, or give a face a film";
            return Err(model_error(self.scene.source, "heat", message));
        }
        Ok(conduction)
    }

    /// Puts one condition on the solid.
    fn put(&self, own: &HeatScene, number: usize, conduction: &mut Conduction) -> Result<(), SceneError> {
        let Self { galerkin, places, sets, .. } = *self;
        let (path, on) = (format!("heat[{number}].on"), own.on.as_str());
        let refused = |error: GalerkinError| model_error(self.scene.source, &path, &error.to_string());
        let nodes = sets.at(&path, on)?;
        if let Some(temperature) = own.held {
            return conduction
                .hold(nodes, temperature)
                .map_err(|error| model_error(self.scene.source, &path, &format!("{error}; hold it once")));
        }
        let volumes = nodes.iter().map(|&node| (node, places.block.volumes[node as usize]));
        let mut at_nodes = |by_volume: f64| {
            volumes.clone().try_for_each(|(node, volume)| {
                let place = &places.block.positions[node as usize];
                conduction.supply_at(galerkin, place, by_volume * volume).map_err(refused)
            })
        };
        if let Some(source) = own.source {
            if on == "all" {
                conduction.source(galerkin, source);
                return Ok(());
            }
            return at_nodes(source);
        }
        let points = self.face(&path, on);
        if let Some(flow) = own.flow {
            let Ok(points) = points else {
                return at_nodes(flow / volumes.clone().map(|(_, volume)| volume).sum::<f64>());
            };
            let area: f64 = points.iter().map(|point| point.area().norm()).sum();
            return conduction.supply(galerkin, &points, flow / area).map_err(refused);
        }
        let points = points?;
        if let Some(flux) = own.flux {
            conduction.supply(galerkin, &points, flux).map_err(refused)?;
        }
        if let Some(film) = &own.film {
            conduction.film(galerkin, &points, film.coefficient.get(), film.ambient).map_err(refused)?;
        }
        if let Some(given) = &own.radiation {
            let factor = given.emissivity * given.constant.get();
            let radiation = Radiation { factor, surroundings: given.surroundings, zero: given.zero };
            conduction.radiate(galerkin, &points, radiation).map_err(refused)?;
        }
        Ok(())
    }

    /// Points of the faces that lie in a set.
    fn face(&self, path: &str, on: &str) -> Result<Vec<FacePoint>, SceneError> {
        let Self { places, sets, .. } = *self;
        if let Some(points) = places.of_surface(self.scene, sets, (path, on))? {
            return Ok(points);
        }
        let mut cells = places.cells.clone();
        let faces = places.faces(&mut cells, sets, path, on)?;
        let rule = self.solid.galerkin().map_or(2, |options| options.gauss.get().max(2));
        let refused = |error| model_error(self.scene.source, path, &format!("{error}"));
        cells.face_points(&faces, rule).map_err(refused)
    }

    /// The strain that each point would have were it free, by all changes of temperature at level one \[–\]; none where nothing is warmed.
    ///
    /// # Errors
    /// [`SceneError`] where no temperatures are conducted.
    pub fn strains(&self, conduction: Option<&Conduction>) -> Result<Option<Vec<f64>>, SceneError> {
        let expansion =
            self.solid.material.elastic().and_then(|elastic| elastic.expansion).unwrap_or_default();
        let mut out: Option<Vec<f64>> = None;
        for load in &self.scene.loads {
            let Some(temperature) = &load.temperature else { continue };
            let sum = out.get_or_insert_with(|| vec![0.0; self.galerkin.points()]);
            let conducted = temperature.conducted.as_ref().zip(conduction);
            let Some((own, conduction)) = conducted else {
                let change = temperature.change.unwrap_or_default();
                sum.iter_mut().for_each(|sum| *sum += expansion * change);
                continue;
            };
            let path = load.at("temperature.conducted");
            let refused = |error: String| model_error(self.scene.source, &path, &error);
            let found = conduction.steady().map_err(|error| refused(error.to_string()))?;
            let there = self.galerkin.temperatures_at_points(&found.parameters);
            let there = there.map_err(|error| refused(error.to_string()))?;
            sum.iter_mut().zip(there).for_each(|(sum, t)| *sum += expansion * (t - own.over));
        }
        refuse_nothing_left(self.scene, out.iter().flatten())?;
        Ok(out)
    }
}
