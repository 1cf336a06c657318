// The guide: every page on a narrow screen, and its search.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { explorer, page as folder } from "./harness.mjs";

let page, guide;
before(async () => {
  page = await explorer();
  guide = page.site.url.replace("index.html", "guide/");
});
after(() => page?.end());

test("no page scrolls sideways at 360 px, and every picture is there", async () => {
  const { browser, run } = page;
  await browser.cdp("Emulation.setDeviceMetricsOverride", { width: 360, height: 800, deviceScaleFactor: 1, mobile: false });
  const pages = readdirSync(join(folder, "guide")).filter((name) => name.endsWith(".html"));
  assert.ok(pages.length > 30, `${pages.length} pages`);
  for (const name of pages) {
    await browser.go(guide + name);
    const missing = await browser.later(`const images = [...document.images];
      images.forEach((image) => { image.loading = "eager"; });
      await Promise.allSettled(images.map((image) => image.decode()));
      return images.filter((image) => !image.naturalWidth || !image.alt).map((image) => image.src)`);
    assert.deepEqual(missing, [], name);
    const wide = await run(`const { scrollWidth, clientWidth } = document.documentElement;
      return scrollWidth > clientWidth && [...document.body.querySelectorAll("*")].filter((one) => one.getBoundingClientRect().right > clientWidth).map((one) => one.outerHTML.slice(0, 80))`);
    assert.equal(wide, false, `${name}: ${wide}`);
  }
  await browser.cdp("Emulation.clearDeviceMetricsOverride", {});
});

test("letters of pictures are at least 9 px on a narrow screen", async () => {
  const { browser, run } = page;
  await browser.cdp("Emulation.setDeviceMetricsOverride", { width: 360, height: 800, deviceScaleFactor: 1, mobile: false });
  const scales = `const images = [...document.images];
    images.forEach((image) => { image.loading = "eager"; });
    await Promise.allSettled(images.map((image) => image.decode()));
    return images.filter(({ src }) => src.endsWith(".svg")).map((image) => {
      const { paddingLeft, paddingRight } = getComputedStyle(image);
      return [image.src, (image.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight)) / image.naturalWidth];
    })`;
  let pictures = 0;
  for (const name of ["ke.html", "figures.html", "../gallery.html", "which-model.html"]) {
    await browser.go(guide + name);
    for (const [picture, scale] of await browser.later(scales)) {
      const svg = readFileSync(join(folder, picture.slice(guide.length - "guide/".length)), "utf8");
      // Lowered letters, in elements of their own, are smaller, as in print.
      const sizes = [...svg.matchAll(/<text [^>]*?font-size="([0-9.]+)"/g)].map(([, size]) => (size > 50 ? 0.1 : 1) * size);
      assert.ok(Math.min(...sizes) * scale >= 9, `${name} ${picture}: ${Math.min(...sizes)} px times ${scale}`);
      pictures += 1;
    }
  }
  assert.ok(pictures > 15, `${pictures} pictures`);
  await browser.go(page.site.url);
  await browser.until("return document.documentElement.dataset.state === 'ready'", "the explorer");
  const drawn = await run(`const text = document.querySelector("#curve svg text"); return text.getBoundingClientRect().height`);
  assert.ok(drawn >= 9, `${drawn} px`);
  await browser.cdp("Emulation.clearDeviceMetricsOverride", {});
});

test("a heading is found by typing, and opened by keys", async () => {
  const { browser } = page;
  await browser.go(`${guide}index.html`);
  await browser.type("input", "measured surface");
  await browser.until("return document.querySelector('#found a')", "an entry", 10);
  assert.match(await page.text("found"), /A measured surface/);
  await browser.keys(["\uE004", "\uE007"]);
  await browser.until("return location.hash === '#a-measured-surface'", "the page of the entry", 10);
  assert.match(await page.run("return location.pathname"), /guide.scan-to-stiffness.html$/);
});

