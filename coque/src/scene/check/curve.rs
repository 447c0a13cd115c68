//! Checks of what is recorded: columns, frames, plot, checkpoints.

use std::collections::BTreeSet;

use super::gauges::{check_cut, check_gauge};
use super::harmonic::phases;
use super::sets::{check_set_name, only_on};
use super::stresses::{check_stress, check_stress_fields};
use crate::scene::analysis::Analysis;
use crate::scene::analysis_kind::Contacts;
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::column_unit::ColumnUnit;
use crate::scene::contact::ContactScene;
use crate::scene::curve::{Measured, Probe};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::output::Output;
use crate::scene::problem::BodyScene;
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::solid::SolidScene;
use crate::scene::source::suggest;
use crate::scene::tools::ToolScene;
use crate::scene::units::Length;

fn check_checkpoints(scene: &BodyInScene<'_>) -> Verdict {
    let Some(every) = scene.output.checkpoint_every else { return Ok(()) };
    let path = "output.checkpoint_every";
    let kind = scene.analysis.kind();
    if !kind.resumes {
        let what = kind.name;
        let bound = format!("left out in {what}, which cannot go on from its middle");
        let repair = "remove it, or use [analysis.explicit], [analysis.static] or [analysis.relaxation]";
        return Err(scene.scope().value(path, every, &bound, repair));
    }
    Ok(())
}

/// Refuses what the body has not, and a direction where there is nothing to take a component of.
fn check_measured(scene: &BodyInScene<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    let (s, word) = (&scene.scope(), probe.of.word());
    let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(&probe.at(key), value, bound, repair)))
    };
    let known: Vec<&str> = measured(scene).iter().map(|of| of.word()).collect();
    if !known.contains(&word) {
        let body = match scene.body {
            BodyScene::Walls(_) => "walls have",
            BodyScene::Shell(_) => "a shell has",
            BodyScene::Solid(_) => "a solid has",
            BodyScene::Fluid(_) => "a fluid has",
            BodyScene::Rigid(_) => "a rigid body has",
        };
        let bound = format!("what {body}: {}", known.join(", "));
        let repair = match probe.of {
            Measured::LinkForce => "measure one of these, or add the [[links]] that hold it",
            Measured::JointForce | Measured::JointMoment if scene.as_rigid().is_some() => {
                "measure one of these, or add the [[joints]] that hold it"
            }
            _ => "measure one of these",
        };
        return refuse("of", &format!("\"{word}\""), &bound, repair);
    }
    let walls = matches!(scene.body, BodyScene::Walls(_));
    if walls && matches!(probe.of, Measured::Force | Measured::Moment) && scene.sets.contains_key(probe.on) {
        let bound =
            format!("but the {word} of a fluid is that on all walls of a body, or on a side of a basin");
        let (value, repair) = (format!("\"{}\"", probe.on), "use on = \"NAME.all\", or a side");
        return Err(SceneError::Set(s.fault(&probe.at("on"), &value, &bound, repair)));
    }
    if probe.of == Measured::Velocity && !has_velocity(scene.analysis) {
        let bound = format!("no velocity in {}", scene.analysis.kind().name);
        return refuse("of", "\"velocity\"", &bound, "use [analysis.explicit.transient]");
    }
    check_joint(scene, probe)?;
    check_enclosed(scene, probe)?;
    check_stress(scene, probe)?;
    check_cut(scene, probe)?;
    check_measured_alike(scene.body, s, probe)
}

/// Whether particles have a velocity in it.
fn has_velocity(analysis: &Analysis) -> bool {
    analysis.kind().passes_time || analysis.swings()
}

/// A joint is named of what joints exert, and is one of the body.
fn check_joint(scene: &BodyInScene<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    if probe.of.is_of_joints() {
        only_on(scene, probe, "joints hold all of a rigid body", &["all"])?;
    }
    let Some(name) = &probe.joint else { return Ok(()) };
    let s = scene.scope();
    let (path, value) = (probe.at("joint"), format!("\"{name}\""));
    if !probe.of.is_of_joints() {
        let bound = format!("none: {} is none of a joint", probe.of.word());
        let repair = "remove `joint`, or measure joint-force or joint-moment";
        return Err(SceneError::Choice(s.fault(&path, &value, &bound, repair)));
    }
    let own = scene.scene.joints.iter().filter(|joint| joint.is_of(scene.name));
    let known: Vec<&str> = own.filter_map(|joint| joint.name.as_deref()).collect();
    if known.contains(&name.as_str()) {
        return Ok(());
    }
    let repair = match known[..] {
        [] => "give that joint a `name` in [[joints]]".into(),
        _ => suggest(name, &known),
    };
    let bound = format!("which is the name of no joint of `{}`", scene.name);
    Err(SceneError::Set(s.fault(&path, &value, &bound, &repair)))
}

