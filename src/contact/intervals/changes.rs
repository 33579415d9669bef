//! Which intervals vanish or meet, and lists without them.
use std::f64::consts::PI;

use crate::contact::intervals::pressure::Pressure;
use crate::contact::intervals::support::{ContactInterval, End, Intervals, Parity};
use crate::contact::problem::accuracy::ROUNDING;

/// Intervals that both grow into a gap shorter than this part of the shorter one are one.
pub(super) const TOGETHER: f64 = 0.03;
/// The same of openings, between which a layer may rest on a short support.
const SUPPORT: f64 = 0.003;

impl Intervals {
    /// Which of them are openings with no gap, with what is singular at their ends or without, or that have shrunk to a point.
    pub(super) fn closing(&self, pressures: &[Pressure]) -> Vec<bool> {
        let closes = |(own, pressure): (&ContactInterval, &Pressure)| {
            let gap = || pressure.force(own).max(pressure.regular(own).force(own));
            own.opens && (own.is_point() || gap() <= 0.0)
        };
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

impl ContactInterval {
    /// Whether an opening is so short, in units of L, that without it the tension there is next to nothing.
    fn is_point(&self) -> bool {
        self.half < 1e-6
    }

    /// Where there is a gap in an opening that has none on the whole.
    fn open_parts(&self, pressure: &Pressure) -> Vec<Self> {
        let places = pressure.places(self);
        // from the right end inwards, to the middle of what is even
        let gaps = pressure.regular(self).inside(self, places);
        let place = |k: usize| self.place(PI * k as f64 / places as f64);
        let opens = |k: usize| k > 0 && gaps.get(k - 1).is_some_and(|gap| *gap > 0.0);
        let part = |first: usize| {
            let last = (first..).take_while(|k| opens(*k)).last().unwrap_or(first);
            let from = if last == gaps.len() { self.from() } else { place(last + 1) };
            self.between([from, place(first - 1)])
        };
        (1..=gaps.len()).rev().filter(|k| opens(*k) && !opens(k - 1)).map(part).collect()
    }
}

/// The list without an interval that vanishes, or with two as one that meet; `None` if it does not change.
pub(super) fn changed(support: &Intervals, pressures: &[Pressure]) -> Option<Intervals> {
    let all = &support.0;
    let closing = support.closing(pressures);
    if closing.contains(&true) {
        let open = |((own, pressure), closes): ((&ContactInterval, &Pressure), bool)| match closes {
            true if own.is_point() => Vec::new(),
            true => own.open_parts(pressure),
            false => vec![*own],
        };
        return Some(Intervals(all.iter().zip(pressures).zip(closing).flat_map(open).collect()));
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
    let together = |own: &ContactInterval| if own.opens { SUPPORT } else { TOGETHER };
    let meets = |end: &End| {
        let own = &all[end.interval];
        if end.side > 0.0 {
            let Some(next) = all.get(end.interval + 1) else { return false };
            let is_short = next.from() - own.to() < together(own) * own.half.min(next.half);
            let is_next = (own.contact, own.punch) == (next.contact, next.punch);
            return is_next && is_short && grows(*end) && grows(End { interval: end.interval + 1, side: -1.0 });
        }
        // an interval meets its mirror image
        let is_innermost = own.parity == Parity::Pair && support.of(own.contact)[0] == *own;
        is_innermost && 2.0 * own.from() < together(own) * own.half && grows(*end)
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
