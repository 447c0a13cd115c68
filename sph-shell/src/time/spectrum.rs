//! The shell in mass-scaled coordinates: its tangent applied to a vector, by differences of the internal force; what is
//! out of balance, and how fast and how far it moves.

use explicit_dynamics::{LinearisedDynamics, MassScaled};

use crate::Shell;
use crate::junction::group::Group;
use crate::junction::spectrum::Scaled;
use crate::packs::Row;

/// Greatest perturbation, in spacings for positions and in radians for directors: central differences of
/// a cubic force lose 1e-10 to truncation and about as much to round-off.
const PERTURBATION: f64 = 1e-5;

impl LinearisedDynamics for Shell {
    fn unknowns(&self) -> usize {
        6 * self.len()
    }

    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        let threads = self.evaluation.threads;
        let spacing = self.reference.cloud.spacing();
        let mut direction = vec![[0.0; 6]; self.len()];
        parallel::chunks(threads, &mut direction[..], |first, rows: &mut [Row]| {
            rows.iter_mut().enumerate().for_each(|(i, row)| *row = self.unscaled(first + i, v));
        });
        let size = |a: usize| {
            let row = &direction[a];
            let x = row[..3].iter().fold(0.0_f64, |m, u| m.max(u.abs())) / spacing;
            (row[3..].iter().fold(x, |m, u| m.max(u.abs())), a)
        };
        let own = self.share.own();
        let (greatest, _) = self.share.greatest(own.clone().map(size));
        if greatest == 0.0 {
            out.fill(0.0);
            return;
        }
        let eps = PERTURBATION / greatest;
        self.share.exchange(&mut self.motion.state);
        // The step has to bear unloading, which is the stiffest answer of a section with memory.
        self.points.hold_histories(true);
        let home = self.motion.state.clone();
        let mut change = vec![[0.0; 6]; home.len()];
        let mut of_bodies = Vec::new();
        for sign in [1.0, -1.0] {
            parallel::chunks(threads, &mut self.motion.state[..], |first, rows: &mut [Row]| {
                let moved = home[first..].iter().zip(&direction[first..]);
                rows.iter_mut().zip(moved).for_each(|(row, (old, u))| *row = perturbed(old, u, sign * eps));
            });
            self.evaluate_internal(false);
            let load = self.load_bound(&home);
            let this: &Self = self;
            parallel::chunks(threads, &mut change[..], |first, rows: &mut [Row]| {
                for (a, row) in (first..).zip(rows) {
                    let mut force = this.internal_force(a);
                    if let Some(load) = &load {
                        (0..6).for_each(|k| force[k] -= load[a][k]);
                    }
                    *row = match sign > 0.0 {
                        true => force,
                        false => std::array::from_fn(|k| (row[k] - force[k]) / (2.0 * eps)),
                    };
                }
            });
            let (groups, springs) = (self.dependents.junctions.groups.iter(), self.body_springs());
            of_bodies.push(groups.map(|group| springs.row(group.first())).collect::<Vec<_>>());
        }
        self.motion.state = home;
        self.points.hold_histories(false);
        let this: &Self = self;
        parallel::chunks(threads, out.as_chunks_mut::<6>().0, |first, rows: &mut [Row]| {
            for (a, row) in (first..).zip(rows) {
                *row = if own.contains(&a) { this.free_part(a, |a| change[a]) } else { [0.0; 6] };
            }
        });
        // Everyone who marches the shell moves its groups.
        for (number, group) in self.dependents.junctions.groups.iter().enumerate() {
            let first = group.first();
            let row = self.free_part(first, |a| change[a]);
            let change =
                std::array::from_fn(|k| (of_bodies[1][number][k] - of_bodies[0][number][k]) / (2.0 * eps));
            let free = self.scaled(group).free_row(change);
            out[6 * first..][..6].copy_from_slice(&std::array::from_fn::<_, 6, _>(|k| row[k] + free[k]));
        }
    }

    fn dot(&mut self, a: &[f64], b: &[f64]) -> f64 {
        self.share.dot(a, b, 6)
    }
}

impl MassScaled for Shell {
    fn out_of_balance(&self, out: &mut [f64]) {
        for (a, out) in out.chunks_exact_mut(6).enumerate() {
            let lack = |a: usize| {
                let (internal, external) = (self.internal_force(a), self.external_force(a));
                std::array::from_fn(|k| external[k] - internal[k])
            };
            let row = match self.dependents.junctions.of(a) {
                Some(group) => self.scaled(group).free_lack(a, lack),
                None => self.free_part(a, lack),
            };
            out.copy_from_slice(&row);
        }
    }

