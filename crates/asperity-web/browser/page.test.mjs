// The explorer in a real browser. `node --test crates/asperity-web/browser` after `cargo xtask page`;
// ASPERITY names the program whose numbers the page must show.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { after, before, test } from "node:test";
import { open } from "./webdriver.mjs";
import { serve } from "./server.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");
const folder = join(root, "target/page");
const scratch = mkdtempSync(join(tmpdir(), "asperity-page-"));
const program = process.env.ASPERITY;
const READY = "return document.documentElement.dataset.state === 'ready' && document.documentElement.dataset.elements !== 'busy'";
const SETTLED = "return ['ready', 'failed'].includes(document.documentElement.dataset.state)";
let site, browser;

before(async () => {
  site = await serve(folder);
  browser = await open({ downloads: scratch });
  await browser.go(site.url);
  await browser.until(READY, "the first page");
});
after(async () => {
  await browser?.close();
  site?.close();
});

const text = (id) => browser.run("return document.getElementById(arguments[0]).textContent", id);
const scene = () => browser.run("return document.getElementById('scene').value");
const values = () => browser.run(`return Object.fromEntries([...document.querySelectorAll('#answers [data-value]')]
  .map(({ dataset: { model, quantity, value, bound } }) => [model + ' ' + quantity, [value, bound]]))`);

async function set(id, value, event = "change") {
  await browser.run(`const field = document.getElementById(arguments[0]);
    field.value = arguments[1]; document.documentElement.dataset.state = 'busy';
    field.dispatchEvent(new Event(arguments[2], { bubbles: true }))`, id, value, event);
  await browser.until(SETTLED, `${id} = ${value}`);
}
const setScene = (text) => set("scene", text, "input");

async function give(name, bytes) {
  const path = join(scratch, name);
  writeFileSync(path, bytes);
  await browser.run("document.documentElement.dataset.state = 'waiting'; document.getElementById('message').hidden = true");
  await browser.type("#scan", path);
  await browser.until("return document.documentElement.dataset.state !== 'waiting' && document.documentElement.dataset.state !== 'busy' || !document.getElementById('message').hidden", name);
}

const EXAMPLES = ["wheel-rail", "bolted-joint", "elastomer-on-glass", "lapped-seal", "ground-steel"];
const example = (name) => readFileSync(join(root, `crates/asperity-scene/examples/${name}.toml`), "utf8");

test("the page opens with a curve, boundary elements and a map, and asks nobody else", async () => {
  const found = await values();
  assert.ok(Number(found["ke area-fraction"][0]) > 0, JSON.stringify(found));
  assert.ok(await browser.run("return document.querySelector('#curve svg') && document.querySelector('#contact svg image') !== null"));
  assert.ok((await browser.run("return document.querySelectorAll('[data-model=bem][data-quantity=area-fraction]').length")) >= 5);
  const origin = new URL(site.url).origin;
  const elsewhere = (await browser.requests()).filter((url) => !url.startsWith(origin) && !/^(data|blob|about|chrome)/.test(url));
  assert.deepEqual(elsewhere, []);
  assert.deepEqual(await browser.errors(), []);
});

test("the module is at most 1.3 MB gzipped", () => {
  const bytes = gzipSync(readFileSync(join(folder, "asperity_bg.wasm")), { level: 9 }).length;
  assert.ok(bytes <= 1.3e6, `${bytes} bytes`);
});

test("numbers are those of the program", { skip: !program }, async () => {
  let compared = 0;
  for (const name of EXAMPLES) {
    await setScene(example(name));
    for (const load of ["10", "250"]) {
      await set("load", `${load} N`);
      const found = await values();
      const models = [...new Set(Object.keys(found).map((key) => key.split(" ")[0]))];
      const quantities = [...new Set(Object.keys(found).map((key) => key.split(" ")[1]))].filter((name) => name !== "separation");
      writeFileSync(join(scratch, "scene.toml"), example(name));
      const args = ["curve", join(scratch, "scene.toml"), "--model", models.join(), "--load", load, "--quantity", quantities.join(), "--format", "json"];
      // The program fails after findings of errors, with its table written.
      for (const row of JSON.parse(spawnSync(program, args, { encoding: "utf8" }).stdout || "[]")) {
        for (const quantity of quantities) {
          const [value, bound] = found[`${row.model} ${quantity}`] ?? [];
          if (value === undefined) continue;
          const column = Object.keys(row).find((key) => key.startsWith(quantity.replaceAll("-", "_")) && !/per_area|error/.test(key.slice(quantity.length)));
          const wanted = row[column];
          const error = Math.abs(Number(value) / wanted - 1);
          assert.ok(error <= Math.max(1e-13, Number(bound)), `${name} ${row.model} ${quantity}: ${value} ${wanted}`);
          compared += 1;
        }
      }
    }
  }
  assert.ok(compared > 100, `${compared} numbers`);
});

