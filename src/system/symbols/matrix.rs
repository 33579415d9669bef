//! The symbolic block matrix: rows are named conditions, columns are layers, a block is a signed face quantity.
use std::ops::{Deref, RangeInclusive};

use recede_layers::{Body, Plane};

use super::conditions::{self, Relation, Term};
use super::names::{Face, InterfaceSide, Place, Quantity, RightHandSide};
use crate::stack::{Joint, Stack};

/// A layer or a support with its amplitudes.
#[derive(Clone, Debug)]
pub struct Column {
    number: usize,
    body: Body,
    amplitudes: RangeInclusive<usize>,
}

impl Column {
    /// The number of the layer or support, as in the scene.
    pub fn number(&self) -> usize {
        self.number
    }

    /// The layer, or the support at the bottom.
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// The layer's amplitudes among all, numbered from 1 as in C1, C2, ...
    pub fn amplitudes(&self) -> RangeInclusive<usize> {
        self.amplitudes.clone()
    }
}

/// A face quantity of one layer, as a linear function of the layer's amplitudes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Block {
    /// Index of the column, from 0.
    pub column: usize,
    /// Number of the layer as in the scene.
    pub layer: usize,
    /// Face of the layer.
    pub face: Face,
    /// Quantity at the face.
    pub quantity: Quantity,
    /// Whether the quantity has a minus sign.
    pub negative: bool,
    /// The stiffness of springs by which a displacement is multiplied, in stress per length.
    pub stiffness: Option<f64>,
}

impl Block {
    /// On which side of its interface the layer lies.
    pub fn side(&self) -> InterfaceSide {
        match self.face {
            Face::Top => InterfaceSide::Below,
            Face::Bottom => InterfaceSide::Above,
        }
    }
}

/// The blocks of a row from left to right: at most four, and one or two for most conditions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Blocks {
    // in place, since a stack of many layers has many rows
    list: [Block; 4],
    count: usize,
}

impl Deref for Blocks {
    type Target = [Block];

    fn deref(&self) -> &[Block] {
        &self.list[..self.count]
    }
}

/// One scalar condition.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Where the condition holds.
    pub place: Place,
    /// The blocks from left to right; all others are zero.
    pub blocks: Blocks,
    /// The right-hand side; `None` is zero.
    pub right: Option<RightHandSide>,
}

/// The block matrix of a stack. Prints as a table, rows named by condition, columns by layer.
///
/// ```
/// use recede::{BlockSystem, HalfPlane, Homogeneous, Plane, Stack};
/// let stack = Stack::builder(Plane::Strain)
///     .layer(Homogeneous::new(1.0, 1.0, 0.25)?)
///     .receding()
///     .layer(HalfPlane::new(1.0, 0.25)?)
///     .build()?;
/// let system = BlockSystem::new(&stack);
/// assert_eq!((system.rows().len(), system.unknowns()), (6, 6));
/// assert_eq!(system.rows()[2].to_string(), "1|2 S above: +S(bottom of 1) = -p1");
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct BlockSystem {
    plane: Plane,
    columns: Vec<Column>,
    rows: Vec<Row>,
}

impl BlockSystem {
    /// The block system of a stack, from the top down.
    pub fn new(stack: &Stack) -> Self {
        Self::assembled(stack, conditions::contact, conditions::joint)
    }

    /// The same with a gap in place of a pressure at each receding interface that weights press together.
    ///
    /// ```
    /// use recede::{BlockSystem, Scene};
    /// let scene = Scene::from_ron("Scene(geometry: PlaneStrain, load: Line, force: 1.0, stack: [
    ///     Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25, specific_weight: 1.0), Receding,
    ///     HalfPlane(shear_modulus: 1.0, poisson: 0.25)])")?;
    /// let system = BlockSystem::pressed(&scene.stack()?);
    /// assert_eq!(system.rows()[3].to_string(), "1|2 V continuous but for a gap: +V(bottom of 1) -V(top of 2) = g1");
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn pressed(stack: &Stack) -> Self {
        let loose = stack.loose();
        let contact = |i: usize| if i > loose { conditions::pressed(i) } else { conditions::contact(i) };
        Self::assembled(stack, contact, conditions::joint)
    }

    /// The block system with given relations at each contact and joint, whose number is not checked.
    pub(super) fn assembled(
        stack: &Stack,
        contacts: impl Fn(usize) -> [Relation; 4],
        joint: impl Fn(&Joint) -> [Relation; 4],
    ) -> Self {
        let mut system = Self { plane: stack.plane(), columns: Vec::new(), rows: Vec::new() };
        let mut last: Option<usize> = None;
        for (contact, (interface, group)) in stack.contacts().into_iter().zip(stack.groups()).enumerate() {
            for (i, (number, body)) in group.bodies().enumerate() {
                let (place, relations) = match (i.checked_sub(1), last) {
                    (Some(i), Some(above)) => {
                        let above = system.columns[above].number;
                        let relations = joint(group.joints().get(i).unwrap_or(&Joint::BONDED));
                        (Place::Between { above, below: number }, relations)
                    }
                    _ => (interface, contacts(contact)),
                };
                // a rigid base has no column
                let below = body.map(|body| system.column(number, body));
                system.interface(place, [last, below], relations);
                last = below;
            }
        }
        system
    }

    /// Plane strain or plane stress.
    pub fn plane(&self) -> Plane {
        self.plane
    }

    /// The layers from the top down; zero-thickness layers and a rigid base have no column.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The conditions from the top down.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Number of amplitudes, equal to the number of rows.
    pub fn unknowns(&self) -> usize {
        self.columns.last().map_or(0, |last| *last.amplitudes().end())
    }

    /// A column for a layer or a support: its index.
    fn column(&mut self, number: usize, body: Body) -> usize {
        let before = self.unknowns();
        let count = if body.layer().is_some_and(|layer| layer.thickness().is_some()) { 4 } else { 2 };
        self.columns.push(Column { number, body, amplitudes: before + 1..=before + count });
        self.columns.len() - 1
    }

    /// The rows of an interface between two columns. A body without a column is rigid: its displacements are zero, and its
    /// stresses are not unknowns.
    fn interface(&mut self, place: Place, columns: [Option<usize>; 2], relations: [Relation; 4]) {
        let [above, below] = columns;
        for Relation { terms, right } in relations {
            let there = |term: &Term| match term.side {
                InterfaceSide::Above => above.map(|column| (column, Face::Bottom)),
                InterfaceSide::Below => below.map(|column| (column, Face::Top)),
            };
            if terms.iter().flatten().any(|term| term.quantity.is_stress() && there(term).is_none()) {
                continue;
            }
            let mut blocks = Blocks::default();
            for term in terms.iter().flatten() {
                let Some((column, face)) = there(term) else { continue };
                let Term { quantity, negative, stiffness, .. } = *term;
                let layer = self.columns[column].number;
                blocks.list[blocks.count] = Block { column, layer, face, quantity, negative, stiffness };
                blocks.count += 1;
            }
            // conditions on a rigid body alone are satisfied
            if !blocks.is_empty() {
                self.rows.push(Row { place, blocks, right });
            }
        }
    }
}
