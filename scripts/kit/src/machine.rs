//! Describes this machine and returns today's date, for records.

use std::fs;
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Returns the number of threads that this machine runs at once.
pub fn cores() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// Returns 1, 2, 4, … and `most`, as numbers of workers to compare.
pub fn doubled_up_to(most: usize) -> Vec<usize> {
    let doubled = std::iter::successors(Some(1), |p| Some(2 * p));
    doubled.take_while(|p| *p < most).chain([most]).collect()
}

/// Returns the name of the processor and the number of cores.
pub fn machine() -> String {
    let cpuinfo = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = cpuinfo.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    let model = model.map_or(std::env::consts::ARCH, |(_, name)| name.trim());
    format!("{model}, {} cores", cores())
}

/// Returns today's date in UTC, as 2026-11-21; empty if the system does not report it.
pub fn date() -> String {
    let printed = Command::new("date").args(["-u", "+%F"]).output().map(|output| output.stdout);
    String::from_utf8_lossy(&printed.unwrap_or_default()).trim().into()
}

/// Applies `work` to every item, on as many threads as there are cores. Results are in the order of
/// the items.
pub fn on_all_cores<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let done = Mutex::new(Vec::with_capacity(items.len()));
    let worker = || {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(index) else { return };
            let result = work(item);
            done.lock().expect("pushing does not panic").push((index, result));
        }
    };
    thread::scope(|scope| {
        for _ in 1..cores().min(items.len()) {
            // If the system refuses a thread, the others do its work.
            let _ = thread::Builder::new().spawn_scoped(scope, worker);
        }
        worker();
    });
    let mut done = done.into_inner().expect("pushing does not panic");
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_date_is_a_year_a_month_and_a_day() {
        let date = super::date();
        let parts: Vec<_> = date.split('-').map(|part| part.parse::<u32>().unwrap()).collect();
        assert!(parts.len() == 3 && date.len() == 10, "{date}");
        assert!(parts[0] > 2000 && parts[1] <= 12 && parts[2] <= 31, "{date}");
    }
}
