// Sends what is typed to afmcalc on this computer and shows its answers; nothing is calculated here.
"use strict";
const find = (selector, inside = document) => inside.querySelector(selector);
const all = (selector, inside = document) => [...inside.querySelectorAll(selector)];
const form = find("#form"), live = find("#live"), words = document.body.dataset;
const MEMORY = `afmcalc ${location.pathname}`;
let pinned = null;

const say = (text) => { find("#status").textContent = text; };
const base = () => Number(find("#base").value);
const asMade = (field) => field.defaultValue ?? (find("option[selected]", field) ?? field.options[0]).value;
const fields = () => Object.fromEntries(
  [...form.elements].filter((one) => one.name && one.value.trim() !== asMade(one)).map((one) => [one.name, one.value.trim()]));
const state = () => ({ base: base(), fields: fields(), pinned });
const clutch = ({ base, fields }) => JSON.stringify([base, fields]);

function post(name, body, signal) {
  return fetch(name, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body), signal });
}

/** Return an answer; where there is none, say so. */
async function asked(name, body) {
  try {
    const reply = await post(name, body);
    if (reply.ok) return await reply.json();
    say(await reply.text());
  } catch (error) { say(`${words.gone} (${error.message})`); }
  return null;
}

/** Put a fragment in its place; what was unfolded or scrolled in there stays so. */
function put(place, html) {
  const open = all("details[id]", place).map((one) => [one.id, one.open]);
  const scrolled = all(".scroll", place).map((one) => one.scrollLeft);
  for (const frame of all("iframe", place)) URL.revokeObjectURL(frame.src);
  place.innerHTML = html;
  for (const frame of all("[data-page]", place)) {
    // a document of its own: its links lead within it
    frame.src = find("a[download]", place).href = URL.createObjectURL(new Blob([frame.dataset.page], { type: "text/html;charset=utf-8" }));
    frame.removeAttribute("data-page");
  }
  all("[data-chart]", place).forEach(draw);
  for (const [id, was] of open) { const one = document.getElementById(id); if (one) one.open = was; }
  all(".scroll", place).forEach((one, index) => { one.scrollLeft = scrolled[index] ?? 0; });
  reachable();
}

/** Round numbers within the ends of an axis: powers of ten, or steps of 1, 2 or 5 times one. */
function ticks({ ends: [low, high], log }) {
  if (log) return Array.from({ length: 40 }, (_, at) => 10 ** (Math.ceil(Math.log10(low)) + at)).filter((one) => one <= high);
  if (!(high > low)) return [low];
  const power = 10 ** Math.floor(Math.log10((high - low) / 6));
  const step = [1, 2, 5, 10].map((one) => one * power).find((one) => one * 6 >= high - low);
  const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, at) => (first + at) * step);
}

