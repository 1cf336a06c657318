// What the explorer does with quick edits, dead workers, other files, errors and its history.
import assert from "node:assert/strict";
import { closeSync, ftruncateSync, openSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { example, explorer, SETTLED } from "./harness.mjs";

let page;
before(async () => (page = await explorer()));
after(() => page?.end());

const field = (path) => `[data-path="${path}"]`;
const heights = (amplitude, count = 64) => Array.from({ length: count }, (_, y) => Array.from({ length: count }, (_, x) =>
  amplitude * (Math.sin(0.7 * x) + Math.cos(0.9 * y) + Math.sin(0.5 * x - 0.8 * y))).join(" ")).join("\n");

test("edits that follow at once are all in the scene, also while boundary elements are solved", async () => {
  await page.run("document.getElementById('solve').click()");
  assert.equal(await page.phase(), "busy");
  await page.change([field("body[1].youngs_modulus"), "190 GPa"], [field("body[1].poissons_ratio"), "0.29"], [field("body[2].youngs_modulus"), "180 GPa"], ["#load", "321 N"], ["#view", "tangent"]);
  const scene = await page.value("scene");
  for (const wanted of ['"190 GPa"', "0.29", '"180 GPa"']) assert.ok(scene.includes(wanted), wanted);
  assert.equal(await page.value("load"), "321 N");
  assert.match(await page.run("return document.querySelector('#curve svg').getAttribute('aria-label')"), /stiffness against the load/);
  assert.equal(await page.run("return document.querySelector('[data-path=\"body[1].poissons_ratio\"]').value"), "0.29");
});

test("boundary elements that are solved do not end an answer, and a text being typed is kept", async () => {
  await page.run("document.getElementById('solve').click()");
  for (const load of [100, 200, 400, 800]) {
    await page.run(`const field = document.getElementById("load"); field.value = arguments[0];
      field.dispatchEvent(new Event("change", { bubbles: true }))`, `${load} N`);
  }
  await page.run(`const field = document.querySelector('[data-path="nominal_area"]'); field.focus(); field.value = "3 m";
    field.dispatchEvent(new Event("input", { bubbles: true }))`);
  await page.browser.until(SETTLED);
  assert.equal(await page.run("return document.getElementById('load').dataset.newtons"), "800");
  assert.equal(await page.run("return document.querySelector('[data-path=\"nominal_area\"]').value"), "3 m");
  assert.ok((await page.run("return document.querySelectorAll('[data-model=bem][data-quantity=area-fraction]').length")) >= 5);
  await page.run("document.querySelector('[data-path=\"nominal_area\"]').blur()");
  await page.browser.until(SETTLED);
});

test("the unit changes the text of the load and not the load", async () => {
  await page.scene(example("wheel-rail"));
  await page.change(["#load", "1234.5 N"]);
  const tangent = () => page.run("return document.querySelector('#answers [data-quantity=tangent]').dataset.value");
  const first = await tangent();
  await page.change(["#unit", "Pa"]);
  assert.match(await page.value("load"), /Pa$/);
  assert.ok(Math.abs((await tangent()) / first - 1) < 1e-12);
  await page.change(["#unit", "N"]);
  assert.equal(await page.value("load"), "1.2345 kN");
  await page.change(["#unit", "Pa"], ["#load", "2e6"]);
  assert.deepEqual([await page.value("load"), await page.value("unit")], ["2e6 Pa", "Pa"]);
  const link = await page.run("return location.href");
  await page.browser.go("about:blank");
  await page.browser.go(link);
  await page.browser.until(SETTLED);
  assert.equal(await page.run("return document.getElementById('load').dataset.pascals"), "2000000");
});

test("back and forward restore what was there before each change", async () => {
  await page.scene(example("bolted-joint"));
  await page.change(["#view", "area-fraction"]);
  await page.change(["#view", "tangent"]);
  await page.change([field("nominal_area"), "2 cm2"]);
  assert.match(await page.value("scene"), /2 cm2/);
  await page.run("history.back()");
  await page.browser.until("return !document.getElementById('scene').value.includes('2 cm2')", "the area before");
  await page.browser.until(SETTLED);
  assert.equal(await page.value("view"), "tangent");
  await page.run("history.back()");
  await page.browser.until("return document.getElementById('view').value === 'area-fraction'", "the quantity before");
  await page.run("history.go(2)");
  await page.browser.until("return document.getElementById('scene').value.includes('2 cm2')", "forward");
  await page.browser.until(SETTLED);
  assert.equal(await page.value("view"), "tangent");
  assert.deepEqual(await page.browser.errors(), []);
});

test("after an error no picture, no values and no files of the scene before", async () => {
  await page.scene(example("wheel-rail"));
  assert.ok(await page.run("return Boolean(document.querySelector('#curve svg'))"));
  await page.scene("nominal_area = ");
  assert.equal(await page.phase(), "failed");
  const left = await page.run(`return [document.querySelectorAll('#curve svg, #answers [data-value], #numbers tr').length,
    ...['save-csv', 'save-svg', 'save-png', 'save-table', 'solve'].map((id) => document.getElementById(id).disabled)]`);
  assert.deepEqual(left, [0, true, true, true, true, true]);
  await page.scene(example("wheel-rail"));
  assert.equal(await page.phase(), "ready");
  assert.ok(await page.run("return !document.getElementById('save-csv').disabled"));
});

test("a scan in place of another is treated alike, and one of the same name is read anew", async () => {
  await page.scene(example("wheel-rail"));
  await page.file("one.txt", heights(1e-7));
  await page.scene((await page.value("scene")).replace('file = "one.txt"', 'file = "one.txt"\nunit = "m"\npixel_size = 1e-6\nlevel = "mean"'));
  assert.equal(await page.phase(), "ready");
  const sq = () => page.run("return document.querySelector('#scan-numbers td').title");
  const first = Number(await sq());
  await page.file("two.txt", heights(3e-7));
  assert.match(await page.value("scene"), /file = "two.txt"\nlevel = "mean"/);
  assert.doesNotMatch(await page.value("scene"), /unit|pixel_size/);
  await page.change([field("surface.unit"), "m"], [field("surface.pixel_size"), "1 um"]);
  assert.ok(Math.abs(Number(await sq()) / first - 3) < 1e-6, await sq());
  await page.file("two.txt", heights(5e-7));
  assert.ok(Math.abs(Number(await sq()) / first - 5) < 1e-6, await sq());
});

test("a link asks for its scan, and tells another file from it by the checksum", async () => {
  const link = await page.run("return location.href");
  const before = await page.value("scene");
  await page.browser.go("about:blank");
  await page.browser.go(link);
  await page.browser.until(SETTLED);
  assert.match(await page.text("message"), /made with the scan two\.txt \(checksum [0-9a-f]{32}\)/);
  assert.equal(await page.value("scene"), before);
  await page.file("two.txt", heights(2e-7));
  assert.match(await page.text("message"), /two\.txt is not the file of the link: its checksum is [0-9a-f]{32}/);
  // The same heights under another name are those of the link.
  await page.file("renamed.txt", heights(5e-7));
  assert.equal(await page.text("message"), "");
  assert.deepEqual([await page.phase(), await page.value("scene")], ["ready", before]);
});

test("boundary elements give mean gap and separation, and their notes are shown", async () => {
  await page.run("document.getElementById('solve').click()");
  await page.browser.until(SETTLED);
  const names = Object.keys((await page.solved())[0]);
  for (const name of ["mean-gap", "separation", "area-fraction"]) assert.ok(names.includes(name), String(names));
  assert.match(await page.text("solved-notes"), /warning|note/);
  assert.match(await page.text("scan-caption"), /64 x 64 points/);
});

test("a file of 2 GB is refused by its size", async () => {
  const path = join(page.scratch, "large.x3p");
  const file = openSync(path, "w");
  ftruncateSync(file, 2 ** 31);
  closeSync(file);
  const start = Date.now();
  await page.browser.type("#scan", path);
  await page.browser.until("return /large.x3p has 2048 MB/.test(document.getElementById('message').textContent)", "the message", 10);
  assert.ok(Date.now() - start < 5000);
  assert.match(await page.text("message"), /at most 128 MB: use the program/);
});

test("wrong numbers of a random surface have a message", async () => {
  await page.change(["#random-pixels", "abc"]);
  await page.run("document.getElementById('make-random').click()");
  await page.browser.until("return /random.pixels is \"abc\"/.test(document.getElementById('message').textContent)");
  await page.browser.until(SETTLED);
});

test("rarely needed options of a scan are folded until one is set", async () => {
  await page.scene(example("wheel-rail"));
  await page.file("folded.txt", heights(1e-7));
  const isOpen = () => page.run("return document.getElementById('more').open");
  assert.equal(await isOpen(), false);
  await page.change([field("surface.unit"), "m"], [field("surface.pixel_size"), "1 um"]);
  assert.deepEqual([await page.phase(), await isOpen()], ["ready", false]);
  await page.scene((await page.value("scene")).replace('unit = "m"', 'unit = "m"\nlevel = "quadratic"'));
  assert.deepEqual([await page.phase(), await isOpen()], ["ready", true]);
});

test("values under the pointer come with the picture", async () => {
  await page.scene(example("wheel-rail"));
  await page.change(["#load", "1 MPa"]);
  await page.run("document.querySelectorAll('#curve .reading')[60].dispatchEvent(new PointerEvent('pointerover', { bubbles: true }))");
  assert.match(await page.text("reading"), /Pagw .*ke .*jg /);
  assert.equal(await page.run("return document.querySelectorAll('#curve .reading').length"), 200);
});

test("pressures of the contact map are shown under the pointer", async () => {
  await page.change(["#example", "made-here"]);
  await page.browser.until("return document.querySelector('#contact image')", "a map");
  await page.browser.until(SETTLED);
  const readings = await page.run(`const box = document.querySelector("#contact image").getBoundingClientRect();
    const at = (x, y) => {
      document.getElementById("contact").dispatchEvent(new PointerEvent("pointermove", { clientX: box.left + x * box.width, clientY: box.top + y * box.height }));
      return document.getElementById("contact-reading").textContent;
    };
    return [at(0.001, 0.999), ...Array.from({ length: 4096 }, (_, k) => at(((k % 64) + 0.5) / 64, (Math.floor(k / 64) + 0.5) / 64))]`);
  assert.match(readings[0], /^x 1\.56[23] µm, y 198\.4 µm: /);
  assert.ok(readings.some((text) => /: no contact$/.test(text)) && readings.some((text) => /: up to 7 GPa$/.test(text)), readings[1]);
});

test("the pressure under the pointer is that of its pixel where parts do not divide the columns", async () => {
  await page.scene(example("wheel-rail"));
  await page.file("odd.txt", heights(1e-7, 130));
  await page.change([field("surface.unit"), "m"], [field("surface.pixel_size"), "1 um"]);
  await page.run("document.getElementById('solve-load').click()");
  await page.browser.until("return document.querySelector('#contact image')", "a map");
  await page.browser.until(SETTLED);
  const [inside, last] = await page.run(`const box = document.querySelector("#contact image").getBoundingClientRect();
    return [128.5, 129.5].map((pixel) => {
      document.getElementById("contact").dispatchEvent(new PointerEvent("pointermove", { clientX: box.left + (pixel / 130) * box.width, clientY: box.top + 1 }));
      return document.getElementById("contact-reading").textContent;
    })`);
  assert.match(inside, /^x 127\.5 µm, y 1\.5 µm: /);
  assert.match(last, /^x 129\.5 µm, y 1\.5 µm: /);
});

test("what to try follows back, a link, a new scan and a typed text", async () => {
  const shown = () => page.run("return document.getElementById('try').hidden ? '' : document.getElementById('tries').textContent");
  await page.change(["#example", "bolted-joint"]);
  const bolted = await shown();
  await page.change(["#example", "lapped-seal"]);
  const lapped = await shown();
  assert.ok(bolted && lapped && bolted !== lapped);
  await page.run("history.back()");
  await page.browser.until("return /bolt/i.test(document.getElementById('scene').value)", "the example before");
  await page.browser.until(SETTLED);
  assert.equal(await shown(), bolted);
  const link = await page.run("return location.href");
  await page.file("own.txt", heights(1e-7));
  assert.equal(await shown(), "");
  await page.browser.go("about:blank");
  await page.browser.go(link);
  await page.browser.until(SETTLED);
  assert.equal(await shown(), bolted);
  await page.scene(example("wheel-rail"));
  assert.equal(await shown(), "");
});

test("what to try beside the example does what it says, and an example can be opened again", async () => {
  await page.change(["#example", "made-here"]);
  assert.ok(await page.run("return !document.getElementById('try').hidden"));
  const press = async (k) => {
    await page.run("document.querySelectorAll('#tries button')[arguments[0]].click()", k);
    await page.browser.until(SETTLED);
    assert.deepEqual([await page.phase(), await page.text("message")], ["ready", ""]);
  };
  await press(0);
  assert.equal(await page.value("view"), "unloading-stiffness");
  await press(1);
  assert.match(await page.value("scene"), /material = "copper/);
  await press(3);
  assert.equal((await page.solved()).length, 1);
  await page.change(["#example", "made-here"]);
  assert.doesNotMatch(await page.value("scene"), /copper/);
  const tries = await page.text("tries");
  await page.change(["#example", "wheel-rail"]);
  assert.notEqual(await page.text("tries"), tries);
});

test("Gao and AT appear when they are ready, and the others are there before", async () => {
  await page.run("for (const id of ['gao', 'at']) document.querySelector(`#models [value=${id}]`).click()");
  await page.browser.until("return document.querySelectorAll('#answers [data-model=ke]').length > 3", "quick models");
  await page.browser.until(SETTLED, "all models");
  const models = await page.run("return [...new Set([...document.querySelectorAll('#answers [data-value]')].map((cell) => cell.dataset.model))]");
  assert.ok(models.includes("gao") && models.includes("at") && models.includes("ke"), String(models));
});

// A fresh page in which a script runs before all others.
async function opened(script, check, phase = "failed", hash = "") {
  const other = await explorer({ script, address: (url) => url + hash });
  try {
    assert.equal(await other.phase(), phase);
    await check(other);
  } finally {
    await other.close();
  }
}

test("a browser that cannot calculate says what it lacks and what to do", async () => {
  for (const [script, wanted] of [
    ["delete window.WebAssembly;", /^This page calculates by WebAssembly, which this browser does not have .* or use the program asperity/],
    ["WebAssembly.validate = () => false;", /^This browser is too old .*Safari from 16\.4, or use the program/],
  ]) {
    await opened(script, async (other) => {
      assert.match(await other.text("message"), wanted);
      assert.equal(await other.run("return document.querySelectorAll('#tabs [aria-selected=true]').length"), 1);
    });
  }
});

test("a worker that dies is started anew twice, then the page says so and keeps the text", async () => {
  const script = `window.started = 0; const Real = Worker; window.Worker = class extends Real {
    constructor() { super("missing.js"); window.started += 1; } };`;
  await opened(script, async (other) => {
    assert.equal(await other.run("return window.started"), 3);
    assert.match(await other.text("message"), /3 times in a row/);
    assert.match(await other.value("scene"), /nominal_area/);
    await other.scene("# mine");
    assert.equal(await other.phase(), "failed");
    assert.equal(await other.value("scene"), "# mine");
  });
});

test("a worker that dies while it is asked is started anew, and the answer follows", () => {
  const script = "window.workers = []; const Real = Worker; window.Worker = class extends Real { constructor(...given) { super(...given); window.workers.push(this); } };";
  return opened(script, async (other) => {
    const before = await other.run("return window.workers.length");
    await other.run(`const load = document.getElementById("load"); load.value = "77 N"; load.dispatchEvent(new Event("change", { bubbles: true }));
      window.workers[0].onmessage({ data: { id: 0, died: "unreachable" } })`);
    await other.browser.until("return document.documentElement.dataset.state === 'ready' && document.getElementById('load').dataset.newtons === '77'", "the answer");
    assert.equal(await other.run("return window.workers.length"), before + 1);
    assert.ok((await other.run("return document.querySelectorAll('#answers [data-value]').length")) > 10);
    assert.equal(await other.text("message"), "");
  }, "ready");
});

test("a link of another version has a message, and the page opens", () => opened("", async (other) => {
  assert.match(await other.text("message"), /the link has version 2 and this page reads version 1/);
}, "ready", `#s=${Buffer.from('{"version":2,"world":[]}').toString("base64url")}`));

test("the models page draws every law, and each has its page in the guide", async () => {
  const models = page.site.url.replace("index.html", "models.html");
  await page.browser.go(models);
  await page.browser.until(SETTLED, "all laws");
  assert.equal(await page.phase(), "ready");
  assert.ok((await page.run("return document.querySelectorAll('#laws svg').length")) >= 9);
  assert.match(await page.run("return document.getElementById('ke').textContent"), /Kinks or jumps at 1, 6, 110/);
  assert.match(await page.run("return document.querySelector('#ke pre').textContent"), /F_c = /);
  const links = await page.run("return [...new Set([...document.querySelectorAll('#laws a')].map((link) => link.href))]");
  for (const link of links) assert.equal((await fetch(link)).status, 200, link);
  // Without hardness there is no critical interference.
  await page.browser.go(page.site.url);
  await page.browser.until(SETTLED);
  await page.scene(example("elastomer-on-glass"));
  const { hash } = new URL(await page.run("return location.href"));
  await page.browser.go("about:blank");
  await page.browser.go(models + hash);
  await page.browser.until(SETTLED, "the law of gw");
  assert.match(await page.run("return document.querySelector('#gw svg').textContent"), /interference over σ/);
  assert.deepEqual(await page.browser.errors(), []);
});
