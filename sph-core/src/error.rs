//! What can be wrong with a cloud or an operator built on it: value, bound and repair in every message.

use thiserror::Error;

/// Why a cloud or an operator could not be built.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SpaceError {
    /// A position, normal or area is NaN or infinite, or an area not positive.
    #[error("particle {particle}: {what} is {value}, {bound} is needed; check the input that places it")]
    BadNumber {
        /// Particle.
        particle: usize,
        /// Which quantity.
        what: &'static str,
        /// Value found.
        value: f64,
        /// What is accepted, in words.
        bound: &'static str,
    },
    /// Two particles stand on the same place.
    #[error(
        "particles {first} and {second} coincide: distance {distance:e}, at least {bound:e} is needed; merge them or move one"
    )]
    Coincident {
        /// Lower index.
        first: usize,
        /// Higher index.
        second: usize,
        /// Distance between the two `[L]`.
        distance: f64,
        /// Smallest distance accepted `[L]`.
        bound: f64,
    },
    /// A list of joined particles names one that does not exist, or that is joined already.
    #[error(
        "particle {particle} is joined twice or not below {particles}; correct the lists of joined particles"
    )]
    BadJoint {
        /// Particle index found.
        particle: usize,
        /// Number of particles.
        particles: usize,
    },
    /// Joined particles stand apart.
    #[error(
        "particles {first} and {second} are joined and stand {distance:e} apart, at most {bound:e} is allowed; put them on one place"
    )]
    JoinedApart {
        /// The first particle of the list.
        first: usize,
        /// The other.
        second: usize,
        /// Distance between the two `[L]`.
        distance: f64,
        /// Greatest distance accepted `[L]`.
        bound: f64,
    },
    /// A particle belongs to no cell, or has no neighbour.
    #[error(
        "particle {particle} is isolated: {found} cells or neighbours, at least 1 is needed; connect or remove it"
    )]
    Isolated {
        /// Particle.
        particle: usize,
        /// Number of cells or neighbours found.
        found: usize,
    },
    /// An edge is used by three or more cells.
    #[error(
        "edge {first}–{second} belongs to {cells} cells, at most 2 are allowed; split the sheet along this edge into separate clouds"
    )]
    NonManifoldEdge {
        /// Lower particle index.
        first: usize,
        /// Higher particle index.
        second: usize,
        /// Number of cells that use the edge.
        cells: usize,
    },
    /// Two neighbouring cells turn opposite ways.
    #[error(
        "cells {cell} and {other} run the same way along edge {first}–{second}; reverse the corner order of one of them"
    )]
    Orientation {
        /// First cell.
        cell: usize,
        /// Second cell.
        other: usize,
        /// Lower particle index.
        first: usize,
        /// Higher particle index.
        second: usize,
    },
    /// No choice of corner orders makes all neighbours agree: the sheet has one side only.
    #[error(
        "the sheet has one side only: whichever way its cells run, two run the same way along an edge, as do {cell} and {other} along {first}–{second}; cut it open there, with particles of its own on each lip"
    )]
    NonOrientable {
        /// First cell.
        cell: usize,
        /// Second cell.
        other: usize,
        /// Lower particle index.
        first: usize,
        /// Higher particle index.
        second: usize,
    },
    /// The normal of a particle points to the other side of a cell.
    #[error(
        "particle {particle}: its normal is {degrees:.0}° from that of cell {cell}, less than 90° is needed; turn the normal round or reverse the corner order of the cell"
    )]
    NormalAgainstCell {
        /// Particle.
        particle: usize,
        /// Cell.
        cell: usize,
        /// Angle between the two normals.
        degrees: f64,
    },
    /// A cell has a corner that is too sharp.
    #[error(
        "cell {cell}: angle of {degrees:.2}° at particle {particle}, at least {bound}° is needed; move the particle, or merge it with its neighbour"
    )]
    Sliver {
        /// Cell.
        cell: usize,
        /// Particle at the corner.
        particle: usize,
        /// Angle found.
        degrees: f64,
        /// Least angle accepted.
        bound: f64,
    },
    /// A cell names a particle that does not exist, or repeats one.
    #[error("cell {cell}: corner {corner} is repeated or not below {particles}; correct the list of cells")]
    BadCorner {
        /// Cell.
        cell: usize,
        /// Particle index found.
        corner: usize,
        /// Number of particles.
        particles: usize,
    },
    /// A cell has no area or is turned inside out.
    #[error("cell {cell}: area {area:e}, at least {bound:e} is needed; move its corners apart or remove it")]
    DegenerateCell {
        /// Cell.
        cell: usize,
        /// Area found `[L²]`.
        area: f64,
        /// Smallest area accepted `[L²]`.
        bound: f64,
    },
    /// A list is too short for what was asked.
    #[error("{what}: {found} found, at least {needed} are needed; refine the cloud or lower the order")]
    TooFew {
        /// What was counted.
        what: &'static str,
        /// Number found.
        found: usize,
        /// Number needed.
        needed: usize,
    },
    /// Two lists that belong together differ in length.
    #[error("{what}: length {found}, {expected} expected; build both from the same cloud")]
    Length {
        /// Which list.
        what: &'static str,
        /// Length found.
        found: usize,
        /// Length expected.
        expected: usize,
    },
    /// A parameter lies outside its range.
    #[error("{what} = {value} is outside {bound}; choose a value in that range")]
    OutOfRange {
        /// Name of the parameter.
        what: &'static str,
        /// Value found.
        value: f64,
        /// Range in words.
        bound: &'static str,
    },
    /// A spacing is too large for the edges of a patch or too small for any machine.
    #[error(
        "spacing = {value} is outside [{least:.3e}, {greatest:.6}], from ten million particles to the length of the shortest edge; choose a spacing in that range"
    )]
    Spacing {
        /// Value found `[L]`.
        value: f64,
        /// Least spacing accepted `[L]`.
        least: f64,
        /// Greatest spacing accepted `[L]`.
        greatest: f64,
    },
    /// No support made the moment matrix of a point invertible.
    #[error(
        "point {point}: {neighbours} neighbours within {radius:e} do not determine a gradient of order {order} (condition bound 1e7); spread the particles over two directions"
    )]
    Undetermined {
        /// Sampling point.
        point: usize,
        /// Neighbours in the largest support tried.
        neighbours: usize,
        /// Radius of the largest support tried `[L]`.
        radius: f64,
        /// Polynomial order asked for.
        order: usize,
    },
    /// A direction has no projection on the surface at some point.
    #[error(
        "the axis stands on the surface at ({x:.4e}, {y:.4e}, {z:.4e}): its unit vector has a projection of {projection:e} there, at least {bound:e} is needed; choose an axis that lies along the surface everywhere",
        x = .position[0], y = .position[1], z = .position[2]
    )]
    AxisNormal {
        /// Where `[L]`.
        position: [f64; 3],
        /// Length of the projection found.
        projection: f64,
        /// Shortest projection accepted.
        bound: f64,
    },
    /// The conjugate gradients for the divergence-consistent operator did not arrive.
    #[error(
        "divergence consistency: residual {residual:e} after {iterations} iterations, {bound:e} is needed; widen the support or use cell stencils"
    )]
    NotConverged {
        /// Iterations done.
        iterations: usize,
        /// Relative residual reached.
        residual: f64,
        /// Relative residual asked for.
        bound: f64,
    },
}
