//! The class in bars: how many points, and which tasks.

use super::share;
use crate::escape::html;
use crate::record::Record;
use crate::report::Words;

/// Bars of the histogram.
const BARS: usize = 10;

/// How many submissions got which share of the points.
pub(crate) fn histogram(records: &[Record]) -> String {
    let mut counts = [0_usize; BARS];
    for record in records {
        counts[((share(record) * BARS as f64) as usize).min(BARS - 1)] += 1;
    }
    let most = counts.iter().copied().max().unwrap_or(0).max(1) as f64;
    let mut out = String::from(
        "<h2>Points</h2>\n<svg viewBox=\"0 0 320 120\" role=\"img\" \
         aria-label=\"How many submissions got which share of the points\">\n\
         <line x1=\"0\" x2=\"320\" y1=\"100\" y2=\"100\"/>\n",
    );
    for (bar, count) in counts.iter().enumerate() {
        let (x, height) = (bar * 32, 80.0 * *count as f64 / most);
        if *count > 0 {
            let y = 100.0 - height;
            out += &format!(
                "<rect x=\"{}\" y=\"{y:.1}\" width=\"26\" height=\"{height:.1}\"/>\n\
                 <text x=\"{}\" y=\"{:.1}\" text-anchor=\"middle\">{count}</text>\n",
                x + 3,
                x + 16,
                y - 4.0
            );
        }
        out += &format!("<text x=\"{x}\" y=\"115\">{}</text>\n", 100 / BARS * bar);
    }
    out + "<text x=\"320\" y=\"115\" text-anchor=\"end\">%</text>\n</svg>\n"
}

/// How many have each task.
pub(crate) fn tasks(records: &[Record], words: &Words) -> String {
    let Some(first) = records.first() else { return String::new() };
    let mut out = String::from("<h2>Tasks</h2>\n<ul class=\"bars\">\n");
    for task in first.tasks_in_order() {
        let has = |record: &&Record| record.tasks.iter().any(|own| own.id == task.id && own.passed);
        let (have, all) = (records.iter().filter(has).count(), records.len());
        out += &format!(
            "<li><span>{}</span><span class=\"bar\"><i style=\"width:{:.0}%\"></i></span>\
             <span class=\"count\">{have} of {all}</span></li>\n",
            html(&words.task(&task.id)),
            100.0 * have as f64 / all as f64
        );
    }
    out + "</ul>\n"
}
