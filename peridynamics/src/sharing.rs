//! A solid that several march together.

use std::ops::Range;

use peers::Peers;

use crate::Solid;
use crate::error::SolidError;
use crate::share::Share;

impl Solid {
    /// Marches it with others, each of whom has built the same solid: this one moves its share of the nodes. All that a march
    /// returns is that of the whole, with the bits of one who marches it alone; what is read of nodes is right after
    /// [`Solid::bring`]. All of them call it once, when all that loads the solid is there, and from then on all that evaluates it, marches
    /// it or sums over it, in the same order. Its statics are not shared.
    ///
    /// # Errors
    /// [`SolidError::NotShared`], and the solid stays as it was: plates of two sheets, solids in a fluid, pressures that follow, forces by a function or from other bodies.
    pub fn share(&mut self, peers: Box<dyn Peers>) -> Result<(), SolidError> {
        let refusals = [
            (self.wetted.is_some(), "a solid in a fluid"),
            (!self.following.is_empty(), "a solid under a pressure that follows"),
            (self.push.is_some(), "a solid on which a function exerts forces"),
            (!self.exerted.is_empty(), "a solid on which other bodies exert forces"),
        ];
        if let Some((_, what)) = refusals.iter().find(|(refused, _)| *refused) {
            return Err(SolidError::NotShared(what));
        }
        let reach = self.mechanics.reach().map_err(SolidError::NotShared)?;
        let share = Share::new(peers, self.block.len(), self.share.threads(), &reach);
        drop(reach);
        let own = share.own(self.block.len());
        for load in &mut self.loads {
            load.forces.retain(|(node, _)| own.contains(&(*node as usize)));
        }
        self.share = share;
        Ok(())
    }

    /// Brings motion, forces, broken bonds and what flowed, of all nodes, to everyone who marches it. All of them call it.
    pub fn bring(&mut self) {
        let Self { rows, rates, internal, external, mechanics, share, .. } = self;
        if !share.is_shared() {
            return;
        }
        for rows in [rows, rates, internal] {
            share.bring(rows.as_flattened_mut(), 4);
        }
        let mut forces: Vec<[f64; 3]> = external.iter().map(|&force| force.into()).collect();
        if !forces.is_empty() {
            share.bring(forces.as_flattened_mut(), 3);
        }
        external.iter_mut().zip(forces).for_each(|(force, brought)| *force = brought.into());
        mechanics.bring(share);
    }

    /// The nodes that this one moves: all, unless others march it too.
    pub fn own_nodes(&self) -> Range<usize> {
        self.share.own(self.block.len())
    }
}
