//! Two columns of a text of numbers, by name or number.

use super::Misread;
use crate::scene::record::ColumnOfFile;

/// Reads times and numbers; a first line without any number names the columns. Empty cells at the end of a line are left out, and lines of nothing else.
///
/// # Errors
/// [`Misread`] for names that are not as many as the cells below them, lines that lack a column, words among numbers, and times that do not ascend.
pub(super) fn read(text: &str, columns: Option<&[ColumnOfFile; 2]>) -> Result<Vec<[f64; 2]>, Misread> {
    let numbered = text.trim_start_matches('\u{feff}').lines().enumerate();
    let mut lines = numbered.map(|(i, line)| (i + 1, line.split('#').next().unwrap_or_default().trim()));
    let lines: Vec<(usize, &str)> = lines.by_ref().filter(|(_, line)| holds(line)).collect();
    let Some(&(place, first)) = lines.first() else {
        return Err(Misread::new("file", "nothing", "a file with numbers", "name another file"));
    };
    let split = separator(first);
    let titles = &cells(first, split)[..];
    let titles = &titles[..filled(titles)];
    let titled = titles.iter().all(|cell| cell.is_empty() || cell.parse::<f64>().is_err());
    if titled && let Some(&(below, text)) = lines.get(1) {
        check_names(cells(first, split), place, cells(text, split), below)?;
    }
    let usual = [ColumnOfFile::Number(1), ColumnOfFile::Number(2)];
    let [time, number] = columns.unwrap_or(&usual);
    let at = [found(time, titles, titled)?, found(number, titles, titled)?];
    let mut points: Vec<[f64; 2]> = Vec::with_capacity(lines.len());
    for &(line, text) in &lines[usize::from(titled)..] {
        let row = cells(text, split);
        let cell = |column: usize| {
            let cell = row.get(column).copied().unwrap_or_default();
            cell.parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(|| {
                let said = if cell.is_empty() { "nothing".to_string() } else { format!("`{cell}`") };
                let bound = format!("a number in column {} of line {line}", column + 1);
                Misread::new("file", said, bound, "correct the line, or name other `columns`")
            })
        };
        let point = [cell(at[0])?, cell(at[1])?];
        if let Some([before, _]) = points.last().filter(|[before, _]| point[0] <= *before) {
            let (value, bound) =
                (format!("time {} in line {line}", point[0]), format!("after the time {before} before it"));
            return Err(Misread::new("file", value, bound, "sort the file by time, or name other `columns`"));
        }
        points.push(point);
    }
    if points.is_empty() {
        return Err(Misread::new(
            "file",
            "no number",
            "a line of numbers below the names of the columns",
            "name another file",
        ));
    }
    Ok(points)
}

/// Whether a line has more than what stands between cells.
fn holds(line: &str) -> bool {
    line.contains(|c: char| !c.is_whitespace() && !",;\"".contains(c))
}

/// How many cells there are up to the last that is not empty.
fn filled(cells: &[&str]) -> usize {
    cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1)
}

/// Refuses names that are not as many as the cells of the first row, be it with or without the empty ones at their ends: a name with a blank in it, between
/// blanks, would give each column the name of another.
fn check_names(names: Vec<&str>, place: usize, row: Vec<&str>, below: usize) -> Result<(), Misread> {
    let [named, there] = [filled(&names), filled(&row)];
    if named == there || names.len() == row.len() {
        return Ok(());
    }
    let value = format!("{named} names in line {place}");
    let bound = format!("as many as the cells of line {below}, which are {there}");
    let repair =
        "name each column once; where a name has blanks in it, write commas between names and between cells";
    Err(Misread::new("file", value, bound, repair))
}

/// What stands between the cells of a line; none for blanks.
fn separator(line: &str) -> Option<char> {
    [',', ';', '\t'].into_iter().find(|&c| line.contains(c))
}

fn cells(line: &str, split: Option<char>) -> Vec<&str> {
    match split {
        Some(c) => line.split(c).map(|cell| cell.trim().trim_matches('"')).collect(),
        None => line.split_whitespace().collect(),
    }
}

