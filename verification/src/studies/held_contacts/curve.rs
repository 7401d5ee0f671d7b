//! All contacts of one material, speed and adhesion: the contacts of a row of half-widths, joined to curves.
//!
//! Contacts of neighbouring half-widths are joined where there are equally many of them and each has one near it; elsewhere the row is made finer until there are or
//! until what happens is known to 1e-9 of the half-width: two contacts meet (the curve turns back in the half-width) or one ends (an edge is pressed, faces meet, the
//! zone fills the gap). No contact is followed from another one.

use super::width::{Bodies, Equilibrium};
use std::f64::consts::PI;
use viscotack::refusal::Refusal;
use viscotack::sliding::contact::Indenter;

/// Neighbours are joined if they are nearer than this: |Δe| over the width, |Δp̄| over its size.
const NEAR: f64 = 0.2;
/// Rows are made finer where what is joined differs more than this.
const SMOOTH: f64 = 0.08;
/// The shortest interval between two rows, in ln tan(a/2).
const SHORTEST: f64 = 1e-7;
/// The shortest one where as many contacts are on both sides.
const SHORT: f64 = 2e-3;
/// Rows at most: more only where what exists is lost in rounding.
const MOST_ROWS: usize = 1500;

/// One end of a strand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// The row ends there.
    Row,
    /// It meets another strand, which begins (or ends) at the same half-width.
    Meets(usize),
    /// No contact beyond: the equilibrium there, if there is one, cannot exist.
    Stops {
        /// The largest edge amplitude of the nearest equilibrium beyond.
        amplitude: f64,
        /// Its smallest gap.
        gap: f64,
    },
}

/// Contacts of growing half-width, joined.
#[derive(Debug, Clone)]
pub struct Strand {
    /// In growing half-width.
    pub contacts: Vec<Equilibrium>,
    /// At the smallest half-width.
    pub begins: End,
    /// At the largest one.
    pub ends: End,
}

/// All contacts of one speed.
#[derive(Debug)]
pub struct Curves {
    /// The strands.
    pub strands: Vec<Strand>,
    /// Rows that were computed.
    pub rows: usize,
    /// Half-widths at which nothing could be computed.
    pub refused: usize,
}

/// The range of ln tan(a/2) in which contacts are looked for.
#[must_use]
pub fn range(bodies: &Bodies) -> (f64, f64) {
    let beta = bodies.memory.stiffening_ratio();
    // Half of a gap that is as narrow as three zones: in a narrower one both zones meet, and there are no two edges any more.
    let (work, zones) = bodies.adhesion.map_or((0.0, 0.0), |adhesion| {
        let (behind, ahead) = (adhesion.trailing_zone, adhesion.leading_zone);
        (adhesion.trailing_work.min(adhesion.leading_work), 0.5 * (behind + ahead + behind.max(ahead)))
    });
    // Without load a glassy contact has a³ = 32Γ/β; pull-off is at a fraction of it.
    let narrow = if work > 0.0 { 0.02 * (32.0 * work / beta).cbrt() } else { 1e-3 };
    let narrow = narrow.min(0.05);
    let wide = match bodies.indenter {
        Indenter::Wave => -(0.5 * zones).max(5e-4).tan().ln(),
        Indenter::Parabola => 3.0_f64.ln(),
    };
    ((0.5 * narrow).ln(), wide)
}

struct Row {
    place: f64,
    contacts: Vec<Equilibrium>,
}

/// How far apart two contacts of about the same half-width are.
#[must_use]
pub fn distance(indenter: Indenter, one: &Equilibrium, other: &Equilibrium) -> f64 {
    let mut ahead = other.eccentricity - one.eccentricity;
    if indenter == Indenter::Wave {
        ahead -= 2.0 * PI * (ahead / (2.0 * PI)).round();
    }
    let pressure = (one.mean_pressure - other.mean_pressure).abs() / (one.mean_pressure.abs() + other.mean_pressure.abs() + 1e-2);
    ahead.abs() / one.half_width.min(1.0) + pressure
}

/// Pairs (index in the narrower row, index in the wider one) of nearest contacts, and the largest distance.
fn pairs(indenter: Indenter, narrow: &Row, wide: &Row) -> (Vec<(usize, usize)>, f64) {
    let mut all: Vec<(f64, usize, usize)> = Vec::new();
    for (i, one) in narrow.contacts.iter().enumerate() {
        for (j, other) in wide.contacts.iter().enumerate() {
            all.push((distance(indenter, one, other), i, j));
        }
    }
    all.sort_by(|one, other| one.0.total_cmp(&other.0));
    let (mut found, mut largest): (Vec<(usize, usize)>, f64) = (Vec::new(), 0.0);
    for (far, i, j) in all {
        if far < NEAR && !found.iter().any(|&(one, other)| one == i || other == j) {
            found.push((i, j));
            largest = largest.max(far);
        }
    }
    (found, largest)
}

