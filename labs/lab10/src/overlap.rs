//! Which of many discs overlap.

/// A disc around a particle.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// Its centre along x.
    pub x: f64,
    /// Its centre along y.
    pub y: f64,
    /// How far it reaches.
    pub radius: f64,
    /// The particle.
    pub who: u32,
}

/// The pairs of `discs` that overlap, the lower number first, and how many were looked at.
///
/// Along x a disc can only overlap those that begin before it ends.
pub fn overlapping(mut discs: Vec<Disc>) -> (Vec<[u32; 2]>, u64) {
    let left = |disc: &Disc| disc.x - disc.radius;
    discs.sort_unstable_by(|a, b| left(a).total_cmp(&left(b)).then(a.who.cmp(&b.who)));
    let (mut found, mut tested) = (Vec::new(), 0);
    for (k, a) in discs.iter().enumerate() {
        let right = a.x + a.radius;
        for b in discs[k + 1..].iter().take_while(|b| left(b) <= right) {
            tested += 1;
            let (dx, dy, far) = (b.x - a.x, b.y - a.y, a.radius + b.radius);
            if dx * dx + dy * dy <= far * far {
                found.push([a.who.min(b.who), a.who.max(b.who)]);
            }
        }
    }
    (found, tested)
}
