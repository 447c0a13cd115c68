//! OpenSees: ten modes of a plate, shells ShellMITC4.

use std::process::Command;

use super::calculix::our_modes;
use super::place::{Place, python};
use super::program;
use super::reading::{Found, Reading};
use super::row::{Comparison, Peer, Side};

const OPENSEES: Peer = Peer {
    name: "OpenSees",
    install: "python3 -m venv target/peers/opensees && target/peers/opensees/bin/pip install openseespy",
    threaded: false,
    find: |place| python(place, "opensees", "import openseespy.opensees as o; print(o.version())"),
};

/// All comparisons with OpenSees.
pub fn comparisons() -> Vec<Comparison> {
    vec![Comparison {
        problem: "ten modes of a supported plate, 51 nodes a side",
        peer: OPENSEES,
        unit: "s",
        answers: "ω of ten modes, Mindlin 19.732 …",
        // Elements of the first order: .75 % at the tenth mode, on these meshes.
        share: 1.0,
        ours: Side { by: "51² particles".to_owned(), run: Box::new(|place, _| our_modes(place, 51)) },
        theirs: Side { by: "ShellMITC4 50×50, without Python's start".to_owned(), run: Box::new(theirs) },
    }]
}

fn theirs(place: &Place, found: &Found) -> Result<Reading, String> {
    let mut command = Command::new(&found.program);
    command.arg(place.deck("opensees_plate.py")).arg("50");
    Reading::of_line(&program::run(&mut command, &place.at("opensees-plate")?, 1)?)
}
