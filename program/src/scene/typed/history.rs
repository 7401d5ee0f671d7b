//! Load histories as a scene gives them: segment after segment, each of one controlled quantity.

use crate::scene::catalogue::{Range, Word};
use crate::scene::units::Dimension;
use std::sync::Arc;
use viscotack::indentation::FrequencySweep;

/// What a history may control. Each problem allows some of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum HistoryQuantity {
    /// K (Pa √m) of a crack.
    StressIntensity,
    /// Stress (Pa) of a strip far ahead of the tip.
    Stress,
    /// Δ (m) of a rounded indenter.
    Penetration,
    /// F (N) on it.
    Force,
    /// a (m) of its contact.
    ContactRadius,
    /// Displacement (m) of the far end of the frame that holds it.
    Frame,
}

impl HistoryQuantity {
    /// Every quantity.
    pub const ALL: [Self; 6] = [Self::StressIntensity, Self::Stress, Self::Penetration, Self::Force, Self::ContactRadius, Self::Frame];

    /// The words of `history.quantity`, in the order of [`HistoryQuantity::ALL`].
    pub const WORDS: &'static [Word] = &[
        Word { word: "stress_intensity", meaning: "K of a crack" },
        Word { word: "stress", meaning: "stress of a cracked strip, far ahead of the tip" },
        Word { word: "penetration", meaning: "depth of a sphere" },
        Word { word: "force", meaning: "force on a sphere" },
        Word { word: "contact_radius", meaning: "radius of a sphere's contact" },
        Word { word: "frame", meaning: "displacement of the far end of the frame that holds a sphere" },
    ];

    /// Those that may oscillate: a radius would pin the edge at every turn.
    pub const OSCILLATING: &'static [Word] = &[
        Word { word: "penetration", meaning: "depth of a sphere" },
        Word { word: "force", meaning: "force on a sphere" },
        Word { word: "frame", meaning: "displacement of the far end of the frame that holds a sphere" },
    ];

    /// Whether it may oscillate.
    #[must_use]
    pub const fn oscillates(self) -> bool {
        matches!(self, Self::Penetration | Self::Force | Self::Frame)
    }

    /// The word in scenes, and the key of a segment that goes to a value of it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::StressIntensity => "stress_intensity",
            Self::Stress => "stress",
            Self::Penetration => "penetration",
            Self::Force => "force",
            Self::ContactRadius => "contact_radius",
            Self::Frame => "frame",
        }
    }

    /// The quantity of a word.
    #[must_use]
    pub fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|quantity| quantity.word() == word)
    }

    /// What its values are measured in.
    #[must_use]
    pub const fn dimension(self) -> Dimension {
        match self {
            Self::StressIntensity => Dimension::STRESS_INTENSITY,
            Self::Stress => Dimension::PRESSURE,
            Self::Penetration | Self::ContactRadius | Self::Frame => Dimension::LENGTH,
            Self::Force => Dimension::FORCE,
        }
    }

    /// What its rates are measured in.
    #[must_use]
    pub const fn rate_dimension(self) -> Dimension {
        match self {
            Self::StressIntensity => Dimension::STRESS_INTENSITY_RATE,
            Self::Stress => Dimension::PRESSURE_RATE,
            Self::Penetration | Self::ContactRadius | Self::Frame => Dimension::SPEED,
            Self::Force => Dimension::FORCE_RATE,
        }
    }

    /// The range of its values: pressed crack faces are a contact, and no contact has a negative radius.
    #[must_use]
    pub const fn range(self) -> Range {
        match self {
            Self::StressIntensity | Self::Stress | Self::ContactRadius => Range::NonNegative,
            Self::Penetration | Self::Force | Self::Frame => Range::Finite,
        }
    }
}

/// A history: what is done, in order, from an unloaded, rested body at time zero.
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    /// One after the other, groups that repeat written out; at least one.
    pub segments: Vec<HistorySegment>,
    /// Which `[[history]]` table each segment is of, from 0; of a standard test, its own place.
    pub tables: Vec<usize>,
    /// Every time through each group that repeats.
    pub repetitions: Vec<Repetition>,
}

/// One time through a group of segments that repeats.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Repetition {
    /// The segments, from 0.
    pub segments: std::ops::Range<usize>,
    /// Which time it is, from 1.
    pub number: u64,
}

impl History {
    /// One segment a table.
    #[must_use]
    pub fn of(segments: Vec<HistorySegment>) -> Self {
        let tables = (0..segments.len()).collect();
        Self { segments, tables, repetitions: Vec::new() }
    }

    /// The segments of a `[[history]]` table.
    pub fn of_table(&mut self, table: usize) -> impl Iterator<Item = &mut HistorySegment> {
        self.segments.iter_mut().zip(&self.tables).filter(move |(_, of)| **of == table).map(|(segment, _)| segment)
    }

    /// The `[[history]]` table of a segment.
    #[must_use]
    pub fn table(&self, segment: usize) -> usize {
        self.tables.get(segment).copied().unwrap_or(segment)
    }
}

