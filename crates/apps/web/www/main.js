// The explorer: one state, whose scene is a text; everything on the page follows from it.
import { $, lacking, options, readings, tell } from "./page.js";
import { desks, page, report, state, work } from "./state.js";
import { answer, change, describe, edit, redraw, setModels, setScene, setView, typed, typingEnds } from "./scene.js";
import { note, openLink, rest, writeLink } from "./link.js";
import { clear } from "./answers.js";
import { editor, write } from "./editor.js";
import { elements } from "./elements.js";
import { leak, showLeak } from "./leak.js";
import { EXAMPLES, exampleText, openExample, tries } from "./examples.js";
import { scans } from "./scans.js";
import { takeAway } from "./takeaway.js";
import { openTab, tabs } from "./tabs.js";

// A scene with another surface or a typed text is no longer the example that it started from.
const ownScene = () => tries(null);

function loads() {
  const moved = (keys, kind) => {
    note(kind);
    return answer(keys);
  };
  $("slider").addEventListener("input", () => moved({ position: $("slider").valueAsNumber }, "slide"));
  $("slider").addEventListener("change", () => {
    writeLink();
    rest();
  });
  $("load").addEventListener("change", () => {
    moved({ text: $("load").value.trim(), unit: $("unit").value }, "load");
    writeLink();
  });
  // The same load in the other unit.
  $("unit").addEventListener("change", () => {
    moved({ text: state.load, show: $("unit").value }, "load");
    writeLink();
  });
}

function surfaces() {
  $("way").addEventListener("change", () => {
    const way = $("way").value;
    change((text) => describe(text, way).catch((error) => {
      if (page.shown) $("way").value = page.shown.way;
      throw error;
    }));
  });
  scans(ownScene);
}

function boundaryElements() {
  Object.assign(elements, { changed: redraw, edit });
  leak(edit);
  $("solve").addEventListener("click", () => elements.solve(true));
  $("solve-load").addEventListener("click", () => elements.solve(false));
  $("stop").addEventListener("click", () => elements.stop());
}

function fail(message) {
  page.failure = message;
  report();
  tell(message);
}

async function open() {
  const { opened, message } = await openLink(setScene);
  showLeak();
  if (opened) tries(state.example);
  if (message) tell(message);
  return { opened, message };
}

async function start() {
  // The address holds the state of the page: it does not become that of a place.
  $("to-answers").addEventListener("click", (event) => {
    event.preventDefault();
    $("answer").scrollIntoView();
    $("answer").focus({ preventScroll: true });
  });
  addEventListener("pointerdown", ({ target }) => { if (!$("model-box").contains(target)) $("model-box").open = false; });
  $("model-box").addEventListener("keydown", ({ key }) => {
    if (key !== "Escape") return;
    $("model-box").open = false;
    $("model-box").firstElementChild.focus();
  });
  tabs();
  clear("");
  if (lacking()) return fail(lacking());
  $("first-warning").addEventListener("click", () => {
    openTab("findings");
    $("tab-findings").focus();
  });
  // A surface of the user is no example any more.
  $("surface-fields").addEventListener("change", () => work("page", null, ownScene));
  editor((text) => {
    ownScene();
    typed(text);
  }, typingEnds);
  options($("example"), [["", "open …"], ...EXAMPLES]);
  $("example").addEventListener("change", () => {
    const name = $("example").value;
    // The same one can be opened again.
    $("example").value = "";
    if (name) openExample(name);
  });
  $("view").addEventListener("change", () => setView($("view").value));
  readings($("curve"), $("reading"));
  loads();
  surfaces();
  boundaryElements();
  takeAway.start();
  $("scene").addEventListener("blur", rest);
  try {
    page.form = await desks.quick.sure(() => desks.quick.call("form"));
  } catch (error) {
    fail(error.message);
    return write(await exampleText(EXAMPLES[0][0]));
  }
  addEventListener("popstate", open);
  const { opened, message } = await open();
  if (!opened) await openExample(EXAMPLES[0][0], "open");
  await work("page", null, async () => message && tell(message));
  page.opened = true;
  report();
}

start();
