//! Instructions of a particle-step for every row of "What each option costs", counted by valgrind: the same whatever else
//! the machine does.
//!
//! The program runs itself under `valgrind --tool=callgrind` twice a row, for some steps and for more, and prints the
//! difference; set-up cancels. Without valgrind it says so and ends.

use std::process::Command;

use validation::cases::option_cost::{BARE, Extent, Row, measure_row, table_rows};

/// Few enough particles for valgrind.
const SIDE: usize = 20;
/// Steps of the two runs of a row; between them lies one frame of fields.
const STEPS: [u64; 2] = [20, 220];

fn rows() -> Vec<Row> {
    let rows = table_rows(&Extent { side: SIDE, steps: STEPS[1] - STEPS[0], rounds: 1 });
    // Threads that wait count instructions too, as many as valgrind lets them.
    rows.expect("sound scenes").into_iter().filter(|row| row.threads == 1).collect()
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, child, which, steps] = &arguments[..]
        && child == "--child"
    {
        let row = &rows()[which.parse::<usize>().expect("a number")];
        measure_row(row, SIDE, steps.parse().expect("a number")).expect("a sound scene");
        return;
    }
    let mut bare = None;
    for (which, row) in rows().iter().enumerate() {
        let counts = STEPS.map(|steps| count(which, steps));
        let [Some(few), Some(many)] = counts else {
            println!(
                "instruction counts skipped: valgrind is not here, or stopped the program, or did not report a count"
            );
            return;
        };
        let each = (many - few) as f64 / ((STEPS[1] - STEPS[0]) * (SIDE * SIDE) as u64) as f64;
        if row.name == BARE {
            bare = Some(each);
        }
        let more = bare.map_or_else(String::new, |bare| format!("  {:+.2} %", 100.0 * (each / bare - 1.0)));
        println!("{:<42}{each:>8.1} instructions a particle-step{more}", row.name);
    }
}

/// Instructions of a whole child run, from callgrind's closing line `Collected : N`.
fn count(which: usize, steps: u64) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(std::env::current_exe().ok()?)
        .args(["--child", &which.to_string(), &steps.to_string()])
        .output()
        .ok()
        // A child that valgrind stopped has counted its way to there.
        .filter(|output| output.status.success())?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text.lines().find(|line| line.contains("Collected :"))?;
    line.rsplit(' ').next()?.parse().ok()
}