fn refined(bodies: &Bodies, rows: &mut Vec<Row>, from: Row, to: Row, refused: &mut usize) {
    let mut open = vec![to];
    let mut here = from;
    while let Some(next) = open.pop() {
        let length = next.place - here.place;
        let (joined, far) = pairs(bodies.indenter, &here, &next);
        let complete = joined.len() == here.contacts.len() && joined.len() == next.contacts.len();
        let fine = rows.len() > MOST_ROWS || if complete { far < SMOOTH || length < SHORT } else { length < SHORTEST };
        if fine {
            rows.push(here);
            here = next;
            continue;
        }
        let place = 0.5 * (here.place + next.place);
        let contacts = bodies.contacts(place).unwrap_or_else(|_| {
            *refused += 1;
            Vec::new()
        });
        open.push(next);
        open.push(Row { place, contacts });
    }
    rows.push(here);
}

impl Curves {
    /// From `count` half-widths, and as many more as it takes.
    ///
    /// # Errors
    /// None at present: half-widths that refuse are counted.
    pub fn new(bodies: &Bodies, count: usize) -> Result<Self, Refusal> {
        let (low, high) = range(bodies);
        let mut refused = 0;
        let coarse: Vec<Row> = (0..=count)
            .map(|index| {
                let place = low + (high - low) * index as f64 / count as f64;
                let contacts = bodies.contacts(place).unwrap_or_else(|_| {
                    refused += 1;
                    Vec::new()
                });
                Row { place, contacts }
            })
            .collect();
        let mut rows: Vec<Row> = Vec::new();
        let mut iterator = coarse.into_iter();
        if let Some(first) = iterator.next() {
            rows.push(first);
        }
        for next in iterator {
            if let Some(last) = rows.pop() {
                refined(bodies, &mut rows, last, next, &mut refused);
            }
        }
        let strands = joined(bodies, &rows);
        Ok(Self { strands, rows: rows.len(), refused })
    }
}

fn joined(bodies: &Bodies, rows: &[Row]) -> Vec<Strand> {
    let mut strands: Vec<Strand> = Vec::new();
    // The strand that each contact of the last row belongs to.
    let mut open: Vec<usize> = Vec::new();
    let begun = |strands: &mut Vec<Strand>, contact: &Equilibrium, begins: End| {
        strands.push(Strand { contacts: vec![*contact], begins, ends: End::Row });
        strands.len() - 1
    };
    for (index, row) in rows.iter().enumerate() {
        let Some(before) = index.checked_sub(1).and_then(|index| rows.get(index)) else {
            open = row.contacts.iter().map(|contact| begun(&mut strands, contact, End::Row)).collect();
            continue;
        };
        let (pairs, _) = pairs(bodies.indenter, before, row);
        // What ends before this row.
        let ended: Vec<usize> = (0..before.contacts.len()).filter(|i| !pairs.iter().any(|(one, _)| one == i)).collect();
        let begins: Vec<usize> = (0..row.contacts.len()).filter(|j| !pairs.iter().any(|(_, other)| other == j)).collect();
        let met = |row: &Row, list: &[usize]| -> Vec<Option<usize>> {
            list.iter()
                .map(|&i| {
                    list.iter().copied().find(|&k| {
                        k != i
                            && row
                                .contacts
                                .get(i)
                                .zip(row.contacts.get(k))
                                .is_some_and(|(one, other)| distance(bodies.indenter, one, other) < NEAR)
                    })
                })
                .collect()
        };
        let stopped = |place: f64, contact: &Equilibrium| {
            let beyond = bodies.equilibria(place).unwrap_or_default();
            let nearest = beyond
                .iter()
                .filter(|other| distance(bodies.indenter, contact, other) < NEAR)
                .min_by(|one, other| distance(bodies.indenter, contact, one).total_cmp(&distance(bodies.indenter, contact, other)));
            nearest.map_or(End::Stops { amplitude: f64::NAN, gap: f64::NAN }, |found| End::Stops {
                amplitude: found.largest_amplitude,
                gap: found.smallest_gap,
            })
        };
        for (&i, meets) in ended.iter().zip(met(before, &ended)) {
            let other = meets.and_then(|k| open.get(k).copied());
            let (Some(&strand), Some(contact)) = (open.get(i), before.contacts.get(i)) else { continue };
            let end = other.map_or_else(|| stopped(row.place, contact), End::Meets);
            if let Some(strand) = strands.get_mut(strand) {
                strand.ends = end;
            }
        }
        let mut next = vec![usize::MAX; row.contacts.len()];
        for &(i, j) in &pairs {
            if let (Some(&strand), Some(contact), Some(place)) = (open.get(i), row.contacts.get(j), next.get_mut(j)) {
                if let Some(strand) = strands.get_mut(strand) {
                    strand.contacts.push(*contact);
                }
                *place = strand;
            }
        }
        let meets = met(row, &begins);
        for &j in &begins {
            if let (Some(contact), Some(place)) = (row.contacts.get(j), next.get_mut(j)) {
                *place = begun(&mut strands, contact, stopped(before.place, contact));
            }
        }
        for (&j, meets) in begins.iter().zip(meets) {
            if let (Some(&strand), Some(other)) = (next.get(j), meets.and_then(|k| next.get(k).copied()))
                && let Some(strand) = strands.get_mut(strand)
            {
                strand.begins = End::Meets(other);
            }
        }
        open = next;
    }
    strands
}
