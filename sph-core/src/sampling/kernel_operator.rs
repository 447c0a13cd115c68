//! Stress-point operator with a corrected kernel: one sampling point per cell, particles within a chosen reach.

use crate::Vec3;
use crate::error::SpaceError;
use crate::kernel::Kernel;
use crate::neighbours::CellList;
use crate::sampling::cell_stencil::cell_point;
use crate::sampling::correction::{Correction, LinearlyExact, Neighbourhood};
use crate::sampling::operator::{SamplingOperator, Stencil};
use crate::surface::cloud::Cloud;

/// Factor by which a support grows while its particles do not determine the shape numbers.
pub(crate) const GROWTH: f64 = 1.1;

/// Growth steps before giving up: 1.1²⁰ ≈ 6.7 times the first support.
pub(crate) const GROWTH_STEPS: usize = 20;

/// Sampling points at the cells, with linearly exact kernel stencils \[belytschko1996\] of radius `reach` × r₄.
///
/// r₄ is the distance from the point to its fourth nearest particle, so the support follows the local spacing.
/// `reach` = 1.4 holds the four corners on a lattice; disordered clouds want 1.8 and a divergence-consistent
/// correction. The support grows by 1.1 while there are fewer than four particles or the moment matrix has a
/// condition number above 1e7. Sheets closer than the support see each other: there is no visibility filter.
pub fn kernel_operator(
    cloud: &Cloud,
    kernel: &dyn Kernel,
    reach: f64,
) -> Result<SamplingOperator, SpaceError> {
    if !(reach > 0.0 && reach.is_finite()) {
        return Err(SpaceError::OutOfRange { what: "reach", value: reach, bound: "(0, ∞)" });
    }
    if cloud.len() < LinearlyExact.needed() {
        let (found, needed) = (cloud.len(), LinearlyExact.needed());
        return Err(SpaceError::TooFew { what: "particles in the cloud", found, needed });
    }
    cloud.check_apart(|_, _| false)?;
    let list = CellList::new(&cloud.positions, 1.5 * cloud.spacing());
    let mut search = Search::default();
    let mut operator = SamplingOperator::empty(cloud.len());
    for (p, cell) in cloud.cells.iter().enumerate() {
        let point = cell_point(cloud, p, cell)?;
        let mut radius = reach * list.nearest(&point.position, 4);
        let mut steps = 0;
        let shape = loop {
            let h = radius / kernel.support();
            list.within(&point.position, RIM * radius, &mut search.particles);
            search.measure(cloud, &point.position, &point.frame.t1, &point.frame.t2, |r, _| {
                LinearlyExact.weight(kernel, r, h)
            });
            if let Some(shape) = LinearlyExact.shape(&search.neighbourhood(h)) {
                break shape;
            }
            if steps == GROWTH_STEPS {
                let neighbours = search.particles.len();
                return Err(SpaceError::Undetermined { point: p, neighbours, radius, order: 1 });
            }
            radius *= GROWTH;
            steps += 1;
        };
        let stencil = Stencil { particles: &search.particles, phi: &shape.phi, g1: &shape.g1, g2: &shape.g2 };
        operator.push(point, 1, stencil, &search.weights);
    }
    Ok(operator)
}

/// Part of the support in which neighbours are looked for: on a lattice whole rings of particles can lie on the rim,
/// where their weight is zero and round-off would decide which of them belong to the stencil.
pub(crate) const RIM: f64 = 1.0 - 1e-9;

/// Neighbours of one point and their coordinates; kept between points to save allocations.
#[derive(Default)]
pub(crate) struct Search {
    pub particles: Vec<u32>,
    pub xi: Vec<f64>,
    pub eta: Vec<f64>,
    pub weights: Vec<f64>,
}

impl Search {
    /// Coordinates and weights of `particles` about `centre`; drops those of weight zero.
    ///
    /// `weigh` sees the distance `[L]` and the particle.
    pub(crate) fn measure(
        &mut self,
        cloud: &Cloud,
        centre: &Vec3,
        t1: &Vec3,
        t2: &Vec3,
        weigh: impl Fn(f64, u32) -> f64,
    ) {
        self.xi.clear();
        self.eta.clear();
        self.weights.clear();
        self.particles.retain(|&b| {
            let arm = cloud.positions[b as usize] - centre;
            let weight = weigh(arm.norm(), b);
            if weight > 0.0 {
                self.xi.push(arm.dot(t1));
                self.eta.push(arm.dot(t2));
                self.weights.push(weight);
            }
            weight > 0.0
        });
    }

    /// The neighbourhood in coordinates of scale `h` `[L]`.
    pub(crate) fn neighbourhood(&self, h: f64) -> Neighbourhood<'_> {
        Neighbourhood { xi: &self.xi, eta: &self.eta, weights: &self.weights, scale: h }
    }
}
