//! Instructions a particle and step, counted by valgrind: repeatable to a per mille whatever else the machine does.
//!
//! The program runs itself under `valgrind --tool=callgrind` twice, for some steps and for more, and prints the
//! difference; set-up cancels. Without valgrind it says so and ends.

mod waters;

use std::process::Command;

use fluid_sph::Scheme;
use waters::{Water, steps};

const STEPS: [usize; 2] = [4, 24];
const WATERS: [Water; 3] = [
    Water::new("plane", 2, 60, Scheme::KickDriftKick),
    Water::new("space", 3, 16, Scheme::KickDriftKick),
    Water::new("plane, predicted", 2, 60, Scheme::PredictorCorrector),
];

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, child, which, count] = &arguments[..]
        && child == "--child"
    {
        let (mut fluid, mut clock) = WATERS[which.parse::<usize>().expect("a number")].fluid(1);
        steps(&mut fluid, &mut clock, count.parse().expect("a number"));
        return;
    }
    for (which, water) in WATERS.iter().enumerate() {
        let [Some(few), Some(many)] = STEPS.map(|steps| count(which, steps)) else {
            println!("instruction counts skipped: valgrind is not here, or it did not report a count");
            return;
        };
        let particles = water.side.pow(water.dimensions as u32);
        let each = (many - few) as f64 / ((STEPS[1] - STEPS[0]) * particles) as f64;
        println!("{}: {each:.0} instructions a particle and step", water.name);
    }
}

/// Instructions of a whole child run, from callgrind's closing line `Collected : N`.
fn count(which: usize, steps: usize) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(std::env::current_exe().ok()?)
        .args(["--child", &which.to_string(), &steps.to_string()])
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text.lines().find(|line| line.contains("Collected :"))?;
    line.rsplit(' ').next()?.parse().ok()
}
