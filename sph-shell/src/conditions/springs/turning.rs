//! Springs against turning: couples on directors that grow with the angle about an axis.
//!
//! φ is the angle from rest of the director's part across the axis e, with `D` the director at rest and `s = |d|² − (e·d)²`:
//!
//! ```text
//! φ = atan2(e·(D × d), D·d − (e·D)(e·d))      g = ∂φ/∂d = (e × d)/s      ∂²φ/∂d² = [e]×/s − 2 g (d − (e·d) e)ᵀ/s
//! n = −k φ g                                  ∂n/∂d = −k (g gᵀ + φ ∂²φ/∂d²)
//! ```
//!
//! g is square to d and the second derivative symmetric, so that a director keeps its length and the couple has a potential. It is the angle of
//! less than half a turn: a director that goes beyond comes back from the other side.

use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::conditions::body::{Block, Body, place_block};
use crate::error::ShellError;
use crate::packs::Row;
use crate::reference::Reference;

/// Least sine of the angle between an axis and a director at rest: about its own axis a director does not turn.
const LEAST_SINE: f64 = 0.1;

/// Springs between directors and the ground, about an axis.
#[derive(Clone, Debug)]
pub struct TurnSpring {
    /// Particles and the stiffness of each \[F L\], a moment by radian.
    pub stiffness: Vec<(u32, f64)>,
    /// Axis (any length).
    pub axis: Vec3,
}

/// Angle and its gradient at a director, and the square of the part across the axis.
fn angle(axis: &Vec3, rest: &Vec3, d: &Vec3) -> (f64, Vec3, f64) {
    let along = axis.dot(d);
    let square = d.norm_squared() - along * along;
    let angle = libm::atan2(axis.dot(&rest.cross(d)), rest.dot(d) - axis.dot(rest) * along);
    (angle, axis.cross(d) / square, square)
}

/// Refuses axes along a director at rest.
pub(super) fn check(springs: &[TurnSpring], reference: &Reference) -> Result<(), ShellError> {
    for TurnSpring { stiffness, axis } in springs {
        for &(particle, _) in stiffness {
            let sine = reference.cloud.frames[particle as usize].n.cross(&axis.normalize()).norm();
            if sine < LEAST_SINE {
                return Err(ShellError::SpringAlongDirector { particle, sine, bound: LEAST_SINE });
            }
        }
    }
    Ok(())
}

/// Hands every particle with a spring, the stiffness, the axis, and the director at rest and in the present to `visit`.
fn each(springs: &[TurnSpring], body: &Body<'_>, mut visit: impl FnMut(u32, f64, &Vec3, [&Vec3; 2])) {
    for TurnSpring { stiffness, axis } in springs {
        for &(a, k) in stiffness {
            let row = &body.state[a as usize];
            let d = Vec3::new(row[3], row[4], row[5]);
            visit(a, k, axis, [&body.reference.cloud.frames[a as usize].n, &d]);
        }
    }
}

/// Adds the couples on directors to the rows of particles.
pub(super) fn add(springs: &[TurnSpring], body: &Body<'_>, rows: &mut [Row]) {
    each(springs, body, |a, k, axis, [rest, d]| {
        let (angle, gradient, _) = angle(axis, rest, d);
        (0..3).for_each(|i| rows[a as usize][3 + i] -= k * angle * gradient[i]);
    });
}

/// Hands their derivatives to `put`.
pub(super) fn stiffness(springs: &[TurnSpring], body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
    each(springs, body, |a, k, axis, [rest, d]| {
        let (angle, gradient, square) = angle(axis, rest, d);
        let across = d - axis * axis.dot(d);
        let second: Matrix3<f64> =
            axis.cross_matrix() / square - gradient * across.transpose() * (2.0 / square);
        let change = (gradient * gradient.transpose() + second * angle) * -k;
        put(a, a, &place_block(3, 3, &change));
    });
}
