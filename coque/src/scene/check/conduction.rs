//! Checks of heat that is conducted: what takes part, what it wants of materials, what tells the temperature.

use explicit_dynamics::Amplitude;

use super::amplitude::check_amplitude;
use super::heat_alone::{conducted, refuse_mechanics};
use super::sets::check_set_name;
use super::solid::check_conduction_of_solid;
use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::heat::HeatScene;
use crate::scene::output::Fields;
use crate::scene::problem::Scene;
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::formulation::{Formulation, Reach};
use crate::scene::shell::material::Material;
use crate::scene::statics::HeatInTime;

/// Refuses heat among bodies that are built together.
pub(super) fn check_heat_alone(scene: &Scene) -> Verdict {
    if scene.heat.is_empty() && !matches!(scene.analysis, Analysis::Heat(_)) {
        return Ok(());
    }
    let (path, value) = if scene.heat.is_empty() { ("analysis.heat", "heat") } else { ("heat", "heat") };
    let bound = "none among several bodies or with tools: one shell or one solid alone conducts it";
    Err(SceneError::Choice(scene.scope().fault(path, value, bound, "remove it, or the other bodies")))
}

/// Refuses heat of what does not conduct, heat that nobody asks for, and temperatures that nothing tells.
pub(super) fn check_conduction(scene: &BodyInScene<'_>) -> Verdict {
    let (s, heat) = (&scene.scope(), &scene.scene.heat);
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(path, value, bound, repair)))
    };
    let analysed = matches!(scene.analysis, Analysis::Heat(_));
    let transient = in_time(scene.analysis);
    let starts = transient.is_some_and(|run| run.start.is_some());
    let asked = scene.loads.iter().find(|load| conducted(load));
    if !analysed && asked.is_none() {
        if heat.is_empty() {
            return Ok(());
        }
        let bound = "none that nobody asks for";
        let repair = "use [analysis.heat], or a load with `temperature = { conducted = { over = 20.0 } }`";
        return refuse("heat", "heat", bound, repair);
    }
    let path = asked.map_or("analysis.heat".to_string(), |load| load.at("temperature.conducted"));
    if let Some(solid) = scene.as_solid() {
        check_given(scene, starts)?;
        return check_conduction_of_solid(scene, solid, transient.is_some());
    }
    let Some(shell) = scene.as_shell() else {
        let bound = format!("none on a {}: shells and solids conduct heat", scene.body.word());
        return refuse(&path, "heat", &bound, "remove it, or model the body as a shell or a solid");
    };
    if !matches!(&shell.formulation, Formulation::StressPoint(f) if f.support == Reach::Cell) {
        let bound = "none but where gradients are sampled in cells";
        return refuse(&path, "heat", bound, "use [formulation.stress-point] without `support`, the default");
    }
    if !shell.ties.is_empty() {
        let bound = "none across ties, which hand on no heat";
        return refuse(&path, "heat", bound, "let the sheets share particles, or leave one of them out");
    }
    check_given(scene, starts)?;
    if let Some(i) = heat.iter().position(|own| own.source.is_some()) {
        let repair = "use `flux`, the source times the thickness";
        return refuse(&format!("heat[{i}].source"), "a source by volume", "none of a shell", repair);
    }
    check_conductivities(shell, &scene.body_scope(), transient.is_some())?;
    if analysed { check_without_mechanics(scene, shell) } else { Ok(()) }
}

/// Refuses a list of heat that is empty or tells no temperature, and what is out of bounds in it.
fn check_given(scene: &BodyInScene<'_>, starts: bool) -> Verdict {
    let (s, heat) = (&scene.scope(), &scene.scene.heat);
    if heat.is_empty() {
        let edge = if scene.as_solid().is_some() { "x0" } else { "u0" };
        let repair =
            format!("add [[heat]] with what holds the temperature, such as on = \"{edge}\", held = 100.0");
        let bound = format!("what holds and heats the {}", scene.body.word());
        return Err(SceneError::Missing(s.fault("heat", "nothing", &bound, &repair)));
    }
    for (i, own) in heat.iter().enumerate() {
        check_kind(scene, own, &format!("heat[{i}]"))?;
        check_course(scene, own, &format!("heat[{i}]"))?;
    }
    if !starts && !heat.iter().any(HeatScene::tells) {
        let bound = "something that tells the temperature: any level of it would do beside heat alone";
        let repair = "hold a set by `held`, or give faces a `film` or `radiation`";
        return Err(SceneError::Choice(s.fault("heat", "given heat alone", bound, repair)));
    }
    Ok(())
}

/// How temperatures go in time, where they do.
fn in_time(analysis: &Analysis) -> Option<&HeatInTime> {
    if let Analysis::Heat(wanted) = analysis { wanted.transient.as_ref() } else { None }
}

