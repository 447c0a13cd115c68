//! Several sections in one shell: cells with a material, a thickness and a height of their own.
//!
//! Sections are looked up by sampling point, four side by side ([`SectionPack`], or [`MixedSection`] where one of them is not linear), so that cells keep
//! their order and a step stays one sweep. Masses and rotary inertias are spread over the corners of cells,
//!
//! ```text
//! m_a = Σ_c A_ac ρ_c t_c        I_a = Σ_c A_ac ρ_c t_c (max(t_c², w_c)/12 + e_c²)
//! ```
//!
//! A_ac the part of the particle's area in cell c ([`crate::spread`]), w_c the area of the cell, e_c the height of the middle of the section over the
//! particles. What a height couples of velocity and rate of the director, `ρ t e ẋ·ḋ`, is left out: masses stay diagonal.
//! Without time nothing is left out. A region may have a strain measure of its own ([`StrainPack`]), which masses and stable step do not know.

use std::sync::Arc;

use shell_kinematics::{LANES, MixedSection, Section, SectionPack, SectionScales, StrainMeasure, StrainPack};
use sph_core::Vec3;

use crate::conditions::spread::{check_cells, spread};
use crate::error::ShellError;
use crate::reference::Reference;

/// Cells with a section of their own.
pub struct Region {
    /// The cells.
    pub cells: Vec<u32>,
    /// Their section.
    pub section: Arc<dyn Section>,
    /// Mass density \[M/L³\].
    pub density: f64,
    /// Height of the middle of the section over the particles, along the normal \[L\].
    pub height: f64,
    /// Direction whose projection on the surface is the section's first axis; without, the section must not care.
    pub axis: Option<Vec3>,
    /// Their strain measure; without, that of the shell.
    pub strain: Option<&'static dyn StrainMeasure>,
}

/// What is read of the section at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointSection {
    /// Thickness \[L\].
    pub thickness: f64,
    /// Height of its middle over the particles \[L\].
    pub height: f64,
    /// Whether stresses run linearly through the thickness.
    pub homogeneous: bool,
    /// Resultants of the unstrained point, `N11, N22, N12` \[F/L\] and `M11, M22, M12` about the particles \[F\].
    pub initial: [f64; 6],
}

/// Stiffness scales of the section at each sampling point.
pub(crate) struct Scales {
    /// That of all points, if there are no others.
    pub uniform: SectionScales,
    /// Those of single points; empty if all are alike.
    pub own: Vec<SectionScales>,
}

impl Scales {
    /// Scales at a sampling point.
    #[inline(always)]
    pub fn at(&self, point: usize) -> &SectionScales {
        self.own.get(point).unwrap_or(&self.uniform)
    }
}

/// Which region each cell belongs to, and what it has there.
pub(crate) struct Regions {
    regions: Vec<Region>,
    /// Region of each cell, one up; zero for the section of all other cells.
    of_cell: Vec<u32>,
}

impl Regions {
    /// Finds the region of each cell.
    ///
    /// # Errors
    /// [`ShellError`] for sets without cells, cells in two regions, densities out of bounds.
    pub fn new(regions: Vec<Region>, reference: &Reference) -> Result<Self, ShellError> {
        let cloud = &reference.cloud;
        let mut of_cell = vec![0; if regions.is_empty() { 0 } else { cloud.cells.len() }];
        for (number, region) in (1..).zip(&regions) {
            check_cells("a region", &region.cells, cloud)?;
            if !(region.density > 0.0 && region.density.is_finite()) {
                return Err(ShellError::Density(region.density));
            }
            for &cell in &region.cells {
                if std::mem::replace(&mut of_cell[cell as usize], number) != 0 {
                    return Err(ShellError::TwoRegions { cell });
                }
            }
        }
        Ok(Self { regions, of_cell })
    }

    fn at(&self, cell: usize) -> Option<&Region> {
        self.regions.get(self.number(cell).checked_sub(1)?)
    }

    /// Number of the region of a cell, one up; zero of cells in none.
    pub fn number(&self, cell: usize) -> usize {
        self.of_cell.get(cell).map_or(0, |&number| number as usize)
    }

    /// Density of the region of a cell, if it has one \[M/L³\].
    pub fn density(&self, cell: usize) -> Option<f64> {
        self.at(cell).map(|region| region.density)
    }

    /// Stiffness scales of all points, in the order of the cells.
    pub fn scales(&self, base: &dyn Section) -> Scales {
        let uniform = base.scales();
        let regions: Vec<SectionScales> = self.regions.iter().map(|region| region.section.scales()).collect();
        let own = self
            .of_cell
            .iter()
            .map(|&number| if number == 0 { uniform } else { regions[number as usize - 1] });
        Scales { uniform, own: own.collect() }
    }

    /// Their sections.
    pub fn sections(&self) -> impl Iterator<Item = &Arc<dyn Section>> {
        self.regions.iter().map(|region| &region.section)
    }

    /// The section at a point.
    pub fn section<'a>(&'a self, base: &'a Arc<dyn Section>, point: usize) -> &'a Arc<dyn Section> {
        self.at(point).map_or(base, |region| &region.section)
    }

    /// Whether there are any.
    pub fn any(&self) -> bool {
        !self.regions.is_empty()
    }

