//! Instructions a bond and step, counted by valgrind: repeatable to a per mille whatever else the machine does.
//!
//! The program runs itself under `valgrind --tool=callgrind` twice, for some steps and for more, and prints the
//! difference; set-up cancels. Without valgrind it says so and ends.

mod lattices;

use std::process::Command;

use explicit_dynamics::Clock;
use lattices::{body, name, yielding};
use peridynamics::{Correction, Law, Plastic};

const STEPS: [u64; 2] = [10, 60];
const CUBE: [usize; 3] = [10, 10, 10];
const CASES: [([usize; 3], Law, Yields); 7] = [
    ([30, 30, 1], Law::BondBased, Yields::No),
    ([30, 30, 1], Law::StateBased, Yields::No),
    (CUBE, Law::BondBased, Yields::No),
    (CUBE, Law::StateBased, Yields::No),
    (CUBE, Law::StateBased, Yields::At(f64::INFINITY)),
    (CUBE, Law::StateBased, Yields::At(1e15)),
    (CUBE, Law::StateBased, Yields::At(1e-6)),
];

/// Whether bonds may yield, with even weights: at infinity the elastic law, then far from yielding, and all of them.
#[derive(Clone, Copy, Debug)]
enum Yields {
    No,
    At(f64),
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, child, which, steps] = &arguments[..]
        && child == "--child"
    {
        let case = CASES[which.parse::<usize>().expect("a number")];
        march(case, steps.parse().expect("a number"));
        return;
    }
    for (which, (counts, law, yields)) in CASES.into_iter().enumerate() {
        let [Some(few), Some(many)] = STEPS.map(|steps| count(which, steps)) else {
            println!("instruction counts skipped: valgrind is not here, or it did not report a count");
            return;
        };
        let bonds = body(counts, law, 1).bonds() as u64;
        let each = (many - few) as f64 / ((STEPS[1] - STEPS[0]) * bonds) as f64;
        println!("{} {counts:?}, yields {yields:?}: {each:.1} instructions a bond and step", name(law));
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

fn march((counts, law, yields): ([usize; 3], Law, Yields), steps: u64) {
    let mut solid = match yields {
        Yields::No => body(counts, law, 1),
        Yields::At(limit) => {
            let plastic = limit.is_finite().then_some(Plastic { yield_stress: limit, hardening: 0.0 });
            yielding(counts, (law, Correction::Even, plastic), 1)
        }
    };
    let mut clock = Clock::start(&mut solid, 1.0, 0.2, 0.0).expect("a stable step");
    for _ in 0..steps {
        clock.step(&mut solid, f64::INFINITY, |_| 1.0).expect("a sound step");
    }
}
