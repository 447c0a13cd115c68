//! The checks of a scene that need no particles, first to last.

mod analysis;
mod conditions;
mod shell;

use std::collections::BTreeSet;

use crate::bodies::probe::always;
use crate::bodies::sets::BUILT_IN;
use crate::scene::analysis::Analysis;
use crate::scene::error::SceneError;
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::region::Region;

type Checked = Result<(), SceneError>;

impl Scene {
    /// Refuses the first thing that is out of bounds.
    pub(crate) fn check(&self) -> Checked {
        self.check_units()?;
        self.check_bodies()?;
        self.check_sets()?;
        for (i, support) in self.supports.iter().enumerate() {
            self.check_support(&format!("supports[{i}]"), support)?;
        }
        for (i, load) in self.loads.iter().enumerate() {
            self.check_load(&format!("loads[{i}]"), load)?;
        }
        self.check_analysis()?;
        self.check_curve()
    }

    fn check_units(&self) -> Checked {
        if self.units.consistent() {
            return Ok(());
        }
        let bound = "consistent: all three with a unit, or all three \"-\"";
        let repair = "units = { length = \"m\", force = \"N\", time = \"s\" }, or \"-\" for all three";
        Err(self.scope().value("units", "a mixture of units and \"-\"", bound, repair))
    }

    fn check_bodies(&self) -> Checked {
        let s = &self.scope();
        let mut names = self.bodies.keys();
        let Some(name) = names.next() else {
            let repair =
                "add [geometry], [material] and [section] for a lone shell, or [bodies.NAME.shell] with them";
            return Err(SceneError::Choice(s.fault("bodies", "no body", "one body", repair)));
        };
        if let Some(second) = names.next() {
            let (path, value) = (format!("bodies.{second}"), format!("a body beside `{name}`"));
            let repair = "keep one of them; nothing couples several bodies yet";
            return Err(SceneError::Choice(s.fault(&path, &value, "the only body", repair)));
        }
        let plain = |c: char| c.is_alphanumeric() || "_-".contains(c);
        if name.is_empty() || !name.chars().all(plain) {
            let repair = "it names sets and files: use letters, digits, _ and -";
            return Err(s.value(&format!("bodies.{name}"), format!("\"{name}\""), "a plain word", repair));
        }
        let s = &self.body_scope();
        self.bodies.values().try_for_each(|BodyScene::Shell(shell)| shell.check(s))
    }

    fn check_sets(&self) -> Checked {
        let s = &self.scope();
        for (name, Region { of, nearest, inside, plane }) in &self.sets {
            let at = format!("sets.{name}");
            if let Some(of) = of {
                s.word(&format!("{at}.of"), of, &Vec::from_iter(self.bodies.keys().map(String::as_str)))?;
            }
            if BUILT_IN.contains(&name.as_str()) {
                let fault = s.fault(
                    &at,
                    "declared",
                    "but there is a built-in set of that name",
                    "choose another name",
                );
                return Err(SceneError::Set(fault));
            }
            let mut given = Vec::new();
            given.extend(nearest.map(|_| "nearest"));
            given.extend(inside.map(|_| "box"));
            given.extend(plane.map(|_| "plane"));
            s.exactly_one(&at, "region", &given, &["nearest", "box", "plane"])?;
            if let Some(point) = nearest {
                s.sized_all(&format!("{at}.nearest"), point)?;
            }
            if let Some(plane) = plane {
                s.sized_all(&format!("{at}.plane.point"), &plane.point)?;
                s.direction(&format!("{at}.plane.normal"), plane.normal)?;
                s.positive(&format!("{at}.plane.within"), plane.within.unwrap_or(1.0))?;
            }
            if let Some(region) = inside {
                s.sized_all(&format!("{at}.box.min"), &region.min)?;
                s.sized_all(&format!("{at}.box.max"), &region.max)?;
                if (0..3).any(|i| region.min[i] > region.max[i]) {
                    let value = format!("min {:?}, max {:?}", region.min, region.max);
                    let bound = "min ≤ max in every coordinate";
                    return Err(s.value(&format!("{at}.box"), value, bound, "swap the coordinates"));
                }
            }
        }
        Ok(())
    }

    /// Refuses a name that is no set; those of a mesh are known when its file has been read.
    pub(in crate::scene) fn check_set_name(&self, path: &str, name: &str) -> Checked {
        if self.shell().geometry.mesh().is_some() {
            return Ok(());
        }
        let known: Vec<&str> = BUILT_IN.into_iter().chain(self.sets.keys().map(String::as_str)).collect();
        if known.contains(&name) {
            return Ok(());
        }
        let repair = crate::scene::source::suggest(name, &known);
        Err(SceneError::Set(self.scope().fault(path, &format!("\"{name}\""), "which is no set", &repair)))
    }

    fn check_checkpoints(&self) -> Checked {
        let Some(every) = self.output.checkpoint_every else { return Ok(()) };
        let path = "output.checkpoint_every";
        if !matches!(self.analysis, Analysis::Explicit(_) | Analysis::Static(_)) {
            let what = self.analysis.run_name();
            let bound = format!("left out in {what}, which cannot go on from its middle");
            let repair = "remove it, or use [analysis.explicit] or [analysis.static]";
            return Err(self.scope().value(path, every, &bound, repair));
        }
        self.scope().positive(path, every)
    }

    fn check_curve(&self) -> Checked {
        let s = &self.scope();
        let mut names: BTreeSet<&str> = always(&self.analysis).iter().copied().collect();
        for (i, probe) in self.curve.iter().enumerate() {
            let at = |key: &str| format!("curve[{i}].{key}");
            let name = probe.name.as_str();
            let plain = |c: char| c.is_alphanumeric() || "_-.'".contains(c);
            if name.is_empty() || !name.chars().all(plain) {
                let repair = "it becomes a column name: use letters, digits, _ and -";
                return Err(s.value(&at("name"), format!("\"{name}\""), "a plain word", repair));
            }
            if !names.insert(name) {
                let repair = format!("rename it; taken already: {}", Vec::from_iter(names).join(", "));
                return Err(s.value(&at("name"), format!("\"{name}\""), "a name of its own", &repair));
            }
            self.check_set_name(&at("on"), &probe.on)?;
            s.direction(&at("direction"), probe.direction)?;
            s.sized(&at("factor"), probe.factor)?;
        }
        if self.output.fields.is_some_and(|fields| fields.every == 0) {
            return Err(s.value("output.fields.every", 0, "1 or more", "1 writes every frame"));
        }
        if let Some(plot) = &self.output.plot {
            let known = Vec::from_iter(names);
            s.word("output.plot.x", &plot.x, &known)?;
            s.word("output.plot.y", &plot.y, &known)?;
        }
        self.check_checkpoints()
    }
}
