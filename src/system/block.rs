//! The symbolic block matrix: rows are named conditions, columns are layers, a block is a signed face quantity.
use crate::solution::Interface;
use crate::stack::{Foundation, Joint, Laminate, Placed, Stack};

/// Amplitude of a transformed field; see [`recede_layers`] for the conventions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// Of the displacement u along the layers.
    U,
    /// Of the displacement v upwards.
    V,
    /// Of the stress σ_yy, tension positive.
    S,
    /// Of the stress σ_xy.
    T,
}

/// Face of a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Face {
    /// The upper face.
    Top,
    /// The lower face.
    Bottom,
}

/// Side of an interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// The layer above the interface.
    Above,
    /// The layer below the interface.
    Below,
}

/// Where a condition holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// On the top face of the stack, below the punch.
    Punch,
    /// Between neighbours, numbered as in the scene; the base counts.
    Between {
        /// Number of the layer above.
        above: usize,
        /// Number of the layer or base below.
        below: usize,
    },
}

/// What is asked at an interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Condition {
    /// The quantity is the same on both sides.
    Continuous(Quantity),
    /// The quantity vanishes on one side.
    Zero(Quantity, Side),
    /// S is minus the contact pressure on one side.
    Pressed(Side),
    /// The stress that belongs to the displacement is its jump times the stiffness of springs.
    Sprung(Quantity),
}

/// A layer with its amplitudes.
#[derive(Clone, Debug)]
pub struct Column {
    layer: Placed,
    first: usize,
    count: usize,
}

impl Column {
    /// The layer and its number.
    pub fn layer(&self) -> &Placed {
        &self.layer
    }

    /// The layer's amplitudes among all, numbered from 1 as in C1, C2, ...
    pub fn amplitudes(&self) -> std::ops::RangeInclusive<usize> {
        self.first..=self.first + self.count - 1
    }
}

/// A face quantity of one layer, as a linear function of the layer's amplitudes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Index of the column, from 0.
    pub column: usize,
    /// Number of the layer as in the scene.
    pub layer: usize,
    /// Face of the layer.
    pub face: Face,
    /// Quantity at the face.
    pub quantity: Quantity,
    /// Whether it enters with a minus sign.
    pub negative: bool,
    /// The stiffness of springs by which a displacement is multiplied, in stress per length.
    pub stiffness: Option<f64>,
}

/// Right-hand side of a row that is loaded: minus the transformed pressure of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pressure {
    /// Index of the contact, from 0 for the punch; see [`Stack::contacts`].
    pub contact: usize,
}

/// One scalar condition.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Where the condition holds.
    pub place: Place,
    /// What is asked.
    pub condition: Condition,
    /// The blocks from left to right, one or two, at springs up to three; everywhere else there is nothing.
    pub blocks: Vec<Block>,
    /// The right-hand side; `None` is zero.
    pub pressure: Option<Pressure>,
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
    columns: Vec<Column>,
    rows: Vec<Row>,
}

