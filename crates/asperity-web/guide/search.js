// Finds pages and sections that have all the words; the index is a file beside this one.

const MOST = 20;
// Letters of the text around what was found.
const AROUND = 60;
const place = document.getElementById("search");
const query = document.getElementById("query");
const found = document.getElementById("found");
let index;

const plain = (text) => text.toLowerCase().replaceAll("-", " ");
const DEFINITIONS = "definitions.html";

// What is called like that, the definitions before others, and where it is defined; then titles,
// headings, text in which the words stand side by side, and any other.
function rank({ page, heading, address, text }, words) {
  const [title, below] = [plain(page), plain(heading)];
  const defines = address.startsWith(DEFINITIONS);
  if ((below || title).replace(/^(an?|the) /, "") === words.join(" ")) return defines ? 8 : 7;
  if (defines && ` ${plain(text).replace(/[^\p{L}\p{N}_]+/gu, " ")} `.includes(` ${words.join(" ")} `)) return 6;
  const all = (...texts) => words.every((word) => texts.some((one) => one.includes(word)));
  if (!heading && all(title)) return 5;
  if (heading && all(below)) return 4;
  if (words.some((word) => below.includes(word)) && all(title, below)) return 3;
  const whole = plain(text);
  if (whole.includes(words.join(" "))) return 2;
  return all(title, below, whole) && words.some((word) => whole.includes(word)) ? 1 : 0;
}

function matches(entries, words) {
  const ranked = entries.map((entry) => [rank(entry, words), entry]).filter(([score]) => score > 0);
  return ranked.sort(([a], [b]) => b - a).slice(0, MOST).map(([score, entry]) => ({ score, ...entry }));
}

// The words of a text around the first that was searched.
function around(text, words) {
  const whole = plain(text);
  const at = [words.join(" "), ...words].map((part) => whole.indexOf(part)).find((place) => place >= 0);
  const [start, end] = [Math.max(0, at - AROUND), at + 2 * AROUND];
  const cut = text.slice(start, end);
  return `${start > 0 ? "… " : ""}${cut.slice(start > 0 ? cut.indexOf(" ") + 1 : 0)}${end < text.length ? " …" : ""}`;
}

function element(name, text) {
  const made = document.createElement(name);
  made.textContent = text;
  return made;
}

function item({ score, page, heading, address, text }, words) {
  const link = element("a", heading || page);
  link.href = address;
  if (heading) link.append(element("span", ` in ${page}`));
  if (score <= 2 || score === 6) link.append(element("small", around(text, words)));
  const row = document.createElement("li");
  row.append(link);
  return row;
}

async function read() {
  return (await fetch("search.json")).json();
}

async function search() {
  const asked = query.value;
  const words = plain(asked).split(/\s+/).filter(Boolean);
  let entries;
  try {
    entries = await (index ??= read());
  } catch {
    index = undefined;
    found.replaceChildren(element("li", "the index search.json cannot be read; use the contents"));
    return;
  }
  // Typed on while the index was read: the later search answers.
  if (asked !== query.value) return;
  const rows = words.length > 0 ? matches(entries, words).map((entry) => item(entry, words)) : [];
  found.replaceChildren(...(words.length > 0 && rows.length === 0 ? [element("li", "no section has these words")] : rows));
}

query.addEventListener("input", search);
place.addEventListener("keydown", (event) => {
  if (event.key === "Escape") {
    query.value = "";
    found.replaceChildren();
    query.focus();
  }
  if (event.key === "Enter" && event.target === query) found.querySelector("a")?.click();
});
// A result on this page leaves the page where it is.
found.addEventListener("click", () => found.replaceChildren());
place.hidden = false;
// On a narrow screen the text comes first.
if (matchMedia("(max-width: 56rem)").matches) document.querySelector("details").open = false;
