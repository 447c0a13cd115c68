//! Checks of stresses: through which height, of which ply, by which criterion; in columns and in the files of fields.

use super::super::criterion::Criterion;
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::curve::{Measured, Probe};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::problem::BodyScene;
use crate::scene::shell::ShellScene;
use crate::scene::shell::formulation::Formulation;
use crate::scene::shell::material::Material;
use crate::scene::shell::parts::ShellPart;
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
    if of == Measured::PlyStress && !has_plies(shell) {
        let repair = "measure `stress`, or give [section.layered]";
        return Err(SceneError::Choice(scene.scope().fault(
            &probe.at("of"),
            &value,
            "none without plies",
            repair,
        )));
    }
    let most = sections(shell).map(|(_, section)| plies(section).max(1)).max().unwrap_or(1);
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
    let in_surface = matches!(of, Measured::MembraneForce | Measured::BendingMoment | Measured::ShearForce);
    let sampled = |shell: &ShellScene| matches!(shell.formulation, Formulation::StressPoint(_));
    let recovered = !stress && (face || in_surface) && scene.as_shell().is_some_and(sampled);
    let at_particles = "no stress or section force of a shell that is sampled in its cells";
    for (key, given, allowed, value, what) in [
        ("face", probe.face.is_some(), face, "a face", "of no face"),
        ("ply", probe.ply.is_some(), judged || stress, "a ply", "of no ply"),
        ("component", probe.component.is_some(), stress, "a component", "no stress of a ply"),
        ("criterion", probe.criterion.is_some(), judged, "a criterion", "judged by none"),
        ("recovered", probe.recovered, recovered, "values at particles", at_particles),
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

/// What each part of a shell is made of, then the shell.
fn sections<'a>(shell: &'a ShellScene) -> impl Iterator<Item = (&'a Material, &'a Section)> {
    let whole = (&shell.material, &shell.section);
    let own = move |part: &'a ShellPart| {
        (part.material.as_ref().unwrap_or(whole.0), part.section.as_ref().unwrap_or(whole.1))
    };
    shell.parts.iter().map(own).chain([whole])
}

/// Whether any of its materials is of a kind.
fn any_material(shell: &ShellScene, of: impl Fn(&Material) -> bool) -> bool {
    sections(shell).any(|(material, section)| section.materials(material).into_iter().any(&of))
}

/// Whether stresses run linearly through the thickness everywhere.
fn runs_linearly(shell: &ShellScene) -> bool {
    sections(shell).all(|(_, section)| section.homogeneous()) && !any_material(shell, Material::yields)
}

fn has_plies(shell: &ShellScene) -> bool {
    sections(shell).any(|(_, section)| plies(section) > 0)
}

/// The number of plies; zero of what has none.
fn plies(section: &Section) -> usize {
    match section {
        Section::Layered(section) => section.plies.len(),
        Section::Homogeneous(_) | Section::Stiffness(_) | Section::File(_) => 0,
    }
}

/// Stresses at faces are those of sections through which they run linearly.
fn check_linear(scene: &BodyInScene<'_>, shell: &ShellScene, probe: &OnSet<'_, Probe>) -> Verdict {
    if runs_linearly(shell) {
        return Ok(());
    }
    let given = sections(shell).any(|(_, section)| matches!(section, Section::Stiffness(_)));
    let [bound, repair] = match any_material(shell, Material::yields) {
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
    let one = if scene.together { format!("`{}`, a shell", scene.name) } else { "a shell".into() };
    if any_material(shell, |material| material.curvature().is_some()) {
        let bound = format!(
            "none of {one} with plasticity or rubber in it: stresses of its plies do not follow from its strains alone"
        );
        return refuse(&bound, "make its materials elastic or orthotropic, or measure section forces");
    }
    if !shell.initial_stress.is_empty() {
        let own = if scene.together { format!(" of `{}`", scene.name) } else { String::new() };
        let bound =
            format!("none beside [[initial_stress]]{own}, which does not say what each ply bears of it");
        return refuse(&bound, "measure section forces, of a homogeneous shell `von-mises`");
    }
    Ok(())
}

/// A criterion wants a strength, and is one of the materials that have one.
fn check_criterion(scene: &BodyInScene<'_>, shell: &ShellScene, criterion: Criterion, path: &str) -> Verdict {
    let [fibres, plain] = strengths(shell);
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

/// Whether any of its materials has strengths of a fibre, or one of its own.
fn strengths(shell: &ShellScene) -> [bool; 2] {
    [
        any_material(shell, |own| matches!(own, Material::Orthotropic(own) if own.strength.is_some())),
        any_material(shell, |own| matches!(own, Material::Elastic(own) if own.strength.is_some())),
    ]
}

/// Fields of stresses that the body has not, and that do not follow from what it is. Of several bodies those show them that have them: what one lacks
/// is then no fault.
pub(super) fn check_stress_fields(scene: &BodyInScene<'_>) -> Verdict {
    let Some(fields) = scene.output.fields else { return Ok(()) };
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(scene.scope().fault(path, value, bound, repair)))
    };
    let principal = "principal stresses";
    let (recovered, nodal) = ("output.fields.recovered", "stresses at particles from those of cells");
    match scene.as_shell() {
        None if scene.together => return Ok(()),
        None if fields.principal && scene.as_solid().is_none() => {
            return refuse(
                "output.fields.principal",
                principal,
                "none but of shells and solids",
                "remove it",
            );
        }
        None if fields.recovered => {
            let repair = "remove it; `stresses` and `principal` of solids are those of their nodes";
            return refuse(recovered, nodal, "none but of a shell", repair);
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
            if fields.principal && !scene.together && !runs_linearly(shell) {
                let bound = "none where stresses do not run linearly through the thickness: of plies and of what yields";
                let repair = "remove it; plies of elastic materials have `plies` and `reserve`";
                return refuse("output.fields.principal", principal, bound, repair);
            }
            if fields.recovered
                && !scene.together
                && !matches!(shell.formulation, Formulation::StressPoint(_))
            {
                let bound = "none where stresses are sampled at the particles";
                return refuse(recovered, nodal, bound, "remove it: `stresses` has them there");
            }
            if fields.plies && (has_plies(shell) || !scene.together) {
                check_by_plies(scene, shell, "output.fields.plies", "stresses of plies")?;
                if !has_plies(shell) {
                    let repair = "remove it: `stresses` has those of both faces";
                    return refuse("output.fields.plies", "stresses of plies", "none without plies", repair);
                }
            }
            let [fibres, plain] = strengths(shell);
            if let Some(criterion) = fields.reserve.filter(|_| fibres || plain || !scene.together) {
                let path = "output.fields.reserve";
                check_by_plies(scene, shell, path, &format!("\"{}\"", criterion.word()))?;
                // Beside the fibres of another body it is judged by its yield strength.
                if fibres || !scene.together {
                    check_criterion(scene, shell, criterion, path)?;
                }
            }
        }
    }
    Ok(())
}
