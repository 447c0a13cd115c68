//! Why a solid could not be built.

/// A solid that was refused before anything ran.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolidError {
    /// A constant of the material out of bounds.
    #[error(
        "{what} is {value}; E and the density are positive, Poisson's ratio lies above -1 and below 0.5 (in plane stress 1)"
    )]
    Material {
        /// Which constant.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// Pairwise forces have one Poisson's ratio.
    #[error(
        "Poisson's ratio is {0}; pairwise forces have {1:.4} in this space; take the state-based formulation for another"
    )]
    Pairwise(f64, f64),
    /// A horizon that reaches too few nodes.
    #[error(
        "the horizon is {0} spacings; below 1.4 no bond leaves the axes of a lattice; 1.5 suits sheets, 3.015 cracks"
    )]
    Horizon(f64),
    /// Nodes that coincide.
    #[error("nodes {0} and {1} coincide; remove one of them")]
    Coincident(u32, u32),
    /// A node whose volume is not positive.
    #[error("node {node} has the volume {volume}; it must be positive")]
    Volume {
        /// The node.
        node: u32,
        /// Its volume.
        volume: f64,
    },
    /// A node without a bond.
    #[error("node {0} has no bond; enlarge the horizon or remove the node")]
    Alone(u32),
    /// A body in space of which no bond leaves a plane.
    #[error(
        "all bonds lie in one plane, so that nothing resists across it; use a plane block or several layers"
    )]
    OneLayer,
    /// Families that no weights above zero make isotropic.
    #[error(
        "cells are too flat for weights that hold uniform strains: every bond that a shear of {} and {} strains is at least \
         {ratio:.1} times as long along {} as along {}, beyond √3 only weights below zero hold extension and shear at once, and the \
         body is unstable at rest; use spacings that differ by less, two sheets for a thin plate, or the correction `none`",
        ["x", "y", "z"][*wide], ["x", "y", "z"][*narrow], ["x", "y", "z"][*wide], ["x", "y", "z"][*narrow]
    )]
    Flat {
        /// Axis along which bonds are long.
        wide: usize,
        /// The other axis of the shear.
        narrow: usize,
        /// Least length along the one over that along the other, of bonds along both.
        ratio: f64,
    },
    /// A plate of sheets without plane stress in a plane.
    #[error("two sheets make a thin plate: they need a plane block and plane stress")]
    NotThin,
    /// Contact asked of a plate of sheets.
    #[error("plates of two sheets know no contact; leave it out, or model the plate as a solid")]
    SheetContact,
    /// A plate of sheets in a fluid.
    #[error(
        "plates of two sheets meet no fluid; model the plate as a shell, or as a solid of several layers"
    )]
    WetSheets,
    /// A plane of symmetry inside the body, or across no axis.
    #[error(
        "a plane of symmetry cuts axis {axis} at {at:.6e}; it bounds the body: put it where all nodes are on one side"
    )]
    Mirror {
        /// The axis.
        axis: usize,
        /// Where the plane cuts it \[L\].
        at: f64,
    },
    /// Contact asked of a body with planes of symmetry.
    #[error(
        "contact with the mirror image of a body is not modelled; model the whole body, or leave contact out"
    )]
    MirroredContact,
    /// A body that the correction `balanced` is not for.
    #[error(
        "balanced weights hold uniform strains on the faces of a body: {0}; put the nodes on the edges of a block without \
         holes, or take the correction `even`"
    )]
    Unbalanced(&'static str),
    /// A set without nodes.
    #[error("{0} acts on an empty set of nodes; name a set that holds at least one")]
    EmptySet(&'static str),
    /// A node number beyond the body.
    #[error("{what} names node {node}, but the body has {count} nodes (numbered from 0)")]
    NoSuchNode {
        /// Who named it.
        what: &'static str,
        /// The number.
        node: u32,
        /// Nodes of the body.
        count: usize,
    },
    /// A prescribed motion along a held direction.
    #[error(
        "node {node} is prescribed to move by {wanted:.6e} along a direction its other supports hold; remove one of them"
    )]
    Contradiction {
        /// The node.
        node: u32,
        /// The motion asked for \[L\].
        wanted: f64,
    },
    /// A node that two supports turn.
    #[error("node {0} is turned by two supports; leave it out of one of them")]
    TwoTurns(u32),
    /// A limit of bonds out of bounds.
    #[error("{what} is {value}; {bound}")]
    Limit {
        /// Which limit.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        bound: &'static str,
    },
    /// What one process marches alone.
    #[error("{0} is marched by one process alone; start one, with as many threads as there are cores")]
    NotShared(&'static str),
    /// Bonds that yield where they cannot.
    #[error("bonds that yield {0}")]
    Yielding(&'static str),
    /// A plate of two sheets that should conduct heat.
    #[error("a plate of two sheets conducts no heat; take a block of bonds, or a shell")]
    Conduction,
    /// Heat of what does not expand.
    #[error("{0}")]
    Heat(&'static str),
    /// A crack that is none.
    #[error("crack {number} (numbered from 0) {problem}")]
    Crack {
        /// Its number.
        number: usize,
        /// What is wrong, and how to repair it.
        problem: &'static str,
    },
}
