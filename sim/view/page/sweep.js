// The points of a sweep in linked charts: all axes and figures side by side, fronts, and each axis alone.

// A measure of the front, or another figure: what it is called, and whether more of it is better.
const figureNames = { fps: "frames a second", film_fps: "frames a second of the film", cycles: "cycles", pixels_other_primitive: "pixels with another primitive",
  node_hit_rate: "node hits", prim_hit_rate: "primitive hits", bytes_per_ray: "bytes a ray", multipliers: "multipliers",
  flip_flops: "flip-flops", memory_bytes: "memory image, bytes", chip_memory_bits: "memory on the chip, bits", rays: "rays",
  chip_luts: "LUTs", chip_multipliers: "multipliers of the chip", chip_block_rams: "block RAMs" };
const moreIsBetter = new Set(["fps", "film_fps", "node_hit_rate", "prim_hit_rate"]);
const points = data.points.map((p, id) => ({ ...p, id })), done = points.filter(p => typeof p.fps === "number");
const isThere = key => done.some(p => typeof p[key] === "number");
const differs = key => isThere(key) && new Set(done.map(p => p[key])).size > 1;
const fourDigits = new Intl.NumberFormat("en-US", { maximumSignificantDigits: 4 });   // made once: it takes long
const short = v => fourDigits.format(Number(v));
const nameOf = p => data.axes.map((axis, a) => `${axis.key} ${p.typed[a]}`).join(", ");
const tooltips = points.map(p => nameOf(p) + ": " + [...new Set([data.front[2], "fps", ...data.front])].filter(key =>
  typeof p[key] === "number").map(key => `${short(p[key])} ${figureNames[key]}`).join(", "));
const tooltipOf = p => tooltips[p.id];
const frontKeys = data.front.map(key => isThere(key) ? key : "memory_bytes"), speedKey = frontKeys[2];

// What is pointed at, and what is left out, is the same in all charts.
const views = {};
let picked = -1, keeps = false, shown = points.map(() => true);
const linked = () => [{ name: "picked", value: picked }, { name: "shown", value: shown }];
const speeds = done.map(p => p[speedKey]);
const speedScale = { name: "speed", type: "linear", domain: [Math.min(...speeds), Math.max(...speeds)], range: { scheme: "viridis" } };

function pick(id) {
  if (id === picked) return;
  const rows = byId("points").querySelectorAll("tbody tr");
  if (rows[picked]) rows[picked].classList.remove("picked");
  picked = id;
  if (rows[id]) rows[id].classList.add("picked");
  for (const view of Object.values(views)) view.signal("picked", id).runAsync();
  byId("picked").textContent = id < 0 ? "No point is picked." : tooltipOf(points[id]);
}
async function link(id, spec) {
  if (views[id]) views[id].finalize();
  const view = views[id] = await show(id, { ...spec, signals: linked() });
  const pointOf = item => item && item.datum && item.datum.point;
  view.addEventListener("mouseover", (event, item) => { if (!keeps && pointOf(item) >= 0) pick(pointOf(item)); });
  view.addEventListener("click", (event, item) => {
    keeps = pointOf(item) >= 0;
    pick(keeps ? pointOf(item) : -1);
  });
}

const seen = (rest, own) => ({ signal: `!shown[datum.point] ? 0 : picked < 0 ? ${rest} : picked === datum.point ? ${own} : ${rest / 6}` });
// Lines, each a thin one that is seen and a wide one that is easy to point at.
const lineMarks = (rest, x, y) => [1.4, 10].map(width => ({
  type: "line", from: { data: "line" }, encode: {
    enter: { x, y, tooltip: { field: "tooltip" }, stroke: width > 2 ? { value: "transparent" } : { scale: "speed", field: "fps" } },
    update: width > 2 ? {} : { strokeOpacity: seen(rest, 1), strokeWidth: { signal: "picked === datum.point ? 3.5 : 1.4" } } } }));

