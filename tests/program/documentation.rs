//! Source: README.md, ARCHITECTURE.md, CONTRIBUTING.md and the pages of `docs/src`.
//!
//! Goal: a reader meets no dead link, no scene that does not run, no command that does not exist, no output that the program does not print; the README stays short.
//!
//! Oracle: the files of the repository and the program itself.
//!
//! Tolerance: none; the output of the README's scene is compared to the digits shown.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

use crate::command_support;

use command_support::Folder;
use std::path::{Path, PathBuf};
use viscotack_program::plan::Plan;
use viscotack_program::scene::{Document, read};

fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn markdown_below(folder: &Path, pages: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            markdown_below(&path, pages);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            pages.push(path);
        }
    }
}

/// The pages for users and contributors, with their texts.
fn pages() -> Vec<(PathBuf, String)> {
    let mut pages: Vec<PathBuf> = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "SECURITY.md"].map(|name| root().join(name)).into();
    markdown_below(&root().join("docs"), &mut pages);
    pages.sort();
    pages.into_iter().map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())).collect()
}

/// Code blocks of a page: what follows the fence, and the text.
fn blocks(text: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut open: Option<(String, String)> = None;
    for line in text.lines() {
        match (line.strip_prefix("```"), open.take()) {
            (Some(_), Some(block)) => found.push(block),
            (Some(info), None) => open = Some((info.trim().to_string(), String::new())),
            (None, Some((info, body))) => open = Some((info, body + line + "\n")),
            (None, None) => {}
        }
    }
    found
}

/// Targets of `[text](target)` outside of code blocks.
fn links(text: &str) -> Vec<String> {
    let mut in_code = false;
    let prose = text.lines().filter(|line| {
        in_code ^= line.starts_with("```");
        !in_code
    });
    let of_line = |line: &str| -> Vec<String> {
        let after = line.split("](").skip(1);
        after.filter_map(|rest| rest.split_once(')').map(|(target, _)| target.to_string())).collect()
    };
    prose.flat_map(of_line).collect()
}

#[test]
fn every_link_leads_to_a_file() {
    let mut checked = 0;
    for (page, text) in pages() {
        for link in links(&text) {
            if link.starts_with("http") || link.starts_with('#') {
                continue;
            }
            let target = page.parent().unwrap().join(link.split('#').next().unwrap());
            assert!(target.exists(), "{}: {link}", page.display());
            checked += 1;
        }
    }
    assert!(checked > 60, "{checked}");
}

#[test]
fn every_page_of_the_book_is_in_its_table_of_contents() {
    let source = root().join("docs/src");
    let contents = links(&std::fs::read_to_string(source.join("SUMMARY.md")).unwrap());
    let mut book = Vec::new();
    markdown_below(&source, &mut book);
    for page in book.iter().filter(|page| !page.ends_with("SUMMARY.md")) {
        let name = page.strip_prefix(&source).unwrap().to_str().unwrap();
        assert!(contents.iter().any(|link| link == name), "{name}");
    }
}

#[test]
fn the_readme_stays_short() {
    let lines = std::fs::read_to_string(root().join("README.md")).unwrap().lines().count();
    assert!(lines <= 150, "{lines}");
}

#[test]
fn every_scene_is_accepted_and_every_part_of_one_is_toml() {
    let (mut scenes, mut parts) = (0, 0);
    for (page, text) in pages() {
        for (info, body) in blocks(&text) {
            if info == "toml scene" {
                let folder = Folder::new();
                folder.write("scene.toml", &body);
                let answer = folder.call(&["explain", "scene.toml"]);
                assert_eq!(answer.code, 0, "{}: {body}\n{}", page.display(), answer.stderr);
                scenes += 1;
            } else if info == "toml" {
                let parsed = body.parse::<toml::Table>();
                assert!(parsed.is_ok(), "{}: {body}\n{parsed:?}", page.display());
                parts += 1;
            }
        }
    }
    assert!(scenes >= 5 && parts >= 5, "{scenes} {parts}");
}