impl BlockSystem {
    /// The block system of a stack, from the top down.
    pub fn new(stack: &Stack) -> Self {
        let mut system = Self { columns: Vec::new(), rows: Vec::new() };
        for (contact, interface) in stack.contacts().into_iter().enumerate() {
            system.contact(contact, interface, stack);
        }
        if let (Foundation::Rigid { number }, Some(last)) = (stack.base().foundation(), stack.base().layers().last()) {
            let place = Place::Between { above: last.number, below: *number };
            let column = system.columns.len() - 1;
            let joint = stack.base().joints().last().copied().unwrap_or(Joint::BONDED);
            for (quantity, stress, stiffness) in pairs(&joint) {
                let block = |quantity| system.block(column, Face::Bottom, quantity);
                let (condition, blocks) = if stiffness == 0.0 {
                    (Condition::Zero(stress, Side::Above), vec![block(stress)])
                } else if stiffness.is_finite() {
                    let jump = Block { stiffness: Some(stiffness), ..block(quantity) };
                    (Condition::Sprung(quantity), vec![jump, Block { negative: true, ..block(stress) }])
                } else {
                    (Condition::Zero(quantity, Side::Above), vec![block(quantity)])
                };
                system.row(place, condition, blocks, None);
            }
        }
        system
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

    /// The conditions of a contact, and the group of bonded layers below it.
    fn contact(&mut self, contact: usize, interface: Interface, stack: &Stack) {
        let place = match interface {
            Interface::Punch => Place::Punch,
            Interface::Between { above, below } => Place::Between { above, below },
        };
        if let Some(above) = self.columns.len().checked_sub(1) {
            self.free_face(contact, place, Side::Above, above, Face::Bottom);
        }
        let below = self.columns.len();
        let joints = stack.laminates().get(contact).map_or(stack.base().joints(), Laminate::joints);
        let layers: Vec<&Placed> = match (stack.laminates().get(contact), stack.base().foundation()) {
            (Some(laminate), _) => laminate.layers().iter().collect(),
            (None, Foundation::HalfPlane(ground)) => stack.base().layers().iter().chain([ground]).collect(),
            (None, Foundation::Rigid { .. }) => stack.base().layers().iter().collect(),
        };
        for (i, layer) in layers.iter().enumerate() {
            let first = self.unknowns() + 1;
            let count = if layer.layer.thickness().is_some() { 4 } else { 2 };
            self.columns.push(Column { layer: (*layer).clone(), first, count });
            match i.checked_sub(1) {
                None => self.free_face(contact, place, Side::Below, below, Face::Top),
                Some(above) => {
                    let place = Place::Between { above: layers[above].number, below: layer.number };
                    self.joined(place, below + i, &joints[above]);
                }
            }
        }
    }

    /// A face without shear, under the pressure of a contact.
    fn free_face(&mut self, contact: usize, place: Place, side: Side, column: usize, face: Face) {
        let pressed = vec![self.block(column, face, Quantity::S)];
        self.row(place, Condition::Pressed(side), pressed, Some(Pressure { contact }));
        let sheared = vec![self.block(column, face, Quantity::T)];
        self.row(place, Condition::Zero(Quantity::T, side), sheared, None);
    }

    /// The conditions between a column and the one to its left: displacements first, then stresses.
    fn joined(&mut self, place: Place, column: usize, joint: &Joint) {
        for (quantity, stress, stiffness) in pairs(joint) {
            let above = |quantity| self.block(column - 1, Face::Bottom, quantity);
            let below = |quantity| Block { negative: true, ..self.block(column, Face::Top, quantity) };
            if stiffness == 0.0 {
                let blocks = vec![above(stress)];
                self.row(place, Condition::Zero(stress, Side::Above), blocks, None);
            } else if stiffness.is_finite() {
                let jump =
                    [above(quantity), below(quantity)].map(|block| Block { stiffness: Some(stiffness), ..block });
                let blocks = vec![jump[0], Block { negative: true, ..above(stress) }, jump[1]];
                self.row(place, Condition::Sprung(quantity), blocks, None);
            } else {
                let blocks = vec![above(quantity), below(quantity)];
                self.row(place, Condition::Continuous(quantity), blocks, None);
            }
        }
        for (stress, stiffness) in [(Quantity::S, joint.normal), (Quantity::T, joint.tangential)] {
            let below = Block { negative: stiffness != 0.0, ..self.block(column, Face::Top, stress) };
            if stiffness == 0.0 {
                self.row(place, Condition::Zero(stress, Side::Below), vec![below], None);
            } else {
                let blocks = vec![self.block(column - 1, Face::Bottom, stress), below];
                self.row(place, Condition::Continuous(stress), blocks, None);
            }
        }
    }

    fn row(&mut self, place: Place, condition: Condition, blocks: Vec<Block>, pressure: Option<Pressure>) {
        self.rows.push(Row { place, condition, blocks, pressure });
    }

    fn block(&self, column: usize, face: Face, quantity: Quantity) -> Block {
        Block { column, layer: self.columns[column].layer.number, face, quantity, negative: false, stiffness: None }
    }
}

/// Displacement, the stress that belongs to it, and the stiffness that relates them.
fn pairs(joint: &Joint) -> [(Quantity, Quantity, f64); 2] {
    [(Quantity::U, Quantity::T, joint.tangential), (Quantity::V, Quantity::S, joint.normal)]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use recede_layers::{Exponential, HalfPlane, Homogeneous, Plane};

    use super::*;
    use crate::scene::{Item, Spring};
    use crate::stack::StackProblem;

    /// The stack of the paper: a strip bonded to a graded layer, both lying loose on a half-plane.
    fn paper(h1: f64, h2: f64) -> BlockSystem {
        let stack = Stack::builder(Plane::Strain)
            .layer(Homogeneous::new(h1, 1.0, 0.25).unwrap())
            .bonded()
            .layer(Exponential::new(h2, 1.0, 0.25, -1.0).unwrap())
            .receding()
            .layer(HalfPlane::new(1.0, 0.25).unwrap())
            .build()
            .unwrap();
        BlockSystem::new(&stack)
    }

    #[test]
    fn the_stack_of_the_paper_has_ten_conditions_for_ten_unknowns() {
        let system = paper(1.0, 1.0);
        assert_eq!((system.rows().len(), system.unknowns()), (10, 10));
        let amplitudes: Vec<_> = system.columns().iter().map(Column::amplitudes).collect();
        assert_eq!(amplitudes, [1..=4, 5..=8, 9..=10]);
    }

    #[test]
    fn without_one_of_its_layers_it_has_six() {
        for system in [paper(0.0, 1.0), paper(1.0, 0.0)] {
            assert_eq!((system.rows().len(), system.unknowns()), (6, 6));
        }
        assert_eq!(paper(0.0, 0.0).rows().len(), 2);
    }

    fn item() -> impl Strategy<Value = Item> {
        let thickness = prop_oneof![Just(0.0), Just(1.0), Just(2.5)];
        thickness.prop_map(|h| Item::layer(Homogeneous::new(h, 1.0, 0.25).unwrap()))
    }

    fn interface() -> impl Strategy<Value = Item> {
        let spring = |tangential| Item::Spring(Spring::new(2.0, tangential).unwrap());
        prop_oneof![
            Just(Item::Bonded),
            Just(Item::Sliding),
            Just(Item::Receding),
            Just(spring(None)),
            Just(spring(Some(0.5)))
        ]
    }

    proptest! {
        #[test]
        fn every_legal_stack_has_as_many_conditions_as_unknowns(
            above in prop::collection::vec((item(), interface()), 0..8),
            rigid in any::<bool>(),
        ) {
            let mut stack = Stack::builder(Plane::Strain);
            for (layer, interface) in above {
                stack = stack.item(layer).item(interface);
            }
            let ground = HalfPlane::new(1.0, 0.25).unwrap();
            let built = if rigid { stack.rigid().build() } else { stack.layer(ground).build() };
            // what is refused are layers of no thickness: nothing else on a rigid base, or next to springs
            let stack = match built {
                Ok(stack) => stack,
                Err(error) => {
                    let loose = matches!(error.problem(), StackProblem::LooseSprings { .. });
                    prop_assert!(rigid || loose);
                    return Ok(());
                }
            };
            let system = BlockSystem::new(&stack);
            prop_assert_eq!(system.rows().len(), system.unknowns());
            for row in system.rows() {
                // a block next to the diagonal at most: the matrix is a chain
                prop_assert!(row.blocks.windows(2).all(|pair| [0, 1].contains(&(pair[1].column - pair[0].column))));
                prop_assert!(matches!(row.blocks.len(), 1..=3));
            }
            // every amplitude of a layer is held by at least as many conditions
            for (i, column) in system.columns().iter().enumerate() {
                let touching = system.rows().iter().filter(|row| row.blocks.iter().any(|block| block.column == i));
                prop_assert!(touching.count() >= column.amplitudes().count());
            }
        }
    }
}
