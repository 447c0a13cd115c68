//! Temperatures at which as much heat leaves every parameter as enters it.

use super::given::Given;
use super::system::System;
use super::{Conduction, ConductionError, Conducts, Radiation};

/// Heat that a balance leaves over what runs, sums of magnitudes: thousands of roundings of them.
pub(super) const LEFT: f64 = 1e-12;
/// Roundings of the temperatures themselves that a balance may leave.
pub(super) const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Newton's method falls quadratically on a convex function; a start in the wrong units takes some twenty.
const MOST_ITERATIONS: usize = 100;
const MOST_HALVINGS: usize = 40;

/// Heat that enters a body in all, by where it comes from \[F L/T\]: the sum of all is zero in balance.
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

/// Temperatures of a body.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Temperatures {
    /// Parameters \[Θ\].
    pub parameters: Vec<f64>,
    /// Of each node \[Θ\].
    pub values: Vec<f64>,
    /// Heat that enters at each node by what holds its temperature \[F L/T\].
    pub held: Vec<f64>,
    /// Where heat comes from.
    pub balance: HeatBalance,
    /// Solves made.
    pub iterations: usize,
}

/// Heat that enters the parameters at some temperatures.
pub(super) struct Entering {
    /// In all \[F L/T\]; of what is held less than what holds it gives.
    pub net: Vec<f64>,
    /// Sum of the magnitudes of which that is the sum, each by a difference of temperatures.
    pub size: Vec<f64>,
    /// Sum of the magnitudes that temperatures alone would make: what their rounding is a part of.
    pub level: Vec<f64>,
}

impl<C: Conducts> Conduction<C> {
    /// The temperatures in balance under what is given at the start of all courses. Whether something tells them in every piece is for whoever asks to see
    /// ([`Conduction::untold`]).
    ///
    /// # Errors
    /// [`ConductionError`] for balances that are not found.
    pub fn steady(&self) -> Result<Temperatures, ConductionError> {
        let given = &self.given_at(0.0);
        let mut system = System::new(self, None)?;
        let mut values = given.start();
        system.put(given, &mut values);
        let mut entering = self.entering(given, &values);
        let mut iterations = 0;
        // Where much heat hides little, one solve finds the little.
        while iterations == 0 || left(&system, &entering) > 1.0 {
            if iterations == MOST_ITERATIONS {
                self.conductor.refuse_beyond_tables(&values)?;
                return Err(ConductionError::NotFound { iterations });
            }
            iterations += 1;
            system.factor(self, given, &values, (1.0, None))?;
            let mut change = system.project(&entering.net);
            system.solver.solve(&mut change)?;
            let before = system.norm(&entering.net);
            let moved = |share: f64| {
                let mut moved = values.clone();
                system.free.iter().zip(&change).for_each(|(&a, change)| moved[a as usize] += share * change);
                system.put(given, &mut moved);
                moved
            };
            let mut share = 1.0;
            let mut halvings = 0;
            loop {
                let there = moved(share);
                let found = self.entering(given, &there);
                if system.norm(&found.net) < before
                    || halvings == MOST_HALVINGS
                    || left(&system, &found) <= 1.0
                {
                    (values, entering) = (there, found);
                    break;
                }
                (share, halvings) = (0.5 * share, halvings + 1);
            }
        }
        self.refuse_below_zero(given, &values)?;
        self.conductor.refuse_beyond_tables(&values)?;
        Ok(self.found(&system, given, (&values, &entering), iterations))
    }

