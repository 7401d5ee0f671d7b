//! Which contact a held load, penetration or half-width has, read off the curves.
//!
//! ```text
//!   held ^        S = snap-in                loading:   from the stable contact of the least load upward; at a limit on to the next wider stable contact
//!        |      ,´ `.                                   of that load, else to full contact
//!        |    ,´ ·   `.                      unloading: from full contact downward: the widest stable contact; at a limit on to the next narrower one,
//!        |  ,´ stable  ·  unstable                      else to no contact
//!        | P = pull-off
//!        +------------------- half-width
//! ```

use super::curve::{Curves, End, distance};
use super::pieces::{Border, Piece, Quantity, depth, load, nearest, pieces, whole};
use super::stability::{Held, Variations};
use super::width::{Bodies, Equilibrium};
use viscotack::refusal::Refusal;
use viscotack::sliding::contact::{ContactEdges, Indenter, Prescribed};

/// How what is held was reached.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reached {
    /// Raised from the least.
    Loading,
    /// Lowered from full contact.
    Unloading,
}

/// What there is at a held value.
#[derive(Debug, Clone, PartialEq)]
pub enum Expected {
    /// This contact.
    Contact {
        /// The contact.
        contact: Equilibrium,
        /// How many other stable contacts carry the same.
        others: usize,
    },
    /// No partial contact: full contact, beyond this limit.
    Full(f64),
    /// No contact, below this limit, or above it where the edges of the last contact would be pressed or its faces would meet.
    Nothing(f64),
    /// No partial contact is stable at this speed whatever is held.
    NoPartial,
    /// What happens depends on contacts whose gap is narrower than three zones, or on contacts that were not computed: not assessed.
    Unknown,
}

/// All contacts of one speed, ready to be asked.
#[derive(Debug)]
pub struct Speed {
    /// Material, speed, adhesion.
    pub bodies: Bodies,
    /// The same at the finest resolution.
    pub finest: Bodies,
    /// Contacts stable under their load, by half-width.
    pub by_load: Vec<Piece>,
    /// Contacts stable at their penetration, by half-width.
    pub by_depth: Vec<Piece>,
    /// Pieces whose stability changes between two turns.
    pub changes: usize,
    /// Rows computed.
    pub rows: usize,
}

/// Samples of the stability of a piece.
const SAMPLES: usize = 4;
/// Pieces of a smaller span, relative to the size of what is held, are rounding.
const NOISE: f64 = 1e-7;
/// A margin nearer to zero is not resolved. Both resolutions agree on smaller ones; along a gap of a hundredth, which both edges can move together, all margins are some
/// 1e-5.
const UNRESOLVED: f64 = 1e-5;
/// Contacts nearer than this, over their size, are one.
const SAME: f64 = 1e-3;
/// Halvings between a stable contact and its unstable neighbour.
const HALVINGS: usize = 14;

impl Speed {
    /// Scans all half-widths.
    ///
    /// # Errors
    /// Those of the curves.
    pub fn new(bodies: Bodies, finest: Bodies, rows: usize, depths: bool) -> Result<Self, Refusal> {
        let curves = Curves::new(&bodies, rows)?;
        let mut changes = 0;
        let mut stable = |quantity: Quantity, held: Held| {
            let mut found: Vec<Piece> = Vec::new();
            let all = match bodies.adhesion {
                Some(_) => pieces(&bodies, &curves, quantity),
                // One contact a half-width, its load and depth grow with it: turns would be rounding.
                None => whole(&curves),
            };
            for piece in all {
                let [low, high] = piece.span(quantity);
                if high - low > NOISE * (low.abs() + high.abs()) {
                    found.extend(stable_parts(&bodies, piece, held, &mut changes));
                }
            }
            found
        };
        let by_load = joined(stable(load, Held::Load), bodies.indenter, load);
        let by_depth = if depths { joined(stable(depth, Held::Penetration), bodies.indenter, depth) } else { Vec::new() };
        Ok(Self { bodies, finest, by_load, by_depth, changes, rows: curves.rows })
    }

    fn of(&self, held: Held) -> (&[Piece], Quantity) {
        match held {
            Held::Penetration => (&self.by_depth, depth),
            _ => (&self.by_load, load),
        }
    }

