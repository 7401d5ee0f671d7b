//! Commented scenes to start from, one a problem.

/// A scene to start from.
#[derive(Debug, Clone, Copy)]
pub struct Template {
    /// The name after `viscotack new`.
    pub name: &'static str,
    /// One line about it.
    pub meaning: &'static str,
    /// The scene.
    pub text: &'static str,
}

/// Every template.
pub const TEMPLATES: &[Template] = &[
    Template {
        name: "crack",
        meaning: "a crack that opens steadily: toughness against speed",
        text: include_str!("../../../scenes/templates/crack.toml"),
    },
    Template {
        name: "strip",
        meaning: "a pure-shear strip: crack speed under a held strain",
        text: include_str!("../../../scenes/templates/strip.toml"),
    },
    Template {
        name: "delayed",
        meaning: "a crack under a load history: delay, growth, arrest",
        text: include_str!("../../../scenes/templates/delayed.toml"),
    },
    Template {
        name: "sliding",
        meaning: "a wave that slides with adhesion: friction and contact against speed",
        text: include_str!("../../../scenes/templates/sliding.toml"),
    },
    Template {
        name: "indentation",
        meaning: "a sphere pressed in and pulled off: force, contact and pull-off in time",
        text: include_str!("../../../scenes/templates/indentation.toml"),
    },
    Template {
        name: "pull-off-test",
        meaning: "a pull-off test: approach until a force, dwell, retract until the contact is lost",
        text: include_str!("../../../scenes/templates/pull_off_test.toml"),
    },
    Template {
        name: "tack-test",
        meaning: "a tack test: approach until a force, hold it, retract until the contact is lost",
        text: include_str!("../../../scenes/templates/tack_test.toml"),
    },
    Template {
        name: "creep-test",
        meaning: "a creep test: a force put on and held",
        text: include_str!("../../../scenes/templates/creep_test.toml"),
    },
    Template {
        name: "relaxation-test",
        meaning: "a relaxation test: a depth approached and held",
        text: include_str!("../../../scenes/templates/relaxation_test.toml"),
    },
    Template {
        name: "dynamic-test",
        meaning: "a dynamic test: oscillations at one frequency after the other",
        text: include_str!("../../../scenes/templates/dynamic_test.toml"),
    },
    Template {
        name: "cyclic-test",
        meaning: "a cyclic test: approach, dwell and retract, again and again",
        text: include_str!("../../../scenes/templates/cyclic_test.toml"),
    },
];

/// The template of a name.
#[must_use]
pub fn template(name: &str) -> Option<&'static Template> {
    TEMPLATES.iter().find(|template| template.name == name)
}
