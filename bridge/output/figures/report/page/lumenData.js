// The lumen as numbers: what report/lumens.py has packed, in mm, Pa and um.
"use strict";

const stressLevels = 250, unknownLevel = 255;

// A quantity: name, unit, the map of its colours, its range, and its value at a vertex of a frame; NaN: not known.
async function stressOf(lumen, vertices) {
  if (!lumen.stress) return null;
  const levels = await unpacked(lumen.stress.data), top = lumen.stress.top_Pa;
  return {
    key: "stress", name: "wall shear stress", unit: "Pa", map: "stress", low: 0, high: top, open: lumen.stress.more,
    line: lumen.resting_Pa, lineName: "at rest above",
    at: (frame, vertex) => {
      const level = levels[frame * vertices + vertex];
      return level === unknownLevel ? NaN : (level / stressLevels) * top;
    },
  };
}

async function gridLumen(lumen) {
  const frames = lumen.days.length, vertices = lumen.around * lumen.along;
  const { low_mm: low, high_mm: high } = lumen.radius;
  const whole = joinedPlanes(await unpacked(lumen.radius.data), frames);
  const radius = (frame, vertex) => low + (whole[frame][vertex] / 65535) * (high - low);
  const bits = lumen.struts && (await unpacked(lumen.struts));
  const strut = (frame, vertex) => {
    const at = frame * vertices + vertex;
    return bits !== null && (bits[at >> 3] & (128 >> (at & 7))) !== 0;
  };
  const quantities = [await stressOf(lumen, vertices)];
  if (lumen.grows) {
    const lost = (frame, vertex) => 1e3 * (radius(0, vertex) - radius(frame, vertex));
    let most = 1;
    for (let v = 0; v < vertices; ++v) most = Math.max(most, lost(frames - 1, v));
    quantities.push({ key: "thickness", name: "new tissue", unit: "µm", map: "thickness", low: 0, high: most, open: false, line: null, at: lost });
  }
  const angle = (row) => -Math.PI + ((row + 0.5) * 2 * Math.PI) / lumen.around;
  const place = (column) => ((column + 0.5) * lumen.length_mm) / lumen.along;
  return {
    ...lumen, frames, vertices, radius, strut, angle, place, hasStruts: bits !== null,
    quantities: quantities.filter((quantity) => quantity),
    width_mm: 2 * high,
    reach: Math.hypot(lumen.length_mm, 2 * high) / 2,
    from: [0.28, 0.34, 1], // where it is looked at from
    // x along the vessel, z towards the eye: the vertex of row r (angle) and column c is r * along + c
    position: (frame, vertex) => {
      const r = radius(frame, vertex), theta = angle(Math.floor(vertex / lumen.along));
      return [place(vertex % lumen.along) - lumen.length_mm / 2, r * Math.sin(theta), r * Math.cos(theta)];
    },
    triangles: () => {
      const index = [];
      for (let row = 0; row < lumen.around; ++row) {
        for (let column = 0; column + 1 < lumen.along; ++column) {
          const a = row * lumen.along + column, b = ((row + 1) % lumen.around) * lumen.along + column;
          index.push(a, a + 1, b, b, a + 1, b + 1);
        }
      }
      return new Uint32Array(index);
    },
    where: (vertex) => `${shownNumber(place(vertex % lumen.along))} mm from the inlet, ${Math.round((angle(Math.floor(vertex / lumen.along)) * 180) / Math.PI)}°`,
    arrow: [[-lumen.length_mm / 2, -1.15 * high, 0], [lumen.length_mm / 2, -1.15 * high, 0]],
  };
}

async function surfaceLumen(lumen) {
  const whole = joinedPlanes(await unpacked(lumen.points), 3);
  const vertices = whole[0].length, bytes = await unpacked(lumen.triangles);
  const middle = lumen.low_mm.map((low, k) => (low + lumen.high_mm[k]) / 2);
  const extents = lumen.high_mm.map((high, k) => high - lumen.low_mm[k]);
  const shallow = extents.indexOf(Math.min(...extents));
  const coordinate = (k, vertex) => lumen.low_mm[k] + (whole[k][vertex] / 65535) * extents[k] - middle[k];
  return {
    ...lumen, frames: 1, vertices, hasStruts: false, strut: () => false,
    quantities: [await stressOf(lumen, vertices)].filter((quantity) => quantity),
    length_mm: Math.max(...extents),
    reach: Math.hypot(...extents) / 2,
    from: extents.map((_, k) => (k === shallow ? 1 : 0.25)), // along which it reaches least far
    width_mm: null,
    position: (_, vertex) => [0, 1, 2].map((k) => coordinate(k, vertex)),
    triangles: () => new Uint32Array(bytes.buffer),
    where: () => "",
    arrow: lumen.ends_mm && lumen.ends_mm.map((end) => end.map((x, k) => x - middle[k])),
  };
}

const lumenOf = (lumen) => (lumen.kind === "grid" ? gridLumen(lumen) : surfaceLumen(lumen));
