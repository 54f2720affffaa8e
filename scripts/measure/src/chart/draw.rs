//! Drawing a chart through plotters.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::look::{Area, Look, Outcome, draw_line, draw_mark, looks};
use super::{Chart, Series};

const WIDTH: u32 = 820;
const PLOT: u32 = 460;
/// Height of charts side by side.
const PANEL: u32 = 300;
const BAR_ROW: u32 = 22;
const LEGEND_ROW: u32 = 24;
const LEGEND_COLUMNS: usize = 2;
/// Between names at the ends of lines.
const LABEL: i32 = 17;
const FONT: &str = "sans-serif";
const INK: RGBColor = RGBColor(51, 51, 51);

/// Where a chart is drawn: its width, the height of its plot, and whether its legend stands below.
#[derive(Clone, Copy)]
struct Place {
    width: u32,
    plot: u32,
    legend: bool,
}

impl Place {
    /// A chart that has the whole width.
    fn alone(chart: &Chart) -> Self {
        let plot = match chart.y.named().len() as u32 {
            0 => PLOT,
            bars => 110 + bars * BAR_ROW,
        };
        Self { width: WIDTH, plot, legend: chart.labels_below() }
    }

    fn height(self, chart: &Chart) -> u32 {
        let rows = chart.series.len().div_ceil(LEGEND_COLUMNS) as u32;
        self.plot + if self.legend { rows * LEGEND_ROW + 12 } else { 0 }
    }

    fn is_narrow(self) -> bool {
        self.width < WIDTH
    }
}

/// Rows of charts. Charts side by side show the same series, and have one legend.
pub(super) fn sheet(rows: &[Vec<Chart>]) -> String {
    let mut height = 0;
    let mut inner = String::new();
    let mut add = |svg: String, x: u32, y: u32| {
        inner += &svg.replacen("<svg ", &format!("<svg x=\"{x}\" y=\"{y}\" "), 1);
    };
    for row in rows {
        match &row[..] {
            [chart] => {
                let place = Place::alone(chart);
                add(svg(chart, place), 0, height);
                height += place.height(chart);
            }
            charts => {
                let width = WIDTH / charts.len().max(1) as u32;
                let place = Place { width, plot: PANEL, legend: false };
                for (chart, at) in charts.iter().zip(0..) {
                    add(svg(chart, place), at * width, height);
                }
                height += PANEL;
                if let Some(chart) = charts.first() {
                    let below = Place { width: WIDTH, plot: 0, legend: true };
                    add(legend(chart, below), 0, height);
                    height += below.height(chart);
                }
            }
        }
    }
    format!(
        "<svg width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" \
         xmlns=\"http://www.w3.org/2000/svg\">\n{inner}</svg>\n"
    )
}

pub(super) fn alone(chart: &Chart) -> String {
    svg(chart, Place::alone(chart))
}

fn svg(chart: &Chart, place: Place) -> String {
    let mut text = on_page(chart, place, |page| draw(chart, place, page));
    let title = format!("<title>{}</title>", escaped(&chart.title));
    if let Some(end) = text.find('>') {
        text.insert_str(end + 1, &title);
    }
    text
}

fn legend(chart: &Chart, place: Place) -> String {
    on_page(chart, place, |page| entries(chart, place, page))
}

