//! What supports prescribe to a rigid body without time: its reference point displaced, its triad turned, by level.
//!
//! The reference point goes to `p₀ + c(λ)` along the directions in which it is held, the triad to `R(λ) Q₀` where a rotation is prescribed, `R = exp(λ φ e)`.
//! All particles are put from these two, so that the body keeps its shape at any level.

use explicit_dynamics::Instant;
use nalgebra::Matrix3;

use crate::Shell;
use crate::junction::group::{Group, director, place};
use crate::packs::Row;

impl Shell {
    /// The group of a rigid body, if the particle belongs to one.
    pub(crate) fn body_of(&self, particle: usize) -> Option<&Group> {
        self.junctions.of(particle).filter(|group| group.body.is_some())
    }

    /// Puts the body that a particle stands for where a level has it.
    pub(crate) fn put_body(&mut self, particle: usize, level: f64) {
        let at = Instant { time: 0.0, level };
        let Self { junctions, constraints, constraint_of, state, case, .. } = self;
        let constraint = constraint_of[particle].checked_sub(1).map(|i| &constraints[i as usize]);
        let group = junctions.of(particle).filter(|group| group.first() == particle);
        let (Some(constraint), Some(group)) = (constraint, group) else { return };
        let Some(body) = &group.body else { return };
        let turned = [0, 1, 2].map(|i| constraint.turned(&body.rest.column(i).into(), at, *case));
        let triad = match turned {
            [Some(d), Some(e), Some(c)] => Matrix3::from_columns(&[d, e, c]),
            _ => group.triad(state),
        };
        let pole = group.pole(state);
        let target = constraint.reference_at(at, *case);
        let pole = pole + body.held * (target - pole - body.arm(&triad));
        group.placed(&pole, &triad).for_each(|(a, row)| state[a as usize] = row);
    }

    /// Square of the force that brings about what is prescribed to the body that a particle stands for, turns counted as arcs \[F²\].
    pub(crate) fn force_on_body(&self, particle: usize, arc: f64) -> f64 {
        let (Some(group), Some(prescribed)) = (
            self.body_of(particle),
            self.constraint(particle).and_then(|constraint| constraint.prescribed()),
        ) else {
            return 0.0;
        };
        let row = group.along_unknowns(&self.state, group.gather(&self.state, |a| self.internal_force(a)));
        let turn = prescribed.rotation.map_or(0.0, |rotation| rotation.axis.dot(&director(&row)) / arc);
        libm::hypot(prescribed.pull(&place(&row)), turn).powi(2)
    }

    /// Rates of all particles of the body that one stands for, per unit of level at fixed unknowns.
    pub(crate) fn rates_of_body(&self, particle: usize, level: f64, rates: &mut [Row]) {
        let (Some(group), Some(prescribed)) = (
            self.body_of(particle),
            self.constraint(particle).and_then(|constraint| constraint.prescribed()),
        ) else {
            return;
        };
        let [u, spin] = prescribed.motion_rate(level, self.case);
        let motion = group.of_pole(&self.state, [u.x, u.y, u.z, spin.x, spin.y, spin.z]);
        group.set_rates(&self.state, rates, &motion);
    }
}
