//! The stored runs of other programs in one text, whoever added a file of them: `peers/work_precision*.csv`, one below the other.

use std::path::Path;

fn main() {
    const FOLDER: &str = "peers";
    println!("cargo:rerun-if-changed={FOLDER}");
    let mut files: Vec<_> = std::fs::read_dir(FOLDER)
        .map(|entries| entries.filter_map(Result::ok).map(|entry| entry.path()).collect::<Vec<_>>())
        .unwrap_or_default();
    files.retain(|path| {
        path.file_name().and_then(|name| name.to_str()).is_some_and(|name| name.starts_with("work_precision") && name.ends_with(".csv"))
    });
    files.sort();
    let text: String = files.iter().filter_map(|path| std::fs::read_to_string(path).ok()).collect();
    if let Ok(folder) = std::env::var("OUT_DIR") {
        let written = std::fs::write(Path::new(&folder).join("work_precision.csv"), text);
        // Without the file the build stops where it is read.
        drop(written);
    }
}
