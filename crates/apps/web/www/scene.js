// From the text of the scene to everything that the page shows of it.
import { $, noPicture, tell, typing } from "./page.js";
import { answers, ask, chosen, desks, files, isSlow, missing, page, report, state, work } from "./state.js";
import { note, writeLink } from "./link.js";
import * as blocks from "./answers.js";
import * as editor from "./editor.js";
import * as form from "./form.js";
import { elements } from "./elements.js";
import { reportScan, showReport } from "./scan-report.js";
import { takeAway } from "./takeaway.js";

// The place of the slider for a scene without a load.
const USUAL = 0.6;

// Another text of the scene; `kind` names what the user did, for the history.
export function setScene(text, kind = "edit") {
  state.text = text;
  page.old = true;
  editor.write(text);
  note(kind);
  forgive();
  return work("page", "scene", showScene);
}

// Another scene may succeed where the last one did not.
const forgive = () => Object.values(desks).forEach((desk) => desk.forgive());

// What follows whenever the page shows other values.
const followers = [];
export const shownAgain = (follow) => followers.push(follow);

// A change of the text by `make`, after the changes before it: none is lost. What is typed
// meanwhile is kept, and changed too.
export function change(make, kind) {
  return work("page", null, async () => {
    let [text, made] = [];
    do {
      text = state.text;
      made = await make(text);
    } while (state.text !== text);
    setScene(made, kind);
  });
}

const tools = (call, keys) => desks.quick.sure(() => desks.quick.call(call, keys));

// Changes by paths; whether the other surface is another one than the first.
export const edit = (changes, another = false) => change((text) => tools("edit", { text, changes, another }));

async function showScene() {
  const text = state.text;
  try {
    await show(text);
  } finally {
    page.old = state.text !== text;
  }
}

async function show(text) {
  try {
    Object.assign(page, { shown: await desks.quick.sure(() => desks.quick.show(text)), text, failure: "", refused: "" });
  } catch (error) {
    Object.assign(page, { shown: null, text, failure: error.message });
    elements.of("");
    clear("The calculation failed.");
    throw error;
  } finally {
    page.rows.clear();
    page.values.clear();
    Object.assign(page, { load: null, best: null, answered: "", undescribed: "" });
  }
  const { shown } = page;
  elements.of(JSON.stringify([text, shown.files.map((name) => files.get(name)?.checksum)]));
  form.fill(shown, edit, page.form);
  form.mark(shown.error, shown.findings);
  editor.number(shown.error);
  takeAway.files(shown.files);
  blocks.views(shown.views, state.view);
  writeLink();
  if (shown.error) {
    // What a link restores stays, also without its scan.
    blocks.keep(state);
    return clear(missing() ? `The scene needs the scan ${missing()}: choose or drop that file.` : "The scene has an error: correct it to see its curves.");
  }
  tell("");
  state.view = $("view").value;
  if (chosen().length === 0) state.models = shown.models.filter((model) => !model.reason && !model.slow).slice(0, 3).map((model) => model.id);
  blocks.models(shown.models, chosen(), setModels);
  blocks.numbers(shown.numbers);
  takeAway.models(chosen());
  elements.allow(shown.scan);
  showReport(Boolean(shown.scan));
  await values(state.load ? { text: state.load } : { position: USUAL });
  reportScan();
}

// The surface described in another way.
export const describe = (text, way) => desks.quick.ask(text, "surface", { text, way });

// Nothing of another scene stays on the page.
function clear(why) {
  Object.assign(page, { load: null, best: null, drawn: "" });
  blocks.clear(why);
  elements.allow(null);
  showReport(false);
  takeAway.models([]);
  followers.forEach((follow) => follow());
}

// The values at another load, after those of the load before.
export const answer = (load) => work("page", "answer", () => values(load));

async function values(keys) {
  if (!answers()) return;
  const ids = chosen();
  const models = ids.filter((id) => !isSlow(id));
  let found;
  try {
    found = await ask(desks.quick, "answer", { models, load: keys, solved: elements.known() });
  } catch (error) {
    if (error.field !== "load") throw error;
    return refuse(error.message, keys);
  }
  const { rows } = found;
  if (rows.some(({ reason }) => !reason)) page.answered = found.load.text;
  // Slow models are still to answer.
  else if (rows.length > 0 && ids.length === models.length) return refuse(blocks.commonRefusal(rows), keys);
  Object.assign(page, { load: found.load, refused: "" });
  state.load = found.load.text;
  blocks.load(found.load, keys.position === undefined);
  elements.showNear();
  Object.assign(page, { values: new Map(rows.map((row) => [row.model, row])), best: found.answer });
  page.undescribed = ids.length > models.length ? "" : blocks.undescribed(rows);
  table();
  await curves(desks.quick, models);
  await draw();
  blocks.findings(found.findings);
  form.mark(null, found.findings);
  takeAway.code();
  if (ids.length > models.length) work("slow", "values", () => slowValues(page.shown, keys));
}