#[test]
fn every_command_exists() {
    let mut commands: Vec<String> = Vec::new();
    for (_, text) in pages() {
        for (info, body) in blocks(&text) {
            let word = |line: &str| line.strip_prefix("viscotack ")?.split_whitespace().next().map(str::to_string);
            if info == "sh" || info == "sh run" {
                commands.extend(body.lines().filter_map(word));
            }
        }
    }
    commands.sort();
    commands.dedup();
    assert!(commands.len() >= 5, "{commands:?}");
    for command in commands {
        let answer = Folder::new().call(&[&command, "--help"]);
        assert_eq!(answer.code, 0, "{command}: {}", answer.stderr);
    }
}

/// Commands in blocks `sh run` end well, one after the other, where the repository's scenes are.
#[test]
fn commands_that_are_short_run() {
    let mut count = 0;
    for (page, text) in pages() {
        let folder = Folder::new();
        let commands: Vec<String> = blocks(&text)
            .into_iter()
            .filter(|block| block.0 == "sh run")
            .flat_map(|block| block.1.lines().map(str::to_owned).collect::<Vec<_>>())
            .collect();
        for command in commands {
            let scenes = root().join("scenes").display().to_string();
            let words: Vec<String> = command
                .split_whitespace()
                .skip(1)
                .map(|word| word.replacen("scenes", &scenes, usize::from(word.starts_with("scenes/"))))
                .collect();
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            let answer = folder.call(&words);
            assert_eq!(answer.code, 0, "{}: {command}\n{}", page.display(), answer.stderr);
            count += 1;
        }
    }
    assert!(count >= 3, "{count}");
}

#[test]
fn the_scene_of_the_readme_prints_what_it_shows() {
    let readme = std::fs::read_to_string(root().join("README.md")).unwrap();
    let blocks = blocks(&readme);
    let place = blocks.iter().position(|(info, _)| info == "toml scene").unwrap();
    let folder = Folder::new();
    folder.write("scene.toml", &blocks[place].1);
    let answer = folder.call(&["run", "scene.toml"]);
    assert_eq!(answer.code, 0, "{}", answer.stderr);
    let (info, shown) = &blocks[place + 1];
    assert_eq!(info, "text");
    for line in shown.lines().filter(|line| *line != "…") {
        assert!(answer.stdout.lines().any(|printed| printed.trim_end() == line.trim_end()), "not printed: {line}\n{}", answer.stdout);
    }
}

/// `viscotack schema --markdown > docs/src/reference/keys.md` makes it anew.
#[test]
fn the_page_of_keys_is_that_of_the_program() {
    let page = std::fs::read_to_string(root().join("docs/src/reference/keys.md")).unwrap();
    let answer = Folder::new().call(&["schema", "--markdown"]).ended(0);
    assert!(answer.stdout == page, "docs/src/reference/keys.md is old: viscotack schema --markdown > docs/src/reference/keys.md");
}

/// `viscotack schema --columns > docs/src/reference/columns.md` makes it anew.
#[test]
fn the_page_of_columns_is_that_of_the_program() {
    let page = std::fs::read_to_string(root().join("docs/src/reference/columns.md")).unwrap();
    let answer = Folder::new().call(&["schema", "--columns"]).ended(0);
    assert!(answer.stdout == page, "docs/src/reference/columns.md is old: viscotack schema --columns > docs/src/reference/columns.md");
}

fn scenes() -> Vec<PathBuf> {
    let mut found = Vec::new();
    for folder in ["cracks", "indentation", "published", "sliding", "surfaces"] {
        for entry in std::fs::read_dir(root().join("scenes").join(folder)).unwrap() {
            found.push(entry.unwrap().path());
        }
    }
    found.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    found.sort();
    found
}

