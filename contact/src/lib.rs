//! Contact of surfaces with rigid tools, with each other and with themselves: a penalty on the distance of mid-surfaces, with a barrier in the
//! inner half of the thickness, and Coulomb friction on tools.
//!
//! Thickness is the room in which contact happens: the mid-surface of a shell of thickness t stands `D = t/2` off a tool when faces touch, so a
//! soft law has half a thickness to give. Every vertex of the surface, a particle or the middle of a quadrilateral, has the energy
//!
//! ```text
//! U = κ A D² φ(s),     s = (D − g)/D,     force −∂U/∂x = κ A D φ′(s) ∇g
//! ```
//!
//! A its area, g its signed distance from the tool ([`ToolShape::gap`]), φ the law ([`Law`]). Forces are the gradient of an energy, so that
//! they need no books of their own, and their tangent is exact.
//!
//! The stiffness κ \[F/L³\] of a unit of area is bounded twice. What the thickness gives to one face is `2E/t`; and a stiff contact costs
//! time steps: a sheet of mass ρt that touches on both sides has `2κ/ρt` added to the square of its frequencies, so κ is held to
//! a share of the square of the fastest one ([`stiffness`]).
//!
//! ```
//! use contact::{Law, Pose, Surface, ToolContact, ToolShape, Watch, stiffness};
//! use sph_core::{Cell, Vec3};
//!
//! // A sheet of one cell, a thousandth of its thickness deep in a plane.
//! let rest = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Vec3::new(x, y, 0.0499));
//! let cells = [Cell { corners: [0, 1, 2, 3], count: 4 }];
//! let contact = ToolContact {
//!     tool: ToolShape::Plane { point: Vec3::zeros(), normal: Vec3::z() }.checked()?,
//!     surface: Surface::new(&cells, &rest, |_| 0.05),
//!     law: Law::new(0.0).ok_or("no law")?,
//!     stiffness: stiffness(1e6, 0.1, 1.0),
//! };
//! let mut sum = Vec3::zeros();
//! let mut watch = Watch::new(&contact.surface);
//! let touch = contact.forces(&mut watch, None, &Pose::default(), |a| rest[a as usize], |_, force| sum += force);
//! assert!((sum.z / (contact.stiffness * 1e-4) - 1.0).abs() < 1e-9); // κ u A
//! assert!((touch.greatest_depth - 0.002).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Two surfaces, or one with itself, are a [`SurfaceContact`]: each vertex of one has the energy `κ σ A D² Σ c φ(s)` over the faces, edges and
//! vertices of the other nearer than D, whose integer coefficients c count every nearest place once (`euler.rs`); σ is its share, by
//! which both sides are as stiff. Who uses it says where nodes are and takes the forces on them:
//!
//! ```
//! use contact::{Law, Mesh, SurfaceContact, Touching};
//! use sph_core::{Cell, Vec3};
//!
//! // Two squares of one cell, a tenth of the distance at which they touch in each other.
//! let square = |z: f64| [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Vec3::new(x, y, z));
//! let places = [square(0.0), square(0.09)];
//! let cells = [Cell { corners: [0, 1, 2, 3], count: 4 }];
//! let meshes = [0, 1].map(|body: usize| Mesh::new(&cells, &places[body], |_| 0.05));
//! let touching = Touching { distance: 0.1, law: Law::SHARP, stiffness: 1e3, skin: 0.3, edges: false };
//! let mut contact = SurfaceContact::between(meshes, [&places[0], &places[1]], touching);
//! let touch = contact.look(|(body, node)| places[body][node as usize]);
//! let mut upper = Vec3::zeros();
//! contact.forces(|(body, _), force| if body == 1 { upper += force });
//! assert!((upper.z / (1e3 * 0.01) - 1.0).abs() < 1e-9); // κ u A
//! assert!((touch.energy / (0.5 * 1e3 * 0.01 * 0.01) - 1.0).abs() < 1e-9);
//! ```
//!
//! | where is | look in |
//! |---|---|
//! | energy of a depth | `law.rs` |
//! | shapes and their distances | `tool.rs` |
//! | vertices, areas | `surface.rs` |
//! | forces, tangent, what is measured of a tool | `touch.rs` |
//! | what is far of a tool is passed over | `watch.rs` |
//! | distance of a point or an edge from a feature, with its derivatives | `pair.rs`, `nearest.rs` |
//! | faces and edges, what lies near along a surface | `mesh.rs` |
//! | which features a point touches, how often each counts | `euler.rs` |
//! | what may touch while nothing moves far | `list.rs`, `surfaces/following.rs`; which patches are near `patches.rs` |
//! | how far nodes may go at once | `surfaces/reaching.rs` |
//! | edges that cross between vertices | `edges.rs` |
//! | two surfaces, or one with itself; forces, tangent, bounds of them | `surfaces.rs`; `surfaces/acting.rs` |
//! | κ | `stiffness.rs` |
//! | what nodes feel of contact, to be read; gaps | `nodal.rs` |
//! | bodies that are too near although nothing acts between them | `unseen.rs` |
//! | friction on tools, its anchors, what it loses | `friction.rs` |
//! | friction of surfaces on each other, anchors in their faces | `surfaces/rubbing.rs`; their history `surfaces/remembering.rs`, `grips.rs` |
//! | how far a motion may go before what touches a tool is another | `changes.rs` |
//! | how far a tool has moved and turned | `pose.rs` |
//! | springs between places of two bodies | `joints.rs` |
//! | springs by a curve, cables, gaps; dashpots; how far their ends are apart | `links.rs`, `force_curve.rs`; `dashpots.rs`; `reach.rs` |
//! | points glued to surfaces; where they stand over them | `glue.rs`; `foot.rs` |
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | slope and curvature of the law, gradient and second derivative of distances are derivatives | `slope_and_curvature_are_derivatives_everywhere`, `gradient_and_second_derivative_are_those_of_the_distance` |
//! | what is passed over does not touch | `far_parts_are_passed_over_until_motion_may_have_brought_them` |
//! | areas sum to that of the sheet | `a_sheet_hands_all_of_its_area_to_its_vertices` |
//! | forces are the gradient of the energy, the tangent that of the forces, for every tool | tests/derivatives.rs |
//! | work of friction is what it loses and what its anchors store; a tool that turns drags | tests/friction.rs |
//! | springs between places: forces and blocks are derivatives, momentum is kept, the bound lies above the frequency | src/joints.rs |
//! | links: energies of curves, forces and blocks are derivatives, what is slack changes no bit; dashpots: order two, the bound of their step | src/force_curve.rs, links.rs, dashpots.rs |
//! | glued points: forces and blocks are derivatives, momentum and moment of momentum are kept, rigid motions cost nothing | tests/glue.rs |
//! | turned and in other units the answer is the same | tests/relations.rs |
//! | the same of pairs of features, of edges that cross, of two surfaces | `gradient_and_second_derivative_of_every_kind_of_pair_are_those_of_the_distance`, `forces_of_two_edges_are_the_gradient_of_their_energy_nearly_parallel_ones_too`, tests/surfaces.rs |
//! | every nearest place counts once; what slides over a plane feels no ripple | `every_nearest_place_counts_once_at_faces_rims_notches_and_corners`, `what_slides_over_a_plane_feels_no_ripple` |
//! | what is too near is found with its places, and what was so at rest is not | `two_sheets_are_too_near_below_the_sum_of_their_halves_and_where_they_cross`, `a_sheet_that_is_rolled_up_meets_itself_and_one_that_is_bent_does_not` |
//! | lists by patches hold what all pairs do | `lists_by_patches_hold_what_all_pairs_do` |
//! | no vertex leaps through a face | `nothing_leaps_through_what_it_may_touch` |
//! | an even depth makes even forces on unlike cells, momentum is kept, an old list and a new one give the same bits | tests/surfaces.rs |
#![warn(missing_docs)]