/// The place of a column.
fn found(column: &ColumnOfFile, titles: &[&str], titled: bool) -> Result<usize, Misread> {
    let count = titles.len();
    match column {
        ColumnOfFile::Number(number) if (1..=count).contains(number) => Ok(number - 1),
        ColumnOfFile::Number(number) => {
            let bound = format!("from 1 to {count}, the columns of the file");
            Err(Misread::new("columns", number.to_string(), bound, "columns are counted from 1"))
        }
        ColumnOfFile::Name(name) => {
            let plain = |title: &str| title.split(" [").next().unwrap_or(title).trim().to_string();
            let same = |title: &&str| *title == name || plain(title) == *name;
            titles.iter().position(|title| titled && same(title)).ok_or_else(|| {
                let bound = match titled {
                    true => {
                        format!("one of {}", titles.iter().map(|t| plain(t)).collect::<Vec<_>>().join(", "))
                    }
                    false => "a number from 1: the file names no columns".into(),
                };
                Misread::new(
                    "columns",
                    format!("\"{name}\""),
                    bound,
                    "name a column of the file, or give its number",
                )
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str) -> ColumnOfFile {
        ColumnOfFile::Name(name.into())
    }

    #[test]
    fn columns_by_number_and_by_name_whatever_stands_between() {
        let wanted = vec![[0.0, 1.0], [0.5, -2.0]];
        assert_eq!(read("0 1\n0.5 -2\n", None).ok(), Some(wanted.clone()));
        assert_eq!(
            read("# quake\nt; x; a\n0; 9; 1\n\n0.5; 9; -2 # last", Some(&[named("t"), named("a")])).ok(),
            Some(wanted.clone())
        );
        let curve = "time [s],a [m/s²]\n0.0,1.0\n0.5,-2.0\n";
        assert_eq!(read(curve, Some(&[named("time"), ColumnOfFile::Number(2)])).ok(), Some(wanted));
    }

    /// A first line with a number in it is a row, whatever else it holds.
    #[test]
    fn the_first_row_is_none_of_names() {
        let wanted = vec![[0.0, 1.0], [0.01, 2.0]];
        for text in [
            "0,1,\n0.01,2,\n",
            "0,1,begin\n0.01,2,end\n",
            "t,a,\n0,1\n0.01,2\n,,\n",
            "t,a\n0,1,,\n0.01,2,,\n",
            "t,a,said\n0,1,\n0.01,2,late\n",
        ] {
            assert_eq!(read(text, None).ok(), Some(wanted.clone()), "{text}");
        }
    }

    #[test]
    fn what_is_no_record_is_refused_by_its_line() {
        let said = |text, columns: Option<&[ColumnOfFile; 2]>| {
            read(text, columns).err().map(|error| format!("{}: {}; {}", error.key, error.value, error.bound))
        };
        assert_eq!(said("0 1\n1 x\n", None).unwrap(), "file: `x`; a number in column 2 of line 2");
        assert_eq!(said("0,1.O\n1,2\n", None).unwrap(), "file: `1.O`; a number in column 2 of line 1");
        assert_eq!(
            said("# a\ntime [s] a b\n0 1 2\n", Some(&[named("time"), named("a")])).unwrap(),
            "file: 4 names in line 2; as many as the cells of line 3, which are 3"
        );
        assert_eq!(
            said("t,a\n0,1,2\n", None).unwrap(),
            "file: 2 names in line 1; as many as the cells of line 2, which are 3"
        );
        assert_eq!(said("0 1\n1\n", None).unwrap(), "file: nothing; a number in column 2 of line 2");
        assert_eq!(said("0 1\n0 2\n", None).unwrap(), "file: time 0 in line 2; after the time 0 before it");
        assert_eq!(
            said("t,a\n0,1\n", Some(&[named("t"), named("b")])).unwrap(),
            "columns: \"b\"; one of t, a"
        );
        assert_eq!(said("\n# none\n", None).unwrap(), "file: nothing; a file with numbers");
    }
}
