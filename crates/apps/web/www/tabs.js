// Sections below the values, one shown at a time; on paper all are.
import { $ } from "./page.js";

const all = () => [...$("tabs").children];

export function openTab(panel) {
  for (const tab of all()) {
    const id = tab.getAttribute("aria-controls");
    const chosen = id === panel;
    tab.setAttribute("aria-selected", String(chosen));
    tab.tabIndex = chosen ? 0 : -1;
    $(id).classList.toggle("shut", !chosen);
  }
}

// Arrows walk along the tabs, of which one is a stop of the tab key.
export function tabs() {
  for (const tab of all()) {
    const panel = $(tab.getAttribute("aria-controls"));
    tab.id = `tab-${panel.id}`;
    panel.setAttribute("role", "tabpanel");
    panel.setAttribute("aria-labelledby", tab.id);
    tab.addEventListener("click", () => openTab(panel.id));
  }
  $("tabs").addEventListener("keydown", (event) => {
    const list = all();
    const [first, last, here] = [list[0], list.at(-1), document.activeElement];
    const next = {
      ArrowRight: here.nextElementSibling ?? first, ArrowLeft: here.previousElementSibling ?? last, Home: first, End: last,
    }[event.key];
    if (!next) return;
    event.preventDefault();
    openTab(next.getAttribute("aria-controls"));
    next.focus();
  });
  openTab("findings");
}
