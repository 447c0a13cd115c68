//! Other lattices that begin at the levels of the run; bars that a finer lattice sharpens.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{Replaced, ran, scene};
use coque::{Checked, Errors, Silent, Verdict};

fn errors(scene: &Checked) -> Errors {
    let outcome = scene.build(1).unwrap().run(&mut Silent);
    scene.errors(&outcome, 1, &mut Silent)
}

#[test]
fn levels_that_begin_at_those_of_the_run_give_the_same_bars() {
    // A run keeps its states only where its scene asks for errors.
    let problems: [(&str, Replaced, &str); 3] = [
        ("hemisphere.toml", &[("analysis.static.levels", "9")], "outward"),
        ("ring.toml", &[("analysis.static.levels", "8")], "minus_U_tip"),
        ("cantilever-end-shear.toml", &[("analysis.static.levels", "10")], "W_tip"),
    ];
    for (name, set, column) in problems {
        let anew = errors(&scene(name, set).unwrap());
        let with: Vec<_> = set.iter().copied().chain([("error", "{}")]).collect();
        let begun = errors(&scene(name, &with).unwrap());
        assert_eq!(begun.lattices.len(), anew.lattices.len());
        let [anew, begun] = [&anew, &begun].map(|errors| &errors.of(column).unwrap().bars);
        let greatest = anew.iter().fold(0.0, |most: f64, bar| most.max(bar.value.abs()));
        assert_eq!(anew.len(), begun.len());
        for (anew, begun) in anew.iter().zip(begun) {
            assert_eq!(anew.value.to_bits(), begun.value.to_bits());
            // Between the rows that are balanced a bar may be wider, not narrower by more than a cubic misses: .29 of it, measured where a strip
            // turns by 90° between two of them, and a bar is twice the error. Below 10⁻⁷ there is round-off.
            let [a, b] = [anew, begun].map(|bar| bar.bar.unwrap_or(0.0));
            assert!(b >= 0.6 * a - 1e-7 * greatest, "{name}: {anew:?}, {begun:?}");
        }
        let last = |bars: &[coque::ErrorBar]| bars.last().unwrap().bar.unwrap();
        // The last level is balanced on all lattices: what Newton's method leaves.
        assert!((last(anew) - last(begun)).abs() <= 1e-3 * last(anew), "{name}");
    }
}

#[test]
fn a_sharpened_bar_is_hardly_larger_than_the_error_and_the_number_is_corrected() {
    let sharpen = ("error", "{ sharpen = true }");
    let problems: [(&str, Replaced, &str); 5] = [
        ("scordelis-lo.toml", &[sharpen], "w_edge"),
        ("pinched-cylinder.toml", &[sharpen], "w_load"),
        ("twisted-beam.toml", &[sharpen], "V_tip"),
        ("hemisphere.toml", &[("analysis.static.levels", "4"), sharpen], "outward"),
        ("column-buckling.toml", &[sharpen], "level"),
    ];
    for (name, set, column) in problems {
        let scene = scene(name, set).unwrap();
        let errors = errors(&scene);
        let found = errors.of(column).unwrap().bars.last().copied().unwrap();
        let truth = ran(Ok(scene.refined(4.0).unwrap().scene)).curve.column(column).unwrap();
        // The fine lattice is off by a fifteenth of the difference at the second order.
        let truth = truth.last().unwrap() + (truth.last().unwrap() - found.value) / 15.0;
        let error = (found.value - truth).abs();
        let bar = found.bar.unwrap();
        assert_eq!(found.verdict, Verdict::Sharpened, "{name}");
        assert!(error <= bar && bar <= 1.5 * error, "{name}: {found:?}, error {error}");
        // Measured .04 of the error at most.
        let left = (found.corrected.unwrap() - truth).abs();
        assert!(left <= 0.12 * error, "{name}: {found:?}, left {left} of {error}");
    }
}

#[test]
fn what_is_not_sharpened_is_said() {
    let march =
        scene("plate.toml", &[("error", "{ sharpen = true }"), ("analysis.modal.modes", "2")]).unwrap();
    assert!(errors(&march).lacks.iter().all(|words| !words.contains("sharpening")));
    let path = [
        ("analysis.arc-length.stop", "{ column = \"w_crown\", above = 2 }"),
        ("error", "{ sharpen = true }"),
    ];
    let path = scene("panel.toml", &path).unwrap();
    assert!(errors(&path).lacks.iter().any(|words| words.starts_with("sharpening: that is done of linear")));
}
