//! Whatever stands in the folder of a run, and whatever `--set` says, ends in a result or in a refusal, never in a panic.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use coque::{
    CHECKPOINT, Checkpoint, Checkpoints, Curve, FieldFiles, FieldSink, Origin, Picture, Progress,
    ProgressReport, Rendering, RunOptions, SCENE_COPY, Scene, Sheet, listed, picture_svg, plot_svg, render,
};
use proptest::prelude::*;

const EXPLICIT: &[(&str, &str)] = &[
    ("geometry.plate.particles", "[9, 3]"),
    ("analysis.explicit.quasi-static.levels", "3"),
    ("output.fields.every", "1"),
];
const TRANSIENT: &[(&str, &str)] = &[
    ("geometry.plate.particles", "[9, 3]"),
    ("loads.0.couple.moment", "5.0"),
    ("analysis.explicit", "{ transient = { duration = 10.0, record_every = 0.1, damping = 0.1 } }"),
];
const STATIC: &[(&str, &str)] = &[("geometry.plate.particles", "[9, 3]"), ("analysis.static.levels", "3")];

fn pairs(replaced: &[(&str, &str)]) -> Vec<(String, String)> {
    replaced.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect()
}

fn scene_text(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name)).unwrap()
}

/// Ends a run after so many words.
struct StopAfter(usize);