    /// The limits of every stable segment.
    #[must_use]
    pub fn limits(&self, held: Held) -> Vec<[f64; 2]> {
        let (stable, quantity) = self.of(held);
        stable.iter().map(|stable| stable.span(quantity)).collect()
    }

    /// What a held value has.
    #[must_use]
    pub fn expected(&self, held: Held, value: f64, reached: Reached) -> Expected {
        if self.bodies.adhesion.is_none()
            && let Some(expected) = self.without_adhesion(held, value)
        {
            return expected;
        }
        let (stable, quantity) = self.of(held);
        let contact_at = |stable: &Piece, value: f64| stable.at(&self.bodies, quantity, value);
        let mut all: Vec<Equilibrium> = stable.iter().filter_map(|stable| contact_at(stable, value)).collect();
        // Where the pull is lost in the rounding of the load, a curve turns back and forth in it: between two stable contacts there is an unstable one, never so near.
        all.dedup_by(|one, other| {
            (one.half_width / other.half_width - 1.0).abs() < SAME && distance(self.bodies.indenter, one, other) < SAME
        });
        let lower = |stable: &Piece| stable.span(quantity)[0];
        let upper = |stable: &Piece| stable.span(quantity)[1];
        let carries = |stable: &Piece, value: f64| lower(stable) < value && value < upper(stable);
        let start = match reached {
            Reached::Loading => stable.iter().min_by(|one, other| lower(one).total_cmp(&lower(other))),
            Reached::Unloading => stable.iter().max_by(|one, other| upper(one).total_cmp(&upper(other))),
        };
        let Some(mut here) = start else { return Expected::NoPartial };
        let beyond = |stable: &Piece, up: bool| {
            let limit = if up { upper(stable) } else { lower(stable) };
            match stable.border(quantity, up) {
                Border::Strand(End::Row) => Expected::Unknown,
                // Beyond a turn, and beyond an edge that becomes unstable by itself, nothing but full contact is left of a wave.
                Border::Turn | Border::Stability if up && self.bodies.indenter == Indenter::Wave => Expected::Full(limit),
                _ => Expected::Nothing(limit),
            }
        };
        if reached == Reached::Loading && value < lower(here) {
            return beyond(here, false);
        }
        if reached == Reached::Unloading && value > upper(here) {
            return beyond(here, true);
        }
        for _ in 0..8 {
            if carries(here, value) {
                let found = contact_at(here, value).and_then(|contact| self.polished(&contact, held, value));
                return found.map_or(Expected::Unknown, |contact| Expected::Contact { contact, others: all.len().saturating_sub(1) });
            }
            let up = value > upper(here);
            let limit = if up { upper(here) } else { lower(here) };
            let Some(last) = here.extreme(quantity, up).map(|contact| contact.half_width) else { return Expected::Unknown };
            let next = stable
                .iter()
                .filter(|other| carries(other, limit))
                .filter_map(|other| contact_at(other, limit).map(|contact| (other, contact.half_width)))
                .filter(|&(_, width)| if up { width > last } else { width < last })
                .min_by(|one, other| if up { one.1.total_cmp(&other.1) } else { other.1.total_cmp(&one.1) });
            // Where the curve only stops being admissible it goes on behind the hole.
            let behind = || {
                let stops = here.border(quantity, up) != Border::Turn;
                stable
                    .iter()
                    .filter(|other| stops && carries(other, value))
                    .filter_map(|other| contact_at(other, value).map(|contact| (other, contact.half_width)))
                    .filter(|&(_, width)| if up { width > last } else { width < last })
                    .min_by(|one, other| if up { one.1.total_cmp(&other.1) } else { other.1.total_cmp(&one.1) })
            };
            match next.or_else(behind) {
                Some((next, _)) => here = next,
                None => {
                    // Beyond all of them it is the outermost limit that is passed.
                    let outermost = stable.iter().filter(|_| here.border(quantity, up) != Border::Turn).find(|other| {
                        stable.iter().all(|third| if up { upper(third) <= upper(other) } else { lower(third) >= lower(other) })
                            && if up { value > upper(other) } else { value < lower(other) }
                    });
                    return beyond(outermost.unwrap_or(here), up);
                }
            }
        }
        Expected::Unknown
    }

