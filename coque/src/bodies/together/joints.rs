//! Springs between sets of two bodies: from the scene's words to what acts between systems.

use std::collections::{BTreeMap, BTreeSet};

use contact::{Joint, Joints};
use sph_core::Vec3;

use super::layout::Layout;
use crate::scene::error::SceneError;
use crate::scene::joints::joints;
use crate::scene::owner::Owner;
use crate::scene::{Analysis, Scene};

/// Sets of each body by name, with the numbers of their particles in it.
pub(in crate::bodies) type SetsOfBodies = BTreeMap<String, BTreeMap<String, Vec<u32>>>;

/// Springs between bodies.
#[derive(Clone)]
pub(in crate::bodies) struct BetweenBodies {
    /// Particles at their ends, by body.
    particles: Vec<Vec<u32>>,
    springs: Joints,
    /// Number of springs.
    count: usize,
}

impl explicit_dynamics::Interaction for BetweenBodies {
    fn particles(&self) -> Vec<Vec<u32>> {
        self.particles.clone()
    }

    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.springs.evaluate(places, forces)
    }

    fn resist(&self, _places: &[[f64; 3]], motion: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        self.springs.resist(motion, forces);
    }

    fn fastest(&self, masses: &[f64]) -> f64 {
        self.springs.fastest(masses)
    }
}

impl implicit_statics::Interaction for BetweenBodies {
    fn particles(&self) -> Vec<Vec<u32>> {
        self.particles.clone()
    }

    fn pairs(&self) -> Vec<[usize; 2]> {
        self.springs.pairs()
    }

    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.springs.evaluate(places, forces)
    }

    fn stiffness(&self, _places: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        self.springs.stiffness(blocks);
    }
}

impl BetweenBodies {
    /// A line for the summary.
    pub fn line(&self) -> String {
        format!("springs between bodies: {}", self.count)
    }

    /// The springs of a scene; none without any.
    ///
    /// # Errors
    /// [`SceneError::Set`] for sets that do not pair, and for an end whose motion is prescribed where no time passes.
    pub fn find(scene: &Scene, layout: &Layout, sets: &SetsOfBodies) -> Result<Option<Self>, SceneError> {
        let mut pairs: Vec<([u32; 2], f64, Vec3)> = Vec::new();
        for joint in joints(scene)? {
            let (on, to) = (format!("{}.on", joint.path), format!("{}.spring.to", joint.path));
            let ends = places(scene, &on, joint.ends[0], layout, sets)?;
            let others = places(scene, &to, joint.ends[1], layout, sets)?;
            refuse_moved(scene, "a spring between bodies", [&ends, &others], layout, sets)?;
            let found = paired(scene, &to, joint.ends[1], [&ends, &others], layout)?;
            let each = joint.spring.stiffness.get() / found.len() as f64;
            let direction = Vec3::from(joint.spring.direction.unwrap_or_default()).normalize();
            pairs.extend(found.into_iter().map(|ends| (ends, each, direction)));
        }
        if pairs.is_empty() {
            return Ok(None);
        }
        let touched: BTreeSet<u32> = pairs.iter().flat_map(|(ends, ..)| *ends).collect();
        let touched: Vec<u32> = touched.into_iter().collect();
        let number = |particle: u32| touched.partition_point(|&other| other < particle);
        let springs = pairs.into_iter().map(|(ends, stiffness, direction)| Joint {
            ends: ends.map(number),
            stiffness,
            direction,
        });
        let rest = touched.iter().map(|&particle| layout.rest[particle as usize]).collect();
        let springs: Vec<Joint> = springs.collect();
        let count = springs.len();
        let springs = Joints::new(springs, rest);
        let particles = layout.of_each(&touched);
        Ok(Some(Self { particles, springs, count }))
    }
}

/// Particles of all in a set of a body.
pub(super) fn members(layout: &Layout, sets: &SetsOfBodies, body: &str, set: &str) -> Vec<u32> {
    let number = layout.names.iter().position(|name| name == body);
    let first = number.map_or(0, |number| layout.particles[number].start as u32);
    let own = sets.get(body).and_then(|sets| sets.get(set));
    own.into_iter().flatten().map(|particle| first + particle).collect()
}

