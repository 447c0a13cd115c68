//! The questions of `coque new`: choices by number or word, the first one where nothing is said.

use std::io::{self, BufRead, Write};

use super::starter::{Choice, Length, Starter, What};

/// Asks what scene is wanted. The end of the input is an empty answer.
///
/// # Errors
/// Those of reader and writer.
pub fn ask(from: &mut dyn BufRead, to: &mut dyn Write) -> io::Result<Starter> {
    let what = choice("What is it made of?", &What::ALL, from, to)?;
    let asked = choice("What is asked?", what.asked(), from, to)?;
    let length = choice("In which units?", &Length::ALL, from, to)?;
    Ok(Starter { what, asked, length })
}

/// Whether the answer is yes; no where nothing is said.
///
/// # Errors
/// Those of reader and writer.
pub fn agreed(question: &str, from: &mut dyn BufRead, to: &mut dyn Write) -> io::Result<bool> {
    write!(to, "{question} [y/N] ")?;
    Ok(matches!(line(from, to)?.as_str(), "y" | "yes"))
}

/// One of several; a lone one is not asked for.
fn choice<C: Choice>(
    question: &str,
    all: &'static [C],
    from: &mut dyn BufRead,
    to: &mut dyn Write,
) -> io::Result<C> {
    if let [only] = all {
        writeln!(to, "{question} {}", only.words().1)?;
        return Ok(*only);
    }
    writeln!(to, "{question}")?;
    for (number, one) in all.iter().enumerate() {
        let (word, meaning) = one.words();
        writeln!(to, "  {}  {word:<12} {meaning}", number + 1)?;
    }
    loop {
        write!(to, "number or word [{}]: ", all[0].words().0)?;
        match line(from, to)?.as_str() {
            "" => return Ok(all[0]),
            said => match chosen(said, all) {
                Some(one) => return Ok(one),
                None => writeln!(to, "`{said}` is none of them, or several")?,
            },
        }
    }
}

/// The choice of that number, or the one whose word begins like that; an exact word comes first.
fn chosen<C: Choice>(said: &str, all: &[C]) -> Option<C> {
    if let Ok(number) = said.parse::<usize>() {
        return all.get(number.checked_sub(1)?).copied();
    }
    let word = |one: &&C| one.words().0;
    if let Some(exact) = all.iter().find(|one| word(one) == said) {
        return Some(*exact);
    }
    let mut alike = all.iter().filter(|one| word(one).starts_with(said));
    alike.next().filter(|_| alike.next().is_none()).copied()
}

/// An answer, without case and blanks; empty at the end of the input.
fn line(from: &mut dyn BufRead, to: &mut dyn Write) -> io::Result<String> {
    to.flush()?;
    let mut said = String::new();
    if from.read_line(&mut said)? == 0 {
        writeln!(to)?;
    }
    Ok(said.trim().to_lowercase())
}

#[cfg(test)]
mod tests {
    use super::super::starter::Asked;
    use super::*;

    fn answered(said: &str) -> (Starter, String) {
        let mut heard = Vec::new();
        let starter = ask(&mut said.as_bytes(), &mut heard).unwrap();
        (starter, String::from_utf8(heard).unwrap())
    }

    #[test]
    fn answers_are_numbers_or_words() {
        let wanted = Starter { what: What::Panel, asked: Asked::Modes, length: Length::Millimetre };
        for said in ["2\n3\n2\n", "panel\nmodes\nmm\n", " Pan \nMODE\nmm\n", "9\npa\nm\nmod\nmm\n"] {
            // `m` alone is modes or motion.
            assert_eq!(answered(said).0, wanted, "{said:?}");
        }
    }

    #[test]
    fn the_end_of_the_input_takes_what_is_usual() {
        let usual = Starter { what: What::Plate, asked: Asked::Equilibrium, length: Length::Metre };
        assert_eq!((answered("").0, answered("\n\n\n").0), (usual, usual));
        let (starter, heard) = answered("fluid\n");
        assert_eq!((starter.asked, starter.length), (Asked::Motion, Length::Metre));
        // Of a fluid there is one question, which is answered.
        assert!(heard.contains("What is asked? how it moves in time\n"), "{heard}");
    }

    #[test]
    fn what_is_not_understood_is_asked_again() {
        let (starter, heard) = answered("p\n0\ncyl\n\n\n");
        assert_eq!((starter.what, starter.asked), (What::Cylinder, Asked::Buckling));
        assert_eq!(heard.matches("is none of them").count(), 2);
        let mut to = Vec::new();
        for (said, yes) in [("y\n", true), ("Yes\n", true), ("", false), ("\n", false), ("n\n", false)] {
            assert_eq!(agreed("Run it?", &mut said.as_bytes(), &mut to).unwrap(), yes, "{said:?}");
        }
    }
}
