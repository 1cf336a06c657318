// Keyboard, screen reader, colours, sizes of letters and targets, and a layout that stays.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { explorer, SETTLED } from "./harness.mjs";

const SHIFTS = "window.shifts = []; new PerformanceObserver((list) => shifts.push(...list.getEntries())).observe({ type: 'layout-shift', buffered: true });";
const FIRST = "new MutationObserver((_, seen) => { if (document.querySelector('#answer [data-value]')) { window.firstValues = performance.now(); seen.disconnect(); } }).observe(document, { childList: true, subtree: true });";
let page;
before(async () => {
  page = await explorer({ script: SHIFTS + FIRST });
  await page.browser.until("return document.querySelectorAll('#solved thead [data-pressure]').length >= 6", "solved loads", 60);
  await page.browser.until(SETTLED);
});
after(() => page?.end());

const size = (width, height) => page.browser.cdp("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });
const scheme = (value) => page.browser.cdp("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value }] });

test("nothing moves while the page opens, solves and slides", async () => {
  for (const position of ["0.3", "0.5", "0.9", "0.7"]) await page.change(["#slider", position, "input"]);
  const moved = await page.run("return shifts.filter(({ hadRecentInput }) => !hadRecentInput).reduce((sum, { value }) => sum + value, 0)");
  assert.ok(moved < 0.1, `${moved}`);
});

test("the load is reached within twelve stops", async () => {
  await page.run("document.activeElement.blur(); scrollTo(0, 0)");
  const stops = [];
  while (stops.length < 12 && stops.at(-1) !== "load") {
    await page.browser.keys(["\uE004"]);
    stops.push(await page.run("return document.activeElement.id || document.activeElement.textContent"));
  }
  assert.equal(stops[0], "to-answers");
  assert.equal(stops.at(-1), "load", stops.join());
});

test("controls have names of their own, bodies are groups, and what changes is said", async () => {
  const { nodes } = await page.browser.cdp("Accessibility.getFullAXTree", {});
  const all = nodes.filter(({ ignored }) => !ignored).map(({ role, name }) => ({ role: role?.value, name: name?.value ?? "" }));
  const named = (role) => all.filter((one) => one.role === role).map(({ name }) => name);
  for (const body of ["First body", "Second body"]) assert.ok(named("group").includes(body), String(named("group")));
  const controls = ["textbox", "combobox", "slider", "checkbox", "tab"].flatMap(named);
  assert.ok(controls.length > 20 && controls.every(Boolean), String(controls));
  assert.deepEqual(controls.filter((name, k) => controls.indexOf(name) !== k), []);
  for (const name of ["Material of the first body", "Hardness H of the second body, in Pa", "Load", "Load over five decades", "Quantity of the plot"]) assert.ok(controls.includes(name), name);
  for (const name of ["Answer", "Load and answer", "Bodies and surface"]) assert.ok(named("region").includes(name), String(named("region")));
  const spoken = await page.run("return [...document.querySelectorAll('[role=status], [role=alert]')].map(({ id }) => id)");
  for (const id of ["status", "load-error", "message", "spoken", "loads-done", "scene-error", "compared-count"]) assert.ok(spoken.includes(id), id);
  assert.match(await page.text("spoken"), /^At .+: real area [\d.]+ %, first-loading stiffness .+; use [a-z-]+$/);
});

test("definitions are reached by tap and key", async () => {
  await page.run("document.querySelector('#definitions summary').click()");
  const words = await page.text("definitions");
  for (const word of ["tangent stiffness", "unloading stiffness", "mean contact pressure"]) assert.ok(words.includes(word), words);
});

// Relative luminance and contrast of WCAG 2.
function contrast(...colours) {
  const [a, b] = colours.map((colour) => {
    const [red, green, blue] = colour.match(/\w\w/g).map((part) => parseInt(part, 16) / 255).map((x) => (x <= 0.03928 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  }).sort((x, y) => y - x);
  return (a + 0.05) / (b + 0.05);
}

test("letters have a contrast of 4.5, borders of controls of 3, in both themes", async () => {
  for (const theme of ["light", "dark"]) {
    await scheme(theme);
    const colour = Object.fromEntries(await page.run("const all = getComputedStyle(document.documentElement); return ['paper', 'card', 'wash', 'ink', 'soft', 'mark', 'wrong', 'warn', 'edge'].map((name) => [name, all.getPropertyValue('--' + name).trim()])"));
    for (const ground of ["paper", "card", "wash"]) {
      for (const letter of ["ink", "soft", "mark", "wrong", "warn"]) {
        assert.ok(contrast(colour[letter], colour[ground]) >= 4.5, `${theme}: ${letter} on ${ground} ${contrast(colour[letter], colour[ground])}`);
      }
      assert.ok(contrast(colour.edge, colour[ground]) >= 3, `${theme}: edge on ${ground} ${contrast(colour.edge, colour[ground])}`);
    }
  }
  await scheme("light");
});

test("targets have 24 px and letters of pictures 12 px", async () => {
  for (const [width, height] of [[360, 800], [1280, 800], [1920, 1080]]) {
    await size(width, height);
    await new Promise((resolve) => setTimeout(resolve, 300));
    await page.browser.until(SETTLED);
    const small = await page.run(`return [...document.querySelectorAll("input:not([type=checkbox]), select, button, summary, [role=tab], label:has(> input[type=checkbox])")]
      .filter((one) => one.getClientRects().length > 0 && one.getBoundingClientRect().height < 23.9).map((one) => one.id + one.textContent + ' ' + one.getBoundingClientRect().height)`);
    assert.deepEqual(small, [], `${width} px`);
    const letters = await page.run(`return ["curve", "contact"].map((id) => {
      const svg = document.querySelector("#" + id + " svg");
      const { width, height } = svg.getBoundingClientRect();
      const box = svg.viewBox.baseVal;
      const scale = Math.min(width / box.width, height / box.height);
      return Math.min(...[...svg.querySelectorAll("text")].map((text) => scale * parseFloat(text.getAttribute("font-size"))));
    })`);
    assert.ok(letters.every((least) => least >= 11.9), `${letters} at ${width} px`);
  }
  await size(1280, 900);
});

test("first values are there within a second, the table 20 ms after a move of the slider", async (t) => {
  const first = await page.run("return firstValues");
  const moves = await page.browser.later(`
    const slider = document.getElementById("slider"), body = document.querySelector("#answers tbody"), taken = [];
    for (let k = 0; k < 15; k++) {
      while (document.documentElement.dataset.state !== "ready") await new Promise((resolve) => setTimeout(resolve, 20));
      const start = performance.now();
      slider.value = 0.3 + 0.02 * k;
      slider.dispatchEvent(new Event("input"));
      await new Promise((resolve) => { const seen = new MutationObserver(() => { seen.disconnect(); resolve(); }); seen.observe(body, { childList: true }); });
      taken.push(performance.now() - start);
    }
    return taken.sort((a, b) => a - b);`);
  t.diagnostic(`first values after ${Math.round(first)} ms; table after a move ${moves.map((one) => one.toFixed(0))} ms`);
  // On a quiet machine 1 s and 20 ms; a busy one is given three times as much.
  assert.ok(first < 3000, `${first} ms`);
  assert.ok(moves[3] < 60, `${moves} ms`);
});
