// What report/lumens.py has packed: base64 of zlib's format.
"use strict";

async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Frames of whole numbers of 16 bits, from two planes of bytes, each frame less the one before.
function joinedPlanes(bytes, frames) {
  const count = bytes.length / 2, size = count / frames;
  const values = new Uint16Array(count);
  for (let i = 0; i < count; ++i) {
    values[i] = bytes[i] + 256 * bytes[count + i] + (i < size ? 0 : values[i - size]);
  }
  return Array.from({ length: frames }, (_, f) => values.subarray(f * size, (f + 1) * size));
}
