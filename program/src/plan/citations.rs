//! The papers behind what a scene uses, as `viscotack cite` prints them.

/// A paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Citation {
    /// Key in BibTeX.
    pub key: &'static str,
    /// What it stands for here.
    pub role: &'static str,
    /// BibTeX entry.
    pub bibtex: &'static str,
}

/// The thesis that the theory is taken from.
pub const THESIS: Citation = Citation {
    key: "Mandriota",
    role: "the energy balance at a moving edge, sliding contacts, indentation in time, and steady and delayed cracks (chapters 1, 3, 4, 5)",
    bibtex: "@phdthesis{Mandriota,\n  author = {Mandriota, C.},\n  title  = {Adhesion and friction in steady and unsteady viscoelastic contacts},\n  school = {Politecnico di Bari}\n}",
};

/// Persson and Brener's theory of opening cracks.
pub const PERSSON_BRENER: Citation = Citation {
    key: "PerssonBrener2005",
    role: "the theory persson_brener (opening; its closing form here is our energy-consistent counterpart)",
    bibtex: "@article{PerssonBrener2005,\n  author  = {Persson, B. N. J. and Brener, E. A.},\n  title   = {Crack propagation in viscoelastic solids},\n  journal = {Physical Review E},\n  volume  = {71},\n  pages   = {036123},\n  year    = {2005},\n  doi     = {10.1103/PhysRevE.71.036123}\n}",
};

/// Schapery's theory of opening cracks.
pub const SCHAPERY_OPENING: Citation = Citation {
    key: "Schapery1975",
    role: "the theory cohesive_zone (opening)",
    bibtex: "@article{Schapery1975,\n  author  = {Schapery, R. A.},\n  title   = {A theory of crack initiation and growth in viscoelastic media {I}. {T}heoretical development},\n  journal = {International Journal of Fracture},\n  volume  = {11},\n  pages   = {141--159},\n  year    = {1975},\n  doi     = {10.1007/BF00034721}\n}",
};

/// Schapery's theory of closing cracks.
pub const SCHAPERY_CLOSING: Citation = Citation {
    key: "Schapery1989",
    role: "the theory cohesive_zone and the process-zone law schapery (closing)",
    bibtex: "@article{Schapery1989,\n  author  = {Schapery, R. A.},\n  title   = {On the mechanics of crack closing and bonding in linear viscoelastic media},\n  journal = {International Journal of Fracture},\n  volume  = {39},\n  pages   = {163--189},\n  year    = {1989},\n  doi     = {10.1007/BF00047448}\n}",
};

/// Greenwood's computation of both.
pub const GREENWOOD: Citation = Citation {
    key: "Greenwood2004",
    role: "the theory cohesive_zone (both motions)",
    bibtex: "@article{Greenwood2004,\n  author  = {Greenwood, J. A.},\n  title   = {The theory of viscoelastic crack propagation and healing},\n  journal = {Journal of Physics D: Applied Physics},\n  volume  = {37},\n  pages   = {2557--2569},\n  year    = {2004},\n  doi     = {10.1088/0022-3727/37/18/011}\n}",
};

/// The pure-shear strip.
pub const RIVLIN_THOMAS: Citation = Citation {
    key: "RivlinThomas1953",
    role: "the strip: energy release rate from the energy density far ahead",
    bibtex: "@article{RivlinThomas1953,\n  author  = {Rivlin, R. S. and Thomas, A. G.},\n  title   = {Rupture of rubber. {I}. {C}haracteristic energy for tearing},\n  journal = {Journal of Polymer Science},\n  volume  = {10},\n  pages   = {291--318},\n  year    = {1953},\n  doi     = {10.1002/pol.1953.120100303}\n}",
};

/// The adhesive elastic wave.
pub const JOHNSON_WAVE: Citation = Citation {
    key: "Johnson1995",
    role: "the relaxed adhesive wave, from which a sliding one is followed; snap-in and pull-off",
    bibtex: "@article{Johnson1995,\n  author  = {Johnson, K. L.},\n  title   = {The adhesion of two elastic bodies with slightly wavy surfaces},\n  journal = {International Journal of Solids and Structures},\n  volume  = {32},\n  pages   = {423--430},\n  year    = {1995},\n  doi     = {10.1016/0020-7683(94)00111-9}\n}",
};

/// The elastic wave.
pub const WESTERGAARD: Citation = Citation {
    key: "Westergaard1939",
    role: "the relaxed wave without adhesion, from which a sliding one is followed",
    bibtex: "@article{Westergaard1939,\n  author  = {Westergaard, H. M.},\n  title   = {Bearing pressures and cracks},\n  journal = {Journal of Applied Mechanics},\n  volume  = {6},\n  pages   = {A49--A53},\n  year    = {1939}\n}",
};

/// The transform of a round contact to a line.
pub const SNEDDON: Citation = Citation {
    key: "Sneddon1965",
    role: "the round contact as a line",
    bibtex: "@article{Sneddon1965,\n  author  = {Sneddon, I. N.},\n  title   = {The relation between load and penetration in the axisymmetric {B}oussinesq problem for a punch of arbitrary profile},\n  journal = {International Journal of Engineering Science},\n  volume  = {3},\n  pages   = {47--57},\n  year    = {1965},\n  doi     = {10.1016/0020-7225(65)90019-4}\n}",
};

