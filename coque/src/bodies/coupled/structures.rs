//! Structures as a fluid wets them: rows of points under the faces of a shell, the nodes of a solid.

use sph_shell::Wetting;

use super::body::Structure;
use crate::bodies::BuiltBody;
use crate::bodies::fluid::parts::rows_deep;
use crate::bodies::shell::build::shell_made;
use crate::bodies::solid::build::solid_made;
use crate::bodies::together::{Side, of_bonds, of_shell};
use crate::scene::body_in_scene::{BodyInScene, ShellInScene};
use crate::scene::error::SceneError;
use crate::scene::{BodyScene, FluidScene, SolidScene};

/// A structure with what the fluid asks of it.
pub(super) struct WettedBody<'a> {
    pub scene: &'a BodyInScene<'a>,
    pub made: BuiltBody<Box<dyn Structure>>,
    /// Mass by area of its surface, ρ_s t \[F T²/L³\].
    pub area_density: f64,
    /// Its surface, where a contact with another structure names it.
    pub side: Option<Side>,
}

/// Builds a body, if it is a structure, and wets it.
pub(super) fn wet<'a>(
    scene: &'a BodyInScene<'a>,
    fluid: &FluidScene,
    threads: usize,
) -> Result<Option<WettedBody<'a>>, SceneError> {
    match scene.body {
        BodyScene::Shell(shell) => {
            let wetting = Wetting {
                spacing: fluid.geometry.spacing(),
                rows: rows_deep(fluid),
                faces: shell.wet.unwrap_or_default(),
                plane: fluid.dimensions() == 2,
                free_edges: Vec::new(),
            };
            // The checks leave a shell in a fluid no material or section of a file.
            let area_density = shell.density().zip(shell.section.thickness()).map_or(0.0, |(rho, t)| rho * t);
            let made = shell_made(&ShellInScene::new(scene, shell), threads, Some(wetting))?;
            let side = of_shell(scene, &made.body)?;
            let made = made.map(|shell| Box::new(shell) as _);
            Ok(Some(WettedBody { scene, made, area_density, side }))
        }
        BodyScene::Solid(solid) => {
            let area_density = thickness(solid) * solid.material.density();
            let made = solid_made(scene, solid, threads, true)?;
            let side = of_bonds(scene, solid, &made.body);
            let made = made.map(|solid| Box::new(solid) as _);
            Ok(Some(WettedBody { scene, made, area_density, side }))
        }
        BodyScene::Fluid(_) | BodyScene::Walls(_) | BodyScene::Rigid(_) => Ok(None),
    }
}

/// The least length of a solid in the directions that the fluid has \[L\].
fn thickness(solid: &SolidScene) -> f64 {
    solid.lattice().lengths[..solid.dimensions()].iter().copied().fold(f64::INFINITY, f64::min)
}
