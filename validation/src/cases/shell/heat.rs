//! heat: plates between walls that buckle as they are heated, evenly and along one edge, two metals that bend, a fin that is cooled, a plate
//! that is quenched, against closed forms.

use benchmarks_ref::reference;

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const PLATE: &str = include_str!("../../../../scenes/heated-plate.toml");
const STRIP: &str = include_str!("../../../../scenes/bimetal-strip.toml");
const ASIDE: &str = include_str!("../../../../scenes/plate-heated-aside.toml");
const FIN: &str = include_str!("../../../../scenes/cooled-fin.toml");
const QUENCHED: &str = include_str!("../../../../scenes/plate-quenched.toml");
const NAME: &str = "critical temperature";
/// Length of the strip \[m\].
const LENGTH: f64 = 0.2;

/// The scenes, their references, and how far they may differ.
pub fn case() -> Case {
    let plate = |counts| Variant::new(STATIC, PLATE, "plate", counts).quick().on("plate between walls");
    let strip = |counts| Variant::new(STATIC, STRIP, "plate", counts).quick().on("strip of two metals");
    let aside =
        |counts| Variant::new(STATIC, ASIDE, "plate", counts).quick().on("plate heated along one edge");
    let fin = |counts| Variant::new(STATIC, FIN, "plate", counts).quick().on("fin cooled by air");
    let quenched =
        |counts| Variant::new(STATIC, QUENCHED, "plate", counts).quick().on("plate between cold clamps");
    Case {
        name: "heat",
        title: "Plate and strip that are heated",
        about: "Changes of temperature: a square plate whose hinged edges hold it in its plane buckles, and a strip of steel on brass bends. Heat that is conducted: a plate heated along one edge buckles, a fin gives it off, and a plate is quenched in time.",
        citation: "closed forms of the theory of plates; S. Timoshenko, J. Opt. Soc. Am. 11 (1925)",
        variants: vec![
            plate([21, 21]).judged(|run, _| buckled(run, 20.0)),
            plate([41, 41]).judged(|run, _| buckled(run, 40.0)),
            strip([31, 4]).judged(|run, _| bent(run)),
            strip([61, 4]).judged(|run, _| bent(run)),
            aside([21, 21]).judged(|run, _| buckled_aside(run, 20.0)),
            aside([41, 41]).judged(|run, _| buckled_aside(run, 40.0)),
            fin([21, 5]).judged(|run, _| cooled(run, 20.0)),
            fin([41, 5]).judged(|run, _| cooled(run, 40.0)),
            quenched([21, 21]).judged(|run, _| cold(run, 20.0)),
            quenched([41, 41]).judged(|run, _| cold(run, 40.0)),
        ],
        headline: Some(Headline::new(NAME, 0.5)),
        ..Case::default()
    }
}

fn buckled(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let exact = reference("heated_shells")?.number(0, "value")?;
    let percent = run.last("level")?.map(|found| 100.0 * (found / exact - 1.0));
    // .077 % with 40 cells.
    let reason =
        "three times what one curvature and one gradient a cell leave of a half wave, of second order";
    Ok(vec![Metric::error(NAME, percent, "%").within(3.0 * 0.077 * (40.0 / cells).powi(2), reason)])
}

fn bent(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let turn = LENGTH * reference("heated_shells")?.number(1, "value")?;
    let percent = run.last("turn")?.map(|found| 100.0 * (found.abs() / turn - 1.0));
    // .0076 % with 30 cells and with 60.
    let reason =
        "three times what the bend across takes from that along, which Timoshenko's strip does not have";
    Ok(vec![Metric::error("turn of the end", percent, "%").within(3.0 * 0.0076, reason)])
}

fn buckled_aside(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let exact = reference("heated_shells")?.number(2, "value")?;
    let percent = run.last("level")?.map(|found| 100.0 * (found / exact - 1.0));
    // .077 % with 40 cells, as of the plate that is heated evenly.
    let reason =
        "three times what one curvature and one gradient a cell leave of a half wave, of second order";
    Ok(vec![Metric::error(NAME, percent, "%").within(3.0 * 0.077 * (40.0 / cells).powi(2), reason)])
}

fn cooled(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let table = reference("heated_shells")?;
    let (end, root) = (table.number(3, "value")?, table.number(4, "value")?);
    let percent = |found: f64, exact: f64| 100.0 * (found / exact - 1.0);
    let end = run.last("end")?.map(|found| percent(found - 20.0, end));
    let root = run.last("root")?.map(|found| percent(found, root));
    let finer = (40.0 / cells).powi(2);
    // .0048 and .0113 % with 40 cells.
    let reason = "three times what temperatures linear along a cell and heat lumped at its ends leave, of second order";
    Ok(vec![
        Metric::error("temperature of the end", end, "%").within(3.0 * 0.0048 * finer, reason),
        Metric::error("heat at the root", root, "%").within(3.0 * 0.0113 * finer, reason),
    ])
}

fn cold(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let table = reference("heated_shells")?;
    let (times, found) = (run.column("time")?, run.column("middle")?);
    let finer = (40.0 / cells).powi(2);
    let reason = "three times what temperatures linear along a cell and heat stored at its corners leave, of second order";
    let of = |row, time: f64, name, off: f64| {
        let exact = table.number(row, "value")?;
        let at = times.iter().position(|own| (own - time).abs() < 1e-9).and_then(|i| found.get(i));
        let percent = at.map(|found| 100.0 * (found - 20.0 - exact) / 480.0);
        Ok::<_, JudgeError>(Metric::error(name, percent, "% of the fall").within(3.0 * off * finer, reason))
    };
    // With 40 cells; after 60 s steps leave .0016 %.
    Ok(vec![of(5, 20.0, "middle after 20 s", 0.056)?, of(6, 60.0, "middle after 60 s", 0.0068)?])
}
