//! What structures and walls, and shells and their dry faces, do to each other at the start: refused, warned of, or watched.

use explicit_dynamics::BoundaryState;
use fluid_sph::Fluid;
use sph_core::Vec3;

use super::contact::{Contact, Inside};
use super::dry::Dry;
use super::layout::Layout;
use super::reach::Loose;
use super::structures::WettedBody;
use super::watch::{Watch, in_plane};
use crate::bodies::fluid::walls::BuiltWalls;
use crate::scene::FluidScene;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::warning::Warning;

/// What is watched of the structures, and what is doubtful about them at the start.
///
/// # Errors
/// [`SceneError::Value`] for water at a dry face, and for a structure in a wall that nothing holds there.
pub(super) fn watched(
    wanted: &FluidScene,
    fluid: &Fluid,
    walls: &[BuiltWalls<'_>],
    wets: &[(&str, WettedBody<'_>)],
    layout: &Layout,
) -> Result<(Watch, Vec<Warning>), SceneError> {
    if wets.is_empty() {
        return Ok(Default::default());
    }
    let places: Vec<Vec<Vec3>> = (wets.iter())
        .map(|(_, wet)| in_plane(fluid.dimensions(), &wet.made.body.configuration().present))
        .collect();
    let names: Vec<&str> = wets.iter().map(|(name, _)| *name).collect();
    let contact = Contact::new(walls, &layout.walls, fluid, (&names, &places));
    let (mut all_dry, mut warnings) = (Vec::new(), Vec::new());
    for (number, ((_, wet), places)) in wets.iter().zip(&places).enumerate() {
        all_dry.extend(dry(number, wet, fluid)?);
        let loose = Loose { scene: wet.scene, places, apart: wet.made.description.spacing };
        if let Some(inside) = contact.at_start(fluid, places).filter(|_| !loose.held(None)) {
            return Err(in_wall(wet.scene, &contact, inside));
        }
        warnings.extend(loose.may_reach(wanted, fluid.positions(), walls));
    }
    let names = wets.iter().map(|(name, _)| (*name).into()).collect();
    Ok((Watch { names, contact, dry: all_dry }, warnings))
}

/// The dry face of a shell, if it has one; refused where water stands at it.
fn dry(number: usize, wet: &WettedBody<'_>, fluid: &Fluid) -> Result<Option<Dry>, SceneError> {
    let Some(shell) = wet.scene.as_shell() else { return Ok(None) };
    let thin = wet.made.body.boundary_layout().thin.as_ref();
    let Some(dry) =
        Dry::new(number, shell.wet.unwrap_or_default(), thin, fluid.spacing(), fluid.dimensions())
    else {
        return Ok(None);
    };
    let mut state = BoundaryState::default();
    wet.made.body.boundary(&mut state);
    let [at_dry, at_wet] = dry.beside(&state, fluid.positions());
    if at_dry == 0 {
        return Ok(Some(dry));
    }
    let bound = format!(
        "the face that the fluid stands at, or both: {at_dry} of its particles are within a spacing of the {}, which is dry, where \
         they feel no shell and go through it",
        dry.word()
    );
    let other = if dry.word() == "front" { "back" } else { "front" };
    let repair = match at_wet {
        0 => format!("use wet = \"{}\", or turn the shell over (`placed`)", dry.word()),
        _ => "use wet = \"both\"".into(),
    };
    Err(wet.scene.body_scope().value("wet", format!("\"{other}\""), &bound, &repair))
}

/// The refusal of a structure in a wall.
fn in_wall(scene: &BodyInScene<'_>, contact: &Contact, inside: Inside) -> SceneError {
    let wall = contact.wall(inside.wall);
    let value = format!("a body that reaches {:.4} deep into `{wall}`", inside.depth);
    let bound = "one outside the walls, or held";
    let repair = format!("move it out of `{wall}`, or hold what is in there by a support");
    scene.body_scope().value("geometry", value, bound, &repair)
}
