// The charts. Each is a specification of Vega; the figures are those of the tables.

// The clock whose figures are shown. Pictures of cost, links and what lies over time are those of the first one.
let chosen = 0;
const clock = () => report.clocks[chosen];

// What gives out tiles waits until the pipelines have room: with all contexts in use that is as it should be.
const kindColours = { busy: "#009e73", starved: "#9fb3c8", stalled: "#d55e00", "has given out enough": "#d5dde6" };
const stalledKind = unit => unit === "dispatch" ? "has given out enough" : "stalled";
const kindsShown = rows => Object.keys(kindColours).filter(kind => rows.some(r => r.kind === kind));

function accountRows() {
  const rows = [];
  for (const [unit, account] of Object.entries(clock().units))
    for (const [kind, causes] of [["busy", account.busy_with], ["starved", account.starved_by], [stalledKind(unit), account.stalled]])
      for (const [cause, cycles] of Object.entries(causes))
        if (cycles > 0) rows.push({ unit, kind, cause, cycles });
  return rows;
}

// Bars of shares, one for each unit, cut by cause.
function accountsSpec() {
  const rows = accountRows(), total = {}, order = Object.keys(clock().units);
  for (const r of rows) total[r.unit] = (total[r.unit] || 0) + r.cycles;
  const seen = {};
  for (const r of rows) {
    r.from = seen[r.unit] || 0;
    r.to = seen[r.unit] = r.from + r.cycles / total[r.unit];
    const nth = rows.filter(o => o.unit === r.unit && o.kind === r.kind).indexOf(r);
    r.opacity = Math.max(0.4, 1 - 0.22 * nth);
    r.label = (r.to - r.from) * within(1000) > 7 * r.cause.length + 100 * isNarrow() ? r.cause : "";
    r.tooltip = `${r.unit}: ${r.kind}, ${r.cause}: ${grouped(r.cycles)} cycles, ${(100 * (r.to - r.from)).toFixed(2)} %`;
  }
  return {
    title: "Cycles of every unit", fills: true, width: within(1000), height: 26 * order.length,
    data: [{ name: "rows", values: rows }],
    scales: [{ name: "x", domain: [0, 1], range: "width" },
      { name: "y", type: "band", domain: order, range: "height", paddingInner: 0.18 },
      { name: "colour", type: "ordinal", domain: kindsShown(rows), range: kindsShown(rows).map(kind => kindColours[kind]) }],
    axes: [{ orient: "bottom", scale: "x", format: "%", tickCount: isNarrow() ? 4 : 10 }, { orient: "left", scale: "y" }],
    legends: [{ fill: "colour", orient: "top", direction: "horizontal", columns: isNarrow() ? 2 : 4, symbolType: "square" }],
    marks: [{
      type: "rect", from: { data: "rows" }, encode: { enter: {
        x: { scale: "x", field: "from" }, x2: { scale: "x", field: "to" }, y: { scale: "y", field: "unit" },
        height: { scale: "y", band: 1 }, fill: { scale: "colour", field: "kind" }, fillOpacity: { field: "opacity" },
        stroke: { value: "#fff" }, strokeWidth: { value: 0.7 }, tooltip: { field: "tooltip" } } }
    }, {
      type: "text", from: { data: "rows" }, encode: { enter: {
        x: { scale: "x", signal: "(datum.from + datum.to) / 2" }, y: { scale: "y", field: "unit", band: 0.5 },
        text: { field: "label" }, align: { value: "center" }, baseline: { value: "middle" }, fontSize: { value: 11 },
        fill: { signal: "datum.kind == 'busy' || datum.kind == 'stalled' ? '#fff' : '#1c2430'" } } }
    }]
  };
}