/// One part of a history; values in the unit of their quantity, times in s.
#[derive(Debug, Clone, PartialEq)]
pub enum HistorySegment {
    /// To a value at once.
    Step {
        /// What is controlled.
        quantity: HistoryQuantity,
        /// Its value after the step.
        value: f64,
    },
    /// Straight to a value.
    Ramp {
        /// What is controlled.
        quantity: HistoryQuantity,
        /// Its value at the end.
        value: f64,
        /// How fast.
        pace: Pace,
    },
    /// The last controlled quantity as it is.
    Hold {
        /// What is controlled: that of the segment before; none where none was before.
        quantity: Option<HistoryQuantity>,
        /// How long (s), zero or more.
        duration: f64,
    },
    /// Through the rows of a table; its first value is stepped to.
    Table {
        /// What is controlled.
        quantity: HistoryQuantity,
        /// The rows.
        table: Arc<MeasuredTable>,
    },
    /// Cycles between two values; the first one of the wave is stepped to.
    Cycles {
        /// What is controlled.
        quantity: HistoryQuantity,
        /// How many.
        count: u32,
        /// How long one takes (s).
        period: f64,
        /// The smaller value.
        lower: f64,
        /// The larger value.
        upper: f64,
        /// The form.
        wave: CycleWave,
    },
    /// A sinus about a mean.
    Oscillation(HistoryOscillation),
    /// Straight to a value that is so far from the present one.
    By {
        /// What is controlled.
        quantity: HistoryQuantity,
        /// The value at the end less the one at the start.
        change: f64,
        /// How fast; none for at once.
        pace: Option<Pace>,
    },
    /// A ramp, a `By` that takes time, or a hold, ended by a condition.
    Until {
        /// What is done; it ends by itself where the condition is never met.
        segment: Box<Self>,
        /// What ends it.
        condition: Condition,
    },
}

/// What ends a segment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Condition {
    /// A quantity reaches a value, from either side.
    Reaches(HistoryQuantity, f64),
    /// The contact is lost.
    Detachment,
    /// The time of the history (s).
    Time(f64),
}

impl HistorySegment {
    /// What is controlled; none of a hold before which nothing was.
    #[must_use]
    pub const fn quantity(&self) -> Option<HistoryQuantity> {
        match self {
            Self::Step { quantity, .. }
            | Self::Ramp { quantity, .. }
            | Self::Table { quantity, .. }
            | Self::Cycles { quantity, .. }
            | Self::By { quantity, .. }
            | Self::Oscillation(HistoryOscillation { quantity, .. }) => Some(*quantity),
            Self::Hold { quantity, .. } => *quantity,
            Self::Until { segment, .. } => segment.quantity(),
        }
    }
}

/// A sinus about the present value of a quantity, or about a straight way to another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HistoryOscillation {
    /// What is controlled.
    pub quantity: HistoryQuantity,
    /// Greatest deviation from the mean, > 0.
    pub amplitude: f64,
    /// Cycles per time (1/s) at the start.
    pub frequency: f64,
    /// The same at the end, and how it goes there; none for a steady frequency.
    pub sweep: Option<(f64, FrequencySweep)>,
    /// How long it lasts.
    pub extent: OscillationExtent,
    /// Where in its cycle it begins (rad).
    pub phase: f64,
    /// The mean at the end, where it does not stay.
    pub to: Option<f64>,
    /// Whether it ends with the first stationary cycle.
    pub until_stationary: bool,
}

impl HistoryOscillation {
    /// Whether only the cycle that repeats itself is asked for.
    #[must_use]
    pub const fn is_periodic(&self) -> bool {
        matches!(self.extent, OscillationExtent::Periodic)
    }

    /// How long it takes (s), at most.
    #[must_use]
    pub fn duration(&self) -> f64 {
        let cycles = match self.extent {
            OscillationExtent::Duration(duration) => return duration,
            OscillationExtent::Cycles(cycles) => f64::from(cycles),
            OscillationExtent::Periodic => 1.0,
        };
        // Cycles in one second of a sweep are its mean frequency.
        let (low, high) = (self.frequency, self.sweep.map_or(self.frequency, |(end, _)| end));
        let logarithm = (high / low).ln();
        match self.sweep {
            Some((_, FrequencySweep::Logarithmic)) if logarithm != 0.0 => cycles * logarithm / (low * logarithm.exp_m1()),
            _ => cycles / (0.5 * (low + high)),
        }
    }
}

/// How long an oscillation lasts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OscillationExtent {
    /// So many cycles.
    Cycles(u32),
    /// So long (s).
    Duration(f64),
    /// For ever: one cycle, which repeats itself.
    Periodic,
}

/// How fast a ramp goes; both numbers are greater than zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pace {
    /// It takes so long (s).
    Duration(f64),
    /// It goes this much a second, up or down.
    Rate(f64),
}

/// The form of a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleWave {
    /// From the lower value straight up in half a period, straight down in the other half.
    Triangle,
    /// Half a period at the upper value, then half a period at the lower one.
    Square,
}

/// A table of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredTable {
    /// The file as named in the scene.
    pub file: String,
    /// Times of what is followed since the first row (s): zero, then increasing. At least two.
    pub times: Vec<f64>,
    /// The controlled quantity at these times.
    pub values: Vec<f64>,
    /// Times of all rows of the file since the first (s).
    pub rows: Vec<f64>,
    /// All further columns, at the times of all rows: measured, not controlled.
    pub others: Vec<MeasuredColumn>,
    /// How far what is followed is from the rows, if it is not the rows themselves.
    pub thinning: Option<RecordThinning>,
    /// What was chosen when the file was read, and what was left out.
    pub notes: Vec<String>,
}

/// A record that is followed along fewer corners than it has rows.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordThinning {
    /// The largest deviation of a row, over the range of the record.
    pub deviation: f64,
    /// Rows, corners, deviation and tolerance in words.
    pub statement: String,
}

/// A column that is not controlled.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredColumn {
    /// Its name in the header.
    pub name: String,
    /// What it is measured in; values are in SI units.
    pub dimension: Dimension,
    /// A value a row; none for an empty cell.
    pub values: Vec<Option<f64>>,
}
