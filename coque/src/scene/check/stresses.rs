//! Checks of stresses: through which height, of which ply, by which criterion; in columns and in the files of fields.

use super::super::criterion::Criterion;
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::curve::{Measured, Probe};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::output::Fields;
use crate::scene::problem::BodyScene;
use crate::scene::shell::ShellScene;
use crate::scene::shell::material::Material;
use crate::scene::shell::section::Section;

/// Refuses faces, plies, components and criteria of what has none, what lacks one, and stresses that do not run as they would have to.
pub(super) fn check_stress(scene: &BodyInScene<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    check_keys(scene, probe)?;
    let Some(shell) = scene.as_shell() else { return Ok(()) };
    let of = probe.of;
    if of.is_of_stress() || of == Measured::PrincipalAngle {
        check_linear(scene, shell, probe)?;
    }
    if !of.is_of_plies() {
        return Ok(());
    }
    let value = format!("\"{}\"", of.word());
    check_by_plies(scene, shell, &probe.at("of"), &value)?;
    if of == Measured::PlyStress && !sections(shell).any(|own| plies(&own) > 0) {
        let repair = "measure `stress`, or give [section.layered]";
        return Err(SceneError::Choice(scene.scope().fault(
            &probe.at("of"),
            &value,
            "none without plies",
            repair,
        )));
    }
    let most = sections(shell).map(|own| plies(&own).max(1)).max().unwrap_or(1);
    if let Some(ply) = probe.ply.filter(|ply| ply.get() > most) {
        let bound = format!("from 1, the lowest, to {most}");
        return Err(scene.scope().value(&probe.at("ply"), ply, &bound, "count the plies from the lowest"));
    }
    match probe.criterion {
        Some(criterion) => check_criterion(scene, shell, criterion, &probe.at("criterion")),
        None => Ok(()),
    }
}

/// Keys of a column that belong to others, and those that it lacks.
fn check_keys(scene: &BodyInScene<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    let (s, of, word) = (&scene.scope(), probe.of, probe.of.word());
    let shell = matches!(scene.body, BodyScene::Shell(_));
    let judged = matches!(of, Measured::ReserveFactor | Measured::FailureIndex);
    let stress = of == Measured::PlyStress;
    let face = shell && (of.is_of_stress() || of == Measured::PrincipalAngle || stress);
    for (key, given, allowed, value, what) in [
        ("face", probe.face.is_some(), face, "a face", "of no face"),
        ("ply", probe.ply.is_some(), judged || stress, "a ply", "of no ply"),
        ("component", probe.component.is_some(), stress, "a component", "no stress of a ply"),
        ("criterion", probe.criterion.is_some(), judged, "a criterion", "judged by none"),
    ] {
        if given && !allowed {
            let bound = format!("none: {word} is {what}");
            return Err(SceneError::Choice(s.fault(
                &probe.at(key),
                value,
                &bound,
                &format!("remove `{key}`"),
            )));
        }
    }
    let faced = shell && matches!(of, Measured::Stress | Measured::PrincipalAngle) || stress;
    let of_ply = "add face = \"top\", \"bottom\" or \"middle\", of the ply";
    let of_shell = "add face = \"top\", to which the directors point, face = \"bottom\" or \"middle\"";
    for (key, given, wanted, repair) in [
        ("face", probe.face.is_some(), faced, if stress { of_ply } else { of_shell }),
        ("ply", probe.ply.is_some(), stress, "add its number from the lowest, as in ply = 1"),
        (
            "component",
            probe.component.is_some(),
            stress,
            "add component = \"along\", \"across\" or \"shear\"",
        ),
        (
            "criterion",
            probe.criterion.is_some(),
            judged,
            "add criterion = \"tsai-wu\", \"hashin\" or \"von-mises\"",
        ),
    ] {
        if wanted && !given {
            return Err(SceneError::Missing(s.fault(
                &probe.at(key),
                "nothing",
                "given: it has no default",
                repair,
            )));
        }
    }
    Ok(())
}

/// A shell and each of its parts.
fn sections(shell: &ShellScene) -> impl Iterator<Item = ShellScene> + '_ {
    (0..shell.parts.len()).map(|part| shell.in_part(part)).chain([shell.clone()])
}

/// The number of plies; zero of what has none.
fn plies(shell: &ShellScene) -> usize {
    match &shell.section {
        Section::Layered(section) => section.plies.len(),
        Section::Homogeneous(_) | Section::Stiffness(_) | Section::File(_) => 0,
    }
}

/// Stresses at faces are those of sections through which they run linearly.
fn check_linear(scene: &BodyInScene<'_>, shell: &ShellScene, probe: &OnSet<'_, Probe>) -> Verdict {
    if !sections(shell).any(|own| !own.section.homogeneous() || own.yields_itself()) {
        return Ok(());
    }
    let given = sections(shell).any(|own| matches!(own.section, Section::Stiffness(_)));
    let [bound, repair] = match shell.yields() {
        false if given => [
            "`membrane-force`, `bending-moment` or `shear-force` of a section of given stiffness, whose build is not known",
            "measure section forces, or describe the build by [section.layered]",
        ],
        true => [
            "`membrane-force`, `bending-moment`, `shear-force` or `plastic-strain` where a material yields",
            "measure section forces: stresses do not run linearly through the thickness",
        ],
        false => [
            "`ply-stress`, `reserve-factor`, `membrane-force`, `bending-moment` or `shear-force` on plies",
            "measure `ply-stress` of a ply, or section forces: stresses differ from ply to ply",
        ],
    };
    let value = format!("\"{}\"", probe.of.word());
    Err(SceneError::Choice(scene.scope().fault(&probe.at("of"), &value, bound, repair)))
}

