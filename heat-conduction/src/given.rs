//! What is given to nodes, parameters and places: always, or by a course in time.

use super::{Conduction, Conducts, Radiation};

/// What holds nodes and gives heat at some time.
#[derive(Clone, Debug)]
pub(super) struct Given {
    /// By node \[Θ\].
    pub held: Vec<Option<f64>>,
    /// Heat that is supplied to each parameter \[F L/T\].
    pub supplied: Vec<f64>,
    /// Film coefficient times area of each place \[F L/(T Θ)\], and the same times the ambient temperature \[F L/T\].
    pub film: Vec<[f64; 2]>,
    /// Places that radiate, with the factor times the area.
    pub radiating: Vec<(u32, Radiation)>,
}

impl Given {
    /// Nothing on so many parameters and places.
    pub fn none(parameters: usize, places: usize) -> Self {
        Self {
            held: vec![None; parameters],
            supplied: vec![0.0; parameters],
            film: vec![[0.0; 2]; places],
            radiating: Vec::new(),
        }
    }
}

/// What of it goes by a course.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    /// A temperature \[Θ\].
    Held,
    /// Heat \[F L/T\].
    Supplied,
    /// Coefficient times area times the ambient temperature \[F L/T\].
    Film,
    /// Temperature of what surrounds a place that radiates, by its number \[Θ\].
    Surroundings(usize),
}

/// A number that a course multiplies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Changing {
    pub course: usize,
    /// Node, parameter or place.
    pub at: u32,
    pub number: f64,
    pub what: What,
}

impl<C: Conducts> Conduction<C> {
    /// What is given at a time \[T\].
    pub(super) fn given_at(&self, time: f64) -> Given {
        let mut given = self.given.clone();
        let factors: Vec<f64> = self.courses.iter().map(|course| course.value(time)).collect();
        for own in &self.changing {
            let (a, number) = (own.at as usize, factors[own.course] * own.number);
            match own.what {
                What::Held => given.held[a] = Some(number),
                What::Supplied => given.supplied[a] += number,
                What::Film => given.film[a][1] += number,
                What::Surroundings(i) => given.radiating[i].1.surroundings = number,
            }
        }
        given
    }
}
