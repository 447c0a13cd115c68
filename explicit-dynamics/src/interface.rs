//! What a fluid and a structure say to each other over their common boundary.
//!
//! A structure shows the fluid points that stand for its wet surface; the fluid says which force it puts on each of them.
//! Neither knows what the other is made of.

use crate::dynamics::Dynamics;
use crate::several::Joinable;

/// How the points of a wet surface belong together; it never changes once built.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BoundaryLayout {
    /// Number of points.
    pub points: usize,
    /// Area of wet surface that a column of points stands for \[L²; L in a plane problem\], by point.
    pub areas: Vec<f64>,
    /// The two faces of a body thinner than the kernel of a fluid is wide; none of a body of bulk.
    pub thin: Option<ThinLayout>,
}

/// The faces of a thin body: fluid on one side must not feel the other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ThinLayout {
    /// Distance between the faces \[L\].
    pub thickness: f64,
    /// By point: its face, along the director or against it.
    pub faces: Vec<Face>,
    /// By place of the middle surface: whether it lies on a free edge, beyond which both sides meet.
    pub edges: Vec<bool>,
}

/// One face of a thin body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// On the side to which the director points.
    Front,
    /// On the other side.
    Back,
}

/// Where a boundary is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BoundaryState {
    /// Positions of the points \[L\].
    pub points: Vec<[f64; 3]>,
    /// Of a thin body: places of its middle surface \[L\]; else empty.
    pub middle: Vec<[f64; 3]>,
    /// Of a thin body: unit normals there, towards [`Face::Front`]; else empty.
    pub normals: Vec<[f64; 3]>,
}

/// What a fluid puts on a boundary, frozen until the next load.
#[derive(Clone, Copy, Debug)]
pub struct BoundaryLoad<'a> {
    /// Forces on the points \[F; F/L in a plane problem\].
    pub forces: &'a [[f64; 3]],
    /// Forces that the fluid found, of which those of the load follow: a point without is dry, and resists nothing.
    pub found: &'a [[f64; 3]],
    /// Velocities with which the fluid saw the points when it found the forces \[L/T\].
    pub seen: &'a [[f64; 3]],
    /// ρ₀c₀ of the fluid \[F T/L³\]: while a wet face moves by δv against what the fluid saw, the load changes by
    /// `−ρ₀c₀ A (δv·n) n`, the pressure of a plane wave.
    pub impedance: f64,
}

/// A structure that a fluid wets.
pub trait Wetted: Joinable {
    /// How its points belong together.
    fn boundary_layout(&self) -> &BoundaryLayout;

    /// Where its boundary is at present.
    fn boundary(&self, out: &mut BoundaryState);

    /// Puts a load on the points; it stays until the next.
    fn apply_load(&mut self, load: &BoundaryLoad<'_>);

    /// Adds to the impulses of the points \[F T; F T/L in a plane problem\] what they resist from now on for a time `span`
    /// \[T\], beyond the forces of the load: `−span ρ₀c₀ A (δv·n) n` with the present velocities. Of a thin body the first
    /// points of a column below its wet faces stand for it. Nothing, unless a structure says otherwise.
    fn impedance_impulses(&self, _span: f64, _impulses: &mut [[f64; 3]]) {}

    /// Velocities of the points at present \[L/T\]: what a fluid receives of a structure that starts in motion. At rest unless
    /// a structure says otherwise.
    fn boundary_velocities(&self, out: &mut Vec<[f64; 3]>) {
        out.clear();
        out.resize(self.boundary_layout().points, [0.0; 3]);
    }
}

/// A fluid that boundaries drive.
pub trait BoundaryDriven: Dynamics {
    /// Tells the place of a structure's boundary at the end of the step to come, and the mean velocities of its points over
    /// that step \[L/T\]: displacements over its span, so that in the middle of the step they stand half a step behind.
    fn set_boundary(&mut self, structure: usize, end: &BoundaryState, velocities: &[[f64; 3]]);

    /// Forces of the last evaluation on the points of a structure \[F; F/L in a plane problem\]: minus what they did to the
    /// fluid.
    fn boundary_forces(&self, structure: usize) -> &[[f64; 3]];

    /// Takes the opposite of impulses on the points of a structure \[F T; F T/L in a plane problem\] between a kick and the
    /// drift behind it: what the points resisted beyond the forces.
    fn apply_reactions(&mut self, structure: usize, impulses: &[[f64; 3]]);

    /// ρ₀c₀ \[F T/L³\].
    fn impedance(&self) -> f64;

    /// How far a boundary point may go in one step \[L\].
    fn greatest_displacement(&self) -> f64;

    /// Particles that [`Dynamics::within_bounds`] may name: those of structures are counted on from here.
    fn particles(&self) -> usize {
        0
    }
}
