//! Checks of load cases: all that drives has one, what has one superposes, and combinations name cases that there are.

use std::collections::BTreeSet;

use crate::scene::analysis::Analysis;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::problem::Scene;
use crate::scene::scope::Scope;

/// Most cases and combinations together: each is a row, a shape and a frame.
const MOST: usize = 1000;

/// Refuses cases where nothing superposes, and what has no case beside what has one.
pub(super) fn check_cases(scene: &Scene) -> Verdict {
    let s = &scene.scope();
    let cases = scene.cases();
    if cases.is_empty() {
        if scene.output.fields.is_some_and(|fields| fields.envelope) {
            let (bound, repair) =
                ("none of a scene without load cases", "remove it, or add case = \"…\" to each load");
            return refuse(s, "output.fields.envelope", "an envelope of fields", bound, repair);
        }
        if scene.combinations().is_empty() {
            return Ok(());
        }
        let (bound, repair) = ("none of a scene without load cases", "add case = \"…\" to each of its loads");
        return refuse(s, &combined(scene), "combinations", bound, repair);
    }
    check_analysis(scene, s)?;
    check_loads(scene, s)?;
    check_supports(scene, s)?;
    check_combinations(scene, s, &cases)
}

fn refuse(s: &Scope<'_>, path: &str, value: &str, bound: &str, repair: &str) -> Verdict {
    Err(SceneError::Choice(s.fault(path, value, bound, repair)))
}

/// Where combinations stand.
fn combined(scene: &Scene) -> String {
    format!("analysis.{}.combinations", scene.analysis.kind().word)
}

/// Where the first case is named.
fn first_place(scene: &Scene) -> String {
    let load = scene.loads.iter().position(|load| load.case.is_some()).map(|i| format!("loads[{i}].case"));
    let support = || scene.supports.iter().position(|own| own.case.is_some());
    load.or_else(|| support().map(|i| format!("supports[{i}].case"))).unwrap_or_default()
}

/// Answers superpose where they are linear, and errors are paired row by row of one answer.
fn check_analysis(scene: &Scene, s: &Scope<'_>) -> Verdict {
    if !matches!(scene.analysis, Analysis::Linear(_) | Analysis::Harmonic(_)) {
        let kind = scene.analysis.kind().name;
        let bound =
            format!("none in {kind}: answers to load cases superpose in linear and harmonic analyses alone");
        let repair = "use [analysis.linear], or run the scene once for each case with that case's loads, without `case`";
        return refuse(s, &first_place(scene), "a load case", &bound, repair);
    }
    if let Analysis::Harmonic(wanted) = &scene.analysis {
        if wanted.base.is_some() {
            let bound = "none beside load cases, of which it is none";
            let repair = "run the scene once more with it, without loads";
            return refuse(s, "analysis.harmonic.base", "a base that shakes", bound, repair);
        }
        if scene.output.fields.is_some() {
            let bound = "none beside load cases that vibrate, whose shapes are not kept";
            let repair = "remove it, or run the scene with the loads of one case, without `case`";
            return refuse(s, "output.fields", "fields", bound, repair);
        }
    }
    if scene.error.is_some() {
        let bound = "none beside load cases: errors are found of one answer";
        let repair = "remove it (`--error`, `--accuracy`), or run the scene with the loads of one case, without `case`";
        return refuse(s, "error", "errors of the numbers", bound, repair);
    }
    Ok(())
}

fn check_loads(scene: &Scene, s: &Scope<'_>) -> Verdict {
    for (i, load) in scene.loads.iter().enumerate() {
        let at = |key: &str| format!("loads[{i}].{key}");
        if load.preload {
            let bound = "none of a preload, which is there in every case";
            match load.case {
                Some(_) => return refuse(s, &at("case"), "a load case", bound, "remove it"),
                None => continue,
            }
        }
        let Some(case) = &load.case else {
            let bound = "one with a case, as other loads have";
            let repair = "add case = \"…\"; what acts in several cases has a case of its own, which combinations count";
            return refuse(s, &format!("loads[{i}]"), "a load without a case", bound, repair);
        };
        check_name(s, &at("case"), case)?;
        if load.encloses() {
            let word = if load.gas.is_some() { "gas" } else { "volume" };
            let bound =
                "none beside load cases: what is enclosed is a stiffness, which all cases would share";
            let repair = "put a `pressure` in its place, or run the scene once for each case, without `case`";
            return refuse(s, &at(word), &format!("a `{word}`"), bound, repair);
        }
    }
    Ok(())
}

