//! Which cells of the host a particle hangs on, and how.
//!
//! On a line of the host several cells are equally near. One of them alone would see one side of the line only, and rounding would choose
//! it: the particle hangs on the mean of all. Cell c, with normal n_c, counts with the weight
//!
//! ```text
//! λ_c = s_c²/Σs²,  Σφx, x,α ← Σ λ_c (…)_c        s_c = n_c·v,  v the first axis of Σ n_c n_cᵀ
//! w_c = s_c/Σs²,   m, d,α  ← Σ w_c (…)_c
//! ```
//!
//! Cells of one smooth sheet count alike, whichever way their normals point; a face across two that are one sheet does not count; two faces of a
//! fold count alike, with their bisector for v. Nothing of it depends on the numbers of cells or on axes.

use nalgebra::{Matrix3, SymmetricEigen};
use sph_core::{Cell, Frame, Vec3};

use crate::reference::Reference;
use crate::ties::hanging::{Hanging, Share};

/// Steps of Newton's method within which a place over a cell is found to rounding.
const STEPS: usize = 12;

/// Rounding of places on a cell, in parts of it.
const ROUND_OFF: f64 = 1e-12;

/// Part of the size of a cell by which it may be farther away than another and still be as near: places of files in single precision are rounded by
/// less, and a tie so near to a line sees both sides of it.
const AS_NEAR: f64 = 1e-5;

/// Weight below which a cell does not count: a face across the others, but for rounding.
const NO_WEIGHT: f64 = 1e-12;

/// Weight of the directors and of the line of what hangs where normals alone give no first axis, as two faces at right angles do.
const LEAN: f64 = 1e-3;

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

/// The cells of some that are nearest to a particle, all those that are equally near.
pub(super) fn nearest(reference: &Reference, cells: &[u32], particle: usize) -> Vec<Place> {
    let x = reference.cloud.positions[particle];
    let (mut least, mut found) = (f64::INFINITY, Vec::<(Place, f64)>::new());
    for &cell in cells {
        let [away, reach] = extent(reference, cell, &x);
        let slack = AS_NEAR * reach;
        if away <= least + slack
            && let Some(place) = over(reference, cell, &x).filter(|place| place.distance <= least + slack)
        {
            least = least.min(place.distance);
            found.push((place, slack));
        }
    }
    found
        .into_iter()
        .filter(|(place, slack)| place.distance <= least + slack)
        .map(|(place, _)| place)
        .collect()
}

/// No point of a cell is nearer to x than the first \[L\]; the second is how far it reaches \[L\].
fn extent(reference: &Reference, cell: u32, x: &Vec3) -> [f64; 2] {
    let positions = &reference.cloud.positions;
    let corners = reference.cloud.cells[cell as usize].corners.map(|b| positions[b as usize]);
    let reach = corners.iter().map(|corner| (corner - corners[0]).norm()).fold(0.0, f64::max);
    [(x - corners[0]).norm() - reach, reach]
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
    /// Whether the particle stands over a corner of the cell.
    pub fn at_a_corner(&self) -> bool {
        self.phi.iter().any(|phi| (phi - 1.0).abs() < AS_NEAR)
    }
}

/// The normal that cells have in common, for particles that hang on them together, by an edge along a line.
fn common_normal(reference: &Reference, places: &[Place], together: &[u32], line: &Vec3) -> Vec3 {
    let normal = |place: &Place| reference.operator.points[place.cell as usize].frame.n;
    if let [place] = places {
        return normal(place);
    }
    let square = |v: Vec3| v * v.transpose();
    let directors = together.iter().map(|&b| square(reference.cloud.frames[b as usize].n));
    let lean = directors.sum::<Matrix3<f64>>() - square(line.try_normalize(0.0).unwrap_or_default());
    let normals = places.iter().map(|place| square(normal(place)));
    let axes = SymmetricEigen::new(normals.sum::<Matrix3<f64>>() + lean * LEAN);
    axes.eigenvectors.column(axes.eigenvalues.imax()).into()
}

/// Particles that hang together on some cells, by an edge that runs along a line.
pub(super) fn hang(reference: &Reference, places: &[Place], together: &[u32], line: &Vec3) -> Vec<Hanging> {
    let (cloud, operator) = (&reference.cloud, &reference.operator);
    let rest = reference.rest();
    let n = common_normal(reference, places, together, line);
    let frame = match places {
        [place] => operator.points[place.cell as usize].frame,
        _ => Frame::from_normal(n),
    };
    let tangents = [frame.t1, frame.t2];
    let cosines: Vec<f64> =
        places.iter().map(|place| operator.points[place.cell as usize].frame.n.dot(&n)).collect();
    let squares: f64 = cosines.iter().map(|s| s * s).sum();
    let mut on = Hanging::default();
    for (place, s) in places.iter().zip(cosines) {
        let [of_x, of_d] = [s * s / squares, s / squares];
        if of_x < NO_WEIGHT {
            continue;
        }
        on.cells.push((place.cell, of_x));
        let (own, stencil) =
            (&operator.points[place.cell as usize].frame, operator.stencil(place.cell as usize));
        for (&b, phi) in cloud.cells[place.cell as usize].particles().iter().zip(place.phi) {
            let k = stencil.particles.iter().position(|&c| c == b).unwrap_or(0);
            let gradient = own.t1 * stencil.g1[k] + own.t2 * stencil.g2[k];
            let [g1, g2] = tangents.map(|t| t.dot(&gradient));
            let i = on.corners.iter().position(|&c| c == b).unwrap_or_else(|| {
                on.corners.push(b);
                on.shares.push(Share::default());
                on.corners.len() - 1
            });
            let Share { x, d, height } = &mut on.shares[i];
            x.iter_mut().zip([phi, g1, g2]).for_each(|(sum, part)| *sum += of_x * part);
            d.iter_mut().zip([phi, g1, g2]).for_each(|(sum, part)| *sum += of_d * part);
            *height += of_x * place.height * phi;
        }
    }
    let foot = on.foot(&rest);
    for (&b, share) in on.corners.iter().zip(&on.shares) {
        let arm = cloud.positions[b as usize] - foot;
        let [xi, eta] = tangents.map(|t| arm.dot(&t));
        let products = [xi * xi, eta * eta, xi * eta];
        on.half_moments
            .iter_mut()
            .zip(products)
            .for_each(|(sum, product)| *sum += 0.5 * share.x[0] * product);
    }
    on.chord = on.rise(&on.vectors(&rest));
    let hung = |&particle: &u32| {
        let director = cloud.frames[particle as usize].n;
        // A single particle has no line: it turns with the trace of its own sheet. A director along the normal turns with any.
        let lies = n.cross(line).norm() > LEAST_SINE * line.norm();
        let line = if lies { *line } else { n.cross(&director).try_normalize(0.0).unwrap_or(frame.t1) };
        let mut hanging = Hanging { particle, line: tangents.map(|t| t.dot(&line)), ..on.clone() };
        hanging.director = hanging.components(&rest, &director);
        hanging
    };
    together.iter().map(hung).collect()
}