mod changes;
mod dashpots;
mod dual;
mod edges;
mod euler;
mod foot;
mod force_curve;
mod friction;
mod glue;
mod grips;
mod joints;
mod law;
mod links;
mod list;
mod mesh;
mod nearest;
mod nodal;
mod pace;
mod pair;
mod patches;
mod pose;
mod reach;
mod stiffness;
mod surface;
mod surfaces;
mod tool;
mod touch;
mod unseen;
mod watch;

pub use changes::{FrontChange, Motion, Turn};
pub use dashpots::{Dashpot, Dashpots};
pub use dual::Dual;
pub use foot::{Foot, Nearest};
pub use force_curve::{Bears, ForceCurve, OnCurve};
pub use friction::Friction;
pub use glue::{Glue, Glued, Hold};
pub use joints::{Joint, Joints};
pub use law::Law;
pub use links::{Link, Links};
pub use mesh::Mesh;
pub use nodal::{Grip, NodalContact};
pub use pace::{Moving, Pace};
pub use pair::Pair;
pub use pose::Pose;
pub use reach::{Far, Reach, Span};
pub use stiffness::{stiffness, thickness_bounds};
pub use surface::{Surface, Vertex};
pub use surfaces::{Deepest, Node, SurfaceContact, SurfaceTouch, Touching};
pub use tool::{Face, Gap, ToolError, ToolShape};
pub use touch::{ToolContact, Touch};
pub use unseen::{Bystander, TooNear};
pub use watch::Watch;
