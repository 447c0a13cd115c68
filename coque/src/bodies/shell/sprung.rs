//! Springs of a shell: who shares them, which places of two sets are pairs.

use sph_core::{Cloud, EndWeights};
use sph_shell::{BodySpring, Spring, SpringBetween, Springs, TurnSpring};

use super::build::Builder;
use super::imported::Imported;
use crate::bodies::sets::{self, Sets};
use crate::scene;
use crate::scene::error::SceneError;

impl Builder<'_> {
    /// Springs, shared by the particles of their sets as forces are; those that turn a rigid set or join two act on them as a whole.
    pub(super) fn springs(
        &self,
        sets: &Sets,
        cloud: &Cloud,
        weights: EndWeights,
        imported: Option<&Imported>,
    ) -> Result<Springs, SceneError> {
        let mut all = Springs::default();
        for (i, support) in self.scene.supports.iter().enumerate() {
            let Some(spring) = &support.spring else { continue };
            let stiffness = spring.stiffness;
            let particles = sets.at(self.scene, &format!("supports[{i}].on"), &support.on)?;
            let body = self.scene.shell().rigid_body(&support.on);
            if let (Some(axis), Some(body)) = (spring.axis, body) {
                all.of_bodies.push(BodySpring::Turning { body, stiffness, axis: self.turned(axis) });
                continue;
            }
            let other = spring.to.as_ref().and_then(|to| self.scene.shell().rigid_body(to));
            let direction = self.turned(spring.direction.unwrap_or_default());
            if let (Some(one), Some(two)) = (body, other) {
                all.of_bodies.push(BodySpring::Between { bodies: [one, two], stiffness, direction });
                continue;
            }
            let edge = match imported {
                None => sets::edge(&support.on, particles, cloud, weights),
                Some(imported) => imported.along(particles),
            };
            let shares = edge.unwrap_or_else(|| sets::places(cloud, particles).map(|a| (a, 1.0)).collect());
            let each = stiffness / shares.iter().map(|share| share.1).sum::<f64>();
            let stiffness: Vec<_> = shares.into_iter().map(|(a, share)| (a, each * share)).collect();
            match (spring, &spring.to) {
                (scene::Spring { axis: Some(axis), .. }, _) => {
                    all.turning.push(TurnSpring { stiffness, axis: self.turned(*axis) });
                }
                (_, None) => all.ground.push(Spring { stiffness, direction }),
                (_, Some(to)) => {
                    let path = format!("supports[{i}].spring.to");
                    let others: Vec<u32> = sets::places(cloud, sets.at(self.scene, &path, to)?).collect();
                    let stiffness = self.paired(&path, to, cloud, stiffness, &others)?;
                    all.between.push(SpringBetween { stiffness, direction });
                }
            }
        }
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
