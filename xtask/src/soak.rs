//! `cargo xtask soak`: kills runs of every analysis at random moments, goes on with them, and holds what they leave against
//! runs that were left in peace.

use crate::cargo;
use clap::Args;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

/// How long it goes on.
#[derive(Args)]
pub struct Options {
    /// Kills altogether
    #[arg(long, value_name = "N", default_value_t = 200)]
    kills: usize,
    /// Begin no run after so many minutes
    #[arg(long, value_name = "M", default_value_t = 30.0)]
    minutes: f64,
    /// Where the random moments begin; the same seed gives the same signals
    #[arg(long, value_name = "SEED", default_value_t = 1)]
    seed: u64,
    /// The program to kill [default: coque, built here]
    #[arg(long, value_name = "FILE")]
    program: Option<PathBuf>,
}

/// An analysis to be killed: a name, a scene of scenes/ and what is replaced in it.
type Subject = (&'static str, &'static str, &'static [&'static str]);

/// Every analysis and every model, each about a second long, with frames; with checkpoints where there are any.
const SUBJECTS: [Subject; 11] = [
    (
        "quasi-static",
        "ring",
        &["geometry.plate.particles=[33, 5]", "output.checkpoint_every=0.005", "output.fields.every=2"],
    ),
    (
        "transient",
        "ring",
        &[
            "geometry.plate.particles=[33, 5]",
            "loads.0.couple.moment=5.0",
            "analysis.explicit={ transient = { duration = 100.0, record_every = 0.5, damping = 0.1 } }",
            "output.checkpoint_every=0.005",
            "output.fields.every=20",
        ],
    ),
    (
        "static",
        "ring",
        &[
            "geometry.plate.particles=[33, 5]",
            "analysis.static.levels=40",
            "output.checkpoint_every=0.005",
            "output.fields.every=4",
        ],
    ),
    (
        "arc-length",
        "panel",
        &[
            "geometry.cylinder.particles=[11, 11]",
            "analysis.arc-length.stop={ column = \"w_crown\", above = 30 }",
            "output.fields.every=4",
        ],
    ),
    ("modal", "plate", &["analysis.modal.modes=12", "output.fields.every=1"]),
    ("buckling", "column-buckling", &["geometry.plate.particles=[81, 7]", "output.fields.every=1"]),
    ("linear", "plate", &["geometry.plate.particles=[81, 81]", "output.fields.every=1"]),
    (
        "galerkin",
        "cantilever-solid",
        &["analysis.static.levels=12", "output.checkpoint_every=0.005", "output.fields.every=2"],
    ),
    (
        "fluid",
        "dam-break",
        &[
            "analysis.explicit.transient.duration=0.15",
            "output.checkpoint_every=0.005",
            "output.fields={ every = 5 }",
        ],
    ),
    (
        "coupled",
        "gate",
        &[
            "analysis.explicit.transient.duration=0.03",
            "output.checkpoint_every=0.005",
            "output.fields.every=3",
        ],
    ),
    (
        "bonds",
        "kalthoff",
        &[
            "bodies.plate.solid.geometry.block.spacing=2e-3",
            "output.checkpoint_every=0.005",
            "output.fields.every=20",
        ],
    ),
];

/// What was done and what was found.
#[derive(Default)]
struct Tally {
    kills: usize,
    terms: usize,
    /// Ended by the signal itself, before the program could watch for it.
    early: usize,
    resumed: usize,
    rerun: usize,
    compared: usize,
    faults: Vec<String>,
}

/// Kills, goes on, compares; an error if anything differed or was torn.
pub fn run(options: &Options) -> Result<(), String> {
    let metadata = cargo::metadata()?;
    let target = PathBuf::from(metadata["target_directory"].as_str().unwrap_or("target"));
    let (built, place) = (target.join("debug/coque"), target.join("soak"));
    let program = options.program.as_ref().unwrap_or(&built);
    if options.program.is_none() && !cargo::succeeds(&cargo::words(&["build", "--package", "coque"]))? {
        return Err("coque does not build".into());
    }
    let _ = fs::remove_dir_all(&place);
    let begun = Instant::now();
    let mut dice = RandomNumbers(options.seed);
    let mut tally = Tally::default();
    let mut whole = Vec::new();
    for (name, scene, replaced) in SUBJECTS {
        let soak = Soak { program, name, scene, replaced, place: place.join(name) };
        let begun = Instant::now();
        let status = soak.wait(soak.start("whole", false)?)?;
        if status.code() != Some(0) {
            return Err(format!("{name}: a run left in peace ended with {status}"));
        }
        println!("{name}: {:.2} s in peace", begun.elapsed().as_secs_f64());
        whole.push((soak, begun.elapsed(), left(&place.join(name).join("whole"))?));
    }
    while tally.kills + tally.terms < options.kills && begun.elapsed().as_secs_f64() < 60.0 * options.minutes
    {
        let number = tally.compared;
        let (soak, length, expected) = &whole[number % whole.len()];
        if let Err(fault) = soak.harass(*length, expected, &mut dice, &mut tally) {
            println!("{}: {fault}", soak.name);
            tally.faults.push(format!("{}: {fault}", soak.name));
        }
        tally.compared += 1;
    }
    let Tally { kills, terms, early, resumed, rerun, compared, faults } = tally;
    println!(
        "{kills} kills, {terms} terms ({early} of them before the program watched), {resumed} resumed, {rerun} run anew, {compared} ends compared, {} faults, {:.0} s",
        faults.len(),
        begun.elapsed().as_secs_f64()
    );
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

/// One analysis under harassment.
struct Soak<'a> {
    program: &'a Path,
    name: &'static str,
    scene: &'static str,
    replaced: &'static [&'static str],
    place: PathBuf,
}

