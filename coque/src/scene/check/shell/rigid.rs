//! Checks of rigid sets: their numbers, what else acts on them, and where there are none.

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::sets::check_set_name;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::per_axis::PerAxis;
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::formulation::{Formulation, Reach};
use crate::scene::shell::parts::RigidBody;

/// Refuses bodies of negative mass or inertia, other formulations than by cells, and a fluid.
pub(super) fn check_rigid(scene: &BodyInScene<'_>, shell: &ShellScene, s: &Scope<'_>) -> Verdict {
    for (i, RigidBody { on, at, inertia, products, .. }) in shell.rigid.iter().enumerate() {
        let own = s.below(&format!("rigid[{i}]"));
        check_set_name(scene, &own.path("on"), on)?;
        own.sized_all("at", at.as_ref().map_or(&[][..], |at| at))?;
        own.sized_all("products", products.as_ref().map_or(&[][..], |products| products))?;
        match inertia {
            Some(PerAxis::Each(list)) if list.len() != 3 => {
                let value = format!("{} numbers", list.len());
                let repair = "give one number, or one each for x, y and z";
                return Err(own.value("inertia", value, "one number or three", repair));
            }
            Some(PerAxis::Each(list)) => {
                for (k, &moment) in list.iter().enumerate() {
                    own.not_negative(&format!("inertia[{k}]"), moment)?;
                }
            }
            Some(PerAxis::Same(moment)) => own.not_negative("inertia", *moment)?,
            None => {}
        }
    }
    if shell.rigid.is_empty() {
        return Ok(());
    }
    for support in scene.supports.iter().filter(|support| shell.rigid_body(support.on).is_some()) {
        if support.diaphragm.is_some_and(|diaphragm| diaphragm.whole_section) {
            let repair = "leave it out, and hold the turns of a rigid set by `held.director`";
            let bound = "false on a rigid set, which has no section";
            return Err(scene.scope().value(&support.at("diaphragm.whole-section"), true, bound, repair));
        }
    }
    let refuse = |bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault("rigid[0]", "a rigid set", bound, repair)))
    };
    if !matches!(&shell.formulation, Formulation::StressPoint(f) if f.support == Reach::Cell) {
        let bound = "none but where strains are sampled in cells";
        return refuse(bound, "use [formulation.stress-point] without `support`, the default");
    }
    if scene.in_fluid {
        return refuse("none in a fluid", "leave it out: cells of a fluid's shell bend everywhere");
    }
    Ok(())
}
