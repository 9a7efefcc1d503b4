//! Reader of the Interval Testing Framework language (`.itl`): assertions `operation argument.. = result..;`.

use scalars::Interval;

/// A literal of the language.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Interval(Interval),
    Number(f64),
    Bool(bool),
    Text(String),
    /// Decorated intervals, NaI, vectors, names of states: what no bare-interval operation takes or gives.
    Other(String),
}

/// One assertion, with its place for messages.
#[derive(Debug)]
pub(crate) struct Assertion {
    pub(crate) operation: String,
    pub(crate) arguments: Vec<Value>,
    pub(crate) results: Vec<Value>,
    pub(crate) signal: Option<String>,
    pub(crate) source: String,
}

/// All assertions of a file.
pub(crate) fn assertions(text: &str) -> Vec<Assertion> {
    let text = without_comments(text);
    let mut found = Vec::new();
    let mut rest = text.as_str();
    while let Some((statement, tail)) = statement(rest) {
        // "testcase name {" opens the first statement of a block and "}" ends it.
        let body = statement.trim_start_matches(|c: char| c.is_whitespace() || c == '}');
        let body = match body.strip_prefix("testcase") {
            Some(block) => block.split_once('{').map_or("", |(_, first)| first),
            None => body,
        };
        let (left, right) = body.split_once(" = ").unwrap_or_else(|| panic!("not an assertion: {body}"));
        let mut left = tokens(left).into_iter();
        let mut right = tokens(right);
        let signal = right.iter().position(|t| t == "signal").map(|at| right.split_off(at)[1].clone());
        found.push(Assertion {
            operation: left.next().unwrap(),
            arguments: left.map(|t| value(&t)).collect(),
            results: right.iter().map(|t| value(t)).collect(),
            signal,
            source: body.split_whitespace().collect::<Vec<_>>().join(" "),
        });
        rest = tail;
    }
    found
}

fn without_comments(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(start) = rest.find("/*") {
        out.push_str(&rest[..start]);
        rest = rest[start..].split_once("*/").map_or("", |(_, tail)| tail);
    }
    out.push_str(rest);
    out.lines().map(|line| line.split("//").next().unwrap_or("").to_owned() + "\n").collect()
}

/// The text up to the next semicolon outside quotes, and what follows.
fn statement(text: &str) -> Option<(&str, &str)> {
    let mut quoted = false;
    let end = text.find(|c| {
        quoted ^= c == '"';
        c == ';' && !quoted
    })?;
    Some((&text[..end], &text[end + 1..]))
}

/// Splits at spaces and commas outside brackets, braces and quotes.
fn tokens(text: &str) -> Vec<String> {
    let (mut found, mut token, mut depth, mut quoted) = (Vec::new(), String::new(), 0, false);
    for c in text.chars() {
        match c {
            '"' => quoted = !quoted,
            '[' | '{' if !quoted => depth += 1,
            ']' | '}' if !quoted => depth -= 1,
            _ => {}
        }
        if !quoted && depth == 0 && (c.is_whitespace() || c == ',') {
            if !token.is_empty() {
                found.push(std::mem::take(&mut token));
            }
        } else {
            token.push(c);
        }
    }
    if !token.is_empty() {
        found.push(token);
    }
    found
}

fn value(token: &str) -> Value {
    let lower = token.to_ascii_lowercase();
    if let Some(text) = token.strip_prefix('"') {
        return Value::Text(text.trim_end_matches('"').to_owned());
    }
    if let Some(inner) = lower.strip_prefix('[').and_then(|t| t.strip_suffix(']')) {
        return match inner.trim() {
            "empty" => Value::Interval(Interval::EMPTY),
            "entire" => Value::Interval(Interval::ENTIRE),
            "nai" => Value::Other(lower),
            bounds => {
                let (lo, hi) = bounds.split_once(',').unwrap_or((bounds, bounds));
                Value::Interval(Interval::new(number(lo.trim()).unwrap(), number(hi.trim()).unwrap()).unwrap())
            }
        };
    }
    match lower.as_str() {
        "true" => Value::Bool(true),
        "false" => Value::Bool(false),
        _ => number(&lower).map_or(Value::Other(lower), Value::Number),
    }
}

/// A decimal to nearest, or an exact hexadecimal number.
fn number(text: &str) -> Option<f64> {
    let (negative, magnitude) = match text.strip_prefix('-') {
        Some(magnitude) => (true, magnitude),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let magnitude = match magnitude.strip_prefix("0x") {
        Some(digits) => hexadecimal(digits)?,
        None => magnitude.parse().ok()?,
    };
    Some(if negative { -magnitude } else { magnitude })
}

fn hexadecimal(text: &str) -> Option<f64> {
    let (mantissa, exponent) = text.split_once('p').unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = u64::from_str_radix(&format!("{whole}{fraction}"), 16).ok()?;
    let exponent = exponent.parse::<i32>().ok()? - 4 * fraction.len() as i32;
    // Two exact steps: the digits fill at most 60 bits, and their last ones are zero where the result is subnormal.
    let (first, second) = (exponent / 2, exponent - exponent / 2);
    Some(digits as f64 * 2f64.powi(first) * 2f64.powi(second))
}
