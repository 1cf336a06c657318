// Scans: chosen, dropped or made here.
import { $, element, options, picture, tell } from "./page.js";

const LARGEST = 512 * 1024 * 1024;
const RANDOM = [
  ["pixels", "Pixels on a side", "256"],
  ["side", "Length of a side", "200 um"],
  ["longest", "Longest wave", "50 um"],
  ["shortest", "Shortest wave", "6.25 um"],
  ["hurst", "Hurst exponent", "0.8"],
  ["sq", "Sq", "0.4 um"],
  ["seed", "Seed", "1"],
];
const NUMBERS = ["pixels", "hurst", "seed"];

export const randomKeys = () => Object.fromEntries(RANDOM.map(([key, , value]) => [key, NUMBERS.includes(key) ? Number(value) : value]));

export function scans({ desks, state, setScene }) {
  const all = Object.values(desks);
  $("random-fields").append(...RANDOM.map(([key, label, value]) => {
    const input = element("input", { id: `random-${key}`, type: "text", value });
    return element("div", { className: "row" }, element("label", { htmlFor: input.id }, label), input);
  }));

  async function use(name, scan, random) {
    const asked = state.scan;
    Object.assign(state, { scan, random });
    // The file that the scene already names.
    const named = desks.quick.text && state.text.includes(JSON.stringify(name));
    const text = named ? state.text : await desks.quick.call("use-scan", { text: state.text, name });
    await setScene(text);
    if (asked && asked.name === name && asked.checksum !== scan.checksum) {
      tell(`${name} is not the file of the link: its checksum is ${scan.checksum}, that of the link ${asked.checksum}.`);
    }
  }

  async function take(file) {
    tell("");
    try {
      if (file.size > LARGEST) throw new Error(`${file.name} is larger than 512 MB: use the program, asperity surface.`);
      const bytes = await file.arrayBuffer();
      const { name, checksum } = await desks.quick.hand(file.name, { bytes });
      await Promise.all([desks.slow, desks.solver].map((desk) => desk.hand(name, { bytes })));
      await use(name, { name, checksum }, null);
    } catch (error) {
      tell(`${file.name}: ${error.message}`);
    }
  }

  async function make(keys) {
    const made = await Promise.all(all.map((desk) => desk.hand("", { keys })));
    await use(made[0].name, made[0], keys);
  }

  $("scan").addEventListener("change", () => $("scan").files[0] && take($("scan").files[0]));
  const drop = $("drop");
  addEventListener("dragover", (event) => { event.preventDefault(); drop.classList.add("over"); });
  addEventListener("dragleave", () => drop.classList.remove("over"));
  addEventListener("drop", (event) => {
    event.preventDefault();
    drop.classList.remove("over");
    if (event.dataTransfer.files[0]) take(event.dataTransfer.files[0]);
  });
  $("make-random").addEventListener("click", async () => {
    const value = ([key]) => [key, NUMBERS.includes(key) ? Number($(`random-${key}`).value) : $(`random-${key}`).value];
    try {
      await make(Object.fromEntries(RANDOM.map(value)));
      tell("");
    } catch (error) {
      tell(error.message);
    }
  });

  // The report of the scene's scan.
  async function show(there) {
    $("scan-report").hidden = !there;
    if (!there) return;
    try {
      const { svg, scales } = await desks.slow.call("scan");
      picture($("scan-picture"), svg, "map of the heights, their distribution and their spectra");
      const heads = Object.keys(scales[0] ?? {});
      const head = element("tr", {}, ...heads.map((name) => element("th", { scope: "col" }, name.replaceAll("_", " "))));
      $("scales").replaceChildren(element("caption", {}, "Moments at several point distances"), head,
        ...scales.map((row) => element("tr", {}, ...heads.map((name) => element("td", {}, String(row[name] ?? "–"))))));
    } catch (error) {
      $("scan-report").hidden = true;
    }
  }

  return { show, make };
}
