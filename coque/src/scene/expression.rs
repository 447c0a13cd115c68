//! Expressions of numbers and parameters: `2 * ${t} + sqrt(3)`.
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = factor { ("*" | "/") factor }
//! factor  = ("+" | "-") factor | power
//! power   = atom [ "^" factor ]
//! atom    = number | "${" name "}" | "pi" | function "(" sum { "," sum } ")" | "(" sum ")"
//! ```

use std::ops::Range;

use super::source::suggest;

/// Brackets, signs and powers within each other beyond which a text is taken for a mistake; bounds the recursion.
const DEEPEST: usize = 64;

/// Functions of so many numbers.
const FUNCTIONS: [(&str, Function); 12] = [
    ("sqrt", Function::One(libm::sqrt)),
    ("abs", Function::One(libm::fabs)),
    ("exp", Function::One(libm::exp)),
    ("ln", Function::One(libm::log)),
    ("sin", Function::One(libm::sin)),
    ("cos", Function::One(libm::cos)),
    ("tan", Function::One(libm::tan)),
    ("asin", Function::One(libm::asin)),
    ("acos", Function::One(libm::acos)),
    ("round", Function::One(libm::round)),
    ("min", Function::Several(f64::min)),
    ("max", Function::Several(f64::max)),
];

#[derive(Clone, Copy)]
enum Function {
    One(fn(f64) -> f64),
    /// Of two or more, taken one after another.
    Several(fn(f64, f64) -> f64),
}

/// What is wrong with an expression.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Flaw {
    /// Of the text itself.
    Text(Misread),
    /// Of the parameter that it names, found by who looked it up.
    Parameter(Box<super::error::SceneError>),
}

/// What is wrong with a text.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Misread {
    /// Bytes of the text.
    pub at: Range<usize>,
    /// What is wrong there.
    pub said: String,
    /// What to do about it.
    pub repair: String,
}

/// The value of an expression; `parameter` finds that of a name, none for one that is not there.
///
/// # Errors
/// [`Flaw`] for a text that is none, a name of no parameter, and a value that is not finite.
pub(super) fn value(
    text: &str,
    parameter: &mut dyn FnMut(&str) -> Result<Option<f64>, Flaw>,
) -> Result<f64, Flaw> {
    let mut reader = Reader { text, at: 0, deep: 0, parameter };
    let found = reader.sum()?;
    reader.skip();
    if reader.at < text.len() {
        let next = reader.token();
        let said = format!("after what stands before it, `{}` means nothing", &text[next.clone()]);
        return reader.refuse(next, &said, "join numbers by + - * / ^, or take it out");
    }
    finite(found, 0..text.len())
}

fn finite(x: f64, at: Range<usize>) -> Result<f64, Flaw> {
    if x.is_finite() {
        return Ok(x);
    }
    let said = format!("its value is {x}, no finite number");
    let repair = "see what is divided by zero, or what a root, a logarithm or a power is taken of".into();
    Err(Flaw::Text(Misread { at, said, repair }))
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    deep: usize,
    parameter: &'a mut dyn FnMut(&str) -> Result<Option<f64>, Flaw>,
}

impl<'a> Reader<'a> {
    fn refuse<T>(&self, at: Range<usize>, said: &str, repair: &str) -> Result<T, Flaw> {
        Err(Flaw::Text(Misread { at, said: said.into(), repair: repair.into() }))
    }

    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn skip(&mut self) {
        self.at += self.rest().len() - self.rest().trim_start().len();
    }

    /// Takes the next sign if it is one of these.
    fn sign(&mut self, signs: &[char]) -> Option<char> {
        self.skip();
        let next = self.rest().chars().next().filter(|next| signs.contains(next))?;
        self.at += next.len_utf8();
        Some(next)
    }

    /// The word or sign that comes next.
    fn token(&self) -> Range<usize> {
        let word = self.rest().find(|c: char| !(c.is_alphanumeric() || "_.".contains(c)));
        let len = match word.unwrap_or(self.rest().len()) {
            0 => self.rest().chars().next().map_or(0, char::len_utf8),
            len => len,
        };
        self.at..self.at + len
    }

