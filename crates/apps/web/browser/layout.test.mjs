// Where things stand at several widths, symbols, and colours in the dark.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { explorer, SETTLED } from "./harness.mjs";

let page;
before(async () => {
  page = await explorer();
  await page.browser.until("return document.querySelectorAll('#solved thead [data-pressure]').length >= 6", "solved loads", 60);
  await page.browser.until(SETTLED);
});
after(() => page?.end());

const size = (width, height) => page.browser.cdp("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });
const width = (width) => size(width, 900);
const openTab = (id) => page.run("document.getElementById(arguments[0]).click()", `tab-${id}`);
const scheme = (value) => page.browser.cdp("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value }] });
const fill = (selector) => page.run("return getComputedStyle(document.querySelector(arguments[0])).fill", selector);

const boxes = (...ids) => page.run("return arguments[0].map((id) => { const { top, bottom, left, right, height } = document.getElementById(id).getBoundingClientRect(); return { top, bottom, left, right, height }; })", ids);

test("load, answer, plot, map and values are on the first screen", async () => {
  for (const [wide, high] of [[1280, 800], [1920, 1080]]) {
    await size(wide, high);
    await page.browser.until(SETTLED);
    await page.run("scrollTo(0, 0)");
    const [load, answer, curve, contact, inputs] = await boxes("load-bar", "answer", "curve", "contact", "inputs");
    assert.ok(load.top < 70 && load.height < 60, `load ${load.top} ${load.height}`);
    assert.ok(answer.top < 120 && answer.bottom < 260, `answer ${answer.top} ${answer.bottom}`);
    assert.ok(curve.top < 270 && curve.height <= 0.45 * high, `plot ${curve.top} ${curve.height}`);
    assert.ok(contact.top === curve.top && contact.left > curve.right, "the map beside the plot");
    assert.ok(inputs.right < load.left && inputs.bottom <= high, "the form beside both, with its own scroll");
    // The answer and all models of the table.
    const rows = await page.run("return [...document.querySelectorAll('#answers tbody tr')].slice(0, 5).map((row) => row.getBoundingClientRect().bottom)");
    assert.ok(rows.length === 5 && rows[4] < high, `${rows} of ${high} px`);
  }
});

test("on a narrow screen the answer and the load stand above the form", async () => {
  await size(360, 800);
  const [load, answer, curve, contact, inputs] = await boxes("load", "answer", "curve", "contact", "inputs");
  assert.ok(load.top < 130 && answer.top < 220 && answer.bottom < 520, `${load.top} ${answer.top} ${answer.bottom}`);
  assert.ok(answer.bottom < inputs.top && curve.bottom < contact.top, `${inputs.top}`);
});

test("a link to the answer is seen when it has the focus, at every width", async () => {
  const before = await page.run("return location.href");
  for (const wide of [360, 1280, 1920]) {
    await size(wide, 900);
    await page.run("document.activeElement.blur(); document.getElementById('to-answers').focus()");
    const [{ top, bottom }] = await boxes("to-answers");
    assert.ok(top >= 0 && bottom < 60, `${top} ${bottom} at ${wide} px`);
    await page.browser.keys(["\uE007"]);
    assert.deepEqual(await page.run("return [document.activeElement.id, location.href]"), ["answer", before]);
  }
});

test("one section is shown below the values, by a tap or an arrow", async () => {
  await size(1280, 900);
  const open = () => page.run("return [...document.querySelectorAll('[role=tabpanel]')].filter((one) => one.getClientRects().length > 0).map(({ id }) => id)");
  assert.deepEqual(await open(), ["findings"]);
  await page.run("document.getElementById('tab-findings').focus()");
  for (const id of ["scan-report", "elements", "derived", "take-away", "findings"]) {
    await page.browser.keys(["\uE014"]);
    assert.deepEqual(await open(), [id]);
    assert.equal(await page.run("return document.activeElement.getAttribute('aria-controls')"), id);
  }
  await page.browser.cdp("Emulation.setEmulatedMedia", { media: "print" });
  // On paper nothing is taken away by a button.
  assert.deepEqual(await open(), ["findings", "scan-report", "elements", "derived"]);
  await page.browser.cdp("Emulation.setEmulatedMedia", { media: "" });
});

test("solved loads do not scroll sideways at 1280 px, and their names are those of the table", async () => {
  await width(1280);
  await openTab("elements");
  const [needed, there] = await page.run("const { scrollWidth, clientWidth } = document.getElementById('solved').parentElement; return [scrollWidth, clientWidth]");
  assert.ok(needed <= there, `${needed} of ${there} px`);
  const names = await page.run("return ['#solved tbody th', '#answers thead th'].map((list) => [...document.querySelectorAll(list)].map((head) => head.textContent))");
  for (const name of ["real over nominal area", "tangent stiffness", "unloading stiffness"]) assert.ok(names.every((list) => list.includes(name)), name);
});

test("the table of values does not scroll sideways at 1280 px and wider", async () => {
  for (const size of [1280, 1500, 1540, 1560]) {
    await width(size);
    const [needed, there] = await page.run("const { scrollWidth, clientWidth } = document.getElementById('answers').parentElement; return [scrollWidth, clientWidth]");
    assert.ok(needed <= there, `${needed} of ${there} px at ${size} px`);
  }
  await width(1280);
});

test("derived numbers have Greek letters and lowered indices", async () => {
  const [text, lowered] = await page.run("return [document.getElementById('numbers').textContent, [...document.querySelectorAll('#numbers sub')].map((sub) => sub.previousSibling.textContent.slice(-1) + sub.textContent)]");
  assert.match(text, /σz, of the asperities/);
  assert.match(text, /\(π S H\/\(2 E\)\)² R/);
  assert.doesNotMatch(text, /sigma|\bpi\b|\beta\b|_/);
  assert.ok(lowered.length >= 5 && lowered.includes("wc"), String(lowered));
});

test("maps have the ground and the letters of the theme, and keep the colours of their data", async () => {
  const images = await page.run("return [...document.querySelectorAll('#contact image')].map((image) => [image.getAttribute('href'), getComputedStyle(image).filter])");
  const found = {};
  for (const value of ["light", "dark"]) {
    await scheme(value);
    found[value] = [await fill("#contact .ground"), await fill("#contact svg text"), await fill("#contact svg > rect")];
  }
  await scheme("light");
  assert.equal(found.light[0], "rgb(255, 255, 255)");
  const brightness = (colour) => Math.max(...colour.match(/\d+/g).map(Number));
  assert.ok(brightness(found.dark[0]) < 215 && brightness(found.dark[1]) > 200, JSON.stringify(found));
  assert.equal(found.dark[2], "none");
  assert.equal(images[0][1], "none");
});
