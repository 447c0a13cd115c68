//! Checks of vibration: what swings linearly, frequencies, damping, what is measured; of a steady one what shakes.

use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::bounded::Positive;
use crate::scene::column_names::phase_of;
use crate::scene::curve::{Measured, Probe, Take};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::harmonic::{Frequencies, Harmonic, RayleighDamping, ShakenBase, VibrationDamping};
use crate::scene::problem::BodyScene;

/// Refuses what does not vibrate steadily.
pub(super) fn check_harmonic(scene: &BodyInScene<'_>, wanted: &Harmonic) -> Verdict {
    let s = &scene.scope();
    check_body(scene)?;
    check_frequencies(scene, &wanted.frequencies)?;
    if let Some(VibrationDamping::Ratio(ratio)) = wanted.damping.filter(|_| wanted.modes.is_none()) {
        let bound = "none without `modes`: a ratio is that of modes";
        let repair = "add modes = …, or use damping.structural = 2 × the ratio, which is the same at peaks";
        return Err(s.value("analysis.harmonic.damping.ratio", ratio, bound, repair));
    }
    check_damping(scene, wanted.damping)?;
    if let Some(ShakenBase { acceleration, .. }) = wanted.base {
        s.direction("analysis.harmonic.base.acceleration", acceleration)?;
    }
    check_swings(scene)?;
    if wanted.base.is_none() && scene.loads.iter().all(|load| load.preload) {
        let repair = "add a load, or shake the supports by analysis.harmonic.base";
        let fault = s.fault("loads", "nothing", "something that drives a harmonic analysis", repair);
        return Err(SceneError::Choice(fault));
    }
    Ok(())
}

/// Refuses bodies whose vibration is not found.
pub(super) fn check_body(scene: &BodyInScene<'_>) -> Verdict {
    let s = &scene.scope();
    if scene.together || !matches!(scene.body, BodyScene::Shell(_) | BodyScene::Solid(_)) {
        let value = if scene.together { "several bodies" } else { "a rigid body" };
        let bound = "one shell or one solid, alone in its scene";
        let repair = "use [analysis.modal], or march the scene by [analysis.explicit.transient]";
        let at = format!("analysis.{}", scene.analysis.kind().word);
        return Err(SceneError::Choice(s.fault(&at, value, bound, repair)));
    }
    Ok(())
}

/// Refuses conditions that do not vibrate linearly, and columns without a size.
pub(super) fn check_swings(scene: &BodyInScene<'_>) -> Verdict {
    let (s, what) = (&scene.scope(), scene.analysis.kind().name);
    let mut motions = scene.supports.iter().filter(|support| !support.preload);
    if let Some((support, word)) = motions.find_map(|support| Some((support, support.motion()?.0))) {
        let bound = format!("none in {what}, unless `preload = true` brings it about before");
        let repair = format!(
            "shake all supports by analysis.{}.base, or load the set by a force",
            scene.analysis.word()
        );
        let fault = s.fault(&support.at(word), "a prescribed motion", &bound, &repair);
        return Err(SceneError::Choice(fault));
    }
    if let Some(load) = scene.loads.iter().find(|load| load.encloses() && !load.preload) {
        let bound = format!("none in {what}, unless `preload = true` shuts it in before");
        let repair = "add `preload = true`, and let a pressure or a force vibrate";
        let fault = s.fault(&load.path, "what is pumped in", &bound, repair);
        return Err(SceneError::Choice(fault));
    }
    scene.curve.iter().try_for_each(|probe| check_swinging(scene, probe))
}

/// Refuses frequencies that do not rise.
pub(super) fn check_frequencies(scene: &BodyInScene<'_>, frequencies: &Frequencies) -> Verdict {
    let (s, at) = (&scene.scope(), format!("analysis.{}.frequencies", scene.analysis.kind().word));
    match frequencies {
        Frequencies::Range(range) if range.to.get() <= range.from.get() => {
            let bound = format!("greater than `from`, {}", range.from);
            Err(s.value(&format!("{at}.to"), range.to, &bound, "they rise from the first to the last"))
        }
        Frequencies::Range(_) => Ok(()),
        Frequencies::List(list) if list.is_empty() => {
            let repair = "frequencies = { from = 1.0, to = 100.0, points = 200 }, or a list";
            Err(s.value(&at, "empty", "a list of at least one frequency", repair))
        }
        Frequencies::List(list) => {
            let mut last = 0.0;
            for (i, &frequency) in list.iter().enumerate() {
                let path = format!("{at}[{i}]");
                if Positive::new(frequency).is_err() {
                    let repair = "for the answer at rest use [analysis.linear]";
                    return Err(s.value(&path, frequency, "above zero", repair));
                }
                s.sized(&path, frequency)?;
                if frequency <= last {
                    let bound = format!("greater than the frequency {last} before it");
                    return Err(s.value(&path, frequency, &bound, "sort them"));
                }
                last = frequency;
            }
            Ok(())
        }
    }
}

/// Refuses a damping of nothing.
pub(super) fn check_damping(scene: &BodyInScene<'_>, damping: Option<VibrationDamping>) -> Verdict {
    let (s, at) = (&scene.scope(), format!("analysis.{}.damping", scene.analysis.kind().word));
    match damping {
        Some(VibrationDamping::Rayleigh(RayleighDamping { mass, stiffness }))
            if mass.get() == 0.0 && stiffness.get() == 0.0 =>
        {
            let repair = match scene.analysis {
                Analysis::Harmonic(_) => "leave `damping` out for none",
                _ => "give one of them, or write damping.ratio = …",
            };
            let bound = "`mass`, `stiffness` or both above zero";
            Err(s.value(&format!("{at}.rayleigh"), "nothing", bound, repair))
        }
        _ => Ok(()),
    }
}

/// Refuses what has no amplitude: what is no linear number of the motion.
fn check_swinging(scene: &BodyInScene<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    use Measured::{
        Acceleration, BendingMoment, Director, Displacement, MembraneForce, PlyStress, Reaction,
        ReactionMoment, Rotation, SectionForce, SectionMoment, ShearForce, Stress, Velocity,
    };
    let known = [
        Displacement,
        Velocity,
        Acceleration,
        Rotation,
        Director,
        Reaction,
        ReactionMoment,
        Stress,
        MembraneForce,
        BendingMoment,
        ShearForce,
        PlyStress,
        SectionForce,
        SectionMoment,
    ];
    let s = &scene.scope();
    if !known.contains(&probe.of) {
        let words = known.map(Measured::word).join(", ");
        let what = scene.analysis.kind().name;
        let bound = format!("what goes with the motion in proportion in {what}: {words}");
        let fault =
            s.fault(&probe.at("of"), &format!("\"{}\"", probe.of.word()), &bound, "measure one of these");
        return Err(SceneError::Choice(fault));
    }
    if matches!(probe.taken(), Take::Max | Take::Min) {
        let what = scene.analysis.kind().name;
        let bound =
            format!("\"mean\" or \"sum\" in {what}: particles reach their greatest at times of their own");
        let repair = "remove it, or name the particle";
        let word = if probe.taken() == Take::Max { "\"max\"" } else { "\"min\"" };
        return Err(SceneError::Choice(s.fault(&probe.at("take"), word, &bound, repair)));
    }
    Ok(())
}

/// The columns of phases, beside those of amplitudes.
pub(super) fn phases(scene: &BodyInScene<'_>) -> Vec<String> {
    match scene.analysis {
        Analysis::Harmonic(_) => scene.curve.iter().map(|probe| phase_of(&probe.name)).collect(),
        _ => Vec::new(),
    }
}
