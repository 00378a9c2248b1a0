// Unpacks the data blocks of a page to bytes, and writes floats as text.

function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Undoes row differences: every row except the first is stored as its difference from the row
// above, byte by byte.
function undoRowDifferences(bytes, stride) {
  for (let i = stride; i < bytes.length; i++) bytes[i] += bytes[i - stride];
}

// The shortest decimal number that gives the same 32-bit float when it is read.
function floatText(value) {
  if (Number.isNaN(value)) return "NaN";
  if (!Number.isFinite(value)) return value > 0 ? "+∞" : "−∞";
  if (Object.is(value, -0)) return "−0";
  let digits = 1;
  while (Math.fround(Number(value.toPrecision(digits))) !== value) digits++;
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}
