//! Text for a terminal: what would steer it is written out.

use std::borrow::Cow;

/// The text with its control characters, but line breaks and tabs, written as `\u{1b}`, and those that turn the direction
/// of writing as well: a title or a name out of a file cannot move a cursor or hide a word.
pub fn plain_text(text: &str) -> Cow<'_, str> {
    if !text.contains(steers) {
        return Cow::Borrowed(text);
    }
    let written = |c: char| if steers(c) { c.escape_unicode().to_string() } else { c.to_string() };
    Cow::Owned(text.chars().map(written).collect())
}

/// The same with a question mark, or as many of them, for each such character: every byte keeps its place.
pub(crate) fn same_length(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for c in text.chars() {
        if steers(c) {
            (0..c.len_utf8()).for_each(|_| plain.push('?'));
        } else {
            plain.push(c);
        }
    }
    plain
}

fn steers(c: char) -> bool {
    let turns = matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    (c.is_control() && !matches!(c, '\n' | '\t')) || turns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_left_that_steers_a_terminal() {
        assert_eq!(plain_text("\u{1b}[31mred\r\n\tµm"), "\\u{1b}[31mred\\u{d}\n\tµm");
        assert_eq!(plain_text("a\u{202e}b\u{9b}"), "a\\u{202e}b\\u{9b}");
        assert!(matches!(plain_text("plain"), Cow::Borrowed(_)));
        let kept = "a\u{202e}b\u{9b}\u{7}c";
        assert_eq!(same_length(kept), "a???b???c");
        assert_eq!(same_length(kept).len(), kept.len());
    }
}
