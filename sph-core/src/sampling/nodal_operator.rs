//! Nodal operator: sampling at the particles themselves, gradients by least squares through the particle.

use crate::error::SpaceError;
use crate::kernel::Kernel;
use crate::neighbours::CellList;
use crate::sampling::correction::{Correction, Shape, ThroughParticle};
use crate::sampling::kernel_operator::{GROWTH, GROWTH_STEPS, RIM, Search};
use crate::sampling::operator::{SamplingOperator, SamplingPoint, Stencil};
use crate::surface::cloud::Cloud;

/// Sampling points at the particles, gradients exact on polynomials of `order` 1, 2 or 3 in the tangent plane.
///
/// Smoothing length `h_a = smoothing × Δ_a`, `Δ_a` = root of the mean area of the cells at a (a triangle is
/// half a cell). Weights are `W A_b`
/// (order 1: `−W'/r · A_b` \[chen1999\]). The first entry of a stencil is the particle itself, the others ascend. The
/// support grows by 1.1 until there are enough neighbours (2, 5, 9) and the moment matrix has a condition number
/// below 1e7; if it never does, the order falls. Boundary particles see one side only and get order 2 at most.
/// The orders reached are in [`SamplingOperator::orders`].
pub fn nodal_operator(
    cloud: &Cloud,
    kernel: &dyn Kernel,
    order: usize,
    smoothing: f64,
) -> Result<SamplingOperator, SpaceError> {
    let wanted = ThroughParticle::new(order)?;
    if !(smoothing > 0.0 && smoothing.is_finite()) {
        return Err(SpaceError::OutOfRange { what: "smoothing", value: smoothing, bound: "(0, ∞)" });
    }
    if cloud.len() < wanted.needed() {
        let (found, needed) = (cloud.len(), wanted.needed());
        return Err(SpaceError::TooFew { what: "particles in the cloud", found, needed });
    }
    cloud.check_apart(|_, _| false)?;
    let list = CellList::new(&cloud.positions, kernel.support() * smoothing * cloud.spacing());
    let spacings = local_spacings(cloud);
    let mut operator = SamplingOperator::empty(cloud.len());
    let mut search = Search::default();
    for a in 0..cloud.len() {
        let highest = if cloud.edge_lengths[a] > 0.0 { order.min(2) } else { order };
        let h = smoothing * spacings[a];
        let mut found = None;
        for order in (1..=highest).rev() {
            let correction = ThroughParticle::new(order)?;
            found = grow(cloud, kernel, &list, a, &correction, h, &mut search);
            if found.is_some() {
                break;
            }
        }
        let Some((reached, shape)) = found else {
            let radius = kernel.support() * h * GROWTH.powi(GROWTH_STEPS as i32);
            let neighbours = search.particles.len().saturating_sub(1);
            return Err(SpaceError::Undetermined { point: a, neighbours, radius, order: 1 });
        };
        let point =
            SamplingPoint { position: cloud.positions[a], frame: cloud.frames[a], weight: cloud.areas[a] };
        let stencil = Stencil { particles: &search.particles, phi: &shape.phi, g1: &shape.g1, g2: &shape.g2 };
        operator.push(point, reached, stencil, &search.weights);
    }
    Ok(operator)
}

/// Shape numbers of particle `a` with the smallest support, from `h` on, that determines them; the stencil is left in
/// `search`, with kernel weights.
fn grow(
    cloud: &Cloud,
    kernel: &dyn Kernel,
    list: &CellList,
    a: usize,
    correction: &ThroughParticle,
    first: f64,
    search: &mut Search,
) -> Option<(u8, Shape)> {
    let (centre, frame) = (&cloud.positions[a], &cloud.frames[a]);
    let mut h = first;
    for _ in 0..=GROWTH_STEPS {
        list.within(centre, RIM * kernel.support() * h, &mut search.particles);
        // The particle itself goes first; its weight does not enter the least squares, any positive number keeps it.
        search.particles.retain(|&b| b as usize != a);
        search.particles.insert(0, a as u32);
        search.measure(cloud, centre, &frame.t1, &frame.t2, |r, b| {
            if r == 0.0 {
                kernel.value(0.0)
            } else {
                correction.weight(kernel, r, h) * cloud.areas[b as usize]
            }
        });
        if let Some(shape) = correction.shape(&search.neighbourhood(h)) {
            search.measure(cloud, centre, &frame.t1, &frame.t2, |r, _| kernel.value(r / h));
            return Some((correction.order(), shape));
        }
        h *= GROWTH;
    }
    None
}

/// Root of the mean area of the cells at each particle `[L]`, a triangle counting as half a cell; of the particle's own
/// area where there are no cells.
fn local_spacings(cloud: &Cloud) -> Vec<f64> {
    let areas: Vec<f64> = cloud.cells.iter().map(|cell| cell.geometry(&cloud.positions).area).collect();
    let halves = |c: u32| f64::from(cloud.cells[c as usize].count - 2);
    let mean = |cells: &[u32]| {
        let area: f64 = cells.iter().map(|&c| areas[c as usize]).sum();
        2.0 * area / cells.iter().map(|&c| halves(c)).sum::<f64>()
    };
    cloud
        .cells_at_particles()
        .iter()
        .zip(&cloud.areas)
        .map(|(cells, own)| if cells.is_empty() { own.sqrt() } else { mean(cells).sqrt() })
        .collect()
}
