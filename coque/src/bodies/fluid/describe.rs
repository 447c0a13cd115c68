//! What a fluid and walls model and what they leave out, for summaries.

use fluid_sph::{Fluid, Scheme, WallRule};

use super::walls::Rows;
use crate::bodies::Description;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::{FluidScene, FluidStart, WallsScene};

/// What the fluid of a scene is; `scene` is that of the fluid alone.
pub(in crate::bodies) fn of_fluid(
    scene: &BodyInScene<'_>,
    wanted: &FluidScene,
    fluid: &Fluid,
) -> Description {
    let method = fluid.formulation();
    let scheme = match method.scheme {
        Scheme::KickDriftKick => "kick, drift, kick",
        Scheme::PredictorCorrector => "predictor and corrector",
    };
    let walls = match method.walls {
        WallRule::Extrapolated => "walls with the pressure of the fluid before them",
        WallRule::Dynamic => "walls with densities of their own",
    };
    let liquid = wanted.liquid();
    let mut modelled = vec![
        format!("weakly compressible liquid, Tait's equation, speed of sound {}", liquid.sound_speed),
        format!(
            "{scheme}, smoothing length {} spacings, artificial viscosity {}",
            method.smoothing, method.viscosity
        ),
        walls.into(),
    ];
    let mut left_out: Vec<String> =
        ["surface tension", "turbulence below the spacing", "air"].map(String::from).into();
    let mut either = |present: bool, what: &str| {
        let list = if present { &mut modelled } else { &mut left_out };
        list.push(what.into());
    };
    either(method.density_diffusion > 0.0, "diffusion of density");
    either(method.kinematic_viscosity > 0.0, "viscosity of the liquid");
    either(method.xsph > 0.0, "particles carried by the mean velocity");
    either(!scene.loads.is_empty(), "gravity");
    if method.slip {
        modelled.push("walls that let it slip".into());
    }
    if wanted.velocity.is_some() {
        modelled.push("velocity at the start".into());
    }
    if let Some(current) = &wanted.current {
        modelled.push(format!("a zone that carries the water along with {}", current.velocity));
    }
    for opening in &wanted.openings {
        let what = match (opening.velocity, opening.level, opening.pressure) {
            (Some(velocity), ..) => format!("velocity {velocity}"),
            (None, Some(level), _) => format!("level {level}"),
            (None, None, Some(pressure)) => format!("pressure {pressure}"),
            (None, None, None) => "free".into(),
        };
        let [x, y, z] = opening.at;
        modelled.push(format!("an opening at [{x}, {y}, {z}], {what}; room for {} particles", fluid.len()));
    }
    if let Some(periodic) = &wanted.periodic {
        let sides = ["x", "y", "z"].into_iter().zip(periodic.sides());
        let sides =
            sides.filter_map(|(axis, sides)| sides.map(|[low, high]| format!("{axis} = {low} and {high}")));
        modelled.push(format!("periodic sides, {}", Vec::from_iter(sides).join(", ")));
    }
    modelled.push(match wanted.formulation.options().start {
        FluidStart::Hydrostatic => "hydrostatic pressure at the start".into(),
        FluidStart::Uniform => "no pressure at the start".into(),
    });
    Description {
        kind: "fluid",
        method: wanted.formulation.word().into(),
        particles: fluid.held(),
        dof: fluid.held() * fluid.dimensions(),
        spacing: fluid.spacing(),
        bytes_per_particle: fluid.bytes_per_particle() as f64,
        modelled,
        left_out,
        ..Description::default()
    }
}

/// What walls of a scene are.
pub(in crate::bodies) fn of_walls(walls: &WallsScene, rows: &Rows, spacing: f64) -> Description {
    let motion = match &walls.motion {
        Some(_) => "rigid, in a given motion",
        None => "rigid, at rest",
    };
    Description {
        kind: "walls",
        method: walls.geometry.word().into(),
        particles: rows.pieces.iter().map(|piece| piece.points.len()).sum(),
        spacing,
        modelled: vec![motion.into()],
        ..Description::default()
    }
}
