//! Checks of rigid bodies: their numbers, what acts on them, and where there are none.

use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::check::sets::only_on;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::loads::{Axis, Load};
use crate::scene::per_axis::PerAxis;
use crate::scene::rigid::{RigidGeometry, RigidScene};
use crate::scene::scope::Scope;
use crate::scene::supports::Support;

/// Bounds what a surface may allocate.
const MOST_VERTICES: f64 = 1e6;

impl RigidScene {
    /// Refuses the first of its own keys that is out of bounds.
    pub(super) fn check(&self, s: &Scope<'_>) -> Verdict {
        self.check_geometry(s)?;
        let given = [("density", self.density), ("mass", self.mass)];
        let given: Vec<&str> = given.iter().filter_map(|(word, value)| value.map(|_| *word)).collect();
        if given.len() != 1 {
            let value = if given.is_empty() { "neither".into() } else { given.join(" and ") };
            let (bound, repair) =
                ("exactly one of `density` and `mass`", "give the density, or the whole mass");
            return Err(SceneError::Choice(s.fault("density", &value, bound, repair)));
        }
        let beside = |key: &str, other: &str, there: bool| match there {
            true => Ok(()),
            false => {
                let (bound, repair) =
                    (format!("none without `{other}`"), format!("add `{other}`, or remove it"));
                Err(SceneError::Choice(s.fault(key, key, &bound, &repair)))
            }
        };
        if self.inertia.is_some() {
            beside("inertia", "mass", self.mass.is_some())?;
        }
        if let Some(products) = &self.products {
            beside("products", "inertia", self.inertia.is_some())?;
            s.sized_all("products", products)?;
        }
        match &self.inertia {
            Some(PerAxis::Each(list)) if list.len() != 3 => {
                let value = format!("{} numbers", list.len());
                let repair = "give one number, or one each for x, y and z";
                Err(s.value("inertia", value, "one number or three", repair))
            }
            Some(PerAxis::Each(list)) => {
                let mut each = list.iter().enumerate();
                each.try_for_each(|(k, &moment)| s.positive(&format!("inertia[{k}]"), moment))
            }
            Some(PerAxis::Same(moment)) => s.positive("inertia", *moment),
            None => Ok(()),
        }
    }

    fn check_geometry(&self, s: &Scope<'_>) -> Verdict {
        let at = |key: &str| format!("geometry.{}.{key}", self.geometry.word());
        match &self.geometry {
            RigidGeometry::Ball(ball) => s.sized_all(&at("centre"), &ball.centre)?,
            RigidGeometry::Box(own) => {
                s.sized_all(&at("min"), &own.min)?;
                s.sized_all(&at("max"), &own.max)?;
                if let Some(axis) = (0..3).find(|&axis| own.min[axis] >= own.max[axis]) {
                    let bound = format!("greater than the least, {}", own.min[axis]);
                    let path = at(&format!("max[{axis}]"));
                    return Err(s.value(&path, own.max[axis], &bound, "swap the coordinates"));
                }
            }
            RigidGeometry::Mesh(_) => {}
        }
        let vertices = self.geometry.particles();
        if vertices.is_nan() || vertices > MOST_VERTICES {
            let value = format!("so small that the surface has {vertices:.1e} vertices");
            let bound = format!("so wide that there are at most {MOST_VERTICES:e}");
            return Err(s.value(&at("spacing"), value, &bound, "use a wider spacing"));
        }
        Ok(())
    }
}

/// Refuses analyses that a rigid body does not go through, and what a scene has beside it that it does not go with.
pub(super) fn check_rigid(scene: &BodyInScene<'_>) -> Verdict {
    let kind = scene.analysis.kind();
    if matches!(scene.analysis, Analysis::Relaxation(_) | Analysis::ArcLength(_) | Analysis::Buckling(_)) {
        let bound = format!("none in {}", kind.name);
        let repair = "use [analysis.static], linear, modal or explicit, or a stiff shell in its place";
        let path = scene.body_scope().path("");
        let fault = scene.source.fault(path.trim_end_matches('.'), "a rigid body", &bound, repair);
        return Err(SceneError::Choice(fault));
    }
    if scene.scene.bodies.len() == 1 && scene.output.fields.is_some_and(|fields| fields.extruded) {
        let bound = "none of a rigid body";
        let repair = "remove it: a rigid body is written as it is";
        let fault = scene.scope().fault("output.fields.extruded", "a thickness", bound, repair);
        return Err(SceneError::Choice(fault));
    }
    Ok(())
}

/// Refuses what a rigid body is not held by.
pub(super) fn check_rigid_support(scene: &BodyInScene<'_>, support: &OnSet<'_, Support>) -> Verdict {
    let s = &scene.scope();
    for (word, _) in support.kinds() {
        if !["clamped", "hinged", "held", "moved", "rotated", "spring"].contains(&word) {
            let bound = "`clamped`, `hinged`, `held`, `moved`, `rotated` or `spring` on a rigid body";
            let repair = "use held = { displacement = […], director = […] } with what does not move";
            let fault = s.fault(&support.at(word), &format!("`{word}`"), bound, repair);
            return Err(SceneError::Choice(fault));
        }
        if word != "spring" {
            only_on(scene, support, "a support holds all of a rigid body", &["all"])?;
        }
    }
    let Some(spring) = &support.spring else { return Ok(()) };
    let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(&support.at(&format!("spring.{key}")), value, bound, repair)))
    };
    if spring.axis.is_some() {
        let repair = "use springs along a direction, away from its centre";
        return refuse("axis", "an axis", "a direction, on a rigid body", repair);
    }
    if spring.to.is_some() {
        let repair = "name a set of another body, or remove it";
        return refuse(
            "to",
            "a set of the same body",
            "one of another: a rigid body keeps its shape",
            repair,
        );
    }
    Ok(())
}

/// Refuses what a rigid body does not carry.
pub(super) fn check_rigid_load(scene: &BodyInScene<'_>, load: &OnSet<'_, Load>) -> Verdict {
    let s = &scene.scope();
    for (word, _) in load.kinds() {
        if !["force", "couple", "gravity"].contains(&word) {
            let bound = "`force`, `couple` or `gravity` on a rigid body";
            let repair = "use force = { total = […] }: nothing of the body bends";
            return Err(SceneError::Choice(s.fault(&load.at(word), &format!("`{word}`"), bound, repair)));
        }
    }
    let Some(couple) = load.couple else { return Ok(()) };
    only_on(scene, load, "a couple turns all of a rigid body", &["all"])?;
    if couple.axis == Axis::Edge {
        let (bound, repair) = ("a fixed axis, on a rigid body", "axis = [0, 0, 1]");
        return Err(SceneError::Choice(s.fault(&load.at("couple.axis"), "\"edge\"", bound, repair)));
    }
    Ok(())
}
