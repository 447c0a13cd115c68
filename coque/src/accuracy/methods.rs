//! Methods and analyses whose answers are those of a scene.

use crate::scene::{Analysis, BodyScene, Checked, Formulation, Reach, Scene, Static, StressPoint};

/// The scene itself, and others that ask for the same states of rest, each with its name.
pub(super) fn methods(scene: &Checked) -> Vec<(String, Checked)> {
    let mut scenes = vec![scene.clone()];
    let levels = match &scene.analysis {
        Analysis::Explicit(explicit) => explicit.quasi_static.as_ref().map(|path| &path.levels),
        Analysis::Relaxation(relaxation) => Some(&relaxation.levels),
        _ => None,
    };
    if let Some(levels) = levels {
        let analysis = Analysis::Static(Static::at(levels.clone()));
        scenes.extend(Scene { analysis, ..Scene::clone(scene) }.check());
    }
    let mut cells = Scene::clone(scenes.last().unwrap_or(scene));
    if let Some(BodyScene::Shell(shell)) = cells.bodies.values_mut().next()
        && !is_cell(&shell.formulation)
    {
        let curvature = shell.formulation.curvature().map(str::to_owned);
        shell.formulation =
            Formulation::StressPoint(StressPoint { support: Reach::Cell, kernel: None, curvature });
        scenes.extend(cells.check());
    }
    scenes.into_iter().map(|scene| (named(&scene), scene)).collect()
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
