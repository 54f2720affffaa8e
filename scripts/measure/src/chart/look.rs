//! The look of a series: its colour, its line and the marks of its points.

use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;

use super::figure::{Kind, Series};

pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub(super) type Drawn<T = ()> = Result<T, Box<dyn std::error::Error>>;

pub(super) const FONT: &str = "sans-serif";
pub(super) const INK: RGBColor = RGBColor(51, 51, 51);
const GREY: RGBColor = RGBColor(130, 130, 130);

/// Colours of measurements.
///
/// The first three are Okabe and Ito's darker colours, which differ for every kind of colour
/// vision. Lines with the other three colours also differ in their marks.
const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(122, 81, 149),
    RGBColor(135, 95, 45),
    RGBColor(51, 51, 51),
];

/// Colour of each report in all figures.
const REPORTS: [(&str, RGBColor); 4] = [
    ("CS267", RGBColor(204, 121, 167)),
    ("CSC367", RGBColor(86, 180, 233)),
    ("CSC581", RGBColor(230, 159, 0)),
    ("CS3210", RGBColor(148, 148, 24)),
];

#[derive(Clone, Copy)]
pub(super) struct Look {
    pub(super) colour: RGBColor,
    mark: usize,
}

/// Chooses the looks of series.
///
/// Guides and comparisons are grey, and each report has its own colour. The other series take
/// colours and marks in turn.
pub(super) fn looks(all: &[Series]) -> Vec<Look> {
    let mut looks = Vec::new();
    let mut coloured = 0;
    let mut published = 0;
    for series in all {
        let report = REPORTS.iter().find(|(report, _)| series.name.starts_with(report));
        looks.push(match (series.kind, report) {
            (Kind::Guide | Kind::Behind | Kind::Crowd, _) => Look { colour: GREY, mark: 0 },
            (Kind::Published, Some(&(_, colour))) => {
                published += 1;
                Look { colour, mark: published - 1 }
            }
            _ => {
                coloured += 1;
                Look { colour: COLOURS[(coloured - 1) % COLOURS.len()], mark: coloured - 1 }
            }
        });
    }
    looks
}

/// Draws the line of a series through points on the page.
pub(super) fn draw_line(page: &Area<'_>, points: &[(i32, i32)], kind: Kind, look: &Look) -> Drawn {
    if kind == Kind::Part {
        return draw_bars(page, points, look);
    }
    if kind == Kind::Behind || kind == Kind::Apart {
        return Ok(());
    }
    let points = points.to_vec();
    let style =
        look.colour.stroke_width(if matches!(kind, Kind::Guide | Kind::Crowd) { 1 } else { 2 });
    match kind {
        Kind::Published => page.draw(&DashedPathElement::new(points, 7, 5, style)),
        Kind::Guide => page.draw(&DashedPathElement::new(points, 3, 4, style)),
        _ => page.draw(&PathElement::new(points, style)),
    }?;
    Ok(())
}

/// Draws bars: each pair of points is the start and the end of a bar.
fn draw_bars(page: &Area<'_>, points: &[(i32, i32)], look: &Look) -> Drawn {
    const HALF: i32 = 8;
    for &[(start, y), (end, _)] in points.as_chunks().0 {
        page.draw(&Rectangle::new([(start, y - HALF), (end, y + HALF)], look.colour.filled()))?;
    }
    Ok(())
}

impl Kind {
    /// Whether points have marks.
    pub(super) fn has_marks(self) -> bool {
        matches!(self, Self::Measured | Self::Apart | Self::Behind | Self::Published)
    }
}

/// Draws a point's mark: filled if it was measured, hollow if it was published.
pub(super) fn draw_mark(page: &Area<'_>, (x, y): (i32, i32), kind: Kind, look: &Look) -> Drawn {
    const SIZE: i32 = 4;
    let style = match kind {
        Kind::Measured | Kind::Apart | Kind::Behind => look.colour.filled(),
        Kind::Published => look.colour.stroke_width(2),
        _ => return Ok(()),
    };
    // There are five marks and six colours, so no two of thirty series look the same.
    match look.mark % 5 {
        0 => page.draw(&Circle::new((x, y), SIZE, style)),
        1 => page.draw(&Rectangle::new([(x - SIZE, y - SIZE), (x + SIZE, y + SIZE)], style)),
        2 => page.draw(&TriangleMarker::new((x, y), SIZE + 2, style)),
        3 => page.draw(&Cross::new((x, y), SIZE, look.colour.stroke_width(2))),
        _ => {
            let far = SIZE + 2;
            let corners = [(x, y - far), (x + far, y), (x, y + far), (x - far, y), (x, y - far)];
            match kind {
                Kind::Published => page.draw(&PathElement::new(corners, style)),
                _ => page.draw(&Polygon::new(corners, style)),
            }
        }
    }?;
    Ok(())
}
