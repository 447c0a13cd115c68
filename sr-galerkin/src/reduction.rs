//! From the matrix of all parameters to that of the unknowns, over a fixed pattern.
//!
//! With `d_h = T q` of the held parameters, `Kq = K_ff + TᵀK_hf + K_fhT + TᵀK_hhT`. With `Z = K_hf + ½K_hhT` that is
//! `K_ff + TᵀZ + ZᵀT`: entries between free parameters are copied, the rest is a small dense matrix on the unknowns near held ones.

use crate::blocks::Blocks;
use crate::essential::{HELD, Unknowns};

/// Not in the pattern.
const NOWHERE: u32 = u32::MAX;

/// The pattern of the unknowns' matrix, and how values come into it.
pub(crate) struct Reduction {
    /// Rows and columns, lower triangle.
    pub pattern: Vec<(usize, usize)>,
    /// Place in the pattern of every value of the blocks.
    direct: Vec<u32>,
    corner: Corner,
}

/// The dense part.
#[derive(Default)]
struct Corner {
    /// Unknowns that couple with held parameters or stand in their terms, ascending.
    unknowns: Vec<u32>,
    /// Terms of the held parameters, by place among `unknowns`.
    terms: Vec<Vec<(u32, f64)>>,
    /// Where entries of K_hf and K_hh come from: held row, column (unknown of the corner, or held), place in the blocks.
    free: Vec<(u32, u32, u32)>,
    held: Vec<(u32, u32, u32)>,
    /// Those of `unknowns` that stand in terms, and the row of each among them.
    masters: Vec<u32>,
    row: Vec<u32>,
    /// Place in the pattern of every master with every unknown.
    places: Vec<u32>,
    /// Space for Z and TᵀZ.
    z: Vec<f64>,
    sums: Vec<f64>,
}

impl Reduction {
    pub fn new(blocks: &Blocks, unknowns: &Unknowns) -> Self {
        let mut pattern = Vec::new();
        let mut direct = vec![NOWHERE; blocks.len()];
        let mut corner = Corner::new(blocks, unknowns);
        blocks.visit(|row, column, place| {
            let (a, b) = (unknowns.of[row], unknowns.of[column]);
            if a != HELD && b != HELD {
                direct[place] = pattern.len() as u32;
                pattern.push((b as usize, a as usize)); // unknowns are numbered as parameters are
            }
        });
        corner.find_places(blocks, unknowns, &direct, &mut pattern);
        Self { pattern, direct, corner }
    }

    /// Values in the order of the pattern.
    pub fn reduce(&mut self, blocks: &Blocks, values: &mut [f64]) {
        values.fill(0.0);
        for (&place, &value) in self.direct.iter().zip(blocks.values()) {
            if place != NOWHERE {
                values[place as usize] = value;
            }
        }
        self.corner.add(blocks.values(), values);
    }
}

impl Corner {
    fn new(blocks: &Blocks, unknowns: &Unknowns) -> Self {
        if unknowns.held.is_empty() {
            return Self::default();
        }
        let mut number = vec![NOWHERE; unknowns.of.len()];
        for (h, held) in unknowns.held.iter().enumerate() {
            number[held.parameter as usize] = h as u32;
        }
        let (mut free, mut held) = (Vec::new(), Vec::new());
        let mut near: Vec<u32> =
            unknowns.held.iter().flat_map(|held| held.terms.iter().map(|term| term.0)).collect();
        blocks.visit(|row, column, place| {
            for (h, other) in [(row, column), (column, row)] {
                let (h, other_held, unknown) = (number[h], number[other], unknowns.of[other]);
                if h != NOWHERE && other_held != NOWHERE {
                    held.push((h, other_held, place as u32));
                } else if h != NOWHERE {
                    near.push(unknown);
                    free.push((h, unknown, place as u32));
                }
                if row == column {
                    break;
                }
            }
        });
        near.sort_unstable();
        near.dedup();
        let local = |unknown: u32| near.partition_point(|&other| other < unknown) as u32;
        free.iter_mut().for_each(|entry| entry.1 = local(entry.1));
        let terms = unknowns.held.iter().map(|held| held.terms.iter().map(|&(u, t)| (local(u), t)).collect());
        let terms: Vec<Vec<(u32, f64)>> = terms.collect();
        let n = near.len();
        let mut row = vec![NOWHERE; n];
        terms.iter().flatten().for_each(|term| row[term.0 as usize] = 0);
        let masters: Vec<u32> = (0..n as u32).filter(|&at| row[at as usize] == 0).collect();
        masters.iter().enumerate().for_each(|(number, &at)| row[at as usize] = number as u32);
        let (z, sums) = (vec![0.0; terms.len() * n], vec![0.0; masters.len() * n]);
        Self { terms, unknowns: near, free, held, masters, row, places: Vec::new(), z, sums }
    }

    /// Takes up what the pattern misses.
    fn find_places(
        &mut self,
        blocks: &Blocks,
        unknowns: &Unknowns,
        direct: &[u32],
        pattern: &mut Vec<(usize, usize)>,
    ) {
        let n = self.unknowns.len();
        self.places = vec![NOWHERE; self.masters.len() * n];
        for number in 0..self.masters.len() {
            for at in 0..n {
                let master = self.masters[number] as usize;
                let other = self.row[at];
                if other != NOWHERE && (other as usize) < number {
                    self.places[number * n + at] = self.places[other as usize * n + master];
                    continue;
                }
                let [low, high] = [master.min(at), master.max(at)].map(|at| self.unknowns[at] as usize);
                let parameters = [low, high].map(|u| unknowns.parameters[u] as usize);
                let known = blocks.place(parameters[0], parameters[1]).map(|place| direct[place]);
                self.places[number * n + at] = known.unwrap_or_else(|| {
                    pattern.push((high, low));
                    (pattern.len() - 1) as u32
                });
            }
        }
    }

    /// Adds `TᵀZ + ZᵀT`.
    fn add(&mut self, blocks: &[f64], values: &mut [f64]) {
        let n = self.unknowns.len();
        let (z, sums) = (&mut self.z, &mut self.sums);
        z.fill(0.0);
        sums.fill(0.0);
        for &(h, unknown, place) in &self.free {
            z[h as usize * n + unknown as usize] += blocks[place as usize];
        }
        for &(h, other, place) in &self.held {
            for &(unknown, t) in &self.terms[other as usize] {
                z[h as usize * n + unknown as usize] += 0.5 * t * blocks[place as usize];
            }
        }
        for (h, terms) in self.terms.iter().enumerate() {
            let z = &z[h * n..][..n];
            for &(unknown, t) in terms {
                let row = &mut sums[self.row[unknown as usize] as usize * n..][..n];
                row.iter_mut().zip(z).for_each(|(sum, z)| *sum += t * z);
            }
        }
        for (number, &master) in self.masters.iter().enumerate() {
            for at in 0..n {
                let both = if at == master as usize { 2.0 } else { 1.0 };
                values[self.places[number * n + at] as usize] += both * sums[number * n + at];
            }
        }
    }
}