/// The adhesive elastic sphere.
pub const JKR: Citation = Citation {
    key: "JohnsonKendallRoberts1971",
    role: "the adhesive elastic sphere: the relaxed start, the glassy first touch, the unit of pull-off forces",
    bibtex: "@article{JohnsonKendallRoberts1971,\n  author  = {Johnson, K. L. and Kendall, K. and Roberts, A. D.},\n  title   = {Surface energy and the contact of elastic solids},\n  journal = {Proceedings of the Royal Society of London A},\n  volume  = {324},\n  pages   = {301--313},\n  year    = {1971},\n  doi     = {10.1098/rspa.1971.0141}\n}",
};

/// The advancing contact without adhesion.
pub const LEE_RADOK: Citation = Citation {
    key: "LeeRadok1960",
    role: "the viscoelastic contact without adhesion, advancing",
    bibtex: "@article{LeeRadok1960,\n  author  = {Lee, E. H. and Radok, J. R. M.},\n  title   = {The contact problem for viscoelastic bodies},\n  journal = {Journal of Applied Mechanics},\n  volume  = {27},\n  pages   = {438--444},\n  year    = {1960},\n  doi     = {10.1115/1.3644020}\n}",
};

/// The receding contact without adhesion.
pub const TING: Citation = Citation {
    key: "Ting1966",
    role: "the viscoelastic contact without adhesion, receding",
    bibtex: "@article{Ting1966,\n  author  = {Ting, T. C. T.},\n  title   = {The contact stresses between a rigid indenter and a viscoelastic half-space},\n  journal = {Journal of Applied Mechanics},\n  volume  = {33},\n  pages   = {845--854},\n  year    = {1966},\n  doi     = {10.1115/1.3625192}\n}",
};

/// The active set of a contact as a semi-smooth Newton method.
pub const PRIMAL_DUAL: Citation = Citation {
    key: "HintermuellerItoKunisch2002",
    role: "the contact set of a surface that acts at a distance",
    bibtex: "@article{HintermuellerItoKunisch2002,\n  author  = {Hinterm{\\\"u}ller, M. and Ito, K. and Kunisch, K.},\n  title   = {The primal-dual active set strategy as a semismooth {N}ewton method},\n  journal = {SIAM Journal on Optimization},\n  volume  = {13},\n  pages   = {865--888},\n  year    = {2002},\n  doi     = {10.1137/S1052623401383558}\n}",
};

/// The law of the contMech runs.
pub const CONTMECH: Citation = Citation {
    key: "WangMueser2017",
    role: "the law of attraction cosine",
    bibtex: "@article{WangMueser2017,\n  author  = {Wang, A. and M{\\\"u}ser, M. H.},\n  title   = {Gauging {P}ersson theory on adhesion},\n  journal = {Tribology Letters},\n  volume  = {65},\n  pages   = {103},\n  year    = {2017},\n  doi     = {10.1007/s11249-017-0886-9}\n}",
};

/// The 3-9 law between half-spaces, and the elastic sphere with it.
pub const GREENWOOD_1997: Citation = Citation {
    key: "Greenwood1997",
    role: "attraction of finite range: the law lennard_jones, the elastic sphere and the Tabor number",
    bibtex: "@article{Greenwood1997,\n  author  = {Greenwood, J. A.},\n  title   = {Adhesion of elastic spheres},\n  journal = {Proceedings of the Royal Society of London A},\n  volume  = {453},\n  pages   = {1277--1297},\n  year    = {1997},\n  doi     = {10.1098/rspa.1997.0070}\n}",
};

/// The viscoelastic sphere with a law of attraction.
pub const MAGHAMI: Citation = Citation {
    key: "Maghami2024",
    role: "the viscoelastic sphere with a Lennard-Jones law, whose published runs the solver is compared with",
    bibtex: "@article{Maghami2024,\n  author  = {Maghami, A. and Wang, Q. and Tricarico, M. and Ciavarella, M. and Li, Q. and Papangelo, A.},\n  title   = {Bulk and fracture process zone contribution to the rate-dependent adhesion amplification in viscoelastic broad-band materials},\n  journal = {Journal of the Mechanics and Physics of Solids},\n  volume  = {193},\n  pages   = {105844},\n  year    = {2024},\n  doi     = {10.1016/j.jmps.2024.105844}\n}",
};

/// The implicit step of the sphere with attraction of finite range.
pub const KENNEDY_CARPENTER: Citation = Citation {
    key: "KennedyCarpenter2003",
    role: "the implicit Runge-Kutta step of contacts with attraction of finite range",
    bibtex: "@article{KennedyCarpenter2003,\n  author  = {Kennedy, C. A. and Carpenter, M. H.},\n  title   = {Additive {R}unge-{K}utta schemes for convection-diffusion-reaction equations},\n  journal = {Applied Numerical Mathematics},\n  volume  = {44},\n  pages   = {139--181},\n  year    = {2003},\n  doi     = {10.1016/S0168-9274(02)00138-1}\n}",
};

/// Every paper.
pub const ALL: &[&Citation] = &[
    &THESIS,
    &PERSSON_BRENER,
    &SCHAPERY_OPENING,
    &SCHAPERY_CLOSING,
    &GREENWOOD,
    &RIVLIN_THOMAS,
    &JOHNSON_WAVE,
    &WESTERGAARD,
    &SNEDDON,
    &JKR,
    &LEE_RADOK,
    &TING,
    &PRIMAL_DUAL,
    &CONTMECH,
    &GREENWOOD_1997,
    &MAGHAMI,
    &KENNEDY_CARPENTER,
];
