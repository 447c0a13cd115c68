//! What the cells of a shell are made of: one section for most, others for those that differ.

use shell_kinematics::{Section, StrainMeasure};
use sph_core::Vec3;
use sph_shell::Region;

/// The sections of a shell: the one of most cells on their particles, and those that differ.
pub(crate) struct Sections {
    /// The section of all cells that no region names.
    pub base: Box<dyn Section>,
    /// Its density \[M/L³\].
    pub density: f64,
    /// Its first axis.
    pub axis: Option<Vec3>,
    /// Its strain measure.
    pub strain: &'static dyn StrainMeasure,
    /// The others.
    pub regions: Vec<Region>,
    /// Mass by area of each cell \[M/L²\]; none where all are alike.
    pub areal: Vec<f64>,
    /// What is modelled, a line a part.
    pub said: Vec<String>,
}

impl Sections {
    /// Mass by area of a cell \[M/L²\].
    pub fn area_density(&self, cell: u32) -> f64 {
        let alike = || self.density * self.base.scales().thickness;
        self.areal.get(cell as usize).copied().unwrap_or_else(alike)
    }
}
