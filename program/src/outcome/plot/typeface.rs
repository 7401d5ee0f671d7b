//! The typeface: how wide a character is and what its outline looks like, read from the font files in the program.
//!
//! `font/` holds DejaVu Sans and DejaVu Sans Oblique 2.37 (the licence lies beside them), without hinting and reduced with the tool `pyftsubset` of
//! fonttools 4 to the characters below. Arial and Helvetica, which an SVG viewer may use instead, are narrower.
//!
//! | face | characters |
//! |---|---|
//! | upright | U+0020-007E, 00A0-017F, 0300-030C, 0323, 0327, 0328, 0391-03C9, 03D1, 03D5, 03F5, 0400-045F, 2009, 200A, 2010-2015, 2018-201E, 2020-2022, 2026, 2030, 2032, 2033, 2070-208E, 210F, 2113, 2190-2194, 21D2, 21D4, 2200-222B, 2234, 223C, 2243, 2245, 2248, 2260-2265, 226A, 226B, 2272, 2273, 22A5, 22C5, 27E8, 27E9 |
//! | oblique | U+0041-005A, 0061-007A, 0300-030C, 0391-03C9, 03D1, 03D5, 03F5, 2113, 2202 |
//!
//! A character without an outline is drawn as a box and counts one em, which reserves too much room rather than too little.

use std::sync::LazyLock;

use ttf_parser::{Face, GlyphId, OutlineBuilder, Rect};

static UPRIGHT: LazyLock<Option<Face<'static>>> = LazyLock::new(|| Face::parse(include_bytes!("font/DejaVuSans.ttf"), 0).ok());
static OBLIQUE: LazyLock<Option<Face<'static>>> = LazyLock::new(|| Face::parse(include_bytes!("font/DejaVuSans-Oblique.ttf"), 0).ok());
/// The glyph that every font has for characters it does not know: a box.
const BOX: GlyphId = GlyphId(0);

/// The advance width of a character at text size 1, slanted or not: the slanted face differs for χ only, which is 2 % wider.
pub(super) fn advance(character: char) -> f64 {
    if is_accent(character) {
        return 0.0;
    }
    let units = UPRIGHT.as_ref().and_then(|face| Some(ems(face, face.glyph_hor_advance(face.glyph_index(character)?)?)));
    units.unwrap_or(1.0)
}

/// The outline of one character and where it stands, in text sizes from the beginning of the line.
pub(super) struct Glyph {
    face: &'static Face<'static>,
    id: GlyphId,
    pub(super) right: f64,
    pub(super) up: f64,
}

impl Glyph {
    /// Draws the outline in units of the font; [`Self::scale`] of them are one text size.
    pub(super) fn outline(&self, pen: &mut dyn OutlineBuilder) {
        self.face.outline_glyph(self.id, pen);
    }

    /// The part of the text size that a unit of the outline is.
    pub(super) fn scale(&self) -> f64 {
        ems(self.face, 1_u16)
    }
}

/// The outlines of a line of text.
pub(super) fn glyphs(text: &str, slanted: bool) -> Vec<Glyph> {
    let mut glyphs: Vec<Glyph> = Vec::new();
    let mut right = 0.0;
    for character in text.chars() {
        let Some((face, id)) = find(character, slanted) else { continue };
        let mut glyph = Glyph { face, id, right, up: 0.0 };
        if let (true, Some(base)) = (is_accent(character), glyphs.last()) {
            (glyph.right, glyph.up) = above(base, &glyph).unwrap_or((right, 0.0));
        }
        glyphs.push(glyph);
        right += advance(character);
    }
    glyphs
}

/// The outline of a character: a slanted one that only the upright face has stays upright; none for an accent that no face has.
fn find(character: char, slanted: bool) -> Option<(&'static Face<'static>, GlyphId)> {
    let upright = UPRIGHT.as_ref()?;
    let oblique = OBLIQUE.as_ref().filter(|_| slanted);
    let known = oblique.into_iter().chain([upright]).find_map(|face| Some((face, face.glyph_index(character)?)));
    known.or_else(|| (!is_accent(character)).then_some((upright, BOX)))
}

/// Accents stand on the character before them.
fn is_accent(character: char) -> bool {
    matches!(character, '\u{300}'..='\u{36f}')
}

/// Where an accent stands: over the middle of the character before it, along its slant, and higher on a character taller than an x.
fn above(base: &Glyph, accent: &Glyph) -> Option<(f64, f64)> {
    let box_of = |glyph: &Glyph| glyph.face.glyph_bounding_box(glyph.id);
    let (below, mark) = (box_of(base)?, box_of(accent)?);
    let height_of_x = base.face.glyph_bounding_box(base.face.glyph_index('x')?)?.y_max;
    let raise = if mark.y_min > 0 { f64::from((below.y_max - height_of_x).max(0)) } else { 0.0 };
    let middle = |area: Rect| (0.5 * f64::from(area.x_min + area.x_max), 0.5 * f64::from(area.y_min + area.y_max));
    let (under, over) = (middle(below), middle(mark));
    let slant = f64::from(-base.face.italic_angle()).to_radians().tan();
    let right = under.0 + slant * (over.1 + raise - under.1) - over.0;
    Some((base.right + base.scale() * right, base.scale() * raise))
}

fn ems(face: &Face<'_>, units: u16) -> f64 {
    f64::from(units) / f64::from(face.units_per_em())
}
