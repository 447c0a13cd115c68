//! Doubts about a number: what may be wrong with a result, and the figure that says so.

use serde::{Deserialize, Serialize};

/// What is doubtful, as a word that a script can look for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Doubt {
    /// A load level was left before the motion had died.
    NotSettled,
    /// Equilibria were found that are unstable.
    Unstable,
    /// A critical point was passed, and what follows is not what the shell would do.
    PassedCritical,
    /// The loads have no potential: part of their stiffness is skew, and the tangent leaves it out.
    NoPotential,
}

impl Doubt {
    /// The word, as `summary.json` has it.
    pub fn word(self) -> &'static str {
        match self {
            Self::NotSettled => "not-settled",
            Self::Unstable => "unstable",
            Self::PassedCritical => "passed-critical",
            Self::NoPotential => "no-potential",
        }
    }
}

/// A number that may be wrong, and why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Warning {
    /// What is doubtful.
    pub doubt: Doubt,
    /// What was found, its bound and the repair, in one sentence.
    pub message: String,
}

impl Warning {
    /// A warning with its message.
    pub fn new(doubt: Doubt, message: impl Into<String>) -> Self {
        Self { doubt, message: message.into() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_word_is_the_one_in_the_summary() {
        for doubt in [Doubt::NotSettled, Doubt::Unstable, Doubt::PassedCritical, Doubt::NoPotential] {
            assert_eq!(serde_json::to_value(doubt).unwrap(), doubt.word());
        }
    }
}
