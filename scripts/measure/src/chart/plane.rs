//! Draws the plane of a chart: its axes, its lines, and their names.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::axis::Fitted;
use super::figure::{Chart, Series};
use super::layout::Layout;
use super::look::{Area, Drawn, FONT, INK, Look, draw_line, draw_mark, looks};

/// Distance between names at the ends of lines.
const LABEL: i32 = 18;

/// The plane of a chart, with its axes.
type Plane<'p, 'b> = ChartContext<'p, SVGBackend<'b>, Cartesian2d<Fitted, Fitted>>;

/// A series with the points, and the corners of its band, that the axes can show.
struct Visible<'s> {
    series: &'s Series,
    look: Look,
    points: Vec<(f64, f64)>,
    band: Vec<(f64, f64)>,
}

/// Draws the plane of a chart in its part of the page.
pub(super) fn draw_plane(chart: &Chart, layout: Layout, page: &Area<'_>, plot: &Area<'_>) -> Drawn {
    let all = visible(chart);
    let plane = plane(chart, layout, plot, &all)?;
    shade(chart, layout, page, &plane, &all)?;
    for Visible { look, band, .. } in all.iter().filter(|visible| visible.band.len() > 2) {
        page.draw(&Polygon::new(pixels(&plane, band), look.colour.mix(0.15)))?;
    }
    for Visible { series, look, points, .. } in &all {
        let points = pixels(&plane, points);
        draw_line(page, &points, series.kind, look)?;
        for point in points {
            draw_mark(page, point, series.kind, look)?;
        }
    }
    if layout.names_lines(chart) { names(&all, &plane, page) } else { Ok(()) }
}

/// Finds the points that the axes can show.
fn visible(chart: &Chart) -> Vec<Visible<'_>> {
    let mut all = Vec::new();
    for (series, look) in chart.series.iter().zip(looks(&chart.series)) {
        let mut points = series.points.clone();
        let mut band = outline(series);
        points.retain(|(x, y)| chart.x.shows(*x) && chart.y.shows(*y));
        band.retain(|(x, y)| chart.x.shows(*x) && chart.y.shows(*y));
        all.push(Visible { series, look, points, band });
    }
    all
}

/// Fits the axes to all points, and draws them.
fn plane<'p, 'b>(
    chart: &Chart,
    layout: Layout,
    plot: &'p Area<'b>,
    all: &[Visible<'_>],
) -> Drawn<Plane<'p, 'b>> {
    let narrow = layout.is_narrow();
    let sizes = layout.sizes();
    let (across, upwards) = layout.ticks();
    let points = all.iter().flat_map(|visible| visible.points.iter().chain(&visible.band));
    let mut plane = ChartBuilder::on(plot)
        .margin(if narrow { 6 } else { 10 })
        .margin_right(if layout.names_lines(chart) { 150 } else { 24 })
        .x_label_area_size(if narrow { 44 } else { 52 })
        .y_label_area_size(layout.beside_axis(chart))
        .build_cartesian_2d(
            chart.x.fit(points.clone().map(|point| point.0), across),
            chart.y.fit(points.map(|point| point.1), upwards),
        )?;
    plane
        .configure_mesh()
        .bold_line_style(BLACK.mix(0.18))
        .light_line_style(BLACK.mix(0.06))
        .axis_style(BLACK.mix(0.5))
        .x_desc(&chart.x.label)
        .y_desc(if layout.says_above() { "" } else { &chart.y.label })
        .axis_desc_style((FONT, sizes.label).into_font().color(&INK))
        .label_style((FONT, sizes.tick).into_font().color(&INK))
        .draw()?;
    Ok(plane)
}

/// Draws the chart's shaded area with its text, if the chart has one.
fn shade(
    chart: &Chart,
    layout: Layout,
    page: &Area<'_>,
    plane: &Plane<'_, '_>,
    all: &[Visible<'_>],
) -> Drawn {
    let Some((from, what)) = &chart.beyond else { return Ok(()) };
    let (columns, rows) = plane.plotting_area().get_pixel_range();
    let points: Vec<_> =
        all.iter().flat_map(|visible| visible.points.iter().chain(&visible.band)).collect();
    let y = points.first().map_or(1.0, |point| point.1);
    let left = plane.backend_coord(&(*from, y)).0.max(columns.start);
    if left >= columns.end {
        return Ok(());
    }
    let corners = [(left, rows.start), (columns.end, rows.end)];
    page.draw(&Rectangle::new(corners, BLACK.mix(0.07).filled()))?;
    // The text is at the bottom, unless a line ends there.
    let there = points.into_iter().map(|point| plane.backend_coord(point));
    let lowest = there.filter(|(x, _)| *x >= left).map(|(_, y)| y).max();
    let (y, side) = match lowest > Some(rows.end - 40) {
        true => (rows.start + 20, VPos::Top),
        false => (rows.end - 3, VPos::Bottom),
    };
    let font = (FONT, layout.sizes().tick).into_font();
    let style = font.color(&INK).pos(Pos::new(HPos::Right, side));
    page.draw_text(what, &style, (columns.end - 3, y))?;
    Ok(())
}

fn pixels(plane: &Plane<'_, '_>, points: &[(f64, f64)]) -> Vec<(i32, i32)> {
    points.iter().map(|point| plane.backend_coord(point)).collect()
}

/// Writes the names of series, in the order of their lines' ends.
///
/// A name is as close to its line's end as the other names allow, but never below the plot. A name
/// with a mark is to the right of all ends, where no line crosses it.
fn names(all: &[Visible<'_>], plane: &Plane<'_, '_>, page: &Area<'_>) -> Drawn {
    let mut labels = Vec::new();
    for visible in all {
        let end = pixels(plane, &visible.points).into_iter().max_by_key(|(x, _)| *x);
        labels.extend(end.map(|end| (end, visible)));
    }
    labels.sort_by_key(|((_, y), _)| *y);
    let last = labels.iter().map(|((x, _), _)| *x).max().unwrap_or_default();
    let mut heights: Vec<i32> = Vec::new();
    for ((_, y), _) in &labels {
        heights.push(heights.last().map_or(*y, |above| (*y).max(above + LABEL)));
    }
    let mut below = plane.plotting_area().get_pixel_range().1.end + LABEL;
    for y in heights.iter_mut().rev() {
        *y = (*y).min(below - LABEL);
        below = *y;
    }
    for (((x, _), Visible { series, look, .. }), y) in labels.into_iter().zip(heights) {
        let style =
            (FONT, 17).into_font().color(&look.colour).pos(Pos::new(HPos::Left, VPos::Center));
        let x = if series.kind.has_marks() { last + 16 } else { x };
        draw_mark(page, (x, y), series.kind, look)?;
        page.draw_text(&series.name, &style, (x + 10, y))?;
    }
    Ok(())
}

/// Returns the corners of a series' band: along its lower bound, and back along its upper bound.
fn outline(series: &Series) -> Vec<(f64, f64)> {
    let low = series.band.iter().map(|&(x, low, _)| (x, low));
    let high = series.band.iter().rev().map(|&(x, _, high)| (x, high));
    low.chain(high).collect()
}
