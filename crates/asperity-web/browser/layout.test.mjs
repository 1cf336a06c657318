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

const width = (width) => page.browser.cdp("Emulation.setDeviceMetricsOverride", { width, height: 900, deviceScaleFactor: 1, mobile: false });
const scheme = (value) => page.browser.cdp("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value }] });
const fill = (selector) => page.run("return getComputedStyle(document.querySelector(arguments[0])).fill", selector);

test("on a narrow screen inputs stand above answers, and a link leads to the answers", async () => {
  await width(360);
  const [inputs, results, link] = await page.run("return ['inputs', 'results', 'to-answers'].map((id) => document.getElementById(id).getBoundingClientRect().top)");
  assert.ok(link < 400 && link < inputs && inputs < results, `${link} ${inputs} ${results}`);
  const before = await page.run("return location.href");
  await page.run("document.getElementById('to-answers').click()");
  const [top, focused, after] = await page.run("return [document.getElementById('load').getBoundingClientRect().top, document.activeElement.id, location.href]");
  assert.ok(top >= 0 && top < 200, `${top} px`);
  assert.deepEqual([focused, after], ["results", before]);
  await width(1280);
  assert.equal(await page.run("return document.getElementById('to-answers').getClientRects().length"), 0);
});

test("solved loads do not scroll sideways at 1280 px, and their names are those of the table", async () => {
  await width(1280);
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
