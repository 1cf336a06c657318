// Boundary elements in a worker of their own, load by load. Stopping ends the worker.
import { $, cell, element, heading, lowered, noPicture, picture, tell } from "./page.js";
import { desks, page, state, work } from "./state.js";

const NO_SCAN = "They need the heights of a surface: drop a scan or make a random surface.";

// Scenes whose solved loads are kept.
const MOST_KEPT = 8;

class Elements {
  solved = [];
  shown = null;
  // The scene of the solved loads, and the loads of scenes before it.
  scene = "";
  kept = new Map();
  edit = () => {};
  // The run under way; events of an older one are not shown.
  run = null;
  // The loads of the run by their pressure, in words.
  wanted = new Map();
  changed = () => {};

  // What the scene allows, after every change of it; null for a scene with an error.
  allow(scan, error = !page.shown || page.shown.error) {
    const refused = error ? "" : scan ? scan.refused : NO_SCAN;
    $("elements-note").textContent = refused ?? `${scan.rows} × ${scan.columns} pixels, solved in this tab.`;
    $("solve").disabled = $("solve-load").disabled = refused !== null || this.run !== null;
    $("contact-box").hidden = !scan;
    if (scan && !this.shown) this.spot(refused ?? "The contact of this scan is not solved yet.", refused === null);
    const fill = () => this.edit([{ path: "surface.fill_missing", value: "true" }]);
    for (const place of refused && scan?.fill ? [$("elements-note"), $("contact").firstElementChild] : []) {
      place.append(" ", element("button", { type: "button", onclick: fill }, "Fill the missing points"));
    }
  }

  // The loads that were solved for this text with these files, and none of another scene.
  of(scene) {
    if (scene === this.scene) return;
    this.kept.delete(this.scene);
    if (this.solved.length > 0) this.kept.set(this.scene, this.solved);
    if (this.kept.size > MOST_KEPT) this.kept.delete(this.kept.keys().next().value);
    this.drop();
    this.scene = scene;
    this.solved = this.kept.get(scene) ?? [];
    if (this.solved.length > 0) this.table();
  }

  drop() {
    this.spot();
    if (this.run) this.stop("");
    [this.solved, this.shown] = [[], null];
    $("solved").hidden = $("solved-notes").hidden = true;
    $("iterations").textContent = "";
  }

  // Solves the present load, with `all` also loads over the range of the slider.
  solve(all) {
    const run = {};
    const { text, shown, load } = page;
    if (!load) return null;
    // The first is solved before the others.
    const others = all ? shown.scan.pressures.filter(([pascals]) => pascals !== load.pascals) : [];
    const wanted = new Map([[load.pascals, load.text], ...others]);
    const pressures = [...wanted.keys()];
    return work("solver", "press", async () => {
      if (text !== page.text) return;
      this.run = run;
      this.wanted = wanted;
      this.busy(true);
      try {
        await desks.solver.press(text, pressures, Boolean(state.leak), (event) => this.run === run && this.happened(event));
        if (this.run === run) $("iterations").textContent = "";
      } catch (error) {
        if (this.run === run) throw error;
      } finally {
        if (this.run === run) this.end();
      }
    });
  }

  stop(why = this.stopped()) {
    this.end();
    desks.solver.end("stopped");
    $("iterations").textContent = why;
  }

  // Which loads of the run are solved, and which are missing.
  stopped() {
    const [solved, missing] = [[], []];
    for (const [pressure, text] of [...this.wanted].sort(([a], [b]) => a - b)) (this.at(pressure) ? solved : missing).push(text);
    return `stopped: ${solved.length > 0 ? `solved ${solved.join(", ")}` : "no load is solved"}; missing ${missing.join(", ")}`;
  }

  end() {
    this.run = null;
    this.busy(false);
  }

  busy(busy) {
    $("stop").hidden = $("progress").hidden = !busy;
    $("solve").disabled = $("solve-load").disabled = busy;
    document.documentElement.dataset.elements = busy ? "busy" : "ready";
    if (busy) $("iterations").textContent = "starting";
  }

  // The place of the map without one.
  spot(why = "", offer = false) {
    noPicture($("contact"), why);
    $("contact-reading").textContent = "";
    const button = element("button", { type: "button", onclick: () => this.solve(false) }, "Solve this load");
    if (offer) $("contact").firstElementChild.append(element("br"), button);
  }

