//! Instructions a bond and step, counted by valgrind: repeatable to a per mille whatever else the machine does.
//!
//! The program runs itself under `valgrind --tool=callgrind` twice, for some steps and for more, and prints the
//! difference; set-up cancels. Without valgrind it says so and ends.

mod lattices;

use std::process::Command;

use explicit_dynamics::Clock;
use lattices::{body, name};
use peridynamics::Law;

const STEPS: [u64; 2] = [10, 60];
const CASES: [([usize; 3], Law); 4] = [
    ([30, 30, 1], Law::BondBased),
    ([30, 30, 1], Law::StateBased),
    ([10, 10, 10], Law::BondBased),
    ([10, 10, 10], Law::StateBased),
];

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, child, which, steps] = &arguments[..]
        && child == "--child"
    {
        let (counts, law) = CASES[which.parse::<usize>().expect("a number")];
        march(counts, law, steps.parse().expect("a number"));
        return;
    }
    for (which, (counts, law)) in CASES.into_iter().enumerate() {
        let [Some(few), Some(many)] = STEPS.map(|steps| count(which, steps)) else {
            println!("instruction counts skipped: valgrind is not here, or it did not report a count");
            return;
        };
        let bonds = body(counts, law, 1).bonds() as u64;
        let each = (many - few) as f64 / ((STEPS[1] - STEPS[0]) * bonds) as f64;
        println!("{} {counts:?}: {each:.1} instructions a bond and step", name(law));
    }
}

/// Instructions of a whole child run, from callgrind's closing line `Collected : N`.
fn count(which: usize, steps: u64) -> Option<u64> {
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

fn march(counts: [usize; 3], law: Law, steps: u64) {
    let mut solid = body(counts, law, 1);
    let mut clock = Clock::start(&mut solid, 1.0, 0.2, 0.0).expect("a stable step");
    for _ in 0..steps {
        clock.step(&mut solid, f64::INFINITY, |_| 1.0).expect("a sound step");
    }
}