// A load that no chosen model answers: the values of the load before stay, dimmed.
// The answer at the load before may have come, and changed the field, since this one was typed.
async function refuse(message, keys, typed = keys.text) {
  if (page.load || keys.position !== undefined) page.refused = message;
  if (page.load) return blocks.refuseLoad(message, typed);
  if (page.refused) return clear(message);
  // A load that a link brought: the scene is shown at another.
  await values({ position: USUAL });
  tell(message);
}

// Slow models refuse a load that is shown, as the others did: back to the one before.
async function withdraw(load, message, keys) {
  if (state.load !== load) return;
  if (page.answered) await values({ text: page.answered });
  else page.load = null;
  await refuse(message, keys, load);
  writeLink();
}

// The rows of curves that are not there yet.
async function curves(desk, models) {
  const missing = models.filter((id) => !page.rows.has(id));
  if (missing.length === 0) return;
  const rows = await ask(desk, "curve", { models: missing });
  Object.entries(rows).forEach(([id, text]) => page.rows.set(id, text));
}

// Models whose laws take seconds, in a worker of their own: they appear when they are ready.
async function slowValues(shown, keys) {
  const current = () => page.shown === shown;
  const models = chosen().filter(isSlow);
  if (!current() || models.length === 0) return;
  const load = state.load;
  const found = await ask(desks.slow, "answer", { models, load: { text: load }, solved: elements.known() });
  if (!current()) return;
  // A later load has a piece of its own.
  if (state.load === load) {
    found.rows.forEach((row) => page.values.set(row.model, row));
    const rows = chosen().map((id) => page.values.get(id)).filter(Boolean);
    if (rows.every(({ reason }) => reason)) return work("page", null, () => withdraw(load, blocks.commonRefusal(rows), keys));
    page.answered = load;
    // A refused load keeps its reason.
    if (!page.refused) page.undescribed = blocks.undescribed(rows);
    table();
  }
  await curves(desks.slow, models);
  if (!current()) return page.rows.clear();
  work("page", "draw", draw);
  if (state.load === load) blocks.addFindings(found.findings);
}

// The values of models, and of boundary elements where they are solved at this load.
function table() {
  const about = (id) => page.shown.models.find((model) => model.id === id)?.about ?? id;
  if (page.load) {
    blocks.answer(page.best, Boolean(state.example));
    blocks.table(page.shown.views, chosen(), page.values, page.best, about);
  }
  followers.forEach((follow) => follow());
}

// Boundary elements were solved at a load: at that of the page they are the answer.
export function redraw(pascals) {
  if (pascals === page.load?.pascals && !page.refused) return answer({ text: state.load });
  table();
  return work("page", "draw", draw);
}

async function draw() {
  if (!answers() || !page.load) return;
  const { view } = state;
  const [ids, solved] = [chosen().filter((id) => page.rows.has(id)), elements.points(view)];
  const rows = ids.map((id) => page.rows.get(id));
  try {
    if (rows.length + solved.length === 0 && chosen().length > 0) {
      withoutCurves("Being calculated.");
    } else {
      const outside = ids.filter((id) => page.values.get(id)?.outside);
      const keys = { rows, view, load: { text: state.load }, solved, outside };
      page.picture = (size) => ask(desks.quick, "draw", { ...keys, size });
      // As large as its place, so that letters keep their size.
      const { clientWidth, clientHeight } = $("curve");
      const svg = await page.picture([clientWidth, clientHeight]);
      blocks.curve(svg, ids, $("view").selectedOptions[0]?.textContent ?? "");
      page.drawn = view;
    }
  } catch (error) {
    // No model has the quantity: the place of the curves says so, with the reason of the first.
    if (error.field !== "view") throw error;
    const reasons = ids.map((id) => page.values.get(id)?.cells.find(({ quantity, digits }) => quantity === view && digits === undefined)?.shown);
    withoutCurves([error.message, ...reasons.filter(Boolean).slice(0, 1)].join("; "));
  }
  followers.forEach((follow) => follow());
}

// Another width of the page has another picture.
addEventListener("resize", () => work("page", "draw", draw));

// The place of the curves says why there are none.
function withoutCurves(why) {
  page.drawn = "";
  noPicture($("curve"), why);
}

export function setModels(ids) {
  takeAway.pick(ids.find((id) => !state.models.includes(id)));
  state.models = ids;
  // The load before was answered by other models.
  page.answered = "";
  note("models");
  takeAway.models(chosen());
  // Other models may answer a load that was refused.
  answer(page.refused ? { text: $("load").value.trim(), unit: $("unit").value } : { text: state.load });
  writeLink();
}

export function setView(view) {
  state.view = $("view").value = view;
  note("view");
  followers.forEach((follow) => follow());
  work("page", "draw", draw);
  writeLink();
}

// Typed text of the scene is shown after a pause; it counts at once.
export function typed(text) {
  state.text = text;
  Object.assign(page, { typing: true, old: true });
  report();
}

export function typingEnds() {
  page.typing = false;
  note("type");
  typing.delete($("scene"));
  forgive();
  return work("page", "scene", showScene);
}