// An axis with one value says nothing, and takes no place.
const dimensionsOf = () => {
  const dimensions = data.axes.map((axis, a) => ({ axis, a })).filter(d => d.axis.values.length > 1).map(({ axis, a }) => ({ title: axis.key,
    at: p => axis.values.indexOf(p.typed[a]) / (axis.values.length - 1), ticks: axis.values.map((label, i) =>
      ({ label, at: i / (axis.values.length - 1) })).filter((t, i, all) => i % Math.ceil(all.length / (isNarrow() ? 6 : 12)) === 0) }));
  for (const key of new Set([speedKey, "node_hit_rate", "prim_hit_rate", "bytes_per_ray", ...frontKeys])) {
    if (!differs(key)) continue;
    const values = done.filter(p => typeof p[key] === "number").map(p => p[key]);
    const low = Math.min(...values), high = Math.max(...values);
    dimensions.push({ title: figureNames[key], at: p => typeof p[key] === "number" ? (p[key] - low) / (high - low) : null,
      ticks: [0, 0.25, 0.5, 0.75, 1].map(at => ({ at, label: short(low + at * (high - low)) })) });
  }
  return dimensions;
};

// A long title in two lines.
const inTwo = title => {
  const words = title.split(" "), cut = k => [words.slice(0, k).join(" "), words.slice(k).join(" ")];
  if (title.length < 17 || words.length < 2) return [title];
  const longest = pair => Math.max(...pair.map(line => line.length));
  return words.slice(1).map((word, k) => cut(k + 1)).reduce((best, pair) => longest(pair) < longest(best) ? pair : best);
};

// Axes side by side, or on a narrow screen one below the other. Ticks lie above the lines, each on paper of its own.
function parallelSpec() {
  const dimensions = dimensionsOf(), across = room() >= 110 * dimensions.length;
  const rows = done.flatMap(p => dimensions.map((d, i) => ({ point: p.id, i, at: d.at(p), fps: p[speedKey], tooltip: tooltipOf(p) })))
    .filter(row => row.at !== null);
  const ticks = dimensions.flatMap((d, i) => d.ticks.map(t => ({ ...t, i, paper: 6.4 * t.label.length + 6 })));
  const place = { scale: "place", field: "i" }, value = { scale: "value", field: "at" };
  const x = across ? place : value, y = across ? value : place;
  const beside = across ? { x: { ...x, offset: -5 }, y, align: { value: "right" }, baseline: { value: "middle" } } :
    { x, y: { ...y, offset: 6 }, align: { signal: "datum.at < 0.05 ? 'left' : datum.at > 0.95 ? 'right' : 'center'" }, baseline: { value: "top" } };
  const paper = across ? { x2: { ...x, offset: -2 }, width: { field: "paper" }, yc: y, height: { value: 14 } } :
    { x: { ...x, offset: { signal: "datum.at < 0.05 ? -3 : datum.at > 0.95 ? 3 - datum.paper : -datum.paper / 2" } }, width: { field: "paper" },
      y: { ...y, offset: 4 }, height: { value: 14 } };
  return {
    title: "Every point, through its values and its figures; the brighter, the faster", fills: across,
    width: across ? within(Math.max(900, 120 * dimensions.length)) : room() - 16, height: across ? 340 : 74 * dimensions.length,
    data: [{ name: "none", values: [] }, { name: "rows", values: rows }, { name: "ticks", values: ticks }, { name: "dimensions", values: dimensions.map((d, i) => ({ i, title: across ? inTwo(d.title) : [d.title] })) }],
    scales: [{ name: "place", type: "point", domain: dimensions.map((d, i) => i), range: across ? "width" : [0, 74 * dimensions.length], padding: 0.4 },
      { name: "value", domain: [0, 1], range: across ? "height" : "width" }, speedScale],
    legends: [{ fill: "speed", title: figureNames[speedKey], type: "gradient", orient: across ? "right" : "top", direction: across ? "vertical" : "horizontal" }],
    marks: [
      { type: "rule", from: { data: "dimensions" }, encode: { enter: { ...(across ? { x, y: { value: 0 }, y2: { signal: "height" } } :
        { y, x: { value: 0 }, x2: { signal: "width" } }), stroke: { value: "#98a3b0" } } } },
      { type: "group", from: { facet: { name: "line", data: "rows", groupby: "point" } }, marks: lineMarks(0.6, x, y) },
      { type: "rect", from: { data: across ? "none" : "dimensions" }, interactive: false, encode: { enter: { x: { value: 0 }, y: { ...y, offset: -20 }, height: { value: 16 },
        width: { signal: "7.2 * length(datum.title[0]) + 8" }, fill: { value: "#fff" }, fillOpacity: { value: 0.88 } } } },
      { type: "rect", from: { data: "ticks" }, interactive: false, encode: { enter: { ...paper, fill: { value: "#fff" }, fillOpacity: { value: 0.88 } } } },
      { type: "text", from: { data: "ticks" }, interactive: false, encode: { enter: { ...beside, text: { field: "label" }, fontSize: { value: 11 }, fill: { value: "#1c2430" } } } },
      { type: "text", from: { data: "dimensions" }, encode: { enter: { ...(across ? { x, y: { signal: "2 - 14 * length(datum.title)" }, align: { value: "center" } } :
        { x: { value: 0 }, y: { ...y, offset: -8 }, align: { value: "left" } }), text: { field: "title" },
        fontSize: { value: 12 }, fontWeight: { value: 600 }, limit: { value: across ? 124 : 300 } } } }
    ]
  };
}

