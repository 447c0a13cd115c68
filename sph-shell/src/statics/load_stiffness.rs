//! The load stiffness `−∂external/∂q`: what follower loads add to the tangent, and how far it is from symmetric.
//!
//! Loads without a potential leave a skew part: pressure on a shell with free edges, couples that turn out of a plane
//! \[schweizerhof1984\]. The solver is symmetric, so the tangent takes the symmetric part. Equilibria stay exact, since
//! residuals hold the whole load; critical levels are those of the symmetric part, and flutter is not looked for.

use implicit_statics::BlockPattern;
use std::ops::DerefMut;

use crate::Shell;
use crate::conditions::body::Block;
use crate::statics::static_shell::StaticShell;

/// The largest entry of the skew part that counts as rounding, in units of the largest derivative.
const ROUNDING: f64 = 1e-9;

/// Takes the symmetric part of the loads' derivatives from the lower triangle of the tangent.
pub(crate) fn subtract_load_stiffness(
    shell: &Shell,
    level: f64,
    pattern: &BlockPattern,
    blocks: &mut [Block],
) {
    shell.load_stiffness(level, &mut |a, b, block| {
        add_halves((a, b, block), [-0.5, -0.5], pattern, blocks);
    });
}

impl<S: DerefMut<Target = Shell>> StaticShell<S> {
    /// Largest entry of the skew part of the load stiffness at level one in the unknowns, in units of its largest derivative:
    /// zero where the loads have a potential in the present state, of order one where free edges leave them without.
    pub fn skew_load_share(&self) -> f64 {
        let turn = 1.0 / self.dofs.arc;
        let unit = |i: usize| if i < 3 { 1.0 } else { turn };
        let mut largest = 0.0_f64;
        self.shell.load_stiffness(1.0, &mut |_, _, block| {
            for (i, row) in block.iter().enumerate() {
                let sizes = row.iter().enumerate().map(|(j, v)| v.abs() * unit(i) * unit(j));
                largest = sizes.fold(largest, f64::max);
            }
        });
        let couples = self.shell.loading.couples_on_bodies(&self.shell.dependents.junctions);
        largest = couples.iter().fold(largest, |most, (_, couple)| most.max(couple.amax() * turn * turn));
        if largest == 0.0 {
            return 0.0;
        }
        let mut skew = vec![[[0.0; 6]; 6]; self.pattern.pairs.blocks()];
        self.shell.load_stiffness(1.0, &mut |a, b, block| {
            add_halves((a, b, block), [0.5, -0.5], &self.pattern.pairs, &mut skew);
        });
        self.shell.dependents.ties.reduce(&self.shell.motion.state, &self.pattern, &mut skew, -1.0, |_| None);
        self.shell.dependents.junctions.tie(&self.shell.motion.state, &self.pattern.pairs, &mut skew, -1.0);
        for (first, couple) in couples {
            let Some(number) = self.pattern.pairs.find(first, first) else { continue };
            // Of a couple C about a fixed axis in the rotations of a body: ½ C × θ.
            let half = couple.cross_matrix() * 0.5;
            (0..3).for_each(|i| (0..3).for_each(|j| skew[number][3 + i][3 + j] += half[(i, j)]));
        }
        let mut values = vec![0.0; self.entries()];
        self.project_blocks(&skew, |_| 0.0, &mut values);
        let share = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        if share > ROUNDING * largest { share / largest } else { 0.0 }
    }
}

/// Adds a block and its transpose, times a factor each, to the lower triangle of blocks; a diagonal block gets both.
fn add_halves(
    (a, b, block): (u32, u32, &Block),
    [plain, transposed]: [f64; 2],
    pattern: &BlockPattern,
    blocks: &mut [Block],
) {
    let Some(sum) = pattern.find(a.max(b), a.min(b)).map(|number| &mut blocks[number]) else { return };
    for i in 0..6 {
        for j in 0..6 {
            if a >= b {
                sum[i][j] += plain * block[i][j];
            }
            if a <= b {
                sum[i][j] += transposed * block[j][i];
            }
        }
    }
}
