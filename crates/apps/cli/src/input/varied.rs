//! A number of the scene with several values: `hardness=1GPa:4GPa:4`.

use std::str::FromStr;

use asperity::{nearest_hint, nearest_name};
use asperity_scene::{KEYS, Key, key_of_input, quantity_of};

use crate::input::lists::Numbers;

/// A number of the scene by its name, and its values.
#[derive(Debug, Clone, PartialEq)]
pub struct Varied {
    pub name: String,
    pub values: Vec<f64>,
}

impl FromStr for Varied {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let Some((name, values)) = text.split_once('=') else {
            return Err("write KEY=A:B:N or KEY=v,v, for example hardness=1GPa:4GPa:4".into());
        };
        let name = name.trim();
        if Key::find("", key_of_input(name)).is_none() {
            let near = nearest_name(name, KEYS.iter().map(|key| key.name));
            return Err(format!("{name} is no key of a scene{}", nearest_hint(near)));
        }
        let number = |text: &str| quantity_of(key_of_input(name), text);
        let Numbers(values) = Numbers::read(values, &number)?;
        Ok(Self { name: name.into(), values })
    }
}
