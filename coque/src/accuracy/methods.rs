//! Methods and analyses whose answers are those of a scene.

use crate::scene::{Analysis, Formulation, Reach, Scene, Static, StressPoint};

impl Scene {
    /// The scene itself, and others that ask for the same states of rest, each with its name.
    pub(super) fn methods(&self) -> Vec<(String, Scene)> {
        let mut scenes = vec![self.clone()];
        let levels = match &self.analysis {
            Analysis::Explicit(explicit) => explicit.quasi_static.as_ref().map(|path| &path.levels),
            Analysis::Relaxation(relaxation) => Some(&relaxation.levels),
            _ => None,
        };
        if let Some(levels) = levels {
            let mut at_rest = self.clone();
            at_rest.analysis = Analysis::Static(Static::at(levels.clone()));
            scenes.push(at_rest);
        }
        if let Some(shell) = self.as_shell().filter(|shell| !is_cell(&shell.formulation)) {
            let curvature = shell.formulation.curvature().to_owned();
            let mut cells = scenes.last().unwrap_or(self).clone();
            cells.shell_mut().formulation =
                Formulation::StressPoint(StressPoint { support: Reach::Cell, kernel: None, curvature });
            scenes.push(cells);
        }
        scenes.into_iter().map(|scene| (named(&scene), scene)).collect()
    }
}

fn is_cell(formulation: &Formulation) -> bool {
    matches!(formulation, Formulation::StressPoint(f) if f.support == Reach::Cell)
}

/// Method and analysis in words.
fn named(scene: &Scene) -> String {
    let analysis = scene.analysis.kind().word;
    match scene.as_shell() {
        Some(shell) if is_cell(&shell.formulation) => format!("cells, {analysis}"),
        Some(shell) => format!("{}, {analysis}", shell.formulation.describe()),
        None => analysis.to_owned(),
    }
}
