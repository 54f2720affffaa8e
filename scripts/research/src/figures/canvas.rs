//! A sheet to draw on, that becomes an SVG file.

use std::fmt::Write;

use lab_measure::chart::escaped;

/// Dark ink, for what matters.
pub(super) const INK: &str = "#333333";
/// Grey, for what is only there.
pub(super) const GREY: &str = "#a9b0b8";
/// Blue and orange of the kit's charts.
pub(super) const BLUE: &str = "#0072b2";
pub(super) const ORANGE: &str = "#d55e00";
/// Tints of these two, for areas.
pub(super) const PALE_BLUE: &str = "#d6e9f5";
pub(super) const PALE_ORANGE: &str = "#fbe3d3";

/// A position on the sheet, in pixels from the upper left corner.
pub(super) type Point = (f64, f64);

/// A phone shows a sheet as wide as its page, or lets a wide one be scrolled; text on it is at least so high.
const PHONE: f64 = 350.0;
const SCROLLED: f64 = 600.0;
const LEAST_TEXT: f64 = 12.0;

/// A white sheet.
pub(super) struct Canvas {
    title: String,
    width: f64,
    height: f64,
    body: String,
}

/// How something is drawn.
#[derive(Clone, Copy)]
pub(super) struct Style {
    fill: &'static str,
    stroke: &'static str,
    width: f64,
    opacity: f64,
    dashed: bool,
}

/// An area of one colour, without an outline.
pub(super) fn filled(fill: &'static str) -> Style {
    Style { fill, stroke: "none", width: 0.0, opacity: 1.0, dashed: false }
}

/// A line or an outline.
pub(super) fn outlined(stroke: &'static str, width: f64) -> Style {
    Style { fill: "none", stroke, width, opacity: 1.0, dashed: false }
}

impl Style {
    /// The same, filled.
    pub(super) fn on(self, fill: &'static str) -> Self {
        Self { fill, ..self }
    }

    /// The same, partly transparent.
    pub(super) fn faint(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    /// The same in dashes.
    pub(super) fn dashed(self) -> Self {
        Self { dashed: true, ..self }
    }

    fn attributes(self) -> String {
        let mut text = format!("fill=\"{}\"", self.fill);
        if self.stroke != "none" {
            let _ = write!(text, " stroke=\"{}\" stroke-width=\"{}\"", self.stroke, self.width);
        }
        if self.dashed {
            text.push_str(" stroke-dasharray=\"6 5\"");
        }
        if self.opacity < 1.0 {
            let _ = write!(text, " opacity=\"{}\"", self.opacity);
        }
        text
    }
}

impl Canvas {
    /// An empty sheet; `title` is what a reader hears who cannot see it.
    pub(super) fn new(title: &str, width: f64, height: f64) -> Self {
        Self { title: title.into(), width, height, body: String::new() }
    }

    pub(super) fn circle(&mut self, (x, y): Point, radius: f64, style: Style) {
        self.shape("circle", &[("cx", x), ("cy", y), ("r", radius)], style);
    }

    pub(super) fn rectangle(&mut self, (x, y): Point, width: f64, height: f64, style: Style) {
        self.shape("rect", &[("x", x), ("y", y), ("width", width), ("height", height)], style);
    }

    pub(super) fn line(&mut self, (x, y): Point, (to_x, to_y): Point, style: Style) {
        self.shape("line", &[("x1", x), ("y1", y), ("x2", to_x), ("y2", to_y)], style);
    }

    fn shape(&mut self, name: &str, numbers: &[(&str, f64)], style: Style) {
        let numbers = numbers.iter().map(|(name, value)| format!("{name}=\"{}\" ", short(*value)));
        let numbers: String = numbers.collect();
        let _ = writeln!(self.body, "<{name} {numbers}{}/>", style.attributes());
    }

    /// Text centred at a position, of that size or as large as a phone needs it.
    pub(super) fn text(&mut self, (x, y): Point, size: f64, colour: &'static str, text: &str) {
        let shown = if self.width <= SCROLLED { PHONE } else { SCROLLED };
        let least = (10.0 * LEAST_TEXT * self.width / shown).ceil() / 10.0;
        let size = size.max(least);
        let (x, y, text) = (short(x), short(y), escaped(text));
        let _ = writeln!(
            self.body,
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{colour}\" text-anchor=\"middle\">{text}</text>"
        );
    }

    /// The finished picture.
    pub(super) fn svg(self) -> String {
        let Self { title, width, height, body } = self;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\">\n<title>{}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{body}</svg>\n",
            escaped(&title)
        )
    }
}

/// A square part of a sheet, with a square scene in it.
pub(super) struct Panel {
    pub(super) left: f64,
    pub(super) top: f64,
    /// Its side, in pixels, and that of the scene.
    pub(super) pixels: f64,
    pub(super) side: f64,
}

impl Panel {
    /// A position of the scene on the sheet; y goes up.
    pub(super) fn at(&self, (x, y): Point) -> Point {
        (self.left + self.long(x), self.top + self.pixels - self.long(y))
    }

    /// How long a length of the scene is on the sheet.
    pub(super) fn long(&self, length: f64) -> f64 {
        length * self.pixels / self.side
    }

    pub(super) fn frame(&self, canvas: &mut Canvas, style: Style) {
        canvas.rectangle((self.left, self.top), self.pixels, self.pixels, style);
    }

    /// Text in the middle, so far below the panel's upper edge.
    pub(super) fn text(&self, canvas: &mut Canvas, down: f64, size: f64, text: &str) {
        canvas.text((self.left + self.pixels / 2.0, self.top + down), size, INK, text);
    }
}

/// A coordinate to a tenth of a pixel.
fn short(value: f64) -> String {
    let text = format!("{value:.1}");
    let text = text.strip_suffix(".0").unwrap_or(&text);
    if text == "-0" { "0".into() } else { text.into() }
}
