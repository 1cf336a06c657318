// What the page shows, and the work that is under way.
import { Desk } from "./desk.js";
import { Turns } from "./turns.js";
import { $, tell } from "./page.js";

// The files of the page by name; desks read them when a scene names them.
export const files = new Map();
export const desks = { quick: new Desk(files), slow: new Desk(files), solver: new Desk(files) };

// What a link restores. The load is typed, with its unit; the example is that which the scene
// started from; the leak is whether flows are solved.
export const state = { text: "", models: ["gw", "ke", "jg", "persson-fudge"], load: "", view: "area-fraction", scan: null, random: null, example: null, leak: false };

// Answers of the desks: the scene as read from a text, the load on it, the answer there, the values
// of models, the rows of their curves, the quantity that is drawn and how; why the load was refused or no
// model describes it, the last load that a model answers, and the scan that a link asks for.
export const page = {
  opened: false, typing: false, failure: "", form: null, text: "", shown: null,
  load: null, best: null, drawn: "", picture: null, refused: "", undescribed: "", answered: "", values: new Map(), rows: new Map(), wanted: null, old: false,
};

// The scan without which the scene cannot be shown.
export const missing = () => (page.shown?.error && page.shown.files.find((name) => !files.has(name))) || "";

// The page and its quick models, slow models, and boundary elements each have a lane.
export const turns = new Turns(report);

// The scene has values that follow from a number that cannot be meant.
export const implausible = () => Boolean(page.shown?.implausible);

// The state follows from the work that is under way and from what it found.
export function report() {
  const broken = page.failure || page.refused || page.shown?.error || Object.values(desks).some((desk) => desk.broken);
  const phase = !page.opened && !broken ? "loading" : turns.busy || page.typing ? "busy" : broken ? "failed" : "ready";
  document.documentElement.dataset.state = phase;
  const wrong = page.shown?.error ? (missing() ? `waiting for ${missing()}` : "the scene has an error") : page.refused ? "the load is refused" : "failed";
  $("status").textContent = { loading: "loading", busy: "calculating", failed: wrong, ready: page.undescribed ? "no model describes the load" : implausible() ? "implausible number" : "ready" }[phase];
  // Spoken when the values are there, not at every step of the slider; nothing of another scene or
  // of the load before a refused one.
  const spoken = phase === "failed" || page.old ? "" : phase === "ready" ? page.best?.spoken ?? "" : $("spoken").textContent;
  if ($("spoken").textContent !== spoken) $("spoken").textContent = spoken;
  // Values at the load before a refused one, or of the scene before.
  document.documentElement.toggleAttribute("data-stale", Boolean(page.refused) || page.old);
  // Values of numbers that cannot be meant.
  document.documentElement.toggleAttribute("data-implausible", implausible());
  $("copy-link").disabled = Boolean(page.refused);
  const none = Boolean(page.refused) || !page.load || implausible();
  $("save-values").disabled = none;
  $("save-csv").disabled = none || chosen().length === 0;
  $("save-svg").disabled = $("save-png").disabled = none || !page.drawn;
}

// Runs a piece of work in a lane; an error is shown.
export function work(lane, kind, piece) {
  return turns.add(lane, kind, piece).catch((error) => tell(error.message));
}

export const ask = (desk, call, keys) => desk.ask(page.text, call, keys);
// Whether the scene has models that answer.
export const answers = () => Boolean(page.shown && !page.shown.error);
export const isSlow = (id) => page.shown.models.some((model) => model.id === id && model.slow);
const allowed = (key, id) => page.shown?.models.find((model) => model[key] === id && !model.reason)?.id;
// The chosen models that the scene allows; other asperities than equal ones have variants of their own.
export const chosen = () => [...new Set(state.models.map((id) => allowed("id", id) ?? allowed("equal", id)).filter(Boolean))];
