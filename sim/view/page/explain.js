// The way of a ray through the tree: its visits as a tree, and their cycles one after the other.

const longOf = v => `visit ${v.id + 1}: node in line ${v.line}, ${v.met} of ${v.boxes} boxes met, ${v.tests} to test` +
  (v.closer ? `, ${v.closer} closer` : "") + (v.dropped ? `, ${v.dropped} dropped` : "") +
  `; ${grouped(v.cycles)} cycles, ${grouped(v.work)} of them work` +
  Object.entries(v.waits).map(([cause, cycles]) => `, ${cycles} ${cause}`).join("");
const visitsOf = ray => ray.visits.map((v, id) => ({ ...v, id, parent: v.parent < 0 ? null : v.parent }))
  .map(v => ({ ...v, tooltip: longOf(v), far: v.cache !== "" && v.cache !== "hit" }));

function treeSpec(ray) {
  const visits = visitsOf(ray), depth = [];
  for (const v of visits) depth[v.id] = v.parent === null ? 0 : depth[v.parent] + 1;
  const widest = Math.max(...Array.from({ length: Math.max(...depth) + 1 }, (_, d) => depth.filter(x => x === d).length));
  const most = Math.max(1, ...visits.map(v => v.cycles));
  // A tree that is deeper than wide goes from left to right, as text does.
  const levels = Math.max(...depth) + 1, aside = levels > widest;
  const width = aside ? Math.min(room() - 40, 90 * (levels - 1)) : Math.max(Math.min(500, room() - 40), Math.min(3000, 34 * widest));
  return {
    title: `${ray.purpose} ray: ${grouped(visits.length)} visits`, width, height: aside ? 40 + 44 * (widest - 1) : 26 + 64 * levels,
    data: [{ name: "tree", values: visits, transform: [{ type: "stratify", key: "id", parentKey: "parent" },
      { type: "tree", method: "tidy", size: aside ? [{ signal: "height" }, { signal: "width" }] : [{ signal: "width" }, { signal: "height" }],
        as: aside ? ["y", "x", "depth", "children"] : ["x", "y", "depth", "children"] }] },
      { name: "links", source: "tree", transform: [{ type: "treelinks" }] }, { name: "none", values: [] }],
    scales: [{ name: "size", type: "sqrt", domain: [0, most], range: [8, 26] }],
    marks: [
      { type: "rule", from: { data: "links" }, encode: { enter: { x: { field: "source.x" }, y: { field: "source.y" }, x2: { field: "target.x" },
        y2: { field: "target.y" }, stroke: { value: "#98a3b0" } } } },
      { type: "symbol", from: { data: "tree" }, encode: { enter: { x: { field: "x" }, y: { field: "y" }, tooltip: { field: "tooltip" },
        size: { signal: "pow(scale('size', datum.cycles), 2)" }, stroke: { signal: "datum.far ? '#d55e00' : '#3b4653'" },
        strokeWidth: { signal: "datum.far ? 3 : 1.2" }, fill: { signal: "datum.closer ? '#9be3c4' : datum.tests ? '#cfe6f7' : '#ffffff'" } } } },
      { type: "text", from: { data: "tree" }, interactive: false, encode: { enter: { x: { field: "x" }, y: { field: "y" }, text: { signal: "datum.id + 1" },
        align: { value: "center" }, baseline: { value: "middle" }, fontSize: { value: 9 } } } },
      { type: "text", from: { data: aside ? "tree" : "none" }, interactive: false, encode: { enter: { x: { field: "x" }, y: { field: "y", offset: 24 },
        text: { signal: "datum.cycles + ' cycles'" }, align: { value: "center" }, fontSize: { value: 10 }, fill: { value: "#5d6875" } } } }
    ]
  };
}

// Each visit's cycles, cut into work and what was waited for.
function stepsSpec(ray) {
  const rows = [];
  for (const v of visitsOf(ray)) {
    let from = 0;
    for (const [cause, cycles] of [["work", v.work], ...Object.entries(v.waits)])
      if (cycles > 0) rows.push({ id: v.id + 1, cause, from, to: from += cycles, tooltip: v.tooltip });
  }
  const causes = [...new Set(rows.map(r => r.cause))];
  const ids = ray.visits.map((v, i) => i + 1);
  return {
    title: "Cycles of every visit, with its primitives, and what they were for", width: Math.max(Math.min(500, room() - 150), Math.min(3000, 14 * ids.length)), height: 180,
    data: [{ name: "rows", values: rows }],
    scales: [{ name: "x", type: "band", domain: ids, range: "width", paddingInner: 0.15 },
      { name: "y", domain: { data: "rows", field: "to" }, range: "height", zero: true, nice: true },
      { name: "colour", type: "ordinal", domain: causes, range: ["#009e73", "#d55e00", "#0072b2", "#e69f00", "#cc79a7", "#56b4e9", "#999999", "#f0e442"] }],
    axes: [{ orient: "bottom", scale: "x", title: "visit", labelOverlap: true }, { orient: "left", scale: "y", title: "cycles", tickCount: 5 }],
    legends: [{ fill: "colour", orient: legendSide(), direction: isNarrow() ? "horizontal" : "vertical", columns: isNarrow() ? 2 : 1, symbolType: "square" }],
    marks: [{ type: "rect", from: { data: "rows" }, encode: { enter: { x: { scale: "x", field: "id" }, width: { scale: "x", band: 1 },
      y: { scale: "y", field: "from" }, y2: { scale: "y", field: "to" }, fill: { scale: "colour", field: "cause" }, tooltip: { field: "tooltip" } } } }]
  };
}

let drawn = [];
async function showRay() {
  for (const view of drawn) view.finalize();
  const ray = data.rays[byId("ray").value];
  drawn = ray.visits.length ? [await show("tree", treeSpec(ray)), await show("steps", stepsSpec(ray))] : [];
}
showPage(async () => {
  data.rays.forEach((ray, i) => byId("ray").add(new Option(`${i}: ${ray.purpose}, ${ray.visits.length} visits`, i)));
  byId("ray").addEventListener("change", showRay);
  await showRay();
});
