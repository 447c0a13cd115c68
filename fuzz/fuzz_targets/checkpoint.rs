//! Any bytes as a checkpoint, and any bytes in one whose length and checksum are right, end in a run or in a refusal.
#![no_main]

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use coque::{
    CHECKPOINT, Checkpoint, Checkpoints, ProgressReport, Origin, Progress, RunOptions, SCENE_COPY, Scene,
};

const TEXT: &str = include_str!("../../scenes/ring.toml");
/// Mark and version, then length and checksum.
const BEFORE: usize = 8 + 4;
const HEADER: usize = BEFORE + 8 + 4;

struct StopAfter(usize);

impl Progress for StopAfter {
    fn update(&mut self, _: &ProgressReport) -> ControlFlow<()> {
        self.0 = self.0.saturating_sub(1);
        if self.0 == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
    fn warn(&mut self, _: &str) {}
}

/// A folder of this process, and the checkpoints of a march and of static levels.
static PLACE: LazyLock<(PathBuf, [Vec<u8>; 2])> = LazyLock::new(|| {
    let folder = std::env::temp_dir().join(format!("coque-fuzz-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder for files");
    fs::write(folder.join(SCENE_COPY), TEXT).expect("room for a scene");
    let kept = ["analysis.explicit.quasi-static.levels", "analysis.static.levels"].map(|key| {
        let pairs = [("geometry.plate.particles", "[5, 3]"), (key, "3")];
        let replaced: Vec<_> = pairs.map(|(path, value)| (path.to_owned(), value.to_owned())).into();
        let scene = Scene::with_overrides(TEXT, "ring.toml", &replaced).expect("a scene");
        let origin = Origin::new(TEXT, "ring.toml".into(), replaced, 1);
        let mut checkpoints = Checkpoints::new(&folder, origin, 0.0);
        let (progress, checkpoints) = (&mut StopAfter(3), Some(&mut checkpoints));
        let options = RunOptions { progress, checkpoints, fields: None, from: None };
        let _ = scene.build(1).expect("a model").run_with(options);
        fs::read(folder.join(CHECKPOINT)).expect("a checkpoint")
    });
    (folder, kept)
});

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let (folder, kept) = &*PLACE;
    let Some((&how, bytes)) = bytes.split_first() else { return };
    let whole = &kept[usize::from(how & 1)];
    let file = if how & 2 == 0 {
        sealed(&whole[..BEFORE], bytes)
    } else if how & 4 == 0 {
        // pairs of a place and a byte, put into what was kept
        let mut body = whole[HEADER..].to_vec();
        for change in bytes.chunks_exact(3) {
            let at = usize::from(change[0]) << 8 | usize::from(change[1]);
            let length = body.len();
            body[at % length] = change[2];
        }
        sealed(&whole[..BEFORE], &body)
    } else {
        bytes.to_vec()
    };
    fs::write(folder.join(CHECKPOINT), file).expect("room for a checkpoint");
    go_on(folder);
});

fn sealed(start: &[u8], body: &[u8]) -> Vec<u8> {
    [start, &(body.len() as u64).to_le_bytes(), &crc32fast::hash(body).to_le_bytes(), body].concat()
}

fn go_on(folder: &Path) {
    let Ok((checkpoint, text)) = Checkpoint::read(folder) else { return };
    let origin = checkpoint.origin.clone();
    let Ok(scene) = Scene::with_overrides(&text, &origin.file, &origin.replaced) else { return };
    if !scene.as_shell().and_then(|shell| shell.geometry.particles()).is_some_and(|[n1, n2]| n1 * n2 <= 100) {
        return;
    }
    let Ok(model) = scene.build(1) else { return };
    let options =
        RunOptions { progress: &mut StopAfter(2), checkpoints: None, fields: None, from: Some(checkpoint) };
    let _ = model.run_with(options);
}
