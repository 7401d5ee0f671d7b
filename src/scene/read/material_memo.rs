//! Materials that were made before from the same data: a fit takes a second, a sweep has a thousand states.

use crate::scene::diagnostic::SceneError;
use crate::scene::typed::MaterialOrigin;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// What was made, or why it could not be.
type Made = Result<MaterialOrigin, SceneError>;

/// Materials by all that they depend on, shared by all copies of a document.
#[derive(Debug, Clone, Default)]
pub(crate) struct MaterialMemo {
    made: Arc<Mutex<HashMap<String, Made>>>,
}

impl MaterialMemo {
    /// What was made of these words, or is made now; others that want a material wait meanwhile.
    pub(super) fn get(&self, words: &str, make: impl FnOnce() -> Made) -> Made {
        let mut made = self.made.lock().unwrap_or_else(PoisonError::into_inner);
        made.entry(words.to_owned()).or_insert_with(make).clone()
    }
}
