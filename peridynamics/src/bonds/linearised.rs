//! A network about a state: what each whole bond adds to second derivatives.

use sph_core::Vec3;

use super::images::Images;
use super::intact::Bond;
use super::network::{Network, Row};

/// Least length of a present bond \[L\]: one that has collapsed pulls nowhere.
const COLLAPSED: f64 = 1e-300;

/// A whole directed bond at a state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinearisedBond {
    /// The node at the other end, or an image.
    pub other: u32,
    /// `∂T/∂e` at fixed dilatations, the same from both ends \[F/L\].
    pub stiffness: f64,
    /// Its share in the dilatation of its own node \[1/L\].
    pub own: f64,
    /// Its share in that of the other node \[1/L\].
    pub twin: f64,
    /// Direction M at the state, towards the other node.
    pub direction: Vec3,
    /// Pull over present length T/Y \[F/L\].
    pub across: f64,
}

/// A network about a state, whole bonds only: node by node, others ascending.
pub(crate) struct Linearised<'a> {
    starts: Vec<u32>,
    bonds: Vec<LinearisedBond>,
    /// `(λ − μ) V` of each node \[F L\]; none where all are zero or the law has no dilatation.
    pub factors: Option<&'a [f64]>,
    pub(super) images: Option<&'a Images>,
}

impl Linearised<'_> {
    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// The node at the other end of a bond, and what a displacement of it makes of that end along the axes.
    #[inline]
    pub fn end(&self, bond: &LinearisedBond) -> (usize, [f64; 3]) {
        let other = bond.other as usize;
        self.images.map_or((other, [1.0; 3]), |images| (images.source(other), images.signs(other)))
    }

    /// Whole bonds of a node.
    pub fn of(&self, node: usize) -> &[LinearisedBond] {
        &self.bonds[self.starts[node] as usize..self.starts[node + 1] as usize]
    }

    /// `∂θ/∂x` of a node's dilatation with respect to its own position.
    pub fn own_gradient(&self, node: usize) -> Vec3 {
        self.of(node).iter().fold(Vec3::zeros(), |sum, bond| sum - bond.direction * bond.own)
    }
}

impl Network {
    /// Whole bonds of a node, others ascending: those with a stiffness or a share in a dilatation.
    fn whole(&self, node: usize) -> impl Iterator<Item = Bond> {
        let carries = |bond: &Bond| bond.stiffness != 0.0 || bond.shares != [0.0; 2];
        self.bonds_of(node).map(|(_, bond)| bond).filter(carries)
    }

    /// The nodes at the other ends of a node's bonds, and those whose images are there. Broken bonds count too, and some ends come
    /// more than once: the pattern of a tangent stays as bonds break, and with it the order in which it is factored.
    pub fn neighbours(&self, node: usize) -> impl Iterator<Item = u32> {
        let family = self.family(node);
        (0..family.len())
            .flat_map(move |pack| family.others(pack))
            .map(|other| self.source(other as usize) as u32)
    }

    /// The factors of the dilatations, if any of them counts.
    pub fn dilatation_factors(&self) -> Option<&[f64]> {
        let factors = self.dilatation.as_ref()?;
        factors.iter().any(|&factor| factor != 0.0).then_some(factors)
    }

    /// The network about the state in `rows`; its pulls are those of another state, if one is given.
    pub fn linearised(&self, rows: &[Row], stressed: Option<&[Row]>) -> Linearised<'_> {
        let mut out = Linearised {
            starts: vec![0],
            bonds: Vec::with_capacity(self.bonds),
            factors: self.dilatation_factors(),
            images: self.images.as_deref(),
        };
        let rows = &*self.extended(rows);
        let stressed = stressed.map(|rows| self.extended(rows));
        let pulling = stressed.as_deref().unwrap_or(rows);
        let dilatations = self.stressed_dilatations(pulling);
        for node in 0..self.len() {
            let hat = |node: usize| dilatations.get(node).copied().unwrap_or(0.0);
            for bond in self.whole(node) {
                let Bond { other, stiffness, shares: [own, twin], .. } = bond;
                let now = bond.between(node, rows);
                let y = now.norm().max(COLLAPSED);
                let elastic = bond.extension(node, pulling) - 0.5 * (bond.plastic[0] + bond.plastic[1]);
                let pull = stiffness * elastic + (own * hat(node) + twin * hat(self.source(other)));
                let (direction, across) = (now / y, pull / y);
                let other = other as u32;
                out.bonds.push(LinearisedBond { other, stiffness, own, twin, direction, across });
            }
            out.starts.push(out.bonds.len() as u32);
        }
        out
    }

    /// The least of present over reference length of whole bonds, and the node that has it.
    pub fn shortest(&self, rows: &[Row]) -> (usize, f64) {
        let rows = &*self.extended(rows);
        let of = |node: usize| {
            let ratio = |bond: Bond| bond.between(node, rows).norm() / bond.length;
            (node, self.whole(node).map(ratio).fold(f64::INFINITY, f64::min))
        };
        (0..self.len())
            .map(of)
            .fold((0, f64::INFINITY), |least, next| if next.1 < least.1 { next } else { least })
    }

    /// `(λ − μ) V θ` of all nodes; nothing without a dilatation.
    fn stressed_dilatations(&self, rows: &[Row]) -> Vec<f64> {
        let Some(factors) = &self.dilatation else { return Vec::new() };
        let of = |node: usize| {
            let share = |bond: Bond| bond.shares[0] * bond.extension(node, rows);
            factors[node] * self.whole(node).map(share).sum::<f64>()
        };
        (0..self.len()).map(of).collect()
    }
}
