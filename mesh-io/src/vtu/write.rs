//! VTU written: XML with arrays in base64, little-endian, each behind its length in bytes.
//!
//! Version 1.0 with `header_type="UInt64"`, arrays in place: what ParaView, VisIt and meshio all read. Numbers are
//! copied as they stand into one block at a time; nothing is formatted number by number and nothing is held whole.

use std::io::{self, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::writer::{At, Connectivity, FieldWriter, Rows, Values, in_space, misused};

/// Bytes encoded at a time: a multiple of 3, so that only the end is padded, and of 8, so that it fills up evenly.
const BLOCK: usize = 24 * 2048;

/// Numbers asked for at a time.
const ASKED: usize = 1536;

/// The field by which viewers move points, where it is there.
const MOTION: &str = "displacement";

/// A number as it stands in an array.
trait Scalar: Copy + Default {
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

/// A file under way.
pub struct Vtu<W> {
    to: W,
    raw: Vec<u8>,
    filled: usize,
    text: Vec<u8>,
    open: Section,
    points: usize,
    cells: usize,
}

/// What is open in a file, in the order of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Section {
    Head,
    Frame,
    Points,
    Cells,
}

impl<W: Write> Vtu<W> {
    /// Begins a file.
    ///
    /// # Errors
    /// Those of `to`.
    pub fn begin(to: W) -> io::Result<Self> {
        let (raw, text) = (vec![0; BLOCK], vec![0; BLOCK / 3 * 4]);
        let mut file = Self { to, raw, filled: 0, text, open: Section::Head, points: 0, cells: 0 };
        file.line("<?xml version=\"1.0\"?>")?;
        file.line(
            "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">",
        )?;
        file.line("<UnstructuredGrid>")?;
        Ok(file)
    }

    /// Ends the file and hands back what it was written to.
    ///
    /// # Errors
    /// Those of the writer; `InvalidInput` where no geometry was written.
    pub fn end(mut self) -> io::Result<W> {
        self.enter(Section::Cells)?;
        self.line("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>")?;
        Ok(self.to)
    }

    /// Closes and opens sections until one is open.
    fn enter(&mut self, section: Section) -> io::Result<()> {
        match (self.open, section) {
            (open, section) if open == section => {}
            (Section::Head, Section::Frame) => self.line("<FieldData>")?,
            (Section::Points, Section::Cells) => self.line("</PointData>\n<CellData>")?,
            (open, section) => {
                return Err(misused(format!("{section:?} of a frame cannot be written after {open:?}")));
            }
        }
        self.open = section;
        Ok(())
    }

    fn line(&mut self, text: &str) -> io::Result<()> {
        writeln!(self.to, "{text}")
    }

    fn connect(&mut self, cells: Connectivity<'_>) -> io::Result<()> {
        let all = || (0..cells.count).map(cells.cell);
        self.line("<Cells>")?;
        self.begin_array::<i32>("connectivity", "", all().map(|(kind, _)| kind.corners()).sum())?;
        for (kind, corners) in all() {
            corners[..kind.corners()].iter().try_for_each(|&corner| self.put(corner as i32))?;
        }
        self.end_array()?;
        self.begin_array::<i32>("offsets", "", cells.count)?;
        let mut end = 0;
        for (kind, _) in all() {
            end += kind.corners() as i32;
            self.put(end)?;
        }
        self.end_array()?;
        self.begin_array::<u8>("types", "", cells.count)?;
        all().try_for_each(|(kind, _)| self.put(kind as u8))?;
        self.end_array()?;
        self.line("</Cells>")
    }

    fn array<T: Scalar>(&mut self, name: &str, attributes: &str, rows: &dyn Rows<T>) -> io::Result<()> {
        let (count, width) = (rows.count(), rows.width());
        self.begin_array::<T>(name, attributes, count * width)?;
        let mut room = [T::default(); ASKED];
        let at_a_time = ASKED / width;
        for first in (0..count).step_by(at_a_time) {
            let asked = &mut room[..width * at_a_time.min(count - first)];
            rows.fill(first, asked);
            asked.iter().try_for_each(|&value| self.put(value))?;
        }
        self.end_array()
    }

    fn begin_array<T: Scalar>(&mut self, name: &str, attributes: &str, numbers: usize) -> io::Result<()> {
        let kind = T::NAME;
        writeln!(self.to, "<DataArray type=\"{kind}\" Name=\"{name}\" {attributes} format=\"binary\">")?;
        self.put((numbers * T::SIZE) as u64)
    }

    fn end_array(&mut self) -> io::Result<()> {
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

impl<W: Write> FieldWriter for Vtu<W> {
    fn geometry(&mut self, points: &dyn Rows<f64>, cells: Connectivity<'_>) -> io::Result<()> {
        in_space(points)?;
        match self.open {
            Section::Head => {}
            Section::Frame => self.line("</FieldData>")?,
            _ => return Err(misused("a frame has one geometry".into())),
        }
        (self.points, self.cells) = (points.count(), cells.count);
        let piece =
            format!("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>", self.points, self.cells);
        self.line(&piece)?;
        self.array("Points", "NumberOfComponents=\"3\"", points)?;
        self.line("</Points>")?;
        self.connect(cells)?;
        self.open = Section::Points;
        self.line(&format!("<PointData Vectors=\"{MOTION}\">"))
    }

    fn numbers(
        &mut self,
        at: At,
        name: &str,
        unit: &str,
        components: &[&str],
        values: Values<'_>,
    ) -> io::Result<()> {
        let (section, count) = match at {
            At::Frame => (Section::Frame, 1),
            At::Points => (Section::Points, self.points),
            At::Cells => (Section::Cells, self.cells),
        };
        values.check(name, count)?;
        self.enter(section)?;
        let mut attributes = match (at, values.shape().1) {
            (At::Frame, _) => "NumberOfTuples=\"1\"".into(),
            (_, 1) => String::new(),
            (_, width) => format!("NumberOfComponents=\"{width}\""),
        };
        // An attribute of our own, which other readers pass over.
        if unit != "-" {
            attributes += &format!(" unit=\"{unit}\"");
        }
        for (i, component) in components.iter().enumerate() {
            attributes += &format!(" ComponentName{i}=\"{component}\"");
        }
        match values {
            Values::Double(rows) => self.array(name, &attributes, rows),
            Values::Single(rows) => self.array(name, &attributes, rows),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vtu::read::{Grid, Numbers};
    use crate::vtu::xml::parsed;
    use crate::writer::{Kind, rows};

    /// Numbers of an array of a file.
    fn numbers(text: &str, name: &str) -> Vec<f64> {
        let document = parsed(text).unwrap();
        let array = document.descendants().find(|node| node.attribute("Name") == Some(name)).unwrap();
        Grid::open(&document, |_| true).unwrap().numbers(array).map(Numbers::real).unwrap()
    }

    #[test]
    fn arrays_of_every_length_come_back() {
        // Round the ends of blocks: 6144 numbers of eight bytes fill one, with the length one fewer; and of what is
        // asked for at a time.
        for count in [0, 1, 2, 3, 511, 512, 513, 6142, 6143, 6144, 12_287, 20_000] {
            let value = |i: usize| (i as f64).sqrt() - 7.0;
            let mut file = Vtu::begin(Vec::new()).unwrap();
            let cell = |i: usize| (Kind::Vertex, [i as u32; 8]);
            let place = |i: usize| [value(i), -value(i), 0.5];
            file.geometry(&rows(count, place), Connectivity { count, cell: &cell }).unwrap();
            let singles = rows(count, |i| [value(i) as f32; 2]);
            file.numbers(At::Points, "singles", "N", &["11", "22"], Values::Single(&singles)).unwrap();
            file.numbers(At::Cells, "alone", "-", &[], Values::Double(&rows(count, |i| [value(i)]))).unwrap();
            let text = String::from_utf8(file.end().unwrap()).unwrap();
            let expected: Vec<f64> = (0..count).flat_map(place).collect();
            assert_eq!(numbers(&text, "Points"), expected);
            assert_eq!(numbers(&text, "connectivity"), (0..count).map(|i| i as f64).collect::<Vec<_>>());
            assert_eq!(numbers(&text, "offsets"), (1..=count).map(|i| i as f64).collect::<Vec<_>>());
            assert_eq!(numbers(&text, "types"), vec![1.0; count]);
            let expected: Vec<f64> = (0..count).flat_map(|i| [f64::from(value(i) as f32); 2]).collect();
            assert_eq!(numbers(&text, "singles"), expected);
            assert_eq!(numbers(&text, "alone"), (0..count).map(value).collect::<Vec<_>>());
        }
    }

    #[test]
    fn what_comes_out_of_its_place_is_refused() {
        let mut file = Vtu::begin(Vec::new()).unwrap();
        let [none, one, two] = [0, 1, 2].map(|count| rows(count, |_| [0.5]));
        let mut put = |at, values| file.numbers(at, "a", "-", &[], values).map_err(|error| error.to_string());
        assert!(put(At::Points, Values::Double(&none)).unwrap_err().contains("after Head"));
        put(At::Frame, Values::Double(&one)).unwrap();
        let cell = |_: usize| (Kind::Vertex, [0; 8]);
        let cells = Connectivity { count: 1, cell: &cell };
        assert!(file.geometry(&one, cells).unwrap_err().to_string().contains("3 are needed"));
        file.geometry(&rows(1, |_| [0.5; 3]), cells).unwrap();
        let mut put = |at, values| file.numbers(at, "a", "-", &[], values).map_err(|error| error.to_string());
        put(At::Cells, Values::Double(&one)).unwrap();
        assert!(put(At::Points, Values::Double(&one)).unwrap_err().contains("after Cells"));
        assert!(put(At::Cells, Values::Double(&two)).unwrap_err().contains("2 rows where 1 are needed"));
        assert!(Vtu::begin(Vec::new()).unwrap().end().is_err());
    }
}
