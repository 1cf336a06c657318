// Scans and scene files: chosen, dropped or made here.
import { $, download, element, tell } from "./page.js";
import { answers, desks, files, page, state, work } from "./state.js";
import { edit, setScene, shownAgain } from "./scene.js";
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

// Bytes of a file in which a scene has its surface.
const HEAD = 100000;
// Fields of a scene that a scan which cannot be used has errors at.
const OF_FILE = ["surface.file", "surface.max_missing"];

// The name in a scene of a file of the computer, without its folders there.
const nameIn = (names, { name }) => names.find((one) => one.split(/[\\/]/).pop() === name);

// Makes a file of the computer, or a random surface, the surface of a text: the text and the scan.
export async function useScan(text, { file, typed }) {
  const given = typed ? { keys: typed } : { file };
  const here = file && nameIn(page.shown?.files ?? [], file);
  const { name: handed, checksum } = await desks.quick.hand(here || (file?.name ?? ""), given);
  const { name, message } = askedFor({ name: handed, checksum });
  const old = files.get(name);
  files.set(name, Object.assign(given, { checksum }));
  try {
    const made = await desks.quick.call("use-scan", { text, name });
    const { error } = await desks.quick.show(made);
    // A file that cannot be read takes no other's place.
    if (OF_FILE.includes(error?.field)) await desks.quick.call("usable", { name });
    return { text: made, scan: { name, checksum }, random: given.keys ?? null, message };
  } catch (error) {
    if (old) files.set(name, old);
    else files.delete(name);
    throw error;
  }
}

// Where many points of the scan are missing, one click uses the others.
shownAgain(() => {
  const [name] = page.shown?.files ?? [];
  if (page.shown?.error?.field !== "surface.max_missing") return;
  const { text } = page;
  work("page", "offer", async () => {
    const offer = await desks.quick.ask(text, "usable", { name });
    if (!offer || text !== page.text) return;
    tell(offer.message);
    const use = () => edit([{ path: "surface.max_missing", value: offer.value }]);
    $("message").lastElementChild.before(" ", element("button", { type: "button", onclick: use }, "Use the measured points"));
  });
});

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

const named = (list) => list.map(({ name }) => name).join(", ");

async function use(source, changed, also = "") {
  const found = await used(source);
  if (!found) return;
  const { text, scan, random, message } = found;
  if (answers()) before = { text: state.text, scan: state.scan, random: state.random };
  Object.assign(state, { scan, random });
  changed();
  const said = [random ? "" : message, also].filter(Boolean).join(" ");
  setScene(text, "scan").then(() => said && tell(said));
}

// Opens a scene file with those of the scans that it names; a scan of another name takes the place
// of the only one that it names.
async function openScene(file, scans, changed) {
  await desks.quick.call("admit", { name: file.name, size: file.size });
  let text = await file.text();
  const { files: names, unreadable } = await desks.quick.show(text);
  if (unreadable) throw new Error(`${file.name}: ${unreadable}`);
  let scan = null;
  const unused = [];
  for (const one of scans) {
    const name = nameIn(names, one);
    if (name) {
      const given = { file: one };
      const { checksum } = await desks.quick.hand(name, given);
      files.set(name, Object.assign(given, { checksum }));
      scan ??= { name, checksum };
    } else if (names.length === 1 && scans.length === 1) ({ text, scan } = await useScan(text, { file: one }));
    else unused.push(one);
  }
  [page.wanted, before] = [null, null];
  Object.assign(state, { load: "", scan, random: null });
  changed();
  setScene(text, "scan").then(() => unused.length > 0 && tell(`${named(unused)}: not used, as ${file.name} does not name it.`));
}

// A scene file is told from a scan by its name or by its text.
const isScene = async (file) => /\.toml$/i.test(file.name) || /^\s*\[surface\]/m.test(await file.slice(0, HEAD).text());

// What was chosen or dropped: a scan, or a scene file with its scans. Nothing is left out in
// silence.
function take(list, changed) {
  if (list.length === 0) return;
  tell("");
  work("page", null, async () => {
    const kinds = await Promise.all(list.map(isScene));
    const scene = list.find((_, k) => kinds[k]);
    const [first, ...rest] = list.filter((file) => file !== scene);
    if (scene) return openScene(scene, first ? [first, ...rest] : [], changed);
    const also = rest.length > 0 && `${first.name} is used, and not ${named(rest)}: choose one scan, or scans with a scene file that names them.`;
    return use({ file: first }, changed, also);
  });
}

// `changed` follows when the surface of the scene becomes another.
export function scans(changed) {
  $("random-fields").append(...RANDOM.map(([key, label, value]) => {
    const input = element("input", { id: `random-${key}`, type: "text", value });
    return element("div", { className: "row" }, element("label", { htmlFor: input.id }, label), input);
  }));
  $("scan").multiple = true;
  $("scan").addEventListener("change", () => {
    const list = [...$("scan").files];
    // The same file can be chosen again.
    $("scan").value = "";
    take(list, changed);
  });
  const drop = $("drop");
  addEventListener("dragover", (event) => { event.preventDefault(); drop.classList.add("over"); });
  addEventListener("dragleave", () => drop.classList.remove("over"));
  addEventListener("drop", (event) => {
    event.preventDefault();
    drop.classList.remove("over");
    take([...event.dataTransfer.files], changed);
  });
  $("make-random").addEventListener("click", () => {
    tell("");
    work("page", null, () => use({ typed: typedRandom() }, changed));
  });
  $("save-scan").addEventListener("click", () => work("page", null, async () => {
    const [name] = page.shown?.files ?? [];
    if (name) download(name, new Blob([await desks.quick.file(page.text, name)]), "application/octet-stream");
  }));
}
