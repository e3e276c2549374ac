//! Roles, their colours in light and dark, and the fixed style of every sampler.
//!
//! The hues are derived from Okabe and Ito's palette (2008) and Tol's (2021), darkened for white pages and lightened for dark
//! ones until each has a contrast of at least 3:1. Series differ in dash and marker as well, so that colour is never alone.
//! A drawing carries the light colours as attributes and the roles as classes; [`css`] makes the classes follow the theme.

/// What a stroke or a fill is for; its colour follows from it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Role {
    /// Text, and what must be seen first.
    Ink,
    /// Axes, ticks, their labels, secondary words.
    Axis,
    /// Lines that only guide the eye.
    Grid,
    /// Borders of strata: finer than points, plainer than the grid.
    Strata,
    /// The page, behind marks.
    Page,
    /// The pale fill of bars and areas.
    Fill,
    /// A theoretical line.
    Theory,
    /// The true value.
    Exact,
    /// What a figure points at.
    Accent,
    /// What is secondary: bands, single runs.
    Muted,
    /// A series: vermilion.
    Vermilion,
    /// A series: ochre.
    Ochre,
    /// A series: purple.
    Purple,
    /// A series: teal.
    Teal,
    /// A series: green.
    Green,
    /// A series: blue.
    Blue,
    /// A series: violet.
    Violet,
    /// A series: wine.
    Wine,
    /// A series: slate.
    Slate,
    /// A series: olive.
    Olive,
    /// The first of six steps of an order, from light to strong.
    Step1,
    /// The second step.
    Step2,
    /// The third step.
    Step3,
    /// The fourth step.
    Step4,
    /// The fifth step.
    Step5,
    /// The last step.
    Step6,
}

/// Each role with its name in CSS, its light and its dark colour.
const COLOURS: [(Role, &str, &str, &str); 26] = [
    (Role::Ink, "ink", "#1c1f24", "#e8e6e1"),
    (Role::Axis, "axis", "#565b63", "#aab0b8"),
    (Role::Grid, "grid", "#e3e5e8", "#33383f"),
    (Role::Strata, "strata", "#b9bec6", "#565d67"),
    (Role::Page, "page", "#ffffff", "#16181c"),
    (Role::Fill, "fill", "#6490bb", "#5f89b0"),
    (Role::Theory, "theory", "#3c4149", "#c9ccd1"),
    (Role::Exact, "exact", "#1c1f24", "#e8e6e1"),
    (Role::Accent, "accent", "#c0392b", "#ff8a75"),
    (Role::Muted, "muted", "#7a818b", "#8d949e"),
    (Role::Vermilion, "vermilion", "#c9480a", "#f58a4b"),
    (Role::Ochre, "ochre", "#a87400", "#e5b13a"),
    (Role::Purple, "purple", "#b0479b", "#e48fd0"),
    (Role::Teal, "teal", "#148a9c", "#56c7d6"),
    (Role::Green, "green", "#00734f", "#35c594"),
    (Role::Blue, "blue", "#0068ad", "#5eb0f2"),
    (Role::Violet, "violet", "#47309e", "#ab9bf8"),
    (Role::Wine, "wine", "#7d1d4f", "#e9789f"),
    (Role::Slate, "slate", "#46586b", "#9fb4c9"),
    (Role::Olive, "olive", "#66701a", "#bcc75a"),
    (Role::Step1, "step1", "#b08a12", "#6f63bd"),
    (Role::Step2, "step2", "#6f9130", "#4f79b8"),
    (Role::Step3, "step3", "#2f9468", "#3aa0b5"),
    (Role::Step4, "step4", "#1f7d8c", "#3dbd93"),
    (Role::Step5, "step5", "#2f5597", "#93d160"),
    (Role::Step6, "step6", "#3b1d6e", "#f3e34c"),
];

impl Role {
    /// The steps of an order: their lightness falls evenly on a white page and rises on a dark one.
    pub const STEPS: [Self; 6] = [Self::Step1, Self::Step2, Self::Step3, Self::Step4, Self::Step5, Self::Step6];

