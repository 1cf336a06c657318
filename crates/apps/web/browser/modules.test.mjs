// The modules of the page import each other in one direction.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { root } from "./harness.mjs";

const folder = join(root, "crates/apps/web/www");

test("no circles", () => {
  const imports = new Map(readdirSync(folder).filter((name) => name.endsWith(".js")).map((name) =>
    [name, [...readFileSync(join(folder, name), "utf8").matchAll(/from "\.\/(.+?)"/g)].map(([, other]) => other)]));
  assert.ok(imports.size > 10 && imports.get("scans.js").includes("scene.js"), String([...imports]));
  const walk = (name, way) => {
    assert.ok(!way.includes(name), [...way, name].join(" → "));
    for (const other of imports.get(name) ?? []) walk(other, [...way, name]);
  };
  for (const name of imports.keys()) walk(name, []);
});
