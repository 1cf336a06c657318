// The text of the scene with its line numbers; the line of an error is marked.
import { $, element } from "./page.js";

export function editor(changed) {
  const text = $("scene");
  let timer;
  text.addEventListener("input", () => {
    clearTimeout(timer);
    timer = setTimeout(() => changed(text.value), 250);
  });
  text.addEventListener("scroll", () => { $("lines").scrollTop = text.scrollTop; });
}

export function write(text) {
  const area = $("scene");
  if (area.value !== text) area.value = text;
}

export function number(error) {
  const [area, lines] = [$("scene"), $("lines")];
  const count = Math.min(area.value.split("\n").length, 20000);
  lines.replaceChildren();
  for (let k = 1; k <= count; k++) {
    lines.append(k === error?.line ? element("b", {}, String(k)) : String(k), "\n");
  }
  lines.scrollTop = area.scrollTop;
  const said = $("scene-error");
  said.hidden = !error;
  said.textContent = error?.message ?? "";
  if (error) area.setAttribute("aria-invalid", "true");
  else area.removeAttribute("aria-invalid");
}