/// Particles of all in the set of a body that is named at a path, one for each place.
pub(super) fn places(
    scene: &Scene,
    path: &str,
    (body, set): (&str, &str),
    layout: &Layout,
    sets: &SetsOfBodies,
) -> Result<Vec<u32>, SceneError> {
    let all = members(layout, sets, body, set);
    if all.is_empty() {
        let (value, repair) = (format!("\"{body}.{set}\""), "name another set of that body");
        return Err(SceneError::Set(scene.source.fault(path, &value, "which has no particle", repair)));
    }
    Ok(distinct(layout, all))
}

/// The first particle of all at each place.
pub(super) fn distinct(layout: &Layout, mut all: Vec<u32>) -> Vec<u32> {
    let mut taken = BTreeSet::new();
    all.retain(|particle| {
        let x = layout.rest[*particle as usize];
        taken.insert([x.x, x.y, x.z].map(f64::to_bits))
    });
    all
}

/// Each place of a set with the nearest of the other, which is named at a path: all of both, each once.
pub(super) fn paired(
    scene: &Scene,
    path: &str,
    (body, set): (&str, &str),
    [ends, others]: [&[u32]; 2],
    layout: &Layout,
) -> Result<Vec<[u32; 2]>, SceneError> {
    let refuse = |value: String, bound: String| {
        let repair = "name two sets of as many places that face each other, or one place of each";
        Err(SceneError::Set(scene.source.fault(path, &value, &bound, repair)))
    };
    if ends.len() != others.len() {
        let value = format!("\"{body}.{set}\" with {} places", others.len());
        return refuse(value, format!("and the set joined to it has {}", ends.len()));
    }
    let at = |particle: u32| layout.rest[particle as usize];
    let mut taken = vec![false; others.len()];
    let mut pairs = Vec::with_capacity(ends.len());
    for &a in ends {
        let away = |b: u32| (at(b) - at(a)).norm_squared();
        let nearest = (0..others.len()).min_by(|&i, &j| away(others[i]).total_cmp(&away(others[j])));
        let Some(number) = nearest else { continue };
        if std::mem::replace(&mut taken[number], true) {
            let x = at(others[number]);
            let value = format!("\"{body}.{set}\" with a place at ({:.4}, {:.4}, {:.4})", x.x, x.y, x.z);
            return refuse(
                value,
                "one place for each: two of the set joined to it have this one as their nearest".into(),
            );
        }
        pairs.push([a, others[number]]);
    }
    Ok(pairs)
}

/// Without time no end may be moved by a support: answers are differentiated by the level at fixed unknowns.
pub(super) fn refuse_moved(
    scene: &Scene,
    what: &str,
    ends: [&[u32]; 2],
    layout: &Layout,
    sets: &SetsOfBodies,
) -> Result<(), SceneError> {
    if matches!(scene.analysis, Analysis::Explicit(_)) {
        return Ok(());
    }
    let Some((path, on)) = moved_on(scene, ends, layout, sets)? else { return Ok(()) };
    let bound = format!(
        "whose places hang on {what}, which {} has on places that no support moves",
        scene.analysis.kind().name
    );
    let repair = "move another set, or use [analysis.explicit]";
    Err(SceneError::Set(scene.source.fault(&path, &format!("\"{on}\""), &bound, repair)))
}

/// The support that moves any of some places: where its set is named, and the set.
pub(super) fn moved_on<'a>(
    scene: &'a Scene,
    ends: [&[u32]; 2],
    layout: &Layout,
    sets: &SetsOfBodies,
) -> Result<Option<(String, &'a str)>, SceneError> {
    for (i, support) in scene.supports.iter().enumerate().filter(|(_, support)| support.motion().is_some()) {
        let path = format!("supports[{i}].on");
        let Owner::Of(body, set) = Owner::of(scene, &path, &support.on)? else { continue };
        let moved = members(layout, sets, body, set);
        if moved.iter().any(|particle| ends.iter().any(|end| end.contains(particle))) {
            return Ok(Some((path, &support.on)));
        }
    }
    Ok(None)
}
