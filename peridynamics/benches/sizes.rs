//! What a block of nodes costs to build, to hold and to march as it grows: peak memory of the set-up and memory held, both
//! beyond that of the bare program, set-up over a step, and the time of a step a bond.
//!
//! Each case is a process of its own, so that its peak is its own; all run once a round, in turn, and the least times of the rounds
//! are printed. Times are those of the processor where the system tells them. `cargo bench -p peridynamics --bench sizes -- ROUNDS`.

mod lattices;

use std::process::Command;
use std::time::Instant;

use explicit_dynamics::Clock;
use lattices::{SPACING, moving, name, parts};
use peridynamics::{Correction, Criterion, Fracture, Law};

const SIDES: [usize; 3] = [22, 36, 46];
const LAWS: [Law; 2] = [Law::BondBased, Law::StateBased];
/// Directed bonds that each measurement of a step works through, at least.
const WORK: usize = 60_000_000;
const BODIES: [Body; 5] = [
    Body { correction: Correction::None, off: 0.0, breaks: None },
    Body { correction: Correction::Even, off: 0.0, breaks: None },
    Body { correction: Correction::None, off: 1e-3, breaks: None },
    Body { correction: Correction::None, off: 0.0, breaks: Some(Criterion::EnergyByStretch(1e9)) },
    Body { correction: Correction::None, off: 0.0, breaks: Some(Criterion::EnergyByWork(1e9)) },
];

/// Weights, how far nodes are off their places in spacings, and what breaks bonds, far beyond what they come to.
#[derive(Debug)]
struct Body {
    correction: Correction,
    off: f64,
    breaks: Option<Criterion>,
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, child, side, law, body] = &arguments[..]
        && child == "--child"
    {
        case(number(side), LAWS[number(law)], &BODIES[number(body)]);
        return;
    }
    let rounds = arguments.iter().find_map(|word| word.parse().ok()).unwrap_or(3);
    for (body, of) in BODIES.iter().enumerate() {
        println!("{of:?}");
        println!(
            "law  side  bonds a node  peak  held [bytes a node]  set-up [s]  over a step  a step [ns a bond]"
        );
        let cases = || (0..LAWS.len()).flat_map(|law| SIDES.map(|side| (law, side)));
        let mut least = vec![[f64::INFINITY; 5]; cases().count()];
        for _ in 0..rounds {
            for ((law, side), least) in cases().zip(&mut least) {
                let figures = run([side, law, body]);
                least.iter_mut().zip(figures).for_each(|(least, figure)| *least = least.min(figure));
            }
        }
        for ((law, side), [bonds, peak, held, set_up, step]) in cases().zip(least) {
            let (nodes, law) = (side.pow(3) as f64, name(LAWS[law]));
            println!(
                "{law}  {side}³  {:.1}  {:.0}  {:.0}  {set_up:.3}  {:.1}  {:.2}",
                bonds / nodes,
                peak / nodes,
                held / nodes,
                set_up / step,
                1e9 * step / bonds,
            );
        }
    }
}

fn number(text: &str) -> usize {
    text.parse().expect("a number")
}

/// What a case printed in a process of its own.
fn run(case: [usize; 3]) -> [f64; 5] {
    let program = std::env::current_exe().expect("a program");
    let words = case.map(|number| number.to_string());
    let output = Command::new(program).arg("--child").args(words).output().expect("a process");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let mut numbers = text.split_whitespace().map(|word| word.parse().expect("a number"));
    std::array::from_fn(|_| numbers.next().expect("five numbers"))
}

/// Prints bonds, peak and held memory [bytes], and the times of the set-up and of a step [s].
fn case(side: usize, law: Law, body: &Body) {
    let bare = memory("VmRSS:");
    let mut parts = parts([side; 3], (law, body.correction, None), 1);
    for (node, x) in parts.block.positions.iter_mut().enumerate() {
        x.iter_mut().enumerate().for_each(|(axis, x)| {
            // Odd places that are the same on every machine.
            let odd = (3 * node + axis + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            *x += body.off * SPACING * ((odd ^ (odd >> 29)) % 1000) as f64 / 500.0;
        });
    }
    parts.fracture = body.breaks.map(|criterion| Fracture { criterion, unbreakable: Vec::new() });
    let start = seconds();
    let mut solid = moving(parts);
    let set_up = seconds() - start;
    let (peak, held) = (memory("VmHWM:") - bare, memory("VmRSS:") - bare);
    let (bonds, steps) = (solid.bonds(), WORK.div_ceil(solid.bonds()));
    let mut clock = Clock::start(&mut solid, 1.0, 0.2, 0.0).expect("a stable step");
    let mut step = f64::INFINITY;
    for _ in 0..4 {
        let start = seconds();
        for _ in 0..steps {
            clock.step(&mut solid, f64::INFINITY, |_| 1.0).expect("a sound step");
        }
        step = step.min((seconds() - start) / steps as f64);
    }
    println!("{bonds} {peak} {held} {set_up} {step}");
}

/// A line of what the system tells of this process [bytes]; nothing where it does not.
fn memory(line: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let kilobytes = status
        .lines()
        .find_map(|text| text.strip_prefix(line)?.split_whitespace().next()?.parse::<f64>().ok());
    1024.0 * kilobytes.unwrap_or(f64::NAN)
}

/// Time of the processor on this thread, where the system tells it; else that of the wall [s].
fn seconds() -> f64 {
    let runs = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = runs.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    static START: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    nanoseconds.map_or_else(|| START.get_or_init(Instant::now).elapsed().as_secs_f64(), |time| 1e-9 * time)
}
