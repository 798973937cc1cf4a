//! A fire that is kept: what the renderer gets of it, in a small file.
//!
//! A head of lines of text, then columns of 16-bit numbers. Each column has
//! the two values between which its numbers lie. What several display modes have in
//! common, as places and velocities, is kept once.
//!
//! ```text
//! hearth-snapshot 1
//! time 5.002
//! value max_particles 1200
//! solid shape box x -0.1       the properties of a solid, with ; for a space in a value
//! column 640 -0.31 0.29       rows, least, most
//! rows fire 0 1 2 3 4 5 6 7   a display mode, and the columns of its instances
//! embers 8 9 10 11 12 13 14 15
//! end
//! ```

use hearth_core::params::Input;
use hearth_core::{Instance, Parameters, Scene, Simulation};

const FIRST_LINE: &str = "hearth-snapshot 1";
const LAST_LINE: &str = "end";
/// Columns of an instance.
const FIELDS: usize = size_of::<Instance>() / size_of::<f32>();
/// The largest kept number.
const STEPS: f32 = u16::MAX as f32;

/// Numbers between two values.
#[derive(Clone, Debug, PartialEq)]
struct Column {
    least: f32,
    most: f32,
    numbers: Vec<u16>,
}

impl Column {
    fn of(values: impl Iterator<Item = f32> + Clone) -> Column {
        let least = values.clone().fold(f32::INFINITY, f32::min);
        let most = values.clone().fold(f32::NEG_INFINITY, f32::max);
        let scale = if most > least {
            STEPS / (most - least)
        } else {
            0.0
        };
        Column {
            least,
            most,
            numbers: values
                .map(|value| ((value - least) * scale).round() as u16)
                .collect(),
        }
    }

    /// Whether all its numbers are one: then none is written.
    fn is_even(&self) -> bool {
        self.most <= self.least
    }

    fn value(&self, row: usize) -> f32 {
        let share = self.numbers.get(row).map_or(0.0, |&n| f32::from(n) / STEPS);
        if share >= 1.0 {
            return self.most;
        }
        self.least + share * (self.most - self.least)
    }
}

/// A fire that is kept.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Snapshot {
    /// Seconds it had burnt.
    pub time: f64,
    /// What of its values is not the default, as a person would write it.
    values: Vec<(String, String)>,
    /// The properties of each solid.
    solids: Vec<Vec<(String, String)>>,
    columns: Vec<Column>,
    /// Display modes with the columns of their instances.
    rows: Vec<(String, [usize; FIELDS])>,
    embers: Option<[usize; FIELDS]>,
}

impl Snapshot {
    /// A fire's time, values and embers. What display modes draw of it is added by
    /// [`keep`](Snapshot::keep).
    pub fn of(fire: &Simulation) -> Snapshot {
        let parameters = fire.parameters();
        let model = ("model".to_owned(), parameters.model().name().to_owned());
        let changed = parameters
            .changed()
            .map(|(param, value)| (param.id.to_owned(), value.to_string()))
            .filter(|(id, _)| id != "model");
        let solids = fire
            .scene()
            .objects()
            .filter(|object| object.solid().is_some());
        let properties = solids.map(|solid| {
            let all = solid.properties();
            all.map(|(name, _, value)| (name.to_owned(), value.to_string()))
                .collect()
        });
        let mut snapshot = Snapshot {
            time: fire.time(),
            solids: properties.collect(),
            values: std::iter::once(model).chain(changed).collect(),
            ..Snapshot::default()
        };
        let mut embers = Vec::new();
        fire.write_embers(&mut embers);
        if !embers.is_empty() {
            snapshot.embers = Some(snapshot.add(&embers));
        }
        snapshot
    }

    /// Keeps what `fire` gives the renderer, under that name.
    pub fn keep(&mut self, name: &str, fire: &Simulation) {
        let mut instances = Vec::new();
        fire.write_instances(&mut instances);
        let columns = self.add(&instances);
        self.rows.push((name.to_owned(), columns));
    }

    fn add(&mut self, instances: &[Instance]) -> [usize; FIELDS] {
        std::array::from_fn(|field| {
            let column = Column::of(instances.iter().map(|instance| instance[field]));
            let known = self.columns.iter().position(|known| *known == column);
            known.unwrap_or_else(|| {
                self.columns.push(column);
                self.columns.len() - 1
            })
        })
    }

