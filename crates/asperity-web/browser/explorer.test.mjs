// What the explorer does with quick edits, dead workers, other files, errors and its history.
import assert from "node:assert/strict";
import { closeSync, ftruncateSync, mkdtempSync, openSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { after, before, test } from "node:test";
import { open } from "./webdriver.mjs";
import { serve } from "./server.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");
const scratch = mkdtempSync(join(tmpdir(), "asperity-explorer-"));
const SETTLED = "return ['ready', 'failed'].includes(document.documentElement.dataset.state)";
const example = (name) => readFileSync(join(root, `crates/asperity-scene/examples/${name}.toml`), "utf8");
let site, browser;

before(async () => {
  site = await serve(join(root, "target/page"));
  browser = await open({ downloads: scratch });
  await browser.go(site.url);
  await browser.until(SETTLED, "the first page");
});
after(async () => {
  await browser?.close();
  site?.close();
});

const phase = () => browser.run("return document.documentElement.dataset.state");
const text = (id) => browser.run("return document.getElementById(arguments[0]).textContent", id);
const value = (id) => browser.run("return document.getElementById(arguments[0]).value", id);
// Gives controls values one after the other at once, and waits for what follows.
async function change(...list) {
  await browser.run(`for (const [selector, value, event = "change"] of arguments[0]) {
    const field = document.querySelector(selector);
    field.value = value;
    field.dispatchEvent(new Event(event, { bubbles: true }));
  }`, list);
  await browser.until(SETTLED, JSON.stringify(list).slice(0, 80));
}
const setScene = (text) => change(["#scene", text, "input"]);
async function give(name, bytes) {
  writeFileSync(join(scratch, name), bytes);
  await browser.type("#scan", join(scratch, name));
  await browser.until(SETTLED, name);
}
const field = (path) => `[data-path="${path}"]`;
const heights = (amplitude) => Array.from({ length: 64 }, (_, y) => Array.from({ length: 64 }, (_, x) =>
  amplitude * (Math.sin(0.7 * x) + Math.cos(0.9 * y) + Math.sin(0.5 * x - 0.8 * y))).join(" ")).join("\n");

test("edits that follow at once are all in the scene, also while boundary elements are solved", async () => {
  await browser.run("document.getElementById('solve').click()");
  assert.equal(await phase(), "busy");
  await change([field("body[1].youngs_modulus"), "190 GPa"], [field("body[1].poissons_ratio"), "0.29"], [field("body[2].youngs_modulus"), "180 GPa"], ["#load", "321 N"], ["#view", "tangent"]);
  const scene = await value("scene");
  for (const wanted of ['"190 GPa"', "0.29", '"180 GPa"']) assert.ok(scene.includes(wanted), wanted);
  assert.equal(await value("load"), "321 N");
  assert.match(await browser.run("return document.querySelector('#curve svg').getAttribute('aria-label')"), /stiffness against the load/);
  assert.equal(await browser.run("return document.querySelector('[data-path=\"body[1].poissons_ratio\"]').value"), "0.29");
});

test("boundary elements that are solved do not end an answer, and a text being typed is kept", async () => {
  await browser.run("document.getElementById('solve').click()");
  for (const load of [100, 200, 400, 800]) {
    await browser.run(`const field = document.getElementById("load"); field.value = arguments[0];
      field.dispatchEvent(new Event("change", { bubbles: true }))`, `${load} N`);
  }
  await browser.run(`const field = document.querySelector('[data-path="nominal_area"]'); field.focus(); field.value = "3 m";
    field.dispatchEvent(new Event("input", { bubbles: true }))`);
  await browser.until(SETTLED);
  assert.equal(await browser.run("return document.getElementById('load').dataset.newtons"), "800");
  assert.equal(await browser.run("return document.querySelector('[data-path=\"nominal_area\"]').value"), "3 m");
  assert.ok((await browser.run("return document.querySelectorAll('[data-model=bem][data-quantity=area-fraction]').length")) >= 5);
  await browser.run("document.querySelector('[data-path=\"nominal_area\"]').blur()");
  await browser.until(SETTLED);
});

test("the unit changes the text of the load and not the load", async () => {
  await setScene(example("wheel-rail"));
  await change(["#load", "1234.5 N"]);
  const tangent = () => browser.run("return document.querySelector('#answers [data-quantity=tangent]').dataset.value");
  const first = await tangent();
  await change(["#unit", "Pa"]);
  assert.match(await value("load"), /Pa$/);
  assert.ok(Math.abs((await tangent()) / first - 1) < 1e-12);
  await change(["#unit", "N"]);
  assert.equal(await value("load"), "1.2345 kN");
  await change(["#unit", "Pa"], ["#load", "2e6"]);
  assert.deepEqual([await value("load"), await value("unit")], ["2e6 Pa", "Pa"]);
  const link = await browser.run("return location.href");
  await browser.go("about:blank");
  await browser.go(link);
  await browser.until(SETTLED);
  assert.equal(await browser.run("return document.getElementById('load').dataset.pascals"), "2000000");
});

