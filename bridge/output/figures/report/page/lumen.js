// The section of the lumen: what is chosen, and the views that show it.
"use strict";

// A bar of colours with its ends.
function colourScale(parent, quantity) {
  parent.replaceChildren();
  if (!quantity) return;
  parent.className = "scale";
  const bar = document.createElement("canvas"), ends = document.createElement("div");
  bar.width = 256;
  bar.height = 1;
  const context = bar.getContext("2d"), image = context.createImageData(256, 1);
  for (let k = 0; k < 256; ++k) image.data.set([...colourOf(quantity.map, k / 255), 255], 4 * k);
  context.putImageData(image, 0, 0);
  const texts = [
    `${shownNumber(quantity.low)} ${quantity.unit}`,
    quantity.name + (quantity.line ? `; at less than ${shownNumber(quantity.line)} ${quantity.unit} covered cells may grow` : ""),
    `${shownNumber(quantity.high)} ${quantity.unit}${quantity.open ? " and more" : ""}`,
  ];
  for (const text of texts) {
    const span = document.createElement("span");
    span.textContent = text;
    ends.append(span);
  }
  parent.append(bar, ends);
}

class LumenSection {
  constructor(lumen) {
    this.lumen = lumen;
    this.state = {
      frame: lumen.frames - 1, quantity: lumen.quantities[0] ?? null, cut: lumen.kind === "grid", steel: true,
      reading: (vertex, quantity = this.state.quantity) => this.reading(vertex, quantity),
    };
    this.views = [];
    const maps = document.getElementById("maps");
    for (const quantity of maps ? lumen.quantities : []) this.views.push(new FlatMap(maps, lumen, this.state, quantity));
    this.startSpace();
    this.controls();
    this.show();
  }

  // Without WebGL the maps are shown alone.
  startSpace() {
    const hint = document.getElementById("spaceHint");
    try {
      this.views.push(new Space(document.getElementById("spaceCanvas"), hint, this.lumen, this.state));
    } catch (error) {
      hint.textContent = "This browser shows nothing in space (no WebGL).";
    }
  }

  reading(vertex, quantity) {
    const where = this.lumen.where(vertex), value = quantity ? quantity.at(this.state.frame, vertex) : NaN;
    const text = Number.isFinite(value) ? `${quantity.name} ${shownNumber(value)} ${quantity.unit}` : "not known yet";
    return [this.lumen.strut(this.state.frame, vertex) ? "strut" : "", text, where].filter((part) => part).join(", ");
  }

  controls() {
    const { lumen, state } = this, byId = (id) => document.getElementById(id);
    const slider = byId("slider");
    slider.max = lumen.frames - 1;
    slider.value = state.frame;
    slider.addEventListener("input", () => { state.frame = Number(slider.value); this.show(); });
    slider.closest("label").hidden = lumen.frames < 2;
    lumen.quantities.forEach((quantity, k) => {
      const label = document.createElement("label"), button = document.createElement("input");
      Object.assign(button, { type: "radio", name: "quantity", value: quantity.key, checked: k === 0 });
      button.addEventListener("change", () => { state.quantity = quantity; this.show(); });
      label.append(button, ` ${quantity.name}`);
      byId("quantities").append(label);
    });
    byId("quantities").hidden = lumen.quantities.length < 2;
    for (const name of ["cut", "steel"]) {
      byId(name).checked = state[name];
      byId(name).addEventListener("change", (event) => { state[name] = event.target.checked; this.show(); });
    }
    byId("cut").closest("label").hidden = lumen.kind !== "grid";
    byId("steelSwitch").hidden = !lumen.hasStruts;
    byId("size").textContent = `It is ${shownNumber(lumen.length_mm)} mm long` + (lumen.width_mm ? ` and up to ${shownNumber(lumen.width_mm)} mm wide.` : ".");
  }

  show() {
    document.getElementById("day").textContent = shownNumber(this.lumen.days[this.state.frame]);
    colourScale(document.getElementById("scale"), this.state.quantity);
    for (const view of this.views) view.show();
  }
}
