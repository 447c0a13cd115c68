//! Directed bonds one by one, and which of them are whole: a bit for each lane of each pack.

use nalgebra::Matrix3;
use sph_core::Vec3;

use super::families::Families;
use super::network::{LANES, Network, Row};
use super::patterns::{Family, Number};

/// Which lanes are bonds, and which of those are whole.
#[derive(Clone, Debug)]
pub(crate) struct Whole {
    /// A bit for each lane of each pack that is a whole bond.
    pub whole: Vec<u8>,
    /// The same of all bonds, whole or not; lanes that only fill up a pack are none.
    all: Vec<u8>,
}

impl Whole {
    /// All bonds whole.
    pub fn new(network: &Network, families: &Families) -> Self {
        let mut all = vec![0; network.packs()];
        for node in 0..network.len() {
            for (lane, _) in network.lanes_of(node).zip(families.of(node)) {
                all[lane / LANES] |= 1 << (lane % LANES);
            }
        }
        Self { whole: all.clone(), all }
    }

    /// Number of packs.
    pub fn packs(&self) -> usize {
        self.all.len()
    }

    /// Whether a lane is a bond.
    pub fn is_bond(&self, lane: usize) -> bool {
        is_set(&self.all, lane)
    }

    /// Whether a lane is a whole bond.
    pub fn is_whole(&self, lane: usize) -> bool {
        is_set(&self.whole, lane)
    }

    /// Whether a lane is a broken bond.
    pub fn is_broken(&self, lane: usize) -> bool {
        self.is_bond(lane) && !self.is_whole(lane)
    }

    /// Lanes of broken bonds among these packs, ascending.
    #[inline]
    pub fn broken(&self, packs: std::ops::Range<usize>) -> impl Iterator<Item = usize> {
        let some = packs.filter(|&pack| self.whole[pack] != self.all[pack]);
        some.flat_map(|pack| LANES * pack..LANES * (pack + 1)).filter(|&lane| self.is_broken(lane))
    }
}

/// Whether the bit of a lane is set.
pub(crate) fn is_set(bits: &[u8], lane: usize) -> bool {
    bits[lane / LANES] & (1 << (lane % LANES)) != 0
}

/// Clears the bit of a lane.
pub(crate) fn clear(bits: &mut [u8], lane: usize) {
    bits[lane / LANES] &= !(1 << (lane % LANES));
}

/// One directed bond of a network.
pub(crate) struct Bond {
    /// The node at the other end, or an image.
    pub other: usize,
    pub length: f64,
    pub stiffness: f64,
    /// Dᵢⱼ and Dⱼᵢ \[1/L\]; zero where there is no dilatation.
    pub shares: [f64; 2],
    /// Plastic extensions at its own and at the other node, as they were kept \[L\].
    pub plastic: [f64; 2],
    /// Its round parts there \[L\].
    pub round: [f64; 2],
}

impl Network {
    /// A directed bond of a node by its lane, counted through all packs.
    pub fn bond(&self, node: usize, lane: usize) -> Bond {
        self.bond_in(&self.family(node), self.packs_of(node).start, lane)
    }

    /// All lanes of a node with their bonds.
    pub fn bonds_of(&self, node: usize) -> impl Iterator<Item = (usize, Bond)> {
        let (family, start) = (self.family(node), self.packs_of(node).start);
        self.lanes_of(node).map(move |lane| (lane, self.bond_in(&family, start, lane)))
    }

    /// A bond of a family whose packs start there.
    #[inline]
    fn bond_in(&self, family: &Family<'_>, start: usize, lane: usize) -> Bond {
        let [plastic, round] = self.flow.as_ref().map_or([[0.0; 2]; 2], |flow| flow.of_lane(lane));
        let (pack, lane) = (lane / LANES - start, lane % LANES);
        let value = |number: Number| family.value(number, pack, lane);
        Bond {
            other: family.others(pack)[lane] as usize,
            length: value(Number::Length),
            stiffness: value(Number::Stiffness),
            shares: [value(Number::Own), value(Number::Twin)],
            plastic,
            round,
        }
    }

    /// The node of a lane.
    pub fn node_of(&self, lane: usize) -> usize {
        self.starts.partition_point(|&start| start as usize <= lane / LANES) - 1
    }

