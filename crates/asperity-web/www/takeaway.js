// Files and lines to take away.
import { $, download, options, picture, tell } from "./page.js";

export function takeAway({ desks, state, page, loadKeys, chosen }) {
  const guard = (act) => async () => {
    try {
      await act();
    } catch (error) {
      tell(error.message);
    }
  };
  const on = (id, act) => $(id).addEventListener("click", guard(act));

  on("save-csv", () => {
    const rows = chosen().map((id) => page.rows.get(id) ?? "");
    download("asperity.csv", `${page.head}\n${rows.join("")}`, "text/csv");
  });
  on("save-svg", () => download("asperity.svg", $("curve").dataset.svg, "image/svg+xml"));
  on("save-png", async () => {
    const image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent($("curve").dataset.svg)}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth;
    canvas.height = image.naturalHeight;
    canvas.getContext("2d").drawImage(image, 0, 0);
    canvas.toBlob((blob) => download("asperity.png", blob, "image/png"));
  });
  on("save-scene", () => download("scene.toml", state.text, "text/plain"));
  on("copy-link", async () => {
    await navigator.clipboard.writeText(location.href);
    $("status").textContent = "link copied";
  });
  on("save-table", async () => {
    const [model, form, units] = ["export-model", "export-form", "export-units"].map((id) => $(id).value);
    const desk = page.shown.models.find(({ id }) => id === model)?.slow ? desks.slow : desks.quick;
    const { name, text } = await desk.call("export", { model, form, units });
    download(name, text, "text/plain");
  });
  on("advise", async () => {
    $("advice").replaceChildren("comparing the models takes some seconds");
    const { summary } = await desks.slow.call("advise", { load: loadKeys() });
    $("advice").replaceChildren(...summary.map((text) => Object.assign(document.createElement("li"), { textContent: text })));
  });

  async function code() {
    if (!$("code").open) return;
    const found = await desks.quick.call("code", { models: chosen(), load: loadKeys() });
    for (const language of ["shell", "python", "rust"]) $(`code-${language}`).textContent = found[language];
  }
  async function law() {
    if (!$("law").open || !$("law-model").value) return;
    const model = $("law-model").value;
    const known = page.shown.models.find(({ id }) => id === model);
    $("law-source").textContent = `${known.name}: ${known.source}`;
    $("law-picture").replaceChildren();
    const svg = await (known.slow ? desks.slow : desks.quick).call("law", { model });
    picture($("law-picture"), svg, `force and area of one asperity by ${model} against the interference`);
  }
  $("code").addEventListener("toggle", guard(code));
  $("law").addEventListener("toggle", guard(law));
  $("law-model").addEventListener("change", guard(law));

  return {
    models(all, ids) {
      const allowed = all.filter(({ reason }) => !reason).map(({ id }) => [id, id]);
      options($("export-model"), ids.map((id) => [id, id]));
      options($("law-model"), allowed, $("law-model").value || ids[0]);
      $("advice").replaceChildren();
      guard(code)();
    },
  };
}
