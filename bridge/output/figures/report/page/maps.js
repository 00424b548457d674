// The lumen laid flat: angle over place along the vessel, a map for each quantity.
"use strict";

class FlatMap {
  constructor(parent, lumen, state, quantity) {
    Object.assign(this, { lumen, state, quantity });
    this.root = document.createElement("div");
    this.root.className = "map";
    const title = document.createElement("h3");
    title.textContent = `${quantity.name} [${quantity.unit}]`;
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("aria-label", `${quantity.name}, laid flat`);
    this.hint = document.createElement("div");
    this.hint.className = "reading";
    this.root.append(title, this.hint, this.canvas);
    parent.append(this.root);
    this.pixels = document.createElement("canvas");
    this.pixels.width = lumen.along;
    this.pixels.height = lumen.around;
    this.canvas.addEventListener("pointermove", (event) => this.read(event));
    this.canvas.addEventListener("pointerdown", (event) => this.read(event));
    new ResizeObserver(() => this.show()).observe(parent);
  }

  // Row 0 of the canvas is the largest angle.
  paint() {
    const { lumen, quantity } = this, { frame } = this.state;
    const context = this.pixels.getContext("2d"), image = context.createImageData(lumen.along, lumen.around);
    for (let row = 0; row < lumen.around; ++row) {
      for (let column = 0; column < lumen.along; ++column) {
        const value = quantity.at(frame, row * lumen.along + column);
        const colour = colourOf(quantity.map, (value - quantity.low) / (quantity.high - quantity.low));
        image.data.set([...colour, 255], 4 * ((lumen.around - 1 - row) * lumen.along + column));
      }
    }
    context.putImageData(image, 0, 0);
  }

  show() {
    const width = this.canvas.clientWidth, height = 220, ratio = devicePixelRatio || 1;
    if (width === 0) return;
    this.canvas.style.height = `${height}px`;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.box = { left: 44, top: 6, right: width - 8, bottom: height - 34 };
    this.paint();
    const context = this.canvas.getContext("2d"), { left, top, right, bottom } = this.box;
    context.scale(ratio, ratio);
    context.drawImage(this.pixels, left, top, right - left, bottom - top);
    // Where struts stood in the lumen on day 0, and the line of the stress that decides
    if (this.lumen.hasStruts) this.border(context, (v) => this.lumen.strut(0, v), this.quantity.map === "stress" ? "#fff" : "#1d2328");
    if (this.quantity.line) this.border(context, (v) => this.quantity.at(this.state.frame, v) > this.quantity.line, "#D55E00");
    this.axes(context);
  }

  // The line between the places that `inside` holds for and the others.
  border(context, inside, colour) {
    const { lumen } = this, { left, top, right, bottom } = this.box;
    const dx = (right - left) / lumen.along, dy = (bottom - top) / lumen.around;
    context.strokeStyle = colour;
    context.lineWidth = 1;
    context.beginPath();
    for (let row = 0; row < lumen.around; ++row) {
      for (let column = 0; column < lumen.along; ++column) {
        const here = inside(row * lumen.along + column), x = left + column * dx, y = bottom - row * dy;
        if (column + 1 < lumen.along && inside(row * lumen.along + column + 1) !== here) { context.moveTo(x + dx, y); context.lineTo(x + dx, y - dy); }
        if (row + 1 < lumen.around && inside((row + 1) * lumen.along + column) !== here) { context.moveTo(x, y - dy); context.lineTo(x + dx, y - dy); }
      }
    }
    context.stroke();
  }

  axes(context) {
    const { left, top, right, bottom } = this.box, { length_mm: length } = this.lumen;
    context.fillStyle = "#59636b";
    context.font = "11px system-ui, sans-serif";
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (const angle of [-180, -90, 0, 90, 180]) context.fillText(`${angle}°`, left - 5, bottom - ((angle + 180) / 360) * (bottom - top));
    context.textAlign = "center";
    context.textBaseline = "top";
    const step = niceStep(length, 5);
    for (let k = 0; k * step <= length * (1 + 1e-9); ++k) context.fillText(shownNumber(k * step), left + ((k * step) / length) * (right - left), bottom + 5);
    context.fillText("mm along the vessel, from the inlet", (left + right) / 2, bottom + 20);
  }

  read(event) {
    const box = this.canvas.getBoundingClientRect(), { left, top, right, bottom } = this.box;
    const column = Math.floor(((event.clientX - box.left - left) / (right - left)) * this.lumen.along);
    const row = Math.floor(((bottom - event.clientY + box.top) / (bottom - top)) * this.lumen.around);
    const inside = column >= 0 && row >= 0 && column < this.lumen.along && row < this.lumen.around;
    this.hint.textContent = inside ? this.state.reading(row * this.lumen.along + column, this.quantity) : "";
  }
}
