//! Bonds that break: which are whole, what the broken ones held, and what is kept of them.
//!
//! A bond breaks at both ends in one step: its extension has the same bits from both. Broken, it has neither stiffness nor a
//! share in a dilatation; weights stay those of the reference, so that the bonds left do not stiffen.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::families::Families;
use super::forces::{Scratch, Watch};
use super::images::Images;
use super::intact::{Bond, Whole, clear, is_set};
use super::limits::Limit;
use super::network::{LANES, Network, Row};
use super::repulsion::Repulsion;
use super::work::Works;
use crate::cracks::Cut;
use crate::error::SolidError;
use crate::formulation::Volumes;
use crate::share::Share;
use peers::Exact;
use sph_core::Vec3;

/// The bonds of a network that are whole, and what breaks them.
#[derive(Clone, Debug)]
pub(crate) struct Breaking {
    pub bonds: Whole,
    /// Bits of whole bonds that may break, and the stretches that break them; none where work does.
    pub watch: Option<Watch>,
    /// The work on bonds, where it breaks them.
    pub works: Option<Works>,
    /// Energy that the broken bonds of each node held, half of each bond's \[F L\].
    energies: Vec<f64>,
    volumes: Vec<f64>,
    horizon: f64,
    reach: f64,
}

impl Breaking {
    /// All bonds whole, without a limit.
    pub fn new(network: &Network, families: &Families) -> Self {
        Self {
            bonds: Whole::new(network, families),
            watch: None,
            works: None,
            energies: vec![0.0; network.len()],
            volumes: families.volumes.clone(),
            horizon: families.horizon,
            reach: families.reach,
        }
    }

    /// Breaks the bonds that a crack, or its mirror image, cuts, whatever they hold; returns how many directed ones.
    pub fn cut(&mut self, network: &mut Network, positions: &[Vec3], cut: &Cut) -> usize {
        let mut crossed = Vec::new();
        for node in 0..network.len() {
            for (lane, bond) in network.bonds_of(node).filter(|(lane, _)| self.bonds.is_bond(*lane)) {
                let other = bond.other;
                // From the same end, whichever end asks.
                let cuts = |a: usize, b: usize| cut.cuts(&positions[a.min(b)], &positions[a.max(b)]);
                let mirrored =
                    |images: &Arc<Images>| cuts(images.source(other), images.seen_back(node, other));
                if cuts(node, other) || network.images.as_ref().is_some_and(mirrored) {
                    crossed.push(lane);
                }
            }
        }
        crossed.iter().for_each(|&lane| self.sever(network, lane));
        self.fit_flow(network);
        crossed.len()
    }

    /// Sets the limit of all whole bonds but those with an end in `unbreakable`.
    ///
    /// # Errors
    /// [`SolidError::NoSuchNode`].
    pub fn limit(&mut self, network: &Network, limit: Limit, unbreakable: &[u32]) -> Result<(), SolidError> {
        let mut safe = vec![false; network.len()];
        for &node in unbreakable {
            let what = "the unbreakable part";
            let missing = SolidError::NoSuchNode { what, node, count: network.len() };
            *safe.get_mut(node as usize).ok_or(missing)? = true;
        }
        let mut lanes = self.bonds.whole.clone();
        for node in 0..network.len() {
            for (lane, bond) in network.bonds_of(node) {
                if safe[node] || safe[network.source(bond.other)] {
                    clear(&mut lanes, lane);
                }
            }
        }
        match limit {
            Limit::Stretch { tension, compression } => {
                self.watch = Some(Watch { lanes, tension, compression });
            }
            Limit::Work(share) => {
                let limits = |bond: &Bond| 0.5 * share * bond.stiffness * bond.length * bond.length;
                self.works = Some(Works::new(network, lanes, &limits));
            }
        }
        Ok(())
    }

    /// Whether bonds may break.
    pub fn is_watched(&self) -> bool {
        self.watch.is_some() || self.works.is_some()
    }

    /// Lanes of the bonds of own nodes beyond their limit in the last evaluation that held them against it, ascending.
    pub fn noted<'a>(&'a self, scratch: &'a Scratch, share: &Share) -> impl Iterator<Item = usize> + 'a {
        let own = share.chunks_of(self.energies.len());
        let by_work = self.works.iter().flat_map({
            let own = own.clone();
            move |works| works.beyond(own.clone())
        });
        let by_stretch = self.watch.iter().flat_map(move |_| scratch.beyond(own.clone()));
        by_work.chain(by_stretch).map(|lane| lane as usize).filter(|&lane| self.bonds.is_whole(lane))
    }