    /// The display modes that are kept.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.rows.iter().map(|(name, _)| name.as_str())
    }

    /// What the renderer gets in the display mode of that name.
    pub fn instances(&self, name: &str) -> Option<Vec<Instance>> {
        let (_, columns) = self.rows.iter().find(|(known, _)| known == name)?;
        Some(self.rows_of(columns))
    }

    /// Its embers.
    pub fn embers(&self) -> Vec<Instance> {
        self.embers
            .map_or_else(Vec::new, |columns| self.rows_of(&columns))
    }

    fn rows_of(&self, columns: &[usize; FIELDS]) -> Vec<Instance> {
        let columns = columns.map(|at| &self.columns[at]);
        (0..columns[0].numbers.len())
            .map(|row| columns.map(|column| column.value(row)))
            .collect()
    }

    /// Its scene.
    ///
    /// # Errors
    /// A value that a table refuses.
    pub fn scene(&self) -> Result<Scene, String> {
        let mut scene = Scene::new(self.parameters()?);
        for solid in &self.solids {
            let mut fields = vec![("kind", Input::Text("solid"))];
            let values = solid.iter();
            fields.extend(values.map(|(name, value)| (name.as_str(), Input::Text(value))));
            scene
                .add(&fields)
                .map_err(|refusals| format!("{refusals:?}"))?;
        }
        Ok(scene)
    }

    /// Its values, read by the table.
    ///
    /// # Errors
    /// A value that the table refuses.
    pub fn parameters(&self) -> Result<Parameters, String> {
        let mut parameters = Parameters::default();
        let values = self.values.iter();
        parameters
            .set_all(values.map(|(id, value)| (id.as_str(), Input::Text(value))))
            .map_err(|refusals| format!("{refusals:?}"))?;
        Ok(parameters)
    }

    /// The file.
    pub fn write(&self) -> Vec<u8> {
        let mut head = format!("{FIRST_LINE}\ntime {}\n", self.time);
        for (id, value) in &self.values {
            head += &format!("value {id} {value}\n");
        }
        for solid in &self.solids {
            head += "solid";
            for (name, value) in solid {
                head += &format!(" {name} {}", value.replace(' ', ";"));
            }
            head += "\n";
        }
        let mut body = Vec::new();
        for column in &self.columns {
            let Column {
                least,
                most,
                numbers,
            } = column;
            head += &format!("column {} {least} {most}\n", numbers.len());
            if !column.is_even() {
                body.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
            }
        }
        let words = |columns: &[usize; FIELDS]| columns.map(|at| at.to_string()).join(" ");
        for (name, columns) in &self.rows {
            head += &format!("rows {name} {}\n", words(columns));
        }
        if let Some(columns) = &self.embers {
            head += &format!("embers {}\n", words(columns));
        }
        head += LAST_LINE;
        head += "\n";
        [head.into_bytes(), body].concat()
    }

    /// Reads a file.
    ///
    /// # Errors
    /// A message about what is wrong with it.
    pub fn read(file: &[u8]) -> Result<Snapshot, String> {
        let mut snapshot = Snapshot::default();
        let mut rest = file;
        let mut lengths = Vec::new();
        let mut first = true;
        loop {
            let end = rest.iter().position(|&byte| byte == b'\n');
            let (line, after) = rest.split_at(end.ok_or("its head does not end")?);
            rest = &after[1..];
            let line = std::str::from_utf8(line).map_err(|error| error.to_string())?;
            let (word, rest_of_line) = line.split_once(' ').unwrap_or((line, ""));
            let bad = || format!("an unknown or incomplete line: {line}");
            match word {
                _ if first => {
                    if line != FIRST_LINE {
                        return Err(format!("no snapshot of this form: {line}"));
                    }
                    first = false;
                }
                "time" => snapshot.time = rest_of_line.parse().map_err(|_| bad())?,
                "value" => {
                    let (id, value) = rest_of_line.split_once(' ').ok_or_else(bad)?;
                    snapshot.values.push((id.to_owned(), value.to_owned()));
                }
                "solid" => {
                    let words: Vec<&str> = rest_of_line.split(' ').collect();
                    let (pairs, rest) = words.as_chunks::<2>();
                    if !rest.is_empty() {
                        return Err(bad());
                    }
                    let owned =
                        |&[name, value]: &[&str; 2]| (name.to_owned(), value.replace(';', " "));
                    snapshot.solids.push(pairs.iter().map(owned).collect());
                }
                "column" => {
                    let mut words = rest_of_line.split(' ');
                    let mut next = || words.next().ok_or_else(bad);
                    let length: usize = next()?.parse().map_err(|_| bad())?;
                    let least = next()?.parse().map_err(|_| bad())?;
                    let most = next()?.parse().map_err(|_| bad())?;
                    lengths.push(length);
                    snapshot.columns.push(Column {
                        least,
                        most,
                        numbers: Vec::new(),
                    });
                }
                "rows" => {
                    let (name, columns) = rest_of_line.split_once(' ').ok_or_else(bad)?;
                    let columns = columns_of(columns).ok_or_else(bad)?;
                    snapshot.rows.push((name.to_owned(), columns));
                }
                "embers" => snapshot.embers = Some(columns_of(rest_of_line).ok_or_else(bad)?),
                LAST_LINE => break,
                _ => return Err(bad()),
            }
        }
        for (column, length) in snapshot.columns.iter_mut().zip(lengths) {
            if column.is_even() {
                column.numbers = vec![0; length];
                continue;
            }
            let bytes = rest.get(..2 * length).ok_or("its numbers break off")?;
            rest = &rest[2 * length..];
            let pairs = bytes.as_chunks::<2>().0;
            column.numbers = pairs.iter().map(|&pair| u16::from_le_bytes(pair)).collect();
        }
        let all = snapshot.rows.iter().map(|(_, columns)| columns);
        let mut used = all.chain(&snapshot.embers).flatten();
        if used.any(|&at| at >= snapshot.columns.len()) {
            return Err("it names a column that it has not".to_owned());
        }
        Ok(snapshot)
    }
}

