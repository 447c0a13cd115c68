//! Heat that runs between the parameters of a body: temperatures in balance, and in time.
//!
//! ```text
//! C Ṫ = −K T + s + Σ φ h A (T_∞ − φ·T) + Σ φ ε σ A (T_s⁴ − (φ·T)⁴)        C Ṫ = 0 in balance, T⁴ from absolute zero
//! ```
//!
//! A model says what runs between its parameters by its matrix K ([`Conducts`]), whose rows sum to zero: differences alone make heat run. What enters through faces enters at
//! places, where the temperature is a sum φ·T of parameters; of most models each parameter is a place. Nodes may be held at temperatures; where a parameter is not the temperature
//! of its node the model solves for as many parameters as nodes are held ([`Eliminated`]).
//!
//! The heat that enters a parameter is a derivative of a convex function of the temperatures, so that there is one answer, and Newton's method finds it; without
//! radiation in one solve ([`Conduction::steady`]). What conducts by its temperature is taken in each solve from the one before. In time [`HeatCourse`] leads.

#![deny(clippy::print_stdout, clippy::print_stderr)]

mod capacity;
mod course;
mod error;
mod given;
mod network;
mod radiation;
mod steady;
mod system;

use explicit_dynamics::Amplitude;

pub use capacity::Capacity;
pub use course::HeatCourse;
pub use error::ConductionError;
use given::{Changing, Given, What};
pub use network::Network;
pub use radiation::Radiation;
pub use steady::{HeatBalance, Temperatures};

/// An entry of the matrix of what conducts: heat that leaves a row by degree of a column \[F L/(T Θ)\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Parameter that the heat leaves.
    pub row: u32,
    /// Parameter that makes it run.
    pub column: u32,
    /// Heat by degree, without the factor \[F L/(T Θ)\].
    pub value: f64,
    /// By which it goes with the temperature \[–\].
    pub factor: f64,
}

/// A parameter that others and what nodes are held at determine.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Eliminated {
    /// The parameter.
    pub parameter: u32,
    /// Parameters that are not eliminated, with their weights \[–\].
    pub terms: Vec<(u32, f64)>,
    /// Nodes that are held, with the weights of their temperatures \[–\].
    pub moves: Vec<(u32, f64)>,
}

/// What conducts heat between its parameters.
pub trait Conducts {
    /// Number of parameters, as many as nodes.
    fn parameters(&self) -> usize;

    /// Visits all entries of a symmetric matrix whose rows sum to zero, in a fixed order and some of them in parts, at temperatures \[Θ\].
    fn visit(&self, temperatures: &[f64], found: impl FnMut(Entry));

    /// Whether factors go with the temperature.
    fn goes_with_temperature(&self) -> bool {
        false
    }

    /// Refuses temperatures at which it is not known how it conducts.
    ///
    /// # Errors
    /// [`ConductionError::Table`].
    fn refuse_beyond_tables(&self, _temperatures: &[f64]) -> Result<(), ConductionError> {
        Ok(())
    }

    /// The parameters for which holding these nodes, ascending, is solved; none where each parameter is the temperature of its node.
    fn eliminate(&self, _held: &[u32]) -> Option<Vec<Eliminated>> {
        None
    }

    /// Temperatures of nodes \[Θ\].
    fn at_nodes(&self, parameters: &[f64]) -> Vec<f64> {
        parameters.to_vec()
    }
}

/// What conducts heat, with what holds and feeds it.
#[derive(Clone, Debug)]
pub struct Conduction<C> {
    conductor: C,
    /// Parameters and their weights at each place through which heat enters; none where parameters are the places.
    places: Option<Vec<Vec<(u32, f64)>>>,
    /// What is given whenever it is, and how films and radiation join places to what goes by a course.
    given: Given,
    changing: Vec<Changing>,
    courses: Vec<Amplitude>,
    /// The one by which goes what is given now.
    course: Option<usize>,
}

impl<C: Conducts> Conduction<C> {
    /// Nothing given yet; heat enters at parameters.
    pub fn new(conductor: C) -> Self {
        let count = conductor.parameters();
        let given = Given::none(count, count);
        Self { conductor, places: None, given, changing: Vec::new(), courses: Vec::new(), course: None }
    }

    /// The same where heat enters at places of their own ([`Conduction::place`]).
    pub fn with_places(conductor: C) -> Self {
        let given = Given::none(conductor.parameters(), 0);
        Self { places: Some(Vec::new()), given, ..Self::new(conductor) }
    }

    /// What conducts.
    pub fn conductor(&self) -> &C {
        &self.conductor
    }

    /// The same, to be changed.
    pub fn conductor_mut(&mut self) -> &mut C {
        &mut self.conductor
    }

