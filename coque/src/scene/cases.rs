//! Load cases: which loads and motions act together, combinations of cases with factors, and the scene under one of them.

use std::collections::BTreeMap;

use serde::Serialize;

use super::analysis::Analysis;
use super::checked::Checked;
use super::combination::Combination;
use super::loads::Load;
use super::problem::Scene;
use super::supports::Support;

/// The column of the curve that has the number of a case or combination, from 1.
pub(crate) const CASE: &str = "case";

/// A load case, or a combination of them: what an answer is to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LoadSet {
    /// Its name.
    pub name: String,
    /// Whether it is a combination.
    pub combines: bool,
    /// Factor of each case that acts, by its name \[–\].
    pub of: BTreeMap<String, f64>,
    /// By how much some are ahead of the others, of steady vibration \[degrees\].
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub phases: BTreeMap<String, f64>,
}

impl LoadSet {
    /// What goes as the cosine, and where there are phases what goes as its negative sine: `f cos φ` and `f sin φ` of each case.
    pub(crate) fn by_phase(&self) -> Vec<Self> {
        if self.phases.is_empty() {
            return vec![self.clone()];
        }
        let part = |of: fn(f64) -> f64| {
            let phase = |case: &str| self.phases.get(case).map_or(0.0, |phase| phase.to_radians());
            let of = self.of.iter().map(|(case, factor)| (case.clone(), factor * of(phase(case))));
            Self { of: of.collect(), phases: BTreeMap::new(), ..self.clone() }
        };
        vec![part(libm::cos), part(libm::sin)]
    }
}

impl Scene {
    /// Names of the load cases, in the order in which loads, then supports, first name them.
    pub fn cases(&self) -> Vec<&str> {
        let loads = self.loads.iter().filter_map(|load| load.case.as_deref());
        let motions = self.supports.iter().filter_map(|support| support.case.as_deref());
        let mut found = Vec::new();
        for name in loads.chain(motions) {
            if !found.contains(&name) {
                found.push(name);
            }
        }
        found
    }

    /// Columns that every curve of the scene has.
    pub(crate) fn first_columns<'a>(&self) -> impl Iterator<Item = &'a str> + use<'a> {
        let case = (!self.cases().is_empty()).then_some(CASE);
        case.into_iter().chain(self.analysis.columns())
    }

    /// Combinations of load cases, as the scene has them.
    pub fn combinations(&self) -> &[Combination] {
        match &self.analysis {
            Analysis::Linear(wanted) => &wanted.combinations,
            Analysis::Harmonic(wanted) => &wanted.combinations,
            _ => &[],
        }
    }

    /// Load cases, then combinations: an answer each. Empty in a scene without cases.
    pub fn load_sets(&self) -> Vec<LoadSet> {
        let case = |name: &str| {
            let (name, of) = (name.to_string(), [(name.to_string(), 1.0)].into());
            LoadSet { name, combines: false, of, phases: BTreeMap::new() }
        };
        let combined = |own: &Combination| {
            let (name, of, phases) = (own.name.clone(), own.of.clone(), own.phases.clone());
            LoadSet { name, combines: true, of, phases }
        };
        let cases = self.cases().into_iter().map(case);
        cases.chain(self.combinations().iter().map(combined)).collect()
    }
}

impl Checked {
    /// The scene under some load cases: loads times the factors of their cases, loads of other cases left out, motions of other cases standing still.
    pub(crate) fn under(&self, set: &LoadSet) -> Self {
        let factor = |case: &Option<String>| match case {
            Some(name) => set.of.get(name).copied(),
            None => Some(1.0),
        };
        let mut scene = self.clone().into_scene();
        scene.is_load_set = true;
        scene.loads.retain(|load| factor(&load.case).is_some());
        scene.loads.iter_mut().for_each(|load| scale_load(load, factor(&load.case).unwrap_or_default()));
        for support in &mut scene.supports {
            scale_motion(support, factor(&support.case).unwrap_or_default());
        }
        Self::made_of(scene)
    }
}

/// A load times a factor; what cells enclose has no case.
fn scale_load(load: &mut Load, by: f64) {
    let all = |v: &mut [f64]| v.iter_mut().for_each(|x| *x *= by);
    if let Some(force) = &mut load.force {
        all(&mut force.total);
    }
    if let Some(couple) = &mut load.couple {
        couple.moment *= by;
    }
    if let Some(pressure) = &mut load.pressure {
        pressure.value = Some(by * pressure.value());
    }
    if let Some(gravity) = &mut load.gravity {
        all(&mut gravity.acceleration);
    }
    if let Some(traction) = &mut load.traction {
        all(&mut traction.value);
    }
    if let Some(heat) = &mut load.temperature {
        for x in [&mut heat.change, &mut heat.difference].into_iter().flatten() {
            *x *= by;
        }
    }
}

/// A prescribed motion times a factor.
fn scale_motion(support: &mut Support, by: f64) {
    if let Some(moved) = &mut support.moved {
        moved.by *= by;
    }
    if let Some(rotated) = &mut support.rotated {
        rotated.by *= by;
    }
    if let Some(turned) = &mut support.turned {
        turned.by *= by;
    }
}
