//! Source: the commands `completions` and `man`, and the option `--errors json`, for shells, readers of manuals, and other programs.
//!
//! Goal: a completion that a shell loads completes commands, options and their values; a manual page is one; an error as JSON has the parts that the text has.
//!
//! Oracle: the shells themselves (bash; zsh and fish where they are installed), the names in the help. Tolerance: none.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use crate::command_support;

use command_support::{Folder, GOOD};
use std::process::Command;

/// What a shell prints, if it is installed.
fn shell(name: &str, folder: &Folder, script: &str) -> Option<String> {
    let mut command = Command::new(name);
    match name {
        "bash" => command.args(["--norc", "-c"]),
        "zsh" => command.args(["-f", "-c"]),
        _ => command.args(["--no-config", "-c"]),
    };
    let output = command.arg(script).current_dir(folder.path(".")).output().ok()?;
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    Some(String::from_utf8(output.stdout).unwrap())
}

/// What is typed, and what must be among the words that are offered.
const TYPED: [(&str, &[&str]); 5] = [
    ("viscotack ru", &["run"]),
    ("viscotack ga", &["gather"]),
    ("viscotack run --sh", &["--shard"]),
    ("viscotack fit --mod", &["--models"]),
    ("viscotack completions ", &["bash", "fish", "zsh"]),
];

fn offered(name: &str, said: &str, typed: &str, words: &[&str]) {
    let found: Vec<&str> = said.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert!(words.iter().all(|word| found.contains(word)), "{name}, {typed:?}: {found:?}");
    assert!(!found.contains(&"viscotack"));
}

#[test]
fn bash_completes() {
    let folder = Folder::new();
    folder.write("viscotack.bash", folder.call(&["completions", "bash"]).ended(0).stdout);
    for (typed, words) in TYPED {
        let parts: Vec<&str> = typed.split(' ').collect();
        let (last, before) = (parts[parts.len() - 1], parts[parts.len() - 2]);
        // As bash calls it: the words, which of them is completed, the command, that word and the one before.
        let script = format!(
            "source ./viscotack.bash; COMP_WORDS=({}); [ -n '{last}' ] || COMP_WORDS+=(''); COMP_CWORD={}; COMP_LINE='{typed}'; COMP_POINT=${{#COMP_LINE}}; \
             _viscotack viscotack '{last}' '{before}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"",
            parts.join(" "),
            parts.len() - 1
        );
        offered("bash", &shell("bash", &folder, &script).expect("bash is installed"), typed, words);
    }
}

#[test]
fn fish_completes_where_it_is_installed() {
    let folder = Folder::new();
    folder.write("viscotack.fish", folder.call(&["completions", "fish"]).ended(0).stdout);
    for (typed, words) in TYPED {
        if let Some(said) = shell("fish", &folder, &format!("source ./viscotack.fish; complete -C '{typed}'")) {
            offered("fish", &said, typed, words);
        }
    }
}

/// zsh completes at a terminal only: one of its own, in which another zsh runs. What is typed becomes the command line with the completed word.
#[test]
fn zsh_completes_where_it_is_installed() {
    let folder = Folder::new();
    folder.write("_viscotack", folder.call(&["completions", "zsh"]).ended(0).stdout);
    // What the zsh inside prints is gathered until it has the form that is waited for, for at most twenty seconds.
    let start = "zmodload zsh/zpty; zpty -b Z zsh -f -i\n\
        waits() { local all part; repeat 400; do while zpty -rt Z part; do all+=$part; done; [[ $all == $~1 ]] && return; sleep .05; done; return 1 }\n\
        zpty -w Z 'PS1=; fpath=($PWD $fpath); autoload -Uz compinit; compinit -u -d ./dump; unsetopt zle_bracketed_paste; print REA''DY'\n\
        waits '*READY*' || exit 1\n";
    for (typed, words) in TYPED {
        let seen: String = words.iter().map(|word| format!("*{word}")).collect();
        let script = format!("{start}zpty -n -w Z '{typed}'$'\\t'; waits '{seen}*' && print -r -- seen; zpty -d Z");
        if let Some(said) = shell("zsh", &folder, &script) {
            assert_eq!(said, "seen\n", "{typed:?}");
        }
    }
}

#[test]
fn manual_pages_name_what_the_help_names() {
    let folder = Folder::new();
    let page = folder.call(&["man"]).ended(0).stdout;
    assert!(page.contains(".TH viscotack 1"), "{page}");
    for command in ["new", "run", "gather", "fit", "explain", "material", "schema"] {
        assert!(page.contains(&format!("viscotack\\-{command}")), "{command} is not in the page");
        let own = folder.call(&["man", command]).ended(0).stdout;
        assert!(own.contains(&format!(".TH viscotack-{command} 1")) || own.contains(&format!(".TH {command} 1")), "{own}");
    }
    let run = folder.call(&["man", "run"]).ended(0).stdout;
    assert!(["shard", "jobs", "out", "force"].iter().all(|option| run.contains(&format!("\\-\\-{option}"))), "{run}");
    let said = folder.call(&["man", "rum"]).ended(2);
    assert!(said.stderr.contains("no command `rum`"), "{}", said.stderr);
}

#[test]
fn errors_as_json_have_the_parts_of_the_text() {
    let folder = Folder::with(&GOOD.replace("speed = \"1 mm/s\"", "speed = \"1 MPa\""));
    let text = folder.call(&["run", "scene.toml"]).ended(2).stderr;
    let said = folder.call(&["--errors", "json", "run", "scene.toml"]).ended(2);
    assert_eq!((said.stdout.as_str(), said.stderr.lines().count()), ("", 1));
    let parts: serde_json::Value = serde_json::from_str(&said.stderr).unwrap();
    let line = GOOD.lines().position(|line| line.starts_with("speed = ")).unwrap() + 1;
    assert_eq!(parts["key"], "crack.speed");
    assert_eq!((parts["file"].as_str(), parts["line"].as_u64()), (Some("scene.toml"), Some(line as u64)));
    assert_eq!(parts["text"].as_str(), Some(text.as_str()));
    assert!(text.contains(parts["message"].as_str().unwrap()) && text.contains(parts["label"].as_str().unwrap()));
    // A call that is wrong without a scene, and one that is right.
    let said = folder.call(&["run", "none.toml", "--errors=json"]).ended(2);
    let parts: serde_json::Value = serde_json::from_str(&said.stderr).unwrap();
    assert!(parts["message"].as_str().unwrap().contains("none.toml"));
    folder.write("good.toml", GOOD);
    assert_eq!(folder.call(&["run", "good.toml", "--errors", "json"]).ended(0).stderr, "");
}
