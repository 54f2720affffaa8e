//! Checks that the machine has enough memory for a list, before the list is filled.

use std::fs;

/// Returns an empty list with room for `count` values, or `None` if the machine has too little
/// memory.
///
/// Linux grants more memory than the machine has, and kills a program that uses too much. So this
/// function first reads the available memory, on systems that report it, and then tries the
/// allocation.
pub(crate) fn room_for<T>(count: usize) -> Option<Vec<T>> {
    let bytes = (count as u64).checked_mul(size_of::<T>() as u64)?;
    if available().is_some_and(|available| bytes > available) {
        return None;
    }
    let mut list = Vec::new();
    list.try_reserve_exact(count).ok()?;
    Some(list)
}

/// Returns the bytes of memory that a program may still use, on systems that report them.
fn available() -> Option<u64> {
    kibibytes(&fs::read_to_string("/proc/meminfo").ok()?)?.checked_mul(1024)
}

/// Returns the available memory in KiB, as given in /proc/meminfo.
fn kibibytes(meminfo: &str) -> Option<u64> {
    let line = meminfo.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    line.trim().strip_suffix("kB")?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::{kibibytes, room_for};

    #[test]
    fn there_is_room_for_what_fits() {
        assert!(
            room_for::<u64>(1000).is_some_and(|list| list.is_empty() && list.capacity() >= 1000)
        );
        assert!(room_for::<u64>(usize::MAX / 16).is_none(), "no machine has so much");
        assert!(room_for::<u64>(usize::MAX).is_none(), "nor for its bytes");
    }

    #[test]
    fn what_is_available_is_read() {
        let text =
            "MemTotal:       24659348 kB\nMemFree:         1 kB\nMemAvailable:   22437816 kB\n";
        assert_eq!(kibibytes(text), Some(22_437_816));
        assert_eq!(kibibytes("MemTotal: 1 kB\n"), None);
    }
}
