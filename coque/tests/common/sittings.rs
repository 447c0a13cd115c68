//! Runs in sittings: stopped, and gone on with from their checkpoints.

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use coque::{
    Checked, Checkpoint, Checkpoints, Ended, FieldFiles, FieldSink, Origin, Outcome, Progress,
    ProgressReport, RunOptions, SCENE_COPY, Scene, Silent,
};

/// A folder of its own, empty.
pub fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("resume").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Overrides of a scene, owned.
pub type Pairs = Vec<(String, String)>;

/// Paths and values, owned.
pub fn pairs(replaced: &[(&str, &str)]) -> Pairs {
    replaced.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect()
}

/// Ends the run when it has been informed this often.
pub struct StopAfter(pub usize);

impl Progress for StopAfter {
    fn update(&mut self, _: &ProgressReport) -> ControlFlow<()> {
        self.0 = self.0.saturating_sub(1);
        if self.0 == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
    fn warn(&mut self, message: &str) {
        panic!("{message}");
    }
}

/// The first sitting of a run, in a folder.
pub fn start(folder: &Path, text: &str, replaced: &Pairs, progress: &mut dyn Progress) -> Outcome {
    fs::write(folder.join(SCENE_COPY), text).unwrap();
    let scene = Scene::with_overrides(text, "test.toml", replaced).unwrap();
    let origin = Origin::new(text, "test.toml".into(), replaced.clone(), 1);
    sit(folder, &scene, origin, progress, None)
}

/// The next sitting, from the checkpoint.
pub fn go_on(folder: &Path, progress: &mut dyn Progress) -> Outcome {
    let (checkpoint, text) = Checkpoint::read(folder).unwrap();
    let origin = checkpoint.origin.clone();
    let scene = Scene::with_overrides(&text, &origin.file, &origin.replaced).unwrap();
    sit(folder, &scene, origin, progress, Some(checkpoint))
}

/// A sitting.
pub fn sit(
    folder: &Path,
    scene: &Checked,
    origin: Origin,
    progress: &mut dyn Progress,
    from: Option<Checkpoint>,
) -> Outcome {
    // Once an hour: only where a checkpoint is written at any rate.
    let mut checkpoints = Checkpoints::new(folder, origin, 3600.0);
    let place = folder.join("fields");
    let mut files = scene.output.fields.map(|wanted| match &from {
        None => FieldFiles::create(&place, FieldFiles::LONE, &wanted).unwrap(),
        Some(checkpoint) => {
            FieldFiles::go_on(&place, FieldFiles::LONE, &wanted, checkpoint.frames()).unwrap()
        }
    });
    let fields = files.as_mut().map(|files| files as &mut dyn FieldSink);
    let options = RunOptions { progress, checkpoints: Some(&mut checkpoints), fields, from };
    scene.build(1).unwrap().run_with(options).unwrap()
}

/// The same but for the wall time.
pub fn same(one: &Outcome, other: &Outcome) {
    assert_eq!(one.ended, other.ended);
    let bits = |outcome: &Outcome| -> Vec<Vec<u64>> {
        outcome.curve.rows.iter().map(|row| row.iter().map(|x| x.to_bits()).collect()).collect()
    };
    assert_eq!(bits(one), bits(other));
    assert_eq!(one.shapes, other.shapes);
    let plain = |outcome: &Outcome| {
        let mut summary = serde_json::to_value(&outcome.summary).unwrap();
        for timed in ["wall_seconds", "particle_steps_per_second"] {
            summary.as_object_mut().unwrap().remove(timed);
        }
        summary
    };
    assert_eq!(plain(one), plain(other));
}

/// Runs a scene through, then again in sittings that end after 1, 2, 4, 8 … updates.
pub fn stopped_again_and_again(name: &str, text: &str, replaced: &[(&str, &str)], least_stops: usize) {
    let (folder, replaced) = (folder(name), pairs(replaced));
    let scene = Scene::with_overrides(text, "test.toml", &replaced).unwrap();
    let whole = scene.build(1).unwrap().run(&mut Silent);
    let mut after = 1;
    let mut outcome = start(&folder, text, &replaced, &mut StopAfter(after));
    let mut stops = 0;
    while let Ended::Interrupted { .. } = outcome.ended {
        stops += 1;
        after *= 2;
        outcome = go_on(&folder, &mut StopAfter(after));
    }
    assert!(stops >= least_stops, "{name}: {stops} stops");
    same(&outcome, &whole);
}