    /// Lanes of a node, counted through all packs; some may only fill up.
    pub fn lanes_of(&self, node: usize) -> std::ops::Range<usize> {
        let packs = self.packs_of(node);
        LANES * packs.start..LANES * packs.end
    }
}

impl Bond {
    /// Present extension \[L\].
    pub fn extension(&self, node: usize, rows: &[Row]) -> f64 {
        self.between(node, rows).norm() - self.length
    }

    /// From the node to the other \[L\].
    pub fn between(&self, node: usize, rows: &[Row]) -> Vec3 {
        let (a, b) = (&rows[node], &rows[self.other]);
        Vec3::new(b[0] - a[0], b[1] - a[1], b[2] - a[2])
    }
}

impl Network {
    /// Elastic parts of the extension of a bond of a node, as that node has it and as the other one, in the state last evaluated.
    pub fn elastic(&self, node: usize, bond: &Bond, extension: f64) -> [f64; 2] {
        let Some(flow) = &self.flow else { return [extension; 2] };
        let left = |k: usize, end: usize| {
            let (elastic, [part, expansion]) = (extension - bond.plastic[k], flow.trial[end]);
            elastic - (elastic * part - bond.round[k] * expansion)
        };
        [left(0, node), left(1, bond.other)]
    }

    /// What a bond of a node pulls with \[F\].
    pub fn pull(&self, node: usize, bond: &Bond, extension: f64, rows: &[Row]) -> f64 {
        let ([own, twin], [near, far]) = (bond.shares, self.elastic(node, bond, extension));
        bond.stiffness * (0.5 * (near + far)) + (rows[node][3] * own + rows[bond.other][3] * twin)
    }

    /// Dilatation θ of a node \[–\], zero for a law without one.
    pub fn dilatation_of(&self, node: usize, rows: &[Row]) -> f64 {
        let part = |(_, bond): (usize, Bond)| bond.shares[0] * bond.extension(node, rows);
        if self.dilatation.is_some() { self.bonds_of(node).map(part).sum() } else { 0.0 }
    }

    /// Energy stored in the bonds of a node, half of each, with that of its dilatation \[F L\].
    pub fn stored(&self, rows: &[Row], node: usize) -> f64 {
        let half = |(_, bond): (usize, Bond)| {
            let [elastic, _] = self.elastic(node, &bond, bond.extension(node, rows));
            0.25 * bond.stiffness * elastic.powi(2)
        };
        let factor = self.dilatation.as_ref().map_or(0.0, |factors| factors[node]);
        let dilated = if factor == 0.0 { 0.0 } else { 0.5 * rows[node][3] * rows[node][3] / factor };
        self.bonds_of(node).map(half).sum::<f64>() + dilated
    }

    /// What the bonds of a node pull along an axis that reach through its plane of symmetry on a side, −1 or 1 \[F\].
    pub fn across(&self, rows: &[Row], node: usize, (axis, side): (usize, i32)) -> f64 {
        let Some(images) = &self.images else { return 0.0 };
        let of = |(_, bond): (usize, Bond)| {
            if images.side(bond.other, axis) != side {
                return 0.0;
            }
            let y = bond.between(node, rows);
            let length = y.norm();
            if length > 0.0 {
                self.pull(node, &bond, length - bond.length, rows) * y[axis] / length
            } else {
                0.0
            }
        };
        images.counts(node, axis) * self.bonds_of(node).map(of).sum::<f64>()
    }

    /// `½ Σ f ⊗ y` over the bonds y of a node and their pulls f, both at present: the volume times the stress, that of
    /// Kirchhoff, and at small strains of Cauchy \[F L\]. Half of a bond belongs to each of its ends.
    pub fn virial(&self, rows: &[Row], node: usize) -> Matrix3<f64> {
        let mut sum = Matrix3::zeros();
        for (_, bond) in self.bonds_of(node) {
            let y = bond.between(node, rows);
            let length = y.norm();
            if length > 0.0 {
                let pull = self.pull(node, &bond, length - bond.length, rows);
                sum += y * y.transpose() * (0.5 * pull / length);
            }
        }
        sum
    }
}
