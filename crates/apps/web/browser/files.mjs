// The same map of heights as a small file of every format that is read.
import { gzipSync } from "node:zlib";

const SIDE = 64;
const PIXEL = 1e-6;

// Heights in whole nanometres, row by row.
export function nanometres(amplitude = 100) {
  const height = (x, y) => Math.round(amplitude * (Math.sin(0.7 * x) + Math.cos(0.9 * y) + Math.sin(0.5 * x - 0.8 * y)));
  return Array.from({ length: SIDE * SIDE }, (_, k) => height(k % SIDE, Math.floor(k / SIDE)));
}

const rows = (heights) => Array.from({ length: SIDE }, (_, y) => heights.slice(SIDE * y, SIDE * (y + 1)));
const doubles = (values) => Buffer.from(Float64Array.from(values).buffer);
const metres = (heights) => doubles(heights.map((height) => 1e-9 * height));
const u32 = (...values) => Buffer.from(Uint32Array.from(values).buffer);
const u16 = (...values) => Buffer.from(Uint16Array.from(values).buffer);

export const matrix = (heights) =>
  `# Width: ${SIDE} um\n# Height: ${SIDE} um\n# Value units: nm\n${rows(heights).map((row) => row.join("\t")).join("\n")}\n`;

const points = (heights) =>
  `x_um,y_um,z_nm\n${heights.map((height, k) => `${k % SIDE},${Math.floor(k / SIDE)},${height}`).join("\n")}\n`;

const profile = (heights) => `x_um\tz_nm\n${heights.slice(0, 4 * SIDE).map((height, k) => `${k}\t${height}`).join("\n")}\n`;

function npy(heights) {
  const head = `{'descr': '<f8', 'fortran_order': False, 'shape': (${SIDE}, ${SIDE}), }`.padEnd(117) + "\n";
  return Buffer.concat([Buffer.from("\x93NUMPY\x01\x00", "latin1"), u16(head.length), Buffer.from(head), metres(heights)]);
}

// As node's own has it from version 20.15 on.
function crc32(bytes) {
  let sum = ~0;
  for (const byte of bytes) {
    sum ^= byte;
    for (let k = 0; k < 8; k++) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum >>> 0;
}

// An archive whose entries are stored as they are.
function zip(entries) {
  const [locals, index] = [[], []];
  let at = 0;
  for (const [name, bytes] of entries) {
    const about = Buffer.concat([u16(20, 0, 0, 0, 33), u32(crc32(bytes), bytes.length, bytes.length), u16(name.length, 0)]);
    const local = Buffer.concat([Buffer.from("PK\x03\x04"), about, Buffer.from(name), bytes]);
    index.push(Buffer.concat([Buffer.from("PK\x01\x02"), u16(20), about, u16(0, 0, 0), u32(0, at), Buffer.from(name)]));
    locals.push(local);
    at += local.length;
  }
  const list = Buffer.concat(index);
  const end = Buffer.concat([Buffer.from("PK\x05\x06"), u16(0, 0, entries.length, entries.length), u32(list.length, at), u16(0)]);
  return Buffer.concat([...locals, list, end]);
}

function x3p(heights) {
  const axis = (name, kind, step) => `<${name}><AxisType>${kind}</AxisType><DataType>D</DataType>${step}</${name}>`;
  const step = `<Increment>${PIXEL}</Increment>`;
  const xml = `<?xml version="1.0" encoding="UTF-8"?><p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2"><Record1>
    <Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType>
    <Axes>${axis("CX", "I", step)}${axis("CY", "I", step)}${axis("CZ", "A", "")}</Axes></Record1>
    <Record3><MatrixDimension><SizeX>${SIDE}</SizeX><SizeY>${SIDE}</SizeY><SizeZ>1</SizeZ></MatrixDimension>
    <DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink></Record3></p:ISO5436_2>`;
  return zip([["main.xml", Buffer.from(xml)], ["bindata/data.bin", metres(heights)]]);
}

function sur(heights) {
  const head = Buffer.alloc(512);
  head.write("DIGITAL SURF", 0);
  for (const [at, value] of [[14, 1], [18, 2], [98, 32]]) head.writeUInt16LE(value, at);
  for (const at of [108, 112]) head.writeInt32LE(SIDE, at);
  for (const at of [120, 124, 128]) head.writeFloatLE(1, at);
  for (const [at, unit] of [[180, "um"], [196, "um"], [212, "nm"]]) head.write(unit.padEnd(16), at);
  return Buffer.concat([head, Buffer.from(Int32Array.from(heights).buffer)]);
}

function gwy(heights) {
  const text = (value) => Buffer.from(`${value}\0`);
  const item = (name, kind, value) => Buffer.concat([text(name), Buffer.from(kind), value]);
  const object = (name, ...items) => Buffer.concat([text(name), u32(Buffer.concat(items).length), ...items]);
  const unit = object("GwySIUnit", item("unitstr", "s", text("m")));
  const side = doubles([SIDE * PIXEL]);
  const field = object("GwyDataField", item("xres", "i", u32(SIDE)), item("yres", "i", u32(SIDE)),
    item("xreal", "d", side), item("yreal", "d", side), item("si_unit_xy", "o", unit), item("si_unit_z", "o", unit),
    item("data", "D", Buffer.concat([u32(heights.length), metres(heights)])));
  return Buffer.concat([Buffer.from("GWYP"), object("GwyContainer", item("/0/data", "o", field))]);
}

function sdf(heights) {
  const numbers = doubles([PIXEL, PIXEL, 1e-9, -1]);
  return Buffer.concat([Buffer.from("bISO-1.0".padEnd(8 + 34)), u16(SIDE, SIDE), numbers, Buffer.from([0, 7, 0]), doubles(heights)]);
}

const sdfText = (heights) => ["aISO-1.0", "ManufacID = us", `NumPoints = ${SIDE}`, `NumProfiles = ${SIDE}`, `Xscale = ${PIXEL}`, `Yscale = ${PIXEL}`,
  "Zscale = 1e-9", "Zresolution = -1", "Compression = 0", "DataType = 7", "CheckType = 0", "*",
  ...rows(heights).map((row) => row.join(" ")), "*", "Operator = us", "*", ""].join("\r\n");

// [name, bytes, keys of the scene that the file does not state]
export const filesOf = (heights) => [
  ["matrix.txt", matrix(heights)],
  ["matrix.txt.gz", gzipSync(matrix(heights))],
  ["points.xyz", points(heights)],
  ["array.npy", npy(heights), 'unit = "m"\npixel_size = 1e-6'],
  ["scan.x3p", x3p(heights)],
  ["scan.sur", sur(heights)],
  ["scan.gwy", gwy(heights)],
  ["binary.sdf", sdf(heights)],
  ["text.sdf", sdfText(heights)],
  ["profile.txt", profile(heights)],
];
