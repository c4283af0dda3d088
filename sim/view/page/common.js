// What all pages share: their data, Vega, and pixels as the program packs them.
"use strict";
const byId = id => document.getElementById(id);
const data = JSON.parse(byId("data").textContent);
const numbers = new Intl.NumberFormat("en-US");   // made once: thousands of figures are written
const grouped = n => numbers.format(Number(n));

function bytesOf(text) {
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes;
}
async function inflated(text) {
  const stream = new Blob([bytesOf(text)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
async function valuesOf(map) {
  const planes = await inflated(map.data), count = data.width * data.height;
  const values = new Uint32Array(count);
  for (let b = 0; b < map.bytes; ++b)
    for (let i = 0; i < count; ++i) values[i] |= planes[b * count + i] << 8 * b;
  return values;
}

// Inferno of matplotlib, in nine steps; between them it is linear.
const inferno = [[0, 0, 4], [31, 12, 72], [85, 15, 109], [136, 34, 106], [186, 54, 85], [227, 89, 51], [249, 140, 10],
  [249, 201, 50], [252, 255, 164]];
function heat(share) {
  const at = Math.min(1, Math.max(0, share)) * (inferno.length - 1), k = Math.min(inferno.length - 2, Math.floor(at));
  return inferno[k].map((c, i) => Math.round(c + (inferno[k + 1][i] - c) * (at - k)));
}
const heatSteps = 1024, heats = new Uint8Array(4 * (heatSteps + 1));
for (let i = 0; i <= heatSteps; ++i) heats.set([...heat(i / heatSteps), 255], 4 * i);
// Of every value, as a canvas has it.
function heatPixels(values, end, pixels) {
  const colours = new Uint32Array(heats.buffer), to = new Uint32Array(pixels.buffer);
  for (let i = 0; i < values.length; ++i) to[i] = colours[Math.min(heatSteps, Math.round(values[i] / end * heatSteps))];
}
// Vega's modules ask for each other by require(); this is what its own entry point makes of them. They run when
// the first chart is drawn, so that a page whose first screen has none is there before.
let charts = null;
const vega = () => charts = charts || (() => {
  const made = {};
  const require = name => {
    if (!made[name]) {
      const module = { exports: made[name] = {} };
      vegaModules[name](module.exports, module, require, undefined);
      made[name] = module.exports;
    }
    return made[name];
  };
  const all = {};
  for (const name of Object.keys(vegaModules)) Object.assign(all, require(name));
  for (const name of Object.keys(vegaModules))
    if (/transforms$|encode$|hierarchy$/.test(name)) Object.assign(require("vega-dataflow").transforms, require(name));
  return all;
})();

const fonts = { font: "system-ui, DejaVu Sans, sans-serif" };
const chartConfig = {
  text: fonts,
  axis: { labelFont: fonts.font, titleFont: fonts.font, labelColor: "#3b4653", titleColor: "#3b4653", grid: false,
    domainColor: "#98a3b0", tickColor: "#98a3b0", titleFontWeight: "normal" },
  legend: { labelFont: fonts.font, titleFont: fonts.font, titleFontWeight: "normal" }
};

// Pixels that a chart may be wide, and whether that is a telephone's screen.
const room = () => document.querySelector("main").clientWidth - 8;
const within = width => Math.min(width, room());
const isNarrow = () => room() < 700;
const legendSide = () => isNarrow() ? "top" : "right";

// The title stands above the chart as text of the page, where it may take several lines. `fills`: the width is that
// of the whole chart, with axes and legends.
async function show(id, { title, fills, ...spec }) {
  const { View, Warn, parse } = vega(), place = byId("chart-" + id), chart = document.createElement("div");
  const heading = document.createElement("p");
  heading.className = "title";
  heading.textContent = title || "";
  place.replaceChildren(...(title ? [heading, chart] : [chart]));
  const autosize = { type: fills ? "fit-x" : "pad", contains: "padding" };
  const view = new View(parse({ autosize, padding: 6, config: chartConfig, ...spec }),
    { renderer: "svg", container: chart, logLevel: Warn, hover: true });
  await view.runAsync();
  return view;
}

// Draws the first screen, and then what lies below it, piece by piece, so that the page can be used meanwhile.
// What goes wrong is said where the charts would be.
const afterPaint = () => new Promise(done => setTimeout(done, 0));
async function showInTurn(first, below) {
  await first();
  performance.mark("opened");
  for (const piece of below) {
    await afterPaint();
    await piece();
  }
  performance.mark("shown");
  document.body.dataset.shown = "yes";
}
function showPage(first, below = []) {
  showInTurn(first, below).catch(error => {
    document.body.dataset.shown = "no";
    const note = document.createElement("p");
    note.className = "note";
    note.textContent = `The charts cannot be drawn by this browser (${error.message}); what else there is stands below.`;
    document.querySelector("main").prepend(note);
    console.error(error);
  });
}
