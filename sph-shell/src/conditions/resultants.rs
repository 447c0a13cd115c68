//! What loads and supports amount to: force and moment of each load, how much of it can move anything, what all supports bear.

use sph_core::Vec3;

use crate::Shell;
use crate::conditions::loads::{AppliedLoad, Load};

/// A system of forces, reduced to a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resultant {
    /// Force \[F\].
    pub force: Vec3,
    /// Moment about the point \[F L\].
    pub moment: Vec3,
}

/// Where a load acts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadShare {
    /// The part that acts on degrees of freedom that no support holds, of `Σ|f|` or of `Σ|τ|`, whichever is more \[–\]; none for a load of size
    /// zero.
    pub free: Option<f64>,
    /// The one particle on which all of it acts, if there is but one.
    pub alone: Option<u32>,
}

impl Resultant {
    /// Adds a force on a position and a couple on a director, `M += (x − p) × f + d × τ`.
    fn add(&mut self, arm: Vec3, force: Vec3, director: Vec3, couple: Vec3) {
        self.force += force;
        self.moment += arm.cross(&force) + director.cross(&couple);
    }
}

impl Shell {
    /// Area centroid of the shell at rest \[L\].
    pub fn centroid(&self) -> Vec3 {
        let cloud = &self.reference.cloud;
        let sum: Vec3 = cloud.positions.iter().zip(&cloud.areas).map(|(x, area)| x * *area).sum();
        self.reference.from_zero(sum / cloud.areas.iter().sum::<f64>())
    }

    /// Each load in the present state, reduced to a point, in the order in which they were given; the amplitude is left out.
    pub fn load_resultants(&self, about: Vec3) -> Vec<Resultant> {
        let about = about - self.reference.origin;
        let mut rows = vec![[0.0; 6]; if self.loading.loads.is_empty() { 0 } else { self.len() }];
        let body = self.dependents.loaded(&self.reference, &self.motion.state);
        let reduced = |AppliedLoad { load, .. }: &AppliedLoad| {
            rows.fill([0.0; 6]);
            load.add(1.0, &body, &mut rows);
            let mut sum = Resultant::default();
            for (a, &[fx, fy, fz, tx, ty, tz]) in rows.iter().enumerate() {
                let arm = self.motion.place(a) - about;
                sum.add(arm, Vec3::new(fx, fy, fz), self.director(a), Vec3::new(tx, ty, tz));
            }
            for ([force, couple], at) in self.on_bodies(&**load) {
                sum.add(at - about, force, Vec3::zeros(), Vec3::zeros());
                sum.moment += couple;
            }
            sum
        };
        self.loading.loads.iter().map(reduced).collect()
    }

