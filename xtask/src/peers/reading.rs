//! What is known of a code that is installed, and what one run of either side tells.

use std::path::PathBuf;

use serde_json::Value;

use super::program::Ran;

/// A code that is installed.
pub struct Found {
    pub program: PathBuf,
    pub version: String,
}

/// What one run tells.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    pub answers: Vec<f64>,
    /// By the clock, in the unit of the comparison.
    pub cost: f64,
    /// The same of the processor.
    pub processor: Option<f64>,
    /// The most memory \[MB\].
    pub memory: Option<f64>,
    /// Memory of the model by node, where that is what is compared.
    pub bytes: Option<f64>,
}

impl Reading {
    /// Of a whole program, from its start to its end \[s\].
    pub fn of_program(ran: Ran, answers: Vec<f64>) -> Self {
        Self { answers, cost: ran.seconds, processor: ran.processor, memory: ran.memory, bytes: None }
    }

    /// Of the line of JSON that a program of ours or a script ends with: answers, cost, where it has them processor and bytes.
    pub fn of_line(ran: &Ran) -> Result<Self, String> {
        let said = line_of_json(&ran.output)?;
        Ok(Self {
            answers: answers(&said)?,
            cost: said["cost"].as_f64().ok_or_else(|| format!("no cost in {said}"))?,
            processor: said["processor"].as_f64(),
            memory: ran.memory,
            bytes: said["bytes"].as_f64(),
        })
    }
}

/// The last line of JSON of what a program printed.
pub fn line_of_json(output: &str) -> Result<Value, String> {
    let line = output.lines().rfind(|line| line.starts_with('{')).ok_or("it printed no line of JSON")?;
    serde_json::from_str(line).map_err(|error| format!("{line}: {error}"))
}

/// The numbers `answers` of such a line.
pub fn answers(said: &Value) -> Result<Vec<f64>, String> {
    let numbers = said["answers"].as_array().map(|all| all.iter().filter_map(Value::as_f64).collect());
    numbers.ok_or_else(|| format!("no answers in {said}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_json_is_read_after_whatever_else_is_printed() {
        let ran = |output: &str| Ran {
            seconds: 9.0,
            processor: None,
            memory: Some(5.0),
            output: output.to_owned(),
        };
        let text = "hello\n{ \"answers\": [1.5, 2], \"cost\": 3, \"processor\": null, \"bytes\": 8 }\n";
        let reading = Reading::of_line(&ran(text)).unwrap();
        assert_eq!((reading.answers, reading.cost, reading.processor), (vec![1.5, 2.0], 3.0, None));
        assert_eq!((reading.memory, reading.bytes), (Some(5.0), Some(8.0)));
        assert!(Reading::of_line(&ran("nothing\n")).is_err() && Reading::of_line(&ran("{}\n")).is_err());
    }
}
