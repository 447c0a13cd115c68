//! Checks of openings: what is given there, and what does not go with them.

use explicit_dynamics::Amplitude;
use sph_core::Vec3;

use crate::scene::body_in_scene::{BodyInScene, gravity_on};
use crate::scene::check::amplitude::check_amplitude;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::fluid::FluidScene;
use crate::scene::fluid::formulation::{FluidMethod, WallMethod};
use crate::scene::fluid::geometry::Extent;
use crate::scene::fluid::openings::FluidOpening;
use crate::scene::problem::Scene;
use crate::scene::scope::Scope;

/// Names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];
/// Least ratio of the speed of sound to the velocity, as to all others.
const LEAST: f64 = 7.0;
/// Sine of an angle within which a direction is along or across another: rounding.
const ALONG: f64 = 1e-9;

/// Refuses openings through which nothing sensible goes.
pub(in crate::scene::check) fn check_openings(scene: &Scene) -> Verdict {
    let Some((name, fluid)) = scene.fluid() else { return Ok(()) };
    let s = &scene.source.body(name, "fluid");
    if fluid.openings.is_empty() {
        if let Some(most) = fluid.most_particles {
            let repair = "remove it: only through `openings` more particles come";
            return Err(s.value("most_particles", most, "left out without openings", repair));
        }
        return Ok(());
    }
    let start = fluid.particles_asked();
    if let Some(most) = fluid.most_particles.filter(|most| (*most as f64) < start) {
        let bound = format!("at least {start:.0}, as many as there are at the start");
        return Err(s.value("most_particles", most, &bound, "leave it out for twice as many"));
    }
    check_alone(scene, s, name, fluid)?;
    let gravity = gravity_on(scene, name);
    let Some(body) = scene.bodies.get(name) else { return Ok(()) };
    let view = BodyInScene::new(scene, name, body)?;
    for (i, opening) in fluid.openings.iter().enumerate() {
        check_place(s, i, fluid, opening)?;
        check_given(&view, s, i, fluid, opening, &gravity)?;
    }
    check_levels(s, fluid)
}

/// Refuses levels between which water would flow: what comes in by a level goes back and forth across the opening.
fn check_levels(s: &Scope<'_>, fluid: &FluidScene) -> Verdict {
    let free = fluid.openings.iter().enumerate().filter(|(_, own)| own.velocity.is_none());
    let mut levels = free.filter_map(|(i, own)| Some((i, own.level?)));
    let Some((_, first)) = levels.next() else { return Ok(()) };
    let Some((i, other)) = levels.find(|(_, level)| (level - first).abs() > ALONG * first.abs()) else {
        return Ok(());
    };
    let bound = format!(
        "{first}, as of the other opening: only a velocity says what comes in, a level what goes out"
    );
    Err(s.value(&format!("openings[{i}].level"), other, &bound, "give a `velocity` where water comes in"))
}

/// What openings do not go with.
fn check_alone(scene: &Scene, s: &Scope<'_>, name: &str, fluid: &FluidScene) -> Verdict {
    let options = fluid.formulation.options();
    let method = matches!(options.method, FluidMethod::Source);
    let walls = method && options.walls.is_none() || options.walls == Some(WallMethod::Dynamic);
    for (refused, what, repair) in [
        (method, "method = \"source\"", "leave the method out"),
        (walls, "walls = \"dynamic\"", "leave `walls` out, or take \"extrapolated\""),
    ] {
        if refused {
            let bound = format!("none with `{what}`");
            return Err(SceneError::Choice(s.fault("openings", "openings", &bound, repair)));
        }
    }
    if let Some((structure, _)) = scene.structures().next() {
        let value = format!("a structure in a fluid with openings, `{name}`");
        let repair = "make it of walls, which stand or have a given motion, or let the water go round (`periodic`, `current`)";
        let bound = "none: particles that come and go wet walls alone";
        let fault = scene.scope().fault(&format!("bodies.{structure}"), &value, bound, repair);
        return Err(SceneError::Choice(fault));
    }
    Ok(())
}

fn check_place(s: &Scope<'_>, i: usize, fluid: &FluidScene, opening: &FluidOpening) -> Verdict {
    let path = |key: &str| format!("openings[{i}].{key}");
    s.sized_all(&path("at"), &opening.at)?;
    s.direction(&path("into"), opening.into)?;
    s.in_plane(&path("into"), opening.into, fluid.dimensions() == 2)?;
    let into = Vec3::from(opening.into).normalize();
    let axis = into.iamax();
    let value = || format!("{:?}", opening.into);
    if into[axis].abs() < 1.0 - ALONG {
        let bound = "along an axis: rows of particles stand across it";
        return Err(s.value(
            &path("into"),
            value(),
            bound,
            "turn the scene so that water comes in along an axis",
        ));
    }
    if fluid.periodic.is_some_and(|periodic| periodic.sides()[axis].is_some()) {
        let bound = format!("across {}, along which the fluid is periodic", AXES[axis]);
        let repair = format!("take {} out of `periodic`, or remove the opening", AXES[axis]);
        return Err(s.value(&path("into"), value(), &bound, &repair));
    }
    Ok(())
}

