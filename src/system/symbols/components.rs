//! The connected components of the block matrix: bodies that only the pressures of contacts hold together.
use super::conditions::{self, Relation};
use super::matrix::{BlockSystem, Column, Row};
use super::names::Face;
use crate::stack::{Joint, Stack};
use crate::system::WrongCount;

/// Columns that conditions without a pressure connect, from the top down. In this order the rows of a component are block
/// tridiagonal: a row involves one column, or two that follow each other.
#[derive(Clone, Debug, Default)]
pub struct Component<'a> {
    columns: &'a [Column],
    /// The rows with the number of their interface: 0 is the upper face of the first column, i lies below i columns.
    rows: Vec<(usize, &'a Row)>,
}

impl<'a> Component<'a> {
    /// The columns from the top down.
    pub fn columns(&self) -> &'a [Column] {
        self.columns
    }

    /// The rows at an interface of the component: 0 is its upper face, i lies below i of its columns.
    pub fn rows_at(&self, interface: usize) -> impl Iterator<Item = &'a Row> + Clone {
        let first = self.rows.partition_point(|(at, _)| *at < interface);
        let end = self.rows.partition_point(|(at, _)| *at <= interface);
        self.rows[first..end].iter().map(|(_, row)| *row)
    }

    /// The first face with more or fewer rows than it needs.
    pub(super) fn wrong_count(&self) -> Option<WrongCount> {
        (0..=self.columns.len()).find_map(|interface| {
            let (column, face) = match interface.checked_sub(1) {
                None => (self.columns.first()?, Face::Top),
                Some(above) => (self.columns.get(above)?, Face::Bottom),
            };
            let needed = match interface {
                0 => 2,
                _ if interface < self.columns.len() => 4,
                // a half-plane and a support end nowhere
                _ => column.amplitudes().count() - 2,
            };
            let (layer, found) = (column.number(), self.rows_at(interface).count());
            (found != needed).then_some(WrongCount { layer, face, found, needed })
        })
    }

    /// Whether a contact presses on the lower face, so that nothing holds the component.
    pub fn is_free(&self) -> bool {
        self.rows_at(self.columns.len()).any(|row| row.right.is_some())
    }
}

impl BlockSystem {
    /// The block system of a stack with given relations at each joint, four that connect the layers on both sides. On a
    /// rigid base, relations that contain only its stresses are left out, and two are to be left.
    ///
    /// # Errors
    /// [`WrongCount`] if they are more or fewer conditions than the bodies at a joint need.
    pub fn with_joints(stack: &Stack, joint: impl Fn(&Joint) -> [Relation; 4]) -> Result<Self, WrongCount> {
        let system = Self::assembled(stack, conditions::contact, joint);
        let components = system.components();
        let wrong = components.iter().find_map(Component::wrong_count);
        wrong.map_or(Ok(()), Err)?;
        Ok(system)
    }

    /// The connected components of the matrix once the rows with a pressure are cut, from the top down: free laminates, and
    /// the base if there is anything elastic in it.
    ///
    /// ```
    /// use recede::{BlockSystem, HalfPlane, Homogeneous, Plane, Stack};
    /// let strip = || Homogeneous::new(1.0, 1.0, 0.25);
    /// let stack = Stack::builder(Plane::Strain).layer(strip()?).bonded().layer(strip()?).receding();
    /// let system = BlockSystem::new(&stack.layer(HalfPlane::new(1.0, 0.25)?).build()?);
    /// let columns = system.components().iter().map(|component| component.columns().len()).collect::<Vec<_>>();
    /// assert_eq!(columns, [2, 1]);
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn components(&self) -> Vec<Component<'_>> {
        // rows connect neighbours only: the columns that are connected with the column before
        let mut is_joined = vec![false; self.columns().len()];
        for row in self.rows().iter().filter(|row| row.right.is_none()) {
            for pair in row.blocks.windows(2).filter(|pair| pair[0].column != pair[1].column) {
                is_joined[pair[0].column.max(pair[1].column)] = true;
            }
        }
        let starts: Vec<usize> = (0..is_joined.len()).filter(|column| !is_joined[*column]).collect();
        let ends = starts.iter().skip(1).copied().chain([is_joined.len()]);
        let columns = starts.iter().zip(ends).map(|(start, end)| &self.columns()[*start..end]);
        let mut components: Vec<Component> = columns.map(|columns| Component { columns, rows: Vec::new() }).collect();
        for row in self.rows() {
            let Some(block) = row.blocks.first() else { continue };
            let component = starts.partition_point(|start| *start <= block.column) - 1;
            let above = block.column - starts[component];
            components[component].rows.push((above + usize::from(block.face == Face::Bottom), row));
        }
        components
    }
}