    /// Breaks the bonds noted; returns the energy that the body loses at these positions, those of ghosts among them \[F L\].
    ///
    /// Of a node it is `Σ ¼ c e² + ½(λ − μ)V [θ² − (θ − Σ D e)²]`, the sums over its broken bonds, less the energy with
    /// which `contact` takes over; where bonds yield, the first e is the elastic part of the extension.
    pub fn break_noted(
        &mut self,
        network: &mut Network,
        scratch: &Scratch,
        rows: &[Row],
        contact: Option<&Repulsion>,
        share: &Share,
    ) -> f64 {
        let lanes = self.noted(scratch, share).collect();
        self.break_lanes(network, (lanes, 1.0), rows, contact, share)
    }

    /// Greatest of [`Breaking::utilisations`].
    pub fn utilisation(&self, network: &Network, rows: &[Row]) -> f64 {
        let mut most = 0.0_f64;
        self.utilisations(network, rows, |_, utilisation| most = most.max(utilisation));
        most
    }

    /// Breaks the bonds utilised this far or further; counts a share of the energy that the body loses at these positions, whose
    /// last places hold the dilatations, and returns it \[F L\].
    pub fn break_from(
        &mut self,
        network: &mut Network,
        (least, counted): (f64, f64),
        rows: &[Row],
        contact: Option<&Repulsion>,
        share: &Share,
    ) -> f64 {
        let mut lanes = Vec::new();
        self.utilisations(network, rows, |lane, utilisation| {
            if utilisation >= least {
                lanes.push(lane);
            }
        });
        self.break_lanes(network, (lanes, counted), rows, contact, share)
    }

    /// How far whole bonds that may break are taken, one at the limit: their stretch over its limit, or the root of their work
    /// over its limit, which grows with the stretch. The same bits from both ends; lanes ascend.
    fn utilisations(&self, network: &Network, rows: &[Row], mut visit: impl FnMut(usize, f64)) {
        let rows = &*network.extended(rows);
        for node in 0..network.len() {
            for (lane, bond) in network.bonds_of(node) {
                if let Some(watch) = self.watch.as_ref().filter(|watch| is_set(&watch.lanes, lane)) {
                    let stretch = bond.extension(node, rows) / bond.length;
                    visit(lane, (stretch / watch.tension).max(stretch / watch.compression));
                }
                if let Some(works) = self.works.as_ref().filter(|works| is_set(&works.lanes, lane)) {
                    visit(lane, works.utilisation(network, node, lane, rows));
                }
            }
        }
    }

    fn break_lanes(
        &mut self,
        network: &mut Network,
        (lanes, counted): (Vec<usize>, f64),
        rows: &[Row],
        contact: Option<&Repulsion>,
        share: &Share,
    ) -> f64 {
        let rows = &*network.extended(rows);
        // In mirrors, and where bonds yield, the nodes of others have to know of a bond that breaks here.
        let known = network.images.is_some() || network.flow.is_some();
        let lanes = if known { share.all(lanes) } else { lanes };
        let lanes = self.with_images(network, lanes);
        let own = share.own(network.len());
        let mut next = lanes.as_slice();
        let (mut lost, mut touched) = (Exact::new(), Vec::new());
        while let Some(&first) = next.first() {
            let node = network.node_of(first);
            let end = next.partition_point(|&lane| lane < network.lanes_of(node).end);
            let (broken, rest) = next.split_at(end);
            if own.contains(&node) {
                let held = counted * Self::held(network, (node, broken), rows, contact);
                self.energies[node] += held;
                lost.add(held);
            }
            broken.iter().for_each(|&lane| self.sever(network, lane));
            touched.push(node);
            next = rest;
        }
        network.fit_flow(touched);
        share.total(lost)
    }

    /// What bonds of a node hold that break together.
    fn held(
        network: &Network,
        (node, lanes): (usize, &[usize]),
        rows: &[Row],
        contact: Option<&Repulsion>,
    ) -> f64 {
        let (mut held, mut share) = (0.0, 0.0);
        for &lane in lanes {
            let bond = network.bond(node, lane);
            let e = bond.extension(node, rows);
            let [elastic, _] = network.elastic(node, &bond, e);
            held += 0.25 * bond.stiffness * elastic * elastic;
            held -=
                0.5 * contact.map_or(0.0, |c| c.of_broken([node, bond.other], bond.length, bond.length + e));
            share += bond.shares[0] * e;
        }
        if let Some(factors) = &network.dilatation {
            let theta = network.dilatation_of(node, rows);
            held += factors[node] * share * (theta - 0.5 * share);
        }
        held
    }

    /// Lanes with all others of the same bonds in mirrors: images differ by rounding, and break in one step.
    fn with_images(&self, network: &Network, lanes: Vec<usize>) -> Vec<usize> {
        let Some(images) = &network.images else { return lanes };
        let mut all = BTreeSet::new();
        let mut waiting = lanes;
        while let Some(lane) = waiting.pop() {
            if !self.bonds.is_whole(lane) || !all.insert(lane) {
                continue;
            }
            let node = network.node_of(lane);
            let other = network.bond(node, lane).other;
            let find = |node: usize, end: usize| {
                network.bonds_of(node).find(|(_, bond)| bond.other == end).map(|(lane, _)| lane)
            };
            waiting.extend(find(images.source(other), images.seen_back(node, other)));
            waiting.extend(images.beside(node, other).filter_map(|end| find(node, end)));
        }
        all.into_iter().collect()
    }

