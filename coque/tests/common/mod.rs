//! What several test files use: scenes of the repository with values replaced, their runs, frames read back.

#![allow(dead_code)] // each test binary uses its own part
#![allow(clippy::unwrap_used)] // a failed test may stop here

pub mod fields;
pub mod fluids;
pub mod galerkin;
pub mod refused;
pub mod sittings;
pub mod solids;
pub mod surfaces;
pub mod torn;

use std::fs;
use std::path::{Path, PathBuf};

use coque::{Checked, Ended, Outcome, Rendering, Scene, SceneError, Silent, render};

/// Overrides of a scene: paths and values.
pub type Replaced<'a> = &'a [(&'a str, &'a str)];

/// The scenes of the repository.
pub fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes")
}

/// The text of one of them.
pub fn text(name: &str) -> String {
    fs::read_to_string(scenes().join(name)).unwrap()
}

/// A scene of some text with values replaced.
pub fn overridden(text: &str, origin: &str, replaced: Replaced) -> Result<Checked, SceneError> {
    let pairs: Vec<_> = replaced.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    Scene::with_overrides(text, origin, &pairs)
}

/// A scene of the repository with values replaced.
pub fn scene(name: &str, replaced: Replaced) -> Result<Checked, SceneError> {
    overridden(&text(name), name, replaced)
}

/// Runs a scene on one thread.
pub fn ran(scene: Result<Checked, SceneError>) -> Outcome {
    scene.unwrap().build(1).unwrap().run(&mut Silent)
}

/// Runs a scene of the repository with values replaced, on one thread.
pub fn run(name: &str, replaced: Replaced) -> Outcome {
    ran(scene(name, replaced))
}

/// The same, which has to reach its end.
pub fn done(name: &str, replaced: Replaced) -> Outcome {
    let outcome = run(name, replaced);
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

/// All values of a column.
pub fn column(outcome: &Outcome, name: &str) -> Vec<f64> {
    outcome.curve.column(name).unwrap()
}

/// The last value of a column: of a linear answer the only one.
pub fn last(outcome: &Outcome, name: &str) -> f64 {
    *column(outcome, name).last().unwrap()
}

/// What refuses a scene of the repository after some values are replaced, in lines of so many letters.
pub fn refusal(name: &str, replaced: Replaced, width: usize) -> String {
    let built = overridden(&text(name), name, replaced).and_then(|scene| scene.build(1).map(drop));
    render(&built.expect_err("not refused"), Rendering { width, colour: false })
}
