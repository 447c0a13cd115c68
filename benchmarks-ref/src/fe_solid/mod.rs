//! Bricks of twenty nodes: the cross-check of solids without elements and of solids of bonds, written without their mechanics.
//!
//! Displacements are the serendipity functions of the brick \[ergatoudis1968\], the same that carry its shape; strains are Green's,
//! stress St Venant's, all from the configuration at rest:
//!
//! ```text
//! F = I + Σ_a u_a ⊗ ∇N_a     E = ½(FᵀF − I)     S = C:E     U = Σ_g V_g ½ E:C:E
//! f_a = Σ_g V_g F S ∇N_a     K_ab = Σ_g V_g (B_aᵀ C B_b + (∇N_a·S ∇N_b) I)      B_a = ∂E/∂u_a
//! ```
//!
//! Three Gauss points along an edge leave six modes without stiffness; two of them make the brick soft enough in bending for thin
//! plates, at the price of six modes more of a lone brick, which neighbours and supports take away. Limits: strains small beside one
//! (rotations any), loads dead, mass lumped in proportion to the squares of the functions.

mod cases;
mod element;
mod mesh;
mod model;

pub use cases::{cantilever, plate};
pub use element::{Moduli, NODES};
pub use mesh::Mesh;
pub use model::{Held, Model};