    /// Every role, in the order of the palette.
    pub fn all() -> impl Iterator<Item = Self> {
        COLOURS.iter().map(|row| row.0)
    }

    /// Its name in CSS: `--chart-NAME`, `.s-NAME` for strokes, `.f-NAME` for fills.
    pub fn name(self) -> &'static str {
        self.row().1
    }

    /// Its colour on a white page and in print.
    pub fn light(self) -> &'static str {
        self.row().2
    }

    /// Its colour on a dark page.
    pub fn dark(self) -> &'static str {
        self.row().3
    }

    fn row(self) -> &'static (Self, &'static str, &'static str, &'static str) {
        &COLOURS[self as usize]
    }
}

/// How a line is broken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Dash {
    /// Unbroken.
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// Dashes and dots.
    DashDot,
    /// Long dashes.
    Long,
    /// A dash and two dots.
    DashDotDot,
}

impl Dash {
    /// How lines of reference are broken, in their order, so that each is known from the others.
    pub const REFERENCES: [Self; 5] = [Self::Dashed, Self::Dotted, Self::DashDot, Self::Long, Self::DashDotDot];

    /// The lengths of strokes and gaps, in units, for round ends.
    pub(super) fn lengths(self) -> &'static str {
        match self {
            Self::Solid => "",
            Self::Dashed => "5 4.5",
            Self::Dotted => "0.01 4",
            Self::DashDot => "7 4.5 0.01 4.5",
            Self::Long => "11 5",
            Self::DashDotDot => "7 4 0.01 4 0.01 4",
        }
    }
}

/// The shape of a mark.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Marker {
    /// A filled circle.
    Disc,
    /// A filled square.
    Square,
    /// A filled diamond.
    Diamond,
    /// A triangle on its base.
    Up,
    /// A triangle on its tip.
    Down,
    /// An upright cross.
    Plus,
    /// A slanted cross.
    Cross,
    /// An open circle.
    Ring,
}

/// How a series looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Style {
    /// Its colour.
    pub role: Role,
    /// How its lines are broken.
    pub dash: Dash,
    /// The shape of its marks.
    pub marker: Marker,
}

