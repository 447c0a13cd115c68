//! Liquid, method and start of a fluid, from the scene's words to those of `fluid-sph`.

use explicit_dynamics::Amplitude;
use fluid_sph::{
    Beach, Course, Current, Formulation, Given, Liquid, Motion, Opening, Rotation, Scheme, Spectrum, Waves,
    way_of_wall,
};
use sph_core::Vec3;

use crate::scene::{
    self, FluidMethod, FluidOpening, FluidScene, SpectrumShape, WallMotion, WallWaves, WaveSpectrum,
};

/// Part of its height with which a wave comes back from a beach, and of what it differs by with which water leaves a current.
const LEFT: f64 = 0.02;

/// Waves of which a sea is the sum, if nothing is said.
const COMPONENTS: usize = 64;

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
        slip: wanted.slip,
    }
}

/// Rows of particles behind a wall, the first half a spacing behind its face: those that the kernel reaches from there, `2h/Δx + ½` cut
/// down.
pub(in crate::bodies) fn rows_deep(fluid: &FluidScene) -> usize {
    libm::round(2.0 * formulation(fluid).smoothing) as usize
}

/// The zone in which waves run out, under a gravity \[L/T²\].
pub(in crate::bodies) fn beach(wanted: &scene::Beach, gravity: &Vec3) -> Beach {
    let length = wanted.length.get();
    let waves = Waves { period: wanted.period.get(), depth: wanted.depth.get(), gravity: gravity.norm() };
    Beach {
        from: wanted.from.into(),
        along: Vec3::from(wanted.along).normalize(),
        length,
        strength: Beach::strength(length, waves.group_velocity(), LEFT),
    }
}

/// The zone that carries the water along.
pub(in crate::bodies) fn current(wanted: &scene::Current) -> Current {
    let (length, velocity) = (wanted.length.get(), wanted.velocity.get());
    Current {
        from: wanted.from.into(),
        along: Vec3::from(wanted.along).normalize(),
        length,
        velocity,
        strength: Current::strength(length, velocity, LEFT),
    }
}

/// An opening.
pub(in crate::bodies) fn opening(wanted: &FluidOpening) -> Opening {
    let into = Vec3::from(wanted.into);
    let axis = into.iamax();
    let along = Vec3::ith(axis, into[axis].signum());
    let given = match (wanted.velocity, wanted.level, wanted.pressure) {
        (Some(velocity), level, _) => Given::Velocity {
            into: velocity,
            course: wanted.amplitude.clone(),
            profile: wanted.profile.clone().unwrap_or_default(),
            level,
        },
        (None, Some(level), _) => Given::Pressure { at_level: 0.0, level },
        (None, None, Some(pressure)) => Given::Pressure { at_level: pressure, level: 0.0 },
        (None, None, None) => Given::Free,
    };
    Opening { at: wanted.at.into(), into: along, given }
}

/// The motion of a wall that makes waves: half of the stroke to either side, of a flap as the angle about its hinge.
fn making(wanted: &WallWaves, gravity: &Vec3) -> Motion {
    let (height, period, depth) = (wanted.height.get(), wanted.period.get(), wanted.depth.get());
    let waves = Waves { period, depth, gravity: gravity.norm() };
    let along = Vec3::from(wanted.along).normalize();
    if let Some(spectrum) = &wanted.spectrum {
        return irregular(wanted, spectrum, gravity);
    }
    let amplitude: Course = Amplitude::Sine { period, growth: Some(wanted.growth()) }.into();
    let Some(hinge) = wanted.hinge else {
        let half = 0.5 * height / waves.of_piston();
        return Motion { translation: Some((along * half, amplitude)), rotation: None };
    };
    let half = 0.5 * height / waves.of_flap();
    // Turned about this axis, what is above the hinge goes along the waves.
    let axis = -gravity.normalize().cross(&along);
    let by = libm::atan(half / depth);
    Motion {
        translation: None,
        rotation: Some(Rotation { centre: hinge.into(), axis, by, angle: amplitude }),
    }
}

/// The motion of a wall that makes irregular waves.
fn irregular(wanted: &WallWaves, spectrum: &WaveSpectrum, gravity: &Vec3) -> Motion {
    let shape = match &spectrum.shape {
        SpectrumShape::PiersonMoskowitz => Spectrum::Jonswap { peakedness: 1.0 },
        SpectrumShape::Jonswap(peakedness) => Spectrum::Jonswap { peakedness: peakedness.get() },
        SpectrumShape::Table(points) => Spectrum::Table(points.clone()),
    };
    let (depth, flap) = (wanted.depth.get(), wanted.hinge.is_some());
    let peak = 1.0 / wanted.period.get();
    let count = spectrum.components.map_or(COMPONENTS, |count| count.get());
    let components = shape.components(wanted.height.get(), peak, count, spectrum.seed);
    let mut terms = way_of_wall(&components, depth, gravity.norm(), flap);
    let along = Vec3::from(wanted.along).normalize();
    let growth = wanted.growth();
    let Some(hinge) = wanted.hinge else {
        return Motion { translation: Some((along, Course::Sines { terms, growth })), rotation: None };
    };
    terms.iter_mut().for_each(|[way, ..]| *way /= depth);
    let axis = -gravity.normalize().cross(&along);
    let angle = Course::Sines { terms, growth };
    Motion { translation: None, rotation: Some(Rotation { centre: hinge.into(), axis, by: 1.0, angle }) }
}

/// The motion of walls, under a gravity \[L/T²\].
pub(in crate::bodies) fn motion(wanted: &WallMotion, gravity: &Vec3) -> Motion {
    if let Some(waves) = &wanted.waves {
        return making(waves, gravity);
    }
    let translation = wanted.translation.as_ref();
    let rotation = wanted.rotation.as_ref();
    Motion {
        translation: translation.map(|motion| (Vec3::from(motion.by), motion.amplitude.clone().into())),
        rotation: rotation.map(|motion| Rotation {
            centre: Vec3::from(motion.centre),
            axis: Vec3::from(motion.axis).normalize(),
            by: motion.by.to_radians(),
            angle: motion.amplitude.clone().into(),
        }),
    }
}
