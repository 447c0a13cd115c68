//! A program run to its end: how long it took, how long its processor worked, the most memory that it held.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// What a run took.
pub struct Ran {
    /// By the clock \[s\].
    pub seconds: f64,
    /// Of the processor, all threads together \[s\], in steps of .01; where the system tells.
    pub processor: Option<f64>,
    /// The greatest resident set \[MB\], as last seen; where the system tells.
    pub memory: Option<f64>,
    /// What it printed.
    pub output: String,
}

/// How often the memory is looked at.
const LOOK: Duration = Duration::from_millis(2);

/// Runs a program in a folder on so many threads; an error where it cannot be started or ends badly.
pub fn run(command: &mut Command, folder: &Path, threads: u32) -> Result<Ran, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let said = |error: std::io::Error| format!("{name}: {error}");
    let (out, err) = (folder.join("output.txt"), folder.join("errors.txt"));
    for variable in ["OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"] {
        command.env(variable, threads.to_string());
    }
    command.current_dir(folder).stdin(Stdio::null());
    command.stdout(File::create(&out).map_err(said)?).stderr(File::create(&err).map_err(said)?);
    let before = children();
    let start = Instant::now();
    let mut child = command.spawn().map_err(said)?;
    let status = format!("/proc/{}/status", child.id());
    let watch = thread::spawn(move || {
        let mut most = None;
        while let Some(now) = resident(&status) {
            most = Some(now);
            thread::sleep(LOOK);
        }
        most
    });
    let ended = child.wait().map_err(said)?;
    let seconds = start.elapsed().as_secs_f64();
    let processor = before.zip(children()).map(|(before, after)| after - before);
    let output = String::from_utf8_lossy(&fs::read(&out).map_err(said)?).into_owned();
    if !ended.success() {
        let errors = String::from_utf8_lossy(&fs::read(&err).map_err(said)?).into_owned();
        let last = errors.lines().chain(output.lines()).rfind(|line| !line.trim().is_empty());
        return Err(format!("{name} ended with {ended}: {}", last.unwrap_or("it said nothing")));
    }
    Ok(Ran { seconds, processor, memory: watch.join().ok().flatten(), output })
}

/// `VmHWM` of a process \[MB\]; none once it is over.
fn resident(status: &str) -> Option<f64> {
    let text = fs::read_to_string(status).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.split_whitespace().next()?.parse::<f64>().ok()? / 1024.0)
}

/// Time of the processor that ended children of this process took \[s\]: the fields `cutime` and `cstime`, in hundredths.
fn children() -> Option<f64> {
    let text = fs::read_to_string("/proc/self/stat").ok()?;
    let (_, fields) = text.rsplit_once(')')?;
    let mut fields = fields.split_whitespace().skip(13).map(|field| field.parse::<f64>().ok());
    Some((fields.next()?? + fields.next()??) / 100.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_program_prints_is_kept_and_how_it_ends_is_said() {
        let folder = std::env::temp_dir().join(format!("peers-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let ran = run(Command::new("cargo").arg("--version"), &folder, 1).unwrap();
        assert!(ran.output.starts_with("cargo ") && ran.seconds > 0.0);
        let failed = run(Command::new("cargo").arg("no-such-subcommand-anywhere"), &folder, 1).err().unwrap();
        assert!(failed.contains("cargo ended with"), "{failed}");
        assert!(run(&mut Command::new("no-such-program-anywhere"), &folder, 1).is_err());
        fs::remove_dir_all(&folder).unwrap();
    }
}