test("the heading of an entry is in view on a narrow screen", async () => {
  const { browser, run } = page;
  await browser.cdp("Emulation.setDeviceMetricsOverride", { width: 360, height: 800, deviceScaleFactor: 1, mobile: false });
  for (const address of ["gw.html#valid-for", "definitions.html#quantities"]) {
    await browser.go(guide + address);
    await browser.until("return scrollY > 100", "the heading", 10);
    const seen = await run(`const heading = document.getElementById(location.hash.slice(1));
      const { left, top, height } = heading.getBoundingClientRect();
      const there = document.elementFromPoint(left + 3, top + height / 2);
      return top >= 0 && (heading.contains(there) || there.contains(heading))`);
    assert.ok(seen, address);
  }
  await browser.cdp("Emulation.clearDeviceMetricsOverride", {});
});

test("symbols fit on a narrow screen, and of the gallery only pictures scroll", async () => {
  const { browser, run } = page;
  await browser.cdp("Emulation.setDeviceMetricsOverride", { width: 360, height: 800, deviceScaleFactor: 1, mobile: false });
  for (const [name, parts] of [["gw.html", "table.symbols"], ["ke.html", "table.symbols"], ["../gallery.html", "section"]]) {
    await browser.go(guide + name);
    const found = await run("return [...document.querySelectorAll(arguments[0])].map(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)", parts);
    assert.ok(found.length > 0 && found.every((over) => over <= 0), `${name}: ${found}`);
  }
  assert.ok(await run("return [...document.querySelectorAll('section figure')].every((one) => parseFloat(getComputedStyle(one).borderRightWidth) > 0)"));
  await browser.cdp("Emulation.clearDeviceMetricsOverride", {});
});

test("words of the text are found with their section, and fast typing leaves the last answer", async () => {
  const { browser, run } = page;
  await browser.go(`${guide}index.html`);
  await browser.type("input", "plasticity index");
  await browser.until("return document.querySelector('#found small')", "sections", 10);
  const found = await run("return [...document.querySelectorAll('#found a')].map((link) => [link.getAttribute('href'), link.querySelector('small')?.textContent ?? ''])");
  assert.ok(found.some(([address, text]) => address === "gw.html#valid-for" && /plasticity index ψ/.test(text)), String(found));
  // Each letter asks anew, and each answer follows the letters of its own.
  for (const text of ["hertz", "measured surface", "persson"]) {
    const shown = await browser.later(`const field = document.getElementById("query");
      for (let k = 1; k <= values[0].length; k++) {
        field.value = values[0].slice(0, k);
        field.dispatchEvent(new Event("input"));
      }
      await new Promise((done) => setTimeout(done, 300));
      return [...document.querySelectorAll("#found li")].map((row) => row.textContent.toLowerCase())`, text);
    assert.ok(shown.length > 0 && shown.every((row) => text.split(" ").some((word) => row.includes(word))), `${text}: ${shown}`);
  }
  await browser.later(`const field = document.getElementById("query"); field.value = "zebra"; field.dispatchEvent(new Event("input")); await new Promise((done) => setTimeout(done, 200))`);
  assert.match(await page.text("found"), /no section has these words/);
});

test("what is called as searched stands first, then its definition", async () => {
  const { browser } = page;
  await browser.go(`${guide}index.html`);
  for (const [text, wanted] of [["separation", "definitions.html#separation"], ["plasticity index", "definitions.html#"], ["unloading-stiffness", "definitions.html#quantities"], ["Definitions", "definitions.html"],
    ["Ra", "inputs.html"], ["hardness HV", "inputs.html#"], ["two steel plates", "inputs.html#"], ["plastisity", "definitions.html"], ["boundary elments", "boundary-elements.html"]]) {
    const first = await browser.later(`const field = document.getElementById("query");
      field.value = values[0];
      field.dispatchEvent(new Event("input"));
      await new Promise((done) => setTimeout(done, 300));
      return document.querySelector("#found a").getAttribute("href")`, text);
    assert.ok(first.startsWith(wanted), `${text}: ${first}`);
  }
});
