// The state of the page in its address, so that a copied link, back and forward restore all of it.
import { $, tell } from "./page.js";

let written = "";

// Writes the state behind the address, without a new entry in the history.
export async function keepLink(desk, state) {
  const { text, models, load, view, scan, random } = state;
  try {
    const link = await desk.call("link", { state: { scene: text, models, load, view, scan, random } });
    written = `#s=${link}`;
    history.replaceState(null, "", written);
  } catch {
    // The address stays as it is; the page goes on.
  }
}

// Opens the state of the address; the message of a link that was not opened, null without a link.
export async function openLink({ desks, state, setScene, slider }) {
  const hash = location.hash;
  if (!hash.startsWith("#s=") || hash === written) return null;
  try {
    const found = await desks.quick.call("unlink", { link: hash.slice(3) });
    const { scene, models, load, view, scan, random } = found;
    Object.assign(state, { models, load, view, scan, random });
    state.unit = load.trim().endsWith("Pa") ? "Pa" : "N";
    slider();
    written = hash;
    if (random) await Promise.all(Object.values(desks).map((desk) => desk.hand("", { keys: random })));
    await setScene(scene);
    if (scan && !random && !desks.quick.files.has(scan.name)) {
      tell(`The link was made with the scan ${scan.name} (checksum ${scan.checksum}), which it does not contain: choose or drop that file.`);
    }
    return "";
  } catch (error) {
    tell(error.message);
    return error.message;
  }
}
