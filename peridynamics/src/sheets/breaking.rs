//! Plates that break: each sheet by its own bonds, so that cracks open on one side first.
//!
//! A pair shears as far as its bonds are whole, by half of its rigidity for each sheet. What a pair loses as a bond breaks is
//! counted with the energy of that bond. A column keeps its thickness.

use super::plate::Plate;
use crate::bonds::breaking::Breaking;
use crate::bonds::network::{LANES, Row};

impl Plate {
    /// Breaks the bonds noted in the last evaluation; returns the energy that the plate loses at these rows \[F L\].
    pub fn break_noted(&mut self, rows: &[Row]) -> f64 {
        let z = self.columns.height;
        let [upper, lower] = &mut self.sheets;
        if !(upper.noted() || lower.noted()) {
            return 0.0;
        }
        let lost = upper.break_noted(rows, z) + lower.break_noted(rows, -z);
        let rows = self.columns.extended(rows, true);
        lost + self.slacken(Some((&rows, 1.0)))
    }

    /// Sets the rigidities of pairs by the bonds that are whole; counts a share of the energy that pairs lose in these rows, and
    /// returns it \[F L\].
    pub fn slacken(&mut self, rows: Option<(&[Row], f64)>) -> f64 {
        let count = self.columns.rest.len();
        let shear = &mut self.columns.shear;
        let mut lost = 0.0;
        for node in 0..count {
            let lanes = self.sheets[0].network.lanes_of(node);
            let pairs = shear.starts[node] as usize..shear.starts[node + 1] as usize;
            for (lane, pair) in lanes.zip(&mut shear.pairs[pairs]) {
                let whole = self.sheets.iter().filter(|sheet| sheet.is_whole(lane)).count();
                let (before, after) = (pair.stiffness, 0.5 * whole as f64 * pair.rigidity);
                pair.stiffness = after;
                let (Some((rows, share)), true) = (rows, before != after) else { continue };
                let end = (&rows[pair.other as usize], &rows[pair.turned as usize]);
                let sheared = pair.sheared((&rows[node], &rows[count + node]), end);
                // The other half is lost at the other end.
                let held = share * 0.25 * (before - after) * sheared.strain * sheared.strain;
                self.sheared_off[node] += held;
                lost += held;
            }
        }
        lost
    }

    /// Whether the bond on a lane is whole in either sheet.
    pub fn is_joined(&self, lane: usize) -> bool {
        self.sheets.iter().any(|sheet| sheet.is_whole(lane))
    }

    /// Energy that the broken bonds and pairs of a column held \[F L\].
    pub fn broken_energy(&self, node: usize) -> f64 {
        let of = |sheet: &super::sheet::Sheet| {
            sheet.breaking.as_ref().map_or(0.0, |breaking| breaking.energy(node))
        };
        let of_pairs = self.sheared_off.get(node).copied().unwrap_or(0.0);
        of(&self.sheets[0]) + of(&self.sheets[1]) + of_pairs
    }

    /// All that changes as bonds break: the broken ones, those of the lower sheet behind those of the upper; the energies
    /// they held, those of pairs behind; the work on bonds.
    pub fn broken_state(&self) -> [Vec<f64>; 3] {
        let lanes = self.lanes() as f64;
        let mut out: [Vec<f64>; 3] = Default::default();
        for (sheet, offset) in self.sheets.iter().zip([0.0, lanes]) {
            let [broken, energies, works] =
                sheet.breaking.as_ref().map_or_else(Default::default, Breaking::state);
            out[0].extend(broken.iter().map(|lane| lane + offset));
            out[1].extend(energies);
            out[2].extend(works);
        }
        out[1].extend(&self.sheared_off);
        out
    }

    /// Takes up such a state; false, and nothing changed, for that of another plate, or one in which bonds are whole that are
    /// broken here.
    pub fn take_up_broken(&mut self, [broken, energies, works]: [&[f64]; 3]) -> bool {
        let (count, lanes) = (self.columns.rest.len(), self.lanes() as f64);
        if self.sheets[0].breaking.is_none() {
            return [broken, energies, works].iter().all(|array| array.is_empty());
        }
        let middle = broken.partition_point(|&lane| lane < lanes);
        let of_lower: Vec<f64> = broken[middle..].iter().map(|lane| lane - lanes).collect();
        if energies.len() != 3 * count || works.len() % 2 != 0 {
            return false;
        }
        let [of_upper, of_works] = [&broken[..middle], &works[..works.len() / 2]];
        let parts = [
            [of_upper, &energies[..count], of_works],
            [&of_lower, &energies[count..2 * count], &works[works.len() / 2..]],
        ];
        let mut taken = Vec::new();
        for (sheet, part) in self.sheets.iter().zip(parts) {
            let Some(mut breaking) = sheet.breaking.clone() else { return false };
            let mut network = sheet.network.clone();
            if !breaking.take_up(&mut network, part) {
                return false;
            }
            taken.push((breaking, network));
        }
        for (sheet, (breaking, network)) in self.sheets.iter_mut().zip(taken) {
            (sheet.breaking, sheet.network) = (Some(breaking), network);
        }
        self.slacken(None);
        self.sheared_off.copy_from_slice(&energies[2 * count..]);
        true
    }

    /// Lanes of a sheet.
    fn lanes(&self) -> usize {
        LANES * self.sheets[0].network.others.len()
    }
}
