//! Every combination of lists of values.

/// Combinations beyond which a list of values is taken for a mistake.
const MOST_RUNS: usize = 100_000;

/// Paths of a scene, each with the value of one run.
pub(super) type Values = Vec<(String, String)>;

/// Every combination of the values, the last list running fastest.
pub(super) fn combinations(over: &[(String, String)]) -> Result<Vec<Values>, String> {
    let mut runs = vec![Values::new()];
    for (path, list) in over {
        let values = split(list);
        if values.iter().any(|value| value.is_empty()) {
            return Err(format!("--over {path}={list}: a value is empty; write PATH=V1,V2,…\n"));
        }
        if runs.len() * values.len() > MOST_RUNS {
            return Err(format!("more than {MOST_RUNS} combinations; give fewer values\n"));
        }
        let with = |run: &Values, value: &&str| {
            let mut run = run.clone();
            run.push((path.clone(), (*value).to_owned()));
            run
        };
        runs = runs.iter().flat_map(|run| values.iter().map(move |value| with(run, value))).collect();
    }
    Ok(runs)
}

/// Parts between commas that stand in no bracket and no quotes.
fn split(list: &str) -> Vec<&str> {
    let (mut depth, mut quote, mut start) = (0_i32, None, 0);
    let mut parts = Vec::new();
    for (at, c) in list.char_indices() {
        match (quote, c) {
            (Some(open), _) if c == open => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(c),
            (None, '[' | '{') => depth += 1,
            (None, ']' | '}') => depth -= 1,
            (None, ',') if depth == 0 => {
                parts.push(list[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(list[start..].trim());
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_split_at_outer_commas() {
        assert_eq!(split("1, 2.5,3e4"), ["1", "2.5", "3e4"]);
        assert_eq!(split("[25, 3],[50, 5]"), ["[25, 3]", "[50, 5]"]);
        assert_eq!(split("{ a = [1, 2], b = \"},\" },'x,y'"), ["{ a = [1, 2], b = \"},\" }", "'x,y'"]);
        assert_eq!(split(""), [""]);
    }

    #[test]
    fn combinations_run_through_the_last_list_first() {
        let over = [("a".to_string(), "1,2".to_string()), ("b".to_string(), "x,y,z".to_string())];
        let runs = combinations(&over).unwrap();
        let shown: Vec<String> = runs.iter().map(|run| format!("{}{}", run[0].1, run[1].1)).collect();
        assert_eq!(shown, ["1x", "1y", "1z", "2x", "2y", "2z"]);
        assert!(combinations(&[("a".into(), "1,,2".into())]).is_err());
    }
}
