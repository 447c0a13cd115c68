//! Checks of answers to response spectra and to noise: what shakes, spectra, densities.

use explicit_dynamics::Amplitude;
use implicit_statics::SpectrumBy;

use super::harmonic::{check_body, check_damping, check_frequencies, check_swings};
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::random_vibration::RandomVibration;
use crate::scene::response_spectrum::{SpectrumAnalysis, SpectrumBase};
use crate::scene::scope::Scope;

const SPECTRUM: &str = "analysis.response-spectrum";
const NOISE: &str = "analysis.random-vibration";

/// Refuses what has no greatest answer to response spectra.
pub(super) fn check_spectrum(scene: &BodyInScene<'_>, wanted: &SpectrumAnalysis) -> Verdict {
    let s = &scene.scope();
    check_body(scene)?;
    check_damping(scene, Some(wanted.damping))?;
    if wanted.base.is_empty() {
        let repair = "add [[analysis.response-spectrum.base]] with its `acceleration` and its spectrum";
        let fault =
            s.fault(&format!("{SPECTRUM}.base"), "nothing", "a direction that shakes at least", repair);
        return Err(SceneError::Choice(fault));
    }
    for (i, base) in wanted.base.iter().enumerate() {
        check_base(s, &format!("{SPECTRUM}.base[{i}]"), base)?;
    }
    if let Some(load) = scene.loads.iter().find(|load| !load.preload && !load.of_base) {
        let bound =
            "none beside response spectra, whose answers have no sign, unless `preload = true` holds it";
        let repair = "remove it, and add the answer to it from a run of its own, with either sign";
        return Err(SceneError::Choice(s.fault(&load.path, "a load", bound, repair)));
    }
    check_swings(scene)
}

fn check_base(s: &Scope<'_>, at: &str, base: &SpectrumBase) -> Verdict {
    s.direction(&format!("{at}.acceleration"), base.acceleration)?;
    let mut given = Vec::new();
    given.extend(base.amplitude.as_ref().map(|_| "amplitude"));
    given.extend((!base.damped.is_empty()).then_some("damped"));
    s.exactly_one(at, "spectrum", &given, &["amplitude", "damped"])?;
    if base.by == SpectrumBy::Time {
        let refuse = |key: &str, value: &str, repair: &str| {
            let bound = "none by `time`: the spectrum is found of the course, for the damping of each mode";
            Err(SceneError::Choice(s.fault(&format!("{at}.{key}"), value, bound, repair)))
        };
        if !base.damped.is_empty() {
            return refuse("damped", "spectra for several dampings", "give the course as `amplitude`");
        }
        if base.logarithmic {
            return refuse("logarithmic", "true", "remove it");
        }
    }
    if let Some(amplitude) = &base.amplitude {
        check_curve(s, &format!("{at}.amplitude"), base, amplitude)?;
    }
    let mut last = 0.0;
    for (i, own) in base.damped.iter().enumerate() {
        let ratio = own.ratio.get();
        if ratio <= last {
            let bound = format!("greater than the damping {last} before it");
            return Err(s.value(&format!("{at}.damped[{i}].ratio"), ratio, &bound, "sort them"));
        }
        last = ratio;
        check_curve(s, &format!("{at}.damped[{i}].amplitude"), base, &own.amplitude)?;
    }
    Ok(())
}

