//! Rust text with everything blanked that is not code: comments, literals, and on request the tests.
//!
//! Blanks keep every line break, so that a place in the masked text is the same place in the file.

/// Comments, strings and characters replaced by blanks.
pub fn code_only(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut masked = chars.clone();
    let mut i = 0;
    while i < chars.len() {
        let end = literal_or_comment(&chars, i);
        for c in &mut masked[i..end] {
            if *c != '\n' {
                *c = ' ';
            }
        }
        i = end.max(i + 1);
    }
    masked.into_iter().collect()
}

/// Where the comment or literal that begins at `i` ends; `i` itself if none does.
fn literal_or_comment(chars: &[char], i: usize) -> usize {
    let at = |k: usize| chars.get(k).copied().unwrap_or('\0');
    match (chars[i], at(i + 1)) {
        ('/', '/') => find(chars, i, |c, _| c == '\n'),
        ('/', '*') => block_comment(chars, i),
        ('"', _) => string(chars, i),
        ('r', '"' | '#') if !follows_name(chars, i) => raw_string(chars, i),
        // 'a' and '\n' are characters, 'a without a closing quote is a lifetime
        ('\'', '\\') => find(chars, i + 3, |c, _| c == '\'') + 1,
        ('\'', _) if at(i + 2) == '\'' => i + 3,
        _ => i,
    }
    .min(chars.len())
}

fn find(chars: &[char], from: usize, stop: impl Fn(char, usize) -> bool) -> usize {
    (from..chars.len()).find(|&k| stop(chars[k], k)).unwrap_or(chars.len())
}

/// A name may end in r; then no raw string begins there. A byte string's b does not count.
fn follows_name(chars: &[char], i: usize) -> bool {
    let name = |k: usize| chars[k].is_alphanumeric() || chars[k] == '_';
    match i {
        0 => false,
        1 => chars[0] != 'b' && name(0),
        _ => name(i - 1) && (chars[i - 1] != 'b' || name(i - 2)),
    }
}

fn block_comment(chars: &[char], start: usize) -> usize {
    let mut depth = 0;
    let mut i = start;
    while i + 1 < chars.len() {
        match (chars[i], chars[i + 1]) {
            ('/', '*') => (depth, i) = (depth + 1, i + 2),
            ('*', '/') => (depth, i) = (depth - 1, i + 2),
            _ => i += 1,
        }
        if depth == 0 {
            return i;
        }
    }
    chars.len()
}

fn string(chars: &[char], start: usize) -> usize {
    let mut i = start + 1;
    while i < chars.len() {
        match chars[i] {
            '\\' => i += 2,
            '"' => return i + 1,
            _ => i += 1,
        }
    }
    chars.len()
}

fn raw_string(chars: &[char], start: usize) -> usize {
    let open = find(chars, start + 1, |c, _| c != '#');
    if chars.get(open) != Some(&'"') {
        return start; // a raw name such as r#type
    }
    let hashes = open - start - 1;
    let closes = |c: char, k: usize| {
        c == '"' && chars[k + 1..].iter().take(hashes).filter(|&&c| c == '#').count() == hashes
    };
    find(chars, open + 1, closes) + 1 + hashes
}

/// Masked code with every item under `#[cfg(test)]` blanked as well.
pub fn without_tests(code: &str) -> String {
    const MARK: &str = "#[cfg(test)]";
    let mut rest = code;
    let mut kept = String::with_capacity(code.len());
    while let Some(start) = rest.find(MARK) {
        let end = start + item_end(&rest[start..]);
        kept.push_str(&rest[..start]);
        kept.extend(rest[start..end].chars().map(|c| if c == '\n' { c } else { ' ' }));
        rest = &rest[end..];
    }
    kept.push_str(rest);
    kept
}

/// The length of an item: to its semicolon, or to the brace that closes its first one.
fn item_end(code: &str) -> usize {
    let mut depth = 0;
    for (i, c) in code.char_indices() {
        match c {
            ';' if depth == 0 => return i + 1,
            '{' => depth += 1,
            '}' if depth <= 1 => return i + 1,
            '}' => depth -= 1,
            _ => {}
        }
    }
    code.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn squeezed(text: &str) -> String {
        code_only(text).split_whitespace().collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn comments_are_blanked() {
        assert_eq!(squeezed("a // b\nc"), "a c");
        assert_eq!(squeezed("a /* b /* c */ d */ e"), "a e");
        assert_eq!(squeezed("a / b"), "a / b");
        assert_eq!(squeezed("a /* never closed"), "a");
    }

    #[test]
    fn literals_are_blanked() {
        assert_eq!(squeezed(r#"f("a // b \" c") + 1"#), "f( ) + 1");
        assert_eq!(squeezed("f(r#\"a \" b\"#) + g(br\"c\") + 1"), "f( ) + g(b ) + 1");
        assert_eq!(squeezed("let c = '\"'; let d = '\\''; e"), "let c = ; let d = ; e");
    }

    #[test]
    fn what_only_looks_like_a_literal_stays() {
        assert_eq!(squeezed("fn f<'a>(x: &'a str) {}"), "fn f<'a>(x: &'a str) {}");
        assert_eq!(squeezed("let r#type = 1;"), "let r#type = 1;");
        assert_eq!(squeezed("for\"x\""), "for");
    }

    #[test]
    fn lines_keep_their_numbers() {
        let text = "a\n\"b\nc\" d\n/* e\n */ f";
        let masked = code_only(text);
        assert_eq!(masked.lines().count(), text.lines().count());
        assert_eq!(masked.lines().nth(2).unwrap().trim(), "d");
        assert_eq!(masked.lines().nth(4).unwrap().trim(), "f");
    }

    #[test]
    fn test_items_are_blanked_and_nothing_after_them() {
        let code = "a\n#[cfg(test)]\nuse b;\nc\n#[cfg(test)]\nmod tests { fn d() { e } }\nf";
        let kept = without_tests(code);
        assert_eq!(kept.split_whitespace().collect::<Vec<_>>(), ["a", "c", "f"]);
        assert_eq!(kept.lines().count(), code.lines().count());
    }
}