test("back and forward restore what was there before each change", async () => {
  await setScene(example("bolted-joint"));
  await change(["#view", "area-fraction"]);
  await change(["#view", "tangent"]);
  await change([field("nominal_area"), "2 cm2"]);
  assert.match(await value("scene"), /2 cm2/);
  await browser.run("history.back()");
  await browser.until("return !document.getElementById('scene').value.includes('2 cm2')", "the area before");
  await browser.until(SETTLED);
  assert.equal(await value("view"), "tangent");
  await browser.run("history.back()");
  await browser.until("return document.getElementById('view').value === 'area-fraction'", "the quantity before");
  await browser.run("history.go(2)");
  await browser.until("return document.getElementById('scene').value.includes('2 cm2')", "forward");
  await browser.until(SETTLED);
  assert.equal(await value("view"), "tangent");
  assert.deepEqual(await browser.errors(), []);
});

test("after an error no picture, no values and no files of the scene before", async () => {
  await setScene(example("wheel-rail"));
  assert.ok(await browser.run("return Boolean(document.querySelector('#curve svg'))"));
  await setScene("nominal_area = ");
  assert.equal(await phase(), "failed");
  const left = await browser.run(`return [document.querySelectorAll('#curve svg, #answers [data-value], #numbers tr').length,
    ...['save-csv', 'save-svg', 'save-png', 'save-table', 'solve'].map((id) => document.getElementById(id).disabled)]`);
  assert.deepEqual(left, [0, true, true, true, true, true]);
  await setScene(example("wheel-rail"));
  assert.equal(await phase(), "ready");
  assert.ok(await browser.run("return !document.getElementById('save-csv').disabled"));
});

test("a scan in place of another keeps its keys, and one of the same name is read anew", async () => {
  await setScene(example("wheel-rail"));
  await give("one.txt", heights(1e-7));
  await setScene((await value("scene")).replace('file = "one.txt"', 'file = "one.txt"\nunit = "m"\npixel_size = 1e-6'));
  assert.equal(await phase(), "ready");
  const sq = () => browser.run("return document.querySelector('#scan-numbers td').title");
  const first = Number(await sq());
  await give("two.txt", heights(3e-7));
  assert.match(await value("scene"), /file = "two.txt"\nunit = "m"\npixel_size = 1e-6/);
  assert.ok(Math.abs(Number(await sq()) / first - 3) < 1e-6, await sq());
  await give("two.txt", heights(5e-7));
  assert.ok(Math.abs(Number(await sq()) / first - 5) < 1e-6, await sq());
});

test("a link asks for its scan, and tells another file from it by the checksum", async () => {
  const link = await browser.run("return location.href");
  const before = await value("scene");
  await browser.go("about:blank");
  await browser.go(link);
  await browser.until(SETTLED);
  assert.match(await text("message"), /made with the scan two\.txt \(checksum [0-9a-f]{32}\)/);
  assert.equal(await value("scene"), before);
  await give("two.txt", heights(2e-7));
  assert.match(await text("message"), /two\.txt is not the file of the link: its checksum is [0-9a-f]{32}/);
  // The same heights under another name are those of the link.
  await give("renamed.txt", heights(5e-7));
  assert.equal(await text("message"), "");
  assert.deepEqual([await phase(), await value("scene")], ["ready", before]);
});

test("boundary elements give mean gap and separation, and their notes are shown", async () => {
  await browser.run("document.getElementById('solve').click()");
  await browser.until(SETTLED);
  const names = await browser.run("return [...document.querySelectorAll('#solved tbody tr:first-child [data-quantity]')].map((cell) => cell.dataset.quantity)");
  for (const name of ["mean-gap", "separation", "area-fraction"]) assert.ok(names.includes(name), String(names));
  assert.match(await text("solved-notes"), /warning|note/);
  assert.match(await text("scan-caption"), /64 x 64 points/);
});

test("a file of 2 GB is refused by its size", async () => {
  const path = join(scratch, "large.x3p");
  const file = openSync(path, "w");
  ftruncateSync(file, 2 ** 31);
  closeSync(file);
  const start = Date.now();
  await browser.type("#scan", path);
  await browser.until("return /large.x3p has 2048 MB/.test(document.getElementById('message').textContent)", "the message", 10);
  assert.ok(Date.now() - start < 5000);
  assert.match(await text("message"), /at most 128 MB: use the program/);
});

test("wrong numbers of a random surface have a message", async () => {
  await change(["#random-pixels", "abc"]);
  await browser.run("document.getElementById('make-random').click()");
  await browser.until("return /random.pixels is \"abc\"/.test(document.getElementById('message').textContent)");
  await browser.until(SETTLED);
});

test("values under the pointer come with the picture", async () => {
  await setScene(example("wheel-rail"));
  await change(["#load", "1 MPa"]);
  await browser.run("document.querySelectorAll('#curve .reading')[60].dispatchEvent(new PointerEvent('pointerover', { bubbles: true }))");
  assert.match(await text("reading"), /Pagw .*ke .*jg /);
  assert.equal(await browser.run("return document.querySelectorAll('#curve .reading').length"), 121);
});

