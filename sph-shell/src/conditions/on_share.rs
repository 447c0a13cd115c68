//! What acts from outside on the particles of one of several who march a shell.

use std::ops::Range;

use crate::conditions::body::Body;
use crate::conditions::loads::{AddLoad, AppliedLoad};
use crate::conditions::springs::Springs;
use crate::packs::Row;
use crate::reference::Reference;

/// Loads and springs on a range of particles. On these they exert what those of the whole do, to the bit.
///
/// Where something depends on places of the whole shell, as contact and a volume do, all particles are read and everyone evaluates all of it.
pub(crate) struct OnShare {
    own: Range<usize>,
    /// None of a load that is evaluated as a whole.
    loads: Vec<Option<AddLoad>>,
    springs: Springs,
    /// Particles of others whose rows may be written beside.
    ghosts: Vec<u32>,
}

impl OnShare {
    /// Those on a range, with the particles that they read beside: all of them if the shell `touches` anything, or a load does not say what it
    /// adds to a range.
    pub fn new(
        loads: &[AppliedLoad],
        springs: &Springs,
        touches: bool,
        own: Range<usize>,
        reference: &Reference,
    ) -> (Self, Vec<u32>) {
        let springs = springs.on_share(&own);
        let mut reads: Vec<u32> = springs.ends().collect();
        let mut whole = touches;
        let of = |applied: &AppliedLoad| {
            let load = applied.load.on_share(&own, reference);
            whole |= load.is_none();
            let load = load?;
            reads.extend(load.reads);
            Some(load.add)
        };
        let loads = loads.iter().map(of).collect();
        if whole {
            reads = (0..reference.cloud.len() as u32).collect();
        }
        (Self { own, loads, springs, ghosts: Vec::new() }, reads)
    }

    /// The same, next to particles of others.
    pub fn beside(self, ghosts: Vec<u32>) -> Self {
        Self { ghosts, ..self }
    }

    /// Zeros in all rows that may be written, those of all particles where one marches alone; which of them count.
    pub fn clear(on_share: Option<&Self>, rows: &mut [Row]) -> Range<usize> {
        let Some(Self { own, ghosts, .. }) = on_share else {
            rows.fill([0.0; 6]);
            return 0..rows.len();
        };
        rows[own.clone()].fill([0.0; 6]);
        ghosts.iter().for_each(|&a| rows[a as usize] = [0.0; 6]);
        own.clone()
    }

    /// The springs that count, of all of them.
    pub fn springs<'a>(on_share: Option<&'a Self>, all: &'a Springs) -> &'a Springs {
        on_share.map_or(all, |on_share| &on_share.springs)
    }

    /// Adds a load by its number, times a factor; of what is evaluated as a whole, all of it.
    pub fn add(
        on_share: Option<&Self>,
        (number, applied): (usize, &AppliedLoad),
        scale: f64,
        body: &Body<'_>,
        rows: &mut [Row],
    ) {
        match on_share.and_then(|on_share| on_share.loads[number].as_ref()) {
            Some(add) => add(scale, body, rows),
            None => applied.load.add(scale, body, rows),
        }
    }
}