function frontOf(all, a, b) {
  const sign = key => moreIsBetter.has(key) ? -1 : 1, at = (p, key) => sign(key) * p[key];
  return all.filter(p => !all.some(o => at(o, a) <= at(p, a) && at(o, b) <= at(p, b) && (at(o, a) < at(p, a) || at(o, b) < at(p, b))));
}
function frontSpec(a, b) {
  const all = done.filter(p => typeof p[a] === "number" && typeof p[b] === "number"), front = frontOf(all, a, b);
  const rows = all.map(p => ({ point: p.id, a: p[a], b: p[b], fps: p[speedKey], front: front.includes(p), knee: p.knee, tooltip: tooltipOf(p) }));
  const line = rows.filter(r => r.front).sort((p, q) => p.a - q.a || p.b - q.b);
  const scale = (name, field, range) => ({ name, domain: { data: "rows", field }, range, nice: true, zero: false });
  const x = { scale: "x", field: "a" }, y = { scale: "y", field: "b" };
  return {
    fills: true, width: within(358), height: 260, data: [{ name: "rows", values: rows }, { name: "front", values: line }],
    scales: [scale("x", "a", "width"), scale("y", "b", "height"), speedScale],
    axes: [{ orient: "bottom", scale: "x", title: figureNames[a], tickCount: 5, format: "~s" },
      { orient: "left", scale: "y", title: figureNames[b], tickCount: 6, format: "~s", grid: true, gridColor: "#eef1f5" }],
    marks: [{ type: "line", from: { data: "front" }, interactive: false, encode: { enter: { x, y, stroke: { value: "#1c2430" }, strokeDash: { value: [4, 3] } } } },
      { type: "symbol", from: { data: "rows" }, encode: {
        enter: { x, y, tooltip: { field: "tooltip" }, fill: { scale: "speed", field: "fps" }, shape: { signal: "datum.knee ? 'diamond' : 'circle'" },
          stroke: { signal: "datum.front ? '#1c2430' : '#fff'" } },
        update: { opacity: seen(0.9, 1), size: { signal: "(datum.knee ? 160 : 70) * (picked === datum.point ? 2.6 : 1)" },
          strokeWidth: { signal: "picked === datum.point ? 3 : 1.2" } } } }]
  };
}

