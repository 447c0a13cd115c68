//! What a shell is made of: sections and strain measures of its cells, the stress that is there before anything is strained, and heat.

use std::sync::Arc;

use shell_kinematics::{LANES, Section, SectionPack, StrainMeasure, StressedPack};

use crate::conditions::case::LoadCase;
use crate::error::ShellError;
use crate::heat::{Heat, Shares, Temperature};
use crate::initial_stress::{InitialStress, resultants_of};
use crate::points::point::PointLaw;
use crate::points::remembering::RememberingPack;
use crate::points::scheme::{Points, Scheme, Sections};
use crate::reference::Reference;
use crate::regions::{PointSection, Regions, Scales};

/// Sections, strain measures, initial stress and heat.
pub(crate) struct Material {
    /// The section, of several that of the cells in no region.
    pub section: Arc<dyn Section>,
    pub strain: &'static dyn StrainMeasure,
    pub regions: Regions,
    /// Resultants `N11, N22, N12, M11, M22, M12` of each unstrained point; empty without initial stress.
    pub stresses: Vec<[f64; 6]>,
    /// The load case to which the initial stress belongs.
    pub stress_case: LoadCase,
    /// Changes of temperature; none of a shell that is not heated.
    pub heat: Option<Heat>,
}

impl Material {
    /// Strain measure and section of points that have none of their own.
    #[inline(always)]
    pub fn law(&self) -> PointLaw<'_> {
        PointLaw { strain: self.strain, section: &*self.section, yielding: None }
    }

    /// Whether stresses run linearly through the thickness everywhere.
    pub fn homogeneous(&self) -> bool {
        self.regions.homogeneous(&*self.section)
    }

    /// Half of the thickness at each particle \[L\], the mean over its cells by area, of sections in the middle of their particles.
    ///
    /// # Errors
    /// [`ShellError`] for a shell without cells, and for sections over or below their particles.
    pub fn half_thickness(&self, reference: &Reference) -> Result<Vec<f64>, ShellError> {
        let cloud = &reference.cloud;
        if cloud.cells.is_empty() {
            return Err(ShellError::ToolWithoutCells);
        }
        let (mut volumes, mut areas) = (vec![0.0; cloud.len()], vec![0.0; cloud.len()]);
        for (number, cell) in cloud.cells.iter().enumerate() {
            let own = self.at(number);
            if own.height != 0.0 {
                return Err(ShellError::ToolOnOffset { cell: number });
            }
            let area = cell.geometry(&cloud.positions).area;
            for &a in &cell.corners[..usize::from(cell.count)] {
                volumes[a as usize] += area * own.thickness;
                areas[a as usize] += area;
            }
        }
        // A particle of no cell touches nothing.
        let half = |(volume, area): (&f64, &f64)| if *area > 0.0 { 0.5 * volume / area } else { 0.0 };
        Ok(volumes.iter().zip(&areas).map(half).collect())
    }

    /// Thickness, of several sections the mean over the area \[L\].
    pub fn thickness(&self, reference: &Reference) -> f64 {
        let mean = self.regions.mean_thickness(&*self.section, reference);
        mean.unwrap_or_else(|| self.section.scales().thickness)
    }

    /// What is read of the section at a sampling point.
    pub fn at(&self, point: usize) -> PointSection {
        let initial = self.stresses.get(point).copied().unwrap_or_default();
        PointSection { initial, ..self.regions.read(&*self.section, point) }
    }

    /// Stiffness scales of all points.
    pub fn scales(&self) -> Scales {
        self.regions.scales(&*self.section)
    }

    /// Bending stiffness of the section at a point \[F L\].
    pub fn bending(&self, point: usize) -> f64 {
        self.regions.bending(&*self.section, point)
    }

    /// Mass of a cell \[M\].
    pub fn cell_mass(&self, reference: &Reference, cell: usize) -> f64 {
        let cloud = &reference.cloud;
        let density = self.regions.density(cell).unwrap_or(reference.density);
        density * self.at(cell).thickness * cloud.cells[cell].geometry(&cloud.positions).area
    }

    /// Gives each pack of points its own sections and strain measures, where there are several, or its history, where a section has a memory.
    ///
    /// # Errors
    /// [`ShellError::OwnLaw`] for sections with a memory without cells or `under` an initial stress or heat, of which it says that it does not go with
    /// them, and under these for several of which some are not linear.
    pub fn divide(&self, points: &mut Points, under: Option<&'static str>) -> Result<(), ShellError> {
        let all = || std::iter::once(&self.section).chain(self.regions.sections());
        let remember = all().any(|section| section.memory().is_some());
        let mixed = self.regions.any() && !all().all(|section| section.linear());
        if let Some(under) = under.filter(|_| remember || mixed) {
            return Err(ShellError::OwnLaw(under));
        }
        if remember && !matches!(points.scheme, Scheme::Cells { .. }) {
            return Err(ShellError::OwnLaw("wants strains sampled in cells; use the formulation by cells"));
        }
        let order = &points.packs.order;
        if self.regions.any() {
            points.strains = self.regions.strains(self.strain, order);
        }
        if remember || mixed {
            let sections = self.regions.mixed(&self.section, order);
            points.sections = Sections::Remembering(sections.into_iter().map(RememberingPack::new).collect());
        } else if self.regions.any() {
            points.sections = Sections::Own(self.regions.packs(&*self.section, order));
        }
        Ok(())
    }

    /// Puts stresses on the unstrained shell; those of one cell add up.
    ///
    /// # Errors
    /// As [`resultants_of`].
    pub fn stress(
        &mut self,
        stresses: &[InitialStress],
        reference: &Reference,
        points: &mut Points,
    ) -> Result<(), ShellError> {
        if stresses.is_empty() {
            return Ok(());
        }
        let sums = resultants_of(stresses, reference, |cell| self.at(cell))?;
        let order = &points.packs.order;
        let sections = self.regions.packs(&*self.section, order);
        let under = |(points, section): (&[u32; LANES], SectionPack)| {
            StressedPack::new(section, points.map(|p| sums[p as usize]))
        };
        points.sections = Sections::Stressed(order.iter().zip(sections).map(under).collect());
        self.stresses = sums;
        Ok(())
    }

    /// Puts temperatures on the shell, all of them in full; those of one cell add up.
    ///
    /// # Errors
    /// As [`Heat::new`].
    pub fn warm(
        &mut self,
        temperatures: &[Temperature],
        reference: &Reference,
        points: &mut Points,
    ) -> Result<(), ShellError> {
        if temperatures.is_empty() {
            return Ok(());
        }
        let section = |cell: usize| {
            let section = self.regions.section(&self.section, cell);
            (section.expansion(), self.at(cell).height)
        };
        self.heat = Some(Heat::new(temperatures, reference, section)?);
        if !matches!(points.sections, Sections::Stressed(_)) {
            let sections = self.regions.packs(&*self.section, &points.packs.order);
            let unstressed = |section| StressedPack::new(section, [[0.0; 6]; LANES]);
            points.sections = Sections::Stressed(sections.into_iter().map(unstressed).collect());
        }
        let all = Shares { stress: 1.0, preload: 1.0, loading: 1.0 };
        points.put_stresses(|point| self.unstrained(point, &all));
        Ok(())
    }

    /// Resultants of a point that is not strained under parts of initial stress and heat, `N11, N22, N12` \[F/L\] and `M11, M22, M12` \[F\] about the
    /// particles, and what heat stores there \[F/L\].
    pub fn unstrained(&self, point: usize, shares: &Shares) -> ([f64; 6], f64) {
        let mut resultants = self.stresses.get(point).copied().unwrap_or_default();
        resultants.iter_mut().for_each(|value| *value *= shares.stress);
        let Some(heat) = &self.heat else { return (resultants, 0.0) };
        let blocked = heat.blocked(point, shares);
        resultants.iter_mut().zip(&blocked.resultants).for_each(|(value, held)| *value -= held);
        (resultants, blocked.energy)
    }
}
