//! Which intervals vanish or meet, and lists without them.
use crate::contact::intervals::pressure::Pressure;
use crate::contact::intervals::support::{ContactInterval, End, Intervals, Parity};
use crate::contact::problem::accuracy::ROUNDING;

/// Intervals that both grow into a gap shorter than this part of the shorter one are one.
pub(super) const TOGETHER: f64 = 0.03;

impl Intervals {
    /// Which of them are openings with no gap.
    pub(super) fn closing(&self, pressures: &[Pressure]) -> Vec<bool> {
        let closes = |(own, pressure): (&ContactInterval, &Pressure)| own.opens && pressure.force(own) <= 0.0;
        self.0.iter().zip(pressures).map(closes).collect()
    }

    /// The list in the middle between this one and another of the same intervals.
    pub(super) fn halfway(&self, other: &Self) -> Self {
        let middle = |(one, other): (&ContactInterval, &ContactInterval)| {
            let ends = [0.5 * (one.from() + other.from()), 0.5 * (one.to() + other.to())];
            one.between(ends).with_corners(one.corners)
        };
        Self(self.0.iter().zip(&other.0).map(middle).collect())
    }
}

/// The list without an interval that vanishes, or with two as one that meet; `None` if it does not change.
pub(super) fn changed(support: &Intervals, pressures: &[Pressure]) -> Option<Intervals> {
    let all = &support.0;
    let closing = support.closing(pressures);
    if closing.contains(&true) {
        let open = all.iter().zip(closing).filter(|(_, closes)| !closes);
        return Some(Intervals(open.map(|(interval, _)| *interval).collect()));
    }
    let vanishes = |number: &usize| {
        let own = &all[*number];
        // each punch keeps an interval
        let alike = support.of(own.contact).iter().filter(|other| other.punch == own.punch);
        !own.opens && pressures[*number].force(own) < ROUNDING && alike.count() > 1
    };
    if let Some(number) = (0..all.len()).find(vanishes) {
        let mut all = all.clone();
        all.remove(number);
        return Some(Intervals(all));
    }
    let grows = |end: End| {
        let [left, right] = [0, 1].map(|place| pressures[end.interval].singular.get(place).copied());
        let sign = all[end.interval].sign(end.side);
        if end.side > 0.0 { right.or(left) } else { left }.is_some_and(|q| sign * q > 0.0)
    };
    let meets = |end: &End| {
        let own = &all[end.interval];
        if end.side > 0.0 {
            let Some(next) = all.get(end.interval + 1) else { return false };
            let is_short = next.from() - own.to() < TOGETHER * own.half.min(next.half);
            let is_next = (own.contact, own.punch) == (next.contact, next.punch);
            return is_next && is_short && grows(*end) && grows(End { interval: end.interval + 1, side: -1.0 });
        }
        // an interval meets its mirror image
        let is_innermost = own.parity == Parity::Pair && support.of(own.contact)[0] == *own;
        is_innermost && 2.0 * own.from() < TOGETHER * own.half && grows(*end)
    };
    let end = support.ends().into_iter().find(meets)?;
    let mut merged = all.clone();
    let own = &all[end.interval];
    merged[end.interval] = if end.side > 0.0 {
        let next = merged.remove(end.interval + 1);
        own.between([own.from(), next.to()]).with_corners([own.corners[0], next.corners[1]])
    } else {
        own.between([0.0, own.to()]).with_corners([own.corners[1]; 2])
    };
    Some(Intervals(merged))
}
