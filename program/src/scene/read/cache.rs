//! What was made before of the same words and files: a fit takes a second, the thinning of a record too, and a sweep has a thousand states.

use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::{Node, Value};
use std::collections::HashMap;
use std::fmt::Write as _;
use std::sync::{Arc, Mutex, PoisonError};

/// What was made, by all that it depends on, shared by all copies of a document.
#[derive(Debug)]
pub(crate) struct Cache<T> {
    made: Arc<Mutex<HashMap<String, Result<T, SceneError>>>>,
}

impl<T> Default for Cache<T> {
    fn default() -> Self {
        Self { made: Arc::default() }
    }
}

impl<T> Clone for Cache<T> {
    fn clone(&self) -> Self {
        Self { made: Arc::clone(&self.made) }
    }
}

impl<T: Clone> Cache<T> {
    /// What was made of these words, or is made now; others that want the same wait meanwhile.
    pub(super) fn get(&self, words: &str, make: impl FnOnce() -> Result<T, SceneError>) -> Result<T, SceneError> {
        let mut made = self.made.lock().unwrap_or_else(PoisonError::into_inner);
        made.entry(words.to_owned()).or_insert_with(make).clone()
    }
}

/// What was made of a table of the scene, with the keys that were read for it.
pub(crate) type OfTable<T> = Cache<(Arc<T>, Arc<[String]>)>;

impl<T> OfTable<T> {
    /// What was made of these keys of a table (of none named: of all) and of what else it depends on; keys that its maker reads count as read
    /// whenever it is taken.
    pub(super) fn of(
        &self,
        table: &Section<'_>,
        keys: &[&str],
        further: &str,
        make: impl FnOnce() -> Result<T, SceneError>,
    ) -> Result<Arc<T>, SceneError> {
        let mut words = format!("{} {:?} {further} ", table.full(""), table.units());
        if keys.is_empty() {
            written(table.node(), &mut words);
        }
        for node in keys.iter().filter_map(|key| table.node().get(key)) {
            written(node, &mut words);
        }
        let below: Vec<String> = if keys.is_empty() { vec![table.full("")] } else { keys.iter().map(|key| table.full(key)).collect() };
        let (made, read) = self.get(&words, || {
            let made = make()?;
            Ok((Arc::new(made), table.keys_read(&below).into()))
        })?;
        table.count_as_read(&read);
        Ok(made)
    }
}

/// The values of a table, without their places.
fn written(node: &Node, words: &mut String) {
    let _ = match &node.value {
        Value::Number(number) => write!(words, "{:x} ", number.to_bits()),
        Value::Text(text) => write!(words, "{text:?} "),
        Value::Flag(flag) => write!(words, "{flag} "),
        Value::Date => write!(words, "{:?} ", node.written()),
        Value::List(items) => {
            words.push('[');
            items.iter().for_each(|item| written(item, words));
            write!(words, "] ")
        }
        Value::Table(entries) => {
            words.push('{');
            for entry in entries {
                let _ = write!(words, "{:?} = ", entry.key);
                written(&entry.node, words);
            }
            write!(words, "}} ")
        }
    };
}
