//! Tokens of GLSL: reading and writing.

/// A token.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    /// A name or a keyword.
    Word(String),
    /// A literal.
    Number(String),
    /// An operator or bracket.
    Mark(&'static str),
}

impl Token {
    /// Whether the token is a mark.
    pub fn is(&self, mark: &str) -> bool {
        matches!(self, Token::Mark(is) if *is == mark)
    }

    /// The name or keyword.
    pub fn word(&self) -> Option<&str> {
        match self {
            Token::Word(word) => Some(word),
            _ => None,
        }
    }

    fn text(&self) -> &str {
        match self {
            Token::Word(text) | Token::Number(text) => text,
            Token::Mark(text) => text,
        }
    }
}

/// Operators, longer ones before their prefixes.
const MARKS: [&str; 38] = [
    "<<=", ">>=", "++", "--", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "==", "!=", "<=",
    ">=", "&&", "||", "<<", ">>", "+", "-", "*", "/", "%", "=", "<", ">", "!", "?", ":", ";", ",",
    ".", "&", "|", "^", "~",
];
const BRACKETS: [&str; 6] = ["(", ")", "{", "}", "[", "]"];

/// Appends the tokens of a line.
///
/// # Errors
/// A character that GLSL does not have.
pub fn read(line: &str, tokens: &mut Vec<Token>) -> Result<(), String> {
    let mut rest = line.split("//").next().unwrap_or_default().trim_start();
    while let Some(first) = rest.chars().next() {
        let is_number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
        let length = if is_number(rest) || first == '.' && is_number(&rest[1..]) {
            let length = number(rest);
            tokens.push(Token::Number(rest[..length].to_owned()));
            length
        } else if is_of_word(first) {
            let length = rest.find(|c| !is_of_word(c)).unwrap_or(rest.len());
            tokens.push(Token::Word(rest[..length].to_owned()));
            length
        } else {
            let mut marks = MARKS.iter().chain(&BRACKETS);
            let mark = marks.find(|mark| rest.starts_with(**mark));
            let mark = mark.ok_or_else(|| format!("{first:?} has no place in GLSL"))?;
            tokens.push(Token::Mark(mark));
            mark.len()
        };
        rest = rest[length..].trim_start();
    }
    Ok(())
}

fn is_of_word(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '_'
}

/// Length of the number at the start of a text.
fn number(text: &str) -> usize {
    let mut before = ' ';
    text.find(|c: char| {
        let exponent = "+-".contains(c) && "eE".contains(before);
        before = c;
        !(is_of_word(c) || c == '.' || exponent)
    })
    .unwrap_or(text.len())
}

/// The source of tokens: a line per statement, without other blanks, because pages download it.
pub fn text(tokens: &[Token]) -> String {
    let mut text = String::new();
    // A `;` in parentheses does not end a line.
    let mut depth = 0;
    for (at, token) in tokens.iter().enumerate() {
        let number;
        let next = match token {
            Token::Number(long) => {
                number = shortest(long);
                &number
            }
            token => token.text(),
        };
        let glues = match (text.chars().last(), next.chars().next()) {
            (Some(last), Some(first)) => {
                let numeric = |c: char| is_of_word(c) || c == '.';
                // A point may follow a name or bracket, and start a number after a mark.
                let words = is_of_word(last) && is_of_word(first)
                    || numeric(last) && numeric(first) && matches!(token, Token::Number(_))
                    || last == '.'
                        && is_of_word(first)
                        && matches!(tokens.get(at.wrapping_sub(1)), Some(Token::Number(_)));
                let signs = last == first && "+-".contains(last);
                words || signs
            }
            _ => false,
        };
        if glues {
            text.push(' ');
        }
        text.push_str(next);
        depth += i32::from(token.is("(")) - i32::from(token.is(")"));
        let ends = token.is("{") || token.is("}") || token.is(";") && depth == 0;
        if ends && !tokens.get(at + 1).is_some_and(|next| next.is(";")) {
            text.push('\n');
        }
    }
    text
}

/// `0.50` as `.5`, and `2.0` as `2.`.
fn shortest(number: &str) -> String {
    let Some((whole, part)) = number.split_once('.') else {
        return number.to_owned();
    };
    if part.contains(['e', 'E']) {
        return number.to_owned();
    }
    let whole = whole.trim_start_matches('0');
    let part = part.trim_end_matches('0');
    if whole.is_empty() && part.is_empty() {
        "0.".to_owned()
    } else {
        format!("{whole}.{part}")
    }
}
