//! Checks of initial stresses: their numbers, and the methods and analyses that have them.

use crate::scene::analysis::Analysis;
use crate::scene::curve::Measured;
use crate::scene::error::SceneError;
use crate::scene::problem::Scene;
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::formulation::{Formulation, Reach};
use crate::scene::statics::Prebuckling;

type Checked = Result<(), SceneError>;

impl Scene {
    /// Whether the level counts an initial stress: nothing else drives an analysis that wants to be driven.
    pub(crate) fn stress_drives(&self) -> bool {
        let kind = self.analysis.kind();
        let stressed = self.as_shell().is_some_and(|shell| !shell.initial_stress.is_empty());
        let alone = self.loads.is_empty() && self.supports.iter().all(|support| support.motion().is_none());
        stressed && alone && kind.wants_driver && kind.preloads
    }

    /// Refuses stresses without components or axes, other formulations than by cells, and analyses that find no balance first.
    pub(in crate::scene::check) fn check_initial_stress(&self, shell: &ShellScene, s: &Scope<'_>) -> Checked {
        for (i, stress) in shell.initial_stress.iter().enumerate() {
            let own = s.below(&format!("initial_stress[{i}]"));
            self.check_set_name(&own.path("on"), &stress.on)?;
            own.sized_all("membrane", &stress.membrane.unwrap_or_default())?;
            own.sized_all("bending", &stress.bending.unwrap_or_default())?;
            let whole = s.path(&format!("initial_stress[{i}]"));
            let given = [stress.membrane.map(|_| "membrane"), stress.bending.map(|_| "bending")];
            if given.iter().all(Option::is_none) {
                let repair = "add membrane = [σ11, σ22, σ12], bending = […] or both";
                let fault = self.source.fault(&whole, "no stress", "`membrane`, `bending` or both", repair);
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
        let kind = self.analysis.kind();
        if !(kind.preloads || kind.passes_time) {
            let bound = format!("none in {}, which does not look for its balance first", kind.name);
            return refuse(&bound, "use [analysis.static], [analysis.modal] or [analysis.buckling]");
        }
        if matches!(&self.analysis, Analysis::Buckling(wanted) if wanted.prebuckling == Prebuckling::Stress) {
            let bound = "\"rotations\" beside an initial stress";
            let repair =
                "leave it out: the stresses of the load alone are computed from a shell without others";
            return Err(self.scope().value("analysis.buckling.prebuckling", "\"stress\"", bound, repair));
        }
        let energy = self.curve.iter().position(|column| column.of == Measured::Energy);
        if let Some(i) = energy.filter(|_| self.stress_drives()) {
            let bound =
                "none where the level counts an initial stress, whose part in it the column does not know";
            let fault = self.scope().fault(
                &format!("curve[{i}].of"),
                "\"energy\"",
                bound,
                "read the column `internal`, which every curve has",
            );
            return Err(SceneError::Choice(fault));
        }
        Ok(())
    }
}
