//! Heights of the layers in a drawing: to scale where that can be seen, otherwise thin layers higher and thick ones lower.
use super::scale::label;

/// Layers are drawn at least as high, in points, where there is room for that.
const LEAST: f64 = 9.0;
/// Parts of a layer's height that count as to scale.
const SAME: f64 = 1e-6;
/// Halvings of the range in which a number is looked for.
const HALVINGS: usize = 60;

/// Depths that layers have, and the heights at which they are drawn, in points downwards from the first.
#[derive(Clone, Debug)]
pub(super) struct DrawnDepths {
    pub(super) knots: Vec<(f64, f64)>,
    /// Points per length to scale.
    scale: f64,
}

impl DrawnDepths {
    /// For faces at these ascending depths, to scale if no layer is too thin and the height of all together is between these.
    pub(super) fn new(faces: Vec<f64>, scale: f64, [lowest, most]: [f64; 2]) -> Self {
        let thick: Vec<f64> = faces.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let least = LEAST.min(most / thick.len().max(1) as f64);
        let height = |scale: f64| thick.iter().map(|h| (scale * h).max(least)).sum::<f64>();
        let low = if height(scale) > most {
            last_below(most, height, [0.0, scale])
        } else {
            scale * (lowest / height(scale).max(f64::MIN_POSITIVE)).max(1.0)
        };
        let mut y = 0.0;
        let below = thick.iter().map(|h| {
            y += (low * h).max(least);
            y
        });
        Self { knots: faces.into_iter().zip([0.0].into_iter().chain(below)).collect(), scale }
    }

    /// Height of all layers together.
    pub(super) fn height(&self) -> f64 {
        self.knots.last().map_or(0.0, |(_, height)| *height)
    }

    /// A sentence on the scale of the heights; `None` if they are to scale.
    pub(super) fn note(&self) -> Option<String> {
        let pairs = self.knots.windows(2);
        let stretched = pairs.map(|pair| (pair[1].1 - pair[0].1) / (self.scale * (pair[1].0 - pair[0].0)));
        let (least, most) = stretched.fold((f64::INFINITY, 0.0_f64), |(least, most), r| (least.min(r), most.max(r)));
        let to_scale = (most - 1.0).abs() < SAME && (least - 1.0).abs() < SAME;
        let times = |ratio: f64| label(format!("{ratio:.1e}").parse().unwrap_or(ratio));
        if self.knots.len() < 2 || to_scale {
            None
        } else if most - least < SAME * most {
            Some(format!("depths drawn × {}", times(most)))
        } else {
            Some(format!("depths not to scale: layers drawn × {} to × {}", times(least), times(most)))
        }
    }
}

/// The number up to which an ascending function is no larger than `most`, between one where it is not and one where it is.
pub(super) fn last_below(most: f64, function: impl Fn(f64) -> f64, [mut below, mut above]: [f64; 2]) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (below + above);
        *(if function(middle) > most { &mut above } else { &mut below }) = middle;
    }
    below
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thin_layers_are_seen_and_thick_ones_fit() {
        let depths = DrawnDepths::new(vec![0.0, 0.001, 1.0, 101.0], 100.0, [0.0, 200.0]);
        assert!(depths.height() <= 200.001 && depths.knots[1].1 >= LEAST, "{depths:?}");
        assert!(depths.knots.is_sorted_by(|(_, a), (_, b)| a < b), "{depths:?}");
        assert!(depths.note().is_some_and(|note| note.contains("not to scale")));
        let to_scale = DrawnDepths::new(vec![0.0, 1.0, 1.5], 100.0, [0.0, 200.0]);
        assert_eq!((to_scale.note(), to_scale.knots), (None, vec![(0.0, 0.0), (1.0, 100.0), (1.5, 150.0)]));
        let many = DrawnDepths::new((0..=1000).map(f64::from).collect(), 1.0, [0.0, 190.0]);
        assert!((many.height() - 190.0).abs() < 1e-6);
        assert_eq!(many.note().unwrap(), "depths drawn × 0.19");
        assert_eq!(DrawnDepths::new(vec![0.0], 1.0, [0.0, 10.0]).height(), 0.0);
    }
}
