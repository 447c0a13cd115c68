//! Force and moment of each load, and of what all supports bear.

use sph_core::Vec3;

use crate::Shell;
use crate::conditions::loads::AppliedLoad;

/// A system of forces, reduced to a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resultant {
    /// Force \[F\].
    pub force: Vec3,
    /// Moment about the point \[F L\].
    pub moment: Vec3,
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
        let mut rows = vec![[0.0; 6]; if self.loads.is_empty() { 0 } else { self.len() }];
        let body = self.as_loaded();
        let reduced = |AppliedLoad { load, .. }: &AppliedLoad| {
            rows.fill([0.0; 6]);
            load.add(1.0, &body, &mut rows);
            let mut sum = Resultant::default();
            for (a, &[fx, fy, fz, tx, ty, tz]) in rows.iter().enumerate() {
                let arm = self.place(a) - about;
                sum.add(arm, Vec3::new(fx, fy, fz), self.director(a), Vec3::new(tx, ty, tz));
            }
            for ([force, couple], at) in self.on_bodies(&**load) {
                sum.add(at - about, force, Vec3::zeros(), Vec3::zeros());
                sum.moment += couple;
            }
            sum
        };
        self.loads.iter().map(reduced).collect()
    }

    /// What the supports and springs exert on the shell, reduced to a point, for the last forces evaluated: of every particle the part of
    /// `[∂U/∂x, ∂U/∂d]` less the load along the directions that are held.
    pub fn support_resultant(&self, about: Vec3) -> Resultant {
        let about = about - self.reference.origin;
        let mut sum = Resultant::default();
        for (a, row) in self.spring_forces.iter().enumerate() {
            let force = Vec3::new(row[0], row[1], row[2]);
            sum.add(self.place(a) - about, force, self.director(a), Vec3::new(row[3], row[4], row[5]));
        }
        for group in self.junctions.groups.iter().filter(|group| group.body.is_some()) {
            let row = self.spring_row_of_body(group.first());
            sum.add(
                group.pole(&self.state) - about,
                Vec3::new(row[0], row[1], row[2]),
                Vec3::zeros(),
                Vec3::zeros(),
            );
            sum.moment += Vec3::new(row[3], row[4], row[5]);
        }
        for a in 0..self.len() {
            let Some(held) = self.constraint(a) else { continue };
            let lack = |a: usize| -> [f64; 6] {
                let (internal, external) = (self.internal_force(a), self.external_force(a));
                std::array::from_fn(|k| internal[k] - external[k])
            };
            let (sum_of, load) = (self.gathered(a, lack), self.body_load(a));
            let [fx, fy, fz, tx, ty, tz] = std::array::from_fn(|k| sum_of[k] - load[k]);
            let (force, couple) = ([fx, fy, fz], Vec3::new(tx, ty, tz));
            let force = Vec3::from(force) - Vec3::from(held.free_translation(force));
            let arm = self.place(a) - about;
            if let Some(group) = self.junctions.of(a) {
                // A group bears a torque: of the moment about its pole what the force at the reference point of a body leaves.
                sum.add(group.pole(&self.state) - about, force, Vec3::zeros(), Vec3::zeros());
                let swung = group.lever(&self.state).map_or(Vec3::zeros(), |lever| lever.torque(&force));
                sum.moment += couple - held.free_spin(couple - swung);
                continue;
            }
            let d = self.director(a);
            let across: [f64; 3] = (couple - d * d.dot(&couple)).into();
            sum.add(arm, force, d, Vec3::from(across) - Vec3::from(held.free_rotation(across)));
        }
        sum
    }
}
