// The 3D truth (results.solids): look-ups, names and looks that its tables and charts share.
import {isNumber, short, superscript} from '../format.js';
import {HUE} from '../palette.js';

// Okabe-Ito hues by CSS variable; dash and shape tell them apart without colour.

export const LAWS = {
  st_venant: {label: 'St. Venant–Kirchhoff', color: 'var(--ink)', dash: [2, 3], shape: 'square'},
  neo_hooke: {label: 'neo-Hooke', color: HUE.green, dash: [7, 3], shape: 'triangle-up'},
  hencky: {label: 'Hencky', color: HUE.vermilion, dash: [9, 3, 2, 3], shape: 'diamond'},
  cauchy_log: {label: 'Cauchy = D : ln V', color: HUE.blue, dash: [1, 0], shape: 'circle'}
};

export const ELEMENTS = {
  hex20: {label: 'hex20, reduced integration', color: HUE.blue, shape: 'circle'},
  hex20_full: {label: 'hex20, full integration', color: HUE.green, shape: 'triangle-up'},
  hex27: {label: 'hex27', color: HUE.vermilion, shape: 'square'},
  calculix: {label: 'CalculiX, C3D20R', color: HUE.magenta, shape: 'diamond'}
};

const OTHER = {color: 'var(--ink)', dash: [4, 2], shape: 'cross'};
export const lawLook = (key) => LAWS[key] ?? {label: key, ...OTHER};
export const elementLook = (key) => ELEMENTS[key] ?? {label: key, ...OTHER};

/** What a study's name says: "frustum_top" -> "frustum, top clamped". */
export const bodyLabel = (name) => name.replace(/_(top|base)$/, ', $1 clamped').replaceAll('_', ' ');

export const GROUPS = [
  {key: 'moments', label: 'two moments'},
  {key: 'forces', label: 'two forces'},
  {key: 'all', label: 'all loads'}
];

/** Every list is there, possibly empty.
 * @param {import('../data.js').Results} results
 */
export function solidsOf(results) {
  const s = results.solids ?? {};
  return {
    given: Boolean(results.solids),
    bodies: s.bodies ?? [],
    bearing: s.bearing ?? null,
    calculix: s.calculix ?? [],
    newton: s.newton ?? [],
    shapes: s.shapes ?? [],
    missing: s.missing ?? []
  };
}

const HOLES = {none: 'no hole', cone: 'conical hole', cylinder: 'cylindrical hole'};
const CUTS = {plane: 'plane cut', cone: 'conical cut'};
/** What a family of bearings is, by its record. */
export const familyLabel = (family) =>
  family ? `${CUTS[family.cut] ?? family.cut}, ${HOLES[family.hole] ?? family.hole}` : 'unnamed family';
export const familyNamed = (bearing, name) => bearing.families.find((f) => f.name === name);

/** xi under the paper's pair of moments, 1 and 3: {value, uncertainty}. */
export const paperXi = (body, law) =>
  body.xis?.find((x) => x.law === law)?.moments?.find((m) => m.name === '13');

/** Sign as a minus, digits kept. */
const fixed = (x, decimals) => x.toFixed(decimals).replace('-', '−');

/** A number with its error bar, both to the bar's second digit: 0.55381 ± 0.00066, or (2.9375 ± 0.0038)·10⁻². */
export function withBar(value, uncertainty, scientific = false) {
  if (!isNumber(value)) return '–';
  if (!(uncertainty > 0)) return short(value, 6);
  const size = Math.floor(Math.log10(Math.abs(value) || uncertainty)),
    last = Math.floor(Math.log10(uncertainty)) - 1;
  if (last < size - 9) return `${short(value, 9)} ± ${short(uncertainty)}`; // nothing but rounding
  if (!scientific && size >= -2 && size < 4)
    return `${fixed(value, Math.max(0, -last))} ± ${fixed(uncertainty, Math.max(0, -last))}`;
  const decimals = Math.max(0, size - last);
  return `(${fixed(value / 10 ** size, decimals)} ± ${fixed(uncertainty / 10 ** size, decimals)})·10${superscript(size)}`;
}

/** As the paper prints: all digits, the last zeros too. */
export function printedDigits(x, digits = 6) {
  if (!isNumber(x)) return '–';
  const [mantissa, exponent] = x.toExponential(digits - 1).split('e');
  return `${mantissa.replace('-', '−')}·10${superscript(Number(exponent))}`;
}
