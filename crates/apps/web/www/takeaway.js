// Files and lines to take away.
import { $, download, element, options } from "./page.js";
import { answers, ask, chosen, desks, isSlow, page, state, work } from "./state.js";
import { writeLink } from "./link.js";

// The model that was ticked or chosen last: tables begin with it.
let picked = null;

const on = (id, act) => $(id).addEventListener("click", () => work("page", null, act));
const deskOf = (id) => (isSlow(id) ? desks.slow : desks.quick);

function saves() {
  on("save-csv", () => {
    const rows = chosen().map((id) => page.rows.get(id) ?? "");
    download("asperity.csv", `${page.shown.head}\n${rows.join("")}`, "text/csv");
  });
  on("save-values", () => {
    const { newtons, pascals } = page.load;
    const { views } = page.shown;
    const { head } = page.best;
    const numbers = ({ digits = "", lower = "", upper = "" } = {}) => [digits, lower, upper];
    const rows = [["best", page.best.row.cells], ...chosen().map((id) => [id, page.values.get(id)?.cells ?? []])];
    if (page.best.solved) rows.push(["bem", page.best.solved.cells]);
    const lines = rows.map(([id, cells]) => [id, newtons, pascals, ...views.flatMap((_, k) => numbers(cells[k]))].join());
    download("values.csv", [head, ...lines, ""].join("\n"), "text/csv");
  });
  // Of the usual size, not that of the screen.
  on("save-svg", async () => download("asperity.svg", await page.picture(null), "image/svg+xml"));
  on("save-png", async () => {
    const image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(await page.picture(null))}`;
    await image.decode();
    const canvas = element("canvas", { width: image.naturalWidth, height: image.naturalHeight });
    canvas.getContext("2d").drawImage(image, 0, 0);
    canvas.toBlob((blob) => download("asperity.png", blob, "image/png"));
  });
  $("save-scene").addEventListener("click", () => download("scene.toml", state.text, "text/plain"));
  $("save-table").addEventListener("click", () => {
    const [model, form, units] = ["export-model", "export-form", "export-units"].map((id) => $(id).value);
    work(isSlow(model) ? "slow" : "page", null, async () => {
      const { name, text } = await ask(deskOf(model), "export", { model, form, units });
      download(name, text, "text/plain");
    });
  });
}

// Where the browser gives no clipboard, as without https, the link stands in a field.
async function copyLink() {
  await writeLink();
  const field = $("link");
  field.value = location.href;
  try {
    await navigator.clipboard.writeText(location.href);
    $("status").textContent = "link copied";
  } catch {
    field.hidden = false;
    field.select();
  }
}

// Lines that give the digits of the page beside its scene file: the same models at the same load.
async function code() {
  if (!$("code").open || !answers() || !page.load) return;
  const { unit, newtons, pascals } = page.load;
  const [place, number] = unit === "Pa" ? ["pressure", pascals] : ["load", newtons];
  const names = page.shown.views.map(({ id }) => id).filter((id) => id !== "separation");
  $("code-shell").textContent = `asperity curve scene.toml --model ${["best", ...chosen()]} --${place} ${number} \\
  --quantity ${names} --errors --format json`;
  $("code-python").textContent = `import asperity

scene = asperity.Scene.from_toml("scene.toml")
best = scene.answer(${JSON.stringify(names)}, ${place}=${number})
for quantity in best.value:
    print("best", quantity, best.value[quantity], best.lower[quantity], best.upper[quantity])
for name in ${JSON.stringify(chosen())}:
    for quantity in ${JSON.stringify(names)}:
        try:
            answer = asperity.model(name).solve(scene, ${place}=${number}, quantities=quantity)
            print(name, quantity, answer[quantity])
        except ValueError as reason:
            print(name, quantity, "none:", reason)`;
}

export const takeAway = {
  start() {
    saves();
    $("copy-link").addEventListener("click", copyLink);
    $("code").addEventListener("toggle", takeAway.code);
    $("export-model").addEventListener("change", () => takeAway.pick($("export-model").value));
  },
  // The code of the present load.
  code: () => work("page", "code", code),
  pick(id) {
    picked = id ?? picked;
  },
  // What has to lie beside a saved scene file.
  files(names) {
    $("scene-files").hidden = names.length === 0;
    $("scene-files").textContent = `The program reads ${names.join(", ")} from the folder of the scene file: save them in one folder.`;
  },
  // The models of the scene; none for a scene with an error.
  models(ids) {
    options($("export-model"), ids.map((id) => [id, id]), [picked, page.shown?.usual].find((id) => ids.includes(id)) ?? ids[0]);
    $("save-table").disabled = ids.length === 0;
    if (ids.length === 0) for (const language of ["shell", "python"]) $(`code-${language}`).textContent = "";
  },
};
