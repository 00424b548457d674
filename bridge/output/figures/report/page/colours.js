// Perceptually uniform maps, as those of the pictures: viridis for stress, magma from light to dark for thickness.
"use strict";

const colourMaps = {
  stress: "440154 48186a 472d7b 424086 3b528b 33638d 2c728e 26828e 21918c " +
    "1fa088 28ae80 3fbc73 5ec962 84d44b addc30 d8e219 fde725",
  thickness: "fcfdbf fde0a1 fec287 fea571 fb8761 f4695c e55064 cf4070 b5367a " +
    "9b2e7f 812581 681c81 4f127b 341069 1c1044 090720 000004",
};
const unknownColour = [200, 200, 200];
const steelColour = [91, 100, 108];

for (const name of Object.keys(colourMaps)) {
  colourMaps[name] = colourMaps[name].split(" ").map((hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16)));
}

// Red, green and blue, 0 to 255, of a share; of what is not known grey.
function colourOf(map, share) {
  if (!Number.isFinite(share)) return unknownColour;
  const stops = colourMaps[map], at = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const low = Math.min(Math.floor(at), stops.length - 2), rest = at - low;
  return stops[low].map((value, k) => value + rest * (stops[low + 1][k] - value));
}
