// Sends the form to afmcalc on this computer and shows its answers; nothing is calculated here.
"use strict";
const find = (selector, inside = document) => inside.querySelector(selector);
const all = (selector, inside = document) => [...inside.querySelectorAll(selector)];
const form = find("#form"), live = find("#live"), words = document.body.dataset;
const [hold, as, by] = all("#holding select, #holding input");
const MEMORY = `afmcalc ${location.pathname}`, PAGE = `${Date.now()} ${Math.random()}`;
let pinned = null, known = words.known;

const say = (text) => { find("#status").textContent = text; };
const status = () => { find("#status").innerHTML = find("#verdict .sum")?.innerHTML ?? ""; };
const base = () => Number(find("#base").value);
const asMade = (field) => field.defaultValue ?? (find("option[selected]", field) ?? field.options[0]).value;
const fields = () => Object.fromEntries(
  [...form.elements].filter((one) => one.name && one.value.trim() !== asMade(one)).map((one) => [one.name, one.value.trim()]));
const state = () => ({ base: base(), fields: fields(), pinned, page: PAGE });
const clutch = ({ base, fields }) => JSON.stringify([base, fields]);

/** Answer to a POST, which may tell of its progress before, or null and ``fail`` with the reason. */
async function asked(name, body, { fail = say, tell, signal } = {}) {
  try {
    const reply = await fetch(name, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body), signal });
    if (!reply.ok) throw new Error(await reply.text());
    for await (const line of lines(reply.body)) if ("progress" in line) tell?.(line); else return line;
  } catch (error) { fail(signal?.aborted ? words.stopped : `${words.gone} (${error.message})`); }
  return null;
}

async function* lines(stream) {
  const reader = stream.pipeThrough(new TextDecoderStream()).getReader();
  for (let rest = ""; ;) {
    const { done, value } = await reader.read();
    const parts = (rest + (value ?? (rest && "\n"))).split("\n");
    rest = parts.pop();
    for (const part of parts) if (part) yield JSON.parse(part);
    if (done) return;
  }
}

/** Sentences of a refusal. */
const sentences = ({ message, problems = [], errors = {} }) => message ?? [...problems, ...Object.values(errors)].join(" ");

/** Answer to what is asked of the state shown, or null and say why there is none. */
async function told(name, options = {}) {
  const answer = await asked(`tab/${name}`, { ...state(), options });
  if (!answer?.problems) return answer;
  say(sentences(answer));
  return null;
}

/** Replace the content of a place; opened details stay open, scrolled tables stay scrolled. */
function put(place, html) {
  const open = all("details[id]", place).map((one) => [one.id, one.open]);
  const scrolled = all(".scroll", place).map((one) => one.scrollLeft);
  for (const frame of all("iframe", place)) URL.revokeObjectURL(frame.src);
  place.innerHTML = html;
  for (const frame of all("[data-page]", place)) {
    // a separate document: its links lead within it
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

/** Let the keyboard reach and scroll everything that scrolls sideways. */
function reachable() {
  for (const one of all(".scroll")) if (one.scrollWidth > one.clientWidth) one.tabIndex = 0; else one.removeAttribute("tabindex");
}

function list(place, sentences) {
  place.replaceChildren(...sentences.map((text) => Object.assign(document.createElement("li"), { textContent: text })));
  place.hidden = !sentences.length;
}

/** Show each error at its field; return the errors without a field. */
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
    reveal(field);
    return false;
  }).map(([key, text]) => (text.includes(key) ? text : `${key}: ${text}`));
}

function reveal(field) {
  for (let one = field.closest("details"); one; one = one.parentElement.closest("details")) one.open = true;
}

// While one state is calculated only the newest waits: answers come while a slider moves, one request at a time.
let busy = false, waiting = false, latest = null;
async function change(key = "") {
  remember(key);
  if (busy) { waiting = true; return; }
  busy = true;
  do {
    waiting = false;
    const sent = state(), answer = await asked("live", { ...sent, options: hold.value ? { hold: hold.value, as: as.value, by: by.value } : {} });
    for (const place of [live, find("#strip")]) place.classList.toggle("stale", !answer?.fragments);
    if (answer) show(answer, sent);
  } while (waiting);
  busy = false;
}

