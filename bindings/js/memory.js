// SPDX-License-Identifier: MIT
// The memory of a WebAssembly instance, and the structs of flinch.h in it as plain objects.

const kScratchBytes = 65536; // the largest call has 256 threats of 80 bytes

/** An error that Flinch reports: its text, and its number in `status` (see flinch.h). */
export class FlinchError extends Error {
  constructor(message, status) {
    super(message);
    this.name = "FlinchError";
    this.status = status;
  }
}

const kElements = {
  f32: { bytes: 4, Array: Float32Array, get: "getFloat32", set: "setFloat32" },
  i32: { bytes: 4, Array: Int32Array, get: "getInt32", set: "setInt32" },
  u32: { bytes: 4, Array: Uint32Array, get: "getUint32", set: "setUint32" },
  pointer: { bytes: 4, Array: Uint32Array, get: "getUint32", set: "setUint32" },
};

/** Reads, writes and calls. Arguments and results of a call live in scratch memory until the next. */
export class Memory {
  constructor(instance) {
    this.call = instance.exports;
    this.scratch = this.call.malloc(kScratchBytes);
    this.used = 0;
    this.structs = JSON.parse(this.text(this.call.flinch_layout()));
  }

  /** Calls may grow the memory, which replaces its buffer. */
  get view() {
    if (this.lastView?.buffer !== this.call.memory.buffer)
      this.lastView = new DataView(this.call.memory.buffer);
    return this.lastView;
  }

  /** Starts a call: what the one before left in scratch memory is gone. */
  begin() {
    this.used = 0;
    return this;
  }

  reserve(bytes) {
    const address = this.scratch + this.used;
    this.used += (bytes + 7) & ~7;
    if (this.used > kScratchBytes) throw new RangeError("too many values for one call");
    return address;
  }

  /** Room for `count` structs, each with its size set where it has that field. */
  reserveStructs(name, count = 1) {
    const { size, fields } = this.structs[name];
    const address = this.reserve(size * count);
    new Uint8Array(this.call.memory.buffer, address, size * count).fill(0);
    for (let i = 0; i < count && fields.size; ++i)
      this.view.setUint32(address + i * size, size, true);
    return address;
  }

  /** Threats for a call; what they leave out of kind, stroke and rod is that of a ball of the first. */
  makeThreats(threats) {
    const thrown = {
      kind: 0, starts_in_s: 0, lasts_s: 0,
      axis: [0, 0, 0], angular_velocity: [0, 0, 0], to_butt_m: 0, to_tip_m: 0,
    };
    return this.makeStructs("flinch_threat", threats.map((threat) => ({ ...thrown, ...threat })));
  }

  /** Structs for a call, made of plain objects, which must have all fields. */
  makeStructs(name, values) {
    const { size, fields } = this.structs[name];
    const address = this.reserveStructs(name, values.length);
    values.forEach((value, i) => {
      for (const [key, field] of Object.entries(fields)) {
        if (key === "size" || key === "reserved") continue;
        const element = kElements[field.type];
        const parts = field.count > 1 ? value[key] : [value[key]];
        if (parts?.length !== field.count || parts[0] === undefined)
          throw new TypeError(`${name} needs ${field.count} number(s) in ${key}`);
        for (let k = 0; k < field.count; ++k) {
          const at = address + i * size + field.offset + k * element.bytes;
          this.view[element.set](at, Number(parts[k]), true);
        }
      }
    });
    return address;
  }

  /** A struct as a plain object: arrays are typed arrays, structs within are objects. */
  readStruct(name, address) {
    const value = {};
    for (const [key, field] of Object.entries(this.structs[name].fields))
      if (key !== "size" && key !== "reserved") value[key] = this.readField(field, address);
    return value;
  }

  readStructs(name, address, count) {
    const { size } = this.structs[name];
    return Array.from({ length: count }, (_, i) => this.readStruct(name, address + i * size));
  }

  readField({ type, offset, count }, address) {
    const element = kElements[type];
    if (!element) return this.readStructs(type, address + offset, count);
    if (count === 1) return this.view[element.get](address + offset, true);
    return new element.Array(this.call.memory.buffer, address + offset, count).slice();
  }

  readInt(address) {
    return this.view.getInt32(address, true);
  }

  /** A text of the library; null where there is none. */
  text(address) {
    if (address === 0) return null;
    const bytes = new Uint8Array(this.call.memory.buffer, address);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  /** Throws what a status reports; returns it where it is an answer and no error. */
  checked(status) {
    if (status >= 0) return status;
    throw new FlinchError(this.text(this.call.flinch_status_message(status)), status);
  }

  /** The handle that a call makes: `create` gets the address to write it to. */
  handle(create) {
    const out = this.begin().reserve(4);
    this.checked(create(out));
    return this.view.getUint32(out, true);
  }

  /** The struct that a call writes. */
  result(name, write) {
    const out = this.begin().reserveStructs(name);
    this.checked(write(out));
    return this.readStruct(name, out);
  }

  /** The names of an enumeration, in order. */
  names(name_of) {
    const names = [];
    for (let text; (text = this.text(this.call[name_of](names.length))) !== null; ) names.push(text);
    return names;
  }
}
