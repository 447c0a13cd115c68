//! What those who march a solid exchange of its bonds: in a sweep places, then what was found from them; at a look all that is kept.

use super::flow::Past;
use super::network::{LANES, Network, Row};
use crate::share::Share;

impl Network {
    /// Adds the nodes at the other ends of a node's bonds, or those whose images are there.
    pub fn ends(&self, node: usize, out: &mut Vec<u32>) {
        out.extend(self.neighbours(node));
    }

    /// Numbers of a node that the bonds of others need beside its place: the dilatation, and what flows.
    pub fn found(&self) -> usize {
        match (&self.dilatation, &self.flow) {
            (None, _) => 0,
            (Some(_), None) => 1,
            (Some(_), Some(_)) => 3,
        }
    }

    /// Waits for places of ghosts, and puts images to theirs.
    pub(super) fn take_places(&self, rows: &mut [Row], share: &Share) {
        share.take_places(rows);
        if let Some(images) = &self.images {
            images.place(rows);
        }
    }

    /// Sends what was found of own nodes.
    pub(super) fn send_found(&self, rows: &[Row], share: &Share) {
        let trial = self.flow.as_ref().map(|flow| &flow.trial[..]);
        share.send_found(|node, found| {
            found[0] = rows[node][3];
            if let Some(trial) = trial {
                found[1..].copy_from_slice(&trial[node]);
            }
        });
    }

    /// Waits for what was found of ghosts, and gives images what their nodes have.
    pub(super) fn take_found(&mut self, rows: &mut [Row], share: &Share) {
        let count = self.len();
        let mut trial = self.flow.as_mut().map(|flow| &mut flow.trial[..]);
        share.take_found(|node, found| {
            rows[node][3] = found[0];
            if let Some(trial) = &mut trial {
                trial[node].copy_from_slice(&found[1..]);
            }
        });
        let Some(images) = &self.images else { return };
        images.carry(rows);
        if let Some(trial) = trial {
            let (nodes, behind) = trial.split_at_mut(count);
            behind.iter_mut().enumerate().for_each(|(k, image)| *image = nodes[images.source(count + k)]);
        }
    }

    /// Brings what flowed, and what flows in the state last evaluated, to all.
    pub fn bring_flow(&mut self, share: &Share) {
        let (count, Some(flow)) = (self.len(), self.flow.as_mut()) else { return };
        for packs in [&mut flow.own, &mut flow.twin] {
            share.bring_lists(&self.starts, packs.as_flattened_mut(), LANES);
        }
        let mut past: Vec<[f64; 2]> = flow.past.iter().map(|past| [past.strain, past.work]).collect();
        share.bring(past.as_flattened_mut(), 2);
        flow.past.iter_mut().zip(past).for_each(|(past, [strain, work])| *past = Past { strain, work });
        share.bring(flow.trial[..count].as_flattened_mut(), 2);
        if let Some(images) = &self.images {
            (count..flow.trial.len()).for_each(|image| flow.trial[image] = flow.trial[images.source(image)]);
        }
    }

    /// Brings rows with those of images behind them, as they were last evaluated, to all.
    pub fn bring_evaluated(&self, rows: &mut [Row], share: &Share) {
        if let Some(images) = &self.images {
            share.bring(rows[..self.len()].as_flattened_mut(), 4);
            images.place(rows);
            images.carry(rows);
        }
    }
}
