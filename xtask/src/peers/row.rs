//! One comparison: ours and the other code on the same problem, first whether they agree, then how long each takes, in turn.

use super::place::Place;
use super::reading::{Found, Reading};

/// Another code.
#[derive(Clone, Copy)]
pub struct Peer {
    pub name: &'static str,
    /// What installs it.
    pub install: &'static str,
    /// Whether it takes more threads than one.
    pub threaded: bool,
    /// The program and its version, if it is installed.
    pub find: fn(&Place) -> Option<Found>,
}

/// What one side runs.
pub struct Side {
    /// Its lattice, mesh or method.
    pub by: String,
    pub run: Run,
}

/// A run of one side; of the other code its program, of ours coque's.
pub type Run = Box<dyn Fn(&Place, &Found) -> Result<Reading, String>>;

/// A problem, what both run, and how far their answers may differ.
pub struct Comparison {
    pub problem: &'static str,
    pub peer: Peer,
    /// Of the costs, such as s.
    pub unit: &'static str,
    /// What the answers are, with a reference where there is one.
    pub answers: &'static str,
    /// How far any answer may be from the other side's \[%\].
    pub share: f64,
    pub ours: Side,
    pub theirs: Side,
}

/// How a comparison ended.
pub enum Outcome {
    NotInstalled,
    Failed(String),
    /// Answers are further apart than allowed: one run of each, no times.
    Apart {
        ours: Reading,
        theirs: Reading,
    },
    /// Runs in turn.
    Timed {
        ours: Vec<Reading>,
        theirs: Vec<Reading>,
    },
}

impl Comparison {
    /// Whether its problem or its code contains the text.
    pub fn is_named(&self, filter: Option<&str>) -> bool {
        let holds = |name: &str, text: &str| name.to_lowercase().contains(&text.to_lowercase());
        filter.is_none_or(|text| holds(self.problem, text) || holds(self.peer.name, text))
    }

    /// One run of each for the answers; if they agree, `times` runs in turn.
    pub fn run(&self, place: &Place, times: u32) -> Outcome {
        match (self.peer.find)(place) {
            None => Outcome::NotInstalled,
            Some(found) => self.measured(place, &found, times).unwrap_or_else(Outcome::Failed),
        }
    }

    fn measured(&self, place: &Place, found: &Found, times: u32) -> Result<Outcome, String> {
        let ours = (self.ours.run)(place, found)?;
        let theirs = (self.theirs.run)(place, found)?;
        if apart(&ours.answers, &theirs.answers).is_none_or(|apart| apart > self.share) {
            return Ok(Outcome::Apart { ours, theirs });
        }
        let (mut ours, mut theirs) = (Vec::new(), Vec::new());
        for _ in 0..times {
            ours.push((self.ours.run)(place, found)?);
            theirs.push((self.theirs.run)(place, found)?);
        }
        Ok(Outcome::Timed { ours, theirs })
    }
}

/// The greatest difference of two lists of answers, each over ours \[%\]; none where they cannot be compared.
pub fn apart(ours: &[f64], theirs: &[f64]) -> Option<f64> {
    if ours.is_empty() || ours.len() != theirs.len() {
        return None;
    }
    let each: Vec<f64> =
        ours.iter().zip(theirs).map(|(ours, theirs)| 100.0 * (theirs / ours - 1.0).abs()).collect();
    each.iter().all(|one| one.is_finite()).then(|| each.into_iter().fold(0.0, f64::max))
}

/// The middle one of some numbers, the mean of both where two are.
pub fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    match numbers.len() {
        0 => f64::NAN,
        n => 0.5 * (numbers[(n - 1) / 2] + numbers[n / 2]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_compared_one_by_one() {
        assert_eq!(apart(&[2.0, 4.0], &[2.0, 5.0]), Some(25.0));
        assert_eq!(apart(&[1.0], &[1.0, 2.0]), None);
        assert_eq!(apart(&[], &[]), None);
        assert_eq!(apart(&[1.0, 1.0], &[f64::NAN, 1.0]), None);
        assert_eq!(apart(&[0.0], &[1.0]), None);
    }

    #[test]
    fn medians_stand_in_the_middle() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(vec![4.0, 1.0]), 2.5);
    }
}