function show(answer, sent) {
  judge(answer.judging);
  const problems = [...answer.problems ?? [], ...mark(answer.errors ?? {}, find("#inputs"))];
  list(find("#problems"), problems);
  if (!answer.fragments) { latest = null; say(words.refused); outdate(); return; }
  for (const [name, html] of Object.entries(answer.fragments)) put(find(`#${name}`), html);
  find("#command").textContent = answer.command;
  status();
  as.value ||= answer.as ?? "";
  calculated = Object.fromEntries(Object.entries(answer.entries).map(([key, text]) => [key, [sent.fields[key], text]]));
  // a sum that is still typed is replaced when its field is left
  settle(Object.keys(calculated).filter((key) => key !== document.activeElement.name));
}

/** Replace sums by what they are, and values by those that hold a result, where nothing else was typed meanwhile. */
function settle(keys) {
  const typed = fields();
  fill(Object.fromEntries(keys.filter((key) => typed[key] === calculated[key][0]).map((key) => [key, calculated[key][1]])));
  now = snapshot();
  keep();
  latest = clutch(state());
  outdate();
}

// The states from which undo and redo lead; what is typed into one field within a second is one change.
const past = [], future = [], MOST = 200;
let now = null, saved = null, calculated = {}, touched = ["", 0];
const snapshot = () => JSON.stringify({ base: base(), fields: fields() });

function remember(key) {
  const next = snapshot(), again = key && key === touched[0] && Date.now() - touched[1] < 1000;
  if (next !== now) {
    if (now !== null && !again) past.push(now);
    if (past.length > MOST) past.shift();
    future.length = 0;
    now = next;
    touched = [key, Date.now()];
  }
  keep();
}

function keep() {
  sessionStorage.setItem(MEMORY, JSON.stringify({ ...state(), known, saved }));
  find("#undo").disabled = !past.length;
  find("#redo").disabled = !future.length;
}

/** Go to a state before or after this one. */
async function travel(from, to) {
  if (!from.length) return;
  to.push(now);
  now = from.pop();
  touched = ["", 0];
  await restore(JSON.parse(now));
  await change();
}

async function restore(wanted) {
  if (wanted.base !== base()) await load({ base: wanted.base });
  for (const one of form.elements) if (one.name) one.value = wanted.fields[one.name] ?? asMade(one);
  all("[data-number]", form).forEach(follow);
}

/** Write texts into fields. */
function fill(entries) {
  for (const [key, text] of Object.entries(entries)) {
    const field = form.elements[key];
    if (field && field.value !== text) { field.value = text; follow(field); }
  }
}

// The full verdict needs a simulation: it is requested when nothing has changed for 250 ms.
let judging = new AbortController();
async function judge(wanted) {
  judging.abort();
  const mine = judging = new AbortController();
  if (!wanted) for (const one of all("#verdict .said, #strip .said")) one.textContent = "";
  await new Promise((done) => setTimeout(done, 250));
  if (!wanted || mine.signal.aborted) return;
  const verdict = find("#verdict"), fail = (text) => { if (!mine.signal.aborted) find(".said", verdict).textContent = text; };
  verdict.ariaBusy = "true";
  const tell = ({ text }) => fail(text || words.working);
  const answer = await asked("tab/check", state(), { fail, tell, signal: mine.signal });
  if (judging !== mine) return;
  verdict.ariaBusy = "false";
  if (!answer?.html) { if (answer) fail(sentences(answer)); return; }
  const before = all("[data-code]", verdict);
  put(verdict, answer.html);
  for (const one of before) twin(one).innerHTML = one.nextElementSibling.innerHTML;
  put(find("#strip"), answer.strip);
  status();
}

// Sliders write the number and leave the unit as it was typed.
const NUMBER = /^\s*([+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:e[+-]?\d+)?)(.*)$/is;
function follow(field) {
  const slider = find(`[data-of="${field.id}"]`), parts = NUMBER.exec(field.value);
  if (!slider) return;
  slider.disabled = !parts || /^\s*[-+*\/]/.test(parts[2]);
  if (slider.disabled) return;
  const number = Number(parts[1].replace(",", ".")), unit = parts[2].trim();
  if (slider.dataset.unit !== unit) {
    const { least, most, whole } = slider.dataset, size = Math.abs(number) || 1, limit = (text) => (unit ? NaN : parseFloat(text));
    const step = whole === undefined ? 10 ** Math.floor(Math.log10(size / 50)) : 1, high = Math.ceil(size / (5 * step)) * 10 * step;
    const low = number < 0 ? -high : 0;
    Object.assign(slider, { min: Math.max(low, limit(least) || low), max: Math.min(high, limit(most) || high), step });
    slider.dataset.unit = unit;
  }
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
  change(target.dataset.of ?? target.name);
});
form.addEventListener("change", ({ target: { name } }) => { if (name in calculated) settle([name]); });
form.addEventListener("submit", (event) => event.preventDefault());