    /// Heat that enters the parameters.
    pub(super) fn entering(&self, given: &Given, values: &[f64]) -> Entering {
        let mut net = given.supplied.clone();
        let mut size: Vec<f64> = given.supplied.iter().map(|heat| heat.abs()).collect();
        let mut level = vec![0.0; net.len()];
        let mut add = |a: u32, heat: f64, of_level: f64| {
            net[a as usize] += heat;
            size[a as usize] += heat.abs();
            level[a as usize] += of_level.abs();
        };
        self.conductor.visit(values, |own| {
            // Rows sum to zero: differences of temperatures alone make heat run.
            let entry = own.factor * own.value;
            let (here, there) = (values[own.row as usize], values[own.column as usize]);
            add(own.row, -entry * (there - here), entry * there);
        });
        for (place, &[by_degree, heat]) in
            (0..).zip(&given.film).filter(|(_, [by_degree, _])| *by_degree > 0.0)
        {
            let enters = by_degree * (heat / by_degree - self.at(values, place));
            self.share(place, |a, phi| add(a, phi * enters, phi * heat));
        }
        for (place, own) in &given.radiating {
            let enters = own.entering(self.at(values, *place));
            self.share(*place, |a, phi| {
                enters.into_iter().for_each(|heat| add(a, phi * heat, phi * heat));
            });
        }
        Entering { net, size, level }
    }

    /// What there is to read at parameters, held ones among them.
    pub(super) fn found(
        &self,
        system: &System,
        given: &Given,
        (values, entering): (&[f64], &Entering),
        iterations: usize,
    ) -> Temperatures {
        let leaves: Vec<f64> = entering.net.iter().map(|net| -net).collect();
        let held = system.at_held(&leaves);
        let balance = HeatBalance { held: 0.0 + held.iter().sum::<f64>(), ..self.enters(given, values) };
        let at_nodes = self.conductor.at_nodes(values);
        Temperatures { parameters: values.to_vec(), values: at_nodes, held, balance, iterations }
    }

    /// By how much less heat enters each place through its faces, by degree \[F L/(T Θ)\].
    pub(super) fn surface_slopes(&self, given: &Given, values: &[f64]) -> Vec<f64> {
        let mut slopes: Vec<f64> = given.film.iter().map(|[by_degree, _]| *by_degree).collect();
        let radiating = given.radiating.iter();
        radiating.for_each(|(place, own)| slopes[*place as usize] += own.slope(self.at(values, *place)));
        slopes
    }

    /// Heat that enters in all, but for what holds some.
    pub(super) fn enters(&self, given: &Given, values: &[f64]) -> HeatBalance {
        let through = |(place, [by_degree, heat]): (u32, &[f64; 2])| match *by_degree > 0.0 {
            true => by_degree * (heat / by_degree - self.at(values, place)),
            false => 0.0,
        };
        let film = (0..).zip(&given.film).map(through);
        let of = |(place, own): &(u32, Radiation)| own.entering(self.at(values, *place)).iter().sum::<f64>();
        let radiated = given.radiating.iter().map(of);
        // A sum of nothing is −0.
        HeatBalance {
            supplied: 0.0 + given.supplied.iter().sum::<f64>(),
            held: 0.0,
            film: 0.0 + film.sum::<f64>(),
            radiated: 0.0 + radiated.sum::<f64>(),
        }
    }

    /// Refuses places that radiate and are colder than anything.
    pub(super) fn refuse_below_zero(&self, given: &Given, values: &[f64]) -> Result<(), ConductionError> {
        match given.radiating.iter().find(|(place, own)| self.at(values, *place) < own.zero) {
            None => Ok(()),
            Some(&(place, own)) => {
                let (mut particle, mut most) = (place, f64::NEG_INFINITY);
                self.share(place, |a, phi| {
                    if phi > most {
                        (particle, most) = (a, phi);
                    }
                });
                let temperature = self.at(values, place);
                Err(ConductionError::BelowZero { particle, temperature, zero: own.zero })
            }
        }
    }
}

impl Given {
    /// Held values where there are some, elsewhere the mean of all temperatures that are given; of a body that radiates alone that at which all of it would be
    /// in balance.
    fn start(&self) -> Vec<f64> {
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
}

/// What is left of the balance of free parameters over what rounding may leave; zero where nothing runs.
fn left(system: &System, entering: &Entering) -> f64 {
    let Entering { net, size, level } = entering;
    let net = system.norm(net);
    if net > 0.0 { net / (LEFT * system.size(size) + ROUNDING * system.size(level)) } else { 0.0 }
}
