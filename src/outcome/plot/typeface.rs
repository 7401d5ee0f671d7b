//! How wide a character is: the advance widths of DejaVu Sans, in 2048ths of the text size.
//!
//! kuva carries the typeface and draws with it, and keeps its widths private; these are the same numbers (its `text_metrics/data.rs`, version 0.6.0) for the
//! characters a physics label needs. The slanted face has the same widths for all of them but χ (2 % wider). A character that is not listed counts one em,
//! which reserves too much room rather than too little. Arial and Helvetica, which an SVG viewer may use instead, are narrower.

/// Units in one em.
const UNITS_PER_EM: f64 = 2048.0;
/// From U+0020 on.
const ASCII: [u16; 95] = [
    651, 821, 942, 1716, 1303, 1946, 1597, 563, 799, 799, 1024, 1716, 651, 739, 651, 690, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303,
    1303, 1303, 690, 690, 1716, 1716, 1716, 1087, 2048, 1401, 1405, 1430, 1577, 1294, 1178, 1587, 1540, 604, 604, 1343, 1141, 1767, 1532,
    1612, 1235, 1612, 1423, 1300, 1251, 1499, 1401, 2025, 1403, 1251, 1403, 799, 690, 799, 1716, 1024, 1024, 1255, 1300, 1126, 1300, 1260,
    721, 1300, 1298, 569, 569, 1186, 569, 1995, 1298, 1253, 1300, 1300, 842, 1067, 803, 1298, 1212, 1675, 1212, 1212, 1075, 1303, 690,
    1303, 1716,
];
/// From U+00A0 on.
const LATIN: [u16; 96] = [
    651, 821, 1303, 1303, 1303, 1303, 690, 1024, 1024, 2048, 965, 1253, 1716, 739, 2048, 1024, 1024, 1716, 821, 821, 1024, 1303, 1303, 651,
    1024, 821, 965, 1253, 1985, 1985, 1985, 1087, 1401, 1401, 1401, 1401, 1401, 1401, 1995, 1430, 1294, 1294, 1294, 1294, 604, 604, 604,
    604, 1587, 1532, 1612, 1612, 1612, 1612, 1612, 1716, 1612, 1499, 1499, 1499, 1499, 1251, 1239, 1290, 1255, 1255, 1255, 1255, 1255,
    1255, 2011, 1126, 1260, 1260, 1260, 1260, 569, 569, 569, 569, 1253, 1298, 1253, 1253, 1253, 1253, 1253, 1716, 1253, 1298, 1298, 1298,
    1298, 1212, 1300, 1212,
];
/// From U+0391 on.
const GREEK: [u16; 57] = [
    1401, 1405, 1141, 1401, 1294, 1403, 1540, 1612, 604, 1343, 1401, 1767, 1532, 1294, 1612, 1540, 1235, 0, 1294, 1251, 1251, 1612, 1403,
    1612, 1565, 604, 1251, 1350, 1107, 1298, 693, 1185, 1350, 1307, 1212, 1253, 1107, 1114, 1298, 1253, 693, 1207, 1212, 1303, 1144, 1142,
    1253, 1233, 1300, 1202, 1298, 1233, 1185, 1351, 1183, 1351, 1715,
];
/// Signs of mathematics and typography.
const SIGNS: [(char, u16); 36] = [
    ('\u{2009}', 409),
    ('\u{200a}', 204),
    ('\u{2013}', 1024),
    ('\u{2014}', 2048),
    ('\u{2019}', 651),
    ('\u{2020}', 1024),
    ('\u{2026}', 2048),
    ('\u{2032}', 465),
    ('\u{210f}', 1298),
    ('\u{2113}', 846),
    ('\u{2192}', 1716),
    ('\u{2202}', 1059),
    ('\u{2207}', 1370),
    ('\u{2211}', 1380),
    ('\u{2212}', 1716),
    ('\u{2218}', 1282),
    ('\u{221a}', 1305),
    ('\u{221d}', 1463),
    ('\u{221e}', 1706),
    ('\u{2225}', 1024),
    ('\u{222b}', 1067),
    ('\u{223c}', 1716),
    ('\u{2243}', 1716),
    ('\u{2248}', 1716),
    ('\u{2260}', 1716),
    ('\u{2264}', 1716),
    ('\u{2265}', 1716),
    ('\u{226a}', 2144),
    ('\u{226b}', 2144),
    ('\u{22a5}', 1784),
    ('\u{22c5}', 651),
    ('\u{27e8}', 799),
    ('\u{27e9}', 799),
    ('\u{3d1}', 1268),
    ('\u{3d5}', 1351),
    ('\u{3f5}', 1260),
];

/// The advance width of a character at text size 1.
pub(super) fn advance(character: char) -> f64 {
    let code = character as usize;
    let listed = |table: &[u16], first: usize| code.checked_sub(first).and_then(|index| table.get(index)).copied();
    let units = match code {
        0x0300..=0x036f => 0, // accents stand on the character before them
        _ => listed(&ASCII, 0x20)
            .or_else(|| listed(&LATIN, 0xa0))
            .or_else(|| listed(&GREEK, 0x391))
            .or_else(|| SIGNS.iter().find(|(sign, _)| *sign == character).map(|(_, units)| *units))
            .unwrap_or(2048),
    };
    f64::from(units) / UNITS_PER_EM
}
