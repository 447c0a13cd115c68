//! Which cell of the host a particle hangs on, and how.

use nalgebra::Matrix3;
use sph_core::{Cell, Vec3};

use crate::reference::Reference;
use crate::ties::hanging::Hanging;

/// Steps of Newton's method within which a place over a cell is found to rounding.
const STEPS: usize = 12;

/// Rounding of places on a cell, in parts of it.
const ROUND_OFF: f64 = 1e-12;

/// Least sine of the angle between an edge and the normal of its host at which the edge has a direction there.
const LEAST_SINE: f64 = 0.1;

/// A place over a cell: `Σ φ_b (X_b + h D_b)`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub cell: u32,
    phi: [f64; 4],
    /// h \[L\].
    height: f64,
    /// From the particle to the nearest point of the cell \[L\].
    pub distance: f64,
}

/// Bilinear numbers of a quadrangle, or linear ones of a triangle, at coordinates that run from 0 to 1, and their derivatives.
fn numbers(count: u8, [u, v]: [f64; 2]) -> [[f64; 4]; 3] {
    if count == 3 {
        return [[1.0 - u - v, u, v, 0.0], [-1.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 1.0, 0.0]];
    }
    let (p, q) = (1.0 - u, 1.0 - v);
    [[p * q, u * q, u * v, p * v], [-q, q, v, -v], [-p, -u, u, p]]
}

/// The coordinates moved into the cell.
fn inside(count: u8, [u, v]: [f64; 2]) -> [f64; 2] {
    let [u, v] = [u.clamp(0.0, 1.0), v.clamp(0.0, 1.0)];
    let over = if count == 3 { (u + v - 1.0).max(0.0) / 2.0 } else { 0.0 };
    [(u - over).max(0.0), (v - over).max(0.0)]
}

/// The cell of some that is nearest to a particle; of equally near ones the first.
pub(super) fn nearest(reference: &Reference, cells: &[u32], particle: usize) -> Option<Place> {
    let x = reference.cloud.positions[particle];
    let mut best: Option<Place> = None;
    for &cell in cells {
        let least = best.map_or(f64::INFINITY, |best| best.distance * (1.0 - ROUND_OFF));
        if beyond(reference, cell, &x) < least
            && let Some(place) = over(reference, cell, &x).filter(|place| place.distance < least)
        {
            best = Some(place);
        }
    }
    best
}

/// No point of a cell is nearer to x than this \[L\].
fn beyond(reference: &Reference, cell: u32, x: &Vec3) -> f64 {
    let positions = &reference.cloud.positions;
    let corners = reference.cloud.cells[cell as usize].corners.map(|b| positions[b as usize]);
    let reach = corners.iter().map(|corner| (corner - corners[0]).norm()).fold(0.0, f64::max);
    (x - corners[0]).norm() - reach
}

/// The place of x over a cell, along the directors; none where they do not lead there.
fn over(reference: &Reference, cell: u32, x: &Vec3) -> Option<Place> {
    let cloud = &reference.cloud;
    let Cell { corners, count } = cloud.cells[cell as usize];
    let at = |numbers: &[f64; 4], height: f64| -> Vec3 {
        let corner = |b: u32| cloud.positions[b as usize] + cloud.frames[b as usize].n * height;
        numbers.iter().zip(corners).map(|(phi, b)| corner(b) * *phi).sum()
    };
    let start = if count == 3 { 1.0 / 3.0 } else { 0.5 };
    let (mut uv, mut height) = ([start; 2], 0.0);
    for _ in 0..STEPS {
        let [phi, du, dv] = numbers(count, uv);
        let normal: Vec3 = phi.iter().zip(corners).map(|(phi, b)| cloud.frames[b as usize].n * *phi).sum();
        let slopes = Matrix3::from_columns(&[at(&du, height), at(&dv, height), normal]);
        let step = slopes.lu().solve(&(x - at(&phi, height)))?;
        uv = [uv[0] + step.x, uv[1] + step.y];
        height += step.z;
        if step.x.abs() + step.y.abs() < ROUND_OFF {
            break;
        }
    }
    let [phi, ..] = numbers(count, uv);
    let size = cloud.cells[cell as usize].geometry(&cloud.positions).area.sqrt();
    let found = (at(&phi, height) - x).norm() < 1e-9 * size;
    let [nearest, ..] = numbers(count, inside(count, uv));
    found.then(|| Place { cell, phi, height, distance: (at(&nearest, 0.0) - x).norm() })
}

impl Place {
    /// A particle of an edge that runs along a line, and hangs here.
    pub fn hang(&self, reference: &Reference, particle: usize, line: &Vec3) -> Hanging {
        let (cloud, operator) = (&reference.cloud, &reference.operator);
        let cell = &cloud.cells[self.cell as usize];
        let (frame, stencil) =
            (operator.points[self.cell as usize].frame, operator.stencil(self.cell as usize));
        let corners = cell.particles().to_vec();
        let x: Vec3 = corners.iter().zip(self.phi).map(|(&b, phi)| cloud.positions[b as usize] * phi).sum();
        let (mut shares, mut half_moments) = (Vec::new(), [0.0; 3]);
        for (&b, phi) in corners.iter().zip(self.phi) {
            let own = stencil.particles.iter().position(|&c| c == b).unwrap_or(0);
            shares.push([phi, stencil.g1[own], stencil.g2[own]]);
            let arm = cloud.positions[b as usize] - x;
            let [xi, eta] = [frame.t1, frame.t2].map(|t| arm.dot(&t));
            let products = [xi * xi, eta * eta, xi * eta];
            half_moments.iter_mut().zip(products).for_each(|(sum, product)| *sum += 0.5 * phi * product);
        }
        let (director, particle, cell) = (Vec3::zeros(), particle as u32, self.cell);
        // A single particle has no line: it turns with the first axis of the cell.
        let lies = frame.n.cross(line).norm() > LEAST_SINE * line.norm();
        let line = if lies { [frame.t1.dot(line), frame.t2.dot(line)] } else { [1.0, 0.0] };
        let mut hanging =
            Hanging { particle, cell, corners, shares, half_moments, height: 0.0, line, director };
        let rest = reference.rest();
        hanging.height = self.height - hanging.rise(&hanging.vectors(&rest));
        hanging.director = hanging.components(&rest, &cloud.frames[particle as usize].n);
        hanging
    }
}
