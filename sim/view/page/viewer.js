// The picture, the reference, the difference and the heat maps under one slider; the figures of a pixel.
const report = JSON.parse(byId("report").textContent);

// The hundredth part of the pixels that costs most has the colour of the scale's end.
function scaleEnd(values) {
  const sorted = Uint32Array.from(values).sort();
  return Math.max(1, sorted[Math.floor(sorted.length * 0.99)]);
}

const layers = [];   // {name, draw(context), scale or null}
function addPicture(id, name) {
  const image = byId(id);
  if (image) layers.push({ name, draw: context => context.drawImage(image, 0, 0), legend: id === "difference" });
}
function addMap(map) {
  layers.push({
    name: map.name, map,
    draw(context) {
      this.end = this.end || scaleEnd(map.values);
      const pixels = context.createImageData(data.width, data.height);
      heatPixels(map.values, this.end, pixels.data);
      context.putImageData(pixels, 0, 0);
    }
  });
}

const causeColours = ["#e69f00", "#56b4e9", "#009e73", "#cc79a7", "#f0e442", "#ffffff"];
let causes = null, kept = false;

function showScales() {
  const parts = [];
  for (const side of ["left", "right"]) {
    const layer = layers[byId(side + "-layer").value];
    if (layer.map) {
      const stops = inferno.map(c => `rgb(${c})`).join(",");
      parts.push(`<div class="scale"><span>${grouped(layer.end)} and more, up to ${grouped(layer.map.max)}</span>` +
        `${layer.name}, from 0<i style="background:linear-gradient(90deg,${stops})"></i></div>`);
    } else if (layer.legend) {
      parts.push(`<div class="scale legend">` + data.causes.names.slice(0, -1).map((name, i) =>
        `<em style="--c:${causeColours[i]}">${name}</em>`).join("") + `</div>`);
    }
  }
  byId("scales").innerHTML = parts.join("");
}

function draw(side) {
  const canvas = byId(side + "-canvas");
  canvas.width = data.width;
  canvas.height = data.height;
  layers[byId(side + "-layer").value].draw(canvas.getContext("2d"));
  showScales();
}

function slide() {
  const share = byId("slider").value / 10;
  byId("left-canvas").style.clipPath = `inset(0 ${100 - share}% 0 0)`;
  byId("divider").style.left = `calc(${share}% - 1px)`;
}

function showPixel(x, y) {
  const at = y * data.width + x, rows = [["pixel", `${x}, ${y}`, ""]];
  const pixels = data.width * data.height;
  for (const map of data.maps) {
    const mean = map.key === "first" ? "" : `mean ${(map.sum / pixels).toFixed(1)}`;
    rows.push([map.name, grouped(map.values[at]), mean]);
  }
  byId("pixel").tBodies[0].replaceChildren(...rows.map(cells => {
    const row = document.createElement("tr");
    cells.forEach((text, i) => {
      const cell = row.insertCell();
      cell.textContent = text;
      if (i === 0) cell.className = "word";
    });
    return row;
  }));
  const code = causes ? causes[at] : 0, cause = causes ? data.causes.names[code & 15] : "";
  byId("why").textContent = !causes ? "" : cause === "none" ? "It does not differ from the reference." :
    `It differs from the reference: ${cause}${code & 16 ? "; it holds another primitive" : ""}.`;
  byId("explain").textContent = data.explain.replace("PIXEL", `${x},${y}`);
}

function pointed(event) {
  const box = byId("right-canvas").getBoundingClientRect();
  const x = Math.floor((event.clientX - box.left) / box.width * data.width);
  const y = Math.floor((event.clientY - box.top) / box.height * data.height);
  return [Math.min(data.width - 1, Math.max(0, x)), Math.min(data.height - 1, Math.max(0, y))];
}

// What explain says of a pixel, if it is one of those whose texts are in the page.
let explanations = {};
function explainPixel(x, y) {
  const text = explanations[y * data.width + x];
  byId("explanation").hidden = !text;
  byId("explanation").textContent = text || "";
}

async function showViewer() {
  if (data.explanations) explanations = JSON.parse(new TextDecoder().decode(await inflated(data.explanations)));
  await Promise.all(data.maps.map(async map => { map.values = await valuesOf(map); }));
  if (data.causes) causes = await inflated(data.causes.data);
  for (const image of document.querySelectorAll("#pictures img")) await image.decode();
  addPicture("picture", "picture");
  addPicture("reference", "reference");
  addPicture("difference", "difference by cause");
  for (const map of data.maps) addMap(map);
  for (const side of ["left", "right"]) {
    const select = byId(side + "-layer");
    layers.forEach((layer, i) => select.add(new Option(layer.name, i)));
    select.value = side === "left" ? 0 : layers.findIndex(layer => layer.map);
    select.addEventListener("change", () => draw(side));
  }
  byId("viewer").hidden = false;
  byId("pictures").hidden = true;
  draw("left");
  draw("right");
  byId("slider").addEventListener("input", slide);
  slide();
  const area = byId("canvases");
  area.addEventListener("pointermove", event => {
    if (event.buttons & 1) {
      const box = area.getBoundingClientRect();
      byId("slider").value = 1000 * (event.clientX - box.left) / box.width;
      slide();
    } else if (!kept) {
      showPixel(...pointed(event));
    }
  });
  area.addEventListener("click", event => {
    kept = !kept;
    showPixel(...pointed(event));
    explainPixel(...pointed(event));
  });
  for (const row of document.querySelectorAll("#pixels tbody tr"))
    row.addEventListener("click", () => {
      const [x, y] = row.cells[0].textContent.split(",").map(Number);
      kept = true;
      showPixel(x, y);
      explainPixel(x, y);
      byId("viewer").scrollIntoView();
    });
  showPixel(data.slowest[0] % data.width, Math.floor(data.slowest[0] / data.width));
}

// Figures as files.
const csv = rows => rows.map(row => row.join(",")).join("\n") + "\n";
const files = {
  "report.json": () => JSON.stringify(report, null, 2) + "\n",
  "pixels.csv": () => csv([["x", "y", ...data.maps.map(map => map.name.replaceAll(" ", "_")), "cause"],
    ...Array.from({ length: data.width * data.height }, (_, i) => [i % data.width, Math.floor(i / data.width),
      ...data.maps.map(map => map.values[i]), causes ? data.causes.names[causes[i] & 15] : ""])]),
  "units.csv": () => csv([["unit", "instances", "count", "kind", "cause", "cycles"],
    ...accountRows().map(r => [r.unit, clock().units[r.unit].instances, clock().units[r.unit].count, r.kind, r.cause, r.cycles])]),
  "windows.csv": () => csv([["first", "cycles", "rays_under_way", "reads", "row_hits", "gb_per_s"],
    ...data.windows.map(w => [w.first, w.cycles, w.rays_under_way, w.reads, w.row_hits, w.gb_per_s])]),
  "links.csv": () => csv([["link", "from", "to", "lanes", "moved", "refused"],
    ...data.links.map(l => [l.name, l.from, l.to, l.lanes, l.moved, l.refused])])
};
for (const button of document.querySelectorAll("[data-save]"))
  button.addEventListener("click", () => {
    const link = document.createElement("a"), name = button.dataset.save;
    link.href = URL.createObjectURL(new Blob([files[name]()]));
    link.download = name;
    link.click();
    URL.revokeObjectURL(link.href);
  });
byId("downloads").hidden = false;