/// Refuses a spectrum that is no table of ascending numbers that are there.
fn check_curve(s: &Scope<'_>, at: &str, base: &SpectrumBase, amplitude: &Amplitude) -> Verdict {
    let Amplitude::Table(points) = amplitude else {
        let bound = "a `table`, or a `record` from a file, as a spectrum";
        let repair = "write amplitude = { table = [[0.0, 0.4], [0.2, 1.0], [2.0, 0.1]] }";
        return Err(SceneError::Choice(s.fault(at, "a course without points", bound, repair)));
    };
    let at = &format!("{at}.table");
    let of_course = base.by == SpectrumBy::Time;
    for (i, &[x, y]) in points.iter().enumerate() {
        s.sized_all(&format!("{at}[{i}]"), &[x, y])?;
        let least = if base.logarithmic {
            "above zero, both of them, of what goes along logarithms"
        } else {
            "zero or more, both of them"
        };
        let there = if base.logarithmic { x > 0.0 && y > 0.0 } else { x >= 0.0 && (of_course || y >= 0.0) };
        if !there {
            let repair = "a spectrum has no sign; leave out the point at zero, the curve stays as it begins";
            return Err(s.value(&format!("{at}[{i}]"), format!("[{x}, {y}]"), least, repair));
        }
    }
    ascending(s, at, points, if of_course { 2 } else { 1 })?;
    if points.iter().all(|point| point[1] == 0.0) {
        return Err(s.value(
            at,
            "zeros",
            "a number above zero somewhere",
            "give the spectrum, or remove the base",
        ));
    }
    Ok(())
}

/// Refuses points that do not ascend, and fewer than there must be.
fn ascending(s: &Scope<'_>, at: &str, points: &[[f64; 2]], fewest: usize) -> Verdict {
    if points.len() < fewest {
        let bound = format!("a list of {fewest} points at least");
        return Err(s.value(at, format!("{} points", points.len()), &bound, "give it more points"));
    }
    if let Some(i) = (1..points.len()).find(|&i| points[i][0] <= points[i - 1][0]) {
        let bound = format!("after the {} before it", points[i - 1][0]);
        return Err(s.value(&format!("{at}[{i}]"), points[i][0], &bound, "sort the points"));
    }
    Ok(())
}

/// Refuses what does not vibrate under noise.
pub(super) fn check_noise(scene: &BodyInScene<'_>, wanted: &RandomVibration) -> Verdict {
    let s = &scene.scope();
    check_body(scene)?;
    check_frequencies(scene, &wanted.frequencies)?;
    check_damping(scene, Some(wanted.damping))?;
    let loads = || scene.loads.iter().filter(|load| !load.preload && !load.of_base);
    if wanted.base.is_empty() && wanted.loads.is_none() {
        let repair =
            "add [[analysis.random-vibration.base]], or [analysis.random-vibration.loads] beside [[loads]]";
        let fault = s.fault(NOISE, "nothing", "noise of a base or of the loads", repair);
        return Err(SceneError::Choice(fault));
    }
    for (i, base) in wanted.base.iter().enumerate() {
        s.direction(&format!("{NOISE}.base[{i}].acceleration"), base.acceleration)?;
        check_density(s, &format!("{NOISE}.base[{i}].density"), &base.density)?;
    }
    if let Some(noise) = &wanted.loads {
        check_density(s, &format!("{NOISE}.loads.density"), &noise.density)?;
        if loads().next().is_none() {
            let repair = "add [[loads]], or remove analysis.random-vibration.loads";
            let fault = s.fault("loads", "nothing", "something that the noise goes with", repair);
            return Err(SceneError::Choice(fault));
        }
    } else if let Some(load) = loads().next() {
        let bound = "none without [analysis.random-vibration.loads], unless `preload = true` holds it";
        let repair = "add `loads = { density = … }` to the analysis, or remove the load";
        return Err(SceneError::Choice(s.fault(&load.path, "a load", bound, repair)));
    }
    check_swings(scene)
}

fn check_density(s: &Scope<'_>, at: &str, density: &[[f64; 2]]) -> Verdict {
    for (i, point) in density.iter().enumerate() {
        let at = format!("{at}[{i}]");
        s.sized_all(&at, point)?;
        if point.iter().any(|&x| x <= 0.0) {
            let value = format!("[{}, {}]", point[0], point[1]);
            let repair = "begin and end the list where the noise does: beyond its ends there is none";
            return Err(s.value(&at, value, "above zero, both of them", repair));
        }
    }
    ascending(s, at, density, 2)
}
