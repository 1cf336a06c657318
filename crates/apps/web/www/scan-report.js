// The report of the scene's scan.
import { $, element, lowered, noPicture, picture } from "./page.js";
import { desks, files, page, work } from "./state.js";

// The scan that the report on the page is about: its file and the keys of the surface.
let reported = "";
const about = ({ fields, files: names }) => JSON.stringify([names.map((name) => files.get(name)?.checksum), Object.entries(fields).filter(([path]) => path.startsWith("surface."))]);

// Leaves the report of this scan where it is; of another scan, or of none, nothing stays.
export function showReport(there) {
  $("save-scan").hidden = !there;
  $("no-scan").hidden = there;
  if (there && reported === about(page.shown)) return;
  reported = "";
  for (const id of ["scan-caption", "scan-numbers"]) $(id).replaceChildren();
  noPicture($("scan-picture"));
  noPicture($("scan-curve"));
}

// Reports on the scan of the scene after its values, in the worker of slow models, which reads
// the file as well.
export const reportScan = () => page.shown?.scan && !reported && work("slow", "scan", report);

async function report() {
  const { text, shown } = page;
  if (!shown?.scan || reported) return;
  const { numbers, svg, curve, caption } = await desks.slow.ask(text, "scan");
  if (page.shown !== shown) return;
  reported = about(shown);
  picture($("scan-picture"), svg, "map of the heights, their distribution and their spectra");
  picture($("scan-curve"), curve, "material ratio curve with the line of its core");
  $("scan-caption").replaceChildren(...caption.map((text) => element("p", {}, text)));
  $("scan-numbers").replaceChildren(...numbers.map(({ name, digits, shown, meaning }) =>
    element("tr", {}, element("th", { scope: "row", title: meaning }, ...lowered(name)), element("td", { title: digits }, shown))));
}
