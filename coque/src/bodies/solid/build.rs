//! From a scene to a solid ready to move: nodes, sets, supports, loads.

use std::collections::BTreeMap;

use peridynamics::{AppliedLoad, Parts, Solid, SolidError, StaticSolid};
use sph_core::{Block, BlockLattice};

use super::conditions::{driver, holds, loads, mirrors, probes, set_out, supports};
use super::describe::describe;
use super::parts::{carrier, contact, cracks, cut_outs, fracture, material};
use super::sets::NodeSets;
use super::warnings::warnings_of;
use crate::bodies::build::amplitude;
use crate::bodies::rigid::free_of;
use crate::bodies::{BuiltBody, Identity, Memory, Model, PrescribedPoint, Probe, Ready};
use crate::scene::error::SceneError;
use crate::scene::{Analysis, Scene, SolidScene};

/// A solid with what its curve measures.
struct SolidParts {
    solid: Solid,
    probes: Vec<Probe>,
    /// The one node whose motion a force that is sought brings about.
    driven: Option<PrescribedPoint>,
    memory: Memory,
    /// Its nodes by name of their set.
    sets: BTreeMap<String, Vec<u32>>,
}

impl Scene {
    /// Builds a solid with what is asked of it.
    pub(in crate::bodies) fn solid_model(
        &self,
        scene: &SolidScene,
        threads: usize,
    ) -> Result<Model, SceneError> {
        let ready = |solid| match &self.analysis {
            Analysis::Explicit(_) => Ready::Dynamic(Box::new(solid)),
            _ => Ready::Static(Box::new(StaticSolid::new(solid))),
        };
        Ok(self.solid_made(scene, threads, false)?.map(ready).model(self, threads))
    }

    /// Builds a solid, in a fluid if it is `wet`, and looks at it.
    pub(in crate::bodies) fn solid_made(
        &self,
        scene: &SolidScene,
        threads: usize,
        wet: bool,
    ) -> Result<BuiltBody<Solid>, SceneError> {
        let SolidParts { mut solid, probes, driven, memory, sets } = self.assemble_solid(scene, threads)?;
        if wet {
            solid.wet().map_err(|error| self.solid_refusal(scene, &error))?;
        }
        let description = describe(self, scene, &solid);
        let warnings = warnings_of(self, scene, &solid);
        let identity = Identity::default();
        let judge = None;
        Ok(BuiltBody { body: solid, description, memory, identity, probes, driven, warnings, judge, sets })
    }

    /// Builds the solid alone, for programs that march or solve it themselves.
    ///
    /// # Errors
    /// As [`Scene::build`], and for a body of another kind.
    pub fn build_solid(&self, threads: usize) -> Result<Solid, SceneError> {
        self.check()?;
        let with_bonds = self.as_solid().filter(|solid| solid.galerkin().is_none());
        let scene = with_bonds.ok_or_else(|| self.not_a("solid with bonds"))?;
        self.assemble_solid(scene, threads).map(|built| built.solid)
    }

    fn assemble_solid(&self, scene: &SolidScene, threads: usize) -> Result<SolidParts, SceneError> {
        let lattice = scene.lattice();
        let memory = self
            .check_memory(lattice.cells().map_or(0.0, |cells| cells.iter().map(|&n| n as f64).product()))?;
        let perfect = self.nodes(scene, &lattice)?;
        let block = self.bent(scene, &lattice, &perfect, threads)?;
        let sets = NodeSets::find(self, &lattice, &perfect, &perfect.positions)?;
        let probes = probes(self, &sets)?;
        let driver = driver(self, &sets)?;
        let supports = supports(self, scene.has_directors(), &sets, driver.as_ref())?;
        let mirrors = mirrors(self, &lattice, &sets)?;
        let material = material(scene);
        let mut loads = loads(self, material.density, &block, &sets)?;
        let driven = driver.map(|driver| driver.point(&supports)).transpose();
        let driven = driven.map_err(|error| self.solid_refusal(scene, &error))?;
        if let Some(PrescribedPoint { particle, direction, .. }) = driven {
            let (forces, amplitude) = (vec![(particle, direction)], amplitude(None));
            loads.push(AppliedLoad { forces, amplitude });
        }
        self.refuse_free_motion(|| {
            let all = Vec::from_iter(0..block.len() as u32);
            free_of(&block.positions, &all, holds(scene, &supports, &block, &mirrors))
        })?;
        let fracture = fracture(self, scene, &sets)?;
        let parts = Parts {
            material,
            formulation: carrier(scene, &lattice),
            fracture,
            cracks: cracks(scene, &lattice),
            contact: contact(scene),
            supports,
            loads,
            threads: threads.max(1),
            block,
        };
        let mut solid =
            Solid::mirrored(parts, &mirrors).map_err(|error| self.solid_refusal(scene, &error))?;
        set_out(scene, &mut solid);
        self.refuse_dof(solid.dof())?;
        self.refuse_pieces(&solid)?;
        Ok(SolidParts { solid, probes, driven, memory, sets: sets.into_members() })
    }

