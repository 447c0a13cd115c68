//! Checks of the particle method.

use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::shell::formulation::{Formulation, Reach};

pub(super) fn check_formulation(formulation: &Formulation, s: &Scope<'_>) -> Verdict {
    let at = |key: &str| format!("formulation.{}.{key}", formulation.word());
    match formulation {
        Formulation::StressPoint(f) => match f.support {
            Reach::Cell if f.kernel.is_some() => {
                let repair = "remove `kernel`, or give `support` as a number such as 1.4";
                let fault = s.fault(&at("kernel"), "a kernel", "no kernel with support = \"cell\"", repair);
                return Err(SceneError::Choice(fault));
            }
            Reach::Cell => {}
            Reach::Wide(reach) => s.within(
                &at("support"),
                reach,
                [1.2, 3.0],
                "in units of the distance to the fourth nearest particle; 1.4 is usual, or \"cell\"",
            )?,
        },
        Formulation::Nodal(_) | Formulation::StrongForm(_) => {}
    }
    let measures = shell_kinematics::strain_measures().map(|m| m.name());
    if let Some(curvature) = formulation.curvature() {
        s.word(&at("curvature"), curvature, &measures)?;
    }
    if let Some(kernel) = formulation.kernel() {
        s.word(&at("kernel"), kernel, &sph_core::kernels().map(|k| k.name()))?;
    }
    Ok(())
}
