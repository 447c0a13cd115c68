//! Walls of a fluid that a body touches: the same faces as tools of the body.

use super::contact::ContactScene;
use super::problem::{BodyScene, Scene};
use super::sets::OF_WALLS;
use super::tools::{ToolBlock, ToolPlane, ToolScene};
use super::walls::{WallGeometry, WallsScene};
use crate::scene::bounded::numbers;

impl Scene {
    /// Gives each body the faces of the walls that it touches, as tools by the name of the walls, in place of those it was given before.
    pub(super) fn touch_walls(&mut self) {
        let mut found: Vec<(String, ToolScene)> = Vec::new();
        for (number, own) in self.contact.iter().enumerate() {
            let Some([a, b]) = own.pair() else { continue };
            for (body, walls) in [(a, b), (b, a)] {
                if let Some(BodyScene::Walls(scene)) = self.bodies.get(walls) {
                    let tools = faces((walls, scene), (number, own)).into_iter();
                    found.extend(tools.map(|tool| (body.clone(), tool)));
                }
            }
        }
        for tools in self.bodies.values_mut().filter_map(tools_of) {
            tools.retain(|tool| tool.of_contact.is_none());
        }
        for (name, tool) in found {
            if let Some(tools) = self.bodies.get_mut(&name).and_then(tools_of) {
                tools.push(tool);
            }
        }
    }
}

/// The tools of a body that may have some.
fn tools_of(body: &mut BodyScene) -> Option<&mut Vec<ToolScene>> {
    match body {
        BodyScene::Shell(shell) => Some(&mut shell.tools),
        BodyScene::Solid(solid) => Some(&mut solid.tools),
        BodyScene::Rigid(rigid) => Some(&mut rigid.tools),
        _ => None,
    }
}

/// The faces of walls: of a basin half spaces behind its sides, of a block the box itself, in a plane fluid without ends across.
fn faces((name, walls): (&str, &WallsScene), (number, own): (usize, &ContactScene)) -> Vec<ToolScene> {
    let translation = walls.motion.as_ref().and_then(|motion| motion.translation.as_ref());
    let tool = |name: String| ToolScene {
        name,
        plane: None,
        sphere: None,
        cylinder: None,
        capsule: None,
        block: None,
        moved: translation.map(|translation| translation.by),
        preload: false,
        turn: None,
        amplitude: translation.map(|translation| translation.amplitude.clone()),
        friction: own.friction,
        stiffness: own.stiffness,
        rounding: own.rounding,
        of_contact: Some(number),
    };
    match &walls.geometry {
        WallGeometry::Basin(basin) => {
            let sides = (0..2 * basin.min.len())
                .filter(|side| !basin.open.iter().any(|open| open == OF_WALLS[side + 1]));
            let side = |side: usize| {
                let axis = side / 2;
                let (mut point, mut normal) = ([0.0; 3], [0.0; 3]);
                (point[axis], normal[axis]) =
                    if side.is_multiple_of(2) { (basin.min[axis], 1.0) } else { (basin.max[axis], -1.0) };
                let plane = Some(ToolPlane { point, normal });
                ToolScene { plane, ..tool(format!("{name}.{}", OF_WALLS[side + 1])) }
            };
            sides.map(side).collect()
        }
        WallGeometry::Block(block) => {
            let (mut min, mut max) = ([f64::NEG_INFINITY; 3], [f64::INFINITY; 3]);
            for (k, length) in numbers(&block.lengths).into_iter().enumerate() {
                min[k] = block.origin.as_ref().map_or(0.0, |origin| origin[k]);
                max[k] = min[k] + length;
            }
            vec![ToolScene { block: Some(ToolBlock { min, max }), ..tool(name.into()) }]
        }
        WallGeometry::Polyline(_) | WallGeometry::Surface(_) => Vec::new(),
    }
}