  happened(event) {
    if (event.event === "progress") {
      Object.assign($("progress"), { max: event.count, value: event.done });
      $("iterations").textContent = event.text;
      // Spoken once a load.
      const [loads] = event.text.split(";");
      if ($("loads-done").textContent !== loads) $("loads-done").textContent = loads;
    } else if (event.event === "failed") {
      tell(event.message);
    } else if (event.event === "flow") {
      this.at(event.pressure)?.maps.push(event.map);
      this.table();
    } else {
      this.solved = this.solved.filter(({ pressure }) => pressure !== event.pressure);
      this.solved.push(event);
      this.solved.sort((a, b) => (a.pressure < b.pressure ? -1 : 1));
      this.showNear();
      this.table();
      this.changed(event.pressure);
    }
  }

  // What the answer knows of solved loads.
  known = () => this.solved.map(({ pressure, cells, notes }) => ({
    pressure,
    values: Object.fromEntries(cells.filter(({ digits }) => digits !== undefined).map(({ quantity, digits }) => [quantity, digits])),
    notes: notes.map(({ code }) => code),
  }));

  // The map at the present load, or at the next heavier one that is solved.
  showNear() {
    const present = page.load?.pascals;
    const near = this.solved.find(({ pressure }) => pressure >= present) ?? this.solved.at(-1);
    if (near && near !== this.shown) this.show(near);
  }

  // The map of the pressures, or of the flow.
  show(one, map = one.maps[0]) {
    this.shown = one;
    picture($("contact"), map.svg, `map at ${one.load}: ${map.caption}`);
    $("contact-reading").textContent = map.caption;
  }

  table() {
    const [table, notes] = [$("solved"), $("solved-notes")];
    table.hidden = false;
    // A column a load: so many quantities are wider than the page.
    const [, ...rows] = new Map(this.solved.flatMap(({ head }) => head.map((column) => [column.id, column]))).values();
    const none = { shown: "not solved; move to this load and press Solve this load" };
    const show = (one, k) => {
      if (!one.maps[k]) return cell(none);
      const button = element("button", { type: "button", onclick: () => this.show(one, one.maps[k]) }, "show");
      button.setAttribute("aria-label", `show the map${k ? " of the flow" : ""} at ${one.load}`);
      return element("td", {}, button);
    };
    const maps = ["map", "map of the flow"].filter((_, k) => this.solved.some((one) => one.maps[k]));
    table.tHead.replaceChildren(element("tr", {}, heading("load"), ...this.solved.map(({ load, pressure, cells: [{ digits }] }) => {
      const head = heading(load, digits);
      Object.assign(head.dataset, { pressure, model: "bem", quantity: "load", value: digits });
      return head;
    })));
    table.tBodies[0].replaceChildren(
      ...rows.map(({ id, label, definition }) => element("tr", {}, element("th", { scope: "row", title: definition }, label),
        ...this.solved.map(({ cells }) => cell(cells.find(({ quantity }) => quantity === id) ?? none, "bem")))),
      ...maps.map((name, k) => element("tr", {}, element("th", { scope: "row" }, name), ...this.solved.map((one) => show(one, k)))));
    // What several loads have in common is shown once, for the lightest.
    const lines = new Map();
    for (const { load, notes } of this.solved) for (const { code, quantity, severity, message } of notes) {
      const same = `${code} ${quantity}`;
      if (!lines.has(same)) lines.set(same, { text: `${severity}: ${message}`, also: [] });
      else lines.get(same).also.push(load);
    }
    notes.hidden = lines.size === 0;
    notes.replaceChildren(...[...lines.values()].map(({ text, also }) =>
      element("li", {}, ...lowered(also.length > 0 ? `${text} (also at ${also.join(", ")})` : text))));
  }

  // What was solved at a pressure.
  at = (pascals) => this.solved.find(({ pressure }) => pressure === pascals);

  // The points of a quantity that boundary elements give.
  points(view) {
    const of = ({ cells }) => cells.find(({ quantity }) => quantity === view)?.digits;
    return this.solved.filter(of).map((one) => [one.pressure, Number(of(one))]);
  }
}

export const elements = new Elements();