    /// Where each load acts, in the order in which they were given.
    ///
    /// Found in the present state with the amplitude left out. A couple along a director turns nothing and does not count.
    pub fn load_shares(&self) -> Vec<LoadShare> {
        let mut rows = vec![[0.0; 6]; if self.loading.loads.is_empty() { 0 } else { self.len() }];
        let body = self.dependents.loaded(&self.reference, &self.motion.state);
        let share = |AppliedLoad { load, .. }: &AppliedLoad| {
            rows.fill([0.0; 6]);
            match load.enclosed() {
                // What is shut in has no pressure yet.
                Some(enclosed) => enclosed.press(1.0, &body, &mut rows),
                None => load.add(1.0, &body, &mut rows),
            }
            self.dependents.ties.condense(&self.motion.state, &mut rows, |_, _| ());
            let (mut sums, mut touched, mut last) = ([[0.0; 2]; 2], 0_usize, 0);
            for (a, (row, state)) in rows.iter().zip(&self.motion.state).enumerate() {
                if *row != [0.0; 6] {
                    (touched, last) = (touched + 1, a as u32);
                }
                let ([fx, fy, fz, tx, ty, tz], d) = (*row, Vec3::new(state[3], state[4], state[5]));
                let (force, couple) = ([fx, fy, fz], Vec3::new(tx, ty, tz));
                let across: [f64; 3] = (couple - d * d.dot(&couple)).into();
                let free = self.constraint(a).map_or((force, across), |constraint| {
                    (constraint.held.free_part(force), constraint.free_rotation(across))
                });
                for (sum, (whole, free)) in sums.iter_mut().zip([(force, free.0), (couple.into(), free.1)]) {
                    sum[0] += Vec3::from(whole).norm();
                    sum[1] += Vec3::from(free).norm();
                }
            }
            for group in &self.dependents.junctions.groups {
                let own = group.body.as_ref().and_then(|body| load.on_body(body.number, body.mass));
                let Some([force, couple]) = own else { continue };
                touched += group.particles.len();
                let free = self.constraint(group.first()).map_or((force, couple), |constraint| {
                    (constraint.held.free_part(force.into()).into(), constraint.free_spin(couple))
                });
                for (sum, (whole, free)) in sums.iter_mut().zip([(force, free.0), (couple, free.1)]) {
                    sum[0] += whole.norm();
                    sum[1] += free.norm();
                }
            }
            let parts = sums.into_iter().filter(|sum| sum[0] > 0.0).map(|[whole, free]| free / whole);
            LoadShare { free: parts.reduce(f64::max), alone: (touched == 1).then_some(last) }
        };
        self.loading.loads.iter().map(share).collect()
    }
    /// What the supports and springs exert on the shell, reduced to a point, for the last forces evaluated: of every particle the part of
    /// `[∂U/∂x, ∂U/∂d]` less the load along the directions that are held.
    pub fn support_resultant(&self, about: Vec3) -> Resultant {
        let about = about - self.reference.origin;
        let mut sum = Resultant::default();
        for (a, row) in self.loading.spring_forces.iter().enumerate() {
            let force = Vec3::new(row[0], row[1], row[2]);
            sum.add(self.motion.place(a) - about, force, self.director(a), Vec3::new(row[3], row[4], row[5]));
        }
        for group in self.dependents.junctions.groups.iter().filter(|group| group.body.is_some()) {
            let row = self.body_springs().row(group.first());
            sum.add(
                group.pole(&self.motion.state) - about,
                Vec3::new(row[0], row[1], row[2]),
                Vec3::zeros(),
                Vec3::zeros(),
            );
            sum.moment += Vec3::new(row[3], row[4], row[5]);
        }
        for a in 0..self.len() {
            let Some(constraint) = self.constraint(a) else { continue };
            let lack = |a: usize| -> [f64; 6] {
                let (internal, external) = (self.internal_force(a), self.external_force(a));
                std::array::from_fn(|k| internal[k] - external[k])
            };
            let (sum_of, load) = (self.gathered(a, lack), self.dependents.junctions.body_load(a));
            let [fx, fy, fz, tx, ty, tz] = std::array::from_fn(|k| sum_of[k] - load[k]);
            let (force, couple) = ([fx, fy, fz], Vec3::new(tx, ty, tz));
            let force = Vec3::from(force) - Vec3::from(constraint.held.free_part(force));
            let arm = self.motion.place(a) - about;
            if let Some(group) = self.dependents.junctions.of(a) {
                // A group bears a torque: of the moment about its pole what the force at the reference point of a body leaves.
                sum.add(group.pole(&self.motion.state) - about, force, Vec3::zeros(), Vec3::zeros());
                let swung =
                    group.lever(&self.motion.state).map_or(Vec3::zeros(), |lever| lever.torque(&force));
                sum.moment += couple - constraint.free_spin(couple - swung);
                continue;
            }
            let d = self.director(a);
            let across: [f64; 3] = (couple - d * d.dot(&couple)).into();
            sum.add(arm, force, d, Vec3::from(across) - Vec3::from(constraint.free_rotation(across)));
        }
        sum
    }

    /// What a load exerts on all rigid bodies: force and couple, and where the force acts.
    fn on_bodies<'a>(&'a self, load: &'a dyn Load) -> impl Iterator<Item = ([Vec3; 2], Vec3)> + 'a {
        self.dependents.junctions.groups.iter().filter_map(move |group| {
            let body = group.body.as_ref()?;
            let at = group.pole(&self.motion.state) + body.arm(&group.triad(&self.motion.state));
            Some((load.on_body(body.number, body.mass)?, at))
        })
    }
}
