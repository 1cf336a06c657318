//! The desk for JavaScript.
#![allow(unsafe_code, reason = "written by wasm-bindgen")]

use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// A [`Desk`](crate::Desk) whose messages are texts.
#[wasm_bindgen(js_name = Desk)]
#[derive(Default)]
pub struct JsDesk {
    desk: crate::Desk,
}

#[wasm_bindgen(js_class = Desk)]
impl JsDesk {
    /// An empty desk.
    #[must_use]
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// See [`Desk::hand`](crate::Desk::hand).
    pub fn hand(&mut self, name: &str, bytes: Vec<u8>) -> String {
        self.desk.hand(name, bytes)
    }

    /// See [`Desk::call`](crate::Desk::call).
    pub fn call(&mut self, message: &str) -> String {
        self.desk.call(message)
    }

    /// See [`Desk::file`](crate::Desk::file); empty for a file that is not there.
    #[must_use]
    pub fn file(&self, name: &str) -> Vec<u8> {
        self.desk.file(name).unwrap_or_default().to_vec()
    }

    /// See [`Desk::press`](crate::Desk::press).
    pub fn press(&self, pressures: &[f64], leaks: bool, happened: &js_sys::Function) -> String {
        self.desk.press(pressures, leaks, |event| {
            // The page does not answer.
            let _ = happened.call1(&JsValue::NULL, &JsValue::from_str(event));
        })
    }
}
