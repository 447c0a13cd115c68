//! `cargo xtask aarch64`: tests and scenes on another processor, built across and run under an emulator.
//!
//! Elementary functions come from the crate `libm` and loops of particles sum in a fixed order, so that a march in time gives
//! the same bits there as here. Factorisations sum in lanes of the processor: what is solved agrees to round-off alone.

use crate::cargo;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const TARGET: &str = "aarch64-unknown-linux-gnu";
const LINKER: &str = "aarch64-linux-gnu-gcc";
/// Libraries of the other processor, where Debian and its kin put them.
const LIBRARIES: &str = "/usr/aarch64-linux-gnu";
/// Names under which the emulator is installed.
const EMULATORS: [&str; 2] = ["qemu-aarch64", "qemu-aarch64-static"];
/// Crates whose tests run there: those that all others stand on, and that do not take hours under an emulator.
const TESTED: [&str; 7] =
    ["lanes", "parallel", "peers", "sph-core", "shell-kinematics", "solid-kinematics", "explicit-dynamics"];

/// What solved numbers may differ by, over the largest of their column: a level ends where its residual is a millionth.
const SOLVED: f64 = 1e-6;
/// Least a column counts as: one of residuals holds nothing but round-off.
const RESIDUAL: f64 = 1e-3;

/// A scene that both processors run.
struct Shared {
    scene: &'static str,
    /// What makes it short.
    set: &'static [&'static str],
    /// Largest difference of a number over the largest of its column; zero asks for the same bytes.
    within: f64,
}

/// A march of each model, then what is solved.
const SCENES: [Shared; 7] = [
    Shared { scene: "ring", set: &["geometry.plate.particles=[13,3]"], within: 0.0 },
    Shared { scene: "dam-break", set: &["analysis.explicit.transient.duration=0.03"], within: 0.0 },
    Shared { scene: "gate", set: &["analysis.explicit.transient.duration=0.004"], within: 0.0 },
    Shared { scene: "crack-branching", set: &["analysis.explicit.transient.duration=1e-6"], within: 0.0 },
    Shared { scene: "thick-ring-solid", set: &[], within: SOLVED },
    Shared { scene: "twisted-strip", set: &[], within: SOLVED },
    Shared { scene: "plate-buckling", set: &[], within: SOLVED },
];

/// What building across and emulating take.
pub struct Tools {
    emulator: &'static str,
}

impl Tools {
    /// Finds them.
    ///
    /// # Errors
    /// What is missing, and how to get it.
    pub fn find() -> Result<Self, String> {
        let install = "apt install gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user-static";
        if !cargo::has_program(LINKER) {
            return Err(format!("no {LINKER}: {install}"));
        }
        let emulator = EMULATORS.into_iter().find(|name| cargo::has_program(name));
        let emulator = emulator.ok_or_else(|| format!("no {}: {install}", EMULATORS.join(" nor ")))?;
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let library = Command::new(rustc).args(["--print", "target-libdir", "--target", TARGET]).output();
        let folder = library.map(|found| String::from_utf8_lossy(&found.stdout).trim().to_owned());
        if !folder.is_ok_and(|folder| !folder.is_empty() && Path::new(&folder).is_dir()) {
            return Err(format!("no standard library for {TARGET}: rustup target add {TARGET}"));
        }
        Ok(Self { emulator })
    }

    /// Runs the tests of the base crates, then scenes on both processors.
    ///
    /// # Errors
    /// A build or a test that fails; a scene whose results differ.
    pub fn check(&self) -> Result<(), String> {
        let mut tests = self.across("test");
        tests.extend(TESTED.iter().flat_map(|name| ["--package".to_owned(), (*name).to_owned()]));
        build(&tests)?;
        let program = cargo::words(&["--package", "coque", "--bin", "coque"]);
        build(&[cargo::words(&["build"]), program.clone()].concat())?;
        build(&[self.across("build"), program].concat())?;
        let target = cargo::root().join("target");
        let (here, there) = (target.join("debug/coque"), target.join(TARGET).join("debug/coque"));
        let mut lost = Vec::new();
        for shared in &SCENES {
            let found = self.compared(shared, &here, &there)?;
            let verdict = if found <= shared.within { "agrees" } else { "DIFFERS" };
            println!(
                "{:<20} {verdict}: {found:.1e} of the largest, at most {:.0e}",
                shared.scene, shared.within
            );
            if found > shared.within {
                lost.push(shared.scene);
            }
        }
        if lost.is_empty() { Ok(()) } else { Err(format!("on {TARGET} results differ: {}", lost.join(", "))) }
    }

