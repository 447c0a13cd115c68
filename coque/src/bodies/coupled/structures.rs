//! Structures as a fluid wets them: rows of points under the faces of a shell or a rigid body, the nodes of a solid.

use rigid_body::Outline;
use sph_core::Vec3;

use super::body::Structure;
use crate::bodies::BuiltBody;
use crate::bodies::rigid_body::build::rigid_made;
use crate::bodies::shell::build::shell_made;
use crate::bodies::solid::build::solid_made;
use crate::bodies::together::{Side, of_bonds, of_rigid, of_shell, wetting};
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
    /// The surface of a rigid body, where no fluid starts; in a plane the third coordinate at which places are looked for in it.
    pub hull: Option<(Outline, Option<f64>)>,
}

/// Part of a spacing within which a particle lies on a face of a rigid body: the rounding of coordinates, those of files among it. What lies farther before a face
/// stays, so that as much is left out as the body displaces: leaving out a quarter of a spacing more lifted a ball four spacings in radius by 7 % too much.
const ON: f64 = 1e-3;

impl WettedBody<'_> {
    /// Whether it leaves no room for a particle of the fluid at a place: inside of it and on its faces.
    pub fn excludes(&self, place: &Vec3, spacing: f64) -> bool {
        let at = |z: Option<f64>| z.map_or(*place, |z| Vec3::new(place.x, place.y, z));
        self.hull.as_ref().is_some_and(|(outline, z)| {
            let place = at(*z);
            outline.encloses(&place) || outline.is_near(&place, ON * spacing)
        })
    }
}

/// Builds a body, if it is a structure, and wets it.
pub(super) fn wet<'a>(
    scene: &'a BodyInScene<'a>,
    fluid: &FluidScene,
    threads: usize,
) -> Result<Option<WettedBody<'a>>, SceneError> {
    match scene.body {
        BodyScene::Shell(shell) => {
            // The checks leave a shell in a fluid no material or section of a file.
            let area_density = shell.density().zip(shell.section.thickness()).map_or(0.0, |(rho, t)| rho * t);
            let made = shell_made(&ShellInScene::new(scene, shell), threads, Some(wetting(shell, fluid)))?;
            let side = of_shell(scene, &made.body)?;
            let made = made.map(|shell| Box::new(shell) as _);
            Ok(Some(WettedBody { scene, made, area_density, side, hull: None }))
        }
        BodyScene::Solid(solid) => {
            let area_density = thickness(solid) * solid.material.density();
            let made = solid_made(scene, solid, threads, true)?;
            let side = of_bonds(scene, solid, &made.body);
            let made = made.map(|solid| Box::new(solid) as _);
            Ok(Some(WettedBody { scene, made, area_density, side, hull: None }))
        }
        BodyScene::Rigid(rigid) => {
            let made = rigid_made(scene, rigid, Some(fluid))?;
            let body = &made.body;
            let outline = Outline {
                vertices: body.rest()[..body.centre() as usize].to_vec(),
                cells: body.cells().to_vec(),
            };
            let z = (fluid.dimensions() == 2).then(|| body.rest()[body.centre() as usize].z);
            // Of a plane body the fluid wets the sides and not the ends.
            let wet_area = if z.is_some() { outline.area_of_sides() } else { outline.area() };
            let area_density = 2.0 * body.mass() / wet_area;
            let side = of_rigid(scene, body, made.description.spacing);
            let made = made.map(|body| Box::new(body) as _);
            Ok(Some(WettedBody { scene, made, area_density, side, hull: Some((outline, z)) }))
        }
        BodyScene::Fluid(_) | BodyScene::Walls(_) => Ok(None),
    }
}

/// The least length of a solid in the directions that the fluid has \[L\].
fn thickness(solid: &SolidScene) -> f64 {
    solid.lattice().lengths[..solid.dimensions()].iter().copied().fold(f64::INFINITY, f64::min)
}