/** Add one to the last digit of a number, or to the one before it. */
function nudge(field, sign, tenfold) {
  const [, number, rest] = /^\s*([+-]?\d*[.,]?\d*)(.*)$/s.exec(field.value), places = number.split(/[.,]/)[1]?.length ?? 0;
  if (!/\d/.test(number) || /^\s*[-+*\/(]/.test(rest)) return;
  const next = Number(number.replace(",", ".")) + sign * (tenfold ? 10 : 1) / 10 ** places;
  field.value = next.toFixed(places).replace(".", number.includes(",") ? "," : ".") + rest;
  field.dispatchEvent(new Event("input", { bubbles: true }));
}
addEventListener("keydown", (event) => {
  const { key, target, shiftKey } = event;
  // in other alphabets by the place on the keyboard
  const command = (event.ctrlKey || event.metaKey) && (/^[a-z]$/i.test(key) ? key.toLowerCase() : event.code.slice(3).toLowerCase());
  if ("number" in target.dataset && (key === "ArrowUp" || key === "ArrowDown")) nudge(target, key === "ArrowUp" ? 1 : -1, shiftKey);
  else if (command === "s") find(find("#save").disabled ? "#save-as" : "#save").click();
  else if ((command === "z" || command === "y") && !target.dataset.option) find(command === "y" || shiftKey ? "#redo" : "#undo").click();
  else return;
  event.preventDefault();
});
addEventListener("beforeunload", (event) => { if (now !== saved) event.preventDefault(); });

/** Load a clutch into the form by the number of its base, 0 that of the spec; or from a file or an example. */
async function load(wanted) {
  const answer = await asked("open", wanted);
  if (!answer?.html) { if (answer) say(sentences(answer)); return false; }
  form.innerHTML = answer.html;
  hold.value = as.value = "";
  find("#requirements").value = answer.requirements;
  find("#heading").textContent = document.title = answer.name;
  find("#source").textContent = answer.source;
  all("[data-number]", form).forEach(follow);
  return true;
}

function download(content, kind) {
  const [, name] = /([^\/\\:]*?)(?:\.\w+)?$/.exec(find("#source").textContent);
  const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(new Blob([content])), download: `${name || "clutch"}.${kind}` });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

function pin(wanted) {
  pinned = wanted;
  find("#pin").textContent = pinned ? words.unpin : words.pin;
}
const on = (selector, act, kind = "click") => find(selector).addEventListener(kind, act);
on("#pin", () => {
  pin(pinned ? null : JSON.parse(snapshot()));
  change();
});
on("#copy", () => navigator.clipboard.writeText(find("#command").textContent).then(() => say(words.copied), () => {
  getSelection().selectAllChildren(find("#command"));
  say(words.select);
}));
on("#undo", () => travel(past, future));
on("#redo", () => travel(future, past));
on("#reset", async () => {
  if (now !== JSON.stringify({ base: 0, fields: {} }) && confirm(words.back)) { await load({ base: 0 }); change(); }
});
const opening = async (wanted, field) => {
  if (await load(wanted)) await change();
  field.value = "";
};
on("#new", ({ target }) => opening({ example: target.value }, target), "change");
on("#open", () => find("#file").click());
on("#file", async ({ target }) => opening({ label: target.files[0].name, text: await target.files[0].text() }, target), "change");

/** Save to the file of the server, or as a download; over what another program wrote only if the person says so. */
async function save(more = {}) {
  const { base, fields } = state(), sent = snapshot(), answer = await asked("save", { base, fields, known, ...more });
  if (!answer) return;
  say(sentences(answer));
  if (answer.text) download(answer.text, "toml");
  if (answer.text || answer.saved) { saved = sent; known = answer.known ?? known; keep(); }
  else if (answer.message && confirm(`${answer.message}\n${words.anyway}`)) await save({ anyway: true });
}
on("#save", () => save());
on("#save-as", () => save({ download: true }));
on("#holding", ({ target }) => {
  if (target === hold) as.value = "";
  change();
}, "input");

// Tabs: arrows move, Enter opens. "live" ones follow every change while open, "open" ones start when opened.
const tabs = all("[role=tab]");
const panel = (tab) => document.getElementById(tab.getAttribute("aria-controls"));
const opened = () => find("[role=tab][aria-selected=true]");
const running = new Map(), answered = new Map();
let timer, due = null;