/// The samplers and their styles through the whole book, and those of the scrambled ones that it compares: any two differ in at
/// least two of colour, dash and marker.
const SAMPLERS: [(&str, Style); 43] = [
    ("independent", Style { role: Role::Vermilion, dash: Dash::Solid, marker: Marker::Disc }),
    ("jittered", Style { role: Role::Ochre, dash: Dash::Dashed, marker: Marker::Square }),
    ("latin-hypercube", Style { role: Role::Purple, dash: Dash::DashDot, marker: Marker::Diamond }),
    ("van-der-corput", Style { role: Role::Teal, dash: Dash::Long, marker: Marker::Down }),
    ("halton", Style { role: Role::Green, dash: Dash::Dotted, marker: Marker::Up }),
    ("sobol", Style { role: Role::Blue, dash: Dash::Solid, marker: Marker::Square }),
    ("sobol+xor", Style { role: Role::Violet, dash: Dash::Dashed, marker: Marker::Diamond }),
    ("sobol+owen", Style { role: Role::Wine, dash: Dash::Long, marker: Marker::Disc }),
    ("halton+owen", Style { role: Role::Olive, dash: Dash::DashDot, marker: Marker::Down }),
    ("multi-jittered", Style { role: Role::Slate, dash: Dash::DashDotDot, marker: Marker::Cross }),
    ("grid", Style { role: Role::Muted, dash: Dash::Dotted, marker: Marker::Plus }),
    ("van-der-corput+xor", Style { role: Role::Violet, dash: Dash::Dotted, marker: Marker::Ring }),
    ("halton+cranley-patterson", Style { role: Role::Teal, dash: Dash::Dashed, marker: Marker::Ring }),
    ("halton+xor", Style { role: Role::Olive, dash: Dash::Dashed, marker: Marker::Cross }),
    ("dart-throwing", Style { role: Role::Teal, dash: Dash::Solid, marker: Marker::Diamond }),
    ("maximal-poisson", Style { role: Role::Violet, dash: Dash::DashDot, marker: Marker::Up }),
    ("best-candidate", Style { role: Role::Green, dash: Dash::Solid, marker: Marker::Down }),
    ("bridson", Style { role: Role::Slate, dash: Dash::DashDot, marker: Marker::Square }),
    ("pmj02", Style { role: Role::Blue, dash: Dash::Dashed, marker: Marker::Down }),
    ("hammersley", Style { role: Role::Green, dash: Dash::Long, marker: Marker::Diamond }),
    ("faure", Style { role: Role::Olive, dash: Dash::Dotted, marker: Marker::Square }),
    ("niederreiter", Style { role: Role::Purple, dash: Dash::Dashed, marker: Marker::Disc }),
    ("korobov", Style { role: Role::Slate, dash: Dash::Solid, marker: Marker::Up }),
    ("kronecker", Style { role: Role::Vermilion, dash: Dash::Dashed, marker: Marker::Up }),
    ("fibonacci", Style { role: Role::Ochre, dash: Dash::DashDotDot, marker: Marker::Diamond }),
    ("larcher-pillichshammer", Style { role: Role::Wine, dash: Dash::DashDotDot, marker: Marker::Down }),
    ("zero-two", Style { role: Role::Teal, dash: Dash::DashDotDot, marker: Marker::Disc }),
    ("orthogonal-array", Style { role: Role::Violet, dash: Dash::Long, marker: Marker::Square }),
    ("orthogonal-array-bush", Style { role: Role::Olive, dash: Dash::Long, marker: Marker::Up }),
    ("correlated-multi-jittered", Style { role: Role::Green, dash: Dash::DashDotDot, marker: Marker::Square }),
    ("padded-jittered", Style { role: Role::Purple, dash: Dash::Dotted, marker: Marker::Down }),
    ("uniform-jitter", Style { role: Role::Blue, dash: Dash::Dotted, marker: Marker::Diamond }),
    ("centred-grid", Style { role: Role::Muted, dash: Dash::DashDot, marker: Marker::Disc }),
    ("radical-inverse", Style { role: Role::Ochre, dash: Dash::Dotted, marker: Marker::Disc }),
    ("folded", Style { role: Role::Muted, dash: Dash::DashDotDot, marker: Marker::Up }),
    ("halton+permutation", Style { role: Role::Vermilion, dash: Dash::DashDot, marker: Marker::Plus }),
    ("halton+faure-permutation", Style { role: Role::Ochre, dash: Dash::DashDot, marker: Marker::Ring }),
    ("sobol+cranley-patterson", Style { role: Role::Teal, dash: Dash::DashDot, marker: Marker::Cross }),
    ("sobol+owen-hash", Style { role: Role::Green, dash: Dash::Dashed, marker: Marker::Plus }),
    ("sobol+linear", Style { role: Role::Slate, dash: Dash::Long, marker: Marker::Plus }),
    ("sobol+permutation", Style { role: Role::Purple, dash: Dash::Long, marker: Marker::Cross }),
    ("larcher-pillichshammer+xor", Style { role: Role::Violet, dash: Dash::Solid, marker: Marker::Cross }),
    ("zero-two+xor", Style { role: Role::Blue, dash: Dash::DashDotDot, marker: Marker::Ring }),
];

impl Style {
    /// Plain ink.
    pub const INK: Self = Self::new(Role::Ink);
    /// A pale fill.
    pub const FILL: Self = Self::new(Role::Fill);
    /// A theoretical line.
    pub const THEORY: Self = Self::new(Role::Theory).dash(Dash::Dashed);
    /// The true value.
    pub const EXACT: Self = Self::new(Role::Exact).dash(Dash::Dotted);
    /// What is secondary.
    pub const MUTED: Self = Self::new(Role::Muted);
    /// What the figure points at.
    pub const ACCENT: Self = Self::new(Role::Accent);
    /// The colours of series.
    const SERIES: [Role; 10] = [
        Role::Vermilion,
        Role::Ochre,
        Role::Purple,
        Role::Teal,
        Role::Green,
        Role::Blue,
        Role::Violet,
        Role::Wine,
        Role::Slate,
        Role::Olive,
    ];

