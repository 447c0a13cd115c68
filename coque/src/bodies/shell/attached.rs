//! What is attached to the particles of a shell: lumped masses, edges tied to other sheets, rigid sets, springs.

use std::collections::BTreeMap;

use nalgebra::Matrix3;
use sph_core::{Cloud, Vec3};
use sph_shell::{
    BodySpring, EvenBed, Holds, Preloaded, RigidLoad, RigidSet, Spring, SpringBetween, Springs, Support, Tie,
    TurnSpring, even_bed,
};

use crate::bodies::sets::{self, Sets};
use crate::bodies::shell::build::Builder;
use crate::bodies::shell::cells::CellSets;
use crate::scene;
use crate::scene::error::SceneError;
use crate::scene::{Axis, LoadKind, RigidBody, ShellTie};

impl Builder<'_> {
    /// Lumped masses, shared equally by the particles of their sets.
    pub(super) fn masses(&self, sets: &Sets) -> Result<Vec<(u32, f64)>, SceneError> {
        let mut all = Vec::new();
        for (i, lumped) in self.scene.shell.masses.iter().enumerate() {
            let path = self.scene.body_scope().path(&format!("masses[{i}].on"));
            let particles = sets.at(self.scene, &path, &lumped.on)?;
            let share = lumped.mass.get() / particles.len() as f64;
            all.extend(particles.iter().map(|&a| (a, share)));
        }
        Ok(all)
    }

    /// Edges and the cells that they hang on.
    pub(super) fn ties(&self, sets: &Sets, cells: &CellSets<'_>) -> Result<Vec<Tie>, SceneError> {
        let tie = |(i, ShellTie { edge, to }): (usize, &ShellTie)| {
            let own = self.scene.body_scope().below(&format!("ties[{i}]"));
            let edge = sets.at(self.scene, &own.path("edge"), edge)?.to_vec();
            Ok(Tie { edge, host: cells.at(&own.path("to"), to)? })
        };
        self.scene.shell.ties.iter().enumerate().map(tie).collect()
    }

    /// Rigid sets with the supports that name them.
    pub(super) fn rigid(&self, sets: &Sets, cloud: &Cloud) -> Result<Vec<RigidSet>, SceneError> {
        let turn = self.turned_axes();
        let body = |(i, body): (usize, &RigidBody)| {
            let path = self.scene.body_scope().path(&format!("rigid[{i}].on"));
            let particles = sets.at(self.scene, &path, &body.on)?.to_vec();
            let sum: Vec3 = particles.iter().map(|&a| cloud.positions[a as usize]).sum();
            let mean = sum / particles.len() as f64;
            let moment = |axis: usize| body.inertia.as_ref().map_or(0.0, |inertia| inertia.along(axis));
            let [xy, yz, zx] = body.products.unwrap_or_default();
            let tensor = Matrix3::new(moment(0), xy, zx, xy, moment(1), yz, zx, yz, moment(2));
            Ok(RigidSet {
                at: body.at.map_or(mean, |at| self.turned(at)),
                mass: body.mass.get(),
                inertia: turn * tensor * turn.transpose(),
                holds: self.holds_of_body(&body.on),
                particles,
            })
        };
        self.scene.shell.rigid.iter().enumerate().map(body).collect()
    }

    /// What each support on a set asks of its body.
    fn holds_of_body(&self, on: &str) -> Vec<Holds> {
        let mut all = Vec::new();
        for support in self.scene.supports.iter().filter(|support| support.on == on) {
            for (_, kind) in support.kinds() {
                let course = support.amplitude.clone().unwrap_or_default();
                let Some(found) = self.support(kind, course) else { continue };
                all.push(if support.preload { Preloaded(found).holds() } else { found.holds() });
            }
        }
        all
    }

    /// A force or a couple about a fixed axis on a rigid set, as a load on its body.
    pub(super) fn load_on_body(&self, kind: &LoadKind, on: &str) -> Option<RigidLoad> {
        let set = self.scene.shell.rigid_body(on)?;
        match kind {
            LoadKind::Force(force) => {
                Some(RigidLoad { set, force: self.turned(force.total), couple: Vec3::zeros() })
            }
            LoadKind::Couple(couple) => {
                let Axis::Fixed(axis) = couple.axis else { return None };
                let couple = self.turned(axis).normalize() * couple.moment;
                Some(RigidLoad { set, force: Vec3::zeros(), couple })
            }
            _ => None,
        }
    }

    /// Springs, spread evenly over the lines or areas of their sets; those that turn a rigid set or join two act on them as a whole.
    pub(super) fn springs(&self, sets: &Sets, cloud: &Cloud) -> Result<Springs, SceneError> {
        let mut all = Springs::default();
        for support in &self.scene.supports {
            let Some(spring) = &support.spring else { continue };
            let stiffness = spring.stiffness.get();
            let particles = sets.at(self.scene, &support.at("on"), support.on)?;
            let body = self.scene.shell.rigid_body(support.on);
            if let (Some(axis), Some(body)) = (spring.axis, body) {
                all.of_bodies.push(BodySpring::Turning { body, stiffness, axis: self.turned(axis) });
                continue;
            }
            let to = spring.to.as_ref().map(|to| self.scene.own_set(to));
            let other = to.and_then(|to| self.scene.shell.rigid_body(to));
            let direction = self.turned(spring.direction.unwrap_or_default());
            if let (Some(one), Some(two)) = (body, other) {
                all.of_bodies.push(BodySpring::Between { bodies: [one, two], stiffness, direction });
                continue;
            }
            let EvenBed { shares, pairs } = even_bed(cloud, particles);
            let shares: Vec<_> = shares.into_iter().map(|(a, share)| (a, stiffness * share)).collect();
            let too_much = pairs.into_iter().map(|(pair, part)| (pair, -stiffness * part));
            match (spring, to) {
                (scene::Spring { axis: Some(axis), .. }, _) => {
                    all.turning.push(TurnSpring { stiffness: shares, axis: self.turned(*axis) });
                }
                (_, None) => {
                    all.ground.push(Spring { stiffness: shares, direction });
                    all.between.push(SpringBetween { stiffness: too_much.collect(), direction });
                }
                (_, Some(to)) => {
                    let path = support.at("spring.to");
                    let others: Vec<u32> = sets::places(cloud, sets.at(self.scene, &path, to)?).collect();
                    let mut stiffness = self.paired(&path, to, cloud, shares, &others)?;
                    let opposite: BTreeMap<u32, u32> = stiffness.iter().map(|&([a, b], _)| (a, b)).collect();
                    let across = |(pair, k): ([u32; 2], f64)| of_openings(pair.map(|a| [a, opposite[&a]]), k);
                    let too_much: Vec<_> = too_much.flat_map(across).collect();
                    stiffness.extend(too_much);
                    all.between.push(SpringBetween { stiffness, direction });
                }
            }
        }
        all.between.retain(|spring| !spring.stiffness.is_empty());
        Ok(all)
    }

    /// Each particle with the nearest of the others: all of both sets, each once.
    fn paired(
        &self,
        path: &str,
        to: &str,
        cloud: &Cloud,
        shares: Vec<(u32, f64)>,
        others: &[u32],
    ) -> Result<Vec<([u32; 2], f64)>, SceneError> {
        let refuse = |value: String, bound: &str| {
            let repair = "name two sets of as many places that face each other, or make both rigid: then their reference points are joined";
            Err(SceneError::Set(self.scene.source.fault(path, &value, bound, repair)))
        };
        if shares.len() != others.len() {
            let value = format!("\"{to}\" with {} places", others.len());
            return refuse(value, &format!("and the set joined to it has {}", shares.len()));
        }
        let mut taken = vec![false; others.len()];
        let mut pairs = Vec::with_capacity(shares.len());
        for (a, k) in shares {
            let away = |b: u32| (cloud.positions[b as usize] - cloud.positions[a as usize]).norm_squared();
            let nearest = (0..others.len()).min_by(|&i, &j| away(others[i]).total_cmp(&away(others[j])));
            let Some(number) = nearest else { continue };
            let b = others[number];
            if std::mem::replace(&mut taken[number], true) || a == b {
                let value = format!("\"{to}\" with particle {b}");
                let bound = "one particle for each: two of the set it is joined to have this one as their nearest, or it belongs to both";
                return refuse(value, bound);
            }
            pairs.push(([a, b], k));
        }
        Ok(pairs)
    }
}

/// `½ k ((u_b − u_a) − (u_d − u_c))²` of two pairs (a, b) and (c, d), as springs between two particles each.
fn of_openings([[a, b], [c, d]]: [[u32; 2]; 2], k: f64) -> [([u32; 2], f64); 6] {
    [([a, b], k), ([c, d], k), ([a, c], k), ([b, d], k), ([a, d], -k), ([c, b], -k)]
}

#[cfg(test)]
mod tests {
    use super::of_openings;

    #[test]
    fn an_opening_is_six_springs() {
        let (u, k) = ([0.3_f64, -1.1, 0.7, 2.9], 1.7);
        let energy = |([a, b], k): ([u32; 2], f64)| 0.5 * k * (u[b as usize] - u[a as usize]).powi(2);
        let found: f64 = of_openings([[0, 1], [2, 3]], k).into_iter().map(energy).sum();
        let wanted = 0.5 * k * ((u[1] - u[0]) - (u[3] - u[2])).powi(2);
        assert!((found - wanted).abs() < 1e-14 * wanted, "{found} {wanted}");
    }
}