fn on_page(chart: &Chart, place: Place, draw: impl FnOnce(&Area<'_>) -> Outcome) -> String {
    let mut text = String::new();
    {
        let backend = SVGBackend::with_string(&mut text, (place.width, place.height(chart)));
        let page = backend.into_drawing_area();
        page.fill(&WHITE)
            .map_err(Into::into)
            .and_then(|()| draw(&page))
            .and_then(|()| page.present().map_err(Into::into))
            .expect("drawing into a string does not fail");
    }
    text
}

fn draw(chart: &Chart, place: Place, page: &Area<'_>) -> Outcome {
    let (plot, _) = page.split_vertically(place.plot);
    plane(chart, place, page, &plot)?;
    if place.legend { entries(chart, place, page) } else { Ok(()) }
}

fn entries(chart: &Chart, place: Place, page: &Area<'_>) -> Outcome {
    let looks = looks(&chart.series);
    let mut both = chart.series.iter().zip(&looks).enumerate();
    both.try_for_each(|(at, (series, look))| entry(series, look, page, (at, place.plot)))
}

fn plane(chart: &Chart, place: Place, page: &Area<'_>, plot: &Area<'_>) -> Outcome {
    let looks = looks(&chart.series);
    let shown = |(x, y): &(f64, f64)| chart.x.shows(*x) && chart.y.shows(*y);
    let lines: Vec<Vec<_>> =
        chart.series.iter().map(|s| s.points.iter().copied().filter(shown).collect()).collect();
    let bands: Vec<Vec<_>> =
        chart.series.iter().map(|s| outline(s).filter(shown).collect()).collect();
    let all = || lines.iter().chain(&bands).flatten();

    let narrow = place.is_narrow();
    let longest = chart.y.named().iter().map(|name| name.chars().count() as u32).max();
    let beside = if narrow { 60 } else { 72 };
    let (title, label, tick) = if narrow { (16, 15, 14) } else { (20, 18, 16) };
    let mut plane = ChartBuilder::on(plot)
        .margin(if narrow { 6 } else { 10 })
        .margin_right(if chart.labels_below() { 24 } else { 150 })
        .caption(&chart.title, (FONT, title).into_font().color(&INK))
        .x_label_area_size(if narrow { 44 } else { 52 })
        .y_label_area_size(longest.map_or(beside, |characters| 9 * characters))
        .build_cartesian_2d(chart.x.fit(all().map(|p| p.0)), chart.y.fit(all().map(|p| p.1)))?;
    plane
        .configure_mesh()
        .bold_line_style(BLACK.mix(0.18))
        .light_line_style(BLACK.mix(0.06))
        .axis_style(BLACK.mix(0.5))
        .x_desc(&chart.x.label)
        .y_desc(&chart.y.label)
        .axis_desc_style((FONT, label).into_font().color(&INK))
        .label_style((FONT, tick).into_font().color(&INK))
        .draw()?;

    let (columns, rows) = plane.plotting_area().get_pixel_range();
    if let Some((from, what)) = &chart.beyond {
        let y = all().map(|p| p.1).next().unwrap_or(1.0);
        let left = plane.backend_coord(&(*from, y)).0.max(columns.start);
        if left < columns.end {
            let corners = [(left, rows.start), (columns.end, rows.end)];
            page.draw(&Rectangle::new(corners, BLACK.mix(0.07).filled()))?;
            let style = (FONT, 13).into_font().color(&INK).pos(Pos::new(HPos::Right, VPos::Bottom));
            page.draw_text(what, &style, (columns.end - 3, rows.end - 3))?;
        }
    }
    let pixels = |points: &[(f64, f64)]| -> Vec<_> {
        points.iter().map(|point| plane.backend_coord(point)).collect()
    };
    for (band, look) in bands.iter().zip(&looks).filter(|(band, _)| band.len() > 2) {
        page.draw(&Polygon::new(pixels(band), look.colour.mix(0.15)))?;
    }
    for ((series, line), look) in chart.series.iter().zip(&lines).zip(&looks) {
        draw_line(page, &pixels(line), series.kind, look)?;
        for point in pixels(line) {
            draw_mark(page, point, series.kind, look)?;
        }
    }
    if chart.labels_below() {
        return Ok(());
    }
    let ends = lines.iter().map(|line| pixels(line).into_iter().max_by_key(|(x, _)| *x));
    names(&chart.series, &looks, ends, rows.end, page)
}

/// The names of series at the ends of their lines: as near as the others leave room, and none below the plot.
fn names(
    series: &[Series],
    looks: &[Look],
    ends: impl Iterator<Item = Option<(i32, i32)>>,
    bottom: i32,
    page: &Area<'_>,
) -> Outcome {
    let mut labels: Vec<_> = ends
        .zip(series)
        .zip(looks)
        .filter_map(|((end, series), look)| Some((end?, series, look)))
        .collect();
    labels.sort_by_key(|((_, y), ..)| *y);
    let mut places: Vec<i32> = Vec::new();
    for ((_, y), ..) in &labels {
        places.push(places.last().map_or(*y, |above| (*y).max(above + LABEL)));
    }
    let mut below = bottom + LABEL;
    for place in places.iter_mut().rev() {
        *place = (*place).min(below - LABEL);
        below = *place;
    }
    for (((x, _), series, look), y) in labels.into_iter().zip(places) {
        let style =
            (FONT, 15).into_font().color(&look.colour).pos(Pos::new(HPos::Left, VPos::Center));
        page.draw_text(&series.name, &style, (x + 10, y))?;
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

/// Text as it may stand in an SVG file.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