    /// The nodes of the block, holes cut.
    fn nodes(&self, scene: &SolidScene, lattice: &BlockLattice) -> Result<Block, SceneError> {
        let block = lattice.block().map_err(|e| self.body_error("geometry.block", &e.to_string()))?;
        let block = block.without(&cut_outs(scene, lattice));
        if block.is_empty() {
            let (found, bound) = ("all of the block", "less: no node is left");
            let path = self.body_scope().path("geometry.cut_outs");
            return Err(SceneError::Choice(self.source.fault(&path, found, bound, "cut less out")));
        }
        Ok(block)
    }

    /// The block with the imperfection put in.
    fn bent(
        &self,
        scene: &SolidScene,
        lattice: &BlockLattice,
        perfect: &Block,
        threads: usize,
    ) -> Result<Block, SceneError> {
        let mut block = perfect.clone();
        let Some(imperfection) = scene.imperfection else { return Ok(block) };
        let Some(waves) = imperfection.half_waves else {
            let modes = self.of_modes();
            let body = modes.as_solid().unwrap_or(scene);
            let mut system = StaticSolid::new(modes.assemble_solid(body, threads)?.solid);
            let read = |system: &StaticSolid| {
                let solid = system.solid();
                [(0..solid.len()).map(|node| solid.position(node)).collect(), Vec::new()]
            };
            let found = self.deflection(&imperfection, &mut system, read, |v| *v)?;
            block.positions.iter_mut().zip(&found.displacements).for_each(|(x, u)| *x += u);
            return Ok(block);
        };
        let waves = waves.map(|n| f64::from(n) * std::f64::consts::PI);
        for x in &mut block.positions {
            let along = |axis: usize| (x[axis] - lattice.origin[axis]) / lattice.lengths[axis];
            let shape = libm::sin(waves[0] * along(0)) * libm::sin(waves[1] * along(1));
            x.z += imperfection.amplitude * shape;
        }
        Ok(block)
    }

    /// A body in pieces has rigid motions of its own for each: a static answer needs one piece.
    fn refuse_pieces(&self, solid: &Solid) -> Result<(), SceneError> {
        let pieces = solid.fragments().len();
        if self.analysis.kind().floats || pieces == 1 {
            return Ok(());
        }
        let path = self.body_scope().path("cracks");
        let bound = format!("a body in one piece in {}", self.analysis.kind().name);
        let repair = "shorten the cracks, or use [analysis.explicit.transient]";
        let value = format!("solid in {pieces} pieces, each with rigid motions of its own");
        Err(SceneError::FreeMotion(self.source.fault(&path, &value, &bound, repair)))
    }

    /// Puts a refusal of the solid where the scene causes it.
    fn solid_refusal(&self, scene: &SolidScene, error: &SolidError) -> SceneError {
        let moved = self.supports.iter().position(|support| support.moved.is_some()).unwrap_or(0);
        let of_body = |path: &str| self.body_scope().path(path);
        let formulation = format!("formulation.{}", scene.formulation.word());
        let path = match error {
            SolidError::Material { .. } | SolidError::Pairwise(..) => of_body("material.elastic"),
            SolidError::Horizon(_) | SolidError::Alone(_) => of_body(&format!("{formulation}.horizon")),
            SolidError::Coincident(..) | SolidError::Volume { .. } | SolidError::OneLayer => {
                of_body("geometry.block")
            }
            SolidError::Contradiction { .. } => format!("supports[{moved}].moved"),
            SolidError::EmptySet(_) | SolidError::NoSuchNode { .. } => "sets".into(),
            SolidError::Unbalanced(_) | SolidError::Flat { .. } => {
                of_body(&format!("{formulation}.correction"))
            }
            SolidError::Limit { .. } => of_body("fracture"),
            SolidError::Crack { number, .. } => of_body(&format!("cracks[{number}]")),
            SolidError::NotThin | SolidError::WetSheets => of_body(&formulation),
            SolidError::SheetContact | SolidError::MirroredContact => of_body("contact"),
            SolidError::Mirror { .. } => "supports".into(),
        };
        self.model_error(&path, &error.to_string())
    }
}