/// What is enclosed is measured on the set of its load.
fn check_enclosed(scene: &BodyInScene<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    if !matches!(probe.of, Measured::EnclosedPressure | Measured::EnclosedVolume) {
        return Ok(());
    }
    let sets: Vec<&str> = scene.loads.iter().filter(|load| load.encloses()).map(|load| load.on).collect();
    if sets.contains(&probe.on) {
        return Ok(());
    }
    let named: Vec<String> = sets.iter().map(|on| format!("\"{on}\"")).collect();
    let (bound, repair) = ("the set of no `gas` and no `volume`", format!("write {}", named.join(" or ")));
    let fault = scene.scope().fault(&probe.at("on"), &format!("\"{}\"", probe.on), bound, &repair);
    Err(SceneError::Set(fault))
}

/// Refuses a direction where there is nothing to take a component of, points and sections of what has none.
pub(super) fn check_measured_alike(body: &BodyScene, s: &Scope<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    check_gauge(body, s, probe)?;
    let word = probe.of.word();
    let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(&probe.at(key), value, bound, repair)))
    };
    if let Some(about) = &probe.about {
        let moments = [
            Measured::Moment,
            Measured::ReactionMoment,
            Measured::ContactMoment,
            Measured::JointMoment,
            Measured::SectionMoment,
        ];
        if !moments.contains(&probe.of) {
            let bound = format!("none: {word} is about no point");
            return refuse("about", "a point", &bound, "remove `about`, or measure a moment");
        }
        s.sized_all(&probe.at("about"), about)?;
    }
    match probe.direction {
        Some(_) if probe.of.is_scalar() => {
            let bound = format!("none: {word} is a number");
            refuse("direction", "a direction", &bound, "remove `direction`")
        }
        None if !probe.of.is_scalar() => {
            let key = probe.at("direction");
            let parent = key.trim_end_matches(".direction");
            let repair = format!("add `direction = …` in `{parent}`");
            let bound = "given: it has no default";
            Err(SceneError::Missing(s.fault(&key, "nothing", bound, &repair)))
        }
        None => Ok(()),
        Some(direction) => s.direction(&probe.at("direction"), direction),
    }
}

/// Refuses a unit that is none of what the column measures.
fn check_unit(scene: &BodyInScene<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    let Some(unit) = probe.unit.as_ref().filter(|_| scene.scene.unit_of(probe).is_none()) else {
        return Ok(());
    };
    let bare = scene.scene.units.length == Length::None;
    let (bound, repair) = match bare {
        true => ("none: the scene has no units".into(), "remove `unit`, or give the scene units"),
        false if unit == "-" => (
            "a unit, or \"-\" beside a `factor` that makes the column a ratio".into(),
            "give the factor, or remove `unit`",
        ),
        false => {
            let fitting = ColumnUnit::fitting(scene.scene.quantity(probe.of));
            (format!("a unit of {}: {fitting}", probe.of.word()), "write one of these")
        }
    };
    Err(SceneError::Choice(scene.scope().fault(&probe.at("unit"), &format!("\"{unit}\""), &bound, repair)))
}

/// What can be measured on the body.
fn measured(scene: &BodyInScene<'_>) -> Vec<Measured> {
    let mut known = measured_alone(scene);
    known.extend(scene.linked.then_some(Measured::LinkForce));
    if scene.scene.joints.iter().any(|joint| joint.is_of(scene.name)) {
        known.extend([Measured::JointForce, Measured::JointMoment]);
    }
    if scene.glued {
        known.push(Measured::GlueForce);
        known.extend(scene.as_rigid().is_none().then_some(Measured::GlueGap));
    }
    known
}

