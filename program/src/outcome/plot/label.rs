//! Labels: text with mathematics between dollars becomes runs of characters, each with its slant, size and height.

use super::typeface;

/// Size of raised and lowered characters, relative to the line they stand on.
const SCRIPT_SIZE: f64 = 0.72;
/// How far a superscript is raised, in sizes of its line.
const RAISE: f64 = 0.38;
/// How far a subscript is lowered, in sizes of its line.
const LOWER: f64 = 0.17;
/// No index gets smaller than this, however deeply it is nested.
const SMALLEST: f64 = 0.52;
/// Nested groups beyond this depth are read flat: a guard for the stack, not a style.
const DEEPEST: usize = 8;

/// Characters in a row that look alike.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Run {
    /// The characters.
    pub(super) text: String,
    /// Slanted, as symbols are.
    pub(super) slanted: bool,
    /// Size relative to the label.
    pub(super) size: f64,
    /// Height of the baseline above that of the label, in sizes of the label.
    pub(super) rise: f64,
}

/// How the characters to come look.
#[derive(Clone, Copy)]
struct Look {
    slanted_symbols: bool,
    size: f64,
    rise: f64,
    depth: usize,
}

impl Look {
    const PLAIN: Self = Self { slanted_symbols: false, size: 1.0, rise: 0.0, depth: 0 };

    fn raised(self) -> Self {
        Self { size: (self.size * SCRIPT_SIZE).max(SMALLEST), rise: self.rise + RAISE * self.size, depth: self.depth + 1, ..self }
    }

    fn lowered(self) -> Self {
        Self { size: (self.size * SCRIPT_SIZE).max(SMALLEST), rise: self.rise - LOWER * self.size, depth: self.depth + 1, ..self }
    }
}

/// Reads a label.
pub(super) fn parse(label: &str) -> Vec<Run> {
    let characters: Vec<char> = label.chars().filter_map(printable).collect();
    let mut runs = Vec::new();
    let mut at = 0;
    while at < characters.len() {
        match characters[at] {
            '\\' if characters.get(at + 1) == Some(&'$') => {
                push(&mut runs, '$', false, Look::PLAIN);
                at += 2;
            }
            '$' => match closing_dollar(&characters, at + 1) {
                Some(end) => {
                    let math = Look { slanted_symbols: true, ..Look::PLAIN };
                    read_math(&characters[at + 1..end], math, &mut runs);
                    at = end + 1;
                }
                None => {
                    push(&mut runs, '$', false, Look::PLAIN);
                    at += 1;
                }
            },
            character => {
                push_text(&mut runs, character, Look::PLAIN);
                at += 1;
            }
        }
    }
    runs
}

/// Upright text, as it is.
pub(super) fn plain(text: &str) -> Vec<Run> {
    vec![Run { text: text.to_owned(), slanted: false, size: 1.0, rise: 0.0 }]
}

/// `front` followed by a power of ten.
pub(super) fn power_of_ten(front: &str, exponent: i32) -> Vec<Run> {
    let mut runs = plain(&format!("{front}10"));
    let look = Look::PLAIN.raised();
    for digit in exponent.to_string().chars() {
        push(&mut runs, if digit == '-' { '−' } else { digit }, false, look);
    }
    runs
}

/// Width of the runs at this text size.
pub(super) fn width(runs: &[Run], size: f64) -> f64 {
    runs.iter().map(|run| run_width(run, size)).sum()
}

/// Width of one run at this text size.
pub(super) fn run_width(run: &Run, size: f64) -> f64 {
    run.text.chars().map(typeface::advance).sum::<f64>() * run.size * size
}

