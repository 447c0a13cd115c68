//! The free parameters as unknowns of a sparse matrix.

use implicit_statics::SymmetricSolver;

use super::given::Given;
use super::{Capacity, Conduction, ConductionError, Conducts, Eliminated};

/// Where each free parameter stands among the unknowns, what the others follow from, and each entry in the pattern.
pub(super) struct System {
    /// The parameters of the unknowns.
    pub free: Vec<u32>,
    /// Unknowns with their weights of each parameter, by `of`; one of those that are free.
    terms: Vec<Vec<(u32, f64)>>,
    /// Place in `terms` of each parameter, one up; zero of those that are held or none.
    of: Vec<u32>,
    held: Vec<Eliminated>,
    /// Parameters that each couples with, ascending.
    coupled: Vec<Vec<u32>>,
    pattern: Vec<(usize, usize)>,
    /// Where each row of the pattern begins.
    rows: Vec<usize>,
    pub solver: SymmetricSolver,
}

impl System {
    /// Orders and analyses the matrix of the free parameters.
    ///
    /// # Errors
    /// [`ConductionError::Balance`] for a pattern that cannot be analysed; none is known.
    pub fn new<C: Conducts>(
        of: &Conduction<C>,
        capacity: Option<&Capacity>,
    ) -> Result<Self, ConductionError> {
        let count = of.conductor.parameters();
        let nodes: Vec<u32> = (0..count as u32).filter(|&a| of.given.held[a as usize].is_some()).collect();
        let alone = |&a: &u32| Eliminated { parameter: a, terms: Vec::new(), moves: vec![(a, 1.0)] };
        let held = of.conductor.eliminate(&nodes).unwrap_or_else(|| nodes.iter().map(alone).collect());
        let rest = vec![0.0; count];
        let mut used = vec![false; count];
        of.conductor.visit(&rest, |entry| used[entry.row as usize] = true);
        held.iter().for_each(|own| used[own.parameter as usize] = false);
        let free: Vec<u32> = (0..count as u32).filter(|&a| used[a as usize]).collect();
        let mut unknown = vec![0; count];
        (0..).zip(&free).for_each(|(number, &a)| unknown[a as usize] = number);
        let mut terms: Vec<Vec<(u32, f64)>> =
            (0..free.len() as u32).map(|number| vec![(number, 1.0)]).collect();
        let mut places = vec![0; count];
        (1..).zip(&free).for_each(|(place, &a)| places[a as usize] = place);
        for own in held.iter().filter(|own| !own.terms.is_empty()) {
            terms.push(own.terms.iter().map(|&(a, t)| (unknown[a as usize], t)).collect());
            places[own.parameter as usize] = terms.len() as u32;
        }
        let mut coupled: Vec<Vec<u32>> = vec![Vec::new(); count];
        of.conductor.visit(&rest, |entry| put_once(&mut coupled[entry.row as usize], entry.column));
        for &(a, b, _) in capacity.iter().flat_map(|capacity| &capacity.pairs) {
            put_once(&mut coupled[a as usize], b);
            put_once(&mut coupled[b as usize], a);
        }
        for place in of.places.iter().flatten() {
            for &(a, _) in place {
                place.iter().for_each(|&(b, _)| put_once(&mut coupled[a as usize], b));
            }
        }
        coupled.iter_mut().for_each(sort_once);
        let mut lower: Vec<Vec<u32>> = (0..free.len() as u32).map(|row| vec![row]).collect();
        let mut columns = Vec::new();
        for (a, coupled) in (0..).zip(&coupled) {
            columns.clear();
            coupled
                .iter()
                .for_each(|&b| columns.extend(terms_of(&terms, &places, b).iter().map(|own| own.0)));
            sort_once(&mut columns);
            for &(row, _) in terms_of(&terms, &places, a) {
                let before = columns.iter().take_while(|column| **column <= row);
                before.for_each(|&column| put_once(&mut lower[row as usize], column));
            }
        }
        lower.iter_mut().for_each(sort_once);
        let of_row = |(row, columns): (usize, &Vec<u32>)| -> Vec<(usize, usize)> {
            columns.iter().map(|&column| (row, column as usize)).collect()
        };
        let pattern: Vec<(usize, usize)> = lower.iter().enumerate().flat_map(of_row).collect();
        let rows = (0..=free.len()).map(|row| pattern.partition_point(|own| own.0 < row)).collect();
        let solver = SymmetricSolver::new(free.len(), &pattern)?;
        Ok(Self { free, terms, of: places, held, coupled, pattern, rows, solver })
    }

    /// Puts parameters that are held where nodes are held and free ones are.
    pub fn put(&self, given: &Given, values: &mut [f64]) {
        for own in &self.held {
            let terms: f64 = own.terms.iter().map(|&(a, t)| t * values[a as usize]).sum();
            let moves: f64 =
                own.moves.iter().map(|&(node, g)| g * given.held[node as usize].unwrap_or_default()).sum();
            values[own.parameter as usize] = if own.terms.is_empty() { moves } else { terms + moves };
        }
    }

