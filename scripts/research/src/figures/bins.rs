//! Which bins a particle must look at.

use anyhow::Result;

use super::canvas::{
    BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, Point, filled, outlined,
};

const CELL: f64 = 64.0;
const TOP: f64 = 40.0;

/// One-way forces look at nine bins, two-way forces at five.
pub(super) fn stencils() -> Result<String> {
    let title =
        "The bins to look at: nine if each particle serves itself, five if a pair serves both";
    let mut canvas = Canvas::new(title, 2.0 * 5.0 * CELL + 90.0, 5.0 * CELL + TOP + 44.0);
    let half = |column: i32, row: i32| row > 0 || (row == 0 && column >= 0);
    panel(&mut canvas, 20.0, "one-way: nine bins", |_, _| true);
    panel(&mut canvas, 5.0 * CELL + 70.0, "two-way: five of the nine", half);
    Ok(canvas.svg())
}

fn panel(canvas: &mut Canvas, left: f64, name: &str, look: impl Fn(i32, i32) -> bool) {
    let corner = |column: i32, row: i32| -> Point {
        (left + f64::from(column + 2) * CELL, TOP + f64::from(2 - row) * CELL)
    };
    for row in -2..=2 {
        for column in -2..=2_i32 {
            let near = column.abs() <= 1 && i32::abs(row) <= 1;
            let fill = match (column, row) {
                (0, 0) => PALE_ORANGE,
                _ if near && look(column, row) => PALE_BLUE,
                _ => "#ffffff",
            };
            canvas.rectangle(corner(column, row), CELL, CELL, outlined(GREY, 1.0).on(fill));
        }
    }
    let middle = (left + 2.66 * CELL, TOP + 2.36 * CELL);
    canvas.circle(middle, CELL, outlined(ORANGE, 1.5).dashed());
    canvas.circle(middle, 4.0, filled(ORANGE));
    canvas.text((left + 2.5 * CELL, TOP - 14.0), 18.0, INK, name);
    canvas.text(
        (left + 2.5 * CELL, TOP + 5.0 * CELL + 26.0),
        15.0,
        INK,
        "dashed: the cutoff of one particle",
    );
}

/// Bins of one and of two cutoffs: the area that is searched beside the area that is needed.
pub(super) fn widths() -> Result<String> {
    const CUTOFF: f64 = 46.0;
    let title =
        "Wider bins mean a larger area to search: 9 and 36 squared cutoffs, for a circle of 3.1";
    let mut canvas = Canvas::new(title, 9.0 * CUTOFF + 120.0, 6.0 * CUTOFF + TOP + 44.0);
    for (left, width, name) in [(30.0, 1.0, "bins of c"), (3.0 * CUTOFF + 90.0, 2.0, "bins of 2 c")]
    {
        let side = width * CUTOFF;
        let top = TOP + (3.0 - 1.5 * width) * CUTOFF;
        for k in 0..9 {
            let corner = (left + f64::from(k % 3) * side, top + f64::from(k / 3) * side);
            canvas.rectangle(corner, side, side, outlined(BLUE, 1.0).on(PALE_BLUE));
        }
        let middle = (left + 1.4 * side, top + 1.6 * side);
        canvas.circle(middle, CUTOFF, outlined(ORANGE, 2.0).on(PALE_ORANGE));
        canvas.circle(middle, 4.0, filled(ORANGE));
        let searched = format!("{} c² searched", 9.0 * width * width);
        canvas.text((left + 1.5 * side, top - 14.0), 18.0, INK, name);
        canvas.text((left + 1.5 * side, top + 3.0 * side + 26.0), 15.0, INK, &searched);
    }
    Ok(canvas.svg())
}
