//! Hard cases of fluids: a tank that rolls, a narrow corner, one particle, a jet, widths of kernels, runs that must end.

pub mod corner;
pub mod jet;
pub mod kernel_width;
pub mod one_particle;
pub mod refused;
pub mod sloshing;
