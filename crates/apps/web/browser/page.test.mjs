// The page opens, is restored from its link, and is used by keys and on paper.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { example, explorer, field, READY, SETTLED } from "./harness.mjs";

let page;
before(async () => (page = await explorer()));
after(() => page?.end());

test("everything is there", async () => {
  await page.opened();
  await page.browser.until(READY);
  assert.ok(Number((await page.values())["ke area-fraction"][0]) > 0);
  assert.equal((await page.all("#curve svg, #contact image")).length, 2);
  assert.equal((await page.all("#answer [data-value]")).length, 4);
  assert.ok((await page.all("#numbers sub")).includes("c"));
  for (const k of [0, 1, 2]) {
    await page.run(`document.querySelectorAll("#tries button")[arguments[0]].click()`, k);
    await page.browser.until(READY, `try ${k}`);
  }
});

test("readings", async () => {
  await page.change(["#example", "made-here"]);
  await page.browser.until(READY);
  await page.run(`document.querySelectorAll("#curve .reading")[60].dispatchEvent(new PointerEvent("pointerover", { bubbles: true }))`);
  assert.ok((await page.all("#reading span")).length >= 4);
});

test("links restore everything", async () => {
  await page.scene(example("lapped-seal"));
  await page.choose(["gw", "ke"]);
  await page.change(["#view", "tangent"], ["#load", "123 N"]);
  const hash = await page.browser.until(`return location.hash.startsWith("#s=") && location.hash`);
  const before = await page.values();
  // No storage is needed for that.
  const denied = `for (const name of ["localStorage", "sessionStorage", "indexedDB", "caches"])
    Object.defineProperty(window, name, { get() { throw new DOMException("denied", "SecurityError"); } });`;
  const fresh = await explorer({ script: denied, address: (url) => url + hash });
  try {
    assert.deepEqual([await fresh.value("load"), await fresh.value("view"), await fresh.value("scene")], ["123 N", "tangent", example("lapped-seal")]);
    assert.deepEqual(await fresh.values(), before);
    for (const wrong of [hash.slice(0, 40), "#s=<b id=sly>"]) {
      await fresh.browser.go("about:blank");
      await fresh.browser.go(fresh.site.url + wrong);
      await fresh.browser.until(READY);
      assert.notEqual(await fresh.text("message"), "");
      assert.ok(Object.keys(await fresh.values()).length > 5);
    }
  } finally {
    await fresh.end();
  }
});

test("history goes back", async () => {
  await page.scene(example("bolted-joint"));
  await page.change(["#view", "area-fraction"]);
  await page.change(["#view", "tangent"]);
  await page.change([field("nominal_area"), "2 cm2"]);
  for (const [step, script] of [[-1, `return !document.getElementById("scene").value.includes("2 cm2")`], [-1, `return document.getElementById("view").value === "area-fraction"`],
    [2, `return document.getElementById("scene").value.includes("2 cm2") && document.getElementById("view").value === "tangent"`]]) {
    await page.run(`history.go(arguments[0])`, step);
    await page.browser.until(script);
    await page.browser.until(SETTLED);
  }
});

test("keys reach everything", async () => {
  await page.scene(example("wheel-rail"));
  await page.run(`document.activeElement.blur(); scrollTo(0, 0)`);
  const tabTo = async (id, most) => {
    for (let k = 0; k < most; k++) {
      await page.browser.keys(["\uE004"]);
      if ((await page.run(`return document.activeElement.id`)) === id) return;
    }
    assert.fail(`${id} is not reached`);
  };
  await tabTo("load", 12);
  await page.browser.keys([..."\uE010"].concat(Array(12).fill("\uE003"), [..."77 N"]));
  await tabTo("tab-findings", 120);
  // The last of the sections below, and back.
  await page.browser.keys(["\uE012"]);
  await tabTo("save-csv", 4);
  await page.browser.until(READY);
  assert.equal(await page.run(`return document.getElementById("load").dataset.newtons`), "77");
  await page.browser.keys(["\uE007"]);
  assert.match(await page.saved("asperity.csv", "status"), /^model,load_N,pressure_Pa,separation_m,area_fraction/);
  await page.run(`document.getElementById("to-answers").focus()`);
  await page.browser.keys(["\uE007"]);
  assert.equal(await page.run(`return document.activeElement.id`), "answer");
});

test("paper has everything", async () => {
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
    assert.ok(await page.run(`return document.getElementById("load").getClientRects().length > 0`));
    await page.browser.cdp("Emulation.setEmulatedMedia", { media: "" });
    await page.browser.cdp("Emulation.clearDeviceMetricsOverride", {});
    const { data } = await page.browser.cdp("Page.printToPDF", { paperWidth: 210 / 25.4, paperHeight: 297 / 25.4, preferCSSPageSize: true });
    const found = Buffer.from(data, "base64").toString("latin1").match(/\/Type\s*\/Page\b/g).length;
    assert.ok(found <= sheets, `${name}: ${found} sheets`);
  }
});
