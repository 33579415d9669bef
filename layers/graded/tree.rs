//! A layer halved again and again: what has been computed of its parts serves every wavenumber.
use std::sync::{Arc, OnceLock};

use super::BodyProfile;
use super::points::Points;
use super::series::{LENGTH, Series};
use super::surface::Coefficients;
use crate::Material;

/// Around a jump of the material parts are halved down to this part of the thickness, or of the wavelength.
const THINNEST: f64 = 1e-14;
/// A material that is still not resolved by so many parts is taken as it is.
const MANY: usize = 10_000;
/// Thickness of the first part of a half-plane; each of the next ones is twice as thick as the one above.
const FIRST: f64 = 1.0;

/// The parts of one layer, as they come to be needed. What a part holds depends on the layer alone, so that the order of
/// questions, and who else asks, makes no difference.
#[derive(Debug, Default)]
pub(crate) struct Tree {
    modulus: OnceLock<f64>,
    /// The material of the layer, if it is the same at all depths.
    material: OnceLock<Option<Material>>,
    roots: OnceLock<Vec<Node>>,
    below: OnceLock<Box<Below>>,
    /// Of the material at the top of the layer, for all parts that are of the same.
    series: OnceLock<Arc<Series>>,
}

/// A part of a half-plane, and the next one below it.
#[derive(Debug)]
struct Below {
    node: Node,
    next: OnceLock<Box<Below>>,
}

/// Which face of the layer one starts from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum From {
    Top,
    Bottom,
}

impl Tree {
    /// The modulus in units of which the parts are computed: c66 at the top face.
    pub fn modulus(&self, profile: &BodyProfile) -> f64 {
        *self.modulus.get_or_init(|| (profile.material)(0.0).shear_compliance.recip())
    }

    /// The material of a layer of finite thickness, if it is homogeneous.
    pub fn material(&self, profile: &BodyProfile) -> Option<&Material> {
        let find = || {
            profile.thickness?;
            let (material, modulus) = ((profile.material)(0.0), self.modulus(profile));
            let top = Coefficients::new(&material, modulus);
            let mut is_same = true;
            self.parts(profile, 0.0, From::Top, |part| {
                is_same = part.points(profile, modulus).are_all(&top);
                is_same
            });
            is_same.then_some(material)
        };
        self.material.get_or_init(find).as_ref()
    }

    /// The material of the first part, if it has been asked for.
    fn first_points(&self) -> Option<&Points> {
        let root = self.roots.get().and_then(|roots| roots.first());
        root.or(self.below.get().map(|below| &below.node))?.points.get()
    }

    /// Parts short enough for the material and for the wave, one after the other, until `visit` has seen enough.
    pub(super) fn parts<'t>(
        &'t self,
        profile: &BodyProfile,
        wavenumber: f64,
        from: From,
        mut visit: impl FnMut(&'t Node) -> bool,
    ) {
        let modulus = self.modulus(profile);
        let mut count = 0;
        let mut pending = Vec::new();
        let mut walk = |root: &'t Node| {
            pending.push(root);
            while let Some(node) = pending.pop() {
                if count < MANY && node.must_be_halved(profile, modulus, wavenumber) {
                    let [upper, lower] = node.halves();
                    let (first, second) = if from == From::Top { (upper, lower) } else { (lower, upper) };
                    pending.extend([second, first]);
                } else {
                    count += 1;
                    if !visit(node) {
                        return false;
                    }
                }
            }
            true
        };
        let roots = self.roots.get_or_init(|| roots(profile));
        let finished = match from {
            From::Top => roots.iter().all(&mut walk),
            From::Bottom => roots.iter().rev().all(&mut walk),
        };
        if profile.thickness.is_none() && finished {
            let first = roots.last().map_or(0.0, |node| node.to);
            let mut below = self.below.get_or_init(|| Below::new(first, FIRST));
            while walk(&below.node) {
                let (from, thickness) = (below.node.to, 2.0 * below.node.thickness);
                below = below.next.get_or_init(|| Below::new(from, thickness));
            }
        }
    }
}

/// What lies between the kinks, in a layer also between them and mid-depth, from which thin layers are described. Of a
/// half-plane only what lies above the last kink.
fn roots(profile: &BodyProfile) -> Vec<Node> {
    let end = profile.thickness.unwrap_or(f64::INFINITY);
    let mut cuts: Vec<f64> = profile.kinks.iter().copied().filter(|depth| *depth > 0.0 && *depth < end).collect();
    cuts.extend(profile.thickness.map(|thickness| 0.5 * thickness));
    cuts.extend(profile.thickness);
    cuts.sort_by(f64::total_cmp);
    let mut from = 0.0;
    let mut nodes = Vec::with_capacity(cuts.len());
    for to in cuts.into_iter().filter(|depth| *depth > 0.0) {
        // cuts in the same place leave nothing between them
        if to > from {
            nodes.push(Node::new(from, to, to - from));
            from = to;
        }
    }
    nodes
}

impl Below {
    fn new(from: f64, thickness: f64) -> Box<Self> {
        Box::new(Self { node: Node::new(from, from + thickness, thickness), next: OnceLock::new() })
    }
}

/// One part of a layer.
#[derive(Debug)]
pub(super) struct Node {
    pub from: f64,
    pub to: f64,
    pub thickness: f64,
    points: OnceLock<Points>,
    series: OnceLock<Arc<Series>>,
    halves: OnceLock<Box<[Node; 2]>>,
}

impl Node {
    fn new(from: f64, to: f64, thickness: f64) -> Self {
        Self { from, to, thickness, points: OnceLock::new(), series: OnceLock::new(), halves: OnceLock::new() }
    }

    fn halves(&self) -> &[Node; 2] {
        self.halves.get_or_init(|| {
            let half = 0.5 * self.thickness;
            let middle = self.from + half;
            Box::new([Self::new(self.from, middle, half), Self::new(middle, self.to, half)])
        })
    }

    /// The material at the Gauss points.
    pub fn points(&self, profile: &BodyProfile, modulus: f64) -> &Points {
        self.points.get_or_init(|| Points::new(profile, modulus, self.from, self.thickness))
    }

    /// The transfer matrix for any wavenumber.
    pub fn series(&self, points: &Points, tree: &Tree) -> &Series {
        self.series.get_or_init(|| match tree.first_points() {
            // a homogeneous layer has one series
            Some(first) if first == points => Arc::clone(tree.series.get_or_init(|| Arc::new(Series::new(points)))),
            _ => Arc::new(Series::new(points)),
        })
    }

    /// Depth at a Gauss point t, which is counted from the bottom up.
    pub fn depth(&self, t: f64) -> f64 {
        self.from + (1.0 - t) * self.thickness
    }

    fn must_be_halved(&self, profile: &BodyProfile, modulus: f64, wavenumber: f64) -> bool {
        let zeta = wavenumber * self.thickness;
        if zeta > LENGTH {
            return true;
        }
        let thinnest = THINNEST * wavenumber.recip().min(profile.thickness.unwrap_or(f64::INFINITY));
        let points = self.points(profile, modulus);
        zeta * points.fastest > LENGTH || !points.resolved && self.thickness > thinnest
    }
}