test("what to try beside the example does what it says, and an example can be opened again", async () => {
  await change(["#example", "ground-steel"]);
  assert.ok(await browser.run("return !document.getElementById('try').hidden"));
  const press = async (k) => {
    await browser.run("document.querySelectorAll('#tries button')[arguments[0]].click()", k);
    await browser.until(SETTLED);
    assert.deepEqual([await phase(), await text("message")], ["ready", ""]);
  };
  await press(0);
  assert.equal(await value("view"), "unloading-stiffness");
  await press(1);
  assert.match(await value("scene"), /material = "copper/);
  await press(3);
  assert.equal(await browser.run("return document.querySelectorAll('#solved tbody tr').length"), 1);
  await change(["#example", "ground-steel"]);
  assert.doesNotMatch(await value("scene"), /copper/);
  await change(["#example", "wheel-rail"]);
  assert.ok(await browser.run("return document.getElementById('try').hidden"));
});

test("Gao and AT appear when they are ready, and the others are there before", async () => {
  await browser.run("for (const id of ['gao', 'at']) document.querySelector(`#models [value=${id}]`).click()");
  await browser.until("return document.querySelectorAll('#answers [data-model=ke]').length > 3", "quick models");
  await browser.until(SETTLED, "all models");
  const models = await browser.run("return [...new Set([...document.querySelectorAll('#answers [data-value]')].map((cell) => cell.dataset.model))]");
  assert.ok(models.includes("gao") && models.includes("at") && models.includes("ke"), String(models));
});

// A fresh page in which a script runs before all others.
async function opened(script, check, phase = "failed", hash = "") {
  const other = await open();
  try {
    await other.call("POST", "/goog/cdp/execute", { cmd: "Page.addScriptToEvaluateOnNewDocument", params: { source: script } });
    await other.go(site.url + hash);
    await other.until(`return document.documentElement.dataset.state === '${phase}'`, phase);
    await check(other);
  } finally {
    await other.close();
  }
}

test("a worker that dies is started anew twice, then the page says so and keeps the text", async () => {
  const script = `window.started = 0; const Real = Worker; window.Worker = class extends Real {
    constructor() { super("missing.js"); window.started += 1; } };`;
  await opened(script, async (other) => {
    assert.equal(await other.run("return window.started"), 3);
    assert.match(await other.run("return document.getElementById('message').textContent"), /3 times in a row/);
    assert.match(await other.run("return document.getElementById('scene').value"), /nominal_area/);
    await other.run("const field = document.getElementById('scene'); field.value = '# mine'; field.dispatchEvent(new Event('input', { bubbles: true }))");
    await other.until("return document.documentElement.dataset.state === 'failed'", "failed again");
    assert.equal(await other.run("return document.getElementById('scene').value"), "# mine");
  });
});

test("a worker that dies while it is asked is started anew, and the answer follows", () => {
  const script = "window.workers = []; const Real = Worker; window.Worker = class extends Real { constructor(...given) { super(...given); window.workers.push(this); } };";
  return opened(script, async (other) => {
    const before = await other.run("return window.workers.length");
    await other.run(`const load = document.getElementById("load"); load.value = "77 N"; load.dispatchEvent(new Event("change", { bubbles: true }));
      window.workers[0].onmessage({ data: { id: 0, died: "unreachable" } })`);
    await other.until("return document.documentElement.dataset.state === 'ready' && document.getElementById('load').dataset.newtons === '77'", "the answer");
    assert.equal(await other.run("return window.workers.length"), before + 1);
    assert.ok((await other.run("return document.querySelectorAll('#answers [data-value]').length")) > 10);
    assert.equal(await other.run("return document.getElementById('message').textContent"), "");
  }, "ready");
});

test("a link of another version has a message, and the page opens", () => opened("", async (other) => {
  assert.match(await other.run("return document.getElementById('message').textContent"), /the link has version 2 and this page reads version 1/);
}, "ready", `#s=${Buffer.from('{"version":2,"world":[]}').toString("base64url")}`));

test("without WebAssembly the page says what to do", () => opened("delete window.WebAssembly;", async (other) => {
  assert.match(await other.run("return document.getElementById('message').textContent"), /no WebAssembly: use another browser/);
}));

test("the models page draws every law, and each has its page in the guide", async () => {
  const models = site.url.replace("index.html", "models.html");
  await browser.go(models);
  await browser.until(SETTLED, "all laws");
  assert.equal(await phase(), "ready");
  assert.ok((await browser.run("return document.querySelectorAll('#laws svg').length")) >= 9);
  assert.match(await browser.run("return document.getElementById('ke').textContent"), /Kinks or jumps at 1, 6, 110/);
  const links = await browser.run("return [...new Set([...document.querySelectorAll('#laws a')].map((link) => link.href))]");
  for (const link of links) assert.equal((await fetch(link)).status, 200, link);
  assert.deepEqual(await browser.errors(), []);
});
