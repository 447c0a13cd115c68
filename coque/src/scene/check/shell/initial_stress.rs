//! Checks of initial stresses: their numbers, and the methods and analyses that have them.

use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::sets::check_set_name;
use crate::scene::curve::Measured;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::formulation::{Formulation, Reach};
use crate::scene::statics::Prebuckling;

/// Refuses stresses without components or axes, other formulations than by cells, and analyses that find no balance first.
pub(super) fn check_initial_stress(scene: &BodyInScene<'_>, shell: &ShellScene, s: &Scope<'_>) -> Verdict {
    for (i, stress) in shell.initial_stress.iter().enumerate() {
        let own = s.below(&format!("initial_stress[{i}]"));
        check_set_name(scene, &own.path("on"), &stress.on)?;
        own.sized_all("membrane", &stress.membrane.unwrap_or_default())?;
        own.sized_all("bending", &stress.bending.unwrap_or_default())?;
        let whole = s.path(&format!("initial_stress[{i}]"));
        let given = [stress.membrane.map(|_| "membrane"), stress.bending.map(|_| "bending")];
        if given.iter().all(Option::is_none) {
            let repair = "add membrane = [σ11, σ22, σ12], bending = […] or both";
            let fault = scene.source.fault(&whole, "no stress", "`membrane`, `bending` or both", repair);
            return Err(SceneError::Choice(fault));
        }
        match stress.axis {
            Some(axis) => own.direction("axis", axis)?,
            None if stress.isotropic() => {}
            None => {
                let bound = "given where the stress differs from direction to direction";
                let repair = "add axis = [1, 0, 0], or whatever lies along the surface";
                return Err(SceneError::Missing(own.fault("axis", "nothing", bound, repair)));
            }
        }
    }
    if shell.initial_stress.is_empty() {
        return Ok(());
    }
    let refuse = |bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault("initial_stress[0]", "an initial stress", bound, repair)))
    };
    if !matches!(&shell.formulation, Formulation::StressPoint(f) if f.support == Reach::Cell) {
        let bound = "none but where strains are sampled in cells";
        return refuse(bound, "use [formulation.stress-point] without `support`, the default");
    }
    let kind = scene.analysis.kind();
    if !(kind.preloads || kind.passes_time) {
        let bound = format!("none in {}, which does not look for its balance first", kind.name);
        return refuse(&bound, "use [analysis.static], [analysis.modal] or [analysis.buckling]");
    }
    if matches!(&scene.analysis, Analysis::Buckling(wanted) if wanted.prebuckling == Prebuckling::Stress) {
        let bound = "\"rotations\" beside an initial stress";
        let repair = "leave it out: the stresses of the load alone are computed from a shell without others";
        return Err(scene.scope().value("analysis.buckling.prebuckling", "\"stress\"", bound, repair));
    }
    let energy = scene.curve.iter().find(|column| column.of == Measured::Energy);
    if let Some(column) = energy.filter(|_| scene.stress_drives()) {
        let bound =
            "none where the level counts an initial stress, whose part in it the column does not know";
        let fault = scene.scope().fault(
            &column.at("of"),
            "\"energy\"",
            bound,
            "read the column `internal`, which every curve has",
        );
        return Err(SceneError::Choice(fault));
    }
    Ok(())
}
