//! CalculiX: a roof to a given error, ten modes of a plate; shells S8R of eight nodes.

use std::fs;
use std::process::Command;

use super::place::{self, Place};
use super::program;
use super::reading::{Found, Reading};
use super::row::{Comparison, Peer, Side};
use super::shell_mesh;

const CALCULIX: Peer = Peer {
    name: "CalculiX",
    install: "apt-get install calculix-ccx",
    threaded: true,
    find: |_| place::installed("ccx", "-v", "Version "),
};

/// Frequencies found of the plate.
const MODES: usize = 10;

/// A deck, its mesh, and how its answers are read.
struct Deck {
    name: &'static str,
    elements: usize,
    place: fn(f64, f64) -> [f64; 3],
    read: fn(&str) -> Option<Vec<f64>>,
}

/// All comparisons with CalculiX.
pub fn comparisons() -> Vec<Comparison> {
    vec![
        Comparison {
            problem: "Scordelis–Lo roof, a quarter, to .3 %",
            peer: CALCULIX,
            unit: "s",
            answers: "edge deflection, published .3024",
            // Either is within .3 % of the published one.
            share: 0.6,
            ours: Side { by: "27² particles".to_owned(), run: Box::new(|place, _| our_roof(place, 27)) },
            theirs: deck("calculix-roof", 4, roof, deflection),
        },
        modes("ten modes of a supported plate to .4 %", 31, 12, 0.8),
        modes("ten modes of a supported plate, 51 nodes a side", 51, 25, 0.3),
    ]
}

/// Ten modes on so many particles and elements a side, and how far they may be apart \[%\].
fn modes(problem: &'static str, particles: usize, elements: usize, share: f64) -> Comparison {
    Comparison {
        problem,
        peer: CALCULIX,
        unit: "s",
        answers: "ω of ten modes, Mindlin 19.732 …",
        share,
        ours: Side {
            by: format!("{particles}² particles"),
            run: Box::new(move |p, _| our_modes(p, particles)),
        },
        theirs: deck("calculix-plate", elements, |u, v| [u, v, 0.0], frequencies),
    }
}

/// CalculiX on one of its decks: the whole program.
fn deck(
    name: &'static str,
    elements: usize,
    place: fn(f64, f64) -> [f64; 3],
    read: fn(&str) -> Option<Vec<f64>>,
) -> Side {
    let deck = Deck { name, elements, place, read };
    Side {
        by: format!("S8R {elements}×{elements}"),
        run: Box::new(move |place, found| deck.run(place, found)),
    }
}

impl Deck {
    fn run(&self, place: &Place, found: &Found) -> Result<Reading, String> {
        let folder = place.at(self.name)?;
        let said = |error: std::io::Error| format!("cannot write {}: {error}", folder.display());
        let deck = format!("{}.inp", self.name);
        fs::copy(place.deck(&deck), folder.join(&deck)).map_err(said)?;
        fs::write(folder.join("mesh.inp"), shell_mesh::deck("S8R", self.elements, self.place))
            .map_err(said)?;
        let ran = program::run(Command::new(&found.program).arg(self.name), &folder, place.threads)?;
        let printed = place::read(&folder.join(format!("{}.dat", self.name)))?;
        let answers = (self.read)(&printed).ok_or("its .dat has no answer that can be read")?;
        Ok(Reading::of_program(ran, answers))
    }
}

/// A quarter of a roof of radius 25 and 40°, its crown at u = 0, its middle at v = 0.
fn roof(u: f64, v: f64) -> [f64; 3] {
    let angle = 40.0_f64.to_radians() * u;
    [25.0 * libm::sin(angle), 25.0 * v, 25.0 * libm::cos(angle)]
}

/// The way down in the last line of a table of displacements: node, x, y, z.
fn deflection(printed: &str) -> Option<Vec<f64>> {
    let line = printed.lines().rfind(|line| !line.trim().is_empty())?;
    let numbers: Vec<f64> = line.split_whitespace().map(|word| word.parse().ok()).collect::<Option<_>>()?;
    (numbers.len() == 4).then(|| vec![-numbers[3]])
}

/// Circular frequencies: the third of five numbers of a mode (number, ω², ω, f, imaginary part).
fn frequencies(printed: &str) -> Option<Vec<f64>> {
    let numbers =
        |line: &str| line.split_whitespace().map(|word| word.parse::<f64>().ok()).collect::<Option<Vec<_>>>();
    let rows = printed.lines().filter_map(numbers).filter(|row| row.len() == 5);
    let found: Vec<f64> = rows.map(|row| row[2]).take(MODES).collect();
    (found.len() == MODES).then_some(found)
}

fn our_roof(place: &Place, side: usize) -> Result<Reading, String> {
    let scene = place.root.join("scenes/scordelis-lo.toml");
    let particles = format!("geometry.cylinder.particles=[{side},{side}]");
    let run = place.scene(&scene, "ours-roof", &[&particles])?;
    Ok(Reading { answers: run.column("w_edge")?, ..run.reading })
}

/// Edges that stay, and turn about themselves alone.
pub fn our_modes(place: &Place, side: usize) -> Result<Reading, String> {
    let scene = place.root.join("scenes/plate.toml");
    let particles = format!("geometry.plate.particles=[{side},{side}]");
    let modal = format!("analysis={{ modal = {{ modes = {MODES} }} }}");
    let edge = |k: usize, on: &str, turn: &str| {
        format!(
            r#"supports[{k}]={{ on = "{on}", held = {{ displacement = [[0, 0, 1]], director = [{turn}] }} }}"#
        )
    };
    let (along, across) = ("[0, 1, 0]", "[1, 0, 0]");
    let edges = [edge(1, "u0", along), edge(2, "u1", along), edge(3, "v0", across), edge(4, "v1", across)];
    let mut sets = vec![particles.as_str(), &modal, "loads=[]", "curve=[]"];
    sets.extend(edges.iter().map(String::as_str));
    let run = place.scene(&scene, "ours-plate", &sets)?;
    Ok(Reading { answers: run.column("circular_frequency")?, ..run.reading })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn its_displacements_are_read() {
        let printed = include_str!("../../peers/samples/calculix-roof.dat");
        assert_eq!(deflection(printed), Some(vec![0.3032533]));
        assert_eq!(deflection("nothing\n"), None);
    }

    #[test]
    fn its_frequencies_are_read() {
        let printed = include_str!("../../peers/samples/calculix-plate.dat");
        let found = frequencies(printed).unwrap();
        assert_eq!((found[0], found[9]), (19.73323, 167.8457));
        assert_eq!(frequencies("1 2 3 4 5\n"), None);
    }

    #[test]
    fn the_roof_is_a_part_of_a_cylinder() {
        assert_eq!(roof(0.0, 1.0), [0.0, 25.0, 25.0]);
        let [x, _, z] = roof(1.0, 0.0);
        assert!((x - 16.0697).abs() < 1e-4 && (z - 19.1511).abs() < 1e-4);
    }
}