/// The same but for what glue does.
fn measured_alone(scene: &BodyInScene<'_>) -> Vec<Measured> {
    if matches!(scene.analysis, Analysis::Heat(_)) {
        return vec![Measured::Temperature, Measured::HeldHeat, Position];
    }
    use Measured::{
        Acceleration, BarForce, BarMoment, BendingMoment, ContactForce, ContactGap, ContactMoment, Damage,
        Density, Director, Displacement, EnclosedPressure, EnclosedVolume, Energy, FailureIndex, Flux, Force,
        FractureEnergy, FrictionLoss, GreatestDepth, Level, MaxPrincipal, MembraneForce, MinPrincipal,
        Moment, Pieces, PlasticStrain, PlasticWork, PlyStress, Position, Pressure, PrincipalAngle, Reaction,
        ReactionMoment, ReserveFactor, Rotation, SectionForce, SectionMoment, ShearForce, StrainEnergy,
        Stress, Thickness, TouchingArea, Tresca, Velocity, VonMises, WetLength,
    };
    match scene.body {
        BodyScene::Fluid(_) => {
            return vec![Displacement, Position, Velocity, Pressure, Density, Level, WetLength, Flux];
        }
        BodyScene::Walls(_) => {
            return vec![Displacement, Position, Pressure, Level, WetLength, Force, Moment];
        }
        BodyScene::Rigid(_) => {
            let mut known = vec![Displacement, Position, Velocity, Rotation, Reaction, ReactionMoment];
            if scene.may_touch() {
                known.extend([ContactForce, ContactMoment]);
            }
            known.extend(rubs(scene).then_some(FrictionLoss));
            return known;
        }
        BodyScene::Shell(_) | BodyScene::Solid(_) => {}
    }
    let solid = scene.as_solid();
    let stresses = [VonMises, Stress, MaxPrincipal, MinPrincipal, Tresca];
    if solid.is_some_and(|solid| solid.galerkin().is_some()) {
        let touching = [ContactForce, ContactMoment, ContactGap, GreatestDepth, TouchingArea];
        let touching = touching.into_iter().filter(|_| scene.may_touch());
        let yielding = [PlasticStrain, PlasticWork];
        let yielding = yielding.into_iter().filter(|_| solid.is_some_and(|own| own.material.yields()));
        let accelerated = scene.analysis.swings().then_some(Acceleration);
        let known = [Displacement, Position, Reaction].into_iter().chain(accelerated).chain(stresses);
        return known.chain(yielding).chain(touching).collect();
    }
    let mut known = vec![Displacement, Position, Reaction, Velocity];
    known.extend(scene.analysis.swings().then_some(Acceleration));
    if solid.is_none_or(SolidScene::has_directors) {
        known.extend([Rotation, Director]);
    }
    if scene.may_touch() {
        known.extend([ContactForce, ContactMoment, ContactGap, GreatestDepth, TouchingArea]);
    }
    known.extend(rubs(scene).then_some(FrictionLoss));
    if scene.as_shell().is_some_and(ShellScene::yields) {
        known.extend([PlasticStrain, Thickness, PlasticWork]);
    }
    if scene.as_shell().is_some_and(|shell| !shell.stiffeners.is_empty()) {
        known.extend([BarForce, BarMoment]);
    }
    if scene.loads.iter().any(|load| load.encloses()) {
        known.extend([EnclosedPressure, EnclosedVolume]);
    }
    if solid.is_some_and(|own| own.material.yields()) {
        known.extend([PlasticStrain, PlasticWork]);
    }
    if let Some(solid) = solid {
        known.extend([Damage, FractureEnergy, Pieces, StrainEnergy]);
        known.extend(stresses.into_iter().filter(|_| !scene.in_fluid));
        // In space, of forces alone; a moment that swings was not looked at.
        let in_space = !solid.is_plane() && !solid.has_directors();
        known.extend((in_space && !scene.analysis.swings()).then_some(ReactionMoment));
    } else if !scene.in_fluid {
        known.extend([ReactionMoment, MembraneForce, BendingMoment, ShearForce, Energy]);
        known.extend(stresses);
        known.extend([PrincipalAngle, PlyStress, ReserveFactor, FailureIndex, SectionForce, SectionMoment]);
    }
    known
}

