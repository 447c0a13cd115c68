//! The tools of the solids of a scene, and solids that stand in them at the start.

use contact::{Law, Mesh, Pose, Surface, ToolContact};

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
pub(in crate::bodies) fn on_tools(
    bodies: &[&BodyInScene<'_>],
    sides: &[Side],
) -> Result<Vec<OnTool>, SceneError> {
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
                surface: nodes_of(side),
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

/// The nodes of a surface, which hand on all of its area: of each triangle about the middle of a face a half to both of its nodes, where the middle
/// as a vertex has a third.
///
/// Middles are left out: on a tool of radius R they stand nearer to it than the nodes by the sag h²/8R of the chords between those, and in a contact
/// of half width a they would bear up to `κ h²/8R`, which is `2.5 h/a` of the greatest pressure `a E/2R` where κ is 10 E/h.
fn nodes_of(side: &Side) -> Surface {
    let vertices = side.mesh.surface().vertices();
    let whole = if vertices.iter().any(|vertex| vertex.nodes().len() > 1) { 1.5 } else { 1.0 };
    let nodes = vertices.iter().filter_map(|vertex| match vertex.nodes() {
        &[node] => Some((node, whole * vertex.area)),
        _ => None,
    });
    let nodes: Vec<(u32, f64)> = nodes.collect();
    Mesh::points(&nodes, 0.5 * side.thickness).surface().clone()
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
