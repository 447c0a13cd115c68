//! One picture a case: the deformed shape of its finest run with the default formulation, coloured by stress.

use coque::{FieldError, FieldSink, Frame, Model, Picture, Scene, Sheet, State, picture_svg};

use super::case::Case;
use super::film::Film;
use super::variant::{Problem, Variant};
use crate::methods::CELL;

/// Displacements below this part of the extent are enlarged to about [`SHOWN`] of it: they could not be seen.
const UNSEEN: f64 = 0.02;
const SHOWN: f64 = 0.08;

/// What a picture is made from.
pub struct Pictured {
    /// Which run it is, in words.
    pub run: String,
    /// Its last frame, the first of modes.
    sheet: Sheet,
    /// Planes in which the part is mirrored to the whole.
    mirror: Vec<usize>,
    /// Frames for a page, where pages are wanted.
    film: Option<Film>,
}

/// Number of the run of a case that is pictured: the finest of its scenes with the default formulation, if there is one.
pub fn chosen(case: &Case, sizes: &[usize]) -> Option<usize> {
    let scene = |variant: &Variant| matches!(variant.source, Problem::Scene { .. });
    let usual = |variant: &Variant| scene(variant) && variant.method.starts_with(CELL);
    let own = case.variants.iter().zip(sizes).enumerate().filter(|(_, (variant, _))| usual(variant));
    let finest = own.reduce(|best, next| if next.1.1 > best.1.1 { next } else { best });
    finest.map(|(number, _)| number)
}

/// Keeps the frame that is drawn, and those of a page.
pub struct KeptFrames {
    sheet: Option<Sheet>,
    film: Option<Film>,
}

impl FieldSink for KeptFrames {
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError> {
        let later_mode = frame.shown.state == State::Mode && self.sheet.is_some();
        if later_mode && self.film.is_none() {
            return Ok(());
        }
        let sheet = frame.sheet(true)?;
        if let Some(film) = &mut self.film {
            film.take(frame, &sheet);
        }
        if !later_mode {
            self.sheet = Some(sheet);
        }
        Ok(())
    }
}

impl KeptFrames {
    /// Nothing so far; frames for a page as well if `pages` are wanted.
    pub fn new(pages: bool) -> Self {
        Self { sheet: None, film: pages.then(Film::default) }
    }

    /// What a picture is made from; none of a run that had nothing to show.
    pub fn pictured(self, run: String, mirror: Vec<usize>) -> Option<Pictured> {
        let Self { sheet, film } = self;
        sheet.map(|sheet| Pictured { run, sheet, mirror, film })
    }
}

/// Axes of the symmetry planes through the origin that cut the shell: it lies on one side of each.
pub fn planes(scene: &Scene, model: &Model) -> Vec<usize> {
    let places = model.body.body().configuration().rest;
    let size = places.iter().map(|x| x.amax()).fold(0.0, f64::max);
    let one_side = |axis: usize| {
        let (low, high) = places
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x[axis]), high.max(x[axis])));
        low.abs().min(high.abs()) <= 1e-6 * size && high - low > 1e-6 * size
    };
    (0..3).filter(|&axis| symmetric(scene, axis) && one_side(axis)).collect()
}

/// Whether a support of the scene is a mirror plane across an axis.
fn symmetric(scene: &Scene, axis: usize) -> bool {
    let planes = scene.supports.iter().filter_map(|support| support.symmetry);
    planes.into_iter().any(|plane| (0..3).all(|i| (i == axis) == (plane.normal[i] != 0.0)))
}

impl Pictured {
    /// The picture as SVG, and what is to be said of it.
    ///
    /// # Errors
    /// What is missing in the frame, in words.
    pub fn drawn(&self) -> Result<(String, String), String> {
        let scale = self.scale();
        let wanted = Picture { mirror: &self.mirror, scale, ..Picture::new(&self.run) };
        let svg = picture_svg(&self.sheet, &wanted).map_err(|error| error.to_string())?;
        let mut caption = String::from(
            "The last state that was recorded (of modes the first); dashed the undeformed edge.",
        );
        if !self.mirror.is_empty() {
            caption += " The part that was computed is mirrored to the whole.";
        }
        Ok((svg, caption))
    }

    /// The run as a small page for a browser; none where pages are not wanted.
    ///
    /// # Errors
    /// What cannot be encoded, in words.
    pub fn page(&self, title: &str) -> Result<Option<String>, String> {
        self.film.as_ref().map_or(Ok(None), |film| film.page(&format!("{title} ({})", self.run)))
    }

    /// Whether there is such a page.
    pub fn has_page(&self) -> bool {
        self.film.is_some()
    }

    /// One for displacements that can be seen, else 1, 2 or 5 times a power of ten.
    fn scale(&self) -> f64 {
        let range = |axis: usize| {
            let along = || self.sheet.points.iter().map(|x| x[axis]);
            along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
        };
        let extent = (0..3).map(range).fold(0.0, f64::max);
        let moved = self.sheet.point_data.get("displacement").map_or(&[][..], |u| &u.numbers);
        let largest = moved.iter().fold(0.0_f64, |largest, u| largest.max(u.abs()));
        if !(largest > 0.0 && largest < UNSEEN * extent) {
            return 1.0;
        }
        let exact = SHOWN * extent / largest;
        let power = 10.0_f64.powi(libm::log10(exact).floor() as i32);
        let digit = [5.0, 2.0].into_iter().find(|digit| digit * power <= exact).unwrap_or(1.0);
        digit * power
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The last frame of the panel, two levels without time.
    fn panel() -> Pictured {
        let set = [("geometry.cylinder.particles", "[5, 5]"), ("analysis.static.levels", "2")];
        let set = set.map(|(path, value)| (path.to_string(), value.to_string()));
        let scene = Scene::with_overrides(include_str!("../../../scenes/panel.toml"), "panel", &set).unwrap();
        let model = scene.build(1).unwrap();
        let planes = planes(&scene, &model);
        let mut kept = KeptFrames::new(true);
        let options = coque::RunOptions {
            progress: &mut coque::Silent,
            checkpoints: None,
            fields: Some(&mut kept),
            from: None,
        };
        model.run_with(options).unwrap();
        kept.pictured("5×5".into(), planes).unwrap()
    }

    #[test]
    fn a_quarter_is_drawn_whole() {
        let panel = panel();
        assert_eq!(panel.mirror, [0, 1]);
        let (svg, caption) = panel.drawn().unwrap();
        assert_eq!(svg.matches("<path fill").count(), 4 * 16);
        assert!(svg.contains("von_mises_top") && caption.contains("mirrored"));
        let page = panel.page("Panel").unwrap().unwrap();
        assert!(panel.has_page() && page.contains("Panel (5×5)") && page.len() < 300_000, "{}", page.len());
        assert!(
            page.contains("level 1\"")
                && page.contains("von_mises_top")
                && !page.contains("von_mises_bottom")
        );
    }

    #[test]
    fn what_could_not_be_seen_is_enlarged() {
        let mut panel = panel();
        // 30 mm of a side of 254 are seen; a thousandth of that is drawn 500 times as large, 15 mm.
        assert_eq!(panel.scale(), 1.0);
        panel.sheet.point_data.get_mut("displacement").unwrap().numbers.iter_mut().for_each(|u| *u *= 1e-3);
        assert_eq!(panel.scale(), 500.0);
    }
}
