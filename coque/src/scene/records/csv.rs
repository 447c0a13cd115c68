//! Two columns of a text of numbers, by name or number.

use super::Misread;
use crate::scene::record::ColumnOfFile;

/// Reads times and numbers; a first line that is no numbers names the columns.
///
/// # Errors
/// [`Misread`] for lines that lack a column, words among numbers, and times that do not ascend.
pub(super) fn read(text: &str, columns: Option<&[ColumnOfFile; 2]>) -> Result<Vec<[f64; 2]>, Misread> {
    let numbered = text.trim_start_matches('\u{feff}').lines().enumerate();
    let mut lines = numbered.map(|(i, line)| (i + 1, line.split('#').next().unwrap_or_default().trim()));
    let lines: Vec<(usize, &str)> = lines.by_ref().filter(|(_, line)| !line.is_empty()).collect();
    let Some(&(_, first)) = lines.first() else {
        return Err(Misread::new("file", "nothing", "a file with numbers", "name another file"));
    };
    let split = separator(first);
    let titles: Vec<&str> = cells(first, split);
    let titled = titles.iter().any(|cell| cell.parse::<f64>().is_err());
    let usual = [ColumnOfFile::Number(1), ColumnOfFile::Number(2)];
    let [time, number] = columns.unwrap_or(&usual);
    let at = [found(time, &titles, titled)?, found(number, &titles, titled)?];
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

    #[test]
    fn what_is_no_record_is_refused_by_its_line() {
        let said = |text, columns: Option<&[ColumnOfFile; 2]>| {
            read(text, columns).err().map(|error| format!("{}: {}; {}", error.key, error.value, error.bound))
        };
        assert_eq!(said("0 1\n1 x\n", None).unwrap(), "file: `x`; a number in column 2 of line 2");
        assert_eq!(said("0 1\n1\n", None).unwrap(), "file: nothing; a number in column 2 of line 2");
        assert_eq!(said("0 1\n0 2\n", None).unwrap(), "file: time 0 in line 2; after the time 0 before it");
        assert_eq!(
            said("t,a\n0,1\n", Some(&[named("t"), named("b")])).unwrap(),
            "columns: \"b\"; one of t, a"
        );
        assert_eq!(said("\n# none\n", None).unwrap(), "file: nothing; a file with numbers");
    }
}
