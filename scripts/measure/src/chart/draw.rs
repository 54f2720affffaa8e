//! Drawing a chart through plotters.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::layout::Layout;
use super::look::{Area, Look, Outcome, draw_line, draw_mark, looks};
use super::{Chart, Form, Series};

/// Between names at the ends of lines.
const LABEL: i32 = 18;
const FONT: &str = "sans-serif";
const INK: RGBColor = RGBColor(51, 51, 51);

/// Rows of charts. Charts side by side show the same series, and have one legend; on a phone they stand one below
/// the other.
pub(super) fn sheet(rows: &[Vec<Chart>], form: Form) -> String {
    let layouts: Vec<Layout> = rows.iter().map(|row| Layout::of(row, form)).collect();
    let heights = rows.iter().zip(&layouts).map(|(row, layout)| layout.height(row.len()));
    let (mut text, size) = (String::new(), (form.width(), heights.sum()));
    {
        let page = SVGBackend::with_string(&mut text, size).into_drawing_area();
        page.fill(&WHITE)
            .map_err(Into::into)
            .and_then(|()| draw(rows, &layouts, &page))
            .and_then(|()| page.present().map_err(Into::into))
            .expect("drawing into a string does not fail");
    }
    let titles: Vec<&str> = rows.iter().flatten().map(|chart| &*chart.title).collect();
    let escaped = titles.join("; ").replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replacen('>', &format!("><title>{escaped}</title>"), 1)
}

fn draw(rows: &[Vec<Chart>], layouts: &[Layout], page: &Area<'_>) -> Outcome {
    let mut rest = page.clone();
    for (row, &layout) in rows.iter().zip(layouts) {
        for charts in row.chunks(layout.across) {
            let (line, below) = rest.split_vertically(layout.plot);
            for (chart, plot) in charts.iter().zip(line.split_evenly((1, layout.across))) {
                plane(chart, layout, page, &plot)?;
            }
            rest = below;
        }
        let (legend, below) = rest.split_vertically(layout.legend);
        if layout.legend > 0 {
            entries(&row[0], layout, &legend)?;
        }
        rest = below;
    }
    Ok(())
}

fn entries(chart: &Chart, layout: Layout, legend: &Area<'_>) -> Outcome {
    let looks = looks(&chart.series);
    let named = chart.series.iter().zip(&looks).filter(|(series, _)| !series.name.is_empty());
    named.enumerate().try_for_each(|(at, (series, look))| entry(series, look, legend, layout, at))
}

