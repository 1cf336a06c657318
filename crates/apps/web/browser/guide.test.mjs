// The guide: every page on a narrow screen, and its search.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { page as folder } from "./harness.mjs";
import { serve } from "./server.mjs";
import { open } from "./webdriver.mjs";

let site, browser, guide;
before(async () => {
  site = await serve(folder);
  browser = await open({});
  guide = site.url.replace("index.html", "guide/");
});
after(async () => {
  await browser.close();
  await site.close();
});

const narrow = () => browser.cdp("Emulation.setDeviceMetricsOverride", { width: 360, height: 800, deviceScaleFactor: 1, mobile: false });
const LOADED = `const images = [...document.images];
  images.forEach((image) => { image.loading = "eager"; });
  await Promise.allSettled(images.map((image) => image.decode()));`;

test("no page scrolls sideways at 360 px, and every picture is there", async () => {
  await narrow();
  const pages = readdirSync(join(folder, "guide")).filter((name) => name.endsWith(".html"));
  assert.ok(pages.length > 30, `${pages.length} pages`);
  for (const name of pages) {
    await browser.go(guide + name);
    const missing = await browser.later(`${LOADED} return images.filter((image) => !image.naturalWidth || !image.alt).map((image) => image.src)`);
    assert.deepEqual(missing, [], name);
    assert.ok(await browser.run("const { scrollWidth, clientWidth } = document.documentElement; return scrollWidth <= clientWidth"), name);
  }
  await browser.cdp("Emulation.clearDeviceMetricsOverride", {});
});

test("letters of pictures are at least 9 px on a narrow screen", async () => {
  await narrow();
  let pictures = 0;
  for (const name of ["figures.html", "which-model.html"]) {
    await browser.go(guide + name);
    const scales = await browser.later(`${LOADED} return images.filter(({ src }) => src.endsWith(".svg")).map((image) => {
      const { paddingLeft, paddingRight } = getComputedStyle(image);
      return [image.src, (image.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight)) / image.naturalWidth];
    })`);
    for (const [picture, scale] of scales) {
      const svg = readFileSync(join(folder, picture.slice(guide.length - "guide/".length)), "utf8");
      // Lowered letters, in elements of their own, are smaller, as in print.
      const sizes = [...svg.matchAll(/<text [^>]*?font-size="([0-9.]+)"/g)].map(([, size]) => (size > 50 ? 0.1 : 1) * size);
      assert.ok(Math.min(...sizes) * scale >= 9, `${name} ${picture}: ${Math.min(...sizes)} px times ${scale}`);
      pictures += 1;
    }
  }
  assert.ok(pictures > 15, `${pictures} pictures`);
  await browser.cdp("Emulation.clearDeviceMetricsOverride", {});
});

test("words are found with their section, also where they are misspelt", async () => {
  for (const [text, wanted] of [["measured surface", "scan-to-stiffness.html#a-measured-surface"], ["plasticity index", "definitions.html"],
    ["hardness HV", "inputs.html#hardness-hv"], ["plastisity", "definitions.html"], ["boundary elments", "boundary-elements.html"]]) {
    await browser.go(`${guide}index.html`);
    await browser.type("input[name=query]", text);
    const asked = () => browser.until("return document.querySelector('.md-search-result__meta button, .md-search-result__link')", text, 10);
    await asked();
    await browser.run("document.querySelector('.md-search-result__meta button')?.click()");
    await browser.until("return document.querySelector('.md-search-result__link')", text, 10);
    const found = await browser.run("return [...document.querySelectorAll('.md-search-result__link')].map(({ href }) => href.replace(/.*[/]|[?][^#]*/g, ''))");
    assert.ok(found.slice(0, 5).includes(wanted), `${text}: ${found}`);
  }
});
