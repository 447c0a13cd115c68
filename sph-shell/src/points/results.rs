//! What can be read at the sampling points: strains, resultants, the directions they refer to.

use std::any::Any;

use shell_kinematics::{LANES, LayeredSection, Pack, PlasticSection, Section, laminate_of};
use sph_core::Vec3;

use crate::Shell;
use crate::points::point::{Point, PointState};

/// Strains and resultants of one sampling point.
///
/// Components refer to the orthonormal frame of the point in the reference configuration; forces and moments are per
/// reference length, moments about the surface of the particles, and conjugate to the strains: `N·e + M·κ + Q·γ` is the work per reference area, for a linear
/// section twice the stored energy.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointResult {
    /// Membrane strains `e11, e22, 2e12` \[–\].
    pub membrane: [f64; 3],
    /// Changes of curvature `κ11, κ22, 2κ12` \[1/L\].
    pub curvature: [f64; 3],
    /// Transverse shear strains `γ1, γ2` \[–\].
    pub shear: [f64; 2],
    /// Membrane forces `N11, N22, N12` \[F/L\].
    pub force: [f64; 3],
    /// Moments `M11, M22, M12` \[F\].
    pub moment: [f64; 3],
    /// Transverse shear forces `Q1, Q2` \[F/L\].
    pub shear_force: [f64; 2],
    /// Where the first direction of the frame points now (unit vector): `x,1/|x,1|`.
    pub t1: [f64; 3],
}

/// What a sampling point whose section yields has gone through, as its history was committed last.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Yielded {
    /// Greatest equivalent plastic strain of its slices \[–\].
    pub plastic_strain: f64,
    /// Thickness over thickness at rest \[–\].
    pub thickness: f64,
    /// Share of the thickness that has ever flowed \[–\].
    pub share: f64,
    /// Work dissipated a reference area \[F/L\].
    pub dissipated: f64,
    /// Work stored by hardening a reference area, by convention \[F/L\].
    pub hardened: f64,
    /// Work done on the control of zero-energy modes of the cell \[F L\].
    pub control: f64,
    /// Area at rest \[L²\].
    pub area: f64,
}

impl Shell {
    /// Its sections that yield, that of cells in no region first.
    pub fn plastic_sections(&self) -> impl Iterator<Item = &PlasticSection> {
        let all = std::iter::once(&self.material.section).chain(self.material.regions.sections());
        all.filter_map(|section| (&**section as &dyn Any).downcast_ref())
    }

    /// The section of a sampling point, if that yields.
    pub fn plastic_section_at(&self, point: usize) -> Option<&PlasticSection> {
        let section = self.material.regions.section(&self.material.section, point);
        (&**section as &dyn Any).downcast_ref()
    }

    /// The plies of the section of a sampling point; none of one whose stresses do not follow from its strains.
    pub fn laminate(&self, point: usize) -> Option<LayeredSection> {
        laminate_of(&**self.material.regions.section(&self.material.section, point))
    }

    /// The number of the section of a sampling point: points of one number have one section.
    pub fn section_number(&self, point: usize) -> usize {
        self.material.regions.number(point)
    }

    /// Greatest membrane stiffness of the section at a sampling point in any direction \[F/L\].
    pub fn stretch_stiffness(&self, point: usize) -> f64 {
        self.material.regions.section(&self.material.section, point).scales().membrane
    }

    /// What each sampling point has gone through, in the order of the reference's `operator.points`, nothing where its section does not yield; empty
    /// where none does.
    pub fn yielded(&self) -> Vec<Yielded> {
        let histories = self.points.sections.histories();
        let points = &self.reference.operator.points;
        let mut out = Vec::new();
        for (pack, of) in histories.iter().zip(&self.points.packs.order) {
            let Some(flowed) = pack.section.flowed() else { continue };
            if out.is_empty() {
                let nothing = |area| Yielded { thickness: 1.0, area, ..Yielded::default() };
                out = points.iter().map(|point| nothing(point.weight)).collect();
            }
            let found = [
                flowed.plastic_strain,
                flowed.thickness,
                flowed.share,
                flowed.dissipated,
                flowed.hardened,
                pack.control.work(),
            ]
            .map(Pack::lanes);
            for (lane, &point) in of.iter().enumerate() {
                let [plastic_strain, thickness, share, dissipated, hardened, control] =
                    found.map(|of| of[lane]);
                let area = points[point as usize].weight;
                out[point as usize] =
                    Yielded { plastic_strain, thickness, share, dissipated, hardened, control, area };
            }
        }
        out
    }

    /// Work done on all points and on the control of their cells until the present state, of a shell whose section has a memory \[F L\]; zero of another.
    pub fn internal_work(&self) -> f64 {
        let mut sum = 0.0;
        for (index, own) in self.points.sections.histories().iter().enumerate() {
            let point = self.points.point(index);
            let PointState { strains, control, .. } = self.strained(&point);
            sum += (own.section.energy(&strains) * point.pack.weight).sum();
            if let Some((cell, hourglass)) = &control {
                sum += own.control.pulls(cell.stiffnesses(), hourglass.components()).1.sum();
            }
        }
        sum
    }

    /// Four points in the present state.
    fn strained(&self, point: &Point<'_>) -> PointState {
        let strain = point.strain.unwrap_or(self.material.strain);
        point.treated().strained::<true, _>(strain, &self.motion.state)
    }

    /// The section of four points.
    pub(crate) fn section_of<'a>(&'a self, point: &Point<'a>) -> &'a dyn Section {
        point.section.unwrap_or(&*self.material.section)
    }

    /// Evaluates strains and resultants of the present state, one entry of `out` a sampling point, in the order of
    /// the reference's `operator.points`: the cells of the cloud, or for nodal sampling and the strong form the
    /// particles. Surplus entries and surplus points are left alone. Nothing is allocated and no state is changed.
    pub fn point_results(&self, out: &mut [PointResult]) {
        for (index, points) in self.points.packs.order.iter().enumerate() {
            let point = self.points.point(index);
            let PointState { placement: p, strains, .. } = self.strained(&point);
            let stress = self.section_of(&point).resultants(&strains);
            for (lane, &point) in points.iter().enumerate().take(LANES) {
                // Filling lanes repeat the last point: the same numbers once more.
                let Some(result) = out.get_mut(point as usize) else { continue };
                let three = |values: &[Pack; 3]| values.map(|v| v.lanes()[lane]);
                let two = |values: &[Pack; 2]| values.map(|v| v.lanes()[lane]);
                *result = PointResult {
                    membrane: three(&strains.membrane),
                    curvature: three(&strains.curvature),
                    shear: two(&strains.shear),
                    force: three(&stress.membrane),
                    moment: three(&stress.moment),
                    shear_force: two(&stress.shear),
                    t1: Vec3::from(p.x1.lane(lane)).normalize().into(),
                };
            }
        }
    }
}