fn plane(chart: &Chart, layout: Layout, page: &Area<'_>, plot: &Area<'_>) -> Outcome {
    let looks = looks(&chart.series);
    let shown = |(x, y): &(f64, f64)| chart.x.shows(*x) && chart.y.shows(*y);
    let lines: Vec<Vec<_>> =
        chart.series.iter().map(|s| s.points.iter().copied().filter(shown).collect()).collect();
    let bands: Vec<Vec<_>> =
        chart.series.iter().map(|s| outline(s).filter(shown).collect()).collect();
    let all = || lines.iter().chain(&bands).flatten();

    let (narrow, sizes) = (layout.is_narrow(), layout.sizes());
    let plot = above(chart, layout, plot)?;
    let (across, upwards) = layout.ticks();
    let mut plane = ChartBuilder::on(&plot)
        .margin(if narrow { 6 } else { 10 })
        .margin_right(if layout.names_lines(chart) { 150 } else { 24 })
        .x_label_area_size(if narrow { 44 } else { 52 })
        .y_label_area_size(layout.beside_axis(chart))
        .build_cartesian_2d(
            chart.x.fit(all().map(|p| p.0), across),
            chart.y.fit(all().map(|p| p.1), upwards),
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

    let (columns, rows) = plane.plotting_area().get_pixel_range();
    if let Some((from, what)) = &chart.beyond {
        let y = all().map(|p| p.1).next().unwrap_or(1.0);
        let left = plane.backend_coord(&(*from, y)).0.max(columns.start);
        if left < columns.end {
            let corners = [(left, rows.start), (columns.end, rows.end)];
            page.draw(&Rectangle::new(corners, BLACK.mix(0.07).filled()))?;
            // At the bottom, unless a line ends there.
            let lowest = all().map(|point| plane.backend_coord(point)).filter(|(x, _)| *x >= left);
            let is_low = lowest.map(|(_, y)| y).max() > Some(rows.end - 40);
            let (y, side) = match is_low {
                true => (rows.start + 20, VPos::Top),
                false => (rows.end - 3, VPos::Bottom),
            };
            let font = (FONT, sizes.tick).into_font();
            let style = font.color(&INK).pos(Pos::new(HPos::Right, side));
            page.draw_text(what, &style, (columns.end - 3, y))?;
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
    if !layout.names_lines(chart) {
        return Ok(());
    }
    let ends = lines.iter().map(|line| pixels(line).into_iter().max_by_key(|(x, _)| *x));
    names(&chart.series, &looks, ends, rows.end, page)
}

/// The title, perhaps what the chart shows upwards, and what is left below.
fn above<'p>(
    chart: &Chart,
    layout: Layout,
    plot: &Area<'p>,
) -> Result<Area<'p>, Box<dyn std::error::Error>> {
    let sizes = layout.sizes();
    let mut y = 4;
    let mut say = |text: &str, size: u32, (x, side): (u32, HPos)| -> Outcome {
        let style = (FONT, size).into_font().color(&INK).pos(Pos::new(side, VPos::Top));
        for line in layout.lines(text, size).trim_end().lines() {
            plot.draw_text(line, &style, (x as i32, y))?;
            y += size as i32 + 4;
        }
        Ok(())
    };
    say(&chart.title, sizes.title, (layout.width / 2, HPos::Center))?;
    if layout.says_above() {
        say(&chart.y.label, sizes.label, (12, HPos::Left))?;
    }
    Ok(plot.split_vertically(y).1)
}

/// The names of series, in the order of their lines' ends: as near as the others leave room, and none below the plot.
/// A name with a mark stands behind the last of all ends, where no line crosses it.
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
    let last = labels.iter().map(|((x, _), ..)| *x).max().unwrap_or_default();
    let mut heights: Vec<i32> = Vec::new();
    for ((_, y), ..) in &labels {
        heights.push(heights.last().map_or(*y, |above| (*y).max(above + LABEL)));
    }
    let mut below = bottom + LABEL;
    for y in heights.iter_mut().rev() {
        *y = (*y).min(below - LABEL);
        below = *y;
    }
    for (((x, _), series, look), y) in labels.into_iter().zip(heights) {
        let style =
            (FONT, 17).into_font().color(&look.colour).pos(Pos::new(HPos::Left, VPos::Center));
        let x = if series.kind.has_marks() { last + 16 } else { x };
        draw_mark(page, (x, y), series.kind, look)?;
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

/// One entry of the legend: a piece of the line, and the name.
fn entry(series: &Series, look: &Look, legend: &Area<'_>, layout: Layout, at: usize) -> Outcome {
    let (across, down) = (at % layout.columns(), at / layout.columns());
    let left = if layout.columns() == 1 { 12 } else { 82 };
    let width = legend.dim_in_pixel().0 as usize;
    let x = left + (across * (width - 80) / layout.columns()) as i32;
    let y = (down as u32 * layout.entry_row()) as i32 + 10;
    draw_line(legend, &[(x, y), (x + 36, y)], series.kind, look)?;
    draw_mark(legend, (x + 18, y), series.kind, look)?;
    let font = (FONT, layout.sizes().entry).into_font();
    let style = font.color(&INK).pos(Pos::new(HPos::Left, VPos::Center));
    legend.draw_text(&series.name, &style, (x + 44, y))?;
    Ok(())
}