/// The numbers of an instance's columns.
fn columns_of(text: &str) -> Option<[usize; FIELDS]> {
    let numbers: Option<Vec<usize>> = text.split(' ').map(|word| word.parse().ok()).collect();
    numbers?.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::Model;

    fn burning(model: Model) -> Simulation {
        let mut parameters = Parameters::new(model);
        let set = parameters.set("ember_rate", Input::Number(500.0));
        assert_eq!(set, Ok(()));
        let mut scene = Scene::new(parameters);
        let solid = [
            ("kind", Input::Text("solid")),
            ("x", Input::Number(0.3)),
            ("material", Input::Text("wood")),
        ];
        assert!(scene.add(&solid).is_ok());
        let mut fire = Simulation::new(scene);
        (0..100).for_each(|_| fire.step());
        fire
    }

    #[test]
    fn snapshots_are_read_as_written() {
        for model in [Model::Classic, Model::Combustion] {
            let fire = burning(model);
            let mut kept = Snapshot::of(&fire);
            kept.keep("fire", &fire);
            let read = Snapshot::read(&kept.write());
            assert_eq!(read.as_ref(), Ok(&kept));
            let changed =
                |of: &Parameters| of.changed().map(|(p, v)| (p.id, v)).collect::<Vec<_>>();
            let parameters = kept.parameters().unwrap_or_default();
            assert_eq!(parameters.model(), model);
            assert_eq!(changed(&parameters), changed(fire.parameters()));
            let solids = |scene: &Scene| scene.solids().cloned().collect::<Vec<_>>();
            let scene = kept.scene().unwrap_or_default();
            assert_eq!(solids(&scene).len(), 1);
            assert_eq!(solids(&scene), solids(fire.scene()));
        }
    }

    #[test]
    fn a_snapshot_has_the_input_of_the_renderer() {
        let fire = burning(Model::Combustion);
        let mut kept = Snapshot::of(&fire);
        kept.keep("fire", &fire);
        let (mut instances, mut embers) = (Vec::new(), Vec::new());
        fire.write_instances(&mut instances);
        fire.write_embers(&mut embers);
        assert!(!instances.is_empty() && !embers.is_empty());
        for (read, given) in [
            (kept.instances("fire").unwrap_or_default(), instances),
            (kept.embers(), embers),
        ] {
            assert_eq!(read.len(), given.len());
            for field in 0..FIELDS {
                let largest = given.iter().map(|row| row[field].abs()).fold(0.0, f32::max);
                for (a, b) in read.iter().zip(&given) {
                    assert!((a[field] - b[field]).abs() <= 2e-5 * largest);
                }
            }
        }
    }

    #[test]
    fn modes_share_common_data() {
        let fire = burning(Model::Combustion);
        let mut kept = Snapshot::of(&fire);
        kept.keep("fire", &fire);
        let once = kept.write().len();
        kept.keep("paper", &fire);
        assert!(kept.write().len() < once + 100);
    }

    #[test]
    fn a_broken_file_is_an_error() {
        let fire = burning(Model::Classic);
        let mut kept = Snapshot::of(&fire);
        kept.keep("fire", &fire);
        let file = kept.write();
        for broken in [&file[..0], &file[1..], &file[..60], &file[..file.len() - 1]] {
            assert!(Snapshot::read(broken).is_err());
        }
    }
}
