//! Colours and marks that can be distinguished without seeing red or green, and the legend beside a picture.

/// A colour as red, green, blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour(pub u8, pub u8, pub u8);

// The palette of Okabe and Ito, made for colour-blind readers; its yellow is too light for lines.
/// Black.
pub const BLACK: Colour = Colour(0x22, 0x22, 0x22);
/// Blue.
pub const BLUE: Colour = Colour(0x00, 0x72, 0xb2);
/// Green, towards blue.
pub const GREEN: Colour = Colour(0x00, 0x9e, 0x73);
/// Orange.
pub const ORANGE: Colour = Colour(0xe6, 0x9f, 0x00);
/// Purple, towards red.
pub const PURPLE: Colour = Colour(0xcc, 0x79, 0xa7);
/// Light blue.
pub const SKY: Colour = Colour(0x56, 0xb4, 0xe9);
/// Red, towards orange.
pub const VERMILION: Colour = Colour(0xd5, 0x5e, 0x00);
/// Grey, for guides.
pub const GREY: Colour = Colour(0x99, 0x99, 0x99);

/// Blue from light to dark, for a quantity that grows; `part` goes from 0 to 1.
pub fn shade(part: f64) -> Colour {
    let mix = |light: f64, dark: f64| (light + (dark - light) * part.clamp(0.0, 1.0)).round() as u8;
    Colour(mix(150.0, 8.0), mix(200.0, 48.0), mix(232.0, 107.0))
}

/// How points are marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Filled circle.
    Disc,
    /// Open circle.
    Circle,
    /// Open square.
    Square,
    /// Open triangle.
    Triangle,
    /// Open diamond.
    Diamond,
    /// Diagonal cross.
    Cross,
}

/// How points are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// Without gaps.
    Solid,
    /// With gaps.
    Dashed,
}

impl Colour {
    /// As in `#0072b2`.
    pub fn hex(self) -> String {
        format!("#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

impl Mark {
    /// Corners about the middle, in half sizes; none for circles.
    pub fn corners(self) -> &'static [(f64, f64)] {
        match self {
            Self::Disc | Self::Circle => &[],
            Self::Square => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
            Self::Triangle => &[(0.0, -1.15), (1.0, 0.75), (-1.0, 0.75)],
            Self::Diamond => &[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
            Self::Cross => &[(-0.9, -0.9), (0.9, 0.9), (0.0, 0.0), (-0.9, 0.9), (0.9, -0.9)],
        }
    }

    /// The mark at a point of an SVG picture.
    fn svg(self, (x, y): (f64, f64), size: f64, colour: &str) -> String {
        match self {
            Self::Disc => format!("<circle cx='{x}' cy='{y}' r='{size}' fill='{colour}'/>"),
            Self::Circle => {
                format!(
                    "<circle cx='{x}' cy='{y}' r='{size}' fill='none' stroke='{colour}' stroke-width='1.6'/>"
                )
            }
            _ => {
                let points: Vec<String> = self
                    .corners()
                    .iter()
                    .map(|(dx, dy)| format!("{:.1},{:.1}", x + size * dx, y + size * dy))
                    .collect();
                let shape = if self == Self::Cross { "polyline" } else { "polygon" };
                let points = points.join(" ");
                format!("<{shape} points='{points}' fill='none' stroke='{colour}' stroke-width='1.6'/>")
            }
        }
    }
}

/// One line of a legend, as HTML: a sample of line and mark, then the words.
pub fn entry(label: &str, colour: Colour, mark: Option<Mark>, line: Option<Line>) -> String {
    let hex = colour.hex();
    let mut sample = String::new();
    if let Some(line) = line {
        let dash = if line == Line::Dashed { " stroke-dasharray='5 3'" } else { "" };
        sample
            .push_str(&format!("<line x1='1' y1='7' x2='25' y2='7' stroke='{hex}' stroke-width='2'{dash}/>"));
    }
    if let Some(mark) = mark {
        sample.push_str(&mark.svg((13.0, 7.0), 4.2, &hex));
    }
    let words = super::escape(label);
    format!("<li><svg width='26' height='14' aria-hidden='true'>{sample}</svg>{words}</li>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shades_go_from_light_to_dark() {
        let bright = |c: Colour| u32::from(c.0) + u32::from(c.1) + u32::from(c.2);
        let shades: Vec<u32> = (0..5).map(|i| bright(shade(f64::from(i) / 4.0))).collect();
        assert!(shades.windows(2).all(|pair| pair[0] > pair[1]), "{shades:?}");
        assert_eq!(shade(7.0), shade(1.0));
    }

    #[test]
    fn entries_hold_sample_and_words() {
        let text = entry("a < b", BLUE, Some(Mark::Cross), Some(Line::Dashed));
        assert!(text.contains("#0072b2") && text.contains("polyline") && text.contains("a &lt; b"), "{text}");
    }
}
