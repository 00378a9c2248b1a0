// Pictures for the tests, made and read here so that nothing of the program's own code stands on both sides.
import {deflateSync, inflateSync} from "node:zlib";

// {width, height, channels, bits (8, 16 or 32), samples}: at(x, y) gives the samples of a pixel.
export function makePicture(width, height, channels, bits, at) {
  const samples = [];
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) samples.push(...at(x, y));
  }
  return {width, height, channels, bits, samples};
}

export function pixelOf({width, channels, samples}, x, y) {
  return samples.slice((y * width + x) * channels, (y * width + x + 1) * channels);
}

const crcTable = Uint32Array.from({length: 256}, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; k++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

function crc(bytes) {
  let c = 0xffffffff;
  for (const byte of bytes) c = crcTable[(c ^ byte) & 255] ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, "latin1"), data]);
  const length = Buffer.alloc(4), sum = Buffer.alloc(4);
  length.writeUInt32BE(data.length);
  sum.writeUInt32BE(crc(body));
  return Buffer.concat([length, body, sum]);
}

const signature = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);

export function encodePng({width, height, channels, bits, samples}) {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header[8] = bits;
  header[9] = [undefined, 0, 4, 2, 6][channels];
  const perRow = width * channels, bytes = bits / 8;
  const rows = Buffer.alloc(height * (1 + perRow * bytes));
  samples.forEach((value, i) => {
    const at = Math.floor(i / perRow) * (1 + perRow * bytes) + 1 + (i % perRow) * bytes;
    if (bits === 8) rows[at] = value;
    else rows.writeUInt16BE(value, at);
  });
  const chunks = [chunk("IHDR", header), chunk("IDAT", deflateSync(rows)), chunk("IEND", Buffer.alloc(0))];
  return Buffer.concat([signature, ...chunks]);
}

// PFM has its rows bottom-up.
export function encodePfm({width, height, channels, samples}) {
  const data = Buffer.alloc(samples.length * 4), perRow = width * channels;
  samples.forEach((value, i) => {
    const row = height - 1 - Math.floor(i / perRow);
    data.writeFloatLE(value, (row * perRow + (i % perRow)) * 4);
  });
  return Buffer.concat([Buffer.from(`${channels === 1 ? "Pf" : "PF"}\n${width} ${height}\n-1.0\n`), data]);
}

function paeth(a, b, c) {
  const p = a + b - c, pa = Math.abs(p - a), pb = Math.abs(p - b), pc = Math.abs(p - c);
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

// PNGs of 8 bits a channel, without interlacing: what the program writes. A palette's indices become their colours.
export function decodePng(file) {
  let header, palette, data = [];
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at)) {
    const type = file.toString("latin1", at + 4, at + 8), body = file.subarray(at + 8, at + 8 + file.readUInt32BE(at));
    if (type === "IHDR") header = body;
    if (type === "PLTE") palette = body;
    if (type === "IDAT") data.push(body);
  }
  const width = header.readUInt32BE(0), height = header.readUInt32BE(4), channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[header[9]];
  if (header[8] !== 8 || !channels || header[12]) throw new Error("not a PNG that these tests read");
  const rows = inflateSync(Buffer.concat(data)), stride = width * channels, samples = new Uint8Array(stride * height);
  for (let y = 0; y < height; y++) {
    const filter = rows[y * (stride + 1)];
    for (let i = 0; i < stride; i++) {
      const at = y * stride + i;
      const left = i >= channels ? samples[at - channels] : 0, above = y ? samples[at - stride] : 0;
      const corner = i >= channels && y ? samples[at - stride - channels] : 0;
      const predicted = [0, left, above, (left + above) >> 1, paeth(left, above, corner)][filter];
      samples[at] = rows[y * (stride + 1) + 1 + i] + predicted;
    }
  }
  if (!palette) return {width, height, channels, bits: 8, samples: Array.from(samples)};
  const colours = Array.from(samples).flatMap((index) => [...palette.subarray(3 * index, 3 * index + 3)]);
  return {width, height, channels: 3, bits: 8, samples: colours};
}
