//! Checks of numbers that go with the temperature: their tables, and what heats the shell.

use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::levels::Levels;
use crate::scene::loads::{Load, Temperature};
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::material::{Elastic, Material};
use crate::scene::statics::{Relaxation, Static};

const KEY: &str = "material.elastic.by_temperature";

/// Refuses tables out of order, factors that make no material, and factors of what is not given.
pub(super) fn check_tables(elastic: &Elastic, s: &Scope<'_>) -> Verdict {
    let Some(own) = &elastic.by_temperature else { return Ok(()) };
    s.sized(&format!("{KEY}.reference"), own.reference)?;
    if own.tables().next().is_none() {
        let repair = "give factors of `young`, `poisson`, `expansion` or `conductivity`, such as young = [[20, 1.0], [400, 0.7]]";
        return Err(SceneError::Missing(s.fault(KEY, "no table", "a table at least", repair)));
    }
    for (key, table) in own.tables() {
        let at = format!("{KEY}.{key}");
        for (i, [temperature, factor]) in table.iter().enumerate() {
            s.sized(&format!("{at}[{i}][0]"), *temperature)?;
            s.positive(&format!("{at}[{i}][1]"), *factor)?;
            if key == "poisson" {
                let bound = if elastic.poisson == 0.0 { f64::INFINITY } else { 0.5 / elastic.poisson.abs() };
                let repair = "Poisson's ratio stays below 1/2: the factor multiplies `poisson`";
                s.between(&format!("{at}[{i}][1]"), *factor, [0.0, bound], repair)?;
            }
        }
        if table.is_empty() || table.windows(2).any(|pair| pair[0][0] >= pair[1][0]) {
            let bound = "a list of [temperature, factor] with ascending temperatures";
            return Err(s.value(&at, "empty or out of order", bound, "sort it by temperature"));
        }
    }
    let wanting = [
        ("expansion", own.expansion.is_some() && elastic.expansion.is_none()),
        ("conductivity", own.conductivity.is_some() && elastic.conductivity.is_none()),
    ];
    if let Some((key, _)) = wanting.into_iter().find(|(_, wanting)| *wanting) {
        let path = format!("material.elastic.{key}");
        return Err(SceneError::Missing(s.fault(
            &path,
            "nothing",
            "the number that factors multiply",
            "add it",
        )));
    }
    Ok(())
}

/// Refuses tables where the same stands for all cells: in plies.
pub(super) fn check_no_tables(elastic: &Elastic, s: &Scope<'_>) -> Verdict {
    if elastic.by_temperature.is_none() {
        return Ok(());
    }
    let bound =
        "none but of [section.homogeneous], whose numbers are those of the mean temperature of a cell";
    let repair = "remove it, or give [section.homogeneous]";
    Err(SceneError::Choice(s.fault(KEY, "numbers by temperature", bound, repair)))
}

/// Refuses loads that do not tell one temperature of each cell.
pub(in crate::scene::check) fn check_tabled_load(
    scene: &BodyInScene<'_>,
    shell: &ShellScene,
    load: &OnSet<'_, Load>,
    temperature: &Temperature,
) -> Verdict {
    let tabled = |own: &ShellScene| match &own.material {
        Material::Elastic(elastic) => elastic.by_temperature.as_ref().map(|own| own.reference),
        _ => None,
    };
    let parts = (0..shell.parts.len()).map(|i| shell.in_part(i));
    let references: Vec<f64> =
        std::iter::once(shell.clone()).chain(parts).filter_map(|own| tabled(&own)).collect();
    let Some(&reference) = references.first() else { return Ok(()) };
    let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(scene.scope().fault(&load.at(key), value, bound, repair)))
    };
    if temperature.difference.is_some_and(|own| own != 0.0) {
        let bound =
            "none where numbers go with the temperature: they are those of the mean through the thickness";
        let repair =
            "remove it, or give [section.layered] with a ply for each height, of materials of their own";
        return refuse("temperature.difference", "a difference", bound, repair);
    }
    if load.case.is_some() {
        let bound = "none where numbers go with the temperature: cases would have moduli of their own";
        return refuse("case", "a load case", bound, "remove it, and run each case as a scene");
    }
    if let Some(other) = references.iter().find(|own| **own != reference) {
        let bound = format!("{reference} everywhere: changes of temperature count from it");
        return Err(scene.scope().value(&format!("{KEY}.reference"), *other, &bound, "write the same"));
    }
    check_full_load(scene, load)?;
    match temperature.conducted {
        Some(own) if own.over != reference => {
            let bound =
                format!("{reference}, as `reference` of the material: both are where it is free of strain");
            Err(scene.scope().value(
                &load.at("temperature.conducted.over"),
                own.over,
                &bound,
                "write the same",
            ))
        }
        _ => Ok(()),
    }
}

/// Refuses analyses in which the load is not there once in full, whose temperatures the numbers are of.
fn check_full_load(scene: &BodyInScene<'_>, load: &OnSet<'_, Load>) -> Verdict {
    let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(scene.scope().fault(key, value, bound, repair)))
    };
    if load.preload {
        return Ok(());
    }
    let shakes = match &scene.analysis {
        Analysis::Harmonic(_) | Analysis::ResponseSpectrum(_) | Analysis::RandomVibration(_) => true,
        // What nothing holds is warm without stress.
        Analysis::Modal(_) => !scene.supports.is_empty(),
        Analysis::Static(Static { levels, .. }) | Analysis::Relaxation(Relaxation { levels, .. }) => {
            if matches!(levels, Levels::List(all) if all.iter().any(|level| *level > 1.0)) {
                let bound =
                    "levels up to one where numbers go with the temperature: they are those of the full load";
                let repair = "multiply the load itself, or add `preload = true` to the temperature";
                return refuse(
                    &format!("analysis.{}.levels", scene.analysis.kind().word),
                    "a level beyond one",
                    bound,
                    repair,
                );
            }
            false
        }
        _ => false,
    };
    if shakes {
        let bound =
            "one with `preload = true` where numbers go with it: what vibrates is warm and stressed by it";
        return refuse(&load.at("temperature"), "a temperature", bound, "add `preload = true` to the load");
    }
    Ok(())
}
