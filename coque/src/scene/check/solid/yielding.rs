//! Checks of solids of bonds that yield.

use crate::scene::analysis::{Analysis, Damping, Explicit};
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::shell::check_plastic;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::shell::plastic::{Hardening, Plastic};
use crate::scene::solid::SolidScene;
use crate::scene::solid::formulation::{Correction, SolidFormulation};

/// Families of bonds yield by von Mises' criterion with linear hardening, in space, where a march goes through their history.
pub(super) fn check_yielding_bonds(
    scene: &BodyInScene<'_>,
    solid: &SolidScene,
    plastic: &Plastic,
) -> Verdict {
    let s = &scene.body_scope();
    check_plastic(plastic, s)?;
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(path, value, bound, repair)))
    };
    let material = "material.plastic";
    if !matches!(plastic.hardening, Hardening::Linear(_)) {
        let bound = "`linear` where bonds carry the solid: the return of a family is closed for it";
        return refuse(
            &format!("{material}.hardening"),
            "another hardening",
            bound,
            "use linear = { yield-stress = …, slope = … }",
        );
    }
    let others = [
        (plastic.kinematic.get() > 0.0, "kinematic", "a back stress"),
        (!plastic.back_stresses.is_empty(), "back-stresses", "back stresses"),
        (plastic.rate.is_some(), "rate", "a law of rates"),
        (plastic.anisotropy.is_some(), "anisotropy", "Hill's criterion"),
    ];
    if let Some((_, key, value)) = others.into_iter().find(|(given, ..)| *given) {
        let bound =
            "none of bonds: families yield by von Mises' criterion, and harden alike in all directions";
        return refuse(&format!("{material}.{key}"), value, bound, "remove it");
    }
    if !matches!(solid.formulation, SolidFormulation::StateBased(_)) || solid.dimensions() != 3 {
        let bound = "that of state-based bonds in space: pairwise bonds cannot tell a change of volume from one of shape, and in a plane no bond \
                     carries the stress across";
        let repair = "use [formulation.state-based] and three lengths, or [material.elastic]";
        return refuse(material, "a material that yields", bound, repair);
    }
    if !matches!(solid.correction(), Correction::Even | Correction::Balanced) {
        let bound = "\"balanced\" or \"even\" beside [material.plastic]: with other weights a flow that keeps the volume meets pressure at faces";
        return refuse("formulation.state-based.correction", "another correction", bound, "remove it");
    }
    if !matches!(scene.analysis, Analysis::Explicit(_)) {
        let bound = format!(
            "none of bonds in {}: where a family stands depends on the way there",
            scene.analysis.kind().name
        );
        let repair = "use [analysis.explicit.quasi-static] or [analysis.explicit.transient], or [formulation.galerkin]";
        return refuse(material, "a material that yields", &bound, repair);
    }
    check_levels(scene)
}

/// A motion that overshoots flows further and stays there: a bar drawn at once, in one period, by a fifth.
fn check_levels(scene: &BodyInScene<'_>) -> Verdict {
    /// Periods of a ramp, of a bar's whose force comes within 1.5 % of a slow one; 5 leave 2.5 % of it, and 1 leaves 7.
    const SLOW: f64 = 20.0;
    let Analysis::Explicit(Explicit { quasi_static: Some(path), .. }) = &scene.analysis else {
        return Ok(());
    };
    let s = &scene.scope();
    if path.damping == Damping::Kinetic {
        let bound =
            "a `ratio` where bonds yield: between its peaks a motion goes too far, and flow does not go back";
        let fault = s.fault(
            "analysis.explicit.quasi-static.damping",
            "\"kinetic\"",
            bound,
            "damping = { ratio = 1.0 }",
        );
        return Err(SceneError::Choice(fault));
    }
    if path.ramp.get() < SLOW {
        let bound = format!(
            "at least {SLOW} where bonds yield: a motion that overshoots flows further, and stays there"
        );
        let path_of = "analysis.explicit.quasi-static.ramp";
        return Err(s.value(
            path_of,
            path.ramp.get(),
            &bound,
            "ramp = 20.0, or [analysis.explicit.transient] with `damping`",
        ));
    }
    Ok(())
}
