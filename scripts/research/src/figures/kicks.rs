//! A step as drifts and kicks, by three methods.

use anyhow::Result;

use super::canvas::{BLUE, Canvas, GREY, INK, ORANGE, filled, outlined};

const WIDTH: f64 = 520.0;
const LEFT: f64 = 60.0;
const LONG: f64 = 400.0;
const PART: f64 = 24.0;

/// The three numbers of PEFRL (Omelyan, Mryglod and Folk, 2002).
const XI: f64 = 0.178_617_895_844_809_1;
const LAMBDA: f64 = -0.212_341_831_062_605_4;
const CHI: f64 = -0.066_264_582_669_818_5;

/// A part of a step, with its share of it.
#[derive(Clone, Copy)]
enum Part {
    Drift(f64),
    Kick(f64),
}

/// The order of a step by the official method, velocity Verlet and PEFRL.
pub(super) fn compositions() -> Result<String> {
    use Part::{Drift, Kick};
    let methods: [(&str, &[Part]); 3] = [
        ("euler: a kick, a drift", &[Kick(1.0), Drift(1.0)]),
        ("velocity Verlet: half a kick at either end", &[Kick(0.5), Drift(1.0), Kick(0.5)]),
        (
            "PEFRL: five drifts, four kicks",
            &[
                Drift(XI),
                Kick(0.5 - LAMBDA),
                Drift(CHI),
                Kick(LAMBDA),
                Drift(1.0 - 2.0 * (CHI + XI)),
                Kick(LAMBDA),
                Drift(CHI),
                Kick(0.5 - LAMBDA),
                Drift(XI),
            ],
        ),
    ];
    let title = "A step as drifts, in which places move, and kicks, in which velocities change: euler, velocity Verlet and PEFRL, which goes back in time in between";
    let mut canvas = Canvas::new(title, WIDTH, 404.0);
    let mut top = 26.0;
    for (name, parts) in methods {
        canvas.text((WIDTH / 2.0, top), 17.0, INK, name);
        top = method(&mut canvas, top + 32.0, parts) + 60.0;
    }
    canvas.text(
        (WIDTH / 2.0, top - 8.0),
        15.0,
        INK,
        "arrow: a drift; dot: a kick, with its share of the step",
    );
    Ok(canvas.svg())
}

/// From line to line as many drifts as there are; where the last line is.
fn method(canvas: &mut Canvas, top: f64, parts: &[Part]) -> f64 {
    let x = |time: f64| LEFT + time * LONG;
    let lines = parts.iter().filter(|part| matches!(part, Part::Drift(_))).count();
    let last = top + (lines - 1) as f64 * PART;
    for end in [0.0, 1.0] {
        canvas.line((x(end), top - 8.0), (x(end), last + 8.0), outlined(GREY, 1.0).dashed());
        canvas.text((x(end), last + 24.0), 13.0, INK, if end == 0.0 { "0" } else { "1" });
    }
    let (mut time, mut y, mut drifts) = (0.0, top, 0);
    for &part in parts {
        match part {
            Part::Drift(share) => {
                if drifts > 0 {
                    canvas.line((x(time), y), (x(time), y + PART), outlined(GREY, 1.0));
                    y += PART;
                }
                drifts += 1;
                canvas.arrow((x(time), y), (x(time + share), y), BLUE);
                time += share;
            }
            Part::Kick(share) => {
                canvas.circle((x(time), y), 6.0, filled(ORANGE));
                let side = if share < 0.0 { -34.0 } else { 28.0 };
                let side = if time > 0.5 { -side } else { side };
                // At either end there is room above.
                let is_end = time == 0.0 || time == 1.0;
                let (side, up) = if is_end { (0.0, 16.0) } else { (side, 0.0) };
                let says = format!("{share:.2}").replace('-', "−");
                let at = (x(time) + side, y + 5.0 - up);
                canvas.rectangle((at.0 - 18.0, at.1 - 13.0), 36.0, 16.0, filled("#ffffff"));
                canvas.text(at, 13.0, INK, &says);
            }
        }
    }
    last
}
