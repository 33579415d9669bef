//! `recede list`: all that may be written in a scene.
use std::io::{self, Write};

use recede::layers::description::{Field, Form, Value};
use recede::{Registry, Vocabulary};

use super::Failure;

/// Columns in which names are written.
const NAMES: usize = 22;

/// List layers, interfaces, bases, punches and loads with their fields
#[derive(Debug, clap::Args)]
pub struct List {}

impl List {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let Vocabulary { scene, punches, loads, layers, interfaces, bases } = Vocabulary::new(&Registry::default());
        // what has a section of its own is not unfolded in place
        let scene: Vec<Field> = scene
            .into_iter()
            .map(|field| match field.value {
                Value::OneOf(forms) if forms == punches => {
                    Field { value: Value::Plain("one of the punches below".to_owned()), ..field }
                }
                Value::OneOf(forms) if forms == loads => {
                    Field { value: Value::Plain("one of the loads below".to_owned()), ..field }
                }
                _ => field,
            })
            .collect();
        writeln!(out, "Scene, with its load")?;
        fields(out, 2, &scene)?;
        for (title, forms_of_title) in
            [("Punches", punches), ("Loads", loads), ("Layers", layers), ("Interfaces", interfaces), ("Bases", bases)]
        {
            writeln!(out, "\n{title}")?;
            forms(out, 2, &forms_of_title)?;
        }
        Ok(())
    }
}

fn fields(out: &mut dyn Write, indent: usize, fields: &[Field]) -> io::Result<()> {
    for Field { name, meaning, optional, value: what } in fields {
        let optional = if *optional { " Optional." } else { "" };
        line(out, indent, name, &format!("{meaning}{optional}{}", range(Some(what))))?;
        value(out, indent + 2, what)?;
    }
    Ok(())
}

fn forms(out: &mut dyn Write, indent: usize, forms: &[Form]) -> io::Result<()> {
    for Form { name, meaning, value: what } in forms {
        line(out, indent, name, &format!("{meaning}{}", range(what.as_ref())))?;
        if let Some(what) = what {
            value(out, indent + 2, what)?;
        }
    }
    Ok(())
}

fn value(out: &mut dyn Write, indent: usize, what: &Value) -> io::Result<()> {
    match what {
        Value::Plain(_) => Ok(()),
        Value::Fields(inner) => fields(out, indent, inner),
        Value::OneOf(inner) => forms(out, indent, inner),
    }
}

/// What is allowed, behind what it means.
fn range(what: Option<&Value>) -> String {
    match what {
        Some(Value::Plain(allowed)) => format!(" Allowed: {allowed}."),
        Some(Value::OneOf(_)) => " One of:".to_owned(),
        Some(Value::Fields(_)) | None => String::new(),
    }
}

fn line(out: &mut dyn Write, indent: usize, name: &str, text: &str) -> io::Result<()> {
    let line = format!("{:indent$}{name:width$} {text}", "", width = NAMES.saturating_sub(indent));
    writeln!(out, "{}", line.trim_end())
}
