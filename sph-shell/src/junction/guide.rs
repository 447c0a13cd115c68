//! A body whose reference point is held or moved along some directions, beside its centre of mass.
//!
//! Centre c, reference point `p = c + r`, `r = Q R`; N projects on the held directions. The unknowns of a body are u, the displacement of the
//! centre along the free directions and of the reference point along the held ones, and a rotation:
//!
//! ```text
//! motion    v_c = u − N (ω × r),   v_p = u + (1 − N)(ω × r)          N u = 0 unless supports move the body
//! torque    τ − r × N F            conjugate to ω with u, from τ about the centre
//! masses    ½m|u|² + ½ω·(J_c + m [r]×ᵀ N [r]×) ω                     u and ω do not meet where N u = 0
//! variation of F·c along a rotation: −[½(N F rᵀ + r Fᵀ N) − (N F·r) 1], to be added to the terms of the arms
//! ```
//!
//! Without supports N = 0 and the body goes by its centre; where all is held N = 1 and it turns about its reference point. In modes this tensor
//! of inertia gives the axes of the unknowns; it changes with the triad, and marches use the centre and a constraint instead (`march.rs`).

use explicit_dynamics::Instant;
use nalgebra::{Matrix3, SymmetricEigen};
use sph_core::Vec3;

use crate::conditions::case::LoadCase;
use crate::conditions::prescribed_at::Prescribed;
use crate::conditions::supports::Constraint;
use crate::junction::group::{Group, director, place};
use crate::junction::rotation::turned;
use crate::packs::Row;

/// What holds a body: where its reference point is from the centre, and along which directions it is held.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lever {
    /// Arm r from the centre to the reference point \[L\].
    pub arm: Vec3,
    /// Projector N on the held directions.
    pub held: Matrix3<f64>,
}

impl Lever {
    /// `r × N F`: what the support along the held directions takes of a torque about the centre.
    pub fn torque(&self, force: &Vec3) -> Vec3 {
        self.arm.cross(&(self.held * force))
    }
}

impl Group {
    /// What holds its reference point; nothing for a free body and for a group on one place.
    pub fn lever(&self, state: &[Row]) -> Option<Lever> {
        let body = self.body.as_ref().filter(|body| body.held != Matrix3::zeros())?;
        Some(Lever { arm: body.arm(&self.triad(state)), held: body.held })
    }

    /// Force and torque about the pole as what is conjugate to the unknowns.
    pub fn along_unknowns(&self, state: &[Row], row: Row) -> Row {
        let Some(lever) = self.lever(state) else { return row };
        let torque = director(&row) - lever.torque(&place(&row));
        [row[0], row[1], row[2], torque.x, torque.y, torque.z]
    }

    /// Velocity and spin of the pole for rates `[u, ω]` of the unknowns.
    pub fn of_pole(&self, state: &[Row], motion: Row) -> Row {
        let Some(Lever { arm, held }) = self.lever(state) else { return motion };
        let v = place(&motion) - held * director(&motion).cross(&arm);
        [v.x, v.y, v.z, motion[3], motion[4], motion[5]]
    }

    /// Way of the pole as the unknowns go by u and turn by the rotation vector θ: the reference point stays where it is held.
    pub fn way_of_pole(&self, state: &[Row], u: &Vec3, theta: &Vec3) -> Vec3 {
        let (Some(lever), Some(body)) = (self.lever(state), &self.body) else { return *u };
        u - lever.held * (body.arm(&turned(&self.triad(state), theta)) - lever.arm)
    }

    /// Rotary inertia of modes of a body about an axis through what holds it \[M L²\].
    pub fn modal_about(&self, state: &[Row], axis: &Vec3) -> Option<f64> {
        let own = self.body.as_ref()?.modal.about(&self.triad(state), axis);
        let swung = self
            .lever(state)
            .map_or(0.0, |Lever { arm, held }| self.mass * (held * axis.cross(&arm)).norm_squared());
        Some(own + swung)
    }

    /// Directions of the rotations of modes: present principal axes of that inertia, nearest to those that turn with the body.
    pub fn turning_axes(&self, state: &[Row]) -> Matrix3<f64> {
        let axes = self.principal_axes(state);
        let (Some(lever), Some(body)) = (self.lever(state), &self.body) else { return axes };
        let cross = lever.arm.cross_matrix();
        let triad = self.triad(state);
        let mut tensor = cross.transpose() * lever.held * cross * self.mass;
        for i in 0..3 {
            let column = body.modal.power(&triad, crate::junction::body::Power::One, &Vec3::ith(i, 1.0));
            tensor.set_column(i, &(tensor.column(i) + column));
        }
        let inner = axes.tr_mul(&(tensor * axes));
        let found = SymmetricEigen::new((inner + inner.transpose()) * 0.5).eigenvectors;
        axes * nearest_order(&found)
    }

    /// Puts a body where its supports have it at a level: the reference point at `p₀ + c(λ)` along the directions in which it is held, the
    /// triad at `R(λ) Q₀` where a rotation is prescribed, `R = exp(λ φ e)`. All particles are put from these two, so that the body keeps
    /// its shape at any level.
    pub fn put(&self, constraint: &Constraint, level: f64, case: LoadCase, state: &mut [Row]) {
        let Some(body) = &self.body else { return };
        let at = Instant { time: 0.0, level };
        let turned = [0, 1, 2].map(|i| constraint.turned(&body.rest.column(i).into(), at, case));
        let triad = match turned {
            [Some(d), Some(e), Some(c)] => Matrix3::from_columns(&[d, e, c]),
            _ => self.triad(state),
        };
        let pole = self.pole(state);
        let target = constraint.reference_at(at, case);
        let pole = pole + body.held * (target - pole - body.arm(&triad));
        self.placed(&pole, &triad).for_each(|(a, row)| state[a as usize] = row);
    }

    /// Square of the force that brings about what is prescribed to a body, turns counted as arcs \[F²\].
    pub fn driving_force(
        &self,
        prescribed: &Prescribed<'_>,
        state: &[Row],
        internal: impl Fn(usize) -> Row,
        arc: f64,
    ) -> f64 {
        let row = self.along_unknowns(state, self.gather(state, internal));
        let turn = prescribed.rotation.map_or(0.0, |rotation| rotation.axis.dot(&director(&row)) / arc);
        libm::hypot(prescribed.pull(&place(&row)), turn).powi(2)
    }

    /// Rates of all particles of a body, per unit of level at fixed unknowns.
    pub fn prescribed_rates(
        &self,
        prescribed: &Prescribed<'_>,
        level: f64,
        case: LoadCase,
        state: &[Row],
        rates: &mut [Row],
    ) {
        let [u, spin] = prescribed.motion_rate(level, case);
        let motion = self.of_pole(state, [u.x, u.y, u.z, spin.x, spin.y, spin.z]);
        self.set_rates(state, rates, &motion);
    }
}

/// Columns of a rotation in the order and with the signs in which they are nearest to the axes.
fn nearest_order(found: &Matrix3<f64>) -> Matrix3<f64> {
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let fit = |order: &[usize; 3]| (0..3).map(|i| found[(i, order[i])].abs()).sum::<f64>();
    let best =
        orders.iter().fold(orders[0], |best, order| if fit(order) > fit(&best) { *order } else { best });
    let column = |i: usize| found.column(best[i]) * if found[(i, best[i])] < 0.0 { -1.0 } else { 1.0 };
    Matrix3::from_columns(&[column(0), column(1), column(2)])
}
