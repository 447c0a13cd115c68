//! Instructions a bond and step, counted by valgrind: repeatable to a per mille whatever else the machine does.
//!
//! The program runs itself under `valgrind --tool=callgrind` twice, for some steps and for more, and prints the
//! difference; set-up cancels. Then what several take together for a body that they share, over what one takes alone.
//! Without valgrind it says so and ends.

mod lattices;

use std::process::Command;

use explicit_dynamics::Clock;
use lattices::{body, name, yielding};
use peridynamics::{Correction, Law, Plastic, Solid};

const STEPS: [u64; 2] = [10, 60];
const CUBE: [usize; 3] = [10, 10, 10];
const LAWS: [Law; 2] = [Law::BondBased, Law::StateBased];
const CASES: [([usize; 3], Law, Yields); 7] = [
    ([30, 30, 1], Law::BondBased, Yields::No),
    ([30, 30, 1], Law::StateBased, Yields::No),
    (CUBE, Law::BondBased, Yields::No),
    (CUBE, Law::StateBased, Yields::No),
    (CUBE, Law::StateBased, Yields::At(f64::INFINITY)),
    (CUBE, Law::StateBased, Yields::At(1e15)),
    (CUBE, Law::StateBased, Yields::At(1e-6)),
];

/// A plane of eight chunks that several share.
const SHARED: [usize; 3] = [60, 60, 1];

/// Whether bonds may yield, with even weights: at infinity the elastic law, then far from yielding, and all of them.
#[derive(Clone, Copy, Debug)]
enum Yields {
    No,
    At(f64),
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, child, case, steps] = &arguments[..]
        && child == "--child"
    {
        let steps = steps.parse().expect("a number");
        match case.split_once('-') {
            Some((law, peers)) => share(LAWS[number(law)], number(peers), steps),
            None => march(CASES[number(case)], steps),
        }
        return;
    }
    for (which, (counts, law, yields)) in CASES.into_iter().enumerate() {
        let Some(instructions) = count_step(&which.to_string()) else {
            println!("instruction counts skipped: valgrind is not here, or it did not report a count");
            return;
        };
        let each = instructions / body(counts, law, 1).bonds() as f64;
        println!("{} {counts:?}, yields {yields:?}: {each:.1} instructions a bond and step", name(law));
    }
    for (which, law) in LAWS.into_iter().enumerate() {
        let all = [1, 2, 4].map(|peers| count_step(&format!("{which}-{peers}")));
        let [Some(one), Some(two), Some(four)] = all else { return };
        let [two, four] = [two, four].map(|several| several / one);
        println!("{} {SHARED:?}: two take {two:.3} of the instructions of one, four {four:.3}", name(law));
    }
}

fn number(text: &str) -> usize {
    text.parse().expect("a number")
}

/// Instructions of a step.
fn count_step(case: &str) -> Option<f64> {
    let [few, many] = STEPS.map(|steps| count(case, steps));
    Some((many? - few?) as f64 / (STEPS[1] - STEPS[0]) as f64)
}

/// Instructions of a whole child run, from callgrind's closing line `Collected : N`.
fn count(case: &str, steps: u64) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(std::env::current_exe().ok()?)
        .args(["--child", case, &steps.to_string()])
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
    steps_of(&mut solid, steps);
}

/// The same of a body that so many share.
fn share(law: Law, peers: usize, steps: u64) {
    let each = |peers| {
        let mut solid = body(SHARED, law, 1);
        solid.share(peers).expect("a body that is shared");
        steps_of(&mut solid, steps);
    };
    peers::together(peers, each).expect("peers that stay");
}

fn steps_of(solid: &mut Solid, steps: u64) {
    let mut clock = Clock::start(solid, 1.0, 0.2, 0.0).expect("a stable step");
    for _ in 0..steps {
        clock.step(solid, f64::INFINITY, |_| 1.0).expect("a sound step");
    }
}
