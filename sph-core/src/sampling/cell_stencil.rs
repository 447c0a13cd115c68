//! The compact limit of the corrected kernel: one sampling point per cell, in closed form.

use nalgebra::{Matrix3, Vector3};

use crate::error::SpaceError;
use crate::sampling::operator::{SamplingOperator, SamplingPoint, Stencil};
use crate::surface::cell::Cell;
use crate::surface::cloud::{Cloud, check_area};
use crate::surface::frame::Frame;

/// One sampling point per cell whose stencil is the cell's three or four particles, in corner order.
///
/// With ξ, η the in-plane coordinates about the area centroid and `A = ½Σ(ξ_b η_{b+1} − ξ_{b+1} η_b)`:
/// `G₁_b = (η_{b+1} − η_{b−1})/2A`, `G₂_b = −(ξ_{b+1} − ξ_{b−1})/2A`, and φ is the least-norm change of 1/m that
/// reproduces linear fields, `φ_b = 1/m + B_bᵀ(BBᵀ)⁻¹[(1,0,0)ᵀ − (1/m)Σ_c B_c]`, `B_b = (1, ξ_b, η_b)ᵀ`.
/// This is the uniform-gradient quadrilateral of Flanagan and Belytschko \[flanagan1981\]; a constant flux sums to the edge
/// normals exactly, on any flat cloud.
pub fn cell_operator(cloud: &Cloud) -> Result<SamplingOperator, SpaceError> {
    let mut operator = SamplingOperator::empty(cloud.len());
    for (c, cell) in cloud.cells.iter().enumerate() {
        let point = cell_point(cloud, c, cell)?;
        let m = usize::from(cell.count);
        let plane: Vec<[f64; 2]> = cell
            .particles()
            .iter()
            .map(|&b| {
                let arm = cloud.positions[b as usize] - point.position;
                [arm.dot(&point.frame.t1), arm.dot(&point.frame.t2)]
            })
            .collect();
        let twice_area: f64 =
            (0..m).map(|b| plane[b][0] * plane[(b + 1) % m][1] - plane[(b + 1) % m][0] * plane[b][1]).sum();
        let mut g1 = [0.0; 4];
        let mut g2 = [0.0; 4];
        for b in 0..m {
            let (next, last) = (plane[(b + 1) % m], plane[(b + m - 1) % m]);
            g1[b] = (next[1] - last[1]) / twice_area;
            g2[b] = -(next[0] - last[0]) / twice_area;
        }
        let phi = values(&plane, twice_area.sqrt());
        let stencil = Stencil { particles: cell.particles(), phi: &phi[..m], g1: &g1[..m], g2: &g2[..m] };
        operator.push(point, 1, stencil, &[1.0; 4][..m]);
    }
    Ok(operator)
}

/// Sampling point of a cell: area centroid, mean normal, `t1` along the first edge, area.
pub(crate) fn cell_point(cloud: &Cloud, c: usize, cell: &Cell) -> Result<SamplingPoint, SpaceError> {
    let geometry = cell.geometry(&cloud.positions);
    check_area(c, cell, &cloud.positions, geometry.area)?;
    let n = geometry.normal;
    let [first, second, ..] = cell.corners.map(|b| cloud.positions[b as usize]);
    let edge = second - first;
    let t1 = (edge - n * n.dot(&edge)).normalize();
    let frame = Frame { t1, t2: n.cross(&t1), n };
    Ok(SamplingPoint { position: geometry.centroid, frame, weight: geometry.area })
}

/// φ of a cell from its in-plane corners; `size` scales lengths so that the 3×3 system is well conditioned.
fn values(plane: &[[f64; 2]], size: f64) -> [f64; 4] {
    let share = 1.0 / plane.len() as f64;
    let mut phi = [share; 4];
    let basis: Vec<Vector3<f64>> =
        plane.iter().map(|x| Vector3::new(1.0, x[0] / size, x[1] / size)).collect();
    let gram: Matrix3<f64> = basis.iter().map(|b| b * b.transpose()).sum();
    let missing = Vector3::x() - share * basis.iter().sum::<Vector3<f64>>();
    // A cell with area has a regular Gram matrix; for a triangle nothing is missing and φ stays ⅓.
    if let Some(change) = gram.cholesky().map(|factor| factor.solve(&missing)) {
        for (phi, basis) in phi.iter_mut().zip(&basis) {
            *phi += basis.dot(&change);
        }
    }
    phi
}