fn check_given(
    view: &BodyInScene<'_>,
    s: &Scope<'_>,
    i: usize,
    fluid: &FluidScene,
    opening: &FluidOpening,
    gravity: &Vec3,
) -> Verdict {
    let path = |key: &str| format!("openings[{i}].{key}");
    let FluidOpening { velocity, amplitude, profile, level, pressure, .. } = opening;
    if let Some(velocity) = velocity {
        s.sized(&path("velocity"), *velocity)?;
        let sound = fluid.liquid().sound_speed.get();
        let of_profile = profile.iter().flatten().map(|pair| pair[1].abs()).reduce(f64::max).unwrap_or(1.0);
        let of_course = match amplitude {
            Amplitude::Table(points) => points.iter().map(|point| point[1].abs()).fold(0.0, f64::max),
            _ => 1.0,
        };
        let most = velocity.abs() * of_profile * of_course;
        if sound < LEAST * most {
            let bound = format!(
                "at most {:.4} with the factors of its profile and its course, a {LEAST}th of the speed of sound",
                sound / LEAST
            );
            let repair = format!("raise material.liquid.sound_speed to {:.4}", 10.0 * most);
            return Err(s.value(&path("velocity"), most, &bound, &repair));
        }
        check_amplitude(view, &s.path(&path("amplitude")), amplitude)?;
    }
    let course = *amplitude != Amplitude::Constant;
    for (given, key, value) in [
        (course, "amplitude", "a course of no velocity"),
        (profile.is_some(), "profile", "one of no velocity"),
    ] {
        if given && velocity.is_none() {
            let repair = "give a velocity, or remove it";
            let fault = s.fault(&path(key), value, "none without `velocity`", repair);
            return Err(SceneError::Choice(fault));
        }
    }
    if let Some(profile) = profile {
        for (k, pair) in profile.iter().enumerate() {
            s.sized_all(&path(&format!("profile[{k}]")), pair)?;
        }
        if profile.is_empty() || !profile.windows(2).all(|pair| pair[0][0] < pair[1][0]) {
            let bound = "a list of [height, factor] with ascending heights";
            return Err(s.value(&path("profile"), "empty or out of order", bound, "sort it by height"));
        }
    }
    let into = Vec3::from(opening.into).normalize();
    let across = gravity.norm() > 0.0 && gravity.dot(&into).abs() <= ALONG * gravity.norm();
    if let Some(level) = level {
        s.sized(&path("level"), *level)?;
        if !across {
            let repair = if gravity.norm() > 0.0 { "give a velocity" } else { "give `pressure`" };
            let bound = "left out unless gravity lies along the opening: else nothing there has a level";
            return Err(s.value(&path("level"), level, bound, repair));
        }
        check_level(s, &path("level"), fluid, *level, gravity)?;
    }
    if let Some(pressure) = pressure {
        s.sized(&path("pressure"), *pressure)?;
        if *pressure < 0.0 && !fluid.formulation.options().confined {
            let bound = "zero or more, unless the fluid is `confined`: else no pressure below zero acts";
            let repair = "raise all pressures alike, or set formulation.weakly-compressible.confined = true";
            return Err(s.value(&path("pressure"), pressure, bound, repair));
        }
        if gravity.norm() > 0.0 {
            let repair = "give `level`: the height up to which water of that pressure would stand";
            return Err(s.value(&path("pressure"), pressure, "left out under gravity", repair));
        }
        if velocity.is_some() {
            let repair = "keep one of the two: the other comes from the fluid";
            return Err(s.value(&path("pressure"), pressure, "left out with `velocity`", repair));
        }
    }
    Ok(())
}

/// Refuses levels from which water falls faster than the speed of sound allows.
fn check_level(s: &Scope<'_>, path: &str, fluid: &FluidScene, level: f64, gravity: &Vec3) -> Verdict {
    let up = -gravity.normalize();
    let lowest = |extent: Extent| {
        let ends = |axis: usize| {
            let near = up[axis] * extent.least[axis];
            near.min(near + up[axis] * extent.lengths[axis])
        };
        (0..3).map(ends).sum::<f64>()
    };
    let bottom = fluid.geometry.extents().into_iter().map(lowest).fold(f64::INFINITY, f64::min);
    let sound = fluid.liquid().sound_speed.get();
    let fall = (2.0 * gravity.norm() * (level - bottom).max(0.0)).sqrt();
    if sound >= LEAST * fall {
        return Ok(());
    }
    let highest = bottom + (sound / LEAST).powi(2) / (2.0 * gravity.norm());
    let bound = format!("at most {highest:.4}, from which water falls at a {LEAST}th of the speed of sound");
    let repair = format!("raise material.liquid.sound_speed to {:.4}", 10.0 * fall);
    Err(s.value(path, level, &bound, &repair))
}
