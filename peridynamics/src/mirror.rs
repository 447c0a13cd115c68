//! Planes of symmetry.

use sph_core::{Block, Vec3};

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