    /// A command of cargo for the other processor.
    fn across(&self, command: &str) -> Vec<String> {
        let key =
            |name: &str, value: &str| ["--config".to_owned(), format!("target.{TARGET}.{name}={value}")];
        let mut words = cargo::words(&[command, "--target", TARGET]);
        words.extend(key("linker", &format!("'{LINKER}'")));
        words.extend(key("runner", &format!("['{}', '-L', '{LIBRARIES}']", self.emulator)));
        words
    }

    /// Runs a scene on both; the largest difference of the curves.
    fn compared(&self, shared: &Shared, here: &Path, there: &Path) -> Result<f64, String> {
        let folder = cargo::root().join("target/aarch64").join(shared.scene);
        let own = curve(&mut Command::new(here), shared, &folder.join("here"))?;
        let mut emulated = Command::new(self.emulator);
        emulated.arg("-L").arg(LIBRARIES).arg(there);
        Ok(difference(&own, &curve(&mut emulated, shared, &folder.join("there"))?))
    }
}

fn build(words: &[String]) -> Result<(), String> {
    if cargo::succeeds(words)? { Ok(()) } else { Err(format!("{} failed", cargo::spelled(words))) }
}

/// The text of the curve that a scene gives.
fn curve(program: &mut Command, shared: &Shared, folder: &Path) -> Result<String, String> {
    let scene: PathBuf = cargo::root().join("scenes").join(format!("{}.toml", shared.scene));
    program.arg("run").arg(scene).arg("--out").arg(folder);
    for set in shared.set {
        program.arg("--set").arg(set);
    }
    let output =
        program.stdin(Stdio::null()).output().map_err(|error| format!("{}: {error}", shared.scene))?;
    if !output.status.success() {
        return Err(format!("{}: {}", shared.scene, String::from_utf8_lossy(&output.stderr)));
    }
    let path = folder.join("curve.csv");
    fs::read_to_string(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}

/// Largest difference of two tables, each number over the largest of its column; zero for the same text, infinite for
/// tables of other shapes or words.
fn difference(one: &str, other: &str) -> f64 {
    if one == other {
        return 0.0;
    }
    let table = |text: &str| -> Vec<Vec<String>> {
        text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
    };
    let (one, other) = (table(one), table(other));
    let same_shape = one.len() == other.len() && one.iter().zip(&other).all(|(a, b)| a.len() == b.len());
    if !same_shape || one.first() != other.first() {
        return f64::INFINITY;
    }
    let number = |text: &String| text.parse::<f64>().ok().filter(|number| number.is_finite());
    let mut most = 0.0_f64;
    for column in 0..one.first().map_or(0, Vec::len) {
        let largest =
            one.iter().skip(1).filter_map(|row| number(&row[column])).fold(0.0, |a: f64, b| a.max(b.abs()));
        for (a, b) in
            one.iter().zip(&other).skip(1).map(|(a, b)| (&a[column], &b[column])).filter(|(a, b)| a != b)
        {
            let (Some(a), Some(b)) = (number(a), number(b)) else { return f64::INFINITY };
            // Different digits of the same number count too: what asks for the same bytes asks for the same text.
            most = most.max(((a - b).abs() / largest.max(RESIDUAL)).max(f64::MIN_POSITIVE));
        }
    }
    most.max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_differ_by_their_largest_difference() {
        let table = "time [s],w [m]\n0.0,0.0\n1.0,4.0\n";
        assert_eq!(difference(table, table), 0.0);
        assert_eq!(difference(table, "time [s],w [m]\n0.0,0.0\n1.0,3.0\n"), 0.25);
        assert!(difference(table, "time [s],w [m]\n0,0.0\n1.0,4.0\n") > 0.0);
        for other in [
            "time [s],u [m]\n0.0,0.0\n1.0,4.0\n",
            "time [s],w [m]\n0.0,0.0\n",
            "time [s],w [m]\n0.0,0.0\n1.0,\n",
        ] {
            assert_eq!(difference(table, other), f64::INFINITY);
        }
    }

    #[test]
    fn every_shared_scene_is_there() {
        for shared in &SCENES {
            assert!(
                cargo::root().join("scenes").join(format!("{}.toml", shared.scene)).is_file(),
                "{}",
                shared.scene
            );
        }
    }
}
