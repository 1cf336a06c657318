// The explorer: one state, whose scene is a text; everything on the page follows from it.
import { Desk } from "./desk.js";
import { $, options, tell } from "./page.js";
import * as answers from "./answers.js";
import * as editor from "./editor.js";
import * as form from "./form.js";
import { Elements } from "./elements.js";
import { scans } from "./scans.js";
import { takeAway } from "./takeaway.js";
import { openLink, keepLink } from "./link.js";
import { EXAMPLES, openExample } from "./examples.js";

const desks = { quick: new Desk(), slow: new Desk(), solver: new Desk() };
export const state = { text: "", models: ["gw", "ke", "jg", "persson-fudge"], load: "", unit: "N", view: "area-fraction", scan: null, random: null };
const page = { shown: null, materials: [], rows: new Map(), turn: 0, sliding: false };

const root = document.documentElement;
function phase(name, text = name) {
  root.dataset.state = name;
  $("status").textContent = text;
}

const loadKeys = () => ({ text: state.load, unit: state.unit });
const slow = (id) => page.shown?.models.find((model) => model.id === id)?.slow ?? false;
const chosen = () => state.models.filter((id) => page.shown.models.some((model) => model.id === id && !model.reason));

// Work of one change of the state; a later change ends it.
async function work(task) {
  const turn = ++page.turn;
  const current = () => turn === page.turn;
  phase("busy");
  try {
    await task(current);
  } catch (error) {
    if (!current()) return;
    if (error.field === "load") answers.refuseLoad(error.message);
    else tell(error.message);
  }
  if (current()) await keepLink(desks.quick, state);
  if (current()) phase(page.shown?.error ? "failed" : "ready", page.shown?.error ? "the scene has an error" : "ready");
}

// Another text of the scene.
export function setScene(text) {
  state.text = text;
  editor.write(text);
  return work(async (current) => {
    desks.slow.show(text).catch(() => {});
    desks.solver.show(text).catch(() => {});
    const shown = await desks.quick.show(text);
    if (!current()) return;
    page.shown = shown;
    page.rows.clear();
    form.fill(shown, edit, page.materials);
    form.mark(shown.error, shown.findings);
    editor.number(shown.error);
    answers.findings(shown.error ? [] : shown.findings);
    if (shown.error) return answers.table([], []);
    tell("");
    answers.views(shown.views, state.view);
    state.view = $("view").value;
    if (chosen().length === 0) state.models = shown.models.filter((model) => !model.reason && !model.slow).slice(0, 3).map((model) => model.id);
    answers.models(shown.models, chosen(), setModels);
    answers.numbers(shown.numbers);
    takeaway.models(shown.models, chosen());
    elements.allow(shown.scan);
    surface.show(Boolean(shown.scan));
    await answer(current, state.load ? { ...loadKeys() } : { position: 0.6, unit: state.unit });
  });
}

// Values at the load, curves and findings; those of slow models follow.
async function answer(current, load) {
  const ids = chosen();
  const parts = [[desks.quick, ids.filter((id) => !slow(id))], [desks.slow, ids.filter(slow)]];
  const rows = new Map();
  let views = [];
  for (const [desk, models] of parts) {
    if (models.length === 0 && (desk !== desks.quick)) continue;
    const found = await desk.call("answer", { models, load });
    if (!current()) return;
    views = found.views;
    found.rows.forEach((row) => rows.set(row.model, row));
    if (desk === desks.quick) {
      state.load = found.load.text;
      answers.load(found.load, load.position === undefined);
      elements.showNear();
      load = loadKeys();
    }
    answers.table(views, ids.filter((id) => rows.has(id)).map((id) => rows.get(id)));
    const missing = models.filter((id) => !page.rows.has(id));
    if (missing.length) {
      const curve = await desk.call("curve", { models: missing });
      if (!current()) return;
      page.head = curve.head;
      Object.entries(curve.rows).forEach(([id, text]) => page.rows.set(id, text));
    }
    await draw(current);
    if (current() && models !== ids && parts[1][1].length) phase("busy", "slow models");
  }
  const found = await desks.quick.call("check", { models: ids.filter((id) => !slow(id)), load });
  if (!current()) return;
  answers.findings(found);
  form.mark(null, found);
}

async function draw(current) {
  const ids = chosen().filter((id) => page.rows.has(id));
  const rows = ids.map((id) => page.rows.get(id));
  const svg = await desks.quick.call("draw", { rows, view: state.view, load: loadKeys(), solved: elements.points(state.view) });
  if (current()) answers.curve(svg, ids, $("view").selectedOptions[0]?.textContent ?? "");
}

// Changes of the text by paths; a material replaces the numbers of its body.
async function edit(changes, body) {
  try {
    await setScene(await desks.quick.call(body === undefined ? "edit" : "material", { text: state.text, changes, body }));
  } catch (error) {
    tell(error.message);
  }
}

function setModels(ids) {
  state.models = ids;
  $("model-box").querySelector("summary").textContent = `Models: ${ids.join(", ")}`;
  takeaway.models(page.shown.models, chosen());
  work((current) => answer(current, loadKeys()));
}

const elements = new Elements(desks.solver, () => work(draw));
const surface = scans({ desks, state, setScene });
const takeaway = takeAway({ desks, state, page, loadKeys, chosen });

// While the slider moves, one answer is under way and the last place waits.
async function slide() {
  page.place = $("slider").value;
  if (page.sliding || page.shown?.error) return;
  page.sliding = true;
  while (page.place !== undefined) {
    const position = Number(page.place);
    page.place = undefined;
    await work((current) => answer(current, { position, unit: state.unit }));
  }
  page.sliding = false;
}

$("slider").addEventListener("input", slide);
$("load").addEventListener("change", () => {
  state.load = $("load").value.trim();
  work((current) => answer(current, loadKeys()));
});
$("unit").addEventListener("change", () => {
  state.unit = $("unit").value;
  work((current) => answer(current, { position: Number($("slider").value), unit: state.unit }));
});
$("view").addEventListener("change", () => {
  state.view = $("view").value;
  work(draw);
});
$("way").addEventListener("change", async () => {
  const way = $("way").value;
  try {
    await setScene(await desks.quick.call("surface", { text: state.text, way }));
  } catch (error) {
    $("way").value = page.shown.way;
    tell(error.message);
  }
});
$("solve").addEventListener("click", () => elements.solve([]));
$("solve-load").addEventListener("click", async () => {
  const { load } = await desks.quick.call("answer", { models: [], load: loadKeys() });
  elements.solve([load.pascals]);
});
$("example").addEventListener("change", () => example($("example").value));

async function example(name) {
  try {
    await openExample(name, { desks, state, setScene });
    if (page.shown?.scan && !page.shown.scan.refused) elements.solve([]);
  } catch (error) {
    tell(error.message);
  }
}

async function start() {
  if (typeof WebAssembly !== "object") {
    phase("failed");
    return tell("This browser has no WebAssembly: use another browser, or the program asperity.");
  }
  editor.editor(setScene);
  options($("example"), EXAMPLES);
  try {
    page.materials = await desks.quick.call("materials");
  } catch (error) {
    phase("failed");
    return tell(`The module could not be loaded: ${error.message}. Reload the page.`);
  }
  const open = () => openLink({ desks, state, setScene, slider: () => ($("unit").value = state.unit) });
  addEventListener("hashchange", open);
  const refused = await open();
  if (refused === "") return;
  await example(EXAMPLES[0][0]);
  if (refused) tell(refused);
}

start();