    /// A solid line and discs.
    pub const fn new(role: Role) -> Self {
        Self { role, dash: Dash::Solid, marker: Marker::Disc }
    }

    /// Broken like this.
    #[must_use]
    pub const fn dash(mut self, dash: Dash) -> Self {
        self.dash = dash;
        self
    }

    /// With marks of this shape.
    #[must_use]
    pub const fn marker(mut self, marker: Marker) -> Self {
        self.marker = marker;
        self
    }

    /// The style of a method, by the name that chapters use: the same through the whole book. A name without one of its own
    /// gets one that follows from its letters alone, so that no other method's style depends on it; its line looks like none
    /// of those that have their own.
    pub fn of(method: &str) -> Self {
        const DASHES: [Dash; 6] =
            [Dash::Solid, Dash::Dashed, Dash::Dotted, Dash::DashDot, Dash::Long, Dash::DashDotDot];
        // Open shapes: the methods with a style of their own mostly have filled ones.
        const MARKERS: [Marker; 3] = [Marker::Ring, Marker::Cross, Marker::Plus];
        if let Some((_, style)) = SAMPLERS.iter().find(|row| row.0 == method) {
            return *style;
        }
        let hash = method
            .bytes()
            .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3));
        let pick = |shift: u32, count: usize| ((hash >> shift) % count.max(1) as u64) as usize;
        let lines = Self::SERIES.iter().flat_map(|&role| DASHES.map(|dash| Self::new(role).dash(dash)));
        let taken = |line: &Self| SAMPLERS.iter().any(|row| (row.1.role, row.1.dash) == (line.role, line.dash));
        let free: Vec<Self> = lines.filter(|line| !taken(line)).collect();
        let line = free.get(pick(7, free.len())).copied().unwrap_or(Self::MUTED);
        line.marker(MARKERS[pick(41, MARKERS.len())])
    }

    /// The style of the `index`-th of several series that are no methods, e.g. integrands or counts.
    pub fn nth(index: usize) -> Self {
        const ORDER: [usize; 10] = [5, 0, 4, 2, 1, 6, 3, 7, 8, 9];
        SAMPLERS[ORDER[index % ORDER.len()]].1
    }
}

/// The style sheet that themes the drawings in a page: light, dark by the reader's system or choice, and light in print.
pub fn css() -> String {
    let declare = |colour: fn(Role) -> &'static str| -> String {
        Role::all().flat_map(|role| ["--chart-", role.name(), ":", colour(role), ";"]).collect()
    };
    let (light, dark) = (declare(Role::light), declare(Role::dark));
    let mut css = format!(
        ":root{{{light}}}\n\
         @media screen and (prefers-color-scheme:dark){{:root:not([data-theme=light]){{{dark}}}}}\n\
         @media screen{{:root[data-theme=dark]{{{dark}}}}}\n"
    );
    for role in Role::all() {
        let name = role.name();
        for part in
            [".chart .s-", name, "{stroke:var(--chart-", name, ")}.chart .f-", name, "{fill:var(--chart-", name, ")}\n"]
        {
            css.push_str(part);
        }
    }
    css += ".chart{display:block;max-width:100%;height:auto;margin-inline:auto;font-family:var(--chart-font,Helvetica,Arial,sans-serif)}\n\
            .chart .m{font-family:var(--chart-math,Georgia,\"Times New Roman\",serif)}\n\
            @media screen and (min-width:34em){.chart.named{min-width:min(30rem,var(--width,30rem))}}\n\
            @media screen and (max-width:30em){.chart{font-size:16.5px}}\n";
    css
}

#[cfg(test)]
mod tests;
