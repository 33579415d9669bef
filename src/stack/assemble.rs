//! From items as written to laminates and base.
use std::collections::BTreeMap;
use std::sync::Arc;

use recede_layers::layer_label;

use super::contrast;
use super::weight::weight;
use super::{Base, Foundation, Joint, Laminate, MAX_LAYERS, MAX_RECEDING, Placed, Stack, StackError, StackProblem};

use crate::geometry::Geometry;
use crate::scene::{Item, Punch};
use crate::solution::Interface;

/// A group of joined layers and the interfaces below it.
#[derive(Debug, Default)]
struct Groups {
    finished: Vec<Laminate>,
    open: Laminate,
    /// The interfaces since the last layer of `open`, several around layers of thickness 0; `None` for a receding one.
    below: Vec<Option<Joint>>,
    /// The gap of one of these.
    gap: Option<Punch>,
    dropped: Vec<Placed>,
}

impl Groups {
    /// Adds the interface with this index among the items; an error if springs are left without a layer on one side.
    fn interface(&mut self, index: usize, joint: Option<Joint>) -> Result<(), StackError> {
        self.below.push(joint);
        let is_loose = self.open.layers.is_empty() || self.below.contains(&None);
        if is_loose && self.below.iter().flatten().any(|joint| joint.gives_way()) {
            let layer = self.dropped.last().map_or(String::new(), Placed::name);
            return Err(StackError::at(index, StackProblem::LooseSprings(layer)));
        }
        Ok(())
    }

    /// Closes the open group if the next layer is not joined to it.
    fn begin_next(&mut self) {
        let below = std::mem::take(&mut self.below);
        // the interfaces above the first layer are dropped
        if self.open.layers.is_empty() {
            self.gap = None;
            return;
        }
        // a receding one takes precedence; compliances of others add up
        match below.into_iter().collect::<Option<Vec<Joint>>>() {
            Some(joints) => self.open.joints.extend(joints.into_iter().reduce(Joint::in_series)),
            None => {
                self.open.gap = self.gap.take();
                self.finished.push(std::mem::take(&mut self.open));
            }
        }
    }

    fn layer(&mut self, placed: Placed) {
        if placed.layer.thickness() == Some(0.0) {
            self.dropped.push(placed);
        } else {
            self.begin_next();
            self.open.layers.push(placed);
        }
    }
}

impl Stack {
    /// Builds a stack from items as they are written in a scene.
    ///
    /// # Errors
    /// [`StackError`] if the items do not alternate between layers and interfaces, do not end in a base, or have a
    /// base elsewhere; if nothing in the stack can deform.
    pub fn from_items(geometry: impl Into<Geometry>, items: &[Item]) -> Result<Self, StackError> {
        Self::from_items_under(geometry, 0.0, items)
    }

    /// The body that presses on the top face of a stack, from items as they are written.
    pub(crate) fn of_second(geometry: Geometry, items: &[Item]) -> Result<Self, StackError> {
        Self::from_items(geometry, items).map_err(|StackError { problem, .. }| StackError::of_second(problem))
    }

    /// The same under a pressure everywhere on the top face, in stress.
    ///
    /// # Errors
    /// As [`Self::from_items`], and if the pressure or the weight of a layer pulls.
    pub fn from_items_under(
        geometry: impl Into<Geometry>,
        pressure_on_top: f64,
        items: &[Item],
    ) -> Result<Self, StackError> {
        check_order(items)?;
        check_names(items)?;
        let mut groups = Groups::default();
        let mut foundation = None;
        for (index, item) in items.iter().enumerate() {
            let number = number(index);
            match item {
                Item::Bonded => groups.interface(index, Some(Joint::BONDED))?,
                Item::Sliding => groups.interface(index, Some(Joint::SLIDING))?,
                Item::Spring(spring) => {
                    let joint = Joint { normal: spring.normal(), tangential: spring.tangential() };
                    groups.interface(index, Some(joint))?;
                }
                Item::Receding => groups.interface(index, None)?,
                Item::RecedingGap(gap) => {
                    groups.interface(index, None)?;
                    if groups.gap.replace(gap.clone()).is_some() {
                        return Err(StackError::at(index, StackProblem::TwoGaps));
                    }
                }
                Item::Rigid => foundation = Some(Foundation::Rigid { number }),
                Item::Support(support) => {
                    foundation = Some(Foundation::Support { number, support: Arc::clone(support) });
                }
                Item::Layer(layer) => {
                    let placed = Placed { number, layer: Arc::clone(layer), pressed_to: 0.0 };
                    match layer.thickness() {
                        None => foundation = Some(Foundation::HalfPlane(placed)),
                        Some(found) if !(found >= 0.0 && found.is_finite()) => {
                            return Err(StackError::at(index, StackProblem::Thickness { layer: placed.name(), found }));
                        }
                        Some(_) => groups.layer(placed),
                    }
                }
            }
        }
        groups.begin_next();
        // where there are items, `check_order` has found a base
        finish((geometry.into(), pressure_on_top), groups, foundation.ok_or(StackError::whole(StackProblem::Empty))?)
    }
}

