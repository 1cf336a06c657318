// Where things stand at several widths, names, colours, sizes, and the time to the first values.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { explorer, SETTLED } from "./harness.mjs";

const SHIFTS = `window.shifts = []; new PerformanceObserver((list) => shifts.push(...list.getEntries())).observe({ type: "layout-shift", buffered: true });`;
const FIRST = `new MutationObserver((_, seen) => { if (document.querySelector("#answer [data-value]")) { window.firstValues = performance.now(); seen.disconnect(); } }).observe(document, { childList: true, subtree: true });`;
let page;
before(async () => {
  page = await explorer({ script: SHIFTS + FIRST });
  await page.opened();
  await page.browser.until(SETTLED);
});
after(() => page?.end());

const size = async (width, height = 900) => {
  await page.browser.cdp("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });
  await new Promise((resolve) => setTimeout(resolve, 200));
  await page.browser.until(SETTLED);
};
const scheme = (value) => page.browser.cdp("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value }] });
const fill = (selector) => page.run(`return getComputedStyle(document.querySelector(arguments[0])).fill`, selector);
const boxes = (...ids) => page.run(`return arguments[0].map((id) => { const { top, bottom, left, right, height } = document.getElementById(id).getBoundingClientRect(); return { top, bottom, left, right, height }; })`, ids);

test("nothing moves", async () => {
  for (const position of ["0.3", "0.5", "0.9", "0.7"]) await page.change(["#slider", position, "input"]);
  const moved = await page.run(`return shifts.filter(({ hadRecentInput }) => !hadRecentInput).reduce((sum, { value }) => sum + value, 0)`);
  assert.ok(moved < 0.1, `${moved}`);
});

test("the first screen", async () => {
  for (const [wide, high] of [[1280, 800], [1920, 1080]]) {
    await size(wide, high);
    await page.run(`scrollTo(0, 0)`);
    const [load, answer, curve, contact, inputs] = await boxes("load-bar", "answer", "curve", "contact", "inputs");
    assert.ok(load.top < 70 && load.height < 60, `load ${load.top} ${load.height}`);
    assert.ok(answer.top < 120 && answer.bottom < 260, `answer ${answer.top} ${answer.bottom}`);
    assert.ok(curve.top < 270 && curve.height <= 0.45 * high, `plot ${curve.top} ${curve.height}`);
    assert.ok(contact.top === curve.top && contact.left > curve.right && inputs.right < load.left && inputs.bottom <= high);
    const rows = await page.run(`return [...document.querySelectorAll("#answers tbody tr")].slice(0, 5).map((row) => row.getBoundingClientRect().bottom)`);
    assert.ok(rows.length === 5 && rows[4] < high, `${rows} of ${high} px`);
  }
  await size(360, 800);
  const [load, answer, curve, contact, inputs] = await boxes("load", "answer", "curve", "contact", "inputs");
  assert.ok(load.top < 130 && answer.top < 220 && answer.bottom < 520, `${load.top} ${answer.top} ${answer.bottom}`);
  assert.ok(answer.bottom < inputs.top && curve.bottom < contact.top, `${inputs.top}`);
});

test("no sideways scrolling", async () => {
  await page.run(`document.getElementById("tab-elements").click()`);
  for (const wide of [360, 1280, 1500, 1560, 2560]) {
    await size(wide);
    const wider = await page.run(`const needs = ({ scrollWidth, clientWidth }) => scrollWidth > clientWidth;
      const tables = innerWidth < 1280 ? [] : ["answers", "solved"].map((id) => document.getElementById(id).parentElement);
      return [document.documentElement, ...tables].map(needs)`);
    assert.ok(!wider.includes(true), `${wide} px: ${wider}`);
  }
});

test("one section below", async () => {
  const open = () => page.run(`return [...document.querySelectorAll("[role=tabpanel]")].filter((one) => one.getClientRects().length > 0).map(({ id }) => id)`);
  await page.run(`document.getElementById("tab-findings").click(); document.getElementById("tab-findings").focus()`);
  for (const id of ["scan-report", "elements", "derived", "take-away", "findings"]) {
    await page.browser.keys(["\uE014"]);
    assert.deepEqual(await open(), [id]);
  }
  await page.browser.cdp("Emulation.setEmulatedMedia", { media: "print" });
  assert.deepEqual(await open(), ["findings", "scan-report", "elements", "derived"]);
  await page.browser.cdp("Emulation.setEmulatedMedia", { media: "" });
});

test("controls have names", async () => {
  const { nodes } = await page.browser.cdp("Accessibility.getFullAXTree", {});
  const all = nodes.filter(({ ignored }) => !ignored).map(({ role, name }) => ({ role: role?.value, name: name?.value ?? "" }));
  const named = (role) => all.filter((one) => one.role === role).map(({ name }) => name);
  assert.ok(["First body", "Second body"].every((body) => named("group").includes(body)));
  assert.ok(named("region").includes("Answer"));
  const controls = ["textbox", "combobox", "slider", "checkbox", "tab"].flatMap(named);
  assert.ok(controls.length > 20 && controls.every(Boolean), String(controls));
  assert.deepEqual(controls.filter((name, k) => controls.indexOf(name) !== k), []);
  const spoken = await page.all("[role=status], [role=alert]", "id");
  for (const id of ["status", "load-error", "message", "spoken", "loads-done", "scene-error"]) assert.ok(spoken.includes(id), id);
  assert.notEqual(await page.text("spoken"), "");
});

// Relative luminance and contrast of WCAG 2.
function contrast(...colours) {
  const [a, b] = colours.map((colour) => {
    const [red, green, blue] = colour.match(/\w\w/g).map((part) => parseInt(part, 16) / 255).map((x) => (x <= 0.03928 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  }).sort((x, y) => y - x);
  return (a + 0.05) / (b + 0.05);
}

test("contrast is enough", async () => {
  for (const theme of ["light", "dark"]) {
    await scheme(theme);
    const colour = Object.fromEntries(await page.run(`const all = getComputedStyle(document.documentElement); return ["paper", "card", "wash", "ink", "soft", "mark", "wrong", "warn", "edge"].map((name) => [name, all.getPropertyValue("--" + name).trim()])`));
    for (const ground of ["paper", "card", "wash"]) {
      for (const letter of ["ink", "soft", "mark", "wrong", "warn"]) {
        assert.ok(contrast(colour[letter], colour[ground]) >= 4.5, `${theme}: ${letter} on ${ground} ${contrast(colour[letter], colour[ground])}`);
      }
      assert.ok(contrast(colour.edge, colour[ground]) >= 3, `${theme}: edge on ${ground} ${contrast(colour.edge, colour[ground])}`);
    }
    // Maps have the ground and the letters of the theme.
    const bright = Math.max(...(await fill("#contact .ground")).match(/\d+/g));
    assert.ok(theme === "light" ? bright === 255 : bright < 215);
  }
  await scheme("light");
});

test("sizes are enough", async () => {
  for (const [width, height] of [[360, 800], [1280, 800], [1920, 1080]]) {
    await size(width, height);
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

test("first values soon", async (t) => {
  const first = await page.run(`return firstValues`);
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
