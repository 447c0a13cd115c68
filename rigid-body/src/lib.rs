//! Rigid bodies: a closed surface, a mass and an inertia, six degrees of freedom; in time and at rest.
//!
//! A body has a pole p, its centre of mass, and a turn Q from its principal axes into space. A place of its surface is `x = p + Q A`, its arm
//! `a = Q A`. Its particles are the vertices of its surface and, last of them, the centre. With principal moments J₀:
//!
//! ```text
//! J = Q J₀ Qᵀ        ẋ = v + ω × a        T = ½ m v·v + ½ ω·J ω        L = J ω
//! m v̇ = Σ f          L̇ = Σ a × f + Σ c
//! ```
//!
//! # In time
//!
//! Central differences, of which the drift is the free motion over a step by the midpoint rule on rotations:
//!
//! ```text
//! kick    v ← v + κ F/m        L ← L + κ τ
//! drift   p ← p + Δt v         J(Q½) ω½ = L,  Q½ = Q exp(½Δt Ω½),  Q ← Q exp(Δt Ω½)        Ω½ = Q½ᵀ ω½
//! ```
//!
//! L is a variable of the state and a free motion does not touch it: moment of momentum is kept to the last bit, whatever the step. In the frame of
//! the body the rule reads `Π± = exp(∓½Δt Ω½) Π½` with `Π = Qᵀ L` and `Ω½ = J₀⁻¹ Π½`: the same half turn about the same axis forwards and backwards.
//! So it is symmetric in time, of second order, keeps |Π|, and its energy `½ Π·J₀⁻¹ Π` comes back after every period of Euler's top instead of drifting
//! away. Steady spins about a principal axis, and all spins of a ball, are exact. It is the rule by which rigid sets of shells turn. The
//! equation for Ω½ is solved by rounds, each of which gains a factor of `Δt |ω|`; a step turns the body by a fiftieth at most.
//!
//! # Joints
//!
//! Hinges, sliders and ball joints to each other and to the ground are exact constraints in time ([`Joints`], `jointed.rs`).
//!
//! # At rest
//!
//! Unknowns are displacements along free directions and turns about the principal axes, in which masses are diagonal. A dead force f at an arm a
//! has the second variation `(f·a) 1 − ½(f aᵀ + a fᵀ)` along the rotation, a spring `½ k (n·u)²` the block `k w wᵀ` with `w = (n, a × n)`.
//!
//! # In a fluid
//!
//! A body that is wet shows a fluid rows of points behind its faces, which go with it, and bears what the fluid puts on them, forces and moments alike. Steps of a
//! light one are bounded by the resistance of sound, `ρ₀c₀A` of each point next to a face on the mass that moves with it.
//!
//! | what | tested in |
//! |---|---|
//! | mass, centre and inertia of a closed surface, exactly | `mass.rs` |
//! | Euler's top: momentum, energy, order two, a symmetric top's precession | `tests/march.rs` |
//! | joints: momentum, a pendulum of large amplitude, a chain, a crank | `tests/jointed.rs` |
//! | tangent against differences of forces; frequencies on springs | `tests/at_rest.rs` |
#![warn(missing_docs)]

mod at_rest;
mod body;
mod conditions;
mod error;
mod forces;
mod inside;
mod joined;
mod jointed;
mod march;
mod mass;
mod shapes;
mod turn;
mod wet_points;
mod wetted;

pub use at_rest::RestingBody;
pub use body::{Parts, RigidBody};
pub use conditions::{Load, RotationHold, Spring, Support};
pub use error::RigidError;
pub use jointed::{Joint, JointKind, Joints};
pub use mass::{MassProperties, Outline};
pub use shapes::{ball, cuboid};
pub use wet_points::WetPoints;