/// Refuses a course where temperatures have none, and one that goes below absolute zero.
fn check_course(scene: &BodyInScene<'_>, own: &HeatScene, at: &str) -> Verdict {
    let Some(amplitude) = &own.amplitude else { return Ok(()) };
    let (s, path) = (&scene.scope(), format!("{at}.amplitude"));
    if in_time(scene.analysis).is_none() {
        let bound = "none but in [analysis.heat.transient], in which temperatures go in time";
        let repair = "remove it, or use [analysis.heat.transient]";
        return Err(SceneError::Choice(s.fault(&path, "a course in time", bound, repair)));
    }
    check_amplitude(scene, &path, amplitude)?;
    let Some(radiation) = &own.radiation else { return Ok(()) };
    let factors = match amplitude {
        Amplitude::Constant => vec![1.0],
        Amplitude::Ramp(_) | Amplitude::Smooth(_) => vec![0.0, 1.0],
        Amplitude::Sine { .. } => vec![-1.0, 1.0],
        Amplitude::Table(points) => points.iter().map(|point| point[1]).collect(),
    };
    let least =
        factors.into_iter().map(|factor| factor * radiation.surroundings).fold(f64::INFINITY, f64::min);
    if least < radiation.zero {
        let bound = format!("a course that leaves them at or above absolute zero, {}", radiation.zero);
        let repair = "let it go by a `table` whose factors times `surroundings` are temperatures";
        return Err(s.value(&path, format!("down to {least}"), &bound, repair));
    }
    Ok(())
}

/// Refuses numbers out of bounds of one condition.
fn check_kind(scene: &BodyInScene<'_>, own: &HeatScene, at: &str) -> Verdict {
    let s = &scene.scope();
    s.exactly_one(at, "kind", &own.given(), &HeatScene::WORDS)?;
    check_set_name(scene, &format!("{at}.on"), &own.on)?;
    for (key, number) in [
        ("held", own.held),
        ("flow", own.flow),
        ("flux", own.flux),
        ("edge_flux", own.edge_flux),
        ("source", own.source),
    ] {
        s.sized(&format!("{at}.{key}"), number.unwrap_or_default())?;
    }
    if let Some(film) = &own.film {
        s.sized(&format!("{at}.film.ambient"), film.ambient)?;
    }
    let Some(radiation) = &own.radiation else { return Ok(()) };
    let key = |key: &str| format!("{at}.radiation.{key}");
    s.within(
        &key("emissivity"),
        radiation.emissivity,
        [0.0, 1.0],
        "a black face has 1, polished metal some 0.05",
    )?;
    s.sized(&key("zero"), radiation.zero)?;
    s.sized(&key("surroundings"), radiation.surroundings)?;
    if radiation.surroundings < radiation.zero {
        let bound = format!("at least absolute zero, {}", radiation.zero);
        let repair = "give temperatures in kelvins, or `zero = -273.15` for degrees Celsius";
        return Err(s.value(&key("surroundings"), radiation.surroundings, &bound, repair));
    }
    Ok(())
}

/// Refuses materials that do not say how they conduct, and of temperatures in time what they store.
fn check_conductivities(shell: &ShellScene, s: &Scope<'_>, in_time: bool) -> Verdict {
    let parts = (0..shell.parts.len()).map(|i| (shell.in_part(i), s.below(&format!("parts[{i}]"))));
    for (own, at) in std::iter::once((shell.clone(), s.clone())).chain(parts) {
        for material in own.section.materials(&own.material) {
            let given = match material {
                Material::Elastic(elastic) => elastic.conductivity.is_some(),
                Material::Orthotropic(orthotropic) => orthotropic.conductivity.is_some(),
                other => {
                    let path = format!("material.{}", other.word());
                    let bound = "elastic or orthotropic: other materials have no conductivity";
                    let repair = "give the shell an elastic material for its heat";
                    return Err(SceneError::Choice(at.fault(&path, "heat", bound, repair)));
                }
            };
            if in_time && material.heat_by_volume().is_none() {
                let path = format!("material.{}.specific_heat", material.word());
                let bound = "the specific heat of every material that warms in time";
                let repair = "add it, in squares of length by time and by temperature, J/(kg K) of newtons, metres and seconds";
                return Err(SceneError::Missing(at.fault(&path, "nothing", bound, repair)));
            }
            if !given {
                let path = format!("material.{}.conductivity", material.word());
                let bound = "a conductivity of every material through which heat runs";
                let fault = at.fault(&path, "nothing", bound, "add it, in force by time and temperature");
                return Err(SceneError::Missing(fault));
            }
        }
    }
    Ok(())
}

/// Refuses what moves or presses, which temperatures alone do not know of.
fn check_without_mechanics(scene: &BodyInScene<'_>, shell: &ShellScene) -> Verdict {
    let fields = scene.output.fields;
    let found = [
        ("supports", scene.supports.is_empty()),
        ("loads", scene.loads.is_empty()),
        ("initial_stress", shell.initial_stress.is_empty()),
        ("tools", shell.tools.is_empty()),
        ("masses", shell.masses.is_empty()),
        ("stiffeners", shell.stiffeners.is_empty()),
        ("rigid", shell.rigid.is_empty()),
        ("velocity", shell.velocity.is_none()),
        ("output.fields", !fields.is_some_and(Fields::shows_stresses)),
    ];
    let found = found.into_iter().find(|(_, none)| !none);
    found.map_or(Ok(()), |(key, _)| refuse_mechanics(scene, key))
}
