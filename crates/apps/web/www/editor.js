// The text of the scene with its line numbers; the line of an error is marked.
import { $, element } from "./page.js";

const PAUSE = 250;
const MOST_LINES = 20000;

// `typed` takes every text at once, `rested` follows when typing rests.
export function editor(typed, rested) {
  const text = $("scene");
  let timer;
  text.addEventListener("input", () => {
    clearTimeout(timer);
    timer = setTimeout(rested, PAUSE);
    typed(text.value);
  });
  text.addEventListener("scroll", () => { $("lines").scrollTop = text.scrollTop; });
}

export function write(text) {
  if ($("scene").value !== text) $("scene").value = text;
}

export function number(error) {
  const [area, lines] = [$("scene"), $("lines")];
  const count = Math.min(area.value.split("\n").length, MOST_LINES);
  lines.replaceChildren();
  for (let k = 1; k <= count; k++) {
    lines.append(k === error?.line ? element("b", {}, String(k)) : String(k), "\n");
  }
  lines.scrollTop = area.scrollTop;
  const message = $("scene-error");
  message.hidden = !error;
  message.textContent = error?.message ?? "";
  if (error) area.setAttribute("aria-invalid", "true");
  else area.removeAttribute("aria-invalid");
}
