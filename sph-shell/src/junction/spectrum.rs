//! Groups in mass-scaled coordinates: the six of the first particle are `[√m v, √I ω]`, those of the others nothing.

use sph_core::Vec3;

use crate::Shell;
use crate::conditions::supports::DirectorHold;
use crate::junction::body::Power;
use crate::junction::group::{Group, director};
use crate::packs::Row;

impl Shell {
    /// The row `[u, θ × d]` of a particle of a group for mass-scaled components v.
    pub(crate) fn unscaled_tied(&self, group: &Group, a: usize, v: &[f64]) -> Row {
        let first = group.first();
        let [u, theta] = halves(&self.free_motion(group, std::array::from_fn(|k| v[6 * first + k])));
        let w = theta.cross(&director(&self.state[a]));
        let arm = group.far_pole(&self.state).map(|pole| self.position(a) - pole);
        let u = arm.map_or(u, |arm| u + theta.cross(&arm));
        [u.x, u.y, u.z, w.x, w.y, w.z]
    }

    /// Force and torque of a group, mass-scaled and without what supports hold, from rows `[f, n]` of particles.
    pub(crate) fn free_part_tied(&self, group: &Group, a: usize, row: impl Fn(usize) -> Row) -> Row {
        if group.first() != a {
            return [0.0; 6];
        }
        self.free_motion(group, group.gather(&self.state, row))
    }

    /// What is out of balance of a group, in the same way.
    pub(crate) fn free_lack_tied(&self, group: &Group, a: usize, lack: impl Fn(usize) -> Row) -> Row {
        if group.first() != a {
            return [0.0; 6];
        }
        let (sum, load) = (group.gather(&self.state, lack), self.body_load(a));
        self.free_motion(group, std::array::from_fn(|k| sum[k] + load[k]))
    }

    /// `[√m v, √I ω]` of a group.
    pub(crate) fn scaled_rates_tied(&self, group: &Group, a: usize) -> Row {
        if group.first() != a {
            return [0.0; 6];
        }
        let motion = group.motion(&self.state, &self.rates);
        if let Some(body) = &group.body {
            let [v, w] = halves(&motion);
            let v = v * group.mass.sqrt();
            let w = body.marching.power(&group.triad(&self.state), Power::Root, &w);
            return [v.x, v.y, v.z, w.x, w.y, w.z];
        }
        std::array::from_fn(|k| motion[k] * if k < 3 { group.mass } else { group.inertia }.sqrt())
    }

    /// `M^{-½}` times a row, without what supports hold.
    fn free_motion(&self, group: &Group, row: Row) -> Row {
        let [mut v, mut w] = halves(&row);
        if let Some(body) = &group.body {
            let constraint = self.constraint(group.first());
            let v = constraint.map_or(v, |held| held.free_translation(v.into()).into()) / group.mass.sqrt();
            let triad = group.triad(&self.state);
            let w = match constraint.map_or(DirectorHold::Free, |held| held.director) {
                DirectorHold::Free => body.marching.power(&triad, Power::InverseRoot, &w),
                DirectorHold::InPlane(n) => n * (n.dot(&w) / body.marching.about(&triad, &n).sqrt()),
                DirectorHold::Fixed => Vec3::zeros(),
            };
            return [v.x, v.y, v.z, w.x, w.y, w.z];
        }
        if let Some(constraint) = self.constraint(group.first()) {
            (v, w) = (constraint.free_translation(v.into()).into(), constraint.free_spin(w));
        }
        let (v, w) = (v / group.mass.sqrt(), w / group.inertia.sqrt());
        [v.x, v.y, v.z, w.x, w.y, w.z]
    }
}

fn halves(row: &Row) -> [Vec3; 2] {
    [Vec3::new(row[0], row[1], row[2]), director(row)]
}
