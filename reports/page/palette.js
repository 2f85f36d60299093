// All colours of the charts, and the look of each formulation, the same in every chart. Colours become CSS
// variables, so that light, dark and print need no second drawing. Families share a hue (Okabe-Ito order, safe
// for colour blindness); inside a family shape, dash and the direct label tell them apart.

/** @typedef {{color: string, dash: number[], shape: string}} Look */

/** Hue: on light, on dark paper. @type {Record<string, [string, string]>} */
const COLORS = {
  gold: ['#c87f00', '#f0ad2e'],
  vermilion: ['#c04a00', '#ff8a4a'],
  blue: ['#0068a8', '#4fb0ef'],
  sky: ['#2f9ac9', '#92d3f5'],
  green: ['#007d5c', '#2fc797'],
  olive: ['#7a7a00', '#c9c62e'],
  moss: ['#99931a', '#e6e27a'],
  magenta: ['#a83279', '#f08cc4'],
  violet: ['#7c3aa6', '#c795f0'],
  pink: ['#c75b9b', '#f5b3d8'],
  indigo: ['#5b4bb0', '#a79cf2'],
  mauve: ['#93508a', '#d9a2d1'],
  cyan: ['#00808f', '#5fd0de'],
  crimson: ['#b3123f', '#ff7d98'],
  rose: ['#d2506e', '#ffb0c0'],
  slate: ['#4f5b66', '#b9c4ce'],
  steel: ['#6b7680', '#93a0ac'],
  brown: ['#7d6a5a', '#d0bba9'],
  pine: ['#3d4a4a', '#a5b8b8'],
  silver: ['#8a8f94', '#d5d9dc'],
  black: ['#000000', '#ffffff'],
  'solid-near': ['#dfe8ee', '#5b6e7c'],
  'solid-far': ['#3f95c8', '#4fb0ef'],
  'solid-shade': ['#1b2f40', '#0a1016'],
  'solid-edge': ['rgb(20 35 50 / 0.45)', 'rgb(0 0 0 / 0.5)']
};

/** CSS colour of a hue. @type {Record<string, string>} */
export const HUE = Object.fromEntries(Object.keys(COLORS).map((name) => [name, `var(--hue-${name})`]));

/** The style sheet that gives the hues their colours. */
export const paletteStyle = () =>
  `:root{${Object.entries(COLORS)
    .map(([name, [light, dark]]) => `--hue-${name}:light-dark(${light},${dark})`)
    .join(';')}}`;

const DASHES = [[], [7, 3], [2, 3], [9, 3, 2, 3], [4, 2]];
const SHAPES = ['circle', 'square', 'triangle-up', 'diamond', 'cross', 'triangle-down'];

/** Families in the order of dash and shape: formulation -> hue. @type {Record<string, string>[]} */
const FAMILIES = [
  {attached_a: 'gold', attached_b: 'vermilion'},
  {invariant: 'blue', intrinsic: 'sky'},
  {jointc: 'green'},
  {field_a: 'olive', field_b: 'moss'},
  {conformal: 'magenta', potential: 'violet', helicoidal: 'pink', quaternion: 'indigo', cayley: 'mauve'},
  {fasse: 'cyan'},
  {rod4: 'crimson', rod34: 'rose'},
  {
    simbody_xyz: 'slate',
    drake_rpy: 'steel',
    chrono_body: 'brown',
    exudyn_intrinsic: 'pine',
    mbdyn_joint_inv: 'silver'
  },
  {linearized: 'black'}
];

/** Systems that fall on top of another in the paper's figures: with gaps, both are seen.
 * @type {Record<string, number[]>}
 */
const GAPS = {jointc: [3, 4], linearized: [2, 6], field_a: [9, 3, 2, 3], field_b: [4, 3, 1, 3]};

/** @type {Map<string, Look>} */
const looks = new Map(
  FAMILIES.flatMap((family) =>
    Object.entries(family).map(([name, hue], i) => [
      name,
      {color: HUE[hue], dash: GAPS[name] ?? DASHES[i], shape: SHAPES[i]}
    ])
  )
);

/** The same number for the same name in every report.
 * @param {string} name
 */
export const hashOf = (name) => [...name].reduce((sum, c) => (Math.imul(sum, 31) + c.charCodeAt(0)) >>> 0, 7);

/** A formulation that is not listed: hue, dash and shape by its name, dark enough on light paper and vice versa.
 * @param {string} name
 * @returns {Look}
 */
function automatic(name) {
  const hash = hashOf(name);
  const angle = hash % 360;
  return {
    color: `light-dark(oklch(0.5 0.13 ${angle}), oklch(0.8 0.11 ${angle}))`,
    dash: DASHES[hash % DASHES.length],
    shape: SHAPES[hash % SHAPES.length]
  };
}

/** @param {string} name of a formulation */
export const look = (name) => looks.get(name) ?? automatic(name);

/** The n-th series of one formulation (several xi): same colour, another dash.
 * @param {string} name
 * @param {number} n
 * @returns {Look}
 */
export const seriesLook = (name, n) =>
  n === 0 ? look(name) : {...look(name), dash: DASHES[(n + 1) % DASHES.length]};

/** @type {Record<string, string>} */
export const KIND_SHAPES = {angular: 'circle', linear: 'square', linear_angular: 'triangle-up'};
