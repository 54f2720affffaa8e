//! Who looks at which pairs of blocks, in lab 8.

use anyhow::Result;

use super::canvas::{BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, filled, outlined};

const CELL: f64 = 38.0;
const GAP: f64 = 56.0;
const TOP: f64 = 64.0;

/// The blocks of worker 0 in all three panels; lab 8's grader knows them too.
const OFFSETS: [usize; 3] = [0, 1, 3];

/// The matrix of blocks for five, six and seven workers, worker 0's jobs in colour.
pub(super) fn jobs() -> Result<String> {
    let panels = [5, 6, 7];
    let cells: usize = panels.iter().sum();
    let width = cells as f64 * CELL + (panels.len() + 1) as f64 * GAP;
    let title =
        "The matrix of blocks for 5, 6 and 7 workers: each diagonal is dealt to all of them";
    let mut canvas = Canvas::new(title, width, TOP + 7.0 * CELL + 20.0);
    let mut left = GAP;
    for workers in panels {
        panel(&mut canvas, left, workers);
        left += workers as f64 * CELL + GAP;
    }
    Ok(canvas.svg())
}

fn panel(canvas: &mut Canvas, left: f64, workers: usize) {
    let middle = |index: usize| (index as f64 + 0.5) * CELL;
    let end = workers as f64 * CELL;
    canvas.text((left + end / 2.0, 20.0), 17.0, INK, &format!("{workers} workers"));
    for block in 0..workers {
        let colour = if OFFSETS.contains(&block) { ORANGE } else { GREY };
        canvas.text((left + middle(block), TOP - 8.0), 14.0, colour, &block.to_string());
        let below = TOP + middle(block) + 5.0;
        canvas.text((left - 12.0, below), 14.0, colour, &block.to_string());
    }
    for row in 0..workers {
        for column in row..workers {
            let corner = (left + column as f64 * CELL, TOP + row as f64 * CELL);
            let (first, second) = lookers(workers, row, column);
            let fill = |worker: usize| match (worker, row == column) {
                (0, _) => PALE_ORANGE,
                (_, true) => PALE_BLUE,
                _ => "#ffffff",
            };
            let ink = |worker: usize| if worker == 0 { ORANGE } else { BLUE };
            let (x, y) = (corner.0 + CELL / 2.0, corner.1 + CELL / 2.0);
            match second {
                None => {
                    canvas.rectangle(corner, CELL, CELL, filled(fill(first)));
                    canvas.text((x, y + 6.0), 17.0, ink(first), &first.to_string());
                }
                Some(second) => {
                    let lower = (corner.0, y);
                    canvas.rectangle(corner, CELL, CELL / 2.0, filled(fill(first)));
                    canvas.rectangle(lower, CELL, CELL / 2.0, filled(fill(second)));
                    canvas.line(lower, (corner.0 + CELL, y), outlined(GREY, 1.0).dashed());
                    canvas.text((x, y - 4.5), 13.0, ink(first), &first.to_string());
                    canvas.text((x, y + 14.5), 13.0, ink(second), &second.to_string());
                }
            }
            canvas.rectangle(corner, CELL, CELL, outlined(INK, 1.0));
        }
    }
}

/// The worker of a pair of blocks; of opposite blocks, with an even number of workers, the two who
/// share them.
fn lookers(workers: usize, row: usize, column: usize) -> (usize, Option<usize>) {
    let worker = |from: usize, to: usize| {
        let there = |p: &&usize| OFFSETS.contains(&((**p + workers + to - from) % workers));
        OFFSETS.iter().find(there).map(|p| (from + workers - p) % workers)
    };
    let far = (column - row) * 2;
    let (near, beyond) = (worker(row, column), worker(column, row));
    match (far == workers, near, beyond) {
        (true, Some(near), beyond) => (near, beyond),
        (false, Some(near), _) if far < workers => (near, None),
        (_, near, beyond) => (beyond.or(near).unwrap_or_default(), None),
    }
}

#[cfg(test)]
mod tests {
    use super::lookers;

    #[test]
    fn the_reports_job_matrix_is_the_one_for_five() {
        let published =
            [[0, 0, 4, 2, 4], [0, 1, 1, 0, 3], [0, 0, 2, 2, 1], [0, 0, 0, 3, 3], [0, 0, 0, 0, 4]];
        for (row, line) in published.iter().enumerate() {
            for (column, worker) in line.iter().enumerate().skip(row) {
                assert_eq!(lookers(5, row, column), (*worker, None), "({row}, {column})");
            }
        }
    }

    #[test]
    fn opposite_blocks_are_shared() {
        assert_eq!(lookers(6, 0, 3), (0, Some(3)));
        assert_eq!(lookers(6, 1, 4), (1, Some(4)));
    }
}
