//! Structures as a fluid wets them: rows of points under the faces of a shell, the nodes of a solid.

use sph_shell::{Sides, Wetting};

use super::body::Structure;
use crate::bodies::BuiltBody;
use crate::bodies::fluid::parts::rows_deep;
use crate::scene::error::SceneError;
use crate::scene::{BodyScene, FluidScene, Scene, SolidScene, WetFaces};

/// A structure with what the fluid asks of it.
pub(super) struct WettedBody {
    pub made: BuiltBody<Box<dyn Structure>>,
    /// Mass by area of its surface, ρ_s t \[F T²/L³\].
    pub area_density: f64,
}

/// Builds one of the structures of a scene, alone, and wets it.
pub(super) fn wet(
    scene: &Scene,
    name: &str,
    fluid: &FluidScene,
    threads: usize,
) -> Result<Option<WettedBody>, SceneError> {
    let alone = scene.single_body(name)?;
    match alone.body() {
        BodyScene::Shell(shell) => {
            let sides = match shell.wet {
                None | Some(WetFaces::Both) => Sides::Both,
                Some(WetFaces::Front) => Sides::Front,
                Some(WetFaces::Back) => Sides::Back,
            };
            let wetting = Wetting {
                spacing: fluid.geometry.spacing(),
                rows: rows_deep(fluid),
                sides,
                plane: fluid.dimensions() == 2,
                free_edges: Vec::new(),
            };
            // The checks leave a shell in a fluid no material or section of a file.
            let area_density =
                shell.material.density().zip(shell.section.thickness()).map_or(0.0, |(rho, t)| rho * t);
            let made = alone.shell_made(threads, Some(wetting))?.map(|shell| Box::new(shell) as _);
            Ok(Some(WettedBody { made, area_density }))
        }
        BodyScene::Solid(solid) => {
            let area_density = thickness(solid) * solid.material.density();
            let made = alone.solid_made(solid, threads, true)?.map(|solid| Box::new(solid) as _);
            Ok(Some(WettedBody { made, area_density }))
        }
        BodyScene::Fluid(_) | BodyScene::Walls(_) => Ok(None),
    }
}

/// The least length of a solid in the directions that the fluid has \[L\].
fn thickness(solid: &SolidScene) -> f64 {
    solid.lattice().lengths[..solid.dimensions()].iter().copied().fold(f64::INFINITY, f64::min)
}
