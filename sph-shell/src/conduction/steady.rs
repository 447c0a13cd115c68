//! Temperatures at which as much heat leaves every particle as enters it.

use sph_core::Vec3;

use super::given::Given;
use super::system::System;
use super::{Conduction, ConductionError, Radiation};

/// Heat that a balance leaves over what runs, sums of magnitudes: thousands of roundings of them.
pub(super) const LEFT: f64 = 1e-12;
/// Roundings of the temperatures themselves that a balance may leave.
pub(super) const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Newton's method falls quadratically on a convex function; a start in the wrong units takes some twenty.
const MOST_ITERATIONS: usize = 100;
const MOST_HALVINGS: usize = 40;

/// Heat that enters a surface in all, by where it comes from \[F L/T\]: the sum of all is zero in balance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HeatBalance {
    /// By what is supplied.
    pub supplied: f64,
    /// By what holds temperatures.
    pub held: f64,
    /// Through films.
    pub film: f64,
    /// By radiation.
    pub radiated: f64,
}

/// Temperatures of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Temperatures {
    /// Of each particle \[Θ\].
    pub values: Vec<f64>,
    /// Heat that enters at each particle by what holds its temperature \[F L/T\]; of joined particles at the first.
    pub held: Vec<f64>,
    /// Heat that runs through each cell, by length across it \[F/T\].
    pub flux: Vec<Vec3>,
    /// Where heat comes from.
    pub balance: HeatBalance,
    /// Solves made.
    pub iterations: usize,
}

/// Heat that enters the nodes at some temperatures.
pub(super) struct Entering {
    /// In all \[F L/T\]; of held nodes less than what holds them gives.
    pub net: Vec<f64>,
    /// Sum of the magnitudes of which that is the sum, each by a difference of temperatures.
    pub size: Vec<f64>,
    /// Sum of the magnitudes that temperatures alone would make: what their rounding is a part of.
    pub level: Vec<f64>,
}

impl Radiation {
    /// Heat that enters at a temperature; below absolute zero, where iterations may come, it goes on as an odd function.
    fn entering(&self, temperature: f64) -> [f64; 2] {
        let power = |t: f64| self.factor * (t - self.zero).powi(3).abs() * (t - self.zero);
        [power(self.surroundings), -power(temperature)]
    }

    /// How much less enters by degree.
    fn slope(&self, temperature: f64) -> f64 {
        4.0 * self.factor * (temperature - self.zero).powi(3).abs()
    }
}

impl Conduction {
    /// The temperatures in balance under what is given at the start of all courses.
    ///
    /// # Errors
    /// [`ConductionError`] for pieces whose temperature nothing tells, and for balances that are not found.
    pub fn steady(&self) -> Result<Temperatures, ConductionError> {
        if let Some(particle) = self.untold() {
            return Err(ConductionError::Untold { particle });
        }
        let given = &self.given_at(0.0);
        let mut system = System::new(self)?;
        let mut values = given.start();
        let mut entering = self.entering(given, &values);
        let mut iterations = 0;
        // Where much heat hides little, one solve finds the little.
        while iterations == 0 || left(&system, &entering) > 1.0 {
            if iterations == MOST_ITERATIONS {
                self.refuse_beyond_tables(&values)?;
                return Err(ConductionError::NotFound { iterations });
            }
            iterations += 1;
            system.factor(self, given, &values, 1.0, |_| 0.0)?;
            let mut change: Vec<f64> = system.free.iter().map(|&a| entering.net[a as usize]).collect();
            system.solver.solve(&mut change)?;
            let before = norm(&system, &entering.net);
            let moved = |share: f64| {
                let mut moved = values.clone();
                system.free.iter().zip(&change).for_each(|(&a, change)| moved[a as usize] += share * change);
                moved
            };
            let mut share = 1.0;
            let mut halvings = 0;
            loop {
                let there = moved(share);
                let found = self.entering(given, &there);
                if norm(&system, &found.net) < before
                    || halvings == MOST_HALVINGS
                    || left(&system, &found) <= 1.0
                {
                    (values, entering) = (there, found);
                    break;
                }
                (share, halvings) = (0.5 * share, halvings + 1);
            }
        }
        given.refuse_below_zero(&values)?;
        self.refuse_beyond_tables(&values)?;
        Ok(self.at(given, &values, &entering, iterations))
    }

    /// Heat that enters the nodes.
    pub(super) fn entering(&self, given: &Given, values: &[f64]) -> Entering {
        let mut net = given.supplied.clone();
        let mut size: Vec<f64> = given.supplied.iter().map(|heat| heat.abs()).collect();
        let mut level = vec![0.0; net.len()];
        let mut add = |a: u32, heat: f64, of_level: f64| {
            net[a as usize] += heat;
            size[a as usize] += heat.abs();
            level[a as usize] += of_level.abs();
        };
        for (c, cell) in self.cells.iter().enumerate() {
            let factor = self.conducts(c, values);
            for (a, row) in cell.entries[..cell.count].iter().enumerate() {
                // Rows sum to zero: differences of temperatures alone make heat run.
                let own = values[cell.nodes[a] as usize];
                for (b, entry) in row[..cell.count].iter().enumerate() {
                    let entry = factor * entry;
                    let other = values[cell.nodes[b] as usize];
                    add(cell.nodes[a], -entry * (other - own), entry * other);
                }
            }
        }
        for (a, &[by_degree, heat]) in (0..).zip(&given.film).filter(|(_, [by_degree, _])| *by_degree > 0.0) {
            add(a, by_degree * (heat / by_degree - values[a as usize]), heat);
        }
        for (a, own) in &given.radiating {
            own.entering(values[*a as usize]).into_iter().for_each(|heat| add(*a, heat, heat));
        }
        Entering { net, size, level }
    }

