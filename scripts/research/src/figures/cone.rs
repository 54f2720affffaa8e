//! Ghosts that a rank moves itself: where they are right, step after step.

use anyhow::Result;

use super::canvas::{BLUE, Canvas, INK, ORANGE, PALE_BLUE, PALE_ORANGE, filled, outlined};

/// Steps without a message, and cutoffs of ghosts.
const STEPS: usize = 4;
const CUTOFF: f64 = 60.0;
const OWN: f64 = 110.0;
const LEFT: f64 = 70.0;
const TOP: f64 = 62.0;
const ROW: f64 = 44.0;
const BAR: f64 = 30.0;

/// The zone of right ghosts shrinks by a cutoff in each step.
pub(super) fn shrinks() -> Result<String> {
    let title = "Ghosts four cutoffs deep, chosen once. In each of four steps what is wrong at their outer edge comes nearer by a cutoff; after the fourth step all ghosts may be wrong, and the rank's own particles are still right";
    let border = LEFT + OWN;
    let edge = border + STEPS as f64 * CUTOFF;
    let bottom = TOP + (STEPS + 1) as f64 * ROW;
    let mut canvas = Canvas::new(title, edge + 20.0, bottom + 44.0);
    canvas.text((LEFT + OWN / 2.0, TOP - 30.0), 15.0, INK, "own particles");
    canvas.text((border + (edge - border) / 2.0, TOP - 30.0), 15.0, INK, "ghosts, m cutoffs deep");
    for step in 0..=STEPS {
        let y = TOP + step as f64 * ROW;
        let wrong = edge - step as f64 * CUTOFF;
        let name = if step == 0 { "chosen".into() } else { format!("step {step}") };
        canvas.text((LEFT / 2.0, y + 0.7 * BAR), 15.0, INK, &name);
        canvas.rectangle((LEFT, y), OWN, BAR, filled(BLUE).faint(0.55));
        canvas.rectangle((border, y), wrong - border, BAR, filled(PALE_BLUE));
        canvas.rectangle((wrong, y), edge - wrong, BAR, filled(PALE_ORANGE));
        if step > 0 {
            let next = y + BAR / 2.0;
            canvas.arrow((wrong + CUTOFF - 4.0, next), (wrong + 2.0, next), ORANGE);
        }
    }
    canvas.line((border, TOP - 18.0), (border, bottom - 4.0), outlined(INK, 2.5).dashed());
    canvas.text((border - OWN / 2.0, bottom + 18.0), 15.0, BLUE, "right in all steps");
    canvas.text((border + (edge - border) / 2.0, bottom + 18.0), 15.0, ORANGE, "a cutoff a step");
    Ok(canvas.svg())
}
