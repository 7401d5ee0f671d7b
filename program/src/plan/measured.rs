//! What a plan says of the files that a scene follows: how a record was thinned, what was chosen when it was read.

use crate::outcome::{Assessment, Validity};
use crate::scene::typed::{History, HistorySegment};

/// A choice or an omission that a person should know of.
pub(super) fn note(name: &str, note: &str) -> Validity {
    Validity { name: name.into(), value: None, assessment: Assessment::Caution, meaning: note.to_owned() }
}

/// The statements on the records of a history; a record that is followed worse than the accuracy asks is a caution.
pub(super) fn records(history: &History, accuracy: f64) -> Vec<Validity> {
    let mut entries = Vec::new();
    for segment in &history.segments {
        let HistorySegment::Table { table, .. } = segment else { continue };
        if let Some(thinning) = &table.thinning {
            entries.push(Validity {
                name: "record over its range".into(),
                value: Some(thinning.deviation),
                assessment: if thinning.deviation <= accuracy { Assessment::Good } else { Assessment::Caution },
                meaning: thinning.statement.clone(),
            });
        }
        entries.extend(table.notes.iter().map(|text| note("record", text)));
    }
    entries
}
