//! The VTU format: XML with arrays in base64, little-endian, each behind its length in bytes.
//!
//! Version 1.0 with `header_type="UInt64"`, arrays in place: what ParaView, VisIt and meshio all read. Numbers are
//! copied as they stand into one block at a time; nothing is formatted number by number and nothing is held whole.

use std::io::{self, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Bytes encoded at a time: a multiple of 3, so that only the end is padded, and of 8, so that it fills up evenly.
const BLOCK: usize = 24 * 2048;

/// A number as it stands in an array.
pub(crate) trait Scalar: Copy {
    /// Its name in the format.
    const NAME: &'static str;
    /// Bytes.
    const SIZE: usize;
    /// Copies it, little end first.
    fn put(self, to: &mut [u8]);
}

macro_rules! scalar {
    ($type:ty, $name:literal) => {
        impl Scalar for $type {
            const NAME: &'static str = $name;
            const SIZE: usize = size_of::<$type>();

            #[inline(always)]
            fn put(self, to: &mut [u8]) {
                to.copy_from_slice(&self.to_le_bytes());
            }
        }
    };
}

scalar!(f64, "Float64");
scalar!(f32, "Float32");
scalar!(u64, "UInt64");
scalar!(i32, "Int32");
scalar!(u8, "UInt8");

/// Kinds of cells, by their numbers in the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Vertex = 1,
    Line = 3,
    Triangle = 5,
    Quadrangle = 9,
    Hexahedron = 12,
    Wedge = 13,
}

/// A file under way. Sections are opened and closed in the order of the format by the caller.
pub(crate) struct Vtu<W> {
    to: W,
    raw: Vec<u8>,
    filled: usize,
    text: Vec<u8>,
}

impl<W: Write> Vtu<W> {
    /// Begins a file.
    pub fn begin(to: W) -> io::Result<Self> {
        let mut file = Self { to, raw: vec![0; BLOCK], filled: 0, text: vec![0; BLOCK / 3 * 4] };
        file.line("<?xml version=\"1.0\"?>")?;
        file.line(
            "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">",
        )?;
        file.line("<UnstructuredGrid>")?;
        Ok(file)
    }

    /// Ends the file and hands back what it was written to.
    pub fn end(mut self) -> io::Result<W> {
        self.line("</UnstructuredGrid>\n</VTKFile>")?;
        Ok(self.to)
    }

    /// A line of XML.
    pub fn line(&mut self, text: &str) -> io::Result<()> {
        writeln!(self.to, "{text}")
    }

    /// One number for the whole file.
    pub fn single(&mut self, name: &str, value: f64) -> io::Result<()> {
        self.data(name, "NumberOfTuples=\"1\"", [[value]].into_iter())
    }

    /// An array of single numbers with a unit (`-` for none), such as `connectivity`.
    pub fn list<T: Scalar>(
        &mut self,
        name: &str,
        unit: &str,
        values: impl ExactSizeIterator<Item = T>,
    ) -> io::Result<()> {
        self.data(name, &unit_attribute(unit), values.map(|value| [value]))
    }

    /// An array of rows with a unit and a name for each component; no names for x, y, z.
    pub fn rows<T: Scalar, const N: usize>(
        &mut self,
        name: &str,
        unit: &str,
        components: [&str; N],
        rows: impl ExactSizeIterator<Item = [T; N]>,
    ) -> io::Result<()> {
        let mut attributes = format!("NumberOfComponents=\"{N}\"{}", unit_attribute(unit));
        for (i, component) in components.iter().enumerate().filter(|(_, name)| !name.is_empty()) {
            attributes += &format!(" ComponentName{i}=\"{component}\"");
        }
        self.data(name, &attributes, rows)
    }

    fn data<T: Scalar, const N: usize>(
        &mut self,
        name: &str,
        attributes: &str,
        rows: impl ExactSizeIterator<Item = [T; N]>,
    ) -> io::Result<()> {
        let kind = T::NAME;
        writeln!(self.to, "<DataArray type=\"{kind}\" Name=\"{name}\" {attributes} format=\"binary\">")?;
        self.put((rows.len() * N * T::SIZE) as u64)?;
        for row in rows {
            for value in row {
                self.put(value)?;
            }
        }
        self.flush()?;
        self.line("\n</DataArray>")
    }

    #[inline(always)]
    fn put<T: Scalar>(&mut self, value: T) -> io::Result<()> {
        // The length in front has eight bytes; shorter numbers behind it fill the block evenly too.
        if self.filled == BLOCK {
            self.flush()?;
        }
        value.put(&mut self.raw[self.filled..self.filled + T::SIZE]);
        self.filled += T::SIZE;
        Ok(())
    }

    /// Encodes what has gathered; padded if it is no multiple of three, which only the end of an array is.
    fn flush(&mut self) -> io::Result<()> {
        let raw = &self.raw[..self.filled];
        let length = STANDARD.encode_slice(raw, &mut self.text).map_err(io::Error::other)?;
        self.filled = 0;
        self.to.write_all(&self.text[..length])
    }
}

/// The unit as an attribute of our own, which other readers pass over.
fn unit_attribute(unit: &str) -> String {
    if unit == "-" { String::new() } else { format!(" unit=\"{unit}\"") }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Decoded array of a file, less the length in front of it.
    fn bytes(text: &str, name: &str) -> Vec<u8> {
        let document = roxmltree::Document::parse(text).unwrap();
        let array = document.descendants().find(|node| node.attribute("Name") == Some(name)).unwrap();
        let all = STANDARD.decode(array.text().unwrap().trim()).unwrap();
        let (length, data) = all.split_at(8);
        assert_eq!(u64::from_le_bytes(length.try_into().unwrap()) as usize, data.len(), "{name}");
        data.to_vec()
    }

    #[test]
    fn arrays_of_every_length_come_back() {
        // Round the ends of blocks: 6144 numbers of eight bytes fill one, with the length one fewer.
        for count in [0, 1, 2, 3, 6142, 6143, 6144, 12_287, 20_000] {
            let mut file = Vtu::begin(Vec::new()).unwrap();
            let value = |i: usize| (i as f64).sqrt() - 7.0;
            file.rows("pairs", "N", ["11", "22"], (0..count).map(|i| [value(i), -value(i)])).unwrap();
            file.list("numbers", "-", (0..count).map(|i| i as i32 - 5)).unwrap();
            file.rows("singles", "-", [""; 3], (0..count).map(|i| [value(i) as f32; 3])).unwrap();
            file.list("bytes", "-", (0..count).map(|i| i as u8)).unwrap();
            let text = String::from_utf8(file.end().unwrap()).unwrap();
            let pairs = bytes(&text, "pairs");
            let numbers = bytes(&text, "numbers");
            assert_eq!((pairs.len(), numbers.len()), (16 * count, 4 * count));
            assert_eq!(bytes(&text, "bytes").len(), count);
            let singles = bytes(&text, "singles");
            assert_eq!(singles.len(), 12 * count);
            if let Some(last) = singles.last_chunk::<4>() {
                assert_eq!(f32::from_le_bytes(*last), value(count - 1) as f32);
            }
            for i in 0..count {
                let at = |k: usize| f64::from_le_bytes(pairs[8 * k..8 * (k + 1)].try_into().unwrap());
                assert_eq!(
                    [at(2 * i).to_bits(), at(2 * i + 1).to_bits()],
                    [value(i), -value(i)].map(f64::to_bits)
                );
                assert_eq!(i32::from_le_bytes(numbers[4 * i..4 * (i + 1)].try_into().unwrap()), i as i32 - 5);
            }
        }
    }
}
