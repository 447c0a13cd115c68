//! Accelerations as the Pacific Earthquake Engineering Research Center keeps them: four lines of heading, then numbers in g at equal times from zero.
//!
//! The third line says what the numbers are and their unit, the fourth how many (`NPTS`) and how far apart in seconds (`DT`), in either order of name and
//! number: `NPTS=   5372, DT=   .0100 SEC`, or `4000   .0050   NPTS, DT`.

use super::Misread;

/// Reads times \[s\] and accelerations \[g\].
///
/// # Errors
/// [`Misread`] for a heading that does not say that, and where there are more or fewer numbers than it says.
pub(super) fn read(text: &str) -> Result<Vec<[f64; 2]>, Misread> {
    let lines: Vec<&str> = text.lines().collect();
    let heading = |i: usize| lines.get(i).map_or("", |line| line.trim());
    let unit = heading(2).to_ascii_uppercase();
    if !(unit.contains("ACCELERATION") && unit.split_whitespace().last() == Some("G")) {
        let bound = "a third line that says ACCELERATION … IN UNITS OF G, as PEER writes it";
        let repair = "name an .AT2 of PEER; of any other file give two columns as CSV, with `units`";
        return Err(Misread::new("file", format!("`{}`", heading(2)), bound, repair));
    }
    let Some((count, step)) = counted(heading(3)) else {
        let bound =
            "a fourth line with NPTS, how many numbers, and DT, how many seconds apart, as PEER writes it";
        return Err(Misread::new(
            "file",
            format!("`{}`", heading(3)),
            bound,
            "see whether the heading is whole",
        ));
    };
    let mut points = Vec::new();
    for (i, line) in lines.iter().enumerate().skip(4) {
        for word in line.split_whitespace() {
            let Some(x) = word.parse::<f64>().ok().filter(|x| x.is_finite()) else {
                let bound = format!("numbers in line {}", i + 1);
                return Err(Misread::new("file", format!("`{word}`"), bound, "correct the line"));
            };
            points.push([step * points.len() as f64, x]);
        }
    }
    if points.len() != count {
        let (value, bound) = (format!("{} numbers", points.len()), format!("NPTS = {count} of them"));
        return Err(Misread::new("file", value, bound, "see whether the file is whole"));
    }
    Ok(points)
}

/// How many numbers, and the time between two.
fn counted(line: &str) -> Option<(usize, f64)> {
    let upper = line.to_ascii_uppercase();
    let (points, step) = (upper.find("NPTS")?, upper.find("DT")?);
    let numbers: Vec<f64> = upper
        .split(|c: char| !(c.is_ascii_digit() || ".+-E".contains(c)))
        .filter(|word| word.contains(|c: char| c.is_ascii_digit()))
        .filter_map(|word| word.parse().ok())
        .collect();
    let [a, b, ..] = numbers[..] else { return None };
    let (count, step) = if points < step { (a, b) } else { (b, a) };
    let whole = count >= 2.0 && count == libm::trunc(count) && count < 1e9;
    (whole && step > 0.0).then_some((count as usize, step))
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADING: &str = "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 1/1/1999, 090\nACCELERATION TIME SERIES IN UNITS OF G\n";

    #[test]
    fn either_heading_is_read() {
        for fourth in
            ["NPTS=      3, DT=   .0050 SEC", "    3    0.0050    NPTS, DT", "DT= 5.0E-3 SEC, NPTS= 3"]
        {
            let text = format!("{HEADING}{fourth}\n  .1000000E-01  -.2000000E-01\n 0.5\n");
            let points = read(&text).ok();
            assert_eq!(points, Some(vec![[0.0, 0.01], [0.005, -0.02], [0.01, 0.5]]), "{fourth}");
        }
    }

    #[test]
    fn what_is_no_acceleration_in_g_or_not_whole_is_refused() {
        let said =
            |text: &str| read(text).err().map(|error| format!("{}; {}", error.value, error.bound)).unwrap();
        assert!(said("a\nb\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 1, DT= 1").starts_with("`VELOCITY"));
        assert!(said(&format!("{HEADING}3 numbers\n1 2 3")).starts_with("`3 numbers`"));
        assert_eq!(said(&format!("{HEADING}NPTS= 4, DT= .1\n1 2 3")), "3 numbers; NPTS = 4 of them");
        assert_eq!(said(&format!("{HEADING}NPTS= 3, DT= .1\n1 x 3")), "`x`; numbers in line 5");
    }
}