impl Soak<'_> {
    /// Starts the run, or goes on with it.
    fn start(&self, folder: &str, resume: bool) -> Result<Child, String> {
        let out = self.place.join(folder);
        let mut command = Command::new(self.program);
        command.current_dir(cargo::root()).stdout(Stdio::null()).stderr(Stdio::null());
        if resume {
            command.arg("resume").arg(out);
        } else {
            command.arg("run").arg(format!("scenes/{}.toml", self.scene)).arg("--out").arg(out);
            for replaced in self.replaced {
                command.args(["--set", replaced]);
            }
        }
        command.spawn().map_err(|error| format!("cannot start {}: {error}", self.program.display()))
    }

    fn wait(&self, mut run: Child) -> Result<ExitStatus, String> {
        run.wait().map_err(|error| error.to_string())
    }

    /// Kills one run some times, lets it come to its end, and compares.
    fn harass(
        &self,
        length: Duration,
        expected: &BTreeMap<String, Vec<u8>>,
        dice: &mut RandomNumbers,
        tally: &mut Tally,
    ) -> Result<(), String> {
        let out = self.place.join("killed");
        let _ = fs::remove_dir_all(&out);
        let mut resume = false;
        loop {
            let begun = SystemTime::now();
            let mut run = self.start("killed", resume)?;
            // three in four are hit; a run left alone this time comes to its end
            if dice.part() < 0.75 {
                sleep(length.mul_f64(1.1 * dice.part()));
            } else {
                let status = self.wait(run)?;
                break self.ended(status, &out, expected);
            }
            if let Some(status) = run.try_wait().map_err(|error| error.to_string())? {
                break self.ended(status, &out, expected);
            }
            let gentle = dice.part() < 0.5;
            signal(&run, if gentle { "-TERM" } else { "-KILL" })?;
            *(if gentle { &mut tally.terms } else { &mut tally.kills }) += 1;
            let (asked, number) = (Instant::now(), run.id());
            let status = self.wait(run)?;
            // The system ends a program that does not watch yet; one that holds its folder does.
            let early = gentle && status.code().is_none() && !holds(&out, number);
            tally.early += usize::from(early);
            if gentle && !early && !matches!(status.code(), Some(0 | 130)) {
                return Err(format!("asked to end it ended with {status}"));
            }
            if gentle && asked.elapsed() > Duration::from_secs(5) + length {
                return Err(format!("asked to end it took {:.1} s", asked.elapsed().as_secs_f64()));
            }
            torn(&out, gentle.then_some(begun), expected)?;
            if status.code() == Some(0) {
                break self.ended(status, &out, expected);
            }
            resume = out.join("checkpoint.bin").exists();
            *(if resume { &mut tally.resumed } else { &mut tally.rerun }) += 1;
        }
    }

    /// Holds the end of a run against the one left in peace.
    fn ended(
        &self,
        status: ExitStatus,
        out: &Path,
        expected: &BTreeMap<String, Vec<u8>>,
    ) -> Result<(), String> {
        if status.code() != Some(0) {
            return Err(format!("it ended with {status}"));
        }
        let found = left(out)?;
        let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>().join(" ");
        if names(&found) != names(expected) {
            return Err(format!("it left {} in the place of {}", names(&found), names(expected)));
        }
        match expected.iter().find(|(name, bytes)| found.get(*name) != Some(*bytes)) {
            Some((name, _)) => Err(format!("{name} differs from that of the run in peace")),
            None => Ok(()),
        }
    }
}

/// Whether the run of that process holds its folder, or left it locked.
fn holds(out: &Path, process: u32) -> bool {
    let lock = fs::read_to_string(out.join("coque.lock")).unwrap_or_default();
    lock.split_whitespace().nth(1) == Some(process.to_string().as_str())
}