    fn sever(&mut self, network: &mut Network, lane: usize) {
        network.sever(lane);
        clear(&mut self.bonds.whole, lane);
        if let Some(watch) = &mut self.watch {
            clear(&mut watch.lanes, lane);
        }
        if let Some(works) = &mut self.works {
            clear(&mut works.lanes, lane);
        }
    }

    /// Fits what yields to the bonds left of the nodes that lost any.
    fn fit_flow(&self, network: &mut Network) {
        if network.flow.is_some() {
            let packs = |node: usize| network.packs_of(node);
            let lost = |&node: &usize| self.bonds.broken(packs(node)).next().is_some();
            let nodes: Vec<usize> = (0..network.len()).filter(lost).collect();
            network.fit_flow(nodes);
        }
    }

    /// The part of a volume at this distance that lies inside the horizon.
    fn share(&self, length: f64) -> f64 {
        let rule = if self.reach > self.horizon { Volumes::Partial } else { Volumes::Whole };
        match rule {
            Volumes::Whole => 1.0,
            Volumes::Partial => ((self.reach - length) / (2.0 * (self.reach - self.horizon))).clamp(0.0, 1.0),
        }
    }

    /// `1 − Σ V̄ of whole bonds / Σ V̄ of all` of a node: zero whole, one free.
    pub fn damage(&self, network: &Network, node: usize) -> f64 {
        if self.bonds.broken(network.packs_of(node)).next().is_none() {
            return 0.0;
        }
        let (mut whole, mut all) = (0.0, 0.0);
        for (lane, bond) in network.bonds_of(node).filter(|(lane, _)| self.bonds.is_bond(*lane)) {
            let volume = self.share(bond.length) * self.volumes[bond.other];
            all += volume;
            if self.bonds.is_whole(lane) {
                whole += volume;
            }
        }
        1.0 - whole / all
    }

    /// Energy that the broken bonds of a node held \[F L\].
    pub fn energy(&self, node: usize) -> f64 {
        self.energies[node]
    }

    /// All that changes: the broken bonds, the energies they held, the work done on bonds.
    pub fn state(&self) -> [Vec<f64>; 3] {
        let works = self.works.as_ref().map_or_else(Vec::new, Works::state);
        [
            self.bonds.broken(0..self.bonds.packs()).map(|lane| lane as f64).collect(),
            self.energies.clone(),
            works,
        ]
    }

    /// Takes up a state of the same body; false, and nothing changed, for one of another body, or one in which bonds are
    /// whole that are broken here.
    pub fn take_up(&mut self, network: &mut Network, [broken, energies, works]: [&[f64]; 3]) -> bool {
        let count = LANES * self.bonds.packs();
        let known = |&lane: &f64| {
            lane >= 0.0 && lane < count as f64 && lane.fract() == 0.0 && self.bonds.is_bond(lane as usize)
        };
        let ascending = broken.is_sorted_by(|a, b| a < b);
        let kept = self
            .bonds
            .broken(0..self.bonds.packs())
            .all(|lane| broken.binary_search_by(|b| b.total_cmp(&(lane as f64))).is_ok());
        let fits = self.works.as_ref().map_or(works.is_empty(), |own| own.fits(works));
        if !(ascending && broken.iter().all(known) && kept && fits && energies.len() == self.energies.len()) {
            return false;
        }
        broken.iter().for_each(|&lane| self.sever(network, lane as usize));
        self.fit_flow(network);
        self.energies.copy_from_slice(energies);
        if let Some(own) = &mut self.works {
            own.take_up(works);
        }
        true
    }

    /// Brings the broken bonds of all nodes to all, with the energies that they held and the work on bonds.
    pub fn bring(&mut self, network: &mut Network, share: &Share) {
        let own = share.own(network.len());
        let packs = network.starts[own.start] as usize..network.starts[own.end] as usize;
        let broken = share.all(self.bonds.broken(packs).collect());
        broken.into_iter().for_each(|lane| self.sever(network, lane));
        share.bring(&mut self.energies, 1);
        if let Some(works) = &mut self.works {
            works.bring(network, share);
        }
    }

    /// Memory beside the bonds \[bytes\].
    pub fn bytes(&self) -> usize {
        let watched = self.watch.as_ref().map_or(0, |watch| watch.lanes.len());
        2 * self.bonds.packs()
            + watched
            + 16 * self.energies.len()
            + self.works.as_ref().map_or(0, Works::bytes)
    }
}