/// Stresses of plies follow from strains where nothing has a memory, is of rubber or was under stress before.
fn check_by_plies(scene: &BodyInScene<'_>, shell: &ShellScene, path: &str, value: &str) -> Verdict {
    let refuse =
        |bound: &str, repair: &str| Err(SceneError::Choice(scene.scope().fault(path, value, bound, repair)));
    if sections(shell).any(|own| own.measure_of_law().is_some()) {
        let bound = "none of a shell with plasticity or rubber in it: stresses of its plies do not follow from its strains alone";
        return refuse(bound, "make its materials elastic or orthotropic, or measure section forces");
    }
    if !shell.initial_stress.is_empty() {
        let bound = "none beside [[initial_stress]], which does not say what each ply bears of it";
        return refuse(bound, "measure section forces, of a homogeneous shell `von-mises`");
    }
    Ok(())
}

/// A criterion wants a strength, and is one of the materials that have one.
fn check_criterion(scene: &BodyInScene<'_>, shell: &ShellScene, criterion: Criterion, path: &str) -> Verdict {
    let (mut fibres, mut plain) = (false, false);
    for own in sections(shell) {
        for material in own.section.materials(&own.material) {
            match material {
                Material::Orthotropic(own) => fibres |= own.strength.is_some(),
                Material::Elastic(own) => plain |= own.strength.is_some(),
                Material::Plastic(_) | Material::Rubber(_) | Material::Smeared(_) | Material::File(_) => {}
            }
        }
    }
    let value = format!("\"{}\"", criterion.word());
    let refuse =
        |bound: &str, repair: &str| Err(SceneError::Choice(scene.scope().fault(path, &value, bound, repair)));
    match criterion {
        _ if !(fibres || plain) => refuse(
            "that of a material with a `strength`, of which there is none",
            "add strength = 250.0 to an elastic material, to an orthotropic one strength = { along_tension = …, along_compression = …, across_tension = …, \
             across_compression = …, shear = … }",
        ),
        Criterion::VonMises if fibres => {
            refuse("\"tsai-wu\" or \"hashin\" where a fibre has strengths of its own", "write one of these")
        }
        Criterion::TsaiWu | Criterion::Hashin if !fibres => {
            refuse("\"von-mises\" where no fibre has strengths of its own", "write it")
        }
        _ => Ok(()),
    }
}

/// Stresses of plies and reserve factors of a shell that has them beside other bodies.
fn check_shown_plies(scene: &BodyInScene<'_>, shell: &ShellScene, fields: Fields) -> Verdict {
    if fields.plies && sections(shell).any(|own| plies(&own) > 0) {
        check_by_plies(scene, shell, "output.fields.plies", "stresses of plies")?;
    }
    let strong = |material: &Material| match material {
        Material::Orthotropic(own) => own.strength.is_some(),
        Material::Elastic(own) => own.strength.is_some(),
        _ => false,
    };
    let judged = sections(shell).any(|own| own.section.materials(&own.material).into_iter().any(strong));
    match fields.reserve.filter(|_| judged) {
        Some(criterion) => {
            let path = "output.fields.reserve";
            check_by_plies(scene, shell, path, &format!("\"{}\"", criterion.word()))?;
            check_criterion(scene, shell, criterion, path)
        }
        None => Ok(()),
    }
}

/// Fields of stresses that the body has not.
pub(super) fn check_stress_fields(scene: &BodyInScene<'_>) -> Verdict {
    let Some(fields) = scene.output.fields else { return Ok(()) };
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(scene.scope().fault(path, value, bound, repair)))
    };
    // Of several bodies those show them that have them; what one has must be right.
    if scene.together {
        return match scene.as_shell() {
            Some(shell) => check_shown_plies(scene, shell, fields),
            None => Ok(()),
        };
    }
    let principal = "principal stresses";
    match scene.as_shell() {
        None if fields.principal && scene.as_solid().is_none() => {
            return refuse(
                "output.fields.principal",
                principal,
                "none but of shells and solids",
                "remove it",
            );
        }
        None if fields.plies => {
            return refuse(
                "output.fields.plies",
                "stresses of plies",
                "none but of a shell of plies",
                "remove it",
            );
        }
        None if fields.reserve.is_some() => {
            return refuse("output.fields.reserve", "reserve factors", "none but of a shell", "remove it");
        }
        None => return Ok(()),
        Some(shell) => {
            if fields.principal
                && sections(shell).any(|own| !own.section.homogeneous() || own.yields_itself())
            {
                let bound = "none where stresses do not run linearly through the thickness: of plies and of what yields";
                let repair = "remove it; plies of elastic materials have `plies` and `reserve`";
                return refuse("output.fields.principal", principal, bound, repair);
            }
            if fields.plies {
                check_by_plies(scene, shell, "output.fields.plies", "stresses of plies")?;
                if !sections(shell).any(|own| plies(&own) > 0) {
                    let repair = "remove it: `stresses` has those of both faces";
                    return refuse("output.fields.plies", "stresses of plies", "none without plies", repair);
                }
            }
            if let Some(criterion) = fields.reserve {
                let path = "output.fields.reserve";
                check_by_plies(scene, shell, path, &format!("\"{}\"", criterion.word()))?;
                check_criterion(scene, shell, criterion, path)?;
            }
        }
    }
    Ok(())
}
