// The points of a sweep in linked charts: all axes and figures side by side, fronts, and each axis alone.

// A measure of the front, or another figure: what it is called, and whether more of it is better.
const figureNames = { fps: "frames a second", cycles: "cycles", pixels_other_primitive: "pixels with another primitive",
  node_hit_rate: "node hits", prim_hit_rate: "primitive hits", bytes_per_ray: "bytes a ray", multipliers: "multipliers",
  flip_flops: "flip-flops", memory_bytes: "memory image, bytes", chip_memory_bits: "memory on the chip, bits",
  chip_luts: "LUTs", chip_multipliers: "multipliers of the chip", chip_block_rams: "block RAMs" };
const moreIsBetter = new Set(["fps", "node_hit_rate", "prim_hit_rate"]);
const points = data.points.map((p, id) => ({ ...p, id })), done = points.filter(p => typeof p.fps === "number");
const isThere = key => done.some(p => typeof p[key] === "number");
const differs = key => isThere(key) && new Set(done.map(p => p[key])).size > 1;
const fourDigits = new Intl.NumberFormat("en-US", { maximumSignificantDigits: 4 });   // made once: it takes long
const short = v => fourDigits.format(Number(v));
const nameOf = p => data.axes.map((axis, a) => `${axis.key} ${p.typed[a]}`).join(", ");
const tooltips = points.map(p => nameOf(p) + ": " + ["fps", ...data.front.filter(key => key !== "fps")].filter(key =>
  typeof p[key] === "number").map(key => `${short(p[key])} ${figureNames[key]}`).join(", "));
const tooltipOf = p => tooltips[p.id];
const frontKeys = data.front.map(key => isThere(key) ? key : "memory_bytes");

// What is pointed at, and what is left out, is the same in all charts.
const views = {};
let picked = -1, keeps = false, shown = points.map(() => true);
const linked = () => [{ name: "picked", value: picked }, { name: "shown", value: shown }];
const speeds = done.map(p => p.fps);
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

function parallelSpec() {
  const dimensions = data.axes.map((axis, a) => ({ title: axis.key, at: p => axis.values.length < 2 ? 0.5 :
    axis.values.indexOf(p.typed[a]) / (axis.values.length - 1), ticks: axis.values.map((label, i) =>
    ({ label, y: axis.values.length < 2 ? 0.5 : i / (axis.values.length - 1) })).filter((t, i, all) => i % Math.ceil(all.length / 12) === 0) }));
  for (const key of new Set(["fps", "node_hit_rate", "prim_hit_rate", "bytes_per_ray", ...frontKeys])) {
    if (!differs(key)) continue;
    const has = done.filter(p => typeof p[key] === "number"), values = has.map(p => p[key]);
    const low = Math.min(...values), high = Math.max(...values);
    dimensions.push({ title: figureNames[key], at: p => typeof p[key] === "number" ? (p[key] - low) / (high - low) : null,
      ticks: [0, 0.25, 0.5, 0.75, 1].map(y => ({ y, label: short(low + y * (high - low)) })) });
  }
  const rows = done.flatMap(p => dimensions.map((d, i) => ({ point: p.id, i, y: d.at(p), fps: p.fps, tooltip: tooltipOf(p) })))
    .filter(row => row.y !== null);
  const ticks = dimensions.flatMap((d, i) => d.ticks.map(t => ({ ...t, i })));
  const x = { scale: "x", field: "i" }, y = { scale: "y", field: "y" };
  return {
    title: "Every point, through its values and its figures; the brighter, the faster", width: Math.max(900, 120 * dimensions.length), height: 340,
    data: [{ name: "rows", values: rows }, { name: "ticks", values: ticks }, { name: "dimensions", values: dimensions.map((d, i) => ({ i, title: d.title })) }],
    scales: [{ name: "x", type: "point", domain: dimensions.map((d, i) => i), range: "width", padding: 0.4 },
      { name: "y", domain: [0, 1], range: "height" }, speedScale],
    legends: [{ fill: "speed", title: "frames a second", type: "gradient", orient: "right" }],
    marks: [
      { type: "rule", from: { data: "dimensions" }, encode: { enter: { x, y: { value: 0 }, y2: { signal: "height" }, stroke: { value: "#98a3b0" } } } },
      { type: "group", from: { facet: { name: "line", data: "rows", groupby: "point" } }, marks: lineMarks(0.6, x, y) },
      ...[3, 0].map(halo => ({ type: "text", from: { data: "ticks" }, interactive: false, encode: { enter: { x: { ...x, offset: -6 }, y,
        text: { field: "label" }, align: { value: "right" }, baseline: { value: "middle" }, fontSize: { value: 11 }, fill: { value: "#1c2430" },
        ...(halo ? { stroke: { value: "#fff" }, strokeWidth: { value: halo }, strokeOpacity: { value: 0.85 } } : {}) } } })),
      { type: "text", from: { data: "dimensions" }, encode: { enter: { x, y: { value: -12 }, text: { field: "title" }, align: { value: "center" },
        fontSize: { value: 12 }, fontWeight: { value: 600 }, limit: { value: 112 } } } }
    ]
  };
}

function frontOf(all, a, b) {
  const sign = key => moreIsBetter.has(key) ? -1 : 1, at = (p, key) => sign(key) * p[key];
  return all.filter(p => !all.some(o => at(o, a) <= at(p, a) && at(o, b) <= at(p, b) && (at(o, a) < at(p, a) || at(o, b) < at(p, b))));
}
function frontSpec(a, b) {
  const all = done.filter(p => typeof p[a] === "number" && typeof p[b] === "number"), front = frontOf(all, a, b);
  const rows = all.map(p => ({ point: p.id, a: p[a], b: p[b], fps: p.fps, front: front.includes(p), knee: p.knee, tooltip: tooltipOf(p) }));
  const line = rows.filter(r => r.front).sort((p, q) => p.a - q.a || p.b - q.b);
  const scale = (name, field, range) => ({ name, domain: { data: "rows", field }, range, nice: true, zero: false });
  const x = { scale: "x", field: "a" }, y = { scale: "y", field: "b" };
  return {
    width: 330, height: 260, data: [{ name: "rows", values: rows }, { name: "front", values: line }],
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
  const rows = all.map(p => ({ point: p.id, at: axis.values.indexOf(p.typed[a]), y: p[key], fps: p.fps, tooltip: tooltipOf(p),
    others: p.typed.filter((v, i) => i !== a).join("\n") })).sort((p, q) => p.at - q.at);
  const means = axis.values.map((v, at) => ({ at, all: rows.filter(r => r.at === at) })).filter(m => m.all.length > 0)
    .map(m => ({ at: m.at, y: m.all.reduce((sum, r) => sum + r.y, 0) / m.all.length }));
  const x = { scale: "x", field: "at" }, y = { scale: "y", field: "y" };
  const labels = { labels: { update: { text: { signal: `${JSON.stringify(axis.values)}[datum.value]` } } } };
  return {
    width: Math.max(150, Math.min(420, 34 * axis.values.length)), height: 220,
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
  for (let a = 0; a < data.axes.length; ++a) await link("alone-" + a, aloneSpec(a, byId("figure").value));
}
async function showPoints() {
  if (done.length === 0) throw new Error("no point has figures");
  addFilters();
  for (const key of Object.keys(figureNames).filter(isThere)) byId("figure").add(new Option(figureNames[key], key));
  byId("figure").addEventListener("change", showAlone);
  byId("points").querySelectorAll("tbody tr").forEach((row, id) => row.addEventListener("mouseover", () => { if (!keeps) pick(id); }));
  data.axes.forEach((axis, a) => {
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
