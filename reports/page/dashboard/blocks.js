// Data blocks: base64 of deflated JSON, inflated when it is asked for.

/** What reading a block may end with: one sentence for the reader. */
export class Damaged extends Error {}

/** Blocks kept after they were read: each is up to a few hundred kB. */
const kKept = 120;

/** Both forms that zlib writes: with its header and checksum, or raw. The header of zlib's form is a multiple of 31;
 * no raw stream of zlib begins so, since it sets the rest of a stored block's first byte to zero.
 * @param {Uint8Array} bytes
 */
const formatOf = ([first, second]) =>
  first === 0x78 && (256 * first + second) % 31 === 0 ? 'deflate' : 'deflate-raw';

/** @param {string} base64 @returns {Promise<any>} */
export async function unpack(base64) {
  const text = atob(base64.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i); // Uint8Array.from takes ten times as long
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(formatOf(bytes)));
  return JSON.parse(await new Response(stream).text());
}

/** Reads blocks by id, keeps the last ones, and says by name what cannot be read. */
export class Blocks {
  /** @param {(id: string) => string | null | undefined} textOf a block */
  constructor(textOf) {
    this.textOf = textOf;
    /** @type {Map<string, Promise<any>>} */
    this.kept = new Map();
  }

  /** name: for the reader; fault: what is wrong with the data, or ''.
   * @param {string} id @param {string} name @param {(json: any) => string} fault
   */
  get(id, name, fault) {
    const known = this.kept.get(id) ?? this.read(id, name, fault);
    this.kept.delete(id);
    this.kept.set(id, known); // the last one asked for is the last one to go
    if (this.kept.size > kKept) this.kept.delete([...this.kept.keys()][0]);
    return known;
  }

  /** @param {string} id @param {string} name @param {(json: any) => string} fault */
  async read(id, name, fault) {
    const text = this.textOf(id);
    if (!text) throw new Damaged(`The data of ${name} are not in this file (no block “${id}”).`);
    const json = await unpack(text).catch(() => {
      throw new Damaged(
        `The data of ${name} are damaged (block “${id}”). Write the dashboard again: ./halfway dashboard.`
      );
    });
    const found = fault(json);
    if (found) throw new Damaged(`The data of ${name} do not fit (block “${id}”): ${found}.`);
    return json;
  }
}