    /// Without adhesion the limits are known: nothing pulls, and full contact needs |E*(kv)| at least.
    fn without_adhesion(&self, held: Held, value: f64) -> Option<Expected> {
        // Contacts narrower than the rows are not distinguished from nothing.
        if self
            .by_load
            .first()
            .zip(self.by_load.first().and_then(|piece| piece.contacts.first()))
            .is_none_or(|(_, narrowest)| value <= if held == Held::Penetration { narrowest.penetration } else { narrowest.mean_pressure })
        {
            return Some(Expected::Unknown);
        }
        if self.bodies.indenter == Indenter::Parabola {
            return None;
        }
        let full = match held {
            Held::Penetration => 1.0,
            _ => {
                let (real, imaginary) = self.bodies.memory.kernel().harmonic_compliance(1.0);
                1.0 / real.hypot(imaginary)
            }
        };
        (value >= full).then_some(Expected::Full(full))
    }

    /// The contacts of a held half-width.
    #[must_use]
    pub fn of_width(&self, half_width: f64) -> Vec<Equilibrium> {
        let place =
            ContactEdges::new(self.bodies.indenter, viscotack::sliding::contact::WaveContact { half_width, eccentricity: 0.0 }).place();
        self.finest.contacts(place).unwrap_or_default()
    }

    /// The contact at the finest resolution under what is held: Newton's method in the half-width and the eccentricity from a contact that is known to a few digits.
    fn polished(&self, start: &Equilibrium, held: Held, value: f64) -> Option<Equilibrium> {
        let mut contact = *start;
        for _ in 0..6 {
            let at = |wider: f64, ahead: f64| {
                let edges = ContactEdges::at_place(self.finest.indenter, contact.place + wider, contact.eccentricity + ahead);
                let prescribed = if held == Held::Penetration { Prescribed::Penetration(value) } else { Prescribed::MeanPressure(value) };
                self.finest.balance(edges, prescribed).ok()
            };
            let (wider, ahead) = (1e-5, 1e-5 * contact.half_width.min(1.0));
            let here = at(0.0, 0.0)?;
            let by_wider = (at(wider, 0.0)? - at(-wider, 0.0)?) / (2.0 * wider);
            let by_ahead = (at(0.0, ahead)? - at(0.0, -ahead)?) / (2.0 * ahead);
            let step = nalgebra::Matrix2::from_columns(&[by_wider, by_ahead]).lu().solve(&here)?;
            contact.place -= step[0];
            contact.eccentricity -= step[1];
            if step[0].abs() < 1e-11 && step[1].abs() < 1e-11 * contact.half_width.min(1.0) {
                break;
            }
        }
        self.finest.numbers(contact.place, contact.eccentricity, value, held == Held::Penetration).ok()
    }

    /// The margin of stability of a contact.
    #[must_use]
    pub fn margin(&self, contact: &Equilibrium, held: Held) -> f64 {
        Variations::new(&self.finest, contact, held).map_or(f64::NAN, |found| found.margin())
    }
}

