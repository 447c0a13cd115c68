//! Contact of surfaces with rigid tools: a penalty on the distance of mid-surfaces, with a barrier in the inner half of the thickness.
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
//! use contact::{Law, Surface, ToolContact, ToolShape, stiffness};
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
//! let touch = contact.forces(&Vec3::zeros(), |a| rest[a as usize], |_, force| sum += force);
//! assert!((sum.z / (contact.stiffness * 1e-4) - 1.0).abs() < 1e-9); // κ u A
//! assert!((touch.greatest_depth - 0.002).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | where is | look in |
//! |---|---|
//! | energy of a depth | `law.rs` |
//! | shapes and their distances | `tool.rs` |
//! | vertices, areas | `surface.rs` |
//! | forces, tangent, what is measured | `touch.rs` |
//! | κ | `stiffness.rs` |
//! | springs between places of two bodies | `joints.rs` |
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | slope and curvature of the law, gradient and second derivative of distances are derivatives | `slope_and_curvature_are_derivatives_everywhere`, `gradient_and_second_derivative_are_those_of_the_distance` |
//! | areas sum to that of the sheet | `a_sheet_hands_all_of_its_area_to_its_vertices` |
//! | forces are the gradient of the energy, the tangent that of the forces, for every tool | tests/derivatives.rs |
//! | springs between places: forces and blocks are derivatives, momentum is kept, the bound lies above the frequency | src/joints.rs |
//! | turned and in other units the answer is the same | tests/relations.rs |
#![warn(missing_docs)]

mod joints;
mod law;
mod stiffness;
mod surface;
mod tool;
mod touch;

pub use joints::{Joint, Joints};
pub use law::Law;
pub use stiffness::stiffness;
pub use surface::{Surface, Vertex};
pub use tool::{Gap, ToolError, ToolShape};
pub use touch::{ToolContact, Touch};