function histogramSpec() {
  const values = data.maps[0].values, bins = 60, most = data.maps[0].max;
  const step = Math.max(1, Math.ceil((most + 1) / bins)), counts = [];
  for (const v of values) counts[Math.floor(v / step)] = (counts[Math.floor(v / step)] || 0) + 1;
  const rows = Array.from(counts, (n, i) => ({ from: i * step, to: (i + 1) * step, pixels: n || 0,
    tooltip: `${grouped(i * step)} to ${grouped((i + 1) * step - 1)} cycles: ${grouped(n || 0)} pixels` }));
  return {
    title: "Pixels by their cycles", fills: true, width: within(1000), height: 180, data: [{ name: "rows", values: rows }],
    scales: [{ name: "x", domain: [0, step * rows.length], range: "width" },
      { name: "y", type: "symlog", domain: { data: "rows", field: "pixels" }, range: "height", nice: true }],
    axes: [{ orient: "bottom", scale: "x", title: "cycles from entering the pipeline to leaving it", tickCount: isNarrow() ? 4 : 10 },
      { orient: "left", scale: "y", title: "pixels (logarithmic)", tickCount: 5, values: [1, 10, 100, 1000, 10000, 100000] }],
    marks: [{ type: "rect", from: { data: "rows" }, encode: { enter: {
      x: { scale: "x", field: "from" }, x2: { scale: "x", field: "to", offset: -1 }, y: { scale: "y", field: "pixels" },
      y2: { scale: "y", value: 0 }, fill: { value: "#0072b2" }, tooltip: { field: "tooltip" } } } }]
  };
}

// The least cycles that each resource needs, and the frame's.
function rooflineSpec() {
  const { bounds, bound, cycles } = clock();
  const names = { trav: "node visits", tri: "primitive tests", shade: "passes of shade", memory: "the memory's data bus" };
  const rows = Object.entries(bounds).filter(([, least]) => least > 0).map(([unit, least]) => ({ name: names[unit] || unit, cycles: least, bound: unit === bound }));
  rows.push({ name: "the frame", cycles, frame: true });
  for (const r of rows) r.tooltip = `${r.name}: ${grouped(Math.round(r.cycles))} cycles`;
  return {
    title: `Roofline at ${clock().mhz} MHz: the least cycles that each resource needs for this frame`, fills: true, width: within(860), height: 26 * rows.length,
    data: [{ name: "rows", values: rows }],
    scales: [{ name: "x", domain: [0, cycles], range: "width", nice: true, zero: true },
      { name: "y", type: "band", domain: rows.map(r => r.name), range: "height", paddingInner: 0.25 }],
    axes: [{ orient: "bottom", scale: "x", title: "cycles", tickCount: isNarrow() ? 3 : 6 }, { orient: "left", scale: "y" }],
    marks: [{ type: "rect", from: { data: "rows" }, encode: { enter: {
      x: { scale: "x", value: 0 }, x2: { scale: "x", field: "cycles" }, y: { scale: "y", field: "name" },
      height: { scale: "y", band: 1 }, tooltip: { field: "tooltip" },
      fill: { signal: "datum.frame ? '#1c2430' : datum.bound ? '#d55e00' : '#9fb3c8'" } } } }]
  };
}

const unitColours = { raygen: "#9ad0f5", trav: "#0072b2", node_cache: "#4a9fd6", ...forNodeUnits("#009e73"), list: "#e3a8c6",
  prim_cache: "#b3538a", tri: "#e69f00", surf_cache: "#a8902a", shade: "#f0e442", tex: "#56b4e9", tex_cache: "#8a8ad6", memory: "#d55e00" };
function kindsSpec() {
  const rows = [];
  for (const [kind, k] of Object.entries(data.kinds)) {
    let at = 0;
    for (const [unit, cycles] of Object.entries(k.cycles_by_unit)) {
      const mean = cycles / k.rays;
      rows.push({ kind, unit, from: at, to: at += mean, tooltip: `${kind}: ${mean.toFixed(1)} cycles of a ray in ${unit}` });
    }
  }
  const kinds = Object.keys(data.kinds).filter(kind => data.kinds[kind].rays > 0);
  const units = [...new Set([...Object.keys(unitColours), ...rows.map(r => r.unit)])].filter(unit => rows.some(r => r.unit === unit));
  return {
    title: "Mean cycles of a ray in each unit, by what the ray is for", fills: true, width: within(960), height: 34 * kinds.length,
    data: [{ name: "rows", values: rows }],
    scales: [{ name: "x", domain: { data: "rows", field: "to" }, range: "width", zero: true, nice: true },
      { name: "y", type: "band", domain: kinds, range: "height", paddingInner: 0.25 },
      { name: "colour", type: "ordinal", domain: units, range: units.map(unit => unitColours[unit] || "#888888") }],
    axes: [{ orient: "bottom", scale: "x", title: "cycles", tickCount: isNarrow() ? 4 : 10 }, { orient: "left", scale: "y" }],
    legends: [{ fill: "colour", orient: "top", direction: "horizontal", columns: isNarrow() ? 3 : 12, symbolType: "square" }],
    marks: [{ type: "rect", from: { data: "rows" }, encode: { enter: {
      x: { scale: "x", field: "from" }, x2: { scale: "x", field: "to" }, y: { scale: "y", field: "kind" },
      height: { scale: "y", band: 1 }, fill: { scale: "colour", field: "unit" }, tooltip: { field: "tooltip" },
      stroke: { value: "#fff" }, strokeWidth: { value: 0.5 } } } }]
  };
}

