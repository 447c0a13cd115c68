//! The list of cases: what each compares with what, a line each.

use std::fmt::Write;

use crate::judge::{Case, Effort};

/// A line for each case: its problem, the figure that is compared first, what it is compared with, and its runs.
pub fn list(cases: &[Case]) -> String {
    cases.iter().fold(String::new(), |mut out, case| {
        let of = |effort| case.variants.iter().filter(|variant| variant.effort == effort).count();
        let (quick, full, heavy) = (of(Effort::Quick), of(Effort::Full), of(Effort::Heavy));
        let headline =
            case.headline.map_or(String::new(), |headline| format!("; headline: {}", headline.metric));
        let (name, title, citation, runs) = (case.name, case.title, case.citation, case.variants.len());
        let _ = writeln!(
            out,
            "{name:<24} {title}{headline} [{citation}] {runs} runs, {quick} quick, {full} full, {heavy} heavy"
        );
        out
    })
}
