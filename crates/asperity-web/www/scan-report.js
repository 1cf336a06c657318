// The report of the scene's scan.
import { $, element, heading, lowered, noPicture, picture } from "./page.js";
import { desks, page, work } from "./state.js";

// Shows it, if the scene has a scan.
export function scanReport(there) {
  $("save-scan").hidden = !there;
  $("no-scan").hidden = there;
  if (!there) for (const id of ["scan-caption", "scan-numbers", "scales"]) $(id).replaceChildren();
  noPicture($("scan-picture"));
  if (there) work("slow", "scan", report);
}

async function report() {
  const { text, shown } = page;
  if (!shown?.scan) return;
  const { svg, caption, scales, numbers } = await desks.slow.ask(text, "scan");
  if (page.shown !== shown) return;
  picture($("scan-picture"), svg, "map of the heights, their distribution and their spectra");
  $("scan-caption").replaceChildren(...caption.map((text) => element("p", {}, text)));
  $("scan-numbers").replaceChildren(...numbers.map(({ name, digits, shown, meaning }) =>
    element("tr", {}, element("th", { scope: "row", title: meaning }, ...lowered(name)), element("td", { title: digits }, shown))));
  const head = element("tr", {}, ...scales.head.map((name) => heading(name)));
  $("scales").replaceChildren(element("caption", {}, "Slopes and curvatures at several point distances"), head,
    ...scales.rows.map((row) => element("tr", {}, ...row.map((text) => element("td", {}, text)))));
}
