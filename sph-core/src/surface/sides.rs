//! The four edges of a cloud that covers a patch.

/// One of the four edges of a patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// First u.
    U0,
    /// Last u.
    U1,
    /// First v.
    V0,
    /// Last v.
    V1,
}

/// The particles on the four edges of a patch, corners included.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sides {
    edges: [Vec<u32>; 4],
}

impl Sides {
    /// From the particles on u0, u1, v0 and v1, each in the direction of the growing parameter.
    pub(crate) fn new(edges: [Vec<u32>; 4]) -> Sides {
        Sides { edges }
    }

    /// Particles of one edge, in the direction of the growing parameter.
    pub fn edge(&self, side: Side) -> &[u32] {
        &self.edges[side as usize]
    }

    /// The particle where a u edge and a v edge meet; none if both are of one kind.
    pub fn corner(&self, first: Side, second: Side) -> Option<u32> {
        let other = self.edge(second);
        let mut shared = self.edge(first).iter().copied().filter(|a| other.contains(a));
        match (shared.next(), shared.next()) {
            (Some(corner), None) => Some(corner),
            _ => None,
        }
    }
}