    /// What is at all parameters as it is at the unknowns.
    pub fn project(&self, numbers: &[f64]) -> Vec<f64> {
        let mut out: Vec<f64> = self.free.iter().map(|&a| numbers[a as usize]).collect();
        for own in self.held.iter().filter(|own| !own.terms.is_empty()) {
            let number = numbers[own.parameter as usize];
            self.at(own.parameter).iter().for_each(|&(u, t)| out[u as usize] += t * number);
        }
        out
    }

    /// What is at all parameters as it is at the nodes that are held.
    pub fn at_held(&self, numbers: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; numbers.len()];
        for own in &self.held {
            let number = numbers[own.parameter as usize];
            own.moves.iter().for_each(|&(node, g)| out[node as usize] += g * number);
        }
        out
    }

    /// Norm of what is at the unknowns.
    pub fn norm(&self, numbers: &[f64]) -> f64 {
        self.project(numbers).iter().map(|own| own.powi(2)).sum::<f64>().sqrt()
    }

    /// The same of magnitudes.
    pub fn size(&self, sizes: &[f64]) -> f64 {
        let mut all: Vec<f64> = self.free.iter().map(|&a| sizes[a as usize]).collect();
        for own in self.held.iter().filter(|own| !own.terms.is_empty()) {
            let size = sizes[own.parameter as usize];
            self.at(own.parameter).iter().for_each(|&(u, t)| all[u as usize] += t.abs() * size);
        }
        all.iter().map(|own| own.powi(2)).sum::<f64>().sqrt()
    }

    fn at(&self, parameter: u32) -> &[(u32, f64)] {
        terms_of(&self.terms, &self.of, parameter)
    }

    /// Factorises what heat does at these temperatures, times a factor, with what parameters store.
    ///
    /// # Errors
    /// [`ConductionError::Balance`] for a matrix that is not finite.
    pub fn factor<C: Conducts>(
        &mut self,
        of: &Conduction<C>,
        given: &Given,
        temperatures: &[f64],
        (factor, capacity): (f64, Option<&Capacity>),
    ) -> Result<(), ConductionError> {
        // Of the parameters first, then of the unknowns, row by row.
        let mut blocks: Vec<Vec<f64>> = self.coupled.iter().map(|own| vec![0.0; own.len()]).collect();
        let mut add = |a: u32, b: u32, value: f64| {
            if let Ok(at) = self.coupled[a as usize].binary_search(&b) {
                blocks[a as usize][at] += value;
            }
        };
        of.conductor.visit(temperatures, |entry| {
            let factor = factor * entry.factor;
            add(entry.row, entry.column, factor * entry.value);
        });
        let slopes = of.surface_slopes(given, temperatures);
        match &of.places {
            None => {
                for (a, slope) in (0..).zip(slopes) {
                    add(a, a, factor * slope + capacity.map_or(0.0, |capacity| capacity.own[a as usize]));
                }
            }
            Some(places) => {
                for (place, slope) in places.iter().zip(slopes).filter(|(_, slope)| *slope != 0.0) {
                    for &(a, left) in place {
                        place.iter().for_each(|&(b, right)| add(a, b, factor * slope * left * right));
                    }
                }
                let own = capacity.map_or(&[][..], |capacity| &capacity.own);
                (0..).zip(own).for_each(|(a, own)| add(a, a, *own));
            }
        }
        for &(a, b, c) in capacity.map_or(&[][..], |capacity| &capacity.pairs) {
            add(a, b, c);
            add(b, a, c);
        }
        let mut values = vec![0.0; self.pattern.len()];
        let (mut sums, mut columns) = (vec![0.0; self.free.len()], Vec::new());
        for (a, (coupled, block)) in (0..).zip(self.coupled.iter().zip(&blocks)) {
            for (&b, value) in coupled.iter().zip(block) {
                for &(column, weight) in self.at(b) {
                    sums[column as usize] += weight * value;
                    columns.push(column);
                }
            }
            sort_once(&mut columns);
            for &(row, weight) in self.at(a) {
                let own = self.rows[row as usize]..self.rows[row as usize + 1];
                let (mut at, before) = (own.start, columns.iter().take_while(|column| **column <= row));
                for &column in before {
                    at += self.pattern[at..own.end].partition_point(|place| place.1 < column as usize);
                    values[at] += weight * sums[column as usize];
                }
            }
            columns.drain(..).for_each(|column| sums[column as usize] = 0.0);
        }
        self.solver.factor(&values)?;
        Ok(())
    }
}

fn terms_of<'a>(terms: &'a [Vec<(u32, f64)>], of: &[u32], parameter: u32) -> &'a [(u32, f64)] {
    let place = (of[parameter as usize] as usize).checked_sub(1);
    place.map_or(&[], |place| terms[place].as_slice())
}

/// Puts a number into a list that has it twice at most some times.
fn put_once(list: &mut Vec<u32>, number: u32) {
    if list.len() == list.capacity() {
        sort_once(list);
        list.reserve(list.len().max(8));
    }
    list.push(number);
}

fn sort_once(list: &mut Vec<u32>) {
    list.sort_unstable();
    list.dedup();
}
