// The explorer as a whole: what it opens with, findings at their fields, links, keys, widths.
import assert from "node:assert/strict";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { example, explorer, READY } from "./harness.mjs";

let page;
before(async () => (page = await explorer()));
after(() => page?.end());

const field = (path) => `document.querySelector('[data-path="${path}"]')`;
const pixels = (side, shortest) => page.run(`document.getElementById('random-pixels').value = arguments[0];
  document.getElementById('random-shortest').value = arguments[1]; document.getElementById('make-random').click()`, side, shortest);

test("the page opens with a curve, boundary elements and a map", async () => {
  const found = await page.values();
  assert.ok(Number(found["ke area-fraction"][0]) > 0, JSON.stringify(found));
  await page.browser.until(READY);
  assert.ok(await page.run("return document.querySelector('#curve svg') && document.querySelector('#contact svg image') !== null"));
  assert.ok((await page.run("return document.querySelectorAll('[data-model=bem][data-quantity=area-fraction]').length")) >= 5);
});

test("a wrong unit is marked at its field and its line, and the page goes on", async () => {
  const good = example("wheel-rail");
  await page.scene(good.replace(/youngs_modulus = .*/, 'youngs_modulus = "210 mm"'));
  assert.equal(await page.run(`return ${field("body[1].youngs_modulus")}.getAttribute('aria-invalid')`), "true");
  const line = 1 + good.split("\n").findIndex((line) => line.startsWith("youngs_modulus"));
  assert.match(await page.text("scene-error"), new RegExp(`^line ${line}: body\\[1\\]\\.youngs_modulus = "210 mm" is not`));
  assert.equal(await page.run("return document.querySelector('#lines b').textContent"), String(line));
  await page.scene(good.replace(/youngs_modulus = .*/, "youngs_modulus = 210"));
  assert.match(await page.run(`return ${field("body[1].youngs_modulus")}.closest('.row').textContent`), /210 looks like GPa/);
  await page.scene(good);
  assert.equal(await page.phase(), "ready");
});

test("a scene of 10 000 keys is refused at a line", async () => {
  const keys = Array.from({ length: 10000 }, (_, k) => `key${k} = ${k}`).join("\n");
  await page.scene(`${keys}\n${example("wheel-rail")}`);
  assert.match(await page.text("scene-error"), /^line 1: key0 is not known/);
  await page.scene(example("wheel-rail"));
  assert.equal(await page.phase(), "ready");
});

test("a link restores everything in a fresh profile, and a damaged one has a message", async () => {
  await page.scene(example("lapped-seal"));
  await page.change(["#load", "123 N"]);
  const link = await page.browser.until("return location.hash.startsWith('#s=') && location.href");
  const hash = link.slice(link.indexOf("#"));
  const before = await page.values();
  const fresh = await explorer({ address: (url) => url + hash });
  try {
    assert.deepEqual([await fresh.value("load"), await fresh.value("scene")], ["123 N", example("lapped-seal")]);
    assert.deepEqual(await fresh.values(), before);
    const other = Buffer.from(JSON.stringify({ version: 99, scene: "" })).toString("base64url");
    for (const [wrong, wanted] of [[hash.slice(0, 40), /damaged or incomplete/], [`#s=${other}`, /version|damaged/], ["#s=<b id=sly>", /damaged/]]) {
      await fresh.browser.go("about:blank");
      await fresh.browser.go(fresh.site.url + wrong);
      await fresh.browser.until(READY);
      assert.match(await fresh.text("message"), wanted);
      assert.ok(Object.keys(await fresh.values()).length > 5);
    }
  } finally {
    await fresh.end();
  }
});

test("two tabs work side by side", async () => {
  await page.scene(example("wheel-rail"));
  const first = await page.browser.call("GET", "/window");
  const { handle } = await page.browser.call("POST", "/window/new", { type: "tab" });
  await page.browser.call("POST", "/window", { handle });
  await page.browser.go(page.site.url);
  await page.browser.until(READY, "the second tab");
  await page.scene(example("bolted-joint"));
  assert.ok(Object.keys(await page.values()).length > 5);
  await page.browser.call("DELETE", "/window");
  await page.browser.call("POST", "/window", { handle: first });
  assert.deepEqual([await page.value("scene"), await page.phase()], [example("wheel-rail"), "ready"]);
});

test("the page needs no storage", async () => {
  const denied = `for (const name of ["localStorage", "sessionStorage", "indexedDB", "caches"])
    Object.defineProperty(window, name, { get() { throw new DOMException("denied", "SecurityError"); } });`;
  const other = await explorer({ script: denied });
  try {
    assert.equal(await other.phase(), "ready");
  } finally {
    await other.end();
  }
});

