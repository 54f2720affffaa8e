//! Drawing a chart through plotters.

use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{Chart, Kind, Series};

const WIDTH: u32 = 820;
const PLOT: u32 = 460;
const BAR_ROW: u32 = 22;
const LEGEND_ROW: u32 = 24;
const LEGEND_COLUMNS: usize = 2;
const FONT: &str = "sans-serif";
const INK: RGBColor = RGBColor(51, 51, 51);
const GREY: RGBColor = RGBColor(130, 130, 130);

/// Okabe and Ito's colours, which differ for every kind of colour vision; their yellow, too
/// light for a line on white, and their black are left out.
const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
];

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Outcome = Result<(), Box<dyn std::error::Error>>;

pub(super) fn column(charts: &[Chart]) -> String {
    let mut height = 0;
    let mut inner = String::new();
    for chart in charts {
        let svg = svg(chart).replacen("<svg ", &format!("<svg y=\"{height}\" "), 1);
        inner += &svg;
        height += self::height(chart);
    }
    format!(
        "<svg width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" \
         xmlns=\"http://www.w3.org/2000/svg\">\n{inner}</svg>\n"
    )
}

/// The height of a chart without its legend.
fn plot_height(chart: &Chart) -> u32 {
    match chart.y.named().len() as u32 {
        0 => PLOT,
        bars => 110 + bars * BAR_ROW,
    }
}

fn height(chart: &Chart) -> u32 {
    plot_height(chart) + chart.series.len().div_ceil(LEGEND_COLUMNS) as u32 * LEGEND_ROW + 12
}

pub(super) fn svg(chart: &Chart) -> String {
    let mut text = String::new();
    {
        let backend = SVGBackend::with_string(&mut text, (WIDTH, height(chart)));
        draw(chart, &backend.into_drawing_area()).expect("drawing into a string does not fail");
    }
    let title = format!("<title>{}</title>", escaped(&chart.title));
    if let Some(end) = text.find('>') {
        text.insert_str(end + 1, &title);
    }
    text
}

fn draw(chart: &Chart, page: &Area<'_>) -> Outcome {
    page.fill(&WHITE)?;
    let below = plot_height(chart);
    let (plot, _) = page.split_vertically(below);
    let looks = looks(&chart.series);
    plane(chart, &looks, page, &plot)?;
    for (at, (series, look)) in chart.series.iter().zip(&looks).enumerate() {
        entry(series, look, page, (at, below))?;
    }
    page.present()?;
    Ok(())
}

/// Colour and mark of a series.
#[derive(Clone, Copy)]
struct Look {
    colour: RGBColor,
    mark: usize,
}

/// Guides are grey; the others take colours and marks in turn.
fn looks(series: &[Series]) -> Vec<Look> {
    let mut coloured = 0;
    series
        .iter()
        .map(|series| {
            if series.kind == Kind::Guide {
                return Look { colour: GREY, mark: 0 };
            }
            coloured += 1;
            let mark = coloured - 1;
            Look { colour: COLOURS[mark % COLOURS.len()], mark }
        })
        .collect()
}