    fn sum(&mut self) -> Result<f64, Flaw> {
        self.deep += 1;
        if self.deep > DEEPEST {
            let said = format!("brackets, signs and powers lie more than {DEEPEST} deep in each other");
            return self.refuse(self.token(), &said, "write parts of it as parameters");
        }
        let mut found = self.product()?;
        while let Some(sign) = self.sign(&['+', '-']) {
            let next = self.product()?;
            found = if sign == '+' { found + next } else { found - next };
        }
        self.deep -= 1;
        Ok(found)
    }

    fn product(&mut self) -> Result<f64, Flaw> {
        let mut found = self.factor()?;
        while let Some(sign) = self.sign(&['*', '/']) {
            let next = self.factor()?;
            found = if sign == '*' { found * next } else { found / next };
        }
        Ok(found)
    }

    fn factor(&mut self) -> Result<f64, Flaw> {
        self.deep += 1;
        if self.deep > DEEPEST {
            let said = format!("brackets, signs and powers lie more than {DEEPEST} deep in each other");
            return self.refuse(self.token(), &said, "write parts of it as parameters");
        }
        let found = match self.sign(&['+', '-']) {
            Some('-') => -self.factor()?,
            Some(_) => self.factor()?,
            None => {
                let base = self.atom()?;
                if self.sign(&['^']).is_some() { libm::pow(base, self.factor()?) } else { base }
            }
        };
        self.deep -= 1;
        Ok(found)
    }