/// Whether the body touches anything with friction.
fn rubs(scene: &BodyInScene<'_>) -> bool {
    let between = |contact: &ContactScene| contact.is_rough() && contact.is_of(scene.name);
    scene.body.tools().iter().any(ToolScene::is_rough) || scene.scene.contact.iter().any(between)
}

pub(super) fn check_curve(scene: &BodyInScene<'_>) -> Verdict {
    let s = &scene.scope();
    let phases = phases(scene);
    let mut names: BTreeSet<&str> =
        scene.scene.first_columns().chain(phases.iter().map(String::as_str)).collect();
    for probe in &scene.curve {
        check_column_name(s, &probe.at("name"), &probe.name, &mut names)?;
        check_set_name(scene, &probe.at("on"), probe.on)?;
        check_measured(scene, probe)?;
        if scene.as_rigid().is_some() && matches!(probe.of, Measured::Reaction | Measured::ReactionMoment) {
            only_on(scene, probe, "supports hold all of a rigid body", &["all"])?;
        }
        if probe.of == Measured::Pieces {
            let why = "pieces are counted of the whole body";
            only_on(scene, probe, why, &["all"])?;
        }
        s.sized(&probe.at("factor"), probe.factor)?;
        check_unit(scene, probe)?;
    }
    check_stress_fields(scene)?;
    if scene.output.over_time && !scene.analysis.kind().passes_time {
        let bound = format!("false in {}: no time passes", scene.analysis.kind().name);
        let repair = "remove it, or use [analysis.explicit.transient]";
        return Err(SceneError::Choice(s.fault("output.over_time", "true", &bound, repair)));
    }
    if scene.output.fields.is_some_and(|fields| fields.every == 0) {
        return Err(s.value("output.fields.every", 0, "1 or more", "1 writes every frame"));
    }
    if scene.output.fields.is_some_and(|fields| fields.contact) && !scene.any_may_touch() {
        let bound = "none where nothing may touch: no tool, no [[contact]]";
        let fault = s.fault("output.fields.contact", "fields of contact", bound, "remove it");
        return Err(SceneError::Choice(fault));
    }
    if scene.output.fields.is_some_and(|fields| fields.contact)
        && scene.analysis.kind().contacts == Contacts::Frozen
    {
        let bound = format!(
            "none in {}: modes are no states, and contact stays as it was",
            scene.analysis.kind().name
        );
        let fault = s.fault("output.fields.contact", "fields of contact", &bound, "remove it");
        return Err(SceneError::Choice(fault));
    }
    if scene.output.fields.is_some_and(|fields| fields.points)
        && scene.as_solid().is_none_or(|solid| solid.galerkin().is_none())
    {
        let (value, bound) = ("quadrature points", "none but of a Galerkin solid");
        let fault = s.fault("output.fields.points", value, bound, "remove it");
        return Err(SceneError::Choice(fault));
    }
    if !scene.together {
        check_plot(s, scene.output, &names)?;
    }
    check_checkpoints(scene)
}

/// Refuses a name that is no word, and one that is taken.
pub(super) fn check_column_name<'a>(
    s: &Scope<'_>,
    path: &str,
    name: &'a str,
    names: &mut BTreeSet<&'a str>,
) -> Verdict {
    let plain = |c: char| c.is_alphanumeric() || "_-.'".contains(c);
    if name.is_empty() || !name.chars().all(plain) {
        let repair = "it becomes a column name: use letters, digits, _ and -";
        return Err(s.value(path, format!("\"{name}\""), "a plain word", repair));
    }
    if !names.insert(name) {
        let taken = Vec::from_iter(names.iter().copied()).join(", ");
        let repair = format!("rename it; taken already: {taken}");
        return Err(s.value(path, format!("\"{name}\""), "a name of its own", &repair));
    }
    Ok(())
}

/// A plot shows columns that there are.
pub(super) fn check_plot(s: &Scope<'_>, output: &Output, names: &BTreeSet<&str>) -> Verdict {
    let Some(plot) = &output.plot else { return Ok(()) };
    let known = Vec::from_iter(names.iter().copied());
    s.word("output.plot.x", &plot.x, &known)?;
    s.word("output.plot.y", &plot.y, &known)
}
