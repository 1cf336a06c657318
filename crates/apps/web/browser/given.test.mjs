// Files that are given to the page, and the form of the surface.
import assert from "node:assert/strict";
import { closeSync, ftruncateSync, openSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { example, explorer, field, SETTLED } from "./harness.mjs";
import { matrix } from "./files.mjs";

let page;
before(async () => (page = await explorer()));
after(() => page?.end());

const STEEL = 'nominal_area = "1 cm2"\nrigid_counterface = true\n[[body]]\nyoungs_modulus = "210 GPa"\npoissons_ratio = 0.3\nhardness = "2 GPa"\n';
const scan = matrix();
// Heights without their unit.
const bare = scan.replace(/^# Value units.*\n/m, "");
const torn = "PK\u0003\u0004 nothing";

// Drops files, each a name and a text.
async function drop(...list) {
  await page.run(`const dataTransfer = new DataTransfer();
    for (const [name, text] of arguments[0]) dataTransfer.items.add(new File([text], name));
    window.dispatchEvent(new DragEvent("drop", { dataTransfer, cancelable: true }));`, list);
  await page.browser.until(SETTLED, JSON.stringify(list.map(([name]) => name)));
}
const state = async () => [await page.phase(), await page.text("message"), await page.text("scene-error")];
const GOOD = ["ready", "", ""];
const kept = async () => [await page.phase(), await page.value("scene"), await page.values()];

test("scenes are dropped", async () => {
  await drop(["own.toml", example("lapped-seal")]);
  assert.deepEqual([await page.value("scene"), ...(await state())], [example("lapped-seal"), ...GOOD]);
  const text = `${STEEL}[surface]\nfile = "scans/a.txt"\nunit = "nm"\n`;
  await drop(["a.txt", bare], ["scene.txt", text]);
  assert.deepEqual([await page.value("scene"), ...(await state())], [text, ...GOOD]);
  // A scene without its scan waits for it.
  const later = text.replace("a.txt", "later.txt");
  await drop(["own.toml", later]);
  assert.equal(await page.phase(), "failed");
  await drop(["later.txt", bare.replace("# Width", "# width")]);
  assert.deepEqual([await page.value("scene"), ...(await state())], [later, ...GOOD]);
});

test("wrong files", async () => {
  await page.scene(example("wheel-rail"));
  await drop(["kept.txt", scan]);
  const before = await kept();
  for (const [name, text] of [["torn.toml", "nominal_area = "], ["other.toml", "a = 1\n"], ["torn.x3p", torn], ["empty.x3p", ""], ["most.txt", matrix({ missing: 57 })]]) {
    await drop([name, text]);
    assert.ok((await page.text("message")).startsWith(name), name);
    assert.deepEqual(await kept(), before, name);
  }
  const path = join(page.scratch, "large.x3p");
  const file = openSync(path, "w");
  ftruncateSync(file, 2 ** 31);
  closeSync(file);
  await page.browser.type("#scan", path);
  await page.browser.until(`return document.getElementById("message").textContent.startsWith("large.x3p")`, "the message", 10);
  assert.deepEqual(await kept(), before);
  await page.run(`document.querySelector("#message .close").click()`);
  assert.equal(await page.run(`return document.getElementById("message").hidden`), true);
});

test("missing points", async () => {
  await page.file("masked.txt", matrix({ missing: 20 }));
  await page.run(`document.querySelector("#message button").click()`);
  await page.browser.until(SETTLED);
  assert.deepEqual(await state(), GOOD);
  assert.match(await page.value("scene"), /max_missing = 0\.32/);
});

test("several files", async () => {
  await page.scene(example("wheel-rail"));
  await drop(["a.txt", scan], ["b.txt", scan]);
  assert.match(await page.text("message"), /^a\.txt .* b\.txt/);
  await drop(["own.toml", example("lapped-seal")], ["b.txt", scan]);
  assert.ok((await page.text("message")).startsWith("b.txt"));
  assert.equal(await page.value("scene"), example("lapped-seal"));
});

test("another scan", async () => {
  await page.scene(example("wheel-rail"));
  await drop(["bare.txt", bare]);
  assert.equal(await page.phase(), "failed");
  await page.change([field("surface.unit"), "um"], [field("surface.level"), "mean"]);
  const sq = async () => Number((await page.all("#scan-numbers td", "title"))[0]);
  const first = await sq();
  await drop(["own.txt", scan]);
  assert.deepEqual([await page.value("field-surface-unit"), await page.value("field-surface-level"), ...(await state())], ["", "mean", ...GOOD]);
  // The same name is read anew.
  await drop(["own.txt", matrix({ amplitude: 300 })]);
  assert.ok(Math.abs((await sq()) / first / 3e-3 - 1) < 0.01, `${await sq()} ${first}`);
});

test("links of scans", async () => {
  await page.change(["#load", "321 N"]);
  const [link, before, values] = [await page.run(`return location.href`), await page.value("scene"), await page.values()];
  await page.browser.go("about:blank");
  await page.browser.go(link);
  await page.browser.until(SETTLED);
  assert.match(await page.text("message"), /own\.txt \(checksum [0-9a-f]{32}\)/);
  assert.deepEqual([await page.value("scene"), await page.value("load")], [before, "321 N"]);
  await page.file("own.txt", scan);
  assert.match(await page.text("message"), /own\.txt .*[0-9a-f]{32}/);
  // The same heights under another name are those of the link.
  await page.file("renamed.txt", matrix({ amplitude: 300 }));
  assert.deepEqual([await page.value("scene"), await page.values(), await page.text("message")], [before, values, ""]);
});

test("nothing becomes markup", async () => {
  const sly = `<img src=x onerror="document.title=1"><b id=sly>`;
  await page.scene(example("wheel-rail").replace(/hardness = .*/, `hardness = '${sly}'`));
  assert.match(await page.text("scene-error"), /<b id=sly>/);
  await page.scene(example("wheel-rail"));
  await page.file(`<b id=sly>"&.txt`, scan);
  assert.match(await page.value("scene"), /<b id=sly>/);
  await page.file("<b id=sly>.x3p", torn);
  assert.match(await page.text("message"), /<b id=sly>/);
  assert.deepEqual([await page.all("#sly"), await page.phase()], [[], "ready"]);
});

test("other surfaces", async () => {
  await page.scene(example("bolted-joint"));
  const given = await page.value("scene");
  const first = await page.value("way");
  for (const way of ["finish", "moments", first]) await page.change(["#way", way]);
  assert.equal(await page.value("scene"), given);
  for (const k of [1, 2]) await page.change([`#material-${k}`, "steel-1040-cold-drawn"]);
  await page.change(["#way", "finish"]);
  await page.change([field("surface.ra"), "0.8"]);
  await page.change([field("surface.finish"), "ground"], [field("nominal_area"), "1 cm2"]);
  await page.change(["#load", "5 MPa"]);
  assert.deepEqual([await page.value("field-surface-ra"), await page.value("other-surface")], ["0.8 um", "same"]);
  const found = async () => {
    const { value, lower, upper } = await page.cell("answer", "tangent");
    return [[value, lower, upper].map((x) => Number((x / 1e9).toPrecision(3))), await page.run(`return document.getElementById("other-fields").hidden`)];
  };
  // By the program with a counterface like the surface, and without one.
  assert.deepEqual(await found(), [[1.11, 0.777, 2.24], true]);
  await page.change(["#other-surface", "smooth"]);
  assert.deepEqual(await found(), [[1.57, 1.1, 2.88], true]);
  await page.change(["#other-surface", "another"]);
  assert.deepEqual(await found(), [[1.11, 0.777, 2.24], false]);
  await page.change([field("surface.ra"), "1.6"]);
  assert.equal(await page.value("field-surface-counterface-ra"), "0.8 um");
  // A table is in the middle of the ranges.
  assert.deepEqual([(await page.all("#export-model option")).length, ...(await page.disabled("save-table"))], [4, false]);
});

test("curved bodies", async () => {
  await page.scene(example("ground-steel"));
  await page.change([field("curvature.radius"), "10 mm"]);
  assert.deepEqual(await page.all(field("nominal_area")), []);
  await page.change(["#load", "50 N"]);
  assert.ok((await page.cell("answer", "peak-pressure")).value > 0);
  await page.change(["#load", "5 MPa"]);
  assert.match(await page.text("load-error"), /no nominal area/);
  await page.change(["#load", "20 N"], [field("curvature.radius"), ""]);
  assert.equal(await page.value("field-nominal-area"), "1 cm2");
  assert.deepEqual(await state(), GOOD);
});
