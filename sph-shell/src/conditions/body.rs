//! What loads see of a shell, and the blocks of their derivatives.

use nalgebra::Matrix3;

use crate::reference::Reference;

/// What a load sees of the shell.
pub struct Body<'a> {
    /// The reference configuration.
    pub reference: &'a Reference,
    /// Position and director of every particle, `[x, y, z, d_x, d_y, d_z]`.
    pub state: &'a [[f64; 6]],
    /// Mass that each particle bears in the equations of motion \[M\]: with what hangs on it by ties, and none of what hangs.
    pub masses: &'a [f64],
}

/// Derivatives between the rows `[x, d]` of two particles.
pub type Block = [[f64; 6]; 6];

/// The block that is `change` from its first row and column (0 of a force or position, 3 of a couple or director) on, else zero.
pub fn place_block(row: usize, column: usize, change: &Matrix3<f64>) -> Block {
    let mut block = [[0.0; 6]; 6];
    for i in 0..3 {
        for j in 0..3 {
            block[row + i][column + j] = change[(i, j)];
        }
    }
    block
}