    fn atom(&mut self) -> Result<f64, Flaw> {
        if self.sign(&['(']).is_some() {
            let found = self.sum()?;
            self.close("the bracket")?;
            return Ok(found);
        }
        if self.rest().starts_with("${") {
            return self.parameter();
        }
        let at = self.token();
        if at.is_empty() {
            return self.refuse(
                at,
                "a number is missing at its end",
                "write a number, or take the last sign out",
            );
        }
        let word = &self.text[at.clone()];
        if word.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return self.number();
        }
        if word.starts_with(char::is_alphabetic) {
            self.at = at.end;
            return self.word(word, at);
        }
        let said = format!("`{word}` stands where a number is expected");
        self.refuse(at, &said, "write a number, ${NAME}, or a bracket there")
    }

    /// A number without sign, such as `1.5e-3`.
    fn number(&mut self) -> Result<f64, Flaw> {
        let bytes = self.rest().as_bytes();
        let digits = |from: usize| {
            let more = bytes[from..].iter().take_while(|c| c.is_ascii_digit() || **c == b'_').count();
            from + more
        };
        let mut end = digits(0);
        if bytes.get(end) == Some(&b'.') {
            end = digits(end + 1);
        }
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            let power = digits(end + 1 + sign);
            if power > end + 1 + sign {
                end = power;
            }
        }
        let at = self.at..self.at + end;
        self.at = at.end;
        match self.text[at.clone()].replace('_', "").parse::<f64>() {
            Ok(x) => finite(x, at),
            Err(_) => self.refuse(at, "this is no number", "write a number such as 1.5e-3"),
        }
    }

    /// `${name}`.
    fn parameter(&mut self) -> Result<f64, Flaw> {
        let start = self.at;
        let Some(len) = self.rest().find('}') else {
            let at = start..self.text.len();
            return self.refuse(at, "`${` has no `}` after it", "a parameter is written ${NAME}");
        };
        let at = start..start + len + 1;
        self.at = at.end;
        let name = self.text[at.start + 2..at.end - 1].trim();
        match (self.parameter)(name)? {
            Some(x) => Ok(x),
            None => {
                let said = format!("there is no parameter `{name}`");
                self.refuse(at, &said, &format!("add `{name} = …` to [parameters]"))
            }
        }
    }

    /// `pi`, or a function of what stands in the brackets after it.
    fn word(&mut self, word: &str, at: Range<usize>) -> Result<f64, Flaw> {
        if word == "pi" {
            return Ok(std::f64::consts::PI);
        }
        let Some((_, function)) = FUNCTIONS.iter().find(|(name, _)| *name == word) else {
            let known: Vec<&str> = FUNCTIONS.iter().map(|(name, _)| *name).chain(["pi"]).collect();
            let said = format!("`{word}` is no function");
            let repair = format!("a parameter is written ${{{word}}}; {}", suggest(word, &known));
            return self.refuse(at, &said, &repair);
        };
        if self.sign(&['(']).is_none() {
            let said = format!("`{word}` has no brackets after it");
            return self.refuse(at, &said, &format!("write {word}(…)"));
        }
        let mut found = vec![self.sum()?];
        while self.sign(&[',']).is_some() {
            found.push(self.sum()?);
        }
        self.close(word)?;
        match (function, &found[..]) {
            (Function::One(of), [x]) => finite(of(*x), at.start..self.at),
            (Function::Several(of), [first, others @ ..]) if !others.is_empty() => {
                Ok(others.iter().fold(*first, |x, y| of(x, *y)))
            }
            (Function::One(_), _) => {
                self.refuse(at.start..self.at, &format!("`{word}` takes one number"), "take the others out")
            }
            _ => {
                let repair = format!("write {word}(…, …)");
                self.refuse(at.start..self.at, &format!("`{word}` takes two numbers or more"), &repair)
            }
        }
    }

    fn close(&mut self, of: &str) -> Result<(), Flaw> {
        if self.sign(&[')']).is_some() {
            return Ok(());
        }
        let at = self.token();
        self.refuse(at, &format!("{of} is not closed"), "write `)` here")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Result<f64, Flaw> {
        value(text, &mut |name| Ok([("t", 0.5), ("n-1", 3.0)].into_iter().find(|p| p.0 == name).map(|p| p.1)))
    }

    #[test]
    fn operators_bind_as_on_paper() {
        let cases = [
            ("1", 1.0),
            (" -2^2 ", -4.0),
            ("2^-1", 0.5),
            ("2^3^2", 512.0),
            ("1 - 2 - 3", -4.0),
            ("12 / 2 / 3", 2.0),
            ("2 + 3 * 4", 14.0),
            ("(2 + 3) * 4", 20.0),
            ("--2", 2.0),
            ("${t} * 2", 1.0),
            ("${ t }*${n-1}", 1.5),
            ("1_000.5e-1", 100.05),
            ("sqrt(16) + abs(-1)", 5.0),
            ("min(3, 1, 2) + max(3, 1)", 4.0),
            ("round(2.5)", 3.0),
            ("2*pi", std::f64::consts::TAU),
            ("sin(pi / 2) + cos(0) + tan(0) + exp(0) + ln(1)", 3.0),
            ("asin(1) + acos(1)", std::f64::consts::FRAC_PI_2),
        ];
        for (text, expected) in cases {
            assert_eq!(of(text), Ok(expected), "{text}");
        }
    }

    /// Each flaw, and the part of the text that it is found at.
    #[test]
    fn flaws_are_found_where_they_are() {
        let cases = [
            ("", "", "a number is missing at its end"),
            ("1 +", "", "a number is missing at its end"),
            ("1 2", "2", "after what stands before it, `2` means nothing"),
            ("5 mm", "mm", "after what stands before it, `mm` means nothing"),
            ("2 * t", "t", "`t` is no function"),
            ("2 * ${u}", "${u}", "there is no parameter `u`"),
            ("${t", "${t", "`${` has no `}` after it"),
            ("(1 + 2", "", "the bracket is not closed"),
            ("sqrt 2", "sqrt", "`sqrt` has no brackets after it"),
            ("sqrt(1, 2)", "sqrt(1, 2)", "`sqrt` takes one number"),
            ("min(1)", "min(1)", "`min` takes two numbers or more"),
            ("1 + sqrt(-1)", "sqrt(-1)", "its value is NaN, no finite number"),
            ("1 / 0", "1 / 0", "its value is inf, no finite number"),
            ("1e999", "1e999", "its value is inf, no finite number"),
            (".", ".", "this is no number"),
            ("2 * * 3", "*", "`*` stands where a number is expected"),
            ("2 é 3", "é", "after what stands before it, `é` means nothing"),
        ];
        for (text, place, expected) in cases {
            match of(text) {
                Err(Flaw::Text(Misread { at, said, .. })) => {
                    assert_eq!((&text[at], said.as_str()), (place, expected), "{text}");
                }
                other => panic!("{text}: {other:?}"),
            }
        }
        for deep in ["(".repeat(10_000), "-".repeat(10_000), "2^".repeat(10_000)] {
            assert!(matches!(of(&deep), Err(Flaw::Text(_))));
        }
    }
}