/// The small scenes that the page is made from hold every column that a scene of the repository has.
#[test]
fn every_column_of_every_scene_is_on_the_page_of_columns() {
    let page = std::fs::read_to_string(root().join("docs/src/reference/columns.md")).unwrap();
    let mut checked = 0;
    for path in scenes() {
        let mut document = Document::load(&path).unwrap();
        read::resolve_includes(&mut document).unwrap();
        let plan = Plan::new(&read::read(&document).unwrap()).unwrap();
        // A place alone makes no table of fields.
        let fields = plan.field_columns();
        for column in plan.columns().iter().chain(fields.iter().filter(|_| fields.len() > 1)) {
            let shown = |text: &str| text.replace('|', "\\|").replace('<', "&lt;").replace('*', "\\*");
            let (meaning, in_unit) = (shown(column.meaning), shown(&column.unit));
            let known = page.lines().any(|line| {
                let cells: Vec<&str> = line.splitn(5, " | ").collect();
                line.starts_with(&format!("| `{}` |", column.name))
                    && line.contains(&meaning)
                    && cells.iter().skip(1).take(2).any(|unit| *unit == in_unit)
            });
            assert!(known, "{}: {} [{}] {}", path.display(), column.name, column.unit, column.meaning);
            checked += 1;
        }
    }
    assert!(checked > 1000, "{checked}");
}

/// `python3 ci/gallery.py target/release/viscotack NAME` adds a scene, or draws it anew.
#[test]
fn every_scene_is_in_the_gallery_with_its_sentence() {
    let page = std::fs::read_to_string(root().join("docs/src/gallery.md")).unwrap();
    let mut pictures = 0;
    for path in scenes() {
        let text = std::fs::read_to_string(&path).unwrap();
        let name = format!("{}/{}", path.parent().unwrap().file_name().unwrap().display(), path.file_stem().unwrap().display());
        let whole = page.contains(&format!("`viscotack run scenes/{name}.toml --out DIR` ("));
        // A picture of a shorter run says so beside its command.
        let changed = format!("`viscotack run scenes/{name}.toml --set ");
        let said =
            page.split(&changed).next().is_some_and(|before| before.lines().rev().take(3).any(|line| line.contains("The picture is of")));
        assert!(whole || (page.contains(&changed) && said), "{name} is not in docs/src/gallery.md");
        let heading: Vec<&str> =
            text.lines().take_while(|line| line.starts_with('#')).map(|line| line.trim_start_matches(['#', ' '])).collect();
        assert!(!heading.is_empty(), "{name}: the first line is no comment");
        assert!(page.contains(heading.join(" ").trim()), "{name}: its comment in docs/src/gallery.md is old");
        assert!(root().join(format!("docs/src/images/gallery/{}.svg", name.replace('/', "_"))).exists(), "{name} has no picture");
        pictures += 1;
    }
    assert!(pictures > 50, "{pictures}");
}

/// The report of a run begins with the answer, shows the pictures within it, needs nothing from the net, and is written without pictures, too.
#[test]
fn a_run_writes_a_report_that_stands_alone() {
    let folder = Folder::new();
    let scene = root().join("scenes/cracks/pure_shear_strip.toml").display().to_string();
    let printed = folder.call(&["run", &scene, "--out", "DIR"]).ended(0).stdout;
    assert!(printed.contains("report.html"), "{printed}");
    let page = folder.read("DIR/report.html");
    let place = |words: &str| page.find(words).unwrap_or_else(|| panic!("no {words}"));
    let parts =
        ["<h1>", "<h2>Answer</h2>", "<h2>Plots</h2>", "<h2>Whether the model holds</h2>", "<h2>Cost</h2>", "<h2>Where it comes from</h2>"];
    assert!(parts.map(place).is_sorted());
    assert!(page.contains("<svg class=\"plot\"") && page.contains("prefers-color-scheme:dark"));
    assert!(!page.contains("<script") && !page.contains("src=\"http") && !page.contains("href=\"http"));
    let summary: serde_json::Value = serde_json::from_str(&folder.read("DIR/summary.json")).unwrap();
    assert!(page.contains(summary["provenance"]["scene_sha256"].as_str().unwrap()));
    for entry in summary["validity"].as_array().unwrap() {
        assert!(page.contains(&format!("<b>{}</b>", entry["name"].as_str().unwrap())), "{entry}");
    }
    folder.call(&["run", &scene, "--out", "BARE", "--no-plots"]).ended(0);
    let bare = folder.read("BARE/report.html");
    assert!(!bare.contains("<svg") && !bare.contains("<h2>Plots</h2>") && bare.contains("<h2>Answer</h2>"));
}
