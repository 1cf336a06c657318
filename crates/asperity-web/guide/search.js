// Finds pages and sections that have all the words; the index is a file beside this one.

const MOST = 20;
// Letters of the text around what was found.
const AROUND = 60;
const place = document.getElementById("search");
const query = document.getElementById("query");
const found = document.getElementById("found");
let index;

const plain = (text) => text.toLowerCase().replaceAll("-", " ");
const split = (text) => plain(text).split(/[^\p{L}\p{N}_]+/u).filter(Boolean);
// A short word, such as Ra, is a word of its own.
const has = (text, word) => (word.length > 3 ? text.includes(word) : ` ${split(text).join(" ")} `.includes(` ${word} `));
const DEFINITIONS = "definitions.html";

// What is called like that, the definitions before others, and where it is defined; then titles,
// headings, text in which the words stand side by side, and any other.
function rank({ page, heading, address, text }, words) {
  const [title, below] = [plain(page), plain(heading)];
  const defines = address.startsWith(DEFINITIONS);
  if ((below || title).replace(/^(an?|the) /, "") === words.join(" ")) return defines ? 8 : 7;
  if (defines && ` ${plain(text).replace(/[^\p{L}\p{N}_]+/gu, " ")} `.includes(` ${words.join(" ")} `)) return 6;
  const all = (...texts) => words.every((word) => texts.some((one) => has(one, word)));
  if (!heading && all(title)) return 5;
  if (heading && all(below)) return 4;
  if (words.some((word) => has(below, word)) && all(title, below)) return 3;
  const whole = plain(text);
  if (has(whole, words.join(" "))) return 2;
  return all(title, below, whole) && words.some((word) => has(whole, word)) ? 1 : 0;
}

function matches(entries, words) {
  const ranked = entries.map((entry) => [rank(entry, words), entry]).filter(([score]) => score > 0);
  return ranked.sort(([a], [b]) => b - a).slice(0, MOST).map(([score, entry]) => ({ score, ...entry }));
}

// Letters to change, insert or leave out to make one word of the other.
function distance(one, other) {
  let row = Array.from({ length: other.length + 1 }, (_, k) => k);
  for (const [k, letter] of [...one].entries()) {
    const next = [k + 1];
    for (let j = 1; j < row.length; j++) {
      next.push(Math.min(next[j - 1] + 1, row[j] + 1, row[j - 1] + (letter === other[j - 1] ? 0 : 1)));
    }
    row = next;
  }
  return row.at(-1);
}

// The words, of which those that stand nowhere give way to the nearest that does.
function spelt(entries, words) {
  const known = new Set(entries.flatMap(({ page, heading, text }) => split(`${page} ${heading} ${text}`)));
  const all = [...known];
  return words.map((word) => {
    if (word.length < 4 || all.some((one) => one.includes(word))) return word;
    const near = all.filter((one) => one.length > 3).map((one) => [distance(word, one), one]);
    const [least, one] = near.reduce((a, b) => (b[0] < a[0] ? b : a), [Infinity, word]);
    return least <= word.length / 4 ? one : word;
  });
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
  if (words.length === 0) return found.replaceChildren();
  const rows = (words) => matches(entries, words).map((entry) => item(entry, words));
  let shown = rows(words);
  const meant = shown.length === 0 ? spelt(entries, words) : words;
  if (meant.join() !== words.join()) {
    shown = rows(meant);
    shown.unshift(element("li", `no section has ${words.join(" ")}; searched for ${meant.join(" ")}`));
  }
  found.replaceChildren(...(shown.length === 0 ? [element("li", "no section has these words")] : shown));
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
