//! Checks of changes of temperature: what is heated, and in which analyses.

use super::shell::check_tabled_load;
use super::solid::check_temperature_of_solid;
use crate::scene::analysis::{Analysis, Explicit};
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::curve::Measured;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::loads::{Load, Temperature};
use crate::scene::shell::formulation::{Formulation, Reach};

/// Refuses changes that are none, bodies that do not expand, analyses without a place for it, and columns that do not know it.
pub(super) fn check_temperature(scene: &BodyInScene<'_>, load: &OnSet<'_, Load>) -> Verdict {
    let Some(Temperature { change, difference, conducted, values }) = &load.temperature else {
        return Ok(());
    };
    let (s, at) = (&scene.scope(), load.at("temperature"));
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(path, value, bound, repair)))
    };
    let heat = "a `temperature`";
    if scene.as_shell().is_none() && scene.as_solid().is_none() {
        let bound = format!("none on a {}: shells and solids expand", scene.body.word());
        return refuse(&at, heat, &bound, "remove it, or model the body as a shell or a solid");
    }
    if conducted.is_some() && (change.is_some() || difference.is_some() || values.is_some()) {
        let repair = "give the numbers to a load of their own: changes of one cell add up";
        let bound = "none beside `conducted`, which finds them";
        return refuse(&format!("{at}.conducted"), "a change that is given", bound, repair);
    }
    if conducted.is_some() && load.case.is_some() {
        let repair = "remove it, or give the change in numbers";
        let bound = "none of what is conducted, which combinations of cases do not multiply";
        return refuse(&load.at("case"), "a load case", bound, repair);
    }
    if let Some(own) = conducted {
        s.sized(&format!("{at}.conducted.over"), own.over)?;
    } else if change.is_none() && difference.is_none() {
        let (bound, repair) = (
            "`change`, `difference`, both, or `conducted`",
            "temperature = { change = 80.0 } heats all of the thickness",
        );
        return Err(SceneError::Choice(s.fault(&at, "no change", bound, repair)));
    }
    s.sized(&format!("{at}.change"), change.unwrap_or_default())?;
    s.sized(&format!("{at}.difference"), difference.unwrap_or_default())?;
    if scene.in_fluid {
        return refuse(&at, heat, "none of a body in a fluid", "remove it, or the fluid");
    }
    check_course(scene, load, &at)?;
    if let Some(solid) = scene.as_solid() {
        return check_temperature_of_solid(scene, load, solid);
    }
    let Some(shell) = scene.as_shell() else { return Ok(()) };
    if !matches!(&shell.formulation, Formulation::StressPoint(f) if f.support == Reach::Cell) {
        let bound = "none but where strains are sampled in cells";
        return refuse(&at, heat, bound, "use [formulation.stress-point] without `support`, the default");
    }
    if (0..shell.parts.len())
        .map(|part| shell.in_part(part))
        .chain([shell.clone()])
        .any(|own| own.measure_of_law().is_some())
    {
        let bound = "none of a shell with plasticity or rubber in it, whose laws do not know of heat";
        return refuse(&at, heat, bound, "make its materials elastic or orthotropic, or remove it");
    }
    if let Some(temperature) = &load.temperature {
        check_tabled_load(scene, shell, load, temperature)?;
    }
    match scene.curve.iter().find(|column| column.of == Measured::Energy) {
        None => Ok(()),
        Some(column) => {
            let bound = "none of a shell that is heated, whose part in it the column does not know";
            refuse(&column.at("of"), "\"energy\"", bound, "read the column `internal`, which every curve has")
        }
    }
}

/// Refuses heat that comes while time passes.
fn check_course(scene: &BodyInScene<'_>, load: &OnSet<'_, Load>, at: &str) -> Verdict {
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(scene.scope().fault(path, value, bound, repair)))
    };
    if matches!(&scene.analysis, Analysis::Explicit(Explicit { quasi_static: Some(_), .. })) {
        let bound = "none in a quasi-static run, whose balance of energy does not know of heat that comes";
        let repair = "use [analysis.static], which brings it up by levels as well";
        return refuse(at, "a `temperature`", bound, repair);
    }
    if load.amplitude.is_some() && scene.analysis.kind().passes_time {
        let bound = "none of a temperature, which is there from the start of a transient run";
        let repair = "remove it, or bring the temperature up by [analysis.static]";
        return refuse(&load.at("amplitude"), "a course in time", bound, repair);
    }
    Ok(())
}
