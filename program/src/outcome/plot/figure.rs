//! What a plot shows, as plain data: no drawing library, no pixels.

/// Curves on two axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// A line above the frame; journals mostly want none.
    pub title: Option<String>,
    /// The axis along the bottom.
    pub horizontal: Axis,
    /// The axis along the left.
    pub vertical: Axis,
    /// The curves, drawn in this order: later ones lie on top.
    pub curves: Vec<Curve>,
    /// Where the legend goes.
    pub legend: LegendPlace,
    /// How wide the picture is on paper.
    pub width: Width,
    /// A smaller picture in a corner of the frame.
    pub inset: Option<Box<Inset>>,
    /// Cells under the curves whose colours are values.
    pub map: Option<Map>,
    /// What is left between measured points and the curves, in a lower frame.
    pub residuals: Option<Box<Residuals>>,
    /// A small line under the picture: what is not drawn.
    pub note: Option<String>,
}

/// Differences of a computed curve and a measured one, drawn below the curves over the same horizontal axis, with a line at zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Residuals {
    /// Their axis.
    pub vertical: Axis,
    /// Place and computed less measured value.
    pub points: Vec<(f64, f64)>,
    /// The sign on each point.
    pub marker: Marker,
    /// Its colour.
    pub colour: Colour,
    /// The root of their mean square, in the unit of their axis.
    pub root_mean_square: Option<f64>,
    /// One less the sum of their squares over that of the measured values from their mean.
    pub determination: Option<f64>,
}

/// A rectangular grid of cells whose colours are values.
#[derive(Debug, Clone, PartialEq)]
pub struct Map {
    /// Places of the columns, in order.
    pub across: Vec<f64>,
    /// Places of the rows, in order.
    pub up: Vec<f64>,
    /// Values, row after row; a NaN is an empty cell.
    pub values: Vec<f64>,
    /// The axis of the colours.
    pub colours: Axis,
}

/// A smaller picture in a corner of the frame of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Inset {
    /// The axis along its bottom.
    pub horizontal: Axis,
    /// The axis along its left.
    pub vertical: Axis,
    /// Its curves; their labels are not shown.
    pub curves: Vec<Curve>,
    /// Its corner; other places mean the upper right one.
    pub place: LegendPlace,
}

impl Figure {
    /// A figure without curves, one column wide, its legend placed automatically.
    #[must_use]
    pub fn new(horizontal: Axis, vertical: Axis) -> Self {
        Self {
            title: None,
            horizontal,
            vertical,
            curves: Vec::new(),
            legend: LegendPlace::Auto,
            width: Width::OneColumn,
            inset: None,
            map: None,
            residuals: None,
            note: None,
        }
    }

    /// Adds a line to what the picture says is not drawn.
    pub fn add_note(&mut self, note: impl AsRef<str>) {
        let note = note.as_ref();
        self.note = Some(self.note.take().map_or_else(|| note.to_owned(), |before| format!("{before}; {note}")));
    }

    /// Says how many points of curves a logarithmic axis has no place for, being negative. Zero is at its far end.
    pub fn note_what_is_negative(&mut self) {
        let points = || self.curves.iter().flat_map(|curve| &curve.points);
        let [across, up] = [&self.horizontal, &self.vertical].map(|axis| axis.scale == Scale::Logarithmic);
        let (all, missing) = points().fold((0, 0), |(all, missing), &(x, y)| {
            let drawn = x.is_finite() && y.is_finite();
            (all + usize::from(drawn), missing + usize::from(drawn && (across && x < 0.0 || up && y < 0.0)))
        });
        if missing > 0 {
            self.add_note(format!("{missing} of {all} points are negative and not drawn"));
        }
    }

    /// Puts a title above the frame.
    #[must_use]
    pub fn with_title(mut self, title: impl Into<String>) -> Self {
        self.title = Some(title.into());
        self
    }

    /// Adds a curve on top of the others.
    #[must_use]
    pub fn with_curve(mut self, curve: Curve) -> Self {
        self.curves.push(curve);
        self
    }

    /// Draws residuals below the curves.
    #[must_use]
    pub fn with_residuals(mut self, residuals: Residuals) -> Self {
        self.residuals = Some(Box::new(residuals));
        self
    }

    /// Sets the place of the legend.
    #[must_use]
    pub fn with_legend(mut self, legend: LegendPlace) -> Self {
        self.legend = legend;
        self
    }

    /// Sets the width on paper.
    #[must_use]
    pub fn with_width(mut self, width: Width) -> Self {
        self.width = width;
        self
    }
}

/// One axis: its label, its scale, and what part of it is shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Quantity, symbol and unit, as in `"crack speed $v$ (m/s)"`.
    pub label: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// The lower and upper end; `None` shows all data.
    pub range: Option<(f64, f64)>,
}

impl Axis {
    /// A linear axis that shows all data.
    #[must_use]
    pub fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Linear, range: None }
    }

    /// A logarithmic axis that shows all positive data.
    #[must_use]
    pub fn logarithmic(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Logarithmic, range: None }
    }

    /// Shows the axis from `lower` to `upper` only; the curves are cut at the frame.
    #[must_use]
    pub fn with_range(mut self, lower: f64, upper: f64) -> Self {
        self.range = Some((lower, upper));
        self
    }
}

