// Turns the columns of a page into typed arrays; the inverse of render/trace/column_pack.h.

const columnTypes = {u8: Uint8Array, u16: Uint16Array, u32: Uint32Array, f32: Float32Array, f64: Float64Array};

// Adds up differences whose bytes are stored in planes: the lowest bytes of all numbers first.
function unpackColumn(bytes, offset, Type, count) {
  const size = Type.BYTES_PER_ELEMENT, buffer = new ArrayBuffer(size * count);
  if (size === 8) {
    const out = new Uint8Array(buffer);
    for (let k = 0; k < 8; k++) {
      for (let i = 0, from = offset + k * count; i < count; i++) out[8 * i + k] = bytes[from + i];
    }
    return new Type(buffer);
  }
  const bits = new {1: Uint8Array, 2: Uint16Array, 4: Uint32Array}[size](buffer);
  let sum = 0;
  for (let i = 0; i < count; i++) {
    let difference = 0;
    for (let k = 0; k < size; k++) difference |= bytes[offset + k * count + i] << (8 * k);
    sum = (sum + difference) | 0;
    bits[i] = sum;
  }
  return new Type(buffer);
}

// Returns {name: typed array} for the directory [[name, type, count], ...].
function unpackColumns(bytes, directory) {
  const columns = {};
  let offset = 0;
  for (const [name, type, count] of directory) {
    const Type = columnTypes[type];
    if (!Type || !Number.isInteger(count) || count < 0 || offset + count * Type.BYTES_PER_ELEMENT > bytes.length) {
      throw new Error(`the column ${name} does not fit into the data`);
    }
    columns[name] = unpackColumn(bytes, offset, Type, count);
    offset += count * Type.BYTES_PER_ELEMENT;
  }
  return columns;
}
