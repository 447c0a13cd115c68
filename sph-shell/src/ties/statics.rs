//! Ties in the blocks of the tangent.

use crate::conditions::body::Block;
use crate::packs::Row;
use crate::statics::blocks::ShellPattern;
use crate::ties::list::Ties;

impl Ties {
    /// Adds the pairs of particles that come to share a block as what hangs goes out, row by row; for each that hangs those it
    /// shares one with.
    pub fn add_pairs(&self, rows: &mut [Vec<u32>]) -> Vec<Vec<u32>> {
        if self.is_empty() {
            return Vec::new();
        }
        let mut near: Vec<Vec<u32>> = vec![Vec::new(); rows.len()];
        for (a, row) in (0..).zip(rows.iter()) {
            for &b in row {
                near[a as usize].push(b);
                near[b as usize].push(a);
            }
        }
        let partners = |hanging: &super::hanging::Hanging| {
            let t = hanging.particle;
            let mut own = std::mem::take(&mut near[t as usize]);
            own.extend(&hanging.corners);
            own.sort_unstable();
            own.dedup();
            own.retain(|&b| b != t);
            for &k in &hanging.corners {
                for &b in &own {
                    rows[k.max(b) as usize].push(k.min(b));
                    near[k as usize].push(b);
                    near[b as usize].push(k);
                }
            }
            own
        };
        self.hanging.iter().map(partners).collect()
    }

    /// Takes what hangs out of the blocks, `Zᵀ H Z` with the second variation for what is out of balance on it, if any is given. The
    /// lower triangle is that of a symmetric matrix, or of a skew one with sign −1.
    pub fn reduce(
        &self,
        state: &[Row],
        pattern: &ShellPattern,
        blocks: &mut [Block],
        sign: f64,
        lack: impl Fn(usize) -> Option<Row>,
    ) {
        let ShellPattern { pairs, of_hanging, .. } = pattern;
        for (i, (hanging, partners)) in self.hanging.iter().zip(of_hanging).enumerate() {
            let (t, v) = (hanging.particle, hanging.vectors(state));
            let z = hanging.jacobians(&v);
            for &b in partners {
                let Some(number) = pairs.find(t.max(b), t.min(b)) else { continue };
                let taken = std::mem::replace(&mut blocks[number], [[0.0; 6]; 6]);
                let of_t = if t > b { taken } else { transposed(&taken, sign) };
                for (&k, z) in hanging.corners.iter().zip(&z) {
                    let share = product(z, &of_t);
                    if k >= b {
                        add(&share, pairs.find(k, b), blocks);
                    }
                    if k <= b {
                        add(&transposed(&share, sign), pairs.find(b, k), blocks);
                    }
                }
            }
            let own = pairs
                .find(t, t)
                .map_or([[0.0; 6]; 6], |number| std::mem::replace(&mut blocks[number], [[0.0; 6]; 6]));
            let second = lack(i).map(|row| hanging.second_variation(&v, &row));
            let count = hanging.corners.len();
            for (k, &row) in hanging.corners.iter().enumerate() {
                for (l, &column) in hanging.corners.iter().enumerate().filter(|(_, column)| **column <= row) {
                    let target = pairs.find(row, column);
                    // Zₖᵀ H Zₗ = ((Zₖᵀ H)ᵀ)ᵀ Zₗ, both products with the transpose on the left.
                    let half = transposed(&product(&z[k], &own), 1.0);
                    add(&product(&half, &z[l]), target, blocks);
                    if let Some(second) = &second {
                        add(&second[k * count + l], target, blocks);
                    }
                }
            }
        }
    }

    /// What is out of balance on what hangs, for the last forces evaluated.
    pub fn lack(&self, i: usize) -> Row {
        let (internal, external) = (self.internal[i], self.external[i]);
        std::array::from_fn(|k| internal[k] - external[k])
    }
}

/// `aᵀ b`.
fn product(a: &Block, b: &Block) -> Block {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..6).map(|k| a[k][i] * b[k][j]).sum()))
}

fn transposed(block: &Block, sign: f64) -> Block {
    std::array::from_fn(|i| std::array::from_fn(|j| sign * block[j][i]))
}

fn add(block: &Block, target: Option<usize>, blocks: &mut [Block]) {
    let Some(target) = target else { return };
    for (sum, row) in blocks[target].iter_mut().zip(block) {
        sum.iter_mut().zip(row).for_each(|(sum, value)| *sum += value);
    }
}
