//! The nodes of a solid: those of a block, holes cut, or those that fill a surface.

use sph_core::{Block, BlockLattice};

use super::parts::cut_outs;
use super::skin::{Skin, filled};
use crate::bodies::Memory;
use crate::bodies::memory::check_memory;
use crate::bodies::refusal::body_error;
use crate::scene::SolidScene;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;

/// Where the nodes of a solid are at rest, before an imperfection moves them.
pub(super) struct Places {
    /// The lattice of a block, or the box round a surface with the spacing of the nodes in it.
    pub lattice: BlockLattice,
    pub block: Block,
    /// The surface that they fill.
    pub skin: Option<Skin>,
}

/// The nodes, and what memory the run needs.
///
/// # Errors
/// [`SceneError`] for nodes that are too many or none, and for a surface that encloses no body.
pub(super) fn places(scene: &BodyInScene<'_>, wanted: &SolidScene) -> Result<(Places, Memory), SceneError> {
    if let Some(surface) = &wanted.geometry.filled {
        let (filled, skin) = filled(scene, surface)?;
        let memory = check_memory(scene, filled.block.len() as f64)?;
        return Ok((Places { lattice: filled.bounds, block: filled.block, skin: Some(skin) }, memory));
    }
    let lattice = wanted.lattice();
    let memory =
        check_memory(scene, lattice.cells().map_or(0.0, |cells| cells.iter().map(|&n| n as f64).product()))?;
    let block = nodes(scene, wanted, &lattice)?;
    Ok((Places { lattice, block, skin: None }, memory))
}

/// The nodes of the block, holes cut.
fn nodes(scene: &BodyInScene<'_>, wanted: &SolidScene, lattice: &BlockLattice) -> Result<Block, SceneError> {
    let block = lattice.block().map_err(|e| body_error(scene, "geometry.block", &e.to_string()))?;
    let block = block.without(&cut_outs(wanted, lattice));
    if block.is_empty() {
        let (found, bound) = ("all of the block", "less: no node is left");
        let path = scene.body_scope().path("geometry.cut_outs");
        return Err(SceneError::Choice(scene.source.fault(&path, found, bound, "cut less out")));
    }
    Ok(block)
}
