//! Planes of symmetry.

use std::collections::BTreeMap;

use sph_core::{Block, CellList, Vec3};

use crate::conditions::{Support, Supported};

/// Nodes closer to a plane than this part of the spacing lie on it.
pub(crate) const ON_PLANE: f64 = 1e-9;

/// A plane of symmetry normal to an axis, all of the body on one side of it.
///
/// Bonds reach across it to the images of nodes, so that a half is the half of a whole; nodes on it stay on it, and stand for
/// half of their volume. Two planes may be parallel: what lies between repeats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// The axis that it is normal to: 0, 1 or 2.
    pub axis: usize,
    /// Where it cuts the axis \[L\].
    pub at: f64,
}

impl Mirror {
    /// What holds the nodes on the plane, if there are any.
    pub(crate) fn support(&self, block: &Block) -> Option<Supported> {
        let near = |x: &Vec3| (x[self.axis] - self.at).abs() <= ON_PLANE * block.greatest_spacing();
        let count = block.len() as u32;
        let nodes: Vec<u32> = (0..count).filter(|&node| near(&block.positions[node as usize])).collect();
        let normal = vec![Vec3::ith(self.axis, 1.0)];
        let support = Support::Held { displacement: normal.clone(), director: normal };
        (!nodes.is_empty()).then_some(Supported { nodes, support })
    }
}

/// What of a load goes through planes of symmetry at once.
#[derive(Clone, Debug)]
pub(crate) struct Passed {
    pub load: usize,
    /// By nodes of the face before the plane, at level one \[F\].
    pub forces: BTreeMap<u32, Vec3>,
    /// The factor of the load when it was last evaluated.
    pub factor: f64,
}

impl Passed {
    /// What it is at a node now.
    pub fn at(&self, node: usize) -> Option<Vec3> {
        self.forces.get(&(node as u32)).map(|force| force * self.factor)
    }
}

/// Which nodes of a face bear what bonds pull through the plane of symmetry before it: each that of the nodes behind it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Borne {
    /// Of nodes of a face the axis, the side of the body, −1 or 1, and a node behind.
    behind: BTreeMap<u32, Vec<(usize, i32, u32)>>,
}

impl Borne {
    /// Gives each node within reach of a plane to the nearest node of the face there.
    pub fn new(mirrors: &[Mirror], block: &Block, reach: f64) -> Self {
        let mut out = Self::default();
        for &Mirror { axis, at } in mirrors {
            let middle = block.positions.iter().map(|x| x[axis]).sum::<f64>() / block.len() as f64;
            let (upper, side) = if at > middle { (1, 1) } else { (0, -1) };
            let face = &block.faces[2 * axis + upper];
            let onto = |node: u32| {
                let mut x = block.positions[node as usize];
                x[axis] = at;
                x
            };
            let places: Vec<Vec3> = face.iter().map(|&(node, _)| onto(node)).collect();
            if places.is_empty() {
                continue;
            }
            let (list, mut near) = (CellList::new(&places, reach), Vec::new());
            for node in 0..block.len() as u32 {
                if (block.positions[node as usize][axis] - at).abs() > reach {
                    continue;
                }
                let x = onto(node);
                list.within(&x, reach, &mut near);
                let distance = |&place: &u32| (places[place as usize] - x).norm_squared();
                if let Some(&place) = near.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))) {
                    out.behind.entry(face[place as usize].0).or_default().push((axis, side, node));
                }
            }
        }
        out
    }

    /// What the planes bear at a node of a face, from what the bonds of a node pull through one.
    pub fn at(&self, node: usize, across: impl Fn(usize, (usize, i32)) -> f64) -> Vec3 {
        let mut sum = Vec3::zeros();
        for &(axis, side, behind) in self.behind.get(&(node as u32)).into_iter().flatten() {
            sum[axis] += across(behind as usize, (axis, side));
        }
        sum
    }
}