    /// What there is to read at temperatures of nodes, held ones among them.
    pub(super) fn at(
        &self,
        given: &Given,
        values: &[f64],
        entering: &Entering,
        iterations: usize,
    ) -> Temperatures {
        let held: Vec<f64> =
            given.held.iter().zip(&entering.net).map(|(held, net)| held.map_or(0.0, |_| -net)).collect();
        let balance = HeatBalance { held: 0.0 + held.iter().sum::<f64>(), ..given.enters(values) };
        let factors = Vec::from_iter((0..self.cells.len()).map(|c| self.conducts(c, values)));
        let values: Vec<f64> = self.node.iter().map(|&a| values[a as usize]).collect();
        let flux = self.operator.gradient(&values).into_iter().enumerate().map(|(c, [g1, g2])| {
            let ([k11, k22, k12], frame) = (self.tensors[c], &self.operator.points[c].frame);
            -(frame.t1 * (k11 * g1 + k12 * g2) + frame.t2 * (k12 * g1 + k22 * g2)) * factors[c]
        });
        let flux = flux.collect();
        Temperatures { values, held, flux, balance, iterations }
    }
}

impl Given {
    /// Held values where there are some, elsewhere the mean of all temperatures that are given; of a surface that radiates alone that at which all of it would be
    /// in balance.
    pub fn start(&self) -> Vec<f64> {
        let alone = self.held.iter().all(Option::is_none) && self.film.iter().all(|[by, _]| *by == 0.0);
        if let Some((_, first)) = self.radiating.first().filter(|_| alone) {
            let factors: f64 = self.radiating.iter().map(|(_, own)| own.factor).sum();
            let taken = |(_, own): &(u32, Radiation)| own.factor * (own.surroundings - own.zero).powi(4);
            let enters: f64 =
                self.radiating.iter().map(taken).sum::<f64>() + self.supplied.iter().sum::<f64>().max(0.0);
            let even = first.zero + libm::sqrt(libm::sqrt(enters / factors));
            return vec![even; self.held.len()];
        }
        let held = self.held.iter().copied().flatten();
        let ambient = self.film.iter().filter(|[by, _]| *by > 0.0).map(|[by, heat]| heat / by);
        let given: Vec<f64> =
            held.chain(ambient).chain(self.radiating.iter().map(|(_, own)| own.surroundings)).collect();
        let mean = given.iter().sum::<f64>() / given.len().max(1) as f64;
        self.held.iter().map(|held| held.unwrap_or(mean)).collect()
    }

    /// By how much less heat enters each node through its faces, by degree \[F L/(T Θ)\].
    pub fn surface_slopes(&self, values: &[f64]) -> Vec<f64> {
        let mut slopes: Vec<f64> = self.film.iter().map(|[by_degree, _]| *by_degree).collect();
        self.radiating.iter().for_each(|(a, own)| slopes[*a as usize] += own.slope(values[*a as usize]));
        slopes
    }

    /// Heat that enters in all at temperatures of nodes, but for what holds some.
    pub fn enters(&self, values: &[f64]) -> HeatBalance {
        let through = |([by_degree, heat], t): (&[f64; 2], &f64)| match *by_degree > 0.0 {
            true => by_degree * (heat / by_degree - t),
            false => 0.0,
        };
        let film = self.film.iter().zip(values).map(through);
        let radiated =
            self.radiating.iter().map(|(a, own)| own.entering(values[*a as usize]).iter().sum::<f64>());
        // A sum of nothing is −0.
        HeatBalance {
            supplied: 0.0 + self.supplied.iter().sum::<f64>(),
            held: 0.0,
            film: 0.0 + film.sum::<f64>(),
            radiated: 0.0 + radiated.sum::<f64>(),
        }
    }

    /// Refuses nodes that radiate and are colder than anything.
    pub fn refuse_below_zero(&self, values: &[f64]) -> Result<(), ConductionError> {
        match self.radiating.iter().find(|(a, own)| values[*a as usize] < own.zero) {
            None => Ok(()),
            Some(&(particle, own)) => {
                let temperature = values[particle as usize];
                Err(ConductionError::BelowZero { particle, temperature, zero: own.zero })
            }
        }
    }
}

pub(super) fn norm(system: &System, numbers: &[f64]) -> f64 {
    system.free.iter().map(|&a| numbers[a as usize].powi(2)).sum::<f64>().sqrt()
}

/// What is left of the balance of free nodes over what rounding may leave; zero where nothing runs.
fn left(system: &System, entering: &Entering) -> f64 {
    let Entering { net, size, level } = entering;
    let net = norm(system, net);
    if net > 0.0 { net / (LEFT * norm(system, size) + ROUNDING * norm(system, level)) } else { 0.0 }
}
