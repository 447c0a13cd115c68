//! The tools of the solids of a scene, and solids that stand in them at the start.

use contact::{Law, Pose, ToolContact};

use super::contact::Side;
use super::on_tool::{OnTool, ToolAt};
use crate::bodies::shell::tools::{ROUNDED, TOUCHING};
use crate::bodies::tool_shapes::shape;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, BodyScene};

/// What all solids and their tools do to each other, over the surfaces of the solids.
///
/// The law has no barrier: a smooth tool has an inside, from which what came there is pushed out again.
///
/// # Errors
/// [`SceneError`] for solids that stand in a tool at the start.
pub(super) fn on_tools(bodies: &[BodyInScene<'_>], sides: &[Side]) -> Result<Vec<OnTool>, SceneError> {
    let mut all = Vec::new();
    for (body, scene) in bodies.iter().enumerate() {
        let Some(side) = sides.iter().find(|side| side.name == scene.name) else { continue };
        let BodyScene::Solid(solid) = scene.body else { continue };
        let side = &Side { body, ..side.clone() };
        let rounding = if matches!(scene.analysis, Analysis::Explicit(_)) { ROUNDED } else { 0.0 };
        for (number, tool) in solid.tools.iter().enumerate() {
            let law = Law::new(tool.rounding.map_or(rounding, |rounding| rounding.get()));
            let shape = shape(tool, From::from).and_then(|shape| shape.checked().ok());
            let (Some(law), Some(shape)) = (law, shape) else { continue };
            let contact = ToolContact {
                tool: shape,
                surface: side.mesh.surface().clone(),
                law: law.open(),
                stiffness: side.stiffness * tool.stiffness.map_or(1.0, |factor| factor.get()),
            };
            refuse_depth(scene, number, &contact, side)?;
            let tool = ToolAt {
                number,
                name: tool.name.clone(),
                contact,
                motion: tool.moved.unwrap_or_default().into(),
                amplitude: tool.amplitude.clone().unwrap_or_default(),
            };
            all.push(OnTool::new(side, tool, bodies.len()));
        }
    }
    Ok(all)
}

/// Refuses a solid that stands in a tool before anything moves.
fn refuse_depth(
    scene: &BodyInScene<'_>,
    number: usize,
    contact: &ToolContact,
    side: &Side,
) -> Result<(), SceneError> {
    let deepest = contact.deepest(&Pose::default(), |a| side.rest[a as usize]);
    let Some((depth, place)) = deepest.filter(|(depth, _)| *depth > TOUCHING) else { return Ok(()) };
    let tool = &scene.body.tools()[number];
    let deep = 0.5 * depth * side.thickness;
    let place = format!("[{:.4}, {:.4}, {:.4}]", place.x, place.y, place.z);
    let value = format!("`{}`, {deep:.4e} deep in the solid at {place}", tool.name);
    let repair = "move the tool away by that depth, and let `moved` bring it";
    let bound = "off the faces of the solid, or on them";
    Err(scene.body_scope().value(&format!("tools[{number}]"), value, bound, repair))
}
