// Numbers for people.

/** @type {Record<string, string>} */
const SUPERSCRIPTS = {
  '-': '⁻',
  0: '⁰',
  1: '¹',
  2: '²',
  3: '³',
  4: '⁴',
  5: '⁵',
  6: '⁶',
  7: '⁷',
  8: '⁸',
  9: '⁹'
};

/** @param {number} n */
export const superscript = (n) => String(n).replace(/./g, (c) => SUPERSCRIPTS[c] ?? c);
/** @param {unknown} x @returns {x is number} */
export const isNumber = (x) => typeof x === 'number' && Number.isFinite(x);

/** Digits of a number that needs no power of ten.
 * @param {number} x
 * @param {number} digits
 */
function plain(x, digits) {
  const least = Math.abs(x) >= 100 ? 3 : digits;
  return String(Number(x.toPrecision(Math.max(digits, least)))).replace('-', '−');
}

/** 10⁻⁵ of 0.00001, '' of what is no power of ten.
 * @param {number} x
 */
export function powerOfTen(x) {
  const exponent = Math.log10(x);
  const whole = Math.round(exponent);
  return Math.abs(exponent - whole) < 1e-9 ? `10${superscript(whole)}` : '';
}

/** 1.2·10⁻⁵, or plain digits where these are shorter.
 * @param {unknown} x
 */
export function short(x, digits = 2) {
  if (!isNumber(x)) return '–';
  if (x === 0) return '0';
  const size = Math.abs(x);
  if (size >= 0.01 && size < 1e4) return plain(x, digits);
  const [mantissa, exponent] = x.toExponential(digits - 1).split('e');
  return `${mantissa.replace('-', '−')}·10${superscript(Number(exponent))}`;
}

/** All digits that a double holds, for tooltips and tables of record.
 * @param {unknown} x
 */
export const full = (x) => (isNumber(x) ? String(x) : '–');

/** A share in per cent.
 * @param {unknown} x
 */
export const percent = (x, digits = 2) => (isNumber(x) ? `${short(100 * x, digits)} %` : '–');

/** @param {unknown} x */
export const nanoseconds = (x) => (isNumber(x) ? (x < 10 ? x.toFixed(1) : x.toFixed(0)) : '–');

/** @param {unknown} x */
export function seconds(x) {
  if (!isNumber(x)) return '–';
  return x < 90 ? `${x.toFixed(1)} s` : `${(x / 60).toFixed(1)} min`;
}

/** @param {number} n @param {string} one */
export const plural = (n, one, many = `${one}s`) => `${n} ${n === 1 ? one : many}`;
