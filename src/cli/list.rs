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
pub struct ListArguments {
    /// One part only: scene, punches, loads, "axisymmetric punches", "axisymmetric loads", layers, interfaces or bases; or one name,
    /// such as Homogeneous
    part: Option<String>,
    /// The JSON Schema of scenes in JSON, for editors and other programs
    #[arg(long, conflicts_with = "part")]
    schema: bool,
}

impl ListArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        if self.schema {
            return Ok(writeln!(out, "{:#}", scene_schema(&Registry::default()))?);
        }
        let all = Vocabulary::new(&Registry::default());
        let parts = [
            ("Punches", all.punches),
            ("Loads", all.loads),
            ("Axisymmetric punches", all.round_punches),
            ("Axisymmetric loads", all.round_loads),
            ("Layers", all.layers),
            ("Interfaces", all.interfaces),
            ("Bases", all.bases),
        ];
        let mut scene = all.scene;
        for field in &mut scene {
            // what has a section of its own is not unfolded in place
            let own = parts.iter().find(|(_, forms)| matches!(&field.value, Value::OneOf(these) if these == forms));
            if let Some((title, _)) = own {
                field.value = Value::Plain(format!("one of the {} below", title.to_lowercase()));
            }
        }
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
                    let titles = parts.each_ref().map(|(title, _)| title.to_lowercase()).join(", ");
                    return Err(Failure::usage(
                        format!("nothing in a scene is called `{name}`"),
                        format!("parts are scene, {titles}; names are {}", names.join(", ")),
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
        entry(out, indent, name, &format!("{meaning}{optional}"), Some(what))?;
    }
    Ok(())
}

fn forms(out: &mut dyn Write, indent: usize, forms: &[Form]) -> io::Result<()> {
    for Form { name, meaning, value: what } in forms {
        entry(out, indent, name, meaning, what.as_ref())?;
    }
    Ok(())
}

/// A line with a name, its meaning and the allowed values; below it what belongs to the name.
fn entry(out: &mut dyn Write, indent: usize, name: &str, meaning: &str, what: Option<&Value>) -> io::Result<()> {
    let allowed = match what {
        Some(Value::Plain(allowed)) => format!(" Allowed: {allowed}."),
        Some(Value::OneOf(_)) => " One of:".to_owned(),
        Some(Value::Fields(_)) | None => String::new(),
    };
    let line = format!("{:indent$}{name:width$} {meaning}{allowed}", "", width = NAMES.saturating_sub(indent));
    writeln!(out, "{}", line.trim_end())?;
    match what {
        Some(Value::Fields(inner)) => fields(out, indent + 2, inner),
        Some(Value::OneOf(inner)) => forms(out, indent + 2, inner),
        Some(Value::Plain(_)) | None => Ok(()),
    }
}
