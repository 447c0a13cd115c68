//! Shells in still water, whose modes are sought: the water adds mass to them.

use fluid_sph::{Screen, StillParts, StillWater, WetSite};
use implicit_statics::{AddedMass, EquilibriumError};
use sph_core::Vec3;
use sph_shell::WetColumn;

use super::build::coupled_walls;
use crate::bodies::fluid::places;
use crate::bodies::memory::check_memory;
use crate::bodies::refusal::body_error;
use crate::bodies::together::WetSurface;
use crate::bodies::together::build::together_in;
use crate::bodies::{InStillWater, Model, Ready};
use crate::scene::body_in_scene::{BodyInScene, gravity_on};
use crate::scene::error::SceneError;
use crate::scene::{BodyScene, FluidScene};

/// Widths that differ by less are one.
const ALIKE: f64 = 1e-9;

/// Builds the shells of a scene in its still water.
pub(in crate::bodies) fn still_model(
    bodies: &[BodyInScene<'_>],
    of_fluid: &BodyInScene<'_>,
    wanted: &FluidScene,
    threads: usize,
) -> Result<Model, SceneError> {
    check_memory(of_fluid, wanted.particles_asked())?;
    let walls = coupled_walls(bodies, wanted)?;
    let walls: Vec<Vec3> = (walls.iter().flat_map(|body| &body.rows.pieces))
        .flat_map(|piece| piece.points.iter().copied())
        .collect();
    let shells = bodies.iter().filter(|body| matches!(body.body, BodyScene::Shell(_)));
    let shells: Vec<BodyInScene<'_>> = shells.cloned().collect();
    let (mut model, wet) = together_in(of_fluid.scene, &shells, Some(wanted), threads)?;
    let refuse =
        |message: &str| body_error(of_fluid, &format!("geometry.{}", wanted.geometry.word()), message);
    let mut widths = wet.iter().filter_map(|surface| surface.width);
    let width = widths.next().unwrap_or(1.0);
    if widths.any(|other| (other - width).abs() > ALIKE * width) {
        return Err(refuse("shells of several widths stand in a plane fluid; give all of them one width"));
    }
    let (screens, sites) = (screens(&wet), sites(&wet));
    let parts = StillParts {
        dimensions: wanted.dimensions(),
        spacing: wanted.geometry.spacing(),
        density: wanted.liquid().density.get(),
        width,
        positions: &places::places(wanted),
        walls: &walls,
        screens: &screens,
        sites: &sites,
    };
    let water = StillWater::new(&parts).map_err(|error| refuse(&error.to_string()))?;
    let gravity = gravity_on(of_fluid.scene, of_fluid.name);
    let hanging = water.hanging(&gravity);
    if hanging > 0 {
        return Err(refuse(&format!(
            "{hanging} sides of its cells are open that do not look up: still water would not stay there, and bears no pressure; put walls at its sides and below"
        )));
    }
    let scale = scale(&water, &mut model);
    let added = added(&water, &wet, scale).map_err(|error| refuse(&error.to_string()))?;
    model.description.modelled.push(format!(
        "{}: still water of density {}, {} cells and {} places of wet faces: an ideal fluid without compression, whose free surface bears no pressure",
        of_fluid.name,
        parts.density,
        water.cells,
        water.nodes - water.cells,
    ));
    let left = "compression and friction of the water, waves that gravity makes of its surface, its pressure at rest";
    model.description.left_out.push(left.into());
    let faces = weighed(&water, &wet, parts.density, &gravity);
    model.water = Some(Box::new(InStillWater { water, added, scale, gravity, faces }));
    Ok(model)
}

fn screens(wet: &[WetSurface]) -> Vec<Screen> {
    let of = |surface: &WetSurface| {
        let half = surface.half;
        surface.middle.iter().map(move |&corners| Screen { corners, half }).collect::<Vec<_>>()
    };
    wet.iter().flat_map(of).collect()
}

/// Places of the wet faces of all shells: of each column the one to which the director points, then the other.
fn sites(wet: &[WetSurface]) -> Vec<WetSite> {
    let mut all = Vec::new();
    for surface in wet {
        for column in &surface.columns {
            for sign in faces(column.wet) {
                let (place, normal) = (column.place, column.normal * sign);
                all.push(WetSite { place, normal, half: surface.half, area: column.area });
            }
        }
    }
    all
}

/// Signs of the normals of wet faces along the director.
fn faces(wet: [bool; 2]) -> impl Iterator<Item = f64> {
    wet.into_iter().zip([1.0, -1.0]).filter_map(|(wet, sign)| wet.then_some(sign))
}

/// Places with water before them: node, column, sign of the normal, and how unknowns move them; in the order of [`sites`].
fn moved<'a>(
    water: &'a StillWater,
    wet: &'a [WetSurface],
) -> impl Iterator<Item = (usize, &'a WetColumn, f64, &'a Vec<(usize, f64)>)> {
    let columns = wet.iter().flat_map(|surface| surface.columns.iter().zip(&surface.along));
    let all = columns.flat_map(|(column, along)| faces(column.wet).map(move |sign| (column, sign, along)));
    all.zip(&water.sites).filter_map(|((column, sign, along), node)| Some(((*node)?, column, sign, along)))
}

/// Wet faces in the pressure at rest, which is less where they have gone up: how each moves along its normal, and `ρ A g·n`, n into the
/// water \[F/L\].
fn weighed(
    water: &StillWater,
    wet: &[WetSurface],
    density: f64,
    gravity: &Vec3,
) -> Vec<(Vec<(usize, f64)>, f64)> {
    let weight = |column: &WetColumn, sign: f64| density * column.area * sign * gravity.dot(&column.normal);
    moved(water, wet).map(|(_, column, sign, along)| (along.clone(), weight(column, sign))).collect()
}

/// A power of two by whose square the Laplacian of the water is as great as the stiffness of the shells, the mass of a particle by the square of the fastest
/// motion; one where that is not known.
fn scale(water: &StillWater, model: &mut Model) -> f64 {
    let Ready::Static(body) = &mut model.body else { return 1.0 };
    let mass = body.vibrating_masses().into_iter().fold(0.0, f64::max);
    let (step, own) = (body.stable_step(), water.values.iter().copied().fold(0.0, f64::max));
    let stiffness = 4.0 * mass / (step * step);
    let exponent = libm::round(0.5 * libm::log2(stiffness / own));
    if exponent.is_finite() { libm::exp2(exponent) } else { 1.0 }
}

/// The mass that the water adds, its pressures in such a unit; sites come in the order of [`sites`].
fn added(water: &StillWater, wet: &[WetSurface], scale: f64) -> Result<AddedMass, EquilibriumError> {
    let mut flux = Vec::new();
    for (node, column, sign, along) in moved(water, wet) {
        let of = |&(unknown, way): &(usize, f64)| (node, unknown, scale * sign * column.area * way);
        flux.extend(along.iter().map(of));
    }
    let values = water.values.iter().map(|value| scale * scale * value).collect();
    AddedMass::new(water.nodes, water.pattern.clone(), values, flux)
}