    fn rates(&self, out: &mut [f64]) {
        for (a, (rate, out)) in self.motion.rates.iter().zip(out.chunks_exact_mut(6)).enumerate() {
            if let Some(group) = self.dependents.junctions.of(a) {
                out.copy_from_slice(&self.scaled(group).scaled_rates(&self.motion.rates, a));
                continue;
            }
            let [x, d] = self.mass_scale(a);
            for (k, value) in out.iter_mut().enumerate() {
                *value = rate[k] / if k < 3 { x } else { d };
            }
        }
    }

    fn displaced(&self) -> f64 {
        let cloud = &self.reference.cloud;
        let square = |a: usize| {
            let (u, rotation) = (self.displacement(a), self.director(a) - cloud.frames[a].n);
            self.reference.masses[a] * u.norm_squared() + self.reference.inertias[a] * rotation.norm_squared()
        };
        let own = self.share.own();
        let chunks =
            own.clone().step_by(parallel::CHUNK).map(|first| first..(first + parallel::CHUNK).min(own.end));
        let [sum] = self.share.sum(chunks.map(|chunk| [chunk.map(square).sum::<f64>()]));
        sum.sqrt()
    }
}

/// A row moved along a direction, its director of length one.
fn perturbed(row: &Row, along: &Row, eps: f64) -> Row {
    let mut row: Row = std::array::from_fn(|k| row[k] + eps * along[k]);
    let scale = 1.0 / (row[3] * row[3] + row[4] * row[4] + row[5] * row[5]).sqrt();
    row[3..].iter_mut().for_each(|value| *value *= scale);
    row
}

impl Shell {
    /// What springs, contact and what is enclosed exert on the present state, as stiff as they may be; nothing where there are none.
    fn load_bound(&mut self, home: &[Row]) -> Option<Vec<Row>> {
        let (springs, touches) = (!self.loading.spring_forces.is_empty(), self.loading.touches());
        if !springs && !touches && self.loading.enclosed(1.0).next().is_none() {
            return None;
        }
        let mut force = vec![[0.0; 6]; home.len()];
        if springs {
            let body = self.dependents.loaded(&self.reference, &self.motion.state);
            self.loading.add_springs(&body, &mut force);
            self.share.exchange_bound(&mut force);
        }
        if touches {
            self.loading.add_contact_bounds(&self.motion.state, home, &mut force);
        }
        self.press_of_enclosed(home, &mut force);
        self.dependents.ties.condense(&self.motion.state, &mut force, |_, _| ());
        Some(force)
    }

    /// Adds what the enclosed, as stiff as it may be, exerts more on a state than at home, to the first order of the volume.
    fn press_of_enclosed(&self, home: &[Row], force: &mut [Row]) {
        for (enclosed, _) in self.loading.enclosed(1.0) {
            let (steepest, gradient) = enclosed.steepest(&self.loaded());
            let moved = self.motion.state.iter().zip(home);
            let along =
                |(g, (now, was)): (&Row, (&Row, &Row))| (0..3).map(|k| g[k] * (now[k] - was[k])).sum::<f64>();
            let change = gradient.iter().zip(moved).map(along).sum::<f64>() * steepest;
            for (sum, g) in force.iter_mut().zip(&gradient) {
                (0..3).for_each(|k| sum[k] -= change * g[k]);
            }
        }
    }

    fn scaled<'a>(&'a self, group: &'a Group) -> Scaled<'a> {
        Scaled { group, state: &self.motion.state, constraint: self.constraint(group.first()) }
    }

    fn mass_scale(&self, a: usize) -> [f64; 2] {
        self.moving_masses().map(|of| 1.0 / of[a].sqrt())
    }

    /// `M^{-½} v` of particle `a`, without what supports and the unit length of the director forbid.
    pub(super) fn unscaled(&self, a: usize, v: &[f64]) -> Row {
        if let Some(group) = self.dependents.junctions.of(a) {
            return self.scaled(group).unscaled(a, v);
        }
        self.free_part(a, |a| std::array::from_fn(|k| v[6 * a + k]))
    }

    /// `M^{-½}` times the row of particle `a` among rows of particles, without what is held.
    pub(super) fn free_part(&self, a: usize, row: impl Fn(usize) -> Row) -> Row {
        if let Some(group) = self.dependents.junctions.of(a) {
            return self.scaled(group).free_part(a, row);
        }
        let mut f = row(a);
        let row = &self.motion.state[a];
        let along = f[3] * row[3] + f[4] * row[4] + f[5] * row[5];
        for k in 3..6 {
            f[k] -= along * row[k];
        }
        if let Some(constraint) = self.constraint(a) {
            let v = constraint.held.free_part([f[0], f[1], f[2]]);
            let w = constraint.free_rotation([f[3], f[4], f[5]]);
            f = [v[0], v[1], v[2], w[0], w[1], w[2]];
        }
        let [x, d] = self.mass_scale(a);
        std::array::from_fn(|k| f[k] * if k < 3 { x } else { d })
    }
}
