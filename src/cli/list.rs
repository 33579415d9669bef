//! `recede list`: all that may be written in a scene.
use std::io::{self, Write};

use recede::layers::description::{Field, Form, Value};
use recede::{Registry, Vocabulary, scene_schema};

use super::Failure;

/// Columns in which names are written.
const NAMES: usize = 22;

/// List layers, interfaces, bases, punches and loads with their fields
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede list
  recede list layers
  recede list Homogeneous
  recede list --schema > scene.schema.json")]
pub struct List {
    /// One part only: scene, punches, loads, "axisymmetric punches", "axisymmetric loads", layers, interfaces or bases; or one name,
    /// such as Homogeneous
    part: Option<String>,
    /// The JSON Schema of scenes in JSON, for editors and other programs
    #[arg(long, conflicts_with = "part")]
    schema: bool,
}

impl List {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        if self.schema {
            return Ok(writeln!(out, "{:#}", scene_schema(&Registry::default()))?);
        }
        let Vocabulary { scene, punches, loads, round_punches, round_loads, layers, interfaces, bases } =
            Vocabulary::new(&Registry::default());
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
        let parts = [
            ("Punches", punches),
            ("Loads", loads),
            ("Axisymmetric punches", round_punches),
            ("Axisymmetric loads", round_loads),
            ("Layers", layers),
            ("Interfaces", interfaces),
            ("Bases", bases),
        ];
        match &self.part {
            None => {
                writeln!(out, "Scene, with its load")?;
                fields(out, 2, &scene)?;
                for (title, part) in &parts {
                    writeln!(out, "\n{title}")?;
                    forms(out, 2, part)?;
                }
                Ok(())
            }
            Some(name) if name.eq_ignore_ascii_case("scene") => Ok(fields(out, 0, &scene)?),
            Some(name) => {
                let same = |other: &str| other.eq_ignore_ascii_case(name);
                if let Some((_, part)) = parts.iter().find(|(title, _)| same(title)) {
                    return Ok(forms(out, 0, part)?);
                }
                let named: Vec<Form> =
                    parts.iter().flat_map(|(_, part)| part).filter(|form| same(&form.name)).cloned().collect();
                if named.is_empty() {
                    let names: Vec<&str> = parts.iter().flat_map(|(_, part)| part).map(|form| &form.name[..]).collect();
                    return Err(Failure::usage(
                        format!("nothing in a scene is called `{name}`"),
                        format!(
                            "parts are scene, punches, loads, axisymmetric punches, axisymmetric loads, layers, interfaces, bases; names are {}",
                            names.join(", ")
                        ),
                    ));
                }
                Ok(forms(out, 0, &named)?)
            }
        }
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
