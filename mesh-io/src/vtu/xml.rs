//! XML that is read in a time that grows as the text: the reader compares every attribute with those before it.

use roxmltree::{Document, Node};

/// Most attributes of one element, and most declarations of name spaces in a text: a dozen is usual.
const MOST_ATTRIBUTES: usize = 256;

/// What is wrong with a file in XML, and what to do about it.
#[derive(Debug)]
pub(crate) struct XmlError {
    /// Line, from 1; zero where the fault lies in no one line.
    pub line: usize,
    /// Entity, value and what is wrong with it.
    pub what: String,
    /// What to do about it.
    pub repair: &'static str,
}

impl XmlError {
    /// A fault in an element; its line is counted only here, as that takes as long as the file.
    pub fn at(node: Node, what: String, repair: &'static str) -> Self {
        let line = node.document().text_pos_at(node.range().start).row as usize;
        Self { line, what, repair }
    }

    /// A fault of the file as a whole.
    pub fn whole(what: String, repair: &'static str) -> Self {
        Self { line: 0, what, repair }
    }
}

/// Opens a text.
pub(crate) fn parsed(text: &str) -> Result<Document<'_>, XmlError> {
    let repair = "the file is cut off or damaged: write it again";
    if let Some((at, what)) = overgrown(text) {
        let line = 1 + text[..at].matches('\n').count();
        return Err(XmlError { line, what, repair });
    }
    Document::parse(text).map_err(|error| {
        let (line, what) = (error.pos().row as usize, format!("not XML: {error}"));
        XmlError { line, what, repair }
    })
}

/// The first tag with too many attributes, or with one declaration of a name space too many.
fn overgrown(text: &str) -> Option<(usize, String)> {
    let (mut at, mut spaces) = (0, 0);
    while let Some(open) = text[at..].find('<').map(|found| at + found) {
        let rest = &text[open..];
        // Whatever does not end is refused by the reader.
        let past = |end: &str| rest.find(end).map_or(text.len(), |found| open + found + end.len());
        if rest.starts_with("<!--") {
            at = past("-->");
            continue;
        }
        if rest.starts_with("<![CDATA[") {
            at = past("]]>");
            continue;
        }
        let (mut quote, mut attributes, mut end) = (None, 0, rest.len());
        for (i, byte) in rest.bytes().enumerate() {
            match (quote, byte) {
                (Some(mark), _) if mark == byte => quote = None,
                (Some(_), _) => {}
                (None, b'"' | b'\'') => quote = Some(byte),
                (None, b'=') => attributes += 1,
                (None, b'>') => {
                    end = i + 1;
                    break;
                }
                _ => {}
            }
        }
        spaces += rest[..end].matches("xmlns").count();
        if attributes > MOST_ATTRIBUTES {
            return Some((
                open,
                format!("an element has {attributes} attributes; at most {MOST_ATTRIBUTES} are read"),
            ));
        }
        if spaces > MOST_ATTRIBUTES {
            return Some((open, format!("more than {MOST_ATTRIBUTES} name spaces are declared")));
        }
        at = open + end;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_attributes_are_refused_by_their_line_and_what_only_looks_like_them_is_not() {
        let attributes = |count: usize| (0..count).map(|i| format!(" a{i}=\"=>\"")).collect::<String>();
        assert!(parsed(&format!("<a{}/>", attributes(MOST_ATTRIBUTES))).is_ok());
        // So many that a reader of quadratic time would take minutes.
        let refused = parsed(&format!("<a>\n\n<b{}/></a>", attributes(200_000))).err().unwrap();
        assert_eq!(refused.line, 3);
        assert!(refused.what.contains("200000 attributes"), "{}", refused.what);
        let signs = "a=b ".repeat(1000);
        assert!(parsed(&format!("<a><!-- <b {signs} --><![CDATA[<b {signs}]]>{signs}</a>")).is_ok());
        let nested = (0..300).map(|i| format!("<a xmlns:n{i}=\"u{i}\">")).collect::<String>();
        assert!(parsed(&format!("{nested}{}", "</a>".repeat(300))).is_err());
    }
}