/** Draw a chart into its SVG. */
function draw(svg) {
  const { x, y, areas, guides, lines } = JSON.parse(svg.dataset.chart), [left, right, top, base] = [60, 750, 8, 276];
  const scale = ({ ends, log }, from, to) => {
    const of = log ? Math.log10 : Number, [low, high] = ends.map(of);
    return (value) => Math.round(10 * (from + (to - from) * (high > low ? (of(value) - low) / (high - low) : .5))) / 10;
  };
  const across = scale(x, left, right), up = scale(y, base, top);
  const add = (name, attributes, text = "", inside = svg) => {
    const one = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) one.setAttribute(key, value);
    one.textContent = text;
    return inside.appendChild(one);
  };
  const path = (xs, ys) => {
    let pen = "M";
    return xs.map((one, at) => {
      if (one === null || ys[at] === null) { pen = "M"; return ""; }
      const place = `${pen}${across(one)} ${up(ys[at])}`;
      pen = "L";
      return place;
    }).join("");
  };
  const digits = (value) => value.toLocaleString(document.documentElement.lang, { maximumSignificantDigits: 4, notation: value >= 1e6 ? "scientific" : "standard" });
  for (const one of ticks(x)) { add("path", { class: "grid", d: `M${across(one)} ${base}V${top}` }); add("text", { x: across(one), y: 294, "text-anchor": "middle" }, digits(one)); }
  for (const one of ticks(y)) { add("path", { class: "grid", d: `M${left} ${up(one)}H${right}` }); add("text", { x: left - 6, y: up(one) + 4, "text-anchor": "end" }, digits(one)); }
  for (const { x: xs, low, high } of areas) add("path", { class: "area", d: `${path(xs, high)}${path([...xs].reverse(), [...low].reverse()).replace("M", "L")}Z` });
  for (const { across: level, at, dash } of guides) add("path", { class: "guide", "stroke-dasharray": dash, d: level ? `M${left} ${up(at)}H${right}` : `M${across(at)} ${base}V${top}` });
  for (const { x: xs, y: ys, colour, dash, points, filled, paler, names } of lines) {
    if (!points) { add("path", { stroke: colour, "stroke-dasharray": dash, class: paler ? "paler" : "", d: path(xs, ys) }); continue; }
    xs.forEach((one, at) => {
      if (one === null || ys[at] === null) return;
      const circle = add("circle", { stroke: colour, color: colour, class: filled ? "filled" : "", cx: across(one), cy: up(ys[at]), r: 4 });
      if (names[at]) add("title", {}, names[at], circle);
    });
  }
}

/** What scrolls sideways can be reached, and scrolled, with the keyboard. */
function reachable() {
  for (const one of all(".scroll")) if (one.scrollWidth > one.clientWidth) one.tabIndex = 0; else one.removeAttribute("tabindex");
}

function list(place, sentences) {
  place.replaceChildren(...sentences.map((text) => Object.assign(document.createElement("li"), { textContent: text })));
  place.hidden = !sentences.length;
}

/** Set each sentence at its field and return those that belong to none. */
function mark(errors, inside) {
  for (const one of all("[aria-invalid]", inside)) one.removeAttribute("aria-invalid");
  for (const one of all(".error", inside)) { one.hidden = true; one.textContent = ""; }
  return Object.entries(errors).filter(([key, text]) => {
    const field = document.getElementById(key), place = document.getElementById(`error-${key}`);
    const table = find(`[data-table="${key}"]`, inside);
    if (table) table.open = true;
    if (!field || !place || !inside.contains(field)) return true;
    field.setAttribute("aria-invalid", "true");
    place.textContent = text;
    place.hidden = false;
    for (let one = field.closest("details"); one; one = one.parentElement.closest("details")) one.open = true;
    return false;
  }).map(([key, text]) => (text.includes(key) ? text : `${key}: ${text}`));
}

// The newest state waits while one is calculated: an answer comes while a slider moves, and at most one is in hand.
let busy = false, waiting = false, latest = null;
async function change() {
  sessionStorage.setItem(MEMORY, JSON.stringify(state()));
  if (busy) { waiting = true; return; }
  busy = true;
  do {
    waiting = false;
    const sent = state(), answer = await asked("live", sent);
    live.classList.toggle("stale", !answer?.fragments);
    if (answer) show(answer, clutch(sent));
  } while (waiting);
  busy = false;
}

function show(answer, sent) {
  judge(answer.judging);
  const problems = [...answer.problems ?? [], ...mark(answer.errors ?? {}, form)];
  list(find("#problems"), problems);
  if (!answer.fragments) { latest = null; say(words.refused); outdate(); return; }
  for (const [name, html] of Object.entries(answer.fragments)) put(find(`#${name}`), html);
  find("#command").textContent = answer.command;
  status();
  latest = sent;
  outdate();
}

function status() {
  const factor = find('[data-path="accuracy_factor"]'), symbol = factor && find(".mark", factor.parentElement).innerHTML;
  find("#status").innerHTML = `${factor ? `<b>${symbol} = ${factor.innerHTML}</b> · ` : ""}${find("#verdict .sum")?.innerHTML ?? ""}`;
}