    /// The sections of each pack of points, that need not be linear: one where its points have the same in the middle of their particles.
    pub fn mixed(&self, base: &Arc<dyn Section>, order: &[[u32; LANES]]) -> Vec<Arc<dyn Section>> {
        let pack = |points: &[u32; LANES]| -> Arc<dyn Section> {
            let sections = points.map(|p| Arc::clone(self.section(base, p as usize)));
            let heights = points.map(|p| self.at(p as usize).map_or(0.0, |region| region.height));
            if heights == [0.0; LANES] && sections.iter().all(|own| Arc::ptr_eq(own, &sections[0])) {
                return Arc::clone(&sections[0]);
            }
            Arc::new(MixedSection::new(sections, heights))
        };
        order.iter().map(pack).collect()
    }

    /// The sections of each pack of points, all linear.
    pub fn packs(&self, base: &dyn Section, order: &[[u32; LANES]]) -> Vec<SectionPack> {
        let pack = |points: &[u32; LANES]| {
            let regions = points.map(|p| self.at(p as usize));
            let sections = regions.map(|region| region.map_or(base, |region| &*region.section));
            SectionPack::new(sections, regions.map(|region| region.map_or(0.0, |region| region.height)))
        };
        order.iter().map(pack).collect()
    }

    /// The strain measures of each pack of points; none where all have that of the shell.
    pub fn strains(&self, base: &'static dyn StrainMeasure, order: &[[u32; LANES]]) -> Vec<StrainPack> {
        let own = |region: &Region| region.strain.unwrap_or(base);
        if self.regions.iter().all(|region| own(region).name() == base.name()) {
            return Vec::new();
        }
        let of = |&p: &u32| self.at(p as usize).map_or(base, own);
        order.iter().map(|points| StrainPack::new(points.each_ref().map(of))).collect()
    }

    /// What is read of the section at a point.
    pub fn read(&self, base: &dyn Section, point: usize) -> PointSection {
        let (section, height) =
            self.at(point).map_or((base, 0.0), |region| (&*region.section, region.height));
        let (thickness, homogeneous) = (section.scales().thickness, section.homogeneous());
        PointSection { thickness, height, homogeneous, initial: [0.0; 6] }
    }

    /// Bending stiffness of the section at a point \[F L\].
    pub fn bending(&self, base: &dyn Section, point: usize) -> f64 {
        self.at(point).map_or(base, |region| &*region.section).scales().bending
    }

    /// Puts masses, rotary inertias and the speed of sound of several sections in the place of those of one.
    pub fn weigh(&self, base: &dyn Section, density: f64, reference: &mut Reference) {
        // Thickness, height and mass by area of each cell.
        let thickness: Vec<f64> = (0..self.of_cell.len()).map(|c| self.read(base, c).thickness).collect();
        let region = |c: usize| self.at(c);
        let height = |c: usize| region(c).map_or(0.0, |region| region.height);
        let mass = |c: usize| region(c).map_or(density, |region| region.density) * thickness[c];
        let cloud = &reference.cloud;
        let all: Vec<u32> = (0..cloud.cells.len() as u32).collect();
        let summed = |by: &dyn Fn(usize) -> f64| {
            let mut sums = vec![0.0; cloud.len()];
            spread(cloud, &all, |c| by(c as usize)).into_iter().for_each(|(a, sum)| sums[a as usize] = sum);
            sums
        };
        let masses = summed(&mass);
        let rotary = summed(&|c| mass(c) * (thickness[c].powi(2) / 12.0 + height(c).powi(2)));
        let size = |c: usize| cloud.cells[c].geometry(&cloud.positions).area;
        let inertias = summed(&|c| mass(c) * (thickness[c].powi(2).max(size(c)) / 12.0 + height(c).powi(2)));
        let speed = |section: &dyn Section, density: f64| {
            let scales = section.scales();
            (scales.membrane / (density * scales.thickness)).sqrt()
        };
        let own = self.regions.iter().map(|region| speed(&*region.section, region.density));
        let base_used = self.of_cell.contains(&0).then(|| speed(base, density));
        reference.sound_speed = own.chain(base_used).fold(0.0, f64::max);
        (reference.masses, reference.inertias, reference.rotary) = (masses, inertias, rotary);
    }

    /// Whether stresses run linearly through the thickness everywhere.
    pub fn homogeneous(&self, base: &dyn Section) -> bool {
        let base_used = self.regions.is_empty() || self.of_cell.contains(&0);
        (!base_used || base.homogeneous()) && self.regions.iter().all(|region| region.section.homogeneous())
    }

    /// Mean thickness over the area; none for one section.
    pub fn mean_thickness(&self, base: &dyn Section, reference: &Reference) -> Option<f64> {
        if self.regions.is_empty() {
            return None;
        }
        let points = &reference.operator.points;
        let volume: f64 =
            points.iter().enumerate().map(|(p, point)| point.weight * self.read(base, p).thickness).sum();
        Some(volume / points.iter().map(|point| point.weight).sum::<f64>())
    }

    /// Turns the frames of the points to the axes of their sections, `base` being that of cells in no region.
    ///
    /// # Errors
    /// [`ShellError::Space`] for an axis that stands on the surface somewhere.
    pub fn align(&self, base: Option<Vec3>, reference: &mut Reference) -> Result<(), ShellError> {
        let rest = (0..self.of_cell.len()).filter(|&cell| self.of_cell[cell] == 0);
        if let Some(axis) = base {
            reference.operator.align_at(rest, &axis)?;
        }
        for region in &self.regions {
            if let Some(axis) = region.axis {
                reference.operator.align_at(region.cells.iter().map(|&cell| cell as usize), &axis)?;
            }
        }
        Ok(())
    }
}
