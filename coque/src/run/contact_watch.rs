//! What is looked at of contact where a run records, and what is doubtful about it.

use explicit_dynamics::Record;

use super::glue_watch;
use super::record::{ContactSummary, RowsSummary, RunRecord, ShortenedSummary};
use crate::WarningKind;
use crate::bodies::contacts_of_scene::ContactsOfScene;
use crate::bodies::{Body, ContactNow, Spanned};

/// Steps in time between two looks for what nothing keeps apart, at least: a look costs less than twenty of them.
const LOOK_EVERY: u64 = 1000;
/// Least step over that of the bodies alone below which a run says so. Plates thrown at each other at .05, .1 and .2 of their speed of sound have
/// steps of .95, .48 and .12, depths of .56, .76 and .91, and energies off by .06, .24 and .17 %.
const SHORT: f64 = 0.5;

/// Who looks at contact where a run records.
#[derive(Debug)]
pub(crate) struct ContactWatch {
    scene: ContactsOfScene,
    /// Steps done when bodies that nothing keeps apart were last looked at.
    pub looked: u64,
}

impl ContactWatch {
    /// One for the contacts of a scene.
    pub fn new(scene: ContactsOfScene) -> Self {
        Self { scene, looked: 0 }
    }

    /// Takes a record of a march, and looks at bodies that nothing keeps apart where that is due.
    pub fn look_in_time(&mut self, body: &dyn Body, record: &Record, found: &mut RunRecord) {
        let at = [record.at.time, record.at.level];
        self.note(body, at, found);
        if record.step >= self.looked + LOOK_EVERY {
            self.looked = record.step;
            self.look(body, at, found);
        }
    }

    /// Notes what each contact does at a time \[T\], zero without time, and a level.
    pub fn note(&self, body: &dyn Body, [time, level]: [f64; 2], found: &mut RunRecord) {
        glue_watch::note(body, 1.0, found);
        for (number, now) in body.contacts().iter().enumerate() {
            if number == found.contacts.len() {
                let set_by = now.by_thickness.map(|own| if own { "thickness" } else { "step" });
                found.contacts.push(ContactSummary {
                    between: self.scene.name(now),
                    stiffness: now.stiffness,
                    set_by: set_by.map(String::from),
                    greatest_depth: 0.0,
                    time,
                    level,
                    place: None,
                    greatest_area: 0.0,
                    rows: None,
                });
            }
            let own = &mut found.contacts[number];
            own.greatest_area = own.greatest_area.max(now.area);
            if let Some(rows) = now.rows {
                RowsSummary::take(&mut own.rows, rows, level);
            }
            if now.depth > own.greatest_depth {
                let place = now.place.map(<[f64; 3]>::from);
                (own.greatest_depth, own.time, own.level, own.place) = (now.depth, time, level, place);
            }
        }
    }

    /// Looks for what has come nearer than faces allow, at a time \[T\], zero without time, and a level; it is reported once.
    pub fn look(&self, body: &dyn Body, [time, level]: [f64; 2], found: &mut RunRecord) {
        if found.warnings.iter().any(|known| known.kind == WarningKind::TouchingUnseen) {
            return;
        }
        if let Some(message) = self.scene.unseen(body, &when(time, level)) {
            found.warn(WarningKind::TouchingUnseen, message);
        }
    }

    /// Says what is doubtful about the contacts of a run that has ended.
    pub fn judge(found: &mut RunRecord) {
        let deep = found.contacts.iter().filter(|own| own.greatest_depth > ContactNow::DEEP);
        let messages: Vec<String> = deep.map(deep_contact).collect();
        messages.into_iter().for_each(|message| found.warn(WarningKind::DeepContact, message));
        let by_levels = !found.levels.is_empty();
        let messages: Vec<String> =
            found.contacts.iter().filter_map(|own| coarse_contact(own, by_levels)).collect();
        messages.into_iter().for_each(|message| found.warn(WarningKind::CoarseContact, message));
        if let Some(ShortenedSummary { steps, least, time }) =
            found.shortened.filter(|own| own.least < SHORT && !found.contacts.is_empty())
        {
            let message = format!(
                "contact made {steps} of {} steps shorter, at time {time} down to {least:.2e} of what the bodies alone would take: \
                 what meets there is pressed into the middle of the thickness; let bodies meet more slowly, use smaller \
                 cells or a greater thickness",
                found.steps
            );
            found.warn(WarningKind::ShortenedStep, message);
        }
    }
}

/// The warning of a deep contact.
fn deep_contact(own: &ContactSummary) -> String {
    let place = own.place.map_or_else(String::new, |[x, y, z]| format!(", at [{x:.4}, {y:.4}, {z:.4}]"));
    format!(
        "{}: faces are {:.2} of the distance at which they touch in each other {}{place} ({} and more are deep): where they press on \
         each other is off by as much, and what they bear there hangs on the stiffness of contact, which {} sets; give it a greater \
         `stiffness`, or use smaller cells",
        own.between,
        own.greatest_depth,
        when(own.time, own.level),
        ContactNow::DEEP,
        match own.set_by.as_deref() {
            Some("thickness") => "the thickness",
            Some(_) => "the step in time",
            None => "the softer of the two",
        },
    )
}

/// The warning of a contact of few rows: along levels, each of which is an answer, if it is coarse at any; in real time, in which each contact begins
/// and ends with a row, if it is at its widest.
fn coarse_contact(own: &ContactSummary, by_levels: bool) -> Option<String> {
    let RowsSummary { fewest, most, coarse_level } = own.rows?;
    let (said, until) = match coarse_level {
        Some(level) if by_levels => (fewest, format!("up to level {level}")),
        _ => (most, String::from("at its widest")),
    };
    let Spanned { rows, wanted, off } = said;
    said.is_coarse().then(|| {
        format!(
            "{}: {until} the contact spans {rows} of the {wanted} rows of nodes that are wanted from its rim to its middle, and at its widest {}: under drums and \
             balls the greatest pressure was up to {off:.0} % off at {rows}, the half width farther, the force {}; read no pressure there, \
             or use {:.2} of this spacing",
            own.between,
            most.rows,
            if rows > 1 { "9 %" } else { "19 %" },
            f64::from(rows) / f64::from(wanted),
        )
    })
}

fn when(time: f64, level: f64) -> String {
    if time > 0.0 { format!("at time {time}") } else { format!("at level {level}") }
}