/// Refuses files that are neither whole nor absent after a run was ended; where it had time to clear up, what it began since
/// then, not what a run killed before it left where it did not come to clear the folder.
fn torn(
    out: &Path,
    gently_since: Option<SystemTime>,
    expected: &BTreeMap<String, Vec<u8>>,
) -> Result<(), String> {
    for (name, path) in files(out) {
        let modified = fs::metadata(&path).and_then(|data| data.modified());
        let gently =
            gently_since.is_some_and(|begun| !modified.as_ref().is_ok_and(|modified| *modified < begun));
        let bytes = fs::read(&path).map_err(|error| format!("{name}: {error}"))?;
        let whole = match path.extension().and_then(|extension| extension.to_str()) {
            Some("csv") => {
                let rows = expected.get(&name).is_some_and(|whole| whole.starts_with(&bytes));
                rows && (bytes.ends_with(b"\n") || !gently)
            }
            Some("json") => serde_json::from_slice::<Value>(&bytes).is_ok(),
            Some("svg") => bytes.trim_ascii_end().ends_with(b"</svg>"),
            Some("vtu" | "pvd") => bytes.trim_ascii_end().ends_with(b"</VTKFile>"),
            Some("part" | "tmp") => !gently,
            _ => true,
        };
        if !whole {
            return Err(format!("{name} is torn"));
        }
    }
    Ok(())
}

/// Files below a folder by their names within it.
fn files(folder: &Path) -> BTreeMap<String, PathBuf> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let (name, path) = (entry.file_name().to_string_lossy().into_owned(), entry.path());
        if path.is_dir() {
            found.extend(files(&path).into_iter().map(|(inner, path)| (format!("{name}/{inner}"), path)));
        } else {
            found.insert(name, path);
        }
    }
    found
}

/// What a run left, without the times in its summary.
fn left(folder: &Path) -> Result<BTreeMap<String, Vec<u8>>, String> {
    let mut left = BTreeMap::new();
    for (name, path) in files(folder) {
        let mut bytes = fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        if name == "summary.json" {
            let mut summary: Value = serde_json::from_slice(&bytes).map_err(|error| error.to_string())?;
            for timed in ["wall_seconds", "particle_steps_per_second"] {
                summary.as_object_mut().map(|summary| summary.remove(timed));
            }
            bytes = summary.to_string().into_bytes();
        }
        left.insert(name, bytes);
    }
    Ok(left)
}

fn signal(run: &Child, name: &str) -> Result<(), String> {
    let sent = Command::new("kill").args([name, &run.id().to_string()]).status();
    sent.map(|_| ()).map_err(|error| format!("cannot start kill: {error}"))
}

/// Numbers in [0, 1) that look random (xorshift).
struct RandomNumbers(u64);

impl RandomNumbers {
    fn part(&mut self) -> f64 {
        self.0 = (self.0 ^ 0x9e37_79b9_7f4a_7c15).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        self.0 ^= self.0 >> 31;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_torn_file_is_seen() {
        let folder = std::env::temp_dir().join(format!("coque-soak-{}", std::process::id()));
        fs::create_dir_all(folder.join("fields")).unwrap();
        let expected = BTreeMap::from([("curve.csv".to_owned(), b"a,b\n1,2\n3,4\n".to_vec())]);
        let found = |name: &str, text: &str, gently: bool| {
            fs::write(folder.join(name), text).unwrap();
            let begun = SystemTime::now() - Duration::from_secs(60);
            let found = torn(&folder, gently.then_some(begun), &expected);
            fs::remove_file(folder.join(name)).unwrap();
            found.is_ok()
        };
        assert!(found("curve.csv", "a,b\n1,2\n", true));
        assert!(!found("curve.csv", "a,b\n1,3\n", true));
        assert!(!found("curve.csv", "a,b\n1,", true) && found("curve.csv", "a,b\n1,", false));
        assert!(found("summary.json", "{}", true) && !found("summary.json", "{", false));
        assert!(found("fields/a.vtu", "</VTKFile>\n", true) && !found("fields/a.vtu", "</VTK", false));
        assert!(found("checkpoint.part", "", false) && !found("checkpoint.part", "", true));
        // What was there before the run is not what it left.
        fs::write(folder.join("curve.csv.part"), "a,").unwrap();
        let later = SystemTime::now() + Duration::from_secs(60);
        assert!(torn(&folder, Some(later), &expected).is_ok());
        assert!(torn(&folder, Some(SystemTime::UNIX_EPOCH), &expected).is_err());
        fs::write(folder.join("coque.lock"), "process 41 on host\n").unwrap();
        assert!(holds(&folder, 41) && !holds(&folder, 4) && !holds(&folder.join("fields"), 41));
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn moments_are_spread() {
        let mut dice = RandomNumbers(1);
        let mean = (0..1000).map(|_| dice.part()).sum::<f64>() / 1000.0;
        assert!((mean - 0.5).abs() < 0.05, "{mean}");
    }
}
