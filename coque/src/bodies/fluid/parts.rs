//! Liquid, method and start of a fluid, from the scene's words to those of `fluid-sph`.

use fluid_sph::{Formulation, Liquid, Motion, Rotation, Scheme};
use sph_core::Vec3;

use crate::scene::{FluidMethod, FluidScene, WallMotion};

/// The liquid.
pub(in crate::bodies) fn liquid(fluid: &FluidScene) -> Liquid {
    let liquid = fluid.liquid();
    Liquid { density: liquid.density.get(), sound_speed: liquid.sound_speed.get() }
}

/// The method: what the scene leaves out is that of its integrator.
pub(in crate::bodies) fn formulation(fluid: &FluidScene) -> Formulation {
    let wanted = fluid.formulation.options();
    let usual = match wanted.method {
        FluidMethod::KickDriftKick => Formulation::default(),
        FluidMethod::Source => Formulation::published(),
    };
    let scheme = match wanted.method {
        FluidMethod::KickDriftKick => Scheme::KickDriftKick,
        FluidMethod::Source => Scheme::PredictorCorrector,
    };
    Formulation {
        smoothing: wanted.smoothing(),
        viscosity: wanted.viscosity.map_or(usual.viscosity, |given| given.get()),
        kinematic_viscosity: fluid.liquid().kinematic_viscosity.get(),
        density_diffusion: wanted.density_diffusion.map_or(usual.density_diffusion, |given| given.get()),
        xsph: wanted.xsph.map_or(usual.xsph, |given| given.get()),
        courant: wanted.courant.map_or(usual.courant, |given| given.get()),
        scheme,
        walls: wanted.walls.unwrap_or(usual.walls),
        confined: wanted.confined,
    }
}

/// Rows of particles behind a wall, the first half a spacing behind its face: those that the kernel reaches from there, `2h/Δx + ½` cut
/// down.
pub(in crate::bodies) fn rows_deep(fluid: &FluidScene) -> usize {
    libm::round(2.0 * formulation(fluid).smoothing) as usize
}

/// The motion of walls.
pub(in crate::bodies) fn motion(wanted: &WallMotion) -> Motion {
    let translation = wanted.translation.as_ref();
    let rotation = wanted.rotation.as_ref();
    Motion {
        translation: translation.map(|motion| (Vec3::from(motion.by), motion.amplitude.clone())),
        rotation: rotation.map(|motion| Rotation {
            centre: Vec3::from(motion.centre),
            axis: Vec3::from(motion.axis).normalize(),
            by: motion.by.to_radians(),
            angle: motion.amplitude.clone(),
        }),
    }
}
