//! LAMMPS: a block of pairwise bonds, `pair_style peri/pmb`, in time.

use std::process::Command;

use super::place::{self, Place};
use super::program;
use super::reading::{Found, Reading};
use super::row::{Comparison, Peer, Side};

const LAMMPS: Peer = Peer {
    name: "LAMMPS",
    install: "apt-get install lammps",
    threaded: true,
    find: |_| place::installed("lmp", "-h", "Parallel Simulator - "),
};

/// Steps of LAMMPS for each node of a side: a wave goes there and back in them.
const STEPS: u32 = 4;

/// All comparisons with LAMMPS.
pub fn comparisons() -> Vec<Comparison> {
    vec![
        block("block of pairwise bonds, 22³ nodes", 22),
        block("block of pairwise bonds, 36³ nodes", 36),
        block("block of pairwise bonds, 46³ nodes", 46),
    ]
}

fn block(problem: &'static str, side: u32) -> Comparison {
    Comparison {
        problem,
        peer: LAMMPS,
        unit: "ns a bond and step",
        answers: "way of the end, once a wave has been there and back [m]",
        // Steps of different length, of second order: .016 % of 22³ nodes.
        share: 0.05,
        ours: Side { by: "directed bonds".to_owned(), run: Box::new(move |place, _| ours(place, side)) },
        theirs: Side {
            by: "peri/pmb".to_owned(),
            run: Box::new(move |place, found| theirs(place, found, side)),
        },
    }
}

fn ours(place: &Place, side: u32) -> Result<Reading, String> {
    let words = [side, place.threads].map(|word| word.to_string());
    let ran = program::run(
        Command::new(place.ours("examples/held_block")).args(words),
        &place.at("ours-block")?,
        place.threads,
    )?;
    Reading::of_line(&ran)
}

fn theirs(place: &Place, found: &Found, side: u32) -> Result<Reading, String> {
    let end = (f64::from(side) - 0.5) * 0.01;
    let ranks = place.threads.to_string();
    let mut command = if place.threads == 1 { Command::new(&found.program) } else { Command::new("mpirun") };
    if place.threads > 1 {
        // What Debian builds has no threads for these bonds: processes. As root an MPI library wants to be asked twice.
        command.args(["-np", &ranks]).arg(&found.program);
        command.env("OMPI_ALLOW_RUN_AS_ROOT", "1").env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
    }
    command.args(["-log", "none", "-in"]).arg(place.deck("lammps-block.in"));
    command.args(["-var", "end", &end.to_string(), "-var", "steps", &(STEPS * side).to_string()]);
    let ran = program::run(&mut command, &place.at("lammps-block")?, 1)?;
    let nodes = f64::from(side.pow(3));
    let reading = reading(&ran.output, nodes, f64::from(place.threads))
        .ok_or("its output has no answer that can be read")?;
    Ok(Reading { memory: ran.memory, ..reading })
}

/// What LAMMPS prints of its last run: the row of the last step, the time of its loop, its share of the processor, bonds, memory; the
/// last two of each of so many processes.
fn reading(output: &str, nodes: f64, ranks: f64) -> Option<Reading> {
    let word = |line: &str, place: usize| {
        line.split_whitespace().nth(place).map(|word| word.trim_end_matches('%').to_owned())
    };
    let number = |line: &str, place: usize| word(line, place)?.parse::<f64>().ok();
    let line = |mark: &str| output.lines().rfind(|line| line.contains(mark));
    let bonds = number(line("total # of bonds =")?, 5)?;
    let memory = number(line("Per MPI rank memory allocation")?, 7)?;
    let looped = line("Loop time of")?;
    let share = number(line("% CPU use")?, 0)? / 100.0;
    let last = output.lines().take_while(|line| !line.starts_with("Loop time of")).last()?;
    let cost = 1e9 * number(looped, 3)? / (number(looped, 8)? * bonds);
    Some(Reading {
        answers: vec![number(last, 1)?],
        cost,
        processor: Some(cost * share * ranks),
        memory: None,
        bytes: Some(ranks * memory * 1024.0 * 1024.0 / nodes),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn its_output_is_read() {
        let output = include_str!("../../peers/samples/lammps-block.txt");
        let reading = reading(output, 10_648.0, 1.0).unwrap();
        assert_eq!(reading.answers, [0.002391028904]);
        // 1.86917 s of 60 steps of 1 105 392 bonds, .617 of them on the processor; 34.53 MB.
        assert!((reading.cost - 28.1826).abs() < 1e-4, "{}", reading.cost);
        assert!((reading.processor.unwrap() - 17.3887).abs() < 1e-4);
        assert!((reading.bytes.unwrap() - 3400.4).abs() < 0.1);
        assert!(super::reading("LAMMPS\nERROR: Unrecognized pair style\n", 1.0, 1.0).is_none());
    }
}