/// The stable parts of a piece, cut where the margin passes zero.
fn stable_parts(bodies: &Bodies, piece: Piece, held: Held, changes: &mut usize) -> Vec<Piece> {
    if bodies.adhesion.is_none() {
        return vec![piece];
    }
    let margin = |contact: &Equilibrium| Variations::new(bodies, contact, held).map_or(f64::NAN, |found| found.margin());
    // Next to a turn the margin is zero, and so it is along a narrow gap: what is reported is shown by the larger ones.
    let samples: Vec<f64> =
        (1..=SAMPLES).filter_map(|index| piece.contacts.get(index * piece.contacts.len() / (SAMPLES + 1))).map(margin).collect();
    let (least, most) =
        samples.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), &value| (least.min(value), most.max(value)));
    // At a turn the determinant vanishes, and beside it one edge alone may run away.
    let alone = |contact: Option<&Equilibrium>| {
        contact.is_some_and(|contact| Variations::new(bodies, contact, held).is_ok_and(|found| found.diagonal() < -UNRESOLVED))
    };
    if least > -UNRESOLVED && most > UNRESOLVED && !alone(piece.contacts.first()) && !alone(piece.contacts.last()) {
        return vec![piece];
    }
    if most < UNRESOLVED {
        return Vec::new();
    }
    // Contact by contact, and closer where it changes.
    *changes += 1;
    let mut parts: Vec<Piece> = Vec::new();
    let mut before: Option<(&Equilibrium, bool)> = None;
    for contact in &piece.contacts {
        let margin = margin(contact);
        let stable = if margin.abs() < UNRESOLVED { before.is_some_and(|(_, stable)| stable) } else { margin > 0.0 };
        let border = before.filter(|(_, was)| *was != stable).and_then(|(last, _)| border_between(bodies, last, contact, held, stable));
        match (parts.last_mut(), before) {
            (Some(part), Some((_, true))) if stable => part.contacts.push(*contact),
            (Some(part), Some((_, true))) => part.contacts.extend(border),
            _ if stable => {
                let contacts = border.into_iter().chain([*contact]).collect();
                parts.push(Piece { contacts, begins: Border::Stability, ends: Border::Stability, ..piece.clone() });
            }
            _ => {}
        }
        before = Some((contact, stable));
    }
    let same = |one: Option<&Equilibrium>, other: Option<&Equilibrium>| {
        one.zip(other).is_some_and(|(one, other)| one.place.to_bits() == other.place.to_bits())
    };
    for part in &mut parts {
        if same(part.contacts.first(), piece.contacts.first()) {
            part.begins = piece.begins;
        }
        if same(part.contacts.last(), piece.contacts.last()) {
            part.ends = piece.ends;
        }
    }
    parts.retain(|part| part.contacts.len() > 2);
    parts
}

/// The last stable contact between two neighbours of which one is stable.
fn border_between(bodies: &Bodies, one: &Equilibrium, other: &Equilibrium, held: Held, other_is_stable: bool) -> Option<Equilibrium> {
    let (mut stable, mut unstable) = if other_is_stable { (*other, *one) } else { (*one, *other) };
    for _ in 0..HALVINGS {
        let middle = nearest(
            bodies,
            0.5 * (stable.place + unstable.place),
            0.5 * (stable.eccentricity + unstable.eccentricity),
            0.5 * (stable.mean_pressure + unstable.mean_pressure),
        )?;
        if Variations::new(bodies, &middle, held).ok()?.margin() > 0.0 {
            stable = middle;
        } else {
            unstable = middle;
        }
    }
    Some(stable)
}

/// Stable parts that continue each other are one: where a turn was rounding, and where the curve turns back in the half-width.
fn joined(mut parts: Vec<Piece>, indenter: Indenter, quantity: Quantity) -> Vec<Piece> {
    let mut out: Vec<Piece> = Vec::new();
    while let Some(mut here) = parts.pop() {
        let mut index = 0;
        while index < parts.len() {
            let Some(other) = parts.get(index) else { break };
            match continued(&here, other, indenter, quantity) {
                Some(both) => {
                    here = both;
                    parts.remove(index);
                    index = 0;
                }
                None => index += 1,
            }
        }
        out.push(here);
    }
    let width = |piece: &Piece| piece.contacts.first().map_or(0.0, |contact| contact.half_width);
    out.sort_by(|one, other| width(one).total_cmp(&width(other)));
    out
}

fn continued(one: &Piece, other: &Piece, indenter: Indenter, quantity: Quantity) -> Option<Piece> {
    let turned = |piece: &Piece| Piece {
        contacts: piece.contacts.iter().rev().copied().collect(),
        begins: piece.ends,
        ends: piece.begins,
        strand: piece.strand,
    };
    for first in [one.clone(), turned(one)] {
        for second in [other.clone(), turned(other)] {
            let (Some(end), Some(begin)) = (first.contacts.last(), second.contacts.first()) else { continue };
            let near = (end.place - begin.place).abs() < 1e-5 && distance(indenter, end, begin) < 0.05;
            let rises = |piece: &Piece| piece.contacts.last().map(&quantity) > piece.contacts.first().map(&quantity);
            if near && first.ends != Border::Stability && second.begins != Border::Stability && rises(&first) == rises(&second) {
                let contacts = first.contacts.iter().chain(&second.contacts).copied().collect();
                return Some(Piece { contacts, begins: first.begins, ends: second.ends, strand: first.strand });
            }
        }
    }
    None
}
