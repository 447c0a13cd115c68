//! What acts from outside on the particles of one of several who march a shell.

use std::ops::Range;

use crate::conditions::body::Body;
use crate::conditions::loads::{AddLoad, AppliedLoad};
use crate::conditions::springs::Springs;
use crate::packs::Row;
use crate::reference::Reference;

/// Loads and springs on a range of particles. On these they exert what those of the whole do, to the bit.
pub(crate) struct OnShare {
    own: Range<usize>,
    loads: Vec<AddLoad>,
    springs: Springs,
    /// Particles of others whose rows may be written beside.
    ghosts: Vec<u32>,
}

impl OnShare {
    /// Those on a range, with the particles that they read beside; nothing if one process alone has to march a load.
    pub fn new(
        loads: &[AppliedLoad],
        springs: &Springs,
        own: Range<usize>,
        reference: &Reference,
    ) -> Option<(Self, Vec<u32>)> {
        let springs = springs.on_share(&own);
        let mut reads: Vec<u32> = springs.ends().collect();
        let mut adds = Vec::new();
        for applied in loads {
            let load = applied.load.on_share(&own, reference)?;
            reads.extend(load.reads);
            adds.push(load.add);
        }
        Some((Self { own, loads: adds, springs, ghosts: Vec::new() }, reads))
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

    /// Adds a load by its number, times a factor.
    pub fn add(&self, load: usize, scale: f64, body: &Body<'_>, rows: &mut [Row]) {
        self.loads[load](scale, body, rows);
    }
}
