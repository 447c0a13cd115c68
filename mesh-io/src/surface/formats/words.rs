//! Words of a text with the line they stand on.

use crate::input::shortened;
use crate::surface::MeshError;

/// Reads a text word by word; nothing that it returns is larger than the text.
#[derive(Clone, Debug)]
pub(super) struct Words<'a> {
    rest: &'a str,
    /// Line of the last word, from 1.
    pub line: usize,
}

impl<'a> Words<'a> {
    pub fn new(text: &'a str) -> Self {
        Self { rest: text, line: 1 }
    }

    /// The next word of any line.
    pub fn next(&mut self) -> Option<&'a str> {
        let start = self.rest.find(|c: char| !c.is_whitespace())?;
        self.line += self.rest[..start].matches('\n').count();
        let word = &self.rest[start..];
        let end = word.find(char::is_whitespace).unwrap_or(word.len());
        self.rest = &word[end..];
        Some(&word[..end])
    }

    /// What is left of the line of the last word.
    pub fn rest_of_line(&mut self) -> &'a str {
        let end = self.rest.find('\n').unwrap_or(self.rest.len());
        let line = &self.rest[..end];
        self.rest = &self.rest[end..];
        line.trim()
    }

    /// The next word, which `what` says must be there.
    pub fn word(&mut self, what: &str) -> Result<&'a str, MeshError> {
        self.next().ok_or_else(|| {
            let what = format!("the file ends where {what} should stand");
            MeshError::at(self.line, what, "the file is cut off: write it again")
        })
    }

    /// The next word as a finite number.
    pub fn float(&mut self, what: &str) -> Result<f64, MeshError> {
        let word = self.word(what)?;
        float(self.line, what, word)
    }

    /// The next word as a whole number, zero or more.
    pub fn count(&mut self, what: &str) -> Result<u64, MeshError> {
        let word = self.word(what)?;
        count(self.line, what, word)
    }

    /// The next three words as a vector.
    pub fn vector(&mut self, what: &str) -> Result<[f64; 3], MeshError> {
        Ok([self.float(what)?, self.float(what)?, self.float(what)?])
    }

    /// Passes over everything up to and with the word `end`.
    pub fn skip_to(&mut self, end: &str) -> Result<(), MeshError> {
        let start = self.line;
        while let Some(word) = self.next() {
            if word == end {
                return Ok(());
            }
        }
        let what = format!("the section that begins here has no {end}");
        Err(MeshError::at(start, what, "the file is cut off: write it again"))
    }
}

/// A finite number from a word.
pub(super) fn float(line: usize, what: &str, word: &str) -> Result<f64, MeshError> {
    word.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| {
        let what = format!("{what} is \"{}\"; it must be a finite number", shortened(word));
        MeshError::at(line, what, "write a number such as 1.5e3")
    })
}

/// A whole number from a word.
pub(super) fn count(line: usize, what: &str, word: &str) -> Result<u64, MeshError> {
    word.parse().map_err(|_| {
        let what = format!("{what} is \"{}\"; it must be a whole number, zero or more", shortened(word));
        MeshError::at(line, what, "write a number such as 12")
    })
}