/// The stack of these groups, within the limits.
fn finish(
    (geometry, pressure_on_top): (Geometry, f64),
    groups: Groups,
    foundation: Foundation,
) -> Result<Stack, StackError> {
    let Groups { finished: laminates, open: joined, dropped, .. } = groups;
    if let (Foundation::Rigid { number }, true, true) = (&foundation, laminates.is_empty(), joined.layers.is_empty()) {
        return Err(StackError::of_layer(*number, StackProblem::NothingElastic));
    }
    if let (Foundation::Support { number, support }, true) = (&foundation, joined.layers.is_empty()) {
        let base = called(&Item::Support(Arc::clone(support)), *number);
        return Err(StackError::of_layer(*number, StackProblem::NotBonded(base)));
    }
    let found = laminates.iter().map(|laminate| laminate.layers.len()).sum::<usize>() + joined.layers.len();
    if found > MAX_LAYERS {
        return Err(StackError::whole(StackProblem::TooManyLayers(found)));
    }
    if laminates.len() > MAX_RECEDING {
        return Err(StackError::whole(StackProblem::TooManyReceding(laminates.len())));
    }
    let mut stack =
        Stack { geometry, pressure_on_top, laminates, base: Base { joined, foundation }, dropped, second: None };
    stack.press_flat();
    if !stack.total_thickness().is_finite() {
        return Err(StackError::whole(StackProblem::TooThick));
    }
    if geometry.is_axisymmetric() {
        check_all_around(&stack)?;
    }
    check_weights(&stack)?;
    let pressed = stack.contacts().split_off(1 + stack.loose());
    for (interface, gap) in stack.gaps().0 {
        if pressed.contains(&interface) {
            // what is curved evenly is pressed flat, and dents are while nothing comes apart
            let is_dent = gap.dent().is_some() && !stack.geometry().is_axisymmetric();
            if !is_dent && gap.punch.as_ref().is_some_and(|gap| gap.shape().even_curvature().is_none()) {
                return Err(StackError::whole(StackProblem::GapUnderWeight { interface }));
            }
            continue;
        }
        // a punch may be curved more
        if interface == Interface::Punch {
            continue;
        }
        let gap = (gap.is_unknown() || gap.shape().falls()).then_some(gap);
        if let Some(gap) = gap {
            let is_unknown = gap.is_unknown();
            return Err(StackError::whole(StackProblem::Bent { interface, curvature: gap.curvature, is_unknown }));
        }
    }
    contrast::check(&stack, None)?;
    Ok(stack)
}

/// Weights and the pressure on top press.
fn check_weights(stack: &Stack) -> Result<(), StackError> {
    let pressure = stack.pressure_on_top;
    if !(pressure >= 0.0 && pressure.is_finite()) {
        return Err(StackError::whole(StackProblem::PressureOnTop(pressure)));
    }
    for placed in stack.groups().flat_map(|group| group.layers()) {
        let found = placed.layer.specific_weight();
        if !(found >= 0.0 && weight(placed).is_finite()) {
            return Err(StackError::of_layer(placed.number, StackProblem::Weight { layer: placed.name(), found }));
        }
    }
    Ok(())
}

