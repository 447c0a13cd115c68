//! A surface as a file: Abaqus `.inp` with its sets, which [`crate::surface::read`] reads back to the same numbers.

use std::io::{self, Write};

use super::Arrays;

/// Numbers of a set in a line.
const IN_A_LINE: usize = 12;

impl Arrays {
    /// Writes the surface as Abaqus input: nodes, triangles and quadrangles in the order of the faces, sets of nodes and of faces by name.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_inp(&self, to: &mut dyn Write) -> io::Result<()> {
        writeln!(to, "*Node")?;
        for (number, [x, y, z]) in (1..).zip(&self.points) {
            writeln!(to, "{number}, {x:?}, {y:?}, {z:?}")?;
        }
        let mut kind = "";
        for (number, &[a, b, c, d]) in (1..).zip(&self.faces) {
            let own = if c == d { "S3" } else { "S4" };
            if own != kind {
                writeln!(to, "*Element, type={own}")?;
                kind = own;
            }
            let fourth = if c == d { String::new() } else { format!(", {}", d + 1) };
            writeln!(to, "{number}, {}, {}, {}{fourth}", a + 1, b + 1, c + 1)?;
        }
        for (keyword, key, sets) in [("Nset", "nset", &self.sets), ("Elset", "elset", &self.face_sets)] {
            for (name, members) in sets {
                writeln!(to, "*{keyword}, {key}={name}")?;
                for line in members.chunks(IN_A_LINE) {
                    let numbers: Vec<String> = line.iter().map(|member| (member + 1).to_string()).collect();
                    writeln!(to, "{}", numbers.join(", "))?;
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::surface::{Format, parse};

    #[test]
    fn what_is_written_reads_back() {
        let arrays = Arrays {
            points: [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 1.0], [1.0, 1.0 / 3.0], [2.0, 1.0]]
                .map(|[x, y]| [x, y, 1e-17 * x])
                .into(),
            faces: vec![[0, 1, 4, 3], [1, 2, 4, 4], [2, 5, 4, 4]],
            sets: BTreeMap::from([("left edge".into(), vec![0, 3])]),
            face_sets: BTreeMap::from([("Tip".into(), vec![1, 2])]),
        };
        let mut text = Vec::new();
        arrays.write_inp(&mut text).unwrap();
        let read = parse("own", Format::Abaqus, &text).unwrap();
        let own = arrays.surface("own", false).unwrap();
        assert_eq!(read.positions, own.positions);
        assert_eq!(read.faces, own.faces);
        assert_eq!((read.set("left edge"), read.set("Tip")), (own.set("left edge"), own.set("Tip")));
        assert_eq!(read.face_sets, own.face_sets);
    }
}
