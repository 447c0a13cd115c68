//! Checks of a zone that carries the water along: as long as the kernel wants, within the water and its periodic sides.

use sph_core::Vec3;

use crate::scene::error::{SceneError, Verdict};
use crate::scene::fluid::FluidScene;
use crate::scene::fluid::current::Current;
use crate::scene::fluid::formulation::FluidMethod;
use crate::scene::problem::Scene;
use crate::scene::scope::Scope;

/// Least ratio of the speed of sound to the velocity, as to all others.
const LEAST: f64 = 7.0;

/// Refuses a zone that no water goes through.
pub(in crate::scene::check) fn check_current(scene: &Scene) -> Verdict {
    let Some((name, fluid)) = scene.fluid() else { return Ok(()) };
    let Some(current) = &fluid.current else { return Ok(()) };
    let s = &scene.source.body(name, "fluid");
    s.sized_all("current.from", &current.from)?;
    s.direction("current.along", current.along)?;
    s.in_plane("current.along", current.along, fluid.dimensions() == 2)?;
    if matches!(fluid.formulation.options().method, FluidMethod::Source) {
        let (bound, repair) = ("none with `method = \"source\"`", "leave the method out");
        return Err(SceneError::Choice(s.fault("current", "a current", bound, repair)));
    }
    let least = 4.0 * fluid.formulation.options().smoothing() * fluid.geometry.spacing();
    if current.length.get() < least {
        let bound =
            format!("at least {least:.6}, twice the reach of the kernel: shorter ones tear the water");
        return Err(s.value(
            "current.length",
            current.length,
            &bound,
            "make it longer, or the spacing narrower",
        ));
    }
    let sound = fluid.liquid().sound_speed.get();
    if sound < LEAST * current.velocity.get() {
        let bound = format!("at most {:.4}, a {LEAST}th of the speed of sound", sound / LEAST);
        let repair = format!("raise material.liquid.sound_speed to {:.4}", 10.0 * current.velocity.get());
        return Err(s.value("current.velocity", current.velocity, &bound, &repair));
    }
    check_place(s, fluid, current)
}

/// The zone lies between periodic sides that it goes along, and there is water in it at the start.
fn check_place(s: &Scope<'_>, fluid: &FluidScene, current: &Current) -> Verdict {
    let along = Vec3::from(current.along).normalize();
    let from = Vec3::from(current.from);
    let to = from + along * current.length.get();
    let sides = fluid.periodic.map_or([None; 3], |periodic| periodic.sides());
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let Some([low, high]) = sides[axis] else { continue };
        let rounding = 1e-9 * (high - low);
        if along[axis] != 0.0 && along[axis].abs() < 1.0 - 1e-12 {
            let bound = format!(
                "along {name}, along which the fluid is periodic, or across it: a slanted zone would end at its sides"
            );
            let repair = format!("take the axis {name} itself, or one across it");
            return Err(s.value("current.along", format!("{:?}", current.along), &bound, &repair));
        }
        let inside = |at: &Vec3| (low - rounding..=high + rounding).contains(&at[axis]);
        if along[axis] != 0.0 && !(inside(&from) && inside(&to)) {
            let value = format!("{:?}, of a zone that ends at {:?}", current.from, <[f64; 3]>::from(to));
            let bound = format!("such that it lies between the periodic sides {name} = {low} and {high}");
            return Err(s.value(
                "current.from",
                value,
                &bound,
                "begin it farther inside, or make it shorter",
            ));
        }
    }
    let span = |at: &dyn Fn(f64, f64) -> f64, list: &[f64; 3], lengths: &[f64; 3]| {
        (0..3).map(|k| at(along[k] * list[k], along[k] * (list[k] + lengths[k]))).sum::<f64>()
    };
    let half = 0.5 * fluid.geometry.spacing();
    let meets = fluid.geometry.extents().iter().any(|extent| {
        let first = span(&f64::min, &extent.least, &extent.lengths);
        let last = span(&f64::max, &extent.least, &extent.lengths);
        // Water may be given periods away.
        let period = sides.iter().zip(along.iter()).find(|(sides, part)| sides.is_some() && **part != 0.0);
        let period = period.and_then(|(sides, _)| *sides).map_or(0.0, |[low, high]| high - low);
        let (begin, end) = (from.dot(&along), to.dot(&along));
        let shifts = if period > 0.0 { libm::round((0.5 * (first + last) - begin) / period) } else { 0.0 };
        [-1.0, 0.0, 1.0].into_iter().any(|more| {
            let by = (shifts + more) * period;
            begin + by < last - half && end + by > first + half
        })
    });
    if meets {
        return Ok(());
    }
    let bound = "where there is water at the start: no particle lies in the zone";
    Err(s.value("current.from", format!("{:?}", current.from), bound, "begin it in the water"))
}
