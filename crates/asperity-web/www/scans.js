// Scans: chosen, dropped or made here.
import { $, download, element, tell } from "./page.js";
import { answers, desks, files, page, state, work } from "./state.js";
import { setScene, shownAgain } from "./scene.js";
import { given as askedFor } from "./link.js";

const RANDOM = [
  ["pixels", "Pixels on a side", "256"],
  ["side", "Length of a side", "200 um"],
  ["longest", "Longest wave", "50 um"],
  ["shortest", "Shortest wave", "6.25 um"],
  ["hurst", "Hurst exponent", "0.8"],
  ["sq", "Sq", "0.4 um"],
  ["seed", "Seed", "1"],
];

// Makes a file of the computer, or a random surface, the surface of a text: the text and the scan.
export async function useScan(text, { file, typed }) {
  const given = typed ? { keys: typed } : { file };
  const { name, checksum } = await desks.quick.hand(file?.name ?? "", given);
  // A file that cannot be read takes no other's place.
  await desks.quick.call("usable", { name, kept: answers() && page.shown.scan ? text : null });
  const { name: named, message } = askedFor({ name, checksum });
  files.set(named, Object.assign(given, { checksum }));
  const made = await desks.quick.call("use-scan", { text, name: named });
  return { text: made, scan: { name: named, checksum }, random: given.keys ?? null, message };
}

export const usualRandom = () => Object.fromEntries(RANDOM.map(([key, , value]) => [key, value]));
const typedRandom = () => Object.fromEntries(RANDOM.map(([key]) => [key, $(`random-${key}`).value]));

// The scene before a file with which it has an error.
let before = null;
shownAgain(() => { if (answers()) before = null; });

// A file that cannot be used leaves the last scene that has values where it was.
async function used(source) {
  for (;;) {
    const { text } = state;
    try {
      const found = await useScan(text, source);
      if (state.text === text) return found;
    } catch (error) {
      if (!before || !page.shown?.error) throw error;
      const { text, scan, random } = before;
      Object.assign(state, { scan, random });
      setScene(text, "scan").then(() => tell(error.message));
      return null;
    }
  }
}

function use(source, changed) {
  tell("");
  return work("page", null, async () => {
    const found = await used(source);
    if (!found) return;
    const { scan, random, message } = found;
    if (answers()) before = { text: state.text, scan: state.scan, random: state.random };
    const text = state.example ? await desks.quick.call("changed", { text: found.text }) : found.text;
    Object.assign(state, { scan, random });
    changed();
    const shown = setScene(text, "scan");
    if (message && !random) shown.then(() => tell(message));
  });
}

// `changed` follows when the surface of the scene becomes another.
export function scans(changed) {
  $("random-fields").append(...RANDOM.map(([key, label, value]) => {
    const input = element("input", { id: `random-${key}`, type: "text", value });
    return element("div", { className: "row" }, element("label", { htmlFor: input.id }, label), input);
  }));
  $("scan").addEventListener("change", () => {
    const [file] = $("scan").files;
    // The same file can be chosen again.
    $("scan").value = "";
    if (file) use({ file }, changed);
  });
  const drop = $("drop");
  addEventListener("dragover", (event) => { event.preventDefault(); drop.classList.add("over"); });
  addEventListener("dragleave", () => drop.classList.remove("over"));
  addEventListener("drop", (event) => {
    event.preventDefault();
    drop.classList.remove("over");
    const [file] = event.dataTransfer.files;
    if (file) use({ file }, changed);
  });
  $("make-random").addEventListener("click", () => use({ typed: typedRandom() }, changed));
  $("save-scan").addEventListener("click", () => work("page", null, async () => {
    const [name] = page.shown?.files ?? [];
    if (name) download(name, new Blob([await desks.quick.file(page.text, name)]), "application/octet-stream");
  }));
}
