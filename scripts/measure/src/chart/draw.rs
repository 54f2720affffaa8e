//! Draws figures with plotters.

use lab_kit::escape::html;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::figure::{Chart, Form, Series};
use super::layout::Layout;
use super::look::{Area, Drawn, FONT, INK, Look, draw_line, draw_mark, looks};
use super::plane::draw_plane;

/// Draws rows of charts as one SVG document with a white background and standard fonts.
///
/// Charts in a row show the same series and have one legend. In a figure for phones, each chart is
/// below the previous chart.
pub fn svg(rows: &[Vec<Chart>], form: Form) -> String {
    let layouts: Vec<Layout> = rows.iter().map(|row| Layout::of(row, form)).collect();
    let heights = rows.iter().zip(&layouts).map(|(row, layout)| layout.height(row.len()));
    let size = (form.width(), heights.sum());
    let mut text = String::new();
    {
        let page = SVGBackend::with_string(&mut text, size).into_drawing_area();
        draw(rows, &layouts, &page).expect("drawing into a string does not fail");
    }
    let titles: Vec<&str> = rows.iter().flatten().map(|chart| &*chart.title).collect();
    text.replacen('>', &format!("><title>{}</title>", html(&titles.join("; "))), 1)
}

fn draw(rows: &[Vec<Chart>], layouts: &[Layout], page: &Area<'_>) -> Drawn {
    page.fill(&WHITE)?;
    let mut rest = page.clone();
    for (row, &layout) in rows.iter().zip(layouts) {
        for charts in row.chunks(layout.across) {
            let (line, below) = rest.split_vertically(layout.plot);
            for (chart, plot) in charts.iter().zip(line.split_evenly((1, layout.across))) {
                let plot = above(chart, layout, &plot)?;
                draw_plane(chart, layout, page, &plot)?;
            }
            rest = below;
        }
        let (legend, below) = rest.split_vertically(layout.legend);
        if layout.legend > 0 {
            entries(&row[0], layout, &legend)?;
        }
        rest = below;
    }
    page.present()?;
    Ok(())
}

/// Writes the title and, in a narrow layout, the label of the y axis. Returns the area below them.
fn above<'p>(chart: &Chart, layout: Layout, plot: &Area<'p>) -> Drawn<Area<'p>> {
    let sizes = layout.sizes();
    let centred = (layout.width / 2, HPos::Center);
    let mut texts = vec![(&chart.title, sizes.title, centred)];
    if layout.says_above() {
        texts.push((&chart.y.label, sizes.label, (12, HPos::Left)));
    }
    let mut y = 4;
    for (text, size, (x, side)) in texts {
        let style = (FONT, size).into_font().color(&INK).pos(Pos::new(side, VPos::Top));
        for line in layout.lines(text, size).trim_end().lines() {
            plot.draw_text(line, &style, (x as i32, y))?;
            y += size as i32 + 4;
        }
    }
    Ok(plot.split_vertically(y).1)
}

fn entries(chart: &Chart, layout: Layout, legend: &Area<'_>) -> Drawn {
    let looks = looks(&chart.series);
    let named = chart.series.iter().zip(&looks).filter(|(series, _)| !series.name.is_empty());
    named.enumerate().try_for_each(|(at, (series, look))| entry(series, look, legend, layout, at))
}

/// Draws an entry of the legend: a piece of the line, and the name.
fn entry(series: &Series, look: &Look, legend: &Area<'_>, layout: Layout, at: usize) -> Drawn {
    let across = at % layout.columns();
    let down = at / layout.columns();
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::axis::Axis;
    use crate::chart::figure::Kind;

    fn alone(chart: Chart) -> String {
        svg(&[vec![chart]], Form::Page)
    }

    #[test]
    fn a_chart_names_what_it_shows() {
        let line = vec![(1000.0, 0.1), (2000.0, 0.2), (64_000.0, 6.0)];
        let chart = Chart::new("Time < n & more", Axis::log("particles n"), Axis::log("time [s]"))
            .with(Series::new(Kind::Measured, "sorted", line.clone()))
            .with(Series::new(Kind::Published, "CS267, Table 1", line.clone()))
            .with(Series::new(Kind::Guide, "slope 1", line));
        let svg = alone(chart);
        for text in
            ["Time &lt; n &amp; more", "particles n", "time [s]", "sorted", "CS267, Table 1"]
        {
            assert!(svg.contains(text), "{text} is missing");
        }
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    }

    #[test]
    fn the_parts_of_a_bar_follow_each_other() {
        let rows = [("one".into(), vec![2.0, 1.0]), ("two".into(), vec![0.5, 0.25])];
        let chart = Chart::bars("Where", Axis::linear("ms"), &["work", "wait"], &rows);
        let points: Vec<_> = chart.series.iter().map(|part| part.points.clone()).collect();
        let work = vec![(0.0, 0.0), (2.0, 0.0), (0.0, 1.0), (0.5, 1.0)];
        assert_eq!(points, [work, vec![(2.0, 0.0), (3.0, 0.0), (0.5, 1.0), (0.75, 1.0)]]);
        let svg = alone(chart);
        assert!(
            ["one", "two", "work", "wait", "ms"].iter().all(|text| svg.contains(text)),
            "{svg}"
        );
    }

    #[test]
    fn text_can_be_read_on_a_page_and_on_a_phone() {
        // These are the widths that a page of the book and a phone have.
        for (form, shown) in [(Form::Page, 750.0), (Form::Phone, 350.0)] {
            let chart =
                Chart::new("A long title of some words", Axis::linear("x"), Axis::linear("y"))
                    .with(Series::new(Kind::Measured, "a", vec![(0.0, 1.0), (1.0, 2.0)]))
                    .shaded_beyond(Some(0.5), "more than cores");
            let direct = chart.clone().labelled_directly();
            let svg = svg(&[vec![chart.clone(), chart], vec![direct]], form);
            let sizes = svg.split("font-size=\"").skip(1).filter_map(|rest| rest.split('"').next());
            let least = sizes.map(|size| size.parse().unwrap()).fold(f64::INFINITY, f64::min);
            let least = least * f64::min(1.0, shown / f64::from(form.width()));
            assert!(least >= 12.0, "{form:?}: {least} px");
        }
    }

    #[test]
    fn what_cannot_be_drawn_is_left_out() {
        let points = vec![(0.0, 1.0), (1.0, f64::NAN), (2.0, -1.0), (3.0, 1.0)];
        let chart = Chart::new("", Axis::log("x"), Axis::log("y"));
        let svg = alone(chart.with(Series::new(Kind::Measured, "a", points)));
        assert!(svg.contains("circle") && !svg.contains("NaN") && !svg.contains("inf"));
        let empty = Chart::new("nothing", Axis::linear("x"), Axis::linear("y"));
        assert!(alone(empty).contains("nothing"));
    }
}
