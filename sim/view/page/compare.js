// What changed: figures by their effect, and cycles gained and lost in every pixel.

const verdicts = { better: "#009e73", worse: "#d55e00", neither: "#9fb3c8" };
function effectsSpec() {
  const rows = data.differences.filter(d => d.change !== null && d.values[d.values.length - 1] !== null).slice(0, 40).map(d => ({
    figure: d.name, change: d.change, verdict: d.verdict || "neither", label: `${d.change > 0 ? "+" : ""}${(100 * d.change).toFixed(2)} %`,
    tooltip: `${d.name} (${d.figure}): ${d.values.map(v => v === null ? "none" : numbers.format(v)).join(" to ")}` }));
  return {
    title: "What people ask for first, then the largest changes, relative to the first report", fills: true, width: within(1060), height: 20 * Math.max(1, rows.length),
    data: [{ name: "rows", values: rows }],
    scales: [{ name: "x", type: "symlog", constant: 0.01, domain: { data: "rows", field: "change" }, range: "width", zero: true, nice: true },
      { name: "y", type: "band", domain: rows.map(r => r.figure), range: "height", paddingInner: 0.2 },
      { name: "verdict", type: "ordinal", domain: Object.keys(verdicts), range: Object.values(verdicts) }],
    axes: [{ orient: "bottom", scale: "x", format: "+.0%", title: "change (symmetric logarithm)", values: [-1, -0.1, -0.01, 0, 0.01, 0.1, 1, 10], labelOverlap: true },
      { orient: "left", scale: "y", labelLimit: isNarrow() ? room() / 2 : 420 }],
    legends: [{ fill: "verdict", orient: "top", direction: "horizontal", symbolType: "square" }],
    marks: [{ type: "rect", from: { data: "rows" }, encode: { enter: { x: { scale: "x", value: 0 }, x2: { scale: "x", field: "change" },
      y: { scale: "y", field: "figure" }, height: { scale: "y", band: 1 }, fill: { scale: "verdict", field: "verdict" }, tooltip: { field: "tooltip" } } } },
    { type: "text", from: { data: "rows" }, encode: { update: { x: { signal: "width + 64" },
      y: { scale: "y", field: "figure", band: 0.5 }, text: { field: "label" }, align: { value: "right" },
      baseline: { value: "middle" }, fontSize: { value: 10 } } } }]
  };
}

// Less is green, more is orange, as much as the hundredth part of the pixels that changed most has the full colour.
const shades = 512;   // of each of the two
function changeColour(share) {
  const full = share < 0 ? [0, 158, 115] : [213, 94, 0], at = Math.min(1, Math.abs(share));
  return full.map(c => Math.round(255 + (c - 255) * at));
}
const changes = new Uint8Array(4 * (2 * shades + 1));
for (let i = -shades; i <= shades; ++i) changes.set([...changeColour(i / shades), 255], 4 * (i + shades));

const maps = [];
// What has the full colour; it is looked for when the map is drawn for the first time.
function endOf(map) {
  if (map.end) return map.end;
  const sizes = map.change.map(Math.abs).sort();
  return map.end = Math.max(1, sizes[Math.floor(sizes.length * 0.99)]);
}
function drawChange() {
  const map = maps[byId("figure").value], end = endOf(map), canvas = byId("change");
  canvas.width = data.width;
  canvas.height = data.height;
  const context = canvas.getContext("2d"), pixels = context.createImageData(data.width, data.height);
  const colours = new Uint32Array(changes.buffer), to = new Uint32Array(pixels.data.buffer);
  for (let i = 0; i < to.length; ++i)
    to[i] = colours[shades + Math.round(Math.max(-1, Math.min(1, map.change[i] / end)) * shades)];
  context.putImageData(pixels, 0, 0);
  const stops = [-1, 0, 1].map(share => `rgb(${changeColour(share)})`).join(",");
  byId("scales").innerHTML = `<div class="scale"><span>${grouped(end)} more</span>${grouped(end)} less` +
    `<i style="background:linear-gradient(90deg,${stops})"></i></div>`;
}
async function showPixels() {
  if (data.maps.length === 0) return;
  for (const map of data.maps) {
    const [first, last] = await Promise.all([valuesOf(map.first), valuesOf(map.last)]);
    maps.push({ name: map.name, first, last, change: Int32Array.from(first).map((v, i) => last[i] - v) });
    byId("figure").add(new Option(map.name, maps.length - 1));
  }
  byId("figure").addEventListener("change", drawChange);
  byId("viewer").hidden = false;
  byId("change").addEventListener("pointermove", event => {
    const box = byId("change").getBoundingClientRect();
    const x = Math.min(data.width - 1, Math.floor((event.clientX - box.left) / box.width * data.width));
    const y = Math.min(data.height - 1, Math.floor((event.clientY - box.top) / box.height * data.height));
    byId("pixel").textContent = `Pixel ${x}, ${y}: ` + maps.map(map => {
      const i = y * data.width + x;
      return `${map.name} ${grouped(map.first[i])} to ${grouped(map.last[i])}`;
    }).join("; ");
  });
  drawChange();
}
showPage(() => show("effects", effectsSpec()), [showPixels]);
