// Panels of curves that are read by pointing at them; all of them show the same day.
"use strict";

const curveColours = ["#0072B2", "#D55E00", "#009E73", "#AA4499", "#7A6A00", "#56B4E9", "#E69F00", "#5B646C"];

function svgElement(name, attributes, parent) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  parent?.append(made);
  return made;
}

function niceStep(range, count) {
  const raw = range / count, power = 10 ** Math.floor(Math.log10(raw));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= raw);
}

function shownNumber(value) {
  if (!Number.isFinite(value)) return "–";
  return Math.abs(value) >= 1000 ? Math.round(value).toLocaleString("en") : String(Number(value.toPrecision(3)));
}

// A value on a day: on the line between two records; nothing beyond them.
function valueOn(x, y, day) {
  const after = x.findIndex((value) => value >= day);
  if (after < 0 || (after === 0 && x[0] > day)) return NaN;
  if (x[after] === day || after === 0) return y[after] ?? NaN;
  if (y[after] === null || y[after - 1] === null) return NaN;
  return y[after - 1] + ((y[after] - y[after - 1]) * (day - x[after - 1])) / (x[after] - x[after - 1]);
}

class CurvePanel {
  constructor(panel, parent, day, onDay) {
    Object.assign(this, { panel, day });
    this.root = document.createElement("div");
    this.root.className = "panel";
    const title = document.createElement("h3");
    title.textContent = panel.title + (panel.unit ? ` [${panel.unit}]` : "");
    this.reading = document.createElement("div");
    this.reading.className = "reading";
    this.svg = svgElement("svg", { role: "img", tabindex: 0, "aria-label": panel.title });
    this.root.append(title, this.reading, this.svg);
    parent.append(this.root);
    const read = (event) => {
      const box = this.svg.getBoundingClientRect();
      onDay(this.dayAt(event.clientX - box.left));
    };
    this.svg.addEventListener("pointermove", read);
    this.svg.addEventListener("pointerdown", read);
    this.svg.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (way) onDay((this.day ?? this.last) + (way * (this.last - this.first)) / 50);
    });
    this.draw();
  }

  bounds() {
    const { lines, bands } = this.panel, known = (values) => values.filter((value) => value !== null);
    const x = [...lines, ...bands].flatMap((line) => line.x);
    const y = [...lines.flatMap((line) => known(line.y)), ...bands.flatMap((band) => [...known(band.low), ...known(band.high)])];
    const reach = (values, start) => values.reduce(([low, high], v) => [Math.min(low, v), Math.max(high, v)], start);
    [this.first, this.last] = reach(x, [Infinity, -Infinity]);
    [this.low, this.high] = reach(y, [0, 1e-12]);
    if (this.last <= this.first) this.last = this.first + 1;
    this.high += 0.05 * (this.high - this.low);
  }

  draw() {
    this.bounds();
    const width = Math.max(this.root.clientWidth, 240), height = 170;
    this.box = { left: 40, right: width - 10, top: 8, bottom: height - 34 };
    this.svg.replaceChildren();
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.svg.setAttribute("height", height);
    this.drawAxes();
    for (const band of this.panel.bands) this.drawBand(band);
    for (const line of this.panel.lines) this.drawLine(line);
    const { top, bottom } = this.box;
    this.cursor = svgElement("line", { class: "cursor", y1: top, y2: bottom, visibility: "hidden" }, this.svg);
    this.dots = this.panel.lines.map((line) =>
      svgElement("circle", { r: 3.5, fill: curveColours[line.group % curveColours.length], visibility: "hidden" }, this.svg));
    this.show(this.day ?? this.last);
  }

  x(day) { return this.box.left + ((day - this.first) / (this.last - this.first)) * (this.box.right - this.box.left); }
  y(value) { return this.box.bottom - ((value - this.low) / (this.high - this.low)) * (this.box.bottom - this.box.top); }
  dayAt(x) {
    const share = (x - this.box.left) / (this.box.right - this.box.left);
    return this.first + Math.min(Math.max(share, 0), 1) * (this.last - this.first);
  }

  drawAxes() {
    const { left, right, top, bottom } = this.box;
    const stepY = niceStep(this.high - this.low, 4), stepX = niceStep(this.last - this.first, 5);
    for (let k = Math.ceil(this.low / stepY); k * stepY <= this.high; ++k) {
      const y = this.y(k * stepY);
      svgElement("line", { class: "grid", x1: left, x2: right, y1: y, y2: y }, this.svg);
      svgElement("text", { x: left - 6, y: y + 4, "text-anchor": "end" }, this.svg).textContent = shownNumber(k * stepY);
    }
    svgElement("line", { class: "axis", x1: left, x2: right, y1: this.y(Math.max(0, this.low)), y2: this.y(Math.max(0, this.low)) }, this.svg);
    for (let k = Math.ceil(this.first / stepX); k * stepX <= this.last * (1 + 1e-9); ++k) {
      svgElement("text", { x: this.x(k * stepX), y: bottom + 15, "text-anchor": "middle" }, this.svg).textContent = shownNumber(k * stepX);
    }
    svgElement("text", { x: (left + right) / 2, y: bottom + 31, "text-anchor": "middle" }, this.svg).textContent = "day after deployment";
  }

  drawLine({ x, y, dashed, group }) {
    let path = "", open = false;
    x.forEach((day, k) => {
      if (y[k] === null) { open = false; return; }
      path += `${open ? "L" : "M"}${this.x(day).toFixed(1)} ${this.y(y[k]).toFixed(1)}`;
      open = true;
    });
    svgElement("path", { class: dashed ? "line dashed" : "line", d: path, stroke: curveColours[group % curveColours.length] }, this.svg);
  }

  drawBand({ x, low, high, group }) {
    const known = x.map((_, k) => k).filter((k) => low[k] !== null && high[k] !== null);
    const points = [...known.map((k) => [x[k], high[k]]), ...known.reverse().map((k) => [x[k], low[k]])];
    const text = points.map(([day, value]) => `${this.x(day).toFixed(1)},${this.y(value).toFixed(1)}`).join(" ");
    svgElement("polygon", { points: text, fill: curveColours[group % curveColours.length], opacity: 0.16 }, this.svg);
  }

  show(day) {
    this.day = Math.min(Math.max(day, this.first), this.last);
    for (const [key, value] of [["x1", this.x(this.day)], ["x2", this.x(this.day)], ["visibility", "visible"]]) this.cursor.setAttribute(key, value);
    this.reading.replaceChildren(`day ${shownNumber(this.day)}: `);
    const values = this.panel.lines.map((line) => valueOn(line.x, line.y, this.day));
    values.forEach((value, k) => {
      const { name, group } = this.panel.lines[k], known = Number.isFinite(value);
      this.dots[k].setAttribute("visibility", known ? "visible" : "hidden");
      if (known) {
        this.dots[k].setAttribute("cx", this.x(this.day));
        this.dots[k].setAttribute("cy", this.y(value));
      }
      const number = document.createElement("i");
      number.style.color = curveColours[group % curveColours.length];
      number.textContent = shownNumber(value);
      this.reading.append(k > 0 ? ", " : "", number, name ? ` ${name}` : "", this.bandText(group, k));
    });
  }

  // What is said of the band about a line.
  bandText(group, line) {
    const band = this.panel.bands.find((one) => one.group === group);
    if (!band || this.panel.lines.findIndex((one) => one.group === group) !== line) return "";
    const [low, high] = [valueOn(band.x, band.low, this.day), valueOn(band.x, band.high, this.day)];
    return Number.isFinite(low) && low < high ? ` (${shownNumber(low)} to ${shownNumber(high)}${band.name})` : "";
  }
}

// `day`: shown until another is pointed at; the last where there is none.
function drawCurves(panels, parent, day) {
  const drawn = [];
  const showDay = (day) => drawn.forEach((panel) => panel.show(day));
  for (const panel of panels) drawn.push(new CurvePanel(panel, parent, day, showDay));
  let width = parent.clientWidth;
  new ResizeObserver(() => {
    if (parent.clientWidth === width) return;
    width = parent.clientWidth;
    drawn.forEach((panel) => panel.draw());
  }).observe(parent);
}
