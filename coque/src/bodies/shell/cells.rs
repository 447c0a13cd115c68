//! Sets of cells by the names of sets: groups of faces of a file, cells whose centre a region holds, cells between particles, and what is
//! made of these.

use sph_core::{Cell, Cloud, Vec3};

use super::imported::Imported;
use crate::bodies::sets::{Sets, inside};
use crate::scene::body_in_scene::ShellInScene;
use crate::scene::error::SceneError;

/// The cells of a shell, to be picked by name.
pub(crate) struct CellSets<'a> {
    scene: &'a ShellInScene<'a>,
    /// Not turned yet.
    cloud: &'a Cloud,
    sets: &'a Sets,
    imported: Option<&'a Imported>,
}

impl<'a> CellSets<'a> {
    pub(crate) fn new(
        scene: &'a ShellInScene<'a>,
        cloud: &'a Cloud,
        sets: &'a Sets,
        imported: Option<&'a Imported>,
    ) -> Self {
        Self { scene, cloud, sets, imported }
    }

    /// Cells of the set that the scene names at `path`.
    ///
    /// A group of faces of the file holds its faces, a region the cells whose centre lies in it, any other set the cells
    /// between its particles; what is made of sets is made of their cells.
    ///
    /// # Errors
    /// [`SceneError::Set`] for a name that is no set and for a set without cells.
    pub(crate) fn at(&self, path: &str, name: &str) -> Result<Vec<u32>, SceneError> {
        let found = self.cells(path, name)?;
        if !found.is_empty() {
            return Ok(found);
        }
        let region = self.scene.sets.get(name);
        let (bound, repair) = if self.cloud.cells.is_empty() {
            ("but points without faces have no cells", "bring a mesh with faces")
        } else if region.is_some_and(|region| region.made().is_some()) {
            (
                "but the sets that it is made of leave no cell: areas and strains are those of cells",
                "make it of sets that hold whole cells",
            )
        } else if region.is_some() {
            (
                "but its region holds no centre of a cell: areas and strains are those of cells",
                "widen the region until it holds whole cells",
            )
        } else {
            (
                "but no cell lies between its particles: areas and strains are those of cells",
                "name \"all\", a group of faces of the file, or a box round the cells",
            )
        };
        let fault = self.scene.source.fault(path, &format!("\"{name}\""), bound, repair);
        Err(SceneError::Set(fault))
    }

    /// Cells of a set, if it has any.
    fn cells(&self, path: &str, name: &str) -> Result<Vec<u32>, SceneError> {
        let particles = self.sets.at(self.scene, path, name)?;
        let cells = &self.cloud.cells;
        if let Some((made, sets)) = self.scene.sets.get(name).and_then(|region| region.made()) {
            let at = |i: usize| format!("sets.{name}.{}[{i}]", made.word());
            let each = sets.iter().enumerate().map(|(i, set)| self.cells(&at(i), self.scene.own_set(set)));
            return Ok(made.members(&each.collect::<Result<Vec<_>, _>>()?));
        }
        let numbered = || (0_u32..).zip(cells);
        Ok(if name == "all" {
            (0..cells.len() as u32).collect()
        } else if let Some(kept) = self.imported.and_then(|imported| imported.cells_of(name)) {
            kept
        } else if let Some(region) = self.scene.sets.get(name) {
            let centre = |cell: &Cell| cell.geometry(&self.cloud.positions).centroid;
            let centres: Vec<Vec3> = cells.iter().map(centre).collect();
            inside(region, &centres, self.cloud.spacing())
        } else {
            let mut member = vec![false; self.cloud.len()];
            particles.iter().for_each(|&a| member[a as usize] = true);
            let whole = |(_, cell): &(u32, &Cell)| cell.particles().iter().all(|&a| member[a as usize]);
            numbered().filter(whole).map(|(c, _)| c).collect()
        })
    }
}
