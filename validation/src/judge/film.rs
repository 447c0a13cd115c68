//! Frames of a pictured run, thinned as they come, and the small page that shows them in a browser.

use coque::{Frame, Sheet, State, usual_field};
use viewer::{Body, Instant, Show, page};

use crate::format::short;

/// Frames of a page.
const FRAMES: usize = 12;
/// Most bytes of a page.
const SIZE: usize = 300_000;
/// What places a shell with its thickness beside the field that is shown.
const PLACED: [&str; 3] = ["displacement", "director", "thickness"];

/// Evenly spaced frames of a run, no more than twice as many as a page holds.
#[derive(Default)]
pub struct Film {
    offered: usize,
    /// Every so many frames are kept, one where it is zero.
    every: usize,
    kept: Vec<(Instant, Sheet)>,
    /// The frame that came last, where it is not kept.
    last: Option<(Instant, Sheet)>,
    sizeless: bool,
}

impl Film {
    /// Takes a frame, with its sheet.
    pub fn take(&mut self, frame: &Frame<'_>, sheet: &Sheet) {
        self.sizeless = frame.shown.state == State::Mode;
        let words = match () {
            () if self.sizeless => format!("mode {}, {}", frame.along, short(frame.level)),
            () if frame.time > 0.0 && frame.along == frame.time => format!("time {}", short(frame.time)),
            () => format!("level {}", short(frame.level)),
        };
        let taken = (Instant { along: frame.along, label: words, row: None }, sheet.clone());
        if self.offered.is_multiple_of(self.every.max(1)) {
            self.kept.push(taken);
            self.last = None;
        } else {
            self.last = Some(taken);
        }
        self.offered += 1;
        if self.kept.len() > 2 * FRAMES {
            let mut number = 0;
            self.kept.retain(|_| {
                number += 1;
                number % 2 == 1
            });
            self.every = 2 * self.every.max(1);
        }
    }

    /// The page; none of a run without frames.
    ///
    /// # Errors
    /// What cannot be encoded, in words.
    pub fn page(&self, title: &str) -> Result<Option<String>, String> {
        let all: Vec<&(Instant, Sheet)> = self.kept.iter().chain(&self.last).collect();
        let Some((_, final_sheet)) = all.last() else { return Ok(None) };
        let field = usual_field(final_sheet);
        let count = all.len().min(FRAMES);
        let chosen: Vec<&(Instant, Sheet)> =
            (0..count).map(|i| all[i * (all.len() - 1) / (count - 1).max(1)]).collect();
        let small = |sheet: &Sheet| {
            let mut sheet = sheet.clone();
            sheet.point_data.retain(|name, _| name == field || PLACED.contains(&name.as_str()));
            sheet.cell_data.retain(|name, _| name == field);
            sheet
        };
        let mut body = Body::new("shape", &small(&chosen[0].1));
        for (_, sheet) in &chosen {
            body.add(&small(sheet)).map_err(|error| error.to_string())?;
        }
        let show = Show {
            title: title.into(),
            frames: chosen.iter().map(|(instant, _)| instant.clone()).collect(),
            sizeless: self.sizeless,
            bodies: vec![body],
            wanted: vec![field.into(), PLACED[0].into()],
            ..Show::default()
        };
        page(show, SIZE, 1).map(|page| Some(page.html)).map_err(|error| error.to_string())
    }
}
