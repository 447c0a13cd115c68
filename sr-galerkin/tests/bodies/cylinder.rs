//! A quarter of a thick cylinder in plane strain under a pressure from within: planes of symmetry on its cuts and on its ends.

use sph_core::{Support, Vec3};
use sr_galerkin::{Condition, Galerkin, Load, Mirror, Parts};

use super::{block, nodes};

/// Inner and outer radius.
pub const RADII: [f64; 2] = [1.0, 2.0];
/// Cells along the quarter over those across.
const ALONG: f64 = 1.5;

/// The cylinder, E = 1, so many cells across; its pressure is one at level one.
pub fn cylinder(across: usize) -> Parts {
    let [inner, outer] = RADII;
    let quarter = std::f64::consts::FRAC_PI_2;
    let along = (ALONG * across as f64) as usize;
    let spacing = outer * quarter / along as f64;
    let long = spacing;
    let mut parts = block([quarter, long, outer - inner], [along + 1, 2, across + 1], 0.0);
    let map = |x: &Vec3| {
        let r = inner + x.z;
        Vec3::new(r * libm::sin(x.x), x.y, r * libm::cos(x.x))
    };
    parts.nodes.iter_mut().chain(&mut parts.cells.corners).for_each(|x| *x = map(x));
    parts.support = Support::ellipsoid([2.5 * spacing; 3]);
    for (axis, at) in [(0, 0.0), (2, 0.0), (1, 0.0), (1, long)] {
        let normal = Vec3::ith(axis, 1.0);
        let on = nodes(&parts, |x| (x[axis] - at).abs() < 1e-9);
        parts.conditions.push(Condition::held(on, normal));
        parts.mirrors.push(Mirror { point: normal * at, normal });
    }
    let faces = parts.cells.faces[4].clone();
    parts.loads.push(Load::Pressure { faces, pressure: 1.0 });
    parts
}

/// Radius of a place.
pub fn radius(x: &Vec3) -> f64 {
    libm::hypot(x.x, x.z)
}

/// Mean radial displacement of the nodes on a radius.
pub fn widened(body: &Galerkin, at: f64) -> f64 {
    let rest = body.rest();
    let on: Vec<usize> = (0..rest.len()).filter(|&a| (radius(&rest[a]) - at).abs() < 1e-9).collect();
    let along = |&a: &usize| {
        let (x, u) = (rest[a], body.displacement(a));
        (u.x * x.x + u.z * x.z) / at
    };
    on.iter().map(along).sum::<f64>() / on.len() as f64
}
