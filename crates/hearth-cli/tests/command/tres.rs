//! The grammar of Godot's text resources: headings with fields, and below them properties whose values are numbers,
//! texts, names, lists, dictionaries and calls.

/// The unread rest of a text.
pub struct Reader<'a>(pub &'a str);

impl Reader<'_> {
    fn takes(&mut self, word: &str) -> bool {
        let rest = self.0.trim_start().strip_prefix(word);
        self.0 = rest.unwrap_or(self.0);
        rest.is_some()
    }

    fn word(&mut self) -> String {
        let text = self.0.trim_start();
        let is_part = |letter: char| letter.is_alphanumeric() || "_.-/".contains(letter);
        let end = text.find(|letter| !is_part(letter)).unwrap_or(text.len());
        self.0 = &text[end..];
        text[..end].to_owned()
    }

    fn text(&mut self) {
        let mut is_escaped = false;
        let end = self.0.find(|letter| {
            let ends = letter == '"' && !is_escaped;
            is_escaped = letter == '\\' && !is_escaped;
            ends
        });
        self.0 = &self.0[end.expect("the end of a text") + 1..];
    }

    /// Values with commas between them, up to that end.
    fn values(&mut self, end: &str, are_pairs: bool) {
        while !self.takes(end) {
            self.value();
            assert!(!are_pairs || self.takes(":"), "a colon before {:?}", self.0);
            if are_pairs {
                self.value();
            }
            assert!(
                self.takes(",") || self.0.trim_start().starts_with(end),
                "{:?}",
                self.0
            );
        }
    }

    fn value(&mut self) {
        if self.takes("\"") || self.takes("&\"") {
            self.text();
        } else if self.takes("[") {
            self.values("]", false);
        } else if self.takes("{") {
            self.values("}", true);
        } else {
            let word = self.word();
            let is_word =
                word.parse::<f64>().is_ok() || ["true", "false", "null"].contains(&&*word);
            if !is_word {
                assert!(
                    ["Rect2", "ExtResource", "SubResource"].contains(&&*word),
                    "{word:?}"
                );
                assert!(self.takes("("), "{:?}", self.0);
                self.values(")", false);
            }
        }
    }

    fn fields(&mut self, end: Option<&str>) {
        while !end.map_or(
            self.0.trim().is_empty() || self.0.trim_start().starts_with('['),
            |end| self.takes(end),
        ) {
            let name = self.word();
            assert!(
                !name.is_empty() && self.takes("="),
                "{name:?} before {:?}",
                self.0
            );
            self.value();
        }
    }

    /// The tags of all headings of a file.
    pub fn headings(mut self) -> Vec<String> {
        let mut tags = Vec::new();
        while self.takes("[") {
            tags.push(self.word());
            self.fields(Some("]"));
            self.fields(None);
        }
        assert_eq!(self.0.trim(), "");
        tags
    }
}
