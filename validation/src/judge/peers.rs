//! Answers of other programs to a case, with what they cost there in units of a run of ours on the same machine.

/// What other programs found, and the run of ours that their costs are counted in.
#[derive(Clone, Debug)]
pub struct Peers {
    /// Method of the run whose time is one.
    pub method: &'static str,
    /// Its lattice.
    pub grid: &'static str,
    /// One of each program and mesh.
    pub answers: Vec<Peer>,
}

/// An answer of another program.
#[derive(Clone, Debug, PartialEq)]
pub struct Peer {
    /// Program and element.
    pub method: String,
    /// How far it is off, in the unit of the case's headline.
    pub error: f64,
    /// Its time over that of our run, both taken in turn on one thread of one machine \[–\].
    pub cost: f64,
}
