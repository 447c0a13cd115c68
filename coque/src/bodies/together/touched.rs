//! The contacts of a scene of several bodies: which bodies touch, and those that stand in each other at the start.

use contact::Law;

use super::contact::{Manner, Side, TouchingBodies};
use crate::bodies::shell::tools::{ROUNDED, TOUCHING};
use crate::scene::error::SceneError;
use crate::scene::{Analysis, Scene};

/// All contacts between some bodies of a scene, over the surfaces of those that they name.
///
/// # Errors
/// [`SceneError`] for bodies that stand in each other at the start.
pub(in crate::bodies) fn contacts(
    scene: &Scene,
    names: &[String],
    sides: &[Side],
) -> Result<Vec<TouchingBodies>, SceneError> {
    let marches = matches!(scene.analysis, Analysis::Explicit(_));
    let mut all = Vec::new();
    for (number, own) in scene.contact.iter().enumerate() {
        let Some(between) = own.pair() else { continue };
        let rounding = own.rounding.map_or(if marches { ROUNDED } else { 0.0 }, |rounding| rounding.get());
        let Some(law) = Law::new(rounding) else { continue };
        let side = |name: &String| {
            let body = names.iter().position(|known| known == name)?;
            Some(Side { body, ..sides.iter().find(|side| side.name == *name)?.clone() })
        };
        let [Some(a), Some(b)] = [side(&between[0]), side(&between[1])] else { continue };
        let factor = own.stiffness.map_or(1.0, |factor| factor.get());
        let friction = own.friction.map_or(0.0, |friction| friction.get());
        let manner = Manner { law, factor, edges: marches, friction };
        let mut contact = TouchingBodies::new([a, b], names.len(), manner);
        refuse_depth(scene, number, &mut contact)?;
        all.push(contact);
    }
    Ok(all)
}

/// Refuses bodies that stand in each other before anything moves.
fn refuse_depth(scene: &Scene, number: usize, contact: &mut TouchingBodies) -> Result<(), SceneError> {
    let Some((depth, places)) = contact.depth_at_rest().filter(|(depth, _)| *depth > TOUCHING) else {
        return Ok(());
    };
    let [here, there] = places.map(|x| format!("[{:.4}, {:.4}, {:.4}]", x.x, x.y, x.z));
    let distance = contact.distance();
    let value = format!("two bodies with {here} and {there}, {:.4e} apart", (1.0 - depth) * distance);
    let bound = format!("the distance at which their faces touch ({distance:.4e}) apart or more");
    let repair = "move them apart, or leave the contact out";
    Err(SceneError::Choice(scene.scope().fault(&format!("contact[{number}]"), &value, &bound, repair)))
}
