//! Whatever is done to a mesh file, reading it ends in a surface or in a refusal, never in a panic or without end.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::Path;

use mesh_io::surface::{Format, MeshError, Surface, parse, parse_body, report};
use proptest::prelude::*;

const FILES: [&str; 12] = [
    "plate-22.msh",
    "plate-41.msh",
    "plate.inp",
    "plate.stl",
    "plate-binary.stl",
    "plate.obj",
    "plate.ply",
    "plate-binary.ply",
    "plate-ascii.vtu",
    "plate-binary.vtu",
    "plate.csv",
    "cube-22.msh",
];

/// Words that break things.
const WORDS: [&str; 16] = [
    "nan",
    "-1",
    "0",
    "1e400",
    "1e29",
    "1e-300",
    "18446744073709551615",
    "9223372036854775807",
    "4294967295",
    "5",
    "2",
    "*Element, type=S4",
    "$Elements",
    "f 1 2 3",
    "\"",
    ",",
];

#[derive(Clone, Debug)]
enum Damage {
    /// Drops a line.
    Line(usize),
    /// Doubles a line.
    Double(usize),
    /// Swaps two lines.
    Swap(usize, usize),
    /// Puts a word in the place of another one.
    Word(usize, usize),
    /// Changes a byte.
    Byte(usize, u8),
    /// Cuts the file off.
    Cut(usize),
}

fn damage() -> impl Strategy<Value = Damage> {
    prop_oneof![
        2 => any::<usize>().prop_map(Damage::Line),
        1 => any::<usize>().prop_map(Damage::Double),
        1 => (any::<usize>(), any::<usize>()).prop_map(|(a, b)| Damage::Swap(a, b)),
        6 => (any::<usize>(), any::<usize>()).prop_map(|(at, which)| Damage::Word(at, which)),
        4 => (any::<usize>(), any::<u8>()).prop_map(|(at, byte)| Damage::Byte(at, byte)),
        1 => any::<usize>().prop_map(Damage::Cut),
    ]
}

fn apply(bytes: &[u8], damage: &Damage) -> Vec<u8> {
    let mut lines: Vec<&[u8]> = bytes.split(|&b| b == b'\n').collect();
    let count = lines.len();
    match *damage {
        Damage::Line(at) => {
            lines.remove(at % count);
        }
        Damage::Double(at) => lines.insert(at % count, lines[at % count]),
        Damage::Swap(a, b) => lines.swap(a % count, b % count),
        Damage::Word(at, which) => return replace_word(bytes, at, WORDS[which % WORDS.len()]),
        Damage::Byte(at, byte) => {
            let mut bytes = bytes.to_vec();
            let count = bytes.len().max(1);
            if let Some(slot) = bytes.get_mut(at % count) {
                *slot = byte;
            }
            return bytes;
        }
        Damage::Cut(at) => return bytes[..at % (bytes.len() + 1)].to_vec(),
    }
    lines.join(&b'\n')
}

/// Replaces one run of bytes between blanks and commas.
fn replace_word(bytes: &[u8], at: usize, by: &str) -> Vec<u8> {
    let part = |b: u8| !b.is_ascii_whitespace() && b != b',';
    let starts: Vec<usize> =
        (0..bytes.len()).filter(|&i| part(bytes[i]) && (i == 0 || !part(bytes[i - 1]))).collect();
    let Some(&start) = starts.get(at % starts.len().max(1)) else { return bytes.to_vec() };
    let end = (start..bytes.len()).find(|&i| !part(bytes[i])).unwrap_or(bytes.len());
    [&bytes[..start], by.as_bytes(), &bytes[end..]].concat()
}

fn check(file: &str, format: Format, bytes: &[u8]) -> Result<(), TestCaseError> {
    for read in [parse, parse_body] {
        sound_or_refused(file, bytes, read(file, format, bytes))?;
    }
    Ok(())
}

fn sound_or_refused(
    file: &str,
    bytes: &[u8],
    found: Result<Surface, MeshError>,
) -> Result<(), TestCaseError> {
    match found {
        Ok(surface) => {
            // Nothing is larger than what was read.
            prop_assert!(surface.positions.len() <= bytes.len() && surface.faces.len() <= bytes.len());
            prop_assert!(
                surface.sets.values().map(Vec::len).sum::<usize>()
                    <= bytes.len() * surface.faces.len().max(1)
            );
            match report(&surface, |_| Vec::new()) {
                Ok(text) => prop_assert!(text.lines().count() >= 5),
                Err(error) => prop_assert!(error.file == file && !error.repair.is_empty(), "{error:?}"),
            }
        }
        Err(error) => {
            prop_assert!(
                error.file == file && !error.what.is_empty() && !error.repair.is_empty(),
                "{error:?}"
            );
            let lines = bytes.split(|&b| b == b'\n').count();
            prop_assert!(error.line.is_none_or(|line| (1..=lines).contains(&line)), "{error:?}");
            prop_assert!(error.to_string().len() < 2000, "{error}");
        }
    }
    Ok(())
}

proptest! {
    // The same files on every run.
    #![proptest_config(ProptestConfig {
        cases: 4096,
        rng_seed: proptest::test_runner::RngSeed::Fixed(1),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn damaged_meshes_never_panic(number in 0..FILES.len(), damages in prop::collection::vec(damage(), 1..4)) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/meshes").join(FILES[number]);
        let format = Format::of(&path).unwrap();
        let bytes = damages.iter().fold(fs::read(path).unwrap(), |bytes, damage| apply(&bytes, damage));
        check(FILES[number], format, &bytes)?;
        // A file under a foreign name is refused as well.
        let other = Format::ALL[number % Format::ALL.len()];
        check(FILES[number], other, &bytes)?;
    }

    #[test]
    fn any_bytes_never_panic(format in 0..Format::ALL.len(), bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        check("bytes", Format::ALL[format], &bytes)?;
    }
}