fn plane(chart: &Chart, looks: &[Look], page: &Area<'_>, plot: &Area<'_>) -> Outcome {
    let shown = |(x, y): &(f64, f64)| chart.x.shows(*x) && chart.y.shows(*y);
    let lines: Vec<Vec<_>> =
        chart.series.iter().map(|s| s.points.iter().copied().filter(shown).collect()).collect();
    let bands: Vec<Vec<_>> =
        chart.series.iter().map(|s| outline(s).filter(shown).collect()).collect();
    let all = || lines.iter().chain(&bands).flatten();

    let longest = chart.y.named().iter().map(|name| name.chars().count() as u32).max();
    let mut plane = ChartBuilder::on(plot)
        .margin(10)
        .margin_right(24)
        .caption(&chart.title, (FONT, 20).into_font().color(&INK))
        .x_label_area_size(52)
        .y_label_area_size(longest.map_or(72, |characters| 9 * characters))
        .build_cartesian_2d(chart.x.fit(all().map(|p| p.0)), chart.y.fit(all().map(|p| p.1)))?;
    plane
        .configure_mesh()
        .bold_line_style(BLACK.mix(0.18))
        .light_line_style(BLACK.mix(0.06))
        .axis_style(BLACK.mix(0.5))
        .x_desc(&chart.x.label)
        .y_desc(&chart.y.label)
        .axis_desc_style((FONT, 18).into_font().color(&INK))
        .label_style((FONT, 16).into_font().color(&INK))
        .draw()?;

    let pixels = |points: &[(f64, f64)]| -> Vec<_> {
        points.iter().map(|point| plane.backend_coord(point)).collect()
    };
    for (band, look) in bands.iter().zip(looks).filter(|(band, _)| band.len() > 2) {
        page.draw(&Polygon::new(pixels(band), look.colour.mix(0.15)))?;
    }
    for ((series, line), look) in chart.series.iter().zip(&lines).zip(looks) {
        draw_line(page, &pixels(line), series.kind, look)?;
        for point in pixels(line) {
            draw_mark(page, point, series.kind, look)?;
        }
    }
    Ok(())
}

/// The corners of a series' band: along its lower bound, and back along its upper one.
fn outline(series: &Series) -> impl Iterator<Item = (f64, f64)> {
    let low = series.band.iter().map(|&(x, low, _)| (x, low));
    let high = series.band.iter().rev().map(|&(x, _, high)| (x, high));
    low.chain(high)
}

/// One entry of the legend, `below` the plot: a piece of the line, and the name.
fn entry(series: &Series, look: &Look, page: &Area<'_>, (at, below): (usize, u32)) -> Outcome {
    let column = (at % LEGEND_COLUMNS) as i32 * (WIDTH as i32 - 80) / LEGEND_COLUMNS as i32;
    let row = (at / LEGEND_COLUMNS) as i32 * LEGEND_ROW as i32;
    let (x, y) = (82 + column, below as i32 + row + 10);
    draw_line(page, &[(x, y), (x + 36, y)], series.kind, look)?;
    draw_mark(page, (x + 18, y), series.kind, look)?;
    let style = (FONT, 17).into_font().color(&INK).pos(Pos::new(HPos::Left, VPos::Center));
    page.draw_text(&series.name, &style, (x + 44, y))?;
    Ok(())
}

fn draw_line(page: &Area<'_>, points: &[(i32, i32)], kind: Kind, look: &Look) -> Outcome {
    if kind == Kind::Part {
        return draw_bars(page, points, look);
    }
    let points = points.to_vec();
    let style = look.colour.stroke_width(if kind == Kind::Guide { 1 } else { 2 });
    match kind {
        Kind::Published => page.draw(&DashedPathElement::new(points, 7, 5, style)),
        Kind::Guide => page.draw(&DashedPathElement::new(points, 3, 4, style)),
        _ => page.draw(&PathElement::new(points, style)),
    }?;
    Ok(())
}

/// A bar from each first of two points to the second.
fn draw_bars(page: &Area<'_>, points: &[(i32, i32)], look: &Look) -> Outcome {
    const HALF: i32 = 8;
    for &[(start, y), (end, _)] in points.as_chunks().0 {
        page.draw(&Rectangle::new([(start, y - HALF), (end, y + HALF)], look.colour.filled()))?;
    }
    Ok(())
}

/// A point's mark: filled for what was measured, hollow for what was published.
fn draw_mark(page: &Area<'_>, (x, y): (i32, i32), kind: Kind, look: &Look) -> Outcome {
    const SIZE: i32 = 4;
    let style = match kind {
        Kind::Measured => look.colour.filled(),
        Kind::Published => look.colour.stroke_width(2),
        Kind::Model | Kind::Guide | Kind::Part => return Ok(()),
    };
    // Five, with six colours: no two of thirty series look alike.
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

/// Text as it may stand in an SVG file.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