/// Breaks the runs at spaces of the plain text into lines no wider than `limit` (a single long word may still be).
pub(super) fn wrap(runs: &[Run], size: f64, limit: f64) -> Vec<Vec<Run>> {
    let mut lines: Vec<Vec<Run>> = vec![Vec::new()];
    for word in words(runs) {
        let last = lines.len() - 1;
        let mut longer = lines[last].clone();
        if !longer.is_empty() {
            append(&mut longer, &plain(" "));
        }
        append(&mut longer, &word);
        if lines[last].is_empty() || width(&longer, size) <= limit {
            lines[last] = longer;
        } else {
            lines.push(word);
        }
    }
    lines
}

fn words(runs: &[Run]) -> Vec<Vec<Run>> {
    let mut words: Vec<Vec<Run>> = vec![Vec::new()];
    for run in runs {
        for (index, piece) in run.text.split(' ').enumerate() {
            if index > 0 {
                words.push(Vec::new());
            }
            if let (false, Some(word)) = (piece.is_empty(), words.last_mut()) {
                append(word, &[Run { text: piece.to_owned(), ..run.clone() }]);
            }
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

fn append(line: &mut Vec<Run>, runs: &[Run]) {
    for run in runs {
        match line.last_mut() {
            Some(last) if alike(last, run.slanted, run.size, run.rise) => last.text.push_str(&run.text),
            _ => line.push(run.clone()),
        }
    }
}

fn alike(run: &Run, slanted: bool, size: f64, rise: f64) -> bool {
    run.slanted == slanted && (run.size - size).abs() < 1e-9 && (run.rise - rise).abs() < 1e-9
}

fn push(runs: &mut Vec<Run>, character: char, slanted: bool, look: Look) {
    match runs.last_mut() {
        Some(last) if alike(last, slanted, look.size, look.rise) => last.text.push(character),
        _ => runs.push(Run { text: character.into(), slanted, size: look.size, rise: look.rise }),
    }
}

/// Control characters, which XML forbids, and private characters, which look different in every typeface, do not pass.
fn printable(character: char) -> Option<char> {
    match character {
        '\t' | '\n' | '\r' => Some(' '),
        '\u{e000}'..='\u{f8ff}' | '\u{fffe}' | '\u{ffff}' => None,
        other if other.is_control() => None,
        other => Some(other),
    }
}

fn closing_dollar(characters: &[char], from: usize) -> Option<usize> {
    (from..characters.len()).find(|&at| characters[at] == '$' && characters[at - 1] != '\\')
}

/// A character of plain text; raised and lowered characters of Unicode become true indices, which every typeface has.
fn push_text(runs: &mut Vec<Run>, character: char, look: Look) {
    const RAISED: [(char, char); 13] = [
        ('⁰', '0'),
        ('¹', '1'),
        ('²', '2'),
        ('³', '3'),
        ('⁴', '4'),
        ('⁵', '5'),
        ('⁶', '6'),
        ('⁷', '7'),
        ('⁸', '8'),
        ('⁹', '9'),
        ('⁺', '+'),
        ('⁻', '−'),
        ('ⁿ', 'n'),
    ];
    if let Some((_, base)) = RAISED.iter().find(|(raised, _)| *raised == character) {
        push(runs, *base, false, look.raised());
    } else if ('₀'..='₉').contains(&character) {
        let digit = u32::from(character) - u32::from('₀');
        push(runs, char::from_digit(digit, 10).unwrap_or(character), false, look.lowered());
    } else {
        push(runs, character, false, look);
    }
}

fn read_math(characters: &[char], look: Look, runs: &mut Vec<Run>) {
    let mut at = 0;
    while at < characters.len() {
        at = read_item(characters, at, look, runs);
    }
}

/// Reads one symbol, command, group or index at `at`; returns the place after it.
fn read_item(characters: &[char], at: usize, look: Look, runs: &mut Vec<Run>) -> usize {
    match characters[at] {
        ' ' | '}' => at + 1,
        '{' => {
            let end = closing_brace(characters, at);
            let inner = Look { depth: look.depth + 1, ..look };
            read_group(&characters[at + 1..end], inner, runs);
            end + 1
        }
        '^' | '_' => {
            let inner = if characters[at] == '^' { look.raised() } else { look.lowered() };
            let next = skip_spaces(characters, at + 1);
            if next < characters.len() { read_argument(characters, next, inner, runs) } else { next }
        }
        '\\' => read_command(characters, at, look, runs),
        '-' => {
            push(runs, '−', false, look);
            at + 1
        }
        '\'' => {
            push(runs, '′', false, look);
            at + 1
        }
        sign @ ('=' | '<' | '>' | '≤' | '≥' | '≈' | '≪' | '≫' | '∝' | '≠' | '~') => {
            push_relation(runs, if sign == '~' { '∼' } else { sign }, look);
            at + 1
        }
        character => {
            if is_symbol(character) && look.slanted_symbols {
                push(runs, character, true, look);
            } else {
                push_text(runs, character, look);
            }
            at + 1
        }
    }
}

fn read_group(characters: &[char], look: Look, runs: &mut Vec<Run>) {
    if look.depth > DEEPEST {
        for character in characters.iter().filter(|c| !matches!(c, '{' | '}' | '\\' | '^' | '_')) {
            push(runs, *character, false, look);
        }
    } else {
        read_math(characters, look, runs);
    }
}

/// The argument of a command or an index: a group, or the next item.
fn read_argument(characters: &[char], at: usize, look: Look, runs: &mut Vec<Run>) -> usize {
    if characters[at] == '{' {
        let end = closing_brace(characters, at);
        read_group(&characters[at + 1..end], look, runs);
        end + 1
    } else if matches!(characters[at], '^' | '_') {
        at + 1 // an index without a base: nothing sensible to draw
    } else {
        read_item(characters, at, look, runs)
    }
}

fn read_command(characters: &[char], at: usize, look: Look, runs: &mut Vec<Run>) -> usize {
    let name: String = characters[at + 1..].iter().take_while(|c| c.is_ascii_alphabetic()).collect();
    let after = at + 1 + name.len();
    if name.is_empty() {
        return match characters.get(at + 1) {
            Some(',' | ';' | ':' | ' ') => {
                push(runs, '\u{2009}', false, look);
                at + 2
            }
            Some('!') => at + 2,
            Some(other) => {
                push(runs, *other, false, look);
                at + 2
            }
            None => at + 1,
        };
    }
    let argument = |look: Look, runs: &mut Vec<Run>| {
        let next = skip_spaces(characters, after);
        if next < characters.len() { read_argument(characters, next, look, runs) } else { next }
    };
    let upright = Look { slanted_symbols: false, ..look };
    match name.as_str() {
        "mathrm" | "mathsf" | "operatorname" | "rm" => argument(upright, runs),
        "text" | "textrm" => {
            let next = skip_spaces(characters, after);
            if characters.get(next) != Some(&'{') {
                return argument(upright, runs);
            }
            let end = closing_brace(characters, next);
            for character in &characters[next + 1..end] {
                push_text(runs, *character, upright);
            }
            end + 1
        }
        "frac" => {
            let next = argument(look, runs);
            push(runs, '/', false, look);
            let next = skip_spaces(characters, next);
            if next < characters.len() { read_argument(characters, next, look, runs) } else { next }
        }
        "sqrt" => {
            push(runs, '√', false, look);
            push(runs, '(', false, look);
            let next = argument(look, runs);
            push(runs, ')', false, look);
            next
        }
        "hat" | "bar" | "dot" | "tilde" => {
            let accent = match name.as_str() {
                "hat" => '\u{302}',
                "bar" => '\u{304}',
                "dot" => '\u{307}',
                _ => '\u{303}',
            };
            let next = argument(look, runs);
            if let Some(last) = runs.last_mut() {
                last.text.push(accent);
            }
            next
        }
        "left" | "right" | "big" | "displaystyle" | "mathit" => after,
        _ => {
            match sign(&name) {
                Some((character, true)) => push_relation(runs, character, look),
                Some((character, false)) => push(runs, character, look.slanted_symbols && is_small_greek(character), look),
                None => name.chars().for_each(|character| push(runs, character, false, look)),
            }
            after
        }
    }
}

fn push_relation(runs: &mut Vec<Run>, character: char, look: Look) {
    for part in ['\u{2009}', character, '\u{2009}'] {
        push(runs, part, false, look);
    }
}

fn skip_spaces(characters: &[char], from: usize) -> usize {
    (from..characters.len()).find(|&at| characters[at] != ' ').unwrap_or(characters.len())
}

/// The brace that closes the one at `open`, or the end of the label.
fn closing_brace(characters: &[char], open: usize) -> usize {
    let mut depth = 0_usize;
    for (at, character) in characters.iter().enumerate().skip(open) {
        match character {
            '{' => depth += 1,
            '}' => {
                depth = depth.saturating_sub(1);
                if depth == 0 {
                    return at;
                }
            }
            _ => {}
        }
    }
    characters.len()
}

fn is_symbol(character: char) -> bool {
    character.is_ascii_alphabetic() || is_small_greek(character)
}

fn is_small_greek(character: char) -> bool {
    matches!(character, 'α'..='ω' | 'ϑ' | 'ϕ' | 'ϵ' | 'ℓ' | '∂')
}

/// The character of a command, and whether it is a relation that wants room on both sides.
fn sign(name: &str) -> Option<(char, bool)> {
    const SIGNS: [(&str, char); 50] = [
        ("alpha", 'α'),
        ("beta", 'β'),
        ("gamma", 'γ'),
        ("delta", 'δ'),
        ("epsilon", 'ϵ'),
        ("varepsilon", 'ε'),
        ("zeta", 'ζ'),
        ("eta", 'η'),
        ("theta", 'θ'),
        ("vartheta", 'ϑ'),
        ("iota", 'ι'),
        ("kappa", 'κ'),
        ("lambda", 'λ'),
        ("mu", 'μ'),
        ("nu", 'ν'),
        ("xi", 'ξ'),
        ("pi", 'π'),
        ("rho", 'ρ'),
        ("sigma", 'σ'),
        ("tau", 'τ'),
        ("upsilon", 'υ'),
        ("phi", 'ϕ'),
        ("varphi", 'φ'),
        ("chi", 'χ'),
        ("psi", 'ψ'),
        ("omega", 'ω'),
        ("Gamma", 'Γ'),
        ("Delta", 'Δ'),
        ("Theta", 'Θ'),
        ("Lambda", 'Λ'),
        ("Xi", 'Ξ'),
        ("Pi", 'Π'),
        ("Sigma", 'Σ'),
        ("Phi", 'Φ'),
        ("Psi", 'Ψ'),
        ("Omega", 'Ω'),
        ("infty", '∞'),
        ("partial", '∂'),
        ("nabla", '∇'),
        ("ell", 'ℓ'),
        ("hbar", 'ℏ'),
        ("times", '×'),
        ("cdot", '·'),
        ("pm", '±'),
        ("circ", '°'),
        ("degree", '°'),
        ("prime", '′'),
        ("int", '∫'),
        ("sum", '∑'),
        ("ldots", '…'),
    ];
    const RELATIONS: [(&str, char); 13] = [
        ("approx", '≈'),
        ("sim", '∼'),
        ("simeq", '≃'),
        ("propto", '∝'),
        ("le", '≤'),
        ("leq", '≤'),
        ("ge", '≥'),
        ("geq", '≥'),
        ("ll", '≪'),
        ("gg", '≫'),
        ("ne", '≠'),
        ("neq", '≠'),
        ("to", '→'),
    ];
    let plain = SIGNS.iter().find(|(known, _)| *known == name).map(|(_, character)| (*character, false));
    plain.or_else(|| RELATIONS.iter().find(|(known, _)| *known == name).map(|(_, character)| (*character, true)))
}
