//! sph-shell
