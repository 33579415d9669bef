//! The contacts that occur in some row of a sweep, without the stack of every row.
//!
//! New values change nothing of the structure but which layers have a thickness of 0, and are not there. For every layer it is
//! found whether it can be there and whether it can be missing; since axes belong to one layer each, all combinations
//! of that occur. Two layers touch in some row if both can be there, all between can be missing, and one of the interfaces
//! between them opens.
use recede_layers::Homogeneous;

use super::Sweep;
use crate::axis::Axis;
use crate::errors::Error;
use crate::scene::{Change, Item, Owner, Slot};
use crate::solution::Interface;
use crate::stack::{Stack, StackProblem};

/// The forms that an item of the stack takes in the rows of a sweep.
#[derive(Default)]
struct Choice {
    /// The item with a thickness that is not 0, or any item that has none.
    there: Option<Item>,
    /// The layer with a thickness of 0.
    missing: Option<Item>,
}

impl Sweep {
    /// The contacts of all stacks that occur, from the top down.
    pub(super) fn all_interfaces(&self) -> Result<Vec<Interface>, Error> {
        let choices: Vec<Choice> =
            (0..self.scene.stack.len()).map(|index| self.choice(index)).collect::<Result<_, _>>()?;
        self.check_fullest(&choices).map_err(|error| self.scene.locate(error))?;
        let mut found = vec![Interface::Punch];
        // a layer that is no base
        let is_layer = |item: &Option<Item>| matches!(item, Some(Item::Layer(layer)) if layer.thickness().is_some());
        for (above, _) in choices.iter().enumerate().filter(|(_, choice)| is_layer(&choice.there)) {
            for below in (above + 1..choices.len()).filter(|below| !is_interface(&choices[*below])) {
                if choices[below].there.is_some() {
                    found.extend(contact_between(&choices, above, below));
                }
                if choices[below].missing.is_none() {
                    break;
                }
            }
        }
        Ok(found)
    }

    /// Fails if no combination of values is a stack. A stack of all layers that can be there is one unless it has too many,
    /// which is left to the rows to tell if there may be fewer.
    fn check_fullest(&self, choices: &[Choice]) -> Result<(), Error> {
        let items: Vec<Item> =
            choices.iter().filter_map(|choice| choice.there.as_ref().or(choice.missing.as_ref())).cloned().collect();
        let Err(error) = Stack::from_items_under(self.scene.geometry, self.scene.pressure_on_top, &items) else {
            return Ok(());
        };
        let only = match error.problem() {
            StackProblem::TooManyLayers(_) | StackProblem::TooManyReceding(_) => {
                choices.iter().all(|choice| choice.there.is_none() || choice.missing.is_none())
            }
            StackProblem::TooThick | StackProblem::Contrast { .. } => !self
                .slots
                .iter()
                .zip(&self.axes)
                .any(|(slot, axis)| matches!(slot.owner, Owner::Item(_)) && axis.count() > 1),
            _ => true,
        };
        if only { Err(error.into()) } else { Ok(()) }
    }

    /// The forms of the item with this index.
    fn choice(&self, index: usize) -> Result<Choice, Error> {
        let own = self.axes.iter().zip(&self.slots).filter(|(_, slot)| slot.owner == Owner::Item(index));
        let own: Vec<(&Axis, &Slot)> = own.collect();
        let mut choice = Choice::default();
        let mut refused = None;
        let mut add = |changes: &[Change]| match self.scene.with_changes(changes) {
            Ok(mut scene) => choice.add(scene.stack.swap_remove(index)),
            Err(error) => drop(refused.get_or_insert(error)),
        };
        if own.is_empty() {
            choice.add(self.scene.stack[index].clone());
            return Ok(choice);
        }
        // each axis at its extremes, with the others at theirs: of one or two axes these are all combinations of extremes
        let extremes: Vec<Vec<f64>> = own.iter().map(|(axis, _)| axis.extremes()).collect();
        let at = |i: usize, extreme: usize| (own[i].1, extremes[i][extreme.min(extremes[i].len() - 1)]);
        for (varied, its_extremes) in extremes.iter().enumerate() {
            for (extreme, others) in (0..its_extremes.len()).flat_map(|one| (0..3).map(move |other| (one, other))) {
                let extreme = |i: usize| if i == varied { extreme } else { others };
                add(&(0..own.len()).map(|i| at(i, extreme(i))).collect::<Vec<_>>());
            }
        }
        match refused {
            Some(error) if choice.there.is_none() && choice.missing.is_none() => {
                let known =
                    own.len() <= 2 && own.iter().zip(&extremes).all(|((axis, _), own)| axis.count() == own.len());
                if known { Err(error.into()) } else { Ok(Choice::any(self.scene.stack[index].clone())) }
            }
            _ => Ok(choice),
        }
    }
}

impl Choice {
    fn add(&mut self, item: Item) {
        let missing = matches!(&item, Item::Layer(layer) if layer.thickness() == Some(0.0));
        let place = if missing { &mut self.missing } else { &mut self.there };
        place.get_or_insert(item);
    }

    /// An item of which nothing is known: a column too many is better than one that is not there.
    fn any(item: Item) -> Self {
        // of unit shear modulus in the place of any other layer of finite thickness
        let strip = |thickness: f64| Homogeneous::new(thickness, 1.0, 0.25).ok().map(Item::layer);
        match &item {
            Item::Layer(layer) if layer.thickness().is_some() => Self { there: strip(1.0), missing: strip(0.0) },
            _ => Self { there: Some(item), missing: None },
        }
    }
}

/// The contact of two layers, if all between them are missing.
fn contact_between(choices: &[Choice], above: usize, below: usize) -> Option<Interface> {
    let between = || choices[above + 1..below].iter().filter_map(|choice| choice.there.as_ref());
    let is_open = between().any(Item::is_receding);
    // springs hold nothing next to a layer that is missing, and nothing lies loose on a support: these are no stacks
    let is_stack = !between().any(|item| matches!(item, Item::Spring(_)))
        && !matches!(choices[below].there, Some(Item::Support(_)));
    let number = |index: usize| choices[..=index].iter().filter(|choice| !is_interface(choice)).count();
    (is_open && is_stack).then(|| Interface::Between { above: number(above), below: number(below) })
}

fn is_interface(choice: &Choice) -> bool {
    choice.there.as_ref().is_some_and(Item::is_interface)
}
