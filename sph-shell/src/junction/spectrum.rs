//! Groups in mass-scaled coordinates: the six of the first particle are `[√m v, √I ω]`, those of the others nothing.

use nalgebra::Vector6;
use sph_core::Vec3;

use crate::conditions::supports::{Constraint, DirectorHold};
use crate::junction::body::Power;
use crate::junction::group::{Group, director, place};
use crate::packs::Row;

/// What is left of a held motion beside others, in units of its size, below which it is one of them.
const DEPENDENT: f64 = 1e-9;

/// A group in mass-scaled coordinates, with what holds it.
pub(crate) struct Scaled<'a> {
    pub group: &'a Group,
    pub state: &'a [Row],
    pub constraint: Option<&'a Constraint>,
}

impl Scaled<'_> {
    /// The row `[u, θ × d]` of a particle of the group for mass-scaled components v.
    pub fn unscaled(&self, a: usize, v: &[f64]) -> Row {
        let first = self.group.first();
        let free = self.without_held(std::array::from_fn(|k| v[6 * first + k]));
        let [u, theta] = halves(&self.mass_scaled(free));
        let w = theta.cross(&director(&self.state[a]));
        let arm = self.group.far_pole(self.state).map(|pole| place(&self.state[a]) - pole);
        let u = arm.map_or(u, |arm| u + theta.cross(&arm));
        [u.x, u.y, u.z, w.x, w.y, w.z]
    }

    /// Force and torque of the group, mass-scaled and without what supports hold, from rows `[f, n]` of particles.
    pub fn free_part(&self, a: usize, row: impl Fn(usize) -> Row) -> Row {
        if self.group.first() != a {
            return [0.0; 6];
        }
        self.free_row(self.group.gather(self.state, row))
    }

    /// The same of force and torque about the pole.
    pub fn free_row(&self, row: Row) -> Row {
        self.without_held(self.mass_scaled(row))
    }

    /// What is out of balance of the group, in the same way.
    pub fn free_lack(&self, a: usize, lack: impl Fn(usize) -> Row) -> Row {
        if self.group.first() != a {
            return [0.0; 6];
        }
        let sum = self.group.gather(self.state, lack);
        let load = self.group.body.as_ref().map_or([0.0; 6], |body| body.external);
        self.free_row(std::array::from_fn(|k| sum[k] + load[k]))
    }

    /// `[√m v, √I ω]` of the group.
    pub fn scaled_rates(&self, rates: &[Row], a: usize) -> Row {
        let group = self.group;
        if group.first() != a {
            return [0.0; 6];
        }
        let motion = group.motion(self.state, rates);
        if let Some(body) = &group.body {
            let [v, w] = halves(&motion);
            let v = v * group.mass.sqrt();
            let w = body.marching.power(&group.triad(self.state), Power::Root, &w);
            return [v.x, v.y, v.z, w.x, w.y, w.z];
        }
        std::array::from_fn(|k| motion[k] * if k < 3 { group.mass } else { group.inertia }.sqrt())
    }

    /// `M^{-½}` times a row.
    fn mass_scaled(&self, row: Row) -> Row {
        let group = self.group;
        let [v, w] = halves(&row);
        let v = v / group.mass.sqrt();
        let w = match &group.body {
            Some(body) => body.marching.power(&group.triad(self.state), Power::InverseRoot, &w),
            None => w / group.inertia.sqrt(),
        };
        [v.x, v.y, v.z, w.x, w.y, w.z]
    }

    /// A mass-scaled motion without what supports hold. Of a body the motions that are held, `[n, r × n]` of the reference point and
    /// `[0, e]` of rotations, are not square to the others before they are scaled.
    fn without_held(&self, row: Row) -> Row {
        let group = self.group;
        let Some(constraint) = self.constraint else { return row };
        let Some(body) = &group.body else {
            let [v, w] = halves(&row);
            let (v, w) = (constraint.held.free_part(v.into()), constraint.free_spin(w));
            return [v[0], v[1], v[2], w.x, w.y, w.z];
        };
        let arm = body.arm(&group.triad(self.state));
        let [x, y, z] = [Vec3::x(), Vec3::y(), Vec3::z()];
        let turns = match constraint.director {
            DirectorHold::Free => [None; 3],
            DirectorHold::InPlane(n) => {
                let frame = sph_core::Frame::from_normal(n);
                [Some(frame.t1), Some(frame.t2), None]
            }
            DirectorHold::Fixed => [Some(x), Some(y), Some(z)],
        };
        let places = constraint.held.basis().iter().map(|n| (*n, arm.cross(n)));
        let all = places.chain(turns.into_iter().flatten().map(|e| (Vec3::zeros(), e)));
        let (mut basis, mut count) = ([Vector6::zeros(); 6], 0);
        for (n, moment) in all {
            let mut held = Vector6::from(self.mass_scaled([n.x, n.y, n.z, moment.x, moment.y, moment.z]));
            let size = held.norm();
            basis[..count].iter().for_each(|known| held -= known * known.dot(&held));
            if held.norm() > DEPENDENT * size {
                basis[count] = held.normalize();
                count += 1;
            }
        }
        let free =
            basis[..count].iter().fold(Vector6::from(row), |left, known| left - known * known.dot(&left));
        free.into()
    }
}

fn halves(row: &Row) -> [Vec3; 2] {
    [Vec3::new(row[0], row[1], row[2]), director(row)]
}