// Lines over the frame's cycles. Lines that lie on each other differ in their dashes, so that none is hidden.
const dashes = [[1, 0], [7, 5], [2, 4], [12, 4, 2, 4], [4, 2], [1, 2], [9, 9], [3, 7]];
function linesSpec(title, axis, rows, format, top) {
  const names = [...new Set(rows.map(r => r.name))];
  const extra = top === undefined ? {} : { domainMax: top };
  return {
    title, fills: true, width: within(1060), height: 150, data: [{ name: "rows", values: rows }],
    scales: [{ name: "x", domain: [0, data.cycles], range: "width" },
      { name: "y", domain: { data: "rows", field: "value" }, range: "height", zero: true, nice: top === undefined, ...extra },
      { name: "colour", type: "ordinal", domain: names, range: names.map((name, i) => unitColours[name] ||
        ["#0072b2", "#d55e00", "#009e73", "#cc79a7"][i % 4]) },
      { name: "dash", type: "ordinal", domain: names, range: names.map((name, i) => dashes[i % dashes.length]) }],
    axes: [{ orient: "bottom", scale: "x", title: "cycle of the frame", tickCount: isNarrow() ? 3 : 10 },
      { orient: "left", scale: "y", title: axis, tickCount: 5, ...(format ? { format } : {}), grid: true, gridColor: "#eef1f5" }],
    legends: names.length > 1 ? [{ stroke: "colour", strokeDash: "dash", orient: legendSide(), symbolType: "stroke", symbolSize: 900,
      direction: isNarrow() ? "horizontal" : "vertical", columns: isNarrow() ? 3 : 1, encode: { symbols: { update: { strokeWidth: { value: 2 } } } } }] : [],
    marks: [{ type: "group", from: { facet: { name: "series", data: "rows", groupby: "name" } }, marks: [{
      type: "line", from: { data: "series" }, encode: { enter: {
        x: { scale: "x", field: "at" }, y: { scale: "y", field: "value" }, stroke: { scale: "colour", field: "name" },
        strokeDash: { scale: "dash", field: "name" }, strokeWidth: { value: 1.8 } } } }] }]
  };
}
const windowRows = values => data.windows.flatMap(w => Object.entries(values(w)).map(([name, value]) =>
  ({ at: w.first + w.cycles / 2, name, value })));

// Each tile where it lies in the picture, as dark as it took long.
function tilesSpec() {
  const side = 1 << data.tile_bits, columns = Math.ceil(data.width / side), lines = Math.ceil(data.height / side);
  const rows = data.tiles.map(([x, y, pipeline, first, last], i) => ({ x, y, cycles: last - first,
    tooltip: `tile ${x}, ${y}: ${grouped(last - first)} cycles, ${grouped(first)} to ${grouped(last)}, pipeline ${pipeline}; ` +
      `the ${grouped(i + 1)}th to be given out` }));
  const size = Math.max(isNarrow() ? 2 : 6, Math.min(40, Math.floor(Math.min(760, room() - 64) / columns)));
  return {
    title: "Tiles: cycles from the first pixel's start to the last pixel's end", width: size * columns, height: size * lines,
    data: [{ name: "rows", values: rows }],
    scales: [{ name: "x", domain: [0, columns], range: "width" }, { name: "y", domain: [0, lines], range: [0, size * lines] },
      { name: "colour", type: "linear", domain: { data: "rows", field: "cycles" }, zero: true, range: { scheme: "blues" } }],
    axes: [{ orient: "bottom", scale: "x", title: "tile, from the left" }, { orient: "left", scale: "y", title: "tile, from the top" }],
    legends: [{ fill: "colour", title: "cycles", type: "gradient", orient: legendSide() }],
    marks: [{ type: "rect", from: { data: "rows" }, encode: { enter: {
      x: { scale: "x", field: "x" }, width: { value: size }, y: { scale: "y", field: "y" }, height: { value: size },
      fill: { scale: "colour", field: "cycles" }, stroke: { value: "#fff" }, strokeWidth: { value: 0.5 },
      tooltip: { field: "tooltip" } } } }]
  };
}
