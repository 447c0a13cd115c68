//! Weakly compressible fluids of SPH particles, their walls and wet boundaries.
