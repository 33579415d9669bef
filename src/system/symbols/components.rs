//! The connected components of the block matrix: bodies that only the pressures of contacts hold together.
use super::conditions::Relation;
use super::matrix::{BlockSystem, Column, Row};
use super::names::Face;
use crate::stack::{Joint, Stack};
use crate::system::WrongCount;

/// Columns that conditions without a pressure connect, from the top down. In this order the rows of a component are block
/// tridiagonal: a row involves one column, or two that follow each other.
#[derive(Clone, Debug)]
pub struct Component<'a> {
    columns: Vec<&'a Column>,
    /// The rows with the number of their interface: 0 is the upper face of the first column, i lies below i columns.
    rows: Vec<(usize, &'a Row)>,
}

impl<'a> Component<'a> {
    /// The columns from the top down.
    pub fn columns(&self) -> &[&'a Column] {
        &self.columns
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
        self.rows_at(self.columns.len()).any(|row| row.pressure.is_some())
    }
}

impl BlockSystem {
    /// The block system of a stack with given relations at each joint, four that connect the layers on both sides. On a
    /// rigid base, relations that contain only its stresses are left out, and two are to be left.
    ///
    /// # Errors
    /// [`WrongCount`] if they are more or fewer conditions than the bodies at a joint need.
    pub fn with_joints(stack: &Stack, joint: impl Fn(&Joint) -> [Relation; 4]) -> Result<Self, WrongCount> {
        let system = Self::assembled(stack, joint);
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
        // each column points to the first one that it is connected with
        let mut first: Vec<usize> = (0..self.columns().len()).collect();
        let root = |first: &[usize], mut column: usize| {
            while first[column] != column {
                column = first[column];
            }
            column
        };
        for row in self.rows().iter().filter(|row| row.pressure.is_none()) {
            for pair in row.blocks.windows(2) {
                let [a, b] = [root(&first, pair[0].column), root(&first, pair[1].column)];
                first[a.max(b)] = a.min(b);
            }
        }
        // where each column goes: which component, and below how many others of its columns
        let mut components: Vec<Component> = Vec::new();
        let mut places: Vec<(usize, usize)> = Vec::with_capacity(first.len());
        for (i, column) in self.columns().iter().enumerate() {
            let root = root(&first, i);
            // later columns are found in one step
            first[i] = root;
            let component = if root == i { components.len() } else { places[root].0 };
            if root == i {
                components.push(Component { columns: Vec::new(), rows: Vec::new() });
            }
            places.push((component, components[component].columns.len()));
            components[component].columns.push(column);
        }
        for row in self.rows() {
            let Some(block) = row.blocks.first() else { continue };
            let (component, above) = places[block.column];
            let interface = above + if block.face == Face::Bottom { 1 } else { 0 };
            components[component].rows.push((interface, row));
        }
        components.iter_mut().for_each(|component| component.rows.sort_by_key(|(interface, _)| *interface));
        components
    }
}
