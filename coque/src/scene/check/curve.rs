//! Checks of what is recorded: columns, frames, plot, checkpoints.

use std::collections::BTreeSet;

use crate::scene::error::SceneError;
use crate::scene::problem::Scene;

type Checked = Result<(), SceneError>;

impl Scene {
    fn check_checkpoints(&self) -> Checked {
        let Some(every) = self.output.checkpoint_every else { return Ok(()) };
        let path = "output.checkpoint_every";
        let kind = self.analysis.kind();
        if !kind.resumes {
            let what = kind.name;
            let bound = format!("left out in {what}, which cannot go on from its middle");
            let repair = "remove it, or use [analysis.explicit] or [analysis.static]";
            return Err(self.scope().value(path, every, &bound, repair));
        }
        self.scope().positive(path, every)
    }

    pub(super) fn check_curve(&self) -> Checked {
        let s = &self.scope();
        let mut names: BTreeSet<&str> = self.analysis.kind().columns.iter().copied().collect();
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
