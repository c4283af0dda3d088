// The block diagram, and the order in which everything is shown.

// Where a unit's box lies: column and row.
const unitPlaces = { dispatch: [0, 1], sched: [1, 1], raygen: [2, 1], trav: [3, 1], ...forNodeUnits([4, 0]), xform: [5, 0], node_cache: [5, 1],
  list: [3, 2], prim_cache: [5, 2], tri: [4, 3], shade: [2, 3], surf_cache: [5, 4], tex: [3, 4], tex_cache: [4, 4], memport: [6, 1.5], l2: [6, 3],
  hits: [6, 0], memory: [7, 1.5] };

function machineSpec() {
  // On a narrow screen the diagram goes down and not across: columns are lines then.
  const names = Object.keys(clock().units), hasStrangers = names.some(name => !unitPlaces[name]), across = !isNarrow();
  const lines = hasStrangers ? 6 : 5, pitch = across ? 138 : Math.floor(room() / lines) - 2, step = across ? 92 : 88;
  const wide = across ? 104 : pitch - 9, high = 58, letters = across ? 13 : 9.5, units = [], bars = [];
  let strangers = 0;   // units that have no place yet
  for (const [name, account] of Object.entries(clock().units)) {
    const [column, row] = unitPlaces[name] || [strangers++, 5];
    const stalled = Object.values(account.stalled).reduce((a, b) => a + b, 0);
    const all = account.busy + account.starved + stalled;
    const unit = { name, x: (across ? column : row) * pitch, y: (across ? row : column) * step, shares: { busy: account.busy / all, starved: account.starved / all,
      [stalledKind(name)]: stalled / all } };
    unit.text = `${(100 * unit.shares.busy).toFixed(across ? 1 : 0)} % busy`;
    unit.tooltip = `${name}: ${Object.entries(unit.shares).map(([k, s]) => `${k} ${(100 * s).toFixed(2)} %`).join(", ")}; ` +
      `${grouped(account.count)} pieces of work`;
    let at = unit.x + 6;
    for (const [kind, share] of Object.entries(unit.shares))
      bars.push({ kind, x: at, x2: at += share * (wide - 12), y: unit.y + high - 16, tooltip: unit.tooltip });
    units.push(unit);
  }
  const places = Object.fromEntries(units.map(u => [u.name, u])), links = [], pairs = {}, between = {};
  const pairOf = link => [link.from, link.to].sort().join();
  for (const link of data.links) between[pairOf(link)] = (between[pairOf(link)] || 0) + 1;
  for (const link of data.links) {
    const a = places[link.from], b = places[link.to];
    if (!a || !b) continue;
    const pair = pairOf(link);
    pairs[pair] = (pairs[pair] || 0) + 1;
    const centre = u => [u.x + wide / 2, u.y + high / 2];
    const [ax, ay] = centre(a), [bx, by] = centre(b), length = Math.hypot(bx - ax, by - ay);
    const ux = (bx - ax) / length, uy = (by - ay) / length, side = link.from < link.to ? 1 : -1;
    const aside = between[pair] > 1 ? side * (2 * pairs[pair] + 3) : 0;
    const edge = Math.min(Math.abs(ux) > 1e-9 ? (wide / 2 + 2) / Math.abs(ux) : 1e9, Math.abs(uy) > 1e-9 ? (high / 2 + 2) / Math.abs(uy) : 1e9);
    const cycles = link.lanes * data.cycles, refused = link.refused / cycles;
    links.push({ x: ax + ux * edge - uy * aside, y: ay + uy * edge + ux * aside, x2: bx - ux * (edge + 5) - uy * aside,
      y2: by - uy * (edge + 5) + ux * aside, angle: Math.atan2(uy, ux) * 180 / Math.PI + 90,
      width: 1 + 5 * link.moved / cycles, colour: Math.min(1, refused * 4),
      tooltip: `${link.name}: ${grouped(link.moved)} transfers, ${(100 * link.moved / cycles).toFixed(2)} % of its cycles; ` +
        `refused in ${(100 * refused).toFixed(2)} %` });
  }
  const encode = more => ({ enter: { tooltip: { field: "tooltip" }, ...more } });
  const field = name => ({ field: name });
  return {
    width: across ? 7 * pitch + wide : (lines - 1) * pitch + wide, height: across ? (lines - 1) * step + high : 7 * step + high,
    data: [{ name: "units", values: units }, { name: "bars", values: bars }, { name: "links", values: links }],
    scales: [{ name: "kind", type: "ordinal", domain: kindsShown(bars), range: kindsShown(bars).map(kind => kindColours[kind]) },
      { name: "heat", domain: [0, 1], range: ["#98a3b0", "#c00000"] }],
    legends: [{ fill: "kind", orient: "top", direction: "horizontal", columns: across ? 4 : 2, symbolType: "square" }],
    marks: [
      { type: "rule", from: { data: "links" }, encode: encode({ x: field("x"), y: field("y"), x2: field("x2"), y2: field("y2"),
        stroke: { scale: "heat", field: "colour" }, strokeWidth: field("width") }) },
      { type: "symbol", from: { data: "links" }, encode: encode({ x: field("x2"), y: field("y2"), shape: { value: "triangle-up" },
        angle: field("angle"), size: { value: 70 }, fill: { scale: "heat", field: "colour" } }) },
      { type: "rect", from: { data: "units" }, encode: encode({ x: field("x"), y: field("y"), width: { value: wide },
        height: { value: high }, fill: { value: "#fff" }, stroke: { value: "#3b4653" }, cornerRadius: { value: 6 } }) },
      { type: "rect", from: { data: "bars" }, encode: encode({ x: field("x"), x2: field("x2"), y: field("y"), height: { value: 9 },
        fill: { scale: "kind", field: "kind" } }) },
      { type: "text", from: { data: "units" }, encode: encode({ x: { field: "x", offset: wide / 2 }, y: { field: "y", offset: 16 },
        text: field("name"), align: { value: "center" }, fontSize: { signal: `min(${letters}, ${1.55 * wide} / length(datum.name))` }, fontWeight: { value: 600 } }) },
      { type: "text", from: { data: "units" }, encode: encode({ x: { field: "x", offset: wide / 2 }, y: { field: "y", offset: 33 },
        text: field("text"), align: { value: "center" }, fontSize: { value: across ? 11 : 9.5 }, fill: { value: "#5d6875" } }) }
    ]
  };
}