// What the verdict needs of an event takes longer: it comes once nothing changes any more.
let judging = new AbortController();
async function judge(wanted) {
  judging.abort();
  const mine = judging = new AbortController();
  await new Promise((done) => setTimeout(done, 250));
  if (!wanted || mine.signal.aborted) return;
  const verdict = find("#verdict");
  verdict.ariaBusy = "true";
  try {
    for await (const line of lines((await post("tab/check", state(), mine.signal)).body)) {
      if (line.html) { put(verdict, line.html); status(); } else find(".said", verdict).textContent = line.text || (line.problems ?? [words.working]).join(" ");
    }
  } catch (error) {
    if (!mine.signal.aborted) find(".said", verdict).textContent = `${words.gone} (${error.message})`;
  }
  if (judging === mine) verdict.ariaBusy = "false";
}

// Sliders write the number and leave the unit as it was typed.
const NUMBER = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(.*)$/is;
function follow(field) {
  const slider = find(`[data-of="${field.id}"]`), parts = NUMBER.exec(field.value);
  if (!slider) return;
  slider.disabled = !parts;
  if (!parts) return;
  const number = Number(parts[1]), unit = parts[2].trim();
  if (slider.dataset.unit !== unit && ("unit" in slider.dataset || !slider.hasAttribute("max"))) {
    const size = 10 ** Math.floor(Math.log10(Math.abs(number) || 1));
    Object.assign(slider, { min: Math.min(0, 2 * number), max: 2 * Math.abs(number) || 1, step: "whole" in slider.dataset ? 1 : size / 50 });
  }
  slider.dataset.unit = unit;
  slider.min = Math.min(slider.min, number);
  slider.max = Math.max(slider.max, number);
  slider.value = number;
  slider.setAttribute("aria-valuetext", field.value);
}

form.addEventListener("input", ({ target }) => {
  if (target.dataset.of) {
    const field = document.getElementById(target.dataset.of);
    field.value = Number(Number(target.value).toPrecision(6)) + NUMBER.exec(field.value)[2];
    target.setAttribute("aria-valuetext", field.value);
  } else follow(target);
  change();
});
form.addEventListener("submit", (event) => event.preventDefault());

/** Put a numbered clutch into the form: that of the spec is 0. */
async function load(number) {
  const answer = await asked("form", { base: number });
  if (!answer?.html) { if (answer) say((answer.problems ?? []).join(" ")); return; }
  form.innerHTML = answer.html;
  all("input[type=text]", form).forEach(follow);
}

function pin(wanted) {
  pinned = wanted;
  find("#pin").textContent = pinned ? words.unpin : words.pin;
}
find("#pin").addEventListener("click", () => {
  pin(pinned ? null : { base: base(), fields: fields() });
  change();
});
find("#copy").addEventListener("click", async () => {
  try {
    await navigator.clipboard.writeText(find("#command").textContent);
    say(words.copied);
  } catch {
    getSelection().selectAllChildren(find("#command"));
    say(words.select);
  }
});
find("#reset").addEventListener("click", () => load(0).then(change));
find("#save").addEventListener("click", async () => {
  const { base, fields } = state(), answer = await asked("save", { base, fields });
  if (answer) say(answer.message ?? [...answer.problems ?? [], ...Object.values(answer.errors ?? {})].join(" "));
});

// Tabs: arrows move, Enter opens. "live" ones follow every change while open, "open" ones start when opened.
const tabs = all("[role=tab]");
const panel = (tab) => document.getElementById(tab.getAttribute("aria-controls"));
const opened = () => find("[role=tab][aria-selected=true]");
const running = new Map(), answered = new Map();
let timer;

function open(tab) {
  for (const one of tabs) {
    one.setAttribute("aria-selected", String(one === tab));
    one.tabIndex = one === tab ? 0 : -1;
    panel(one).hidden = one !== tab;
  }
  reachable();
  outdate(tab.dataset.when === "open");
}