function open(tab) {
  for (const one of tabs) {
    one.setAttribute("aria-selected", String(one === tab));
    one.tabIndex = one === tab ? 0 : -1;
    panel(one).hidden = one !== tab;
  }
  reachable();
  outdate(tab.dataset.when === "open");
}

/** Mark the answer of the open tab as old, or request a new one if it is a live tab or is due: opened ``now``, not begun. */
function outdate(now = false) {
  const tab = opened(), old = tab && answered.get(tab) !== latest;
  if (now || !old) due = old ? tab : null;
  if (!tab || panel(tab).ariaBusy === "true" && !old) return;
  clearTimeout(timer);
  if (old && latest && (due === tab || tab.dataset.when === "live")) { timer = setTimeout(run, 250, tab); return; }
  find(".answer", panel(tab)).classList.toggle("stale", old);
  find(".said", panel(tab)).textContent = latest ? (old && answered.has(tab) ? words.changed : "") : words.refused;
}

async function run(tab) {
  if (due === tab) due = null;
  running.get(tab)?.abort();
  const mine = new AbortController(), place = panel(tab), name = tab.id.slice(4), sent = state();
  const [answer, said, progress, stop] = [".answer", ".said", "progress", ".stop"].map((one) => find(one, place));
  const options = Object.fromEntries(all("[data-option]", place).map((one) => [one.id, one.value]));
  running.set(tab, mine);
  answered.set(tab, clutch(sent));
  const working = (on) => { place.ariaBusy = String(on); progress.hidden = stop.hidden = !on; };
  const fail = (text) => { if (running.get(tab) === mine) said.textContent = text; };
  const tell = (line) => {
    said.textContent = line.text || words.working;
    if (line.progress === null) progress.removeAttribute("value"); else progress.value = line.progress;
  };
  working(true);
  progress.removeAttribute("value");
  said.textContent = words.working;
  const line = await asked(`tab/${name}`, { ...sent, options }, { fail, tell, signal: mine.signal });
  if (running.get(tab) !== mine) return;
  answer.classList.toggle("stale", line?.html === undefined);
  if (line) {
    said.textContent = "";
    list(find(".problems", place), [...line.problems ?? [], ...mark(line.errors ?? {}, place)]);
    if (line.command) { find(".command", place).textContent = line.command; find("pre", place).hidden = false; }
  }
  if (line?.html === undefined) answered.delete(tab); else put(answer, line.html);
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
/** Show or hide the formulas of a key. */
async function help(button, key) {
  const place = document.getElementById(`help-${key}`), answer = place.hidden && await told("help", { key });
  if (answer) put(place, answer.html);
  place.hidden = !answer;
  button.ariaExpanded = String(!place.hidden);
}

/** Show the keys that mend a finding. */
async function mend(button) {
  const { code, path } = button.dataset;
  button.nextElementSibling.textContent = words.working;
  const answer = await told("mend", { code, path });
  put(twin(button), answer?.html ?? "");
}

/** Place for the keys that mend the finding of a button, also where the verdict was shown anew meanwhile. */
function twin(button) {
  const { code, path } = button.dataset, same = (one) => one.dataset.code === code && one.dataset.path === path;
  return (button.isConnected ? button : all("[data-code]").find(same) ?? button).nextElementSibling;
}

/** Fill in the values that mend a finding, and go to the field. */
async function take(key, entries) {
  fill(entries);
  const field = form.elements[key];
  reveal(field);
  field.focus();
  if (!Object.keys(entries).length) return;
  await change();
  say(words.filled);
}

document.addEventListener("click", async ({ target }) => {
  const { base, help: key, code, go, file } = target.dataset;
  if (target.localName !== "button") return;
  if (base) { await load({ base: Number(base) }); await change(); say(words.loaded); }
  if (key) await help(target, key);
  if (code) await mend(target);
  if (go) await take(go, JSON.parse(target.dataset.fill));
  if (!file) return;
  say(words.working);
  const answer = await told(file);
  if (answer) { download(Uint8Array.from(atob(answer.file), (one) => one.charCodeAt(0)), file); status(); }
});
addEventListener("resize", reachable);

/** Begin with the state kept from before a reload of the page. */
async function begin() {
  const kept = JSON.parse(sessionStorage.getItem(MEMORY) ?? "null");
  saved = kept?.saved ?? snapshot();
  known = kept?.known ?? known;
  if (kept) await restore(kept);
  if (kept) pin(kept.pinned);
  all("[data-number]", form).forEach(follow);
  await change();
  if (!opened()) open(tabs[0]);
}
begin();