/// How a value becomes a place on an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Scale {
    /// Equal differences are equal distances.
    Linear,
    /// Equal ratios are equal distances; only positive values have a place.
    Logarithmic,
}

/// One curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its line in the legend; an empty label keeps the curve out of the legend.
    pub label: String,
    /// The points in drawing order (they need not be sorted: a folded branch is drawn as it runs). A NaN is a gap.
    pub points: Vec<(f64, f64)>,
    /// The stroke between the points.
    pub line: Line,
    /// The sign on the points.
    pub marker: Marker,
    /// On which points the sign is drawn.
    pub marker_spacing: MarkerSpacing,
    /// The colour.
    pub colour: Colour,
    /// Half the height of a pale band around each point; none without a band.
    pub band: Vec<f64>,
}

impl Curve {
    /// A curve without markers whose stroke and colour follow from its place in the figure.
    #[must_use]
    pub fn new(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self {
            label: label.into(),
            points,
            line: Line::Automatic,
            marker: Marker::None,
            marker_spacing: MarkerSpacing::EveryPoint,
            colour: Colour::Automatic,
            band: Vec::new(),
        }
    }

    /// Draws a pale band, so far above and below each point; nothing where all are zero.
    #[must_use]
    pub fn with_band(mut self, halves: Vec<f64>) -> Self {
        self.band = if halves.iter().any(|half| *half > 0.0) { halves } else { Vec::new() };
        self
    }

    /// Sets the stroke.
    #[must_use]
    pub fn with_line(mut self, line: Line) -> Self {
        self.line = line;
        self
    }

    /// Draws this sign on every point.
    #[must_use]
    pub fn with_marker(mut self, marker: Marker) -> Self {
        self.marker = marker;
        self
    }

    /// Draws this sign on a few points only, evenly along the curve: it distinguishes densely sampled curves without colour.
    #[must_use]
    pub fn with_sparse_marker(mut self, marker: Marker) -> Self {
        self.marker = marker;
        self.marker_spacing = MarkerSpacing::Sparse;
        self
    }

    /// Takes a colour.
    #[must_use]
    pub fn with(mut self, colour: Colour) -> Self {
        self.colour = colour;
        self
    }

    /// Takes the colour with this index; curves that belong together share an index.
    #[must_use]
    pub fn with_colour(mut self, index: usize) -> Self {
        self.colour = Colour::Index(index);
        self
    }
}

/// The stroke of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Line {
    /// A dash pattern that goes with the place of the curve in the figure, so that no two curves look alike in grey print.
    Automatic,
    /// Full line.
    Solid,
    /// Dashes; in this project the rival, the unstable branch, the case without adhesion.
    Dashed,
    /// Dots.
    Dotted,
    /// Dash and dot.
    DashDotted,
    /// Long dashes.
    LongDashed,
    /// Dash and two dots.
    DashDoubleDotted,
    /// No stroke: markers only.
    None,
}

/// The sign drawn on a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Marker {
    /// No sign.
    None,
    /// A filled disc.
    Circle,
    /// A ring.
    OpenCircle,
    /// A filled square.
    Square,
    /// A square outline.
    OpenSquare,
    /// A filled triangle.
    Triangle,
    /// A triangle outline.
    OpenTriangle,
    /// A filled diamond.
    Diamond,
    /// A diamond outline.
    OpenDiamond,
    /// A diagonal cross; in this project the mark of a failure.
    Cross,
    /// An upright cross.
    Plus,
    /// A small disc: one of very many.
    Point,
}

impl Marker {
    /// The sign of measured points, of so many.
    #[must_use]
    pub const fn of_measured(count: usize) -> Self {
        /// More rings than these hide each other.
        const MOST_RINGS: usize = 150;
        if count <= MOST_RINGS { Self::OpenCircle } else { Self::Point }
    }
}

/// On which points the marker is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MarkerSpacing {
    /// On every point.
    EveryPoint,
    /// On a few points, evenly along the drawn length of the curve.
    Sparse,
}

/// The colour of a curve, from a palette that the colour-blind can distinguish.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Colour {
    /// By the place of the curve in the figure.
    Automatic,
    /// By this index: blue, orange, black, green, vermilion, sky blue, purple, and round again.
    Index(usize),
    /// A place in a sequence, `part` of so many: from dark to light, evenly to the eye, in grey print too.
    Sequence {
        /// From 0.
        place: usize,
        /// How many there are.
        of: usize,
    },
}

/// Where the legend is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LegendPlace {
    /// In a corner or along an edge of the frame that no curve touches; below the frame if there is none.
    Auto,
    /// In the upper left corner, whatever lies there.
    TopLeft,
    /// In the upper right corner, whatever lies there.
    TopRight,
    /// In the lower left corner, whatever lies there.
    BottomLeft,
    /// In the lower right corner, whatever lies there.
    BottomRight,
    /// Below the frame.
    Below,
    /// No legend.
    Hidden,
}

/// The width of the picture on paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Width {
    /// One column of a journal page, 88 mm.
    OneColumn,
    /// The full page, 180 mm.
    TwoColumns,
}
