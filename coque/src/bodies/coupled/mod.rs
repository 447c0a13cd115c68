//! Bodies built together: a fluid, its walls, the structures in it.

mod build;
