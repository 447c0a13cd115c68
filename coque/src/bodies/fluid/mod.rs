//! Fluids and their walls: from the scene's words to `fluid-sph`.

mod places;