fn check_supports(scene: &Scene, s: &Scope<'_>) -> Verdict {
    for (i, support) in scene.supports.iter().enumerate() {
        let at = |key: &str| format!("supports[{i}].{key}");
        let motion = support.motion().filter(|_| !support.preload);
        match (&support.case, motion) {
            (None, None) => {}
            (Some(case), Some(_)) => check_name(s, &at("case"), case)?,
            (Some(_), None) => {
                let bound = "none of what stands still or preloads: it holds in every case";
                return refuse(s, &at("case"), "a load case", bound, "remove it");
            }
            (None, Some((word, _))) => {
                let bound = "one with a case, as other loads and motions have";
                let repair = "add case = \"…\": in other cases the set stands still";
                return refuse(s, &at(word), "a prescribed motion without a case", bound, repair);
            }
        }
    }
    // Two motions of one set in two cases: where one is under way the other would hold it.
    for (i, one) in scene.supports.iter().enumerate() {
        let twice = |other: &&crate::scene::Support| {
            let kinds = (one.motion().map(|m| m.0), other.motion().map(|m| m.0));
            other.on == one.on && other.case != one.case && kinds.0.is_some() && kinds.0 == kinds.1
        };
        let parallel = |other: &&crate::scene::Support| match (one.moved, other.moved) {
            (Some(a), Some(b)) => {
                let [a, b] = [a, b].map(|moved| sph_core::Vec3::from(moved.direction).normalize());
                a.cross(&b).norm() < 1e-6
            }
            _ => true,
        };
        if scene.supports[..i].iter().filter(twice).any(|other| parallel(&other)) {
            let word = one.motion().map_or("moved", |(word, _)| word);
            let bound = "one alone: in each case the motions of the others hold the set";
            let repair = "give the set one motion in a case of its own, and let combinations take it times their factors";
            return refuse(s, &format!("supports[{i}].{word}"), "a second motion of the set", bound, repair);
        }
    }
    Ok(())
}

fn check_combinations(scene: &Scene, s: &Scope<'_>, cases: &[&str]) -> Verdict {
    let combinations = scene.combinations();
    if cases.len() + combinations.len() > MOST {
        let bound = format!("at most {MOST} of cases and combinations together");
        let value = cases.len() + combinations.len();
        return Err(s.value(&combined(scene), value, &bound, "take fewer combinations at a time"));
    }
    let mut taken: BTreeSet<&str> = cases.iter().copied().collect();
    for (i, own) in combinations.iter().enumerate() {
        let at = |key: &str| format!("{}[{i}].{key}", combined(scene));
        check_name(s, &at("name"), &own.name)?;
        if !taken.insert(&own.name) {
            let repair = "rename it: cases and combinations have names of their own";
            return Err(s.value(&at("name"), format!("\"{}\"", own.name), "a name of its own", repair));
        }
        if own.of.is_empty() {
            let repair = format!("of = {{ {} = 1.0 }}", cases[0]);
            return Err(s.value(&at("of"), "empty", "the factor of at least one case", &repair));
        }
        for (case, &factor) in &own.of {
            s.word(&at(&format!("of.{case}")), case, cases)?;
            s.sized(&at(&format!("of.{case}")), factor)?;
        }
        let own: Vec<&str> = own.of.keys().map(String::as_str).collect();
        for (case, &phase) in &combinations[i].phases {
            let path = at(&format!("phases.{case}"));
            if matches!(scene.analysis, Analysis::Linear(_)) {
                let bound = "none in a linear answer, where nothing swings";
                return refuse(s, &path, "a phase", bound, "remove it, or use [analysis.harmonic]");
            }
            s.word(&path, case, &own)?;
            s.sized(&path, phase)?;
        }
    }
    Ok(())
}

/// A case names files and frames.
fn check_name(s: &Scope<'_>, path: &str, name: &str) -> Verdict {
    let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || "_-.+".contains(c));
    if !name.is_empty() && name.len() <= 60 && plain {
        return Ok(());
    }
    let repair = "it names frames and rows: use letters, digits, _, -, + and . , sixty at most";
    Err(s.value(path, format!("\"{name}\""), "a plain word", repair))
}
