//! Checks of answers to response spectra and to noise: what shakes, spectra, densities.

use explicit_dynamics::Amplitude;
use implicit_statics::{DirectionRule, SpectrumBy};
use sph_core::Vec3;

use super::harmonic::{check_body, check_damping, check_frequencies, check_swings};
use crate::scene::Support;
use crate::scene::body_in_scene::{BodyInScene, OnSet};
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
    check_square(s, wanted)?;
    check_fields(scene, SPECTRUM)?;
    if let Some(load) = scene.loads.iter().find(|load| !load.preload && !load.of_base) {
        let bound =
            "none beside response spectra, whose answers have no sign, unless `preload = true` holds it";
        let repair = "remove it, and add the answer to it from a run of its own, with either sign";
        return Err(SceneError::Choice(s.fault(&load.path, "a load", bound, repair)));
    }
    check_swings(scene)
}

/// Refuses bases that lean on each other where directions are combined as if they knew nothing of each other.
fn check_square(s: &Scope<'_>, wanted: &SpectrumAnalysis) -> Verdict {
    if wanted.directions == DirectionRule::Absolute {
        return Ok(());
    }
    let axes: Vec<Vec3> = wanted.base.iter().map(|base| Vec3::from(base.acceleration).normalize()).collect();
    for (i, axis) in axes.iter().enumerate() {
        if axes[..i].iter().any(|other| other.dot(axis).abs() > 1e-9) {
            let bound = "square to all before it: of bases that are combined by `srss` or `hundred-thirty` each has a direction of its own";
            let repair = "turn it, give one base its whole spectrum, or take directions = \"absolute\"";
            let value = format!("{:?}", wanted.base[i].acceleration);
            return Err(s.value(&format!("{SPECTRUM}.base[{i}].acceleration"), value, bound, repair));
        }
    }
    Ok(())
}

/// Refuses files of greatest displacements where a displacement is made of several unknowns, of which each has a greatest of its own.
fn check_fields(scene: &BodyInScene<'_>, analysis: &str) -> Verdict {
    let Some(shell) = scene.as_shell().filter(|_| scene.output.fields.is_some()) else { return Ok(()) };
    let slanted = |v: &[f64; 3]| v.iter().filter(|x| **x != 0.0).count() > 1;
    // What is turned in space holds askew unless it holds all.
    let turned = shell.orientation.is_some();
    let held = |support: &OnSet<'_, Support>| {
        let plane = |normal: &[f64; 3]| turned || slanted(normal);
        let part = support.held.as_ref().is_some_and(|held| {
            held.displacement.iter().any(slanted) || turned && (1..3).contains(&held.displacement.len())
        });
        let planes = [support.symmetry.map(|own| own.normal), support.diaphragm.map(|own| own.axis)];
        part || planes.iter().flatten().any(plane)
    };
    let what = if !shell.rigid.is_empty() {
        "a rigid set"
    } else if !shell.ties.is_empty() {
        "a tied edge"
    } else if scene.supports.iter().any(held) {
        "supports that hold askew in space"
    } else {
        return Ok(());
    };
    let bound = format!(
        "none in {analysis} of a shell with {what}: what is greatest of its unknowns is not what is greatest of its displacements"
    );
    let repair = "read columns, which are combined each by itself";
    Err(SceneError::Choice(scene.scope().fault("output.fields", "fields", &bound, repair)))
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
    if let Some([end, last]) = points.last().filter(|point| of_course && point[1] != 0.0) {
        let value = format!("{last} at its end, the time {end}");
        let repair = "add a point with the factor 0 behind the last";
        return Err(s.value(at, value, "zero at its end, behind which the ground is at rest", repair));
    }
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
    check_fields(scene, NOISE)?;
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