/// Layers and interfaces alternate, from a layer to a base, which is the only one.
fn check_order(items: &[Item]) -> Result<(), StackError> {
    for (index, item) in items.iter().enumerate() {
        let number = number(index);
        let (at, problem) = match (item.is_interface(), items.get(index + 1)) {
            (true, _) if index == 0 => (index, StackProblem::BeginsWithInterface(item.name())),
            (true, None) => (index, StackProblem::EndsWithInterface(item.name())),
            (true, Some(below)) if below.is_interface() => {
                (index + 1, StackProblem::TwoInterfaces { first: item.name(), second: below.name() })
            }
            (false, Some(_)) if is_base(item) => (index, StackProblem::BaseNotLast(called(item, number))),
            (false, Some(below)) if !below.is_interface() => {
                let (above, below) = (called(item, number), called(below, number + 1));
                (index + 1, StackProblem::NoInterface { above, below })
            }
            (false, None) if !is_base(item) => (index, StackProblem::NoBase(called(item, number))),
            _ => continue,
        };
        return Err(StackError::at(at, problem));
    }
    Ok(())
}

/// Refuses two layers of one name.
fn check_names(items: &[Item]) -> Result<(), StackError> {
    let mut names = BTreeMap::new();
    for (index, item) in items.iter().enumerate() {
        let first = item.own_name().and_then(|name| names.insert(name, index));
        if let Some(first) = first {
            let [first, second] = [first, index].map(|index| called(&items[index], number(index)));
            return Err(StackError::at(index, StackProblem::SameName { first, second }));
        }
    }
    Ok(())
}

/// The number of the layer at this place among the items, where layers and interfaces alternate.
fn number(index: usize) -> usize {
    index / 2 + 1
}

fn is_base(item: &Item) -> bool {
    match item {
        Item::Layer(layer) => layer.thickness().is_none(),
        Item::Support(_) | Item::Rigid => true,
        _ => false,
    }
}

fn called(item: &Item, number: usize) -> String {
    match item {
        Item::Rigid => "the rigid base".to_owned(),
        other => format!("{} ({})", layer_label(number, other.own_name()), other.name()),
    }
}

/// Materials have to be the same in all directions along the layers; next to loaded faces the fields of those with complex roots have no closed
/// form about an axis.
fn check_all_around(stack: &Stack) -> Result<(), StackError> {
    let plane = stack.plane();
    for placed in stack.groups().flat_map(|group| group.layers()) {
        let material = placed.layer.material(0.0, plane);
        let [first, _] = material.squared_roots();
        if !placed.layer.is_same_all_around() {
            return Err(StackError::of_layer(placed.number, StackProblem::NotAxisymmetric(placed.name())));
        }
        if !material.is_isotropic() && first.im != 0.0 {
            return Err(StackError::of_layer(placed.number, StackProblem::ComplexRoots(placed.name())));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use recede_layers::{HalfPlane, Homogeneous};

    use super::*;

    fn strip(thickness: f64) -> Item {
        Item::layer(Homogeneous::new(thickness, 1.0, 0.25).unwrap())
    }

    fn ground() -> Item {
        Item::layer(HalfPlane::new(1.0, 0.25).unwrap())
    }

    /// Numbers of the layers of every laminate and of the base.
    fn groups(items: &[Item]) -> (Vec<Vec<usize>>, Vec<usize>) {
        let stack = Stack::from_items(Geometry::PlaneStrain, items).unwrap();
        let numbers = |layers: &[Placed]| layers.iter().map(|layer| layer.number).collect::<Vec<_>>();
        (stack.laminates().iter().map(|laminate| numbers(laminate.layers())).collect(), numbers(stack.base().layers()))
    }

    #[test]
    fn layers_of_no_thickness_leave_one_interface() {
        use Item::{Bonded, Receding, Rigid};
        let (one, none) = (|| strip(1.0), || strip(0.0));
        // a receding interface takes precedence
        assert_eq!(groups(&[one(), Bonded, none(), Receding, ground()]), (vec![vec![1]], vec![]));
        assert_eq!(groups(&[one(), Receding, none(), Bonded, ground()]), (vec![vec![1]], vec![]));
        assert_eq!(groups(&[one(), Bonded, none(), Bonded, one(), Receding, Rigid]), (vec![vec![1, 3]], vec![]));
        assert_eq!(groups(&[one(), Receding, none(), Bonded, none(), Bonded, one(), Bonded, Rigid]), {
            (vec![vec![1]], vec![4])
        });
        // a dropped first layer drops the interface below it
        assert_eq!(groups(&[none(), Receding, one(), Bonded, ground()]), (vec![], vec![2]));
        assert_eq!(groups(&[none(), Receding, none(), Receding, ground()]), (vec![], vec![]));
    }
}