const share = (kinds, at) => kinds[at] / (kinds[0] + kinds[1] + kinds[2] || 1);
function raysSpec() {
  return linesSpec("Rays under way", "contexts in use", windowRows(w => ({ rays: w.rays_under_way })), "",
    data.pipelines * data.contexts);
}
function activitySpec() {
  const shown = ["trav", ...nodeUnits, "xform", "tri", "shade", "memory"];
  return linesSpec("Busy units", "share of cycles", windowRows(w => Object.fromEntries(
    shown.filter(unit => w.units[unit]).map(unit => [unit, share(w.units[unit], 0)]))), "%", 1);
}
function hitsSpec() {
  return linesSpec("Hit rates", "hits of look-ups", windowRows(w => Object.fromEntries(
    Object.entries(w.caches).filter(([, c]) => c[1] > 0).map(([cache, c]) => [cache, c[0] / c[1]]))), "%", 1);
}
function bandwidthSpec() {
  return linesSpec("Memory", "GB/s", windowRows(w => ({ "data read": w.gb_per_s,
    "from open rows": w.reads ? w.gb_per_s * w.row_hits / w.reads : 0 })), "");
}
const below = { histogram: histogramSpec, machine: machineSpec, roofline: rooflineSpec, accounts: accountsSpec,
  kinds: kindsSpec, rays: raysSpec, activity: activitySpec, hits: hitsSpec, bandwidth: bandwidthSpec, tiles: tilesSpec };

// Another clock: its key figures, bounds and accounts. What was watched pixel by pixel is that of the first.
const percent = (part, all) => all ? `${(100 * part / all).toFixed(1)} %` : "";
const sumOf = parts => Object.values(parts).reduce((a, b) => a + b, 0);
function fillTable(table, rows) {
  table.tBodies[0].replaceChildren(...rows.map(cells => {
    const row = document.createElement("tr");
    cells.forEach((text, i) => {
      const cell = row.insertCell();
      cell.textContent = text;
      if (cells.left > i) cell.className = "word";
    });
    return row;
  }));
}
function accountLine(unit, a) {
  const all = a.busy + a.starved + sumOf(a.stalled);
  const parts = (causes, lead) => Object.entries(causes).filter(([, n]) => n > 0 && 2000 * n >= all)
    .map(([cause, n]) => `${lead}${cause} ${percent(n, all)}`);
  const causes = [...parts(a.busy_with, ""), ...parts(a.starved_by, "starved by "), ...parts(a.stalled, "stalled by ")];
  return Object.assign([unit, causes.join(", "), a.instances, grouped(a.count), percent(a.busy, all), percent(a.starved, all),
    percent(sumOf(a.stalled), all)], { left: 2 });
}
async function chooseClock() {
  chosen = Number(byId("clock").value);
  const c = clock(), cells = document.querySelectorAll("header .figures b");
  [grouped(c.cycles), c.fps.toFixed(2), c.mrays_per_s.toFixed(2), `${(100 * c.bound_reached).toFixed(0)} %`, c.bound].forEach((text, i) =>
    cells[i].textContent = text);
  byId("clock-note").hidden = chosen === 0;
  byId("bottleneck").textContent = c.bottleneck + ".";
  fillTable(document.querySelector("#accounts table"), Object.entries(c.units).map(([unit, a]) => accountLine(unit, a)));
  for (const id of ["machine", "roofline", "accounts"]) await show(id, below[id]());
}
if (byId("clock")) byId("clock").addEventListener("change", chooseClock);
showPage(showViewer, Object.entries(below).map(([id, spec]) => () => show(id, spec())));