function aloneSpec(a, key) {
  const axis = data.axes[a], all = done.filter(p => typeof p[key] === "number");
  const rows = all.map(p => ({ point: p.id, at: axis.values.indexOf(p.typed[a]), y: p[key], fps: p[speedKey], tooltip: tooltipOf(p),
    others: p.typed.filter((v, i) => i !== a).join("\n") })).sort((p, q) => p.at - q.at);
  const means = axis.values.map((v, at) => ({ at, all: rows.filter(r => r.at === at) })).filter(m => m.all.length > 0)
    .map(m => ({ at: m.at, y: m.all.reduce((sum, r) => sum + r.y, 0) / m.all.length }));
  const x = { scale: "x", field: "at" }, y = { scale: "y", field: "y" };
  const labels = { labels: { update: { text: { signal: `${JSON.stringify(axis.values)}[datum.value]` } } } };
  return {
    fills: true, width: within(Math.max(220, Math.min(490, 70 + 34 * axis.values.length))), height: 220,
    data: [{ name: "rows", values: rows }, { name: "means", values: means }],
    scales: [{ name: "x", type: "point", domain: axis.values.map((v, i) => i), range: "width", padding: 0.5 },
      { name: "y", domain: { data: "rows", field: "y" }, range: "height", nice: true, zero: false }, speedScale],
    axes: [{ orient: "bottom", scale: "x", title: axis.key, encode: labels, labelOverlap: true },
      { orient: "left", scale: "y", title: figureNames[key], tickCount: 6, format: "~s", grid: true, gridColor: "#eef1f5" }],
    marks: [
      { type: "group", from: { facet: { name: "line", data: "rows", groupby: "others" } }, marks: [{ type: "line", from: { data: "line" }, interactive: false,
        encode: { enter: { x, y, stroke: { value: "#9fb3c8" }, strokeWidth: { value: 1 } }, update: { strokeOpacity: { signal: "picked < 0 ? 0.7 : 0.25" } } } }] },
      { type: "line", from: { data: "means" }, interactive: false, encode: { enter: { x, y, stroke: { value: "#1c2430" }, strokeWidth: { value: 2.5 } } } },
      { type: "symbol", from: { data: "rows" }, encode: { enter: { x, y, tooltip: { field: "tooltip" }, fill: { scale: "speed", field: "fps" } },
        update: { opacity: seen(0.85, 1), size: { signal: "picked === datum.point ? 170 : 40" } } } }]
  };
}

function addFilters() {
  data.axes.forEach((axis, a) => {
    if (axis.values.length < 2) return;
    const line = document.createElement("p");
    line.className = "controls";
    line.append(axis.key);
    for (const value of axis.values) {
      const label = document.createElement("label"), box = document.createElement("input");
      box.type = "checkbox";
      box.checked = true;
      box.addEventListener("change", () => {
        const off = new Set([...byId("filters").querySelectorAll("input:not(:checked)")].map(b => b.dataset.of));
        shown = points.map(p => !p.typed.some((v, i) => off.has(`${i} ${v}`)));
        for (const view of Object.values(views)) view.signal("shown", shown).runAsync();
      });
      box.dataset.of = `${a} ${value}`;
      label.append(box, " ", value);
      line.append(label);
    }
    byId("filters").append(line);
  });
}

async function showAlone() {
  for (let a = 0; a < data.axes.length; ++a) if (data.axes[a].values.length > 1) await link("alone-" + a, aloneSpec(a, byId("figure").value));
}
async function showPoints() {
  if (done.length === 0) throw new Error("no point has figures");
  addFilters();
  for (const key of Object.keys(figureNames).filter(isThere)) byId("figure").add(new Option(figureNames[key], key));
  byId("figure").addEventListener("change", showAlone);
  byId("points").querySelectorAll("tbody tr").forEach((row, id) => row.addEventListener("mouseover", () => { if (!keeps) pick(id); }));
  data.axes.forEach((axis, a) => {
    if (axis.values.length < 2) return;
    const place = document.createElement("div");
    place.className = "chart";
    place.id = "chart-alone-" + a;
    byId("alone").append(place);
  });
  await link("parallel", parallelSpec());
  byId("picked").textContent = "No point is picked.";
}
const [error, cost, speed] = frontKeys;
showPage(showPoints, [
  () => link("error", frontSpec(cost, error)), () => link("speed", frontSpec(cost, speed)),
  () => link("price", frontSpec(speed, error)), showAlone]);