test("a wrong unit is marked at its field and its line, and the page goes on", async () => {
  const good = example("wheel-rail");
  await setScene(good.replace(/youngs_modulus = .*/, 'youngs_modulus = "210 mm"'));
  assert.equal(await browser.run("return document.querySelector('[data-path=\"body[1].youngs_modulus\"]').getAttribute('aria-invalid')"), "true");
  const line = 1 + good.split("\n").findIndex((line) => line.startsWith("youngs_modulus"));
  assert.match(await text("scene-error"), new RegExp(`^line ${line}: body\\[1\\]\\.youngs_modulus is "210 mm"`));
  assert.equal(await browser.run("return document.querySelector('#lines b').textContent"), String(line));
  await setScene(good.replace(/youngs_modulus = .*/, "youngs_modulus = 210"));
  assert.match(await browser.run("return document.querySelector('[data-path=\"body[1].youngs_modulus\"]').closest('.row').textContent"), /210 looks like GPa/);
  await setScene(good);
  assert.equal(await browser.run("return document.documentElement.dataset.state"), "ready");
});

test("a scan of each kind is read, and a bad one has a message", async () => {
  const wave = (k) => 1e-7 * (Math.sin(0.7 * (k % 64)) + Math.cos(0.9 * Math.floor(k / 64)) + Math.sin(0.5 * (k % 64) - 0.8 * Math.floor(k / 64)));
  const heights = Array.from({ length: 4096 }, (_, k) => wave(k));
  const lines = Array.from({ length: 64 }, (_, y) => heights.slice(64 * y, 64 * y + 64).join(" ")).join("\n");
  await setScene(example("wheel-rail"));
  await give("scan.txt", lines);
  assert.match(await text("scene-error"), /surface.*unit|pixel/);
  const named = (await scene()).replace('file = "scan.txt"', 'file = "scan.txt"\nunit = "m"\npixel_size = 1e-6');
  await setScene(named);
  assert.equal(await text("scene-error"), "");
  assert.ok(!(await browser.run("return document.getElementById('scan-report').hidden")));
  for (const [name, bytes, said] of [
    ["empty.x3p", "", /empty \(0 bytes\)/],
    ["corrupt.x3p", "PK\u0003\u0004 nothing", /corrupt\.x3p/],
    ["nan.txt", lines.replaceAll(/\S+/g, "nan"), /nan\.txt/],
  ]) {
    await give(name, bytes);
    const shown = `${await text("message")} ${await text("scene-error")}`;
    assert.match(shown, said);
  }
  await setScene(example("wheel-rail"));
  assert.equal(await browser.run("return document.documentElement.dataset.state"), "ready");
});

test("nothing of a scene or a file name becomes markup", async () => {
  const sly = '<img src=x onerror="document.title=1"><b id=sly>';
  await setScene(example("wheel-rail").replace(/hardness = .*/, `hardness = '${sly}'`));
  await give("<b id=sly>.txt".replace(/[<>]/g, "_"), "1");
  assert.equal(await browser.run("return document.getElementById('sly')"), null);
  assert.match(await browser.run("return document.title"), /asperity/);
});

test("a scene of 10 000 keys is refused at a line", async () => {
  const keys = Array.from({ length: 10000 }, (_, k) => `key${k} = ${k}`).join("\n");
  await setScene(`${keys}\n${example("wheel-rail")}`);
  assert.match(await text("scene-error"), /^line 1: key0 is not known/);
  await setScene(example("wheel-rail"));
  assert.equal(await browser.run("return document.documentElement.dataset.state"), "ready");
});