test("a solution stops within 200 ms and can be started again", async () => {
  const { run, browser } = page;
  await pixels("1024", "2 um");
  await browser.until("return document.getElementById('elements-note').textContent.includes('1024')", "a surface of 1024 pixels");
  await browser.until(READY);
  await run("document.getElementById('solve').click()");
  await browser.until("return document.getElementById('iterations').textContent.includes('iteration')", "progress");
  const took = await browser.later(`const start = performance.now();
    document.getElementById('stop').click();
    while (document.documentElement.dataset.state === 'busy') await new Promise((done) => setTimeout(done));
    return performance.now() - start`);
  assert.ok(took < 200, `${took} ms`);
  await pixels("128", "12.5 um");
  await browser.until("return document.getElementById('elements-note').textContent.includes('128')", "a surface of 128 pixels");
  await browser.until(READY);
  await run("document.getElementById('solve').click()");
  await browser.until("return document.querySelectorAll('[data-model=bem][data-quantity=area-fraction]').length >= 5", "solved loads");
});

test("from the load to the csv by keys alone", async () => {
  await page.scene(example("wheel-rail"));
  await page.run("document.activeElement.blur()");
  const tabTo = async (id) => {
    for (let k = 0; k < 120; k++) {
      if ((await page.run("return document.activeElement.id")) === id) return;
      await page.browser.keys(["\uE004"]);
    }
    assert.fail(`${id} is not reached`);
  };
  await tabTo("load");
  await page.browser.keys([..."\uE010"].concat(Array(12).fill("\uE003"), [..."77 N"]));
  await tabTo("tab-findings");
  // The last of the sections below.
  await page.browser.keys(["\uE012"]);
  await tabTo("save-csv");
  await page.browser.until(READY);
  assert.equal(await page.run("return document.getElementById('load').dataset.newtons"), "77");
  await page.browser.keys(["\uE007"]);
  for (let k = 0; k < 50 && !readdirSync(page.scratch).includes("asperity.csv"); k++) await new Promise((resolve) => setTimeout(resolve, 100));
  assert.match(readFileSync(join(page.scratch, "asperity.csv"), "utf8"), /^model,load_N,pressure_Pa,separation_m,area_fraction/);
});

test("every control has a name, and no width scrolls sideways", async () => {
  const unnamed = await page.run(`return [...document.querySelectorAll('input, select, textarea, button')]
    .filter((one) => !one.labels?.length && !one.getAttribute('aria-label') && !one.textContent.trim()).map((one) => one.outerHTML)`);
  assert.deepEqual(unnamed, []);
  for (const [width, height] of [[360, 800], [1280, 900], [2560, 1300]]) {
    await page.browser.cdp("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });
    for (const value of ["light", "dark"]) {
      await page.browser.cdp("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value }] });
      assert.ok(await page.run("const { scrollWidth, clientWidth } = document.documentElement; return scrollWidth <= clientWidth"), `${width} px`);
      if (process.env.SHOTS) writeFileSync(join(process.env.SHOTS, `page-${width}-${value}.png`), await page.browser.picture());
    }
  }
});

test("what is printed fits the sheet", async () => {
  for (const [name, sheets] of [["bolted-joint", 1], ["made-here", 4]]) {
    await page.change(["#example", name]);
    await page.browser.until(READY);
    // The width of A4 between margins of 10 mm.
    const width = Math.round((190 / 25.4) * 96);
    await page.browser.cdp("Emulation.setEmulatedMedia", { media: "print" });
    await page.browser.cdp("Emulation.setDeviceMetricsOverride", { width, height: 1000, deviceScaleFactor: 1, mobile: false });
    const wide = await page.run(`return [...document.querySelectorAll("main *")].filter((one) => one.getClientRects().length > 0 && !one.closest("svg, .unseen"))
      .filter((one) => one.getBoundingClientRect().right > arguments[0] + 1 || one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).overflowX !== "visible")
      .map((one) => one.outerHTML.slice(0, 100))`, width);
    assert.deepEqual(wide, []);
    assert.ok(await page.run("return document.getElementById('load').getClientRects().length > 0"));
    await page.browser.cdp("Emulation.setEmulatedMedia", { media: "" });
    await page.browser.cdp("Emulation.clearDeviceMetricsOverride", {});
    const { data } = await page.browser.cdp("Page.printToPDF", { paperWidth: 210 / 25.4, paperHeight: 297 / 25.4, preferCSSPageSize: true });
    const pdf = Buffer.from(data, "base64").toString("latin1");
    assert.ok(pdf.match(/\/Type\s*\/Page\b/g).length <= sheets, `${name}: ${pdf.match(/\/Type\s*\/Page\b/g).length} sheets`);
  }
});
