//! Contact as it stands in a state: what touches there is a spring from then on, what is apart stays apart.

use crate::conditions::body::Block;
use crate::packs::Row;

/// The forces of contact in a state and their derivatives there: `f(x) = f₀ + K (x − x₀)`.
///
/// Modes of vibration and linearised buckling are those of this system: small motions open and close nothing.
#[derive(Clone, Debug)]
pub(crate) struct FrozenContact {
    home: Vec<Row>,
    forces: Vec<Row>,
    blocks: Vec<(u32, u32, Block)>,
}

impl FrozenContact {
    /// Contact of a state, with the forces there and the derivatives of the force on the first particle by the place of the second.
    pub fn new(state: &[Row], forces: Vec<Row>, blocks: Vec<(u32, u32, Block)>) -> Self {
        Self { home: state.to_vec(), forces, blocks }
    }

    /// Adds its forces in a state.
    pub fn add(&self, state: &[Row], forces: &mut [Row]) {
        for (sum, row) in forces.iter_mut().zip(&self.forces) {
            (0..6).for_each(|k| sum[k] += row[k]);
        }
        for (a, b, block) in &self.blocks {
            let [here, home] = [state, &self.home].map(|rows| &rows[*b as usize]);
            for (sum, row) in forces[*a as usize].iter_mut().zip(block) {
                *sum += (0..6).map(|k| row[k] * (here[k] - home[k])).sum::<f64>();
            }
        }
    }

    /// Hands the derivatives to `put`, as loads do theirs.
    pub fn stiffness(&self, put: &mut dyn FnMut(u32, u32, &Block)) {
        self.blocks.iter().for_each(|(a, b, block)| put(*a, *b, block));
    }
}
