//! The tools of the solids and rigid bodies of a scene, and those that stand in them at the start.

use contact::{Law, Mesh, Pose, Surface, ToolContact};
use sph_core::Vec3;

use super::contact::Side;
use super::on_tool::{OnTool, ToolAt};
use crate::bodies::refusal::in_tool;
use crate::bodies::shell::tools::{ROUNDED, TOUCHING};
use crate::bodies::tool_shapes::{inset, shape};
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, BodyScene};

/// Depth at which a node of a Galerkin solid would be through the face of a tool, over that at which other bodies touch its surface.
const THIN: f64 = 0.1;

/// What all solids, all rigid bodies and their tools do to each other, over the surfaces of the bodies; with each its places at rest \[L\].
///
/// The law has no barrier: a smooth tool has an inside, from which what came there is pushed out again.
///
/// # Errors
/// [`SceneError`] for bodies that stand in a tool at the start, and for round tools that are too thin.
pub(in crate::bodies) fn on_tools(
    bodies: &[(&BodyInScene<'_>, &[Vec3])],
    sides: &[Side],
) -> Result<Vec<OnTool>, SceneError> {
    let mut all = Vec::new();
    for (body, &(scene, rest)) in bodies.iter().enumerate() {
        let Some(side) = sides.iter().find(|side| side.name == scene.name) else { continue };
        let Some((side, inside)) = of_tools(scene.body, side, rest) else { continue };
        let side = &Side { body, ..side };
        let rounding = if matches!(scene.analysis, Analysis::Explicit(_)) { ROUNDED } else { 0.0 };
        for (number, tool) in scene.body.tools().iter().enumerate() {
            let law = Law::new(tool.rounding.map_or(rounding, |rounding| rounding.get()));
            let shape = shape(tool, From::from).and_then(|shape| shape.checked().ok());
            let (Some(law), Some(shape)) = (law, shape) else { continue };
            let contact = ToolContact {
                tool: inset(shape, inside).ok_or_else(|| too_thin(scene, number, inside))?,
                surface: nodes_of(side),
                law: law.open(),
                stiffness: side.stiffness * tool.stiffness.map_or(1.0, |factor| factor.get()),
            };
            refuse_depth(scene, number, &contact, side)?;
            let tool = ToolAt {
                number,
                name: tool.name.clone(),
                shape,
                contact,
                friction: tool.friction.map_or(0.0, |friction| friction.get()),
                motion: Pose {
                    moved: tool.moved.unwrap_or_default().into(),
                    angle: tool.turn.unwrap_or_default(),
                },
                amplitude: tool.amplitude.clone().unwrap_or_default(),
            };
            all.push(OnTool::new(side, tool, bodies.len()));
        }
    }
    Ok(all)
}

/// The surface of a body as tools touch it, its nodes being at rest at places \[L\], and how far the faces of tools stand inside of where it touches
/// them: nodes of bonds lie inside the faces by half a spacing. Of a Galerkin solid it is the faces themselves, since a distance from a smooth tool
/// has a sign and needs no room; κ = E/r is that of a depth a tenth of that at which other bodies touch. Of a rigid body it is the outer face of the
/// coat, κ = E/r of its thickness. None of a body whose tools are its own.
fn of_tools(body: &BodyScene, side: &Side, rest: &[Vec3]) -> Option<(Side, f64)> {
    let on_faces = |depth: f64, stiffness: f64| {
        let faces =
            Side { thickness: 2.0 * depth, stiffness, rest: rest.to_vec(), inside: None, ..side.clone() };
        Some((faces, depth))
    };
    match body {
        BodyScene::Solid(_) if side.inside.is_none() => Some((side.clone(), 0.0)),
        BodyScene::Solid(_) => on_faces(0.5 * THIN * side.thickness, side.stiffness / THIN),
        BodyScene::Rigid(rigid) => {
            let coat = rigid.coat?;
            on_faces(coat.thickness.get(), coat.young.get() / coat.thickness.get())
        }
        BodyScene::Shell(_) | BodyScene::Fluid(_) | BodyScene::Walls(_) => None,
    }
}

/// Refuses a round tool that is thinner than the depth at which a node would be through its face.
fn too_thin(scene: &BodyInScene<'_>, number: usize, depth: f64) -> SceneError {
    let value = format!("`{}`, a round tool of no more than {depth:.4e}", scene.body.tools()[number].name);
    let bound = match scene.body {
        BodyScene::Rigid(_) => "a radius greater than the thickness of the coat",
        _ => "a radius greater than a hundredth of the least spacing of the solid",
    };
    scene.body_scope().value(&format!("tools[{number}]"), value, bound, "give it a greater radius")
}

/// The nodes of a surface, which hand on all of its area: of each triangle about the middle of a face a half to both of its nodes, where the middle
/// as a vertex has a third.
///
/// What lies between nodes is left out, the middles of faces: on a tool of radius R they stand nearer to it than the nodes by the sag h²/8R of the
/// chords between those, and in a contact of half width a they would bear up to `κ h²/8R`, many times the greatest pressure `a E/2R`.
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

/// Refuses a body that stands in a tool before anything moves.
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
    let body = if scene.as_rigid().is_some() { "rigid body" } else { "solid" };
    let value = format!("`{}`, {deep:.4e} deep in the {body} at {place}", tool.name);
    Err(in_tool(scene, number, value, &format!("off the faces of the {body}, or on them")))
}
