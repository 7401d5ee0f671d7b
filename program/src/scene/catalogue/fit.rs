//! Keys of a fit to measured curves; `viscotack fit` reads them.

use super::{Key, Kind, Word};

pub(super) const KEYS: &[Key] = &[
    Key {
        path: "fit",
        kind: Kind::Table,
        meaning: "Which numbers of the scene `viscotack fit` finds from measured curves. Any other command refuses a scene with this table.",
    },
    Key {
        path: "fit.compare",
        kind: Kind::Texts,
        meaning: "What is compared with the data: along a history `force`, `contact_radius`, `penetration`; across states any column of the result, such as `friction_coefficient`. A text, or a list of texts.",
    },
    Key {
        path: "fit.against",
        kind: Kind::Text,
        meaning: "What the data are given against: `time`, `penetration` or `frame` along a history; or the dotted path of a number of the scene, such as `sliding.speed`: then each row of the data is a state of its own. Default: the time.",
    },
    Key { path: "fit.free", kind: Kind::Tables, meaning: "The numbers to find, one table each." },
    Key {
        path: "fit.free[].key",
        kind: Kind::Text,
        meaning: "The dotted path of a number of the scene; or of the data of each test: `fit.depth_offset` (what the depth shows at depth zero), `fit.time_offset` (the same of the time), `fit.force_offset` (the force without load), `fit.force_drift` (its change per time).",
    },
    Key {
        path: "fit.free[].from",
        kind: Kind::NumberOfSweptKey,
        meaning: "The smallest value allowed. With both ends above zero the logarithm is fitted. An offset or a drift may go without: default half of the range of its column.",
    },
    Key { path: "fit.free[].to", kind: Kind::NumberOfSweptKey, meaning: "The largest value allowed." },
    Key {
        path: "fit.test",
        kind: Kind::Tables,
        meaning: "The tests, one table each, which share all free numbers but offsets and drifts.",
    },
    Key {
        path: "fit.test[].data",
        kind: Kind::Text,
        meaning: "The file of the data, relative to the scene: a header such as `time (s), force (mN)`, then rows. Forces press positive.",
    },
    Key {
        path: "fit.test[].columns",
        kind: Kind::Table,
        meaning: "What the columns of `data` are called, where their names do not say it: each as in the header, with its unit if it has none there, such as `force = \"Load in mN\"`.",
    },
    Key { path: "fit.test[].columns.time", kind: Kind::Text, meaning: "The header of the time." },
    Key { path: "fit.test[].columns.penetration", kind: Kind::Text, meaning: "The header of the penetration." },
    Key { path: "fit.test[].columns.force", kind: Kind::Text, meaning: "The header of the force." },
    Key { path: "fit.test[].columns.contact_radius", kind: Kind::Text, meaning: "The header of the contact radius." },
    Key { path: "fit.test[].columns.frame", kind: Kind::Text, meaning: "The header of the displacement of the frame's far end." },
    Key {
        path: "fit.test[].set",
        kind: Kind::Texts,
        meaning: "What differs in the scene of this test, each as in `--set`: `history.0.rate = '10 µm/s'`.",
    },
    Key {
        path: "fit.errors",
        kind: Kind::Choice(&[
            Word { word: "absolute", meaning: "the noise is the same at all values; the default along a history" },
            Word { word: "relative", meaning: "the noise goes with the value, and logarithms are compared; the default across states" },
        ]),
        meaning: "How the noise of the data goes with their values. Its size is estimated from the residuals of each column of each test.",
    },
    Key {
        path: "fit.loss",
        kind: Kind::Choice(&[
            Word { word: "squares", meaning: "squares of residuals; the default" },
            Word { word: "huber", meaning: "beyond 1.345 standard deviations residuals count by their size: outliers change little" },
        ]),
        meaning: "How residuals count.",
    },
    Key {
        path: "fit.starts",
        kind: Kind::Count { least: 1, most: 100 },
        meaning: "How many descents begin at places far from each other; default 3.",
    },
];