/** Say of the open tab that its answer is old, or get a new one where that is quick or was asked for. */
function outdate(now = false) {
  const tab = opened(), old = tab && answered.get(tab) !== latest;
  if (!tab || panel(tab).ariaBusy === "true" && !old) return;
  clearTimeout(timer);
  if (old && latest && (now || tab.dataset.when === "live")) { timer = setTimeout(run, 250, tab); return; }
  find(".answer", panel(tab)).classList.toggle("stale", old);
  find(".said", panel(tab)).textContent = latest ? (old && answered.has(tab) ? words.changed : "") : words.refused;
}

async function* lines(stream) {
  const reader = stream.pipeThrough(new TextDecoderStream()).getReader();
  for (let rest = ""; ;) {
    const { done, value } = await reader.read();
    if (done) return;
    const parts = (rest + value).split("\n");
    rest = parts.pop();
    for (const part of parts) if (part) yield JSON.parse(part);
  }
}

async function run(tab) {
  running.get(tab)?.abort();
  const mine = new AbortController(), place = panel(tab), name = tab.id.slice(4), sent = state();
  const [answer, said, progress, stop] = [".answer", ".said", "progress", ".stop"].map((one) => find(one, place));
  const options = Object.fromEntries(all("[data-option]", place).map((one) => [one.id, one.value]));
  running.set(tab, mine);
  answered.set(tab, clutch(sent));
  const working = (on) => { place.ariaBusy = String(on); progress.hidden = stop.hidden = !on; };
  working(true);
  progress.removeAttribute("value");
  said.textContent = words.working;
  try {
    const reply = await post(`tab/${name}`, { ...sent, options }, mine.signal);
    if (!reply.ok) throw new Error(await reply.text());
    for await (const line of lines(reply.body)) {
      if ("progress" in line) {
        said.textContent = line.text || words.working;
        if (line.progress === null) progress.removeAttribute("value"); else progress.value = line.progress;
        continue;
      }
      said.textContent = "";
      list(find(".problems", place), [...line.problems ?? [], ...mark(line.errors ?? {}, place)]);
      answer.classList.toggle("stale", line.html === undefined);
      if (line.html !== undefined) put(answer, line.html); else answered.delete(tab);
      if (line.command) { find(".command", place).textContent = line.command; find("pre", place).hidden = false; }
    }
  } catch (error) {
    if (running.get(tab) !== mine) return;
    answered.delete(tab);
    answer.classList.add("stale");
    said.textContent = mine.signal.aborted ? words.stopped : `${words.gone} (${error.message})`;
  }
  if (running.get(tab) !== mine) return;
  working(false);
  if (answered.has(tab)) outdate();
}

find("[role=tablist]").addEventListener("keydown", (event) => {
  const at = tabs.indexOf(event.target), last = tabs.length - 1;
  const to = { ArrowRight: at === last ? 0 : at + 1, ArrowLeft: at ? at - 1 : last, Home: 0, End: last }[event.key];
  if (to === undefined) return;
  event.preventDefault();
  tabs[to].focus();
});
for (const tab of tabs) {
  tab.addEventListener("click", () => open(tab));
  find(".start", panel(tab)).addEventListener("click", () => run(tab));
  find(".stop", panel(tab)).addEventListener("click", () => running.get(tab)?.abort());
  for (const option of all("input[data-option]", panel(tab))) option.addEventListener("change", () => run(tab));
}
document.addEventListener("click", async ({ target }) => {
  if (target.dataset.base) { await load(Number(target.dataset.base)); await change(); say(words.loaded); }
});
addEventListener("resize", reachable);

/** Begin with what was typed before the page was reloaded. */
async function begin() {
  const kept = JSON.parse(sessionStorage.getItem(MEMORY) ?? "null");
  if (kept && kept.base !== base()) await load(kept.base);
  if (kept && kept.base === base()) {
    for (const [key, text] of Object.entries(kept.fields)) if (form.elements[key]) form.elements[key].value = text;
    pin(kept.pinned);
  }
  all("input[type=text]", form).forEach(follow);
  await change();
  open(tabs[0]);
}
begin();