test("a link restores everything in a fresh profile, and a damaged one has a message", async () => {
  await setScene(example("lapped-seal"));
  await set("load", "123 N");
  const [link, before] = [await browser.until("return location.hash.startsWith('#s=') && location.href"), await values()];
  const fresh = await open();
  try {
    await fresh.go(link);
    await fresh.until(READY);
    assert.equal(await fresh.run("return document.getElementById('load').value"), "123 N");
    assert.equal(await fresh.run("return document.getElementById('scene').value"), example("lapped-seal"));
    const after = await fresh.run(`return Object.fromEntries([...document.querySelectorAll('#answers [data-value]')]
      .map(({ dataset: { model, quantity, value } }) => [model + ' ' + quantity, value]))`);
    assert.deepEqual(after, Object.fromEntries(Object.entries(before).map(([key, [value]]) => [key, value])));
    await fresh.go("about:blank");
    await fresh.go(`${site.url}#s=${link.split("#s=")[1].slice(0, 40)}`);
    await fresh.until(READY);
    assert.match(await fresh.run("return document.getElementById('message').textContent"), /damaged or incomplete/);
  } finally {
    await fresh.close();
  }
});

test("a solution stops within 200 ms and can be started again", async () => {
  await browser.run("document.getElementById('random-pixels').value = '1024'; document.getElementById('random-shortest').value = '2 um'; document.getElementById('make-random').click()");
  await browser.until("return document.getElementById('elements-note').textContent.includes('1024')", "a surface of 1024 pixels");
  await browser.until(READY);
  await browser.run("document.getElementById('solve').click()");
  await browser.until("return document.getElementById('iterations').textContent.includes('iteration')", "progress");
  const took = await browser.run("const start = performance.now(); document.getElementById('stop').click(); return document.documentElement.dataset.elements === 'ready' ? performance.now() - start : 1e9");
  assert.ok(took < 200, `${took} ms`);
  await browser.run("document.getElementById('random-pixels').value = '128'; document.getElementById('random-shortest').value = '12.5 um'; document.getElementById('make-random').click()");
  await browser.until("return document.getElementById('elements-note').textContent.includes('128')", "a surface of 128 pixels");
  await browser.until(READY);
  await browser.run("document.getElementById('solve').click()");
  await browser.until("return document.querySelectorAll('[data-model=bem][data-quantity=area-fraction]').length >= 5", "solved loads");
});

test("from the load to the csv by keys alone", async () => {
  await setScene(example("wheel-rail"));
  await browser.run("document.getElementById('load').focus()");
  let focused = "load";
  for (let k = 0; k < 80 && focused !== "save-csv"; k++) {
    await browser.keys(["\uE004"]);
    focused = await browser.run("return document.activeElement.id");
  }
  assert.equal(focused, "save-csv");
  await browser.keys(["\uE007"]);
  for (let k = 0; k < 50 && !readdirSync(scratch).includes("asperity.csv"); k++) await new Promise((resolve) => setTimeout(resolve, 100));
  assert.match(readFileSync(join(scratch, "asperity.csv"), "utf8"), /^model,load_N,pressure_Pa,separation_m,area_fraction/);
});

test("every control has a name, and no width scrolls sideways", async () => {
  const unnamed = await browser.run(`return [...document.querySelectorAll('input, select, textarea, button')]
    .filter((one) => !one.labels?.length && !one.getAttribute('aria-label') && !one.textContent.trim()).map((one) => one.outerHTML)`);
  assert.deepEqual(unnamed, []);
  for (const [width, height] of [[360, 800], [1280, 900], [2560, 1300]]) {
    for (const dark of [false, true]) {
      const other = await open({ width, height, dark });
      try {
        await other.call("POST", "/goog/cdp/execute", { cmd: "Emulation.setDeviceMetricsOverride", params: { width, height, deviceScaleFactor: 1, mobile: false } });
        await other.call("POST", "/goog/cdp/execute", { cmd: "Emulation.setEmulatedMedia", params: { features: [{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }] } });
        await other.go(site.url);
        await other.until(READY);
        assert.ok(await other.run("const { scrollWidth, clientWidth } = document.documentElement; return scrollWidth <= clientWidth"), `${width} px`);
        if (process.env.SHOTS) writeFileSync(join(process.env.SHOTS, `page-${width}-${dark ? "dark" : "light"}.png`), await other.picture());
        assert.deepEqual(await other.errors(), []);
      } finally {
        await other.close();
      }
    }
  }
});