    /// Another place through which heat enters, by its parameters and their weights; its number.
    pub fn place(&mut self, parts: Vec<(u32, f64)>) -> u32 {
        let places = self.places.get_or_insert_default();
        places.push(parts);
        self.given.film.push([0.0; 2]);
        places.len() as u32 - 1
    }

    /// Lets temperatures and heat that are given from here on go by a course in time, which multiplies them; film coefficients and emissivities stay. Returns the
    /// one before, for [`Conduction::end_course`].
    pub fn begin_course(&mut self, course: Amplitude) -> Option<usize> {
        let before = self.course.replace(self.courses.len());
        self.courses.push(course);
        before
    }

    /// Ends a course.
    pub fn end_course(&mut self, before: Option<usize>) {
        self.course = before;
    }

    /// Holds nodes at a temperature \[Θ\].
    ///
    /// # Errors
    /// [`ConductionError::Contradiction`] for one that is held at another already, or by another course.
    pub fn hold(&mut self, nodes: &[u32], temperature: f64) -> Result<(), ConductionError> {
        let own = self.course.map(|course| (&self.courses[course], temperature));
        let start = own.map_or(temperature, |(course, _)| course.value(0.0) * temperature);
        for &node in nodes {
            let held = self.given.held[node as usize];
            if let Some(other) = held.filter(|&other| other != start || self.holds(node) != own) {
                return Err(ConductionError::Contradiction { particle: node, temperatures: [other, start] });
            }
        }
        for &node in nodes {
            self.given.held[node as usize] = Some(start);
            self.goes_by_course(node, temperature, What::Held);
        }
        Ok(())
    }

    /// By which course a node is held, and at what.
    fn holds(&self, node: u32) -> Option<(&Amplitude, f64)> {
        let own = self.changing.iter().find(|own| own.at == node && own.what == What::Held)?;
        Some((&self.courses[own.course], own.number))
    }

    /// Whether what is given goes by a course; notes it.
    fn goes_by_course(&mut self, at: u32, number: f64, what: What) -> bool {
        self.changing.extend(self.course.map(|course| Changing { course, at, number, what }));
        self.course.is_some()
    }

    /// Supplies heat to a parameter \[F L/T\].
    pub fn supply(&mut self, parameter: u32, heat: f64) {
        if !self.goes_by_course(parameter, heat, What::Supplied) {
            self.given.supplied[parameter as usize] += heat;
        }
    }

    /// A film between a place and something of an ambient temperature \[Θ\], by its coefficient times area \[F L/(T Θ)\].
    pub fn film(&mut self, place: u32, by_degree: f64, ambient: f64) {
        self.given.film[place as usize][0] += by_degree;
        if !self.goes_by_course(place, by_degree * ambient, What::Film) {
            self.given.film[place as usize][1] += by_degree * ambient;
        }
    }

    /// A place that radiates, its factor times its area.
    pub fn radiate(&mut self, place: u32, radiation: Radiation) {
        self.goes_by_course(place, radiation.surroundings, What::Surroundings(self.given.radiating.len()));
        self.given.radiating.push((place, radiation));
    }

    /// Whether something tells the temperature at each parameter: its node is held, or there is a film or radiation.
    pub fn known(&self) -> Vec<bool> {
        let Given { held, film, radiating, .. } = &self.given;
        let mut known: Vec<bool> = held.iter().map(Option::is_some).collect();
        let radiating = radiating.iter().filter(|(_, own)| own.factor > 0.0).map(|(place, _)| *place);
        let films = (0..).zip(film).filter(|(_, film)| film[0] > 0.0).map(|(place, _)| place);
        for place in radiating.chain(films) {
            self.share(place, |a, _| known[a as usize] = true);
        }
        known
    }

    /// The first parameter of a piece, of which these are lists, whose temperature nothing tells.
    pub fn untold(&self, pieces: &[Vec<u32>]) -> Option<u32> {
        let known = self.known();
        pieces
            .iter()
            .find(|piece| piece.iter().all(|&a| !known[a as usize]))
            .and_then(|piece| piece.first().copied())
    }

    /// The temperature at a place.
    fn at(&self, values: &[f64], place: u32) -> f64 {
        match &self.places {
            None => values[place as usize],
            Some(places) => places[place as usize].iter().map(|&(a, phi)| phi * values[a as usize]).sum(),
        }
    }

    /// Parameters and weights of a place.
    fn share(&self, place: u32, mut found: impl FnMut(u32, f64)) {
        match &self.places {
            None => found(place, 1.0),
            Some(places) => places[place as usize].iter().for_each(|&(a, phi)| found(a, phi)),
        }
    }
}