impl Progress for StopAfter {
    fn update(&mut self, _: &ProgressReport) -> ControlFlow<()> {
        self.0 = self.0.saturating_sub(1);
        if self.0 == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
    fn warn(&mut self, _: &str) {}
}

/// The folder of a run that was stopped, with its checkpoint and frames.
fn interrupted(name: &str, replaced: &[(&str, &str)]) -> PathBuf {
    // Tests may run as processes of their own, side by side.
    let own = format!("no-panic-{}", std::process::id());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(own).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let text = scene_text("ring.toml");
    fs::write(folder.join(SCENE_COPY), &text).unwrap();
    let replaced = pairs(replaced);
    let scene = Scene::with_overrides(&text, "ring.toml", &replaced).unwrap();
    let mut checkpoints = Checkpoints::new(&folder, Origin::new(&text, "ring.toml".into(), replaced, 1), 0.0);
    let mut files = scene
        .output
        .fields
        .map(|wanted| FieldFiles::create(&folder.join("fields"), FieldFiles::LONE, &wanted).unwrap());
    let options = RunOptions {
        progress: &mut StopAfter(4),
        checkpoints: Some(&mut checkpoints),
        fields: files.as_mut().map(|files| files as &mut dyn FieldSink),
        from: None,
    };
    let outcome = scene.build(1).unwrap().run_with(options).unwrap();
    let mut curve = Vec::new();
    outcome.curve.write_csv(&mut curve).unwrap();
    fs::write(folder.join("curve.csv"), curve).unwrap();
    folder
}

/// Bytes changed, cut off, doubled.
#[derive(Clone, Debug)]
enum Damage {
    Byte(usize, u8),
    Word(usize, u64),
    Cut(usize),
    Double(usize, usize),
}

fn damage() -> impl Strategy<Value = Damage> {
    let word = prop_oneof![Just(0), Just(u64::MAX), Just(f64::NAN.to_bits()), Just(1 << 40), any::<u64>()];
    prop_oneof![
        6 => (any::<usize>(), any::<u8>()).prop_map(|(at, by)| Damage::Byte(at, by)),
        3 => (any::<usize>(), word).prop_map(|(at, by)| Damage::Word(at, by)),
        1 => any::<usize>().prop_map(Damage::Cut),
        1 => (any::<usize>(), 0_usize..64).prop_map(|(at, count)| Damage::Double(at, count)),
    ]
}

fn apply(bytes: &mut Vec<u8>, damage: &Damage) {
    if bytes.is_empty() {
        return;
    }
    let length = bytes.len();
    match *damage {
        Damage::Byte(at, by) => bytes[at % length] = by,
        Damage::Word(at, by) => {
            bytes.iter_mut().skip(at % length).zip(by.to_le_bytes()).for_each(|(a, b)| *a = b)
        }
        Damage::Cut(at) => bytes.truncate(at % length),
        Damage::Double(at, count) => {
            let at = at % length;
            let again = bytes[at..length.min(at + count)].to_vec();
            bytes.splice(at..at, again);
        }
    }
}

/// Bytes of a checkpoint's header before its contents: mark and version; then their length and checksum.
const BEFORE: usize = 8 + 4;
const HEADER: usize = BEFORE + 8 + 4;

/// A header that fits the contents, as a forger would write it.
fn sealed(start: &[u8], body: &[u8]) -> Vec<u8> {
    let (length, checksum) = ((body.len() as u64).to_le_bytes(), crc32fast::hash(body).to_le_bytes());
    [start, &length, &checksum, body].concat()
}

/// Reads the checkpoint in a folder and goes on from it a little way.
fn go_on(folder: &Path) -> Result<(), String> {
    let (checkpoint, text) = Checkpoint::read(folder).map_err(|error| error.to_string())?;
    let origin = checkpoint.origin.clone();
    let scene = Scene::with_overrides(&text, &origin.file, &origin.replaced)
        .map_err(|error| render(&error, Rendering { width: 80, colour: false }))?;
    let counts = scene.as_shell().and_then(|shell| shell.geometry.particles());
    let small = counts.is_some_and(|[n1, n2]| n1 * n2 <= 500);
    if !small {
        return Ok(());
    }
    let model = scene.build(1).map_err(|error| error.to_string())?;
    let options =
        RunOptions { progress: &mut StopAfter(3), checkpoints: None, fields: None, from: Some(checkpoint) };
    model.run_with(options).map(|_| ()).map_err(|error| error.to_string())
}

/// Three interrupted runs and what their checkpoints hold.
static RUNS: LazyLock<Vec<(PathBuf, Vec<u8>)>> = LazyLock::new(|| {
    [("explicit", EXPLICIT), ("transient", TRANSIENT), ("static", STATIC)]
        .map(|(name, replaced)| {
            let folder = interrupted(name, replaced);
            let bytes = fs::read(folder.join(CHECKPOINT)).unwrap();
            (folder, bytes)
        })
        .into()
});

/// Tables and values of a scene, as paths for `--set`.
fn paths(value: &toml::Value, path: &str, found: &mut Vec<String>) {
    if !path.is_empty() {
        found.push(path.into());
    }
    let inside = |key: &str| if path.is_empty() { key.to_string() } else { format!("{path}.{key}") };
    match value {
        toml::Value::Table(table) => table.iter().for_each(|(key, value)| paths(value, &inside(key), found)),
        toml::Value::Array(list) => {
            list.iter().enumerate().for_each(|(i, value)| paths(value, &inside(&i.to_string()), found));
        }
        _ => {}
    }
}

/// Scenes with the paths in them.
static SCENES: LazyLock<Vec<(String, Vec<String>)>> = LazyLock::new(|| {
    ["ring.toml", "panel-laminated.toml", "column-buckling.toml", "plate.toml", "cantilever-end-shear.toml"]
        .map(|name| {
            let text = scene_text(name);
            let mut found = Vec::new();
            paths(&text.parse::<toml::Table>().unwrap().into(), "", &mut found);
            (text, found)
        })
        .into()
});

/// Values that break things.
const VALUES: [&str; 24] = [
    "nan",
    "-inf",
    "-1",
    "0",
    "1e400",
    "1e308",
    "-1e-320",
    "1e30",
    "1e-30",
    "9223372036854775807",
    "2",
    "true",
    "\"\"",
    "[]",
    "{}",
    "[1]",
    "[1, 2]",
    "[[1]]",
    "\"x",
    "{ a = 1 }",
    "{ particles = [3, 3] }",
    "word",
    "[0, 0, 0]",
    "1979-05-27",
];

proptest! {
    // The same cases on every run.
    #![proptest_config(ProptestConfig {
        cases: 384,
        rng_seed: proptest::test_runner::RngSeed::Fixed(1),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn forged_checkpoints_never_panic(
        which in 0..3_usize,
        damages in prop::collection::vec(damage(), 1..4),
        seal in prop::bool::weighted(0.8),
    ) {
        let (folder, whole) = &RUNS[which];
        // the motion is most of the file: half of the damage goes to the front, where lengths and places stand
        let (mut start, mut body) = (whole[..BEFORE].to_vec(), whole[HEADER..].to_vec());
        if seal {
            damages.iter().for_each(|damage| apply(&mut body, damage));
        } else {
            damages.iter().for_each(|damage| apply(&mut start, damage));
        }
        let own = folder.with_extension("forged");
        fs::create_dir_all(&own).unwrap();
        fs::copy(folder.join(SCENE_COPY), own.join(SCENE_COPY)).unwrap();
        fs::write(own.join(CHECKPOINT), sealed(&start, &body)).unwrap();
        if let Err(message) = go_on(&own) {
            prop_assert!(!message.is_empty());
        }
    }

    #[test]
    fn any_bytes_as_a_checkpoint_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..200), seal: bool) {
        let (folder, whole) = &RUNS[0];
        let own = folder.with_extension("any");
        fs::create_dir_all(&own).unwrap();
        fs::copy(folder.join(SCENE_COPY), own.join(SCENE_COPY)).unwrap();
        let file = if seal { sealed(&whole[..BEFORE], &bytes) } else { bytes };
        fs::write(own.join(CHECKPOINT), file).unwrap();
        prop_assert!(go_on(&own).is_err());
    }

    #[test]
    fn damaged_results_never_panic(file in 0..3_usize, damages in prop::collection::vec(damage(), 1..5)) {
        let folder = &RUNS[0].0;
        let own = folder.with_extension("results");
        fs::create_dir_all(own.join("fields")).unwrap();
        let list = folder.join("fields/shell.pvd");
        let frame = listed(&list).unwrap().pop().unwrap().1;
        let curve = folder.join("curve.csv");
        let mut bytes = fs::read([&frame, &list, &curve][file]).unwrap();
        damages.iter().for_each(|damage| apply(&mut bytes, damage));
        let damaged = own.join("fields/damaged");
        fs::write(&damaged, &bytes).unwrap();
        let said = match file {
            0 => Sheet::read(&damaged).map_err(|e| e.to_string()).and_then(|sheet| {
                picture_svg(&sheet, &Picture::new("damaged")).map(|_| ()).map_err(|e| e.to_string())
            }),
            1 => listed(&damaged).map(|_| ()).map_err(|e| e.to_string()),
            _ => String::from_utf8_lossy(&bytes).parse::<Curve>().map_err(|e| e.to_string()).and_then(|curve| {
                let name = |i: usize| curve.columns[i.min(curve.columns.len() - 1)].name.clone();
                let out = own.join("curve.svg");
                plot_svg(&curve, &name(0), &name(1), "damaged", &out).map_err(|e| e.to_string())
            }),
        };
        prop_assert!(said.err().is_none_or(|message| !message.is_empty()));
    }

    #[test]
    fn overrides_of_any_key_never_panic(
        which in 0..5_usize,
        replaced in prop::collection::vec((any::<usize>(), any::<usize>(), 0..8_usize), 1..4),
    ) {
        let (text, found) = &SCENES[which];
        let replaced: Vec<(String, String)> = replaced
            .iter()
            .map(|&(path, value, kind)| {
                let path = &found[path % found.len()];
                // now and then a key beside those that are there, or below one
                let path = match kind {
                    0 => format!("{path}.0"),
                    1 => format!("{path}.particles"),
                    2 => format!("analysis.{}", ["static.levels", "buckling.modes", "modal.modes"][value % 3]),
                    _ => path.clone(),
                };
                (path, VALUES[value % VALUES.len()].into())
            })
            .collect();
        let said = Scene::with_overrides(text, "scene.toml", &replaced).and_then(|scene| {
            let counts = scene.as_shell().and_then(|shell| shell.geometry.particles());
    let small = counts.is_some_and(|[n1, n2]| n1 * n2 <= 300);
            if small { scene.build(1).map(|_| ()) } else { Ok(()) }
        });
        if let Err(error) = said {
            let drawn = render(&error, Rendering { width: 80, colour: true });
            prop_assert!(!drawn.is_empty());
            prop_assert!(!error.fault().repair.is_empty());
        }
    }
}
