// One look per formulation, the same in every chart. Families share a hue (Okabe-Ito order, safe for colour
// blindness); inside a family shape, dash and the direct label tell them apart. Colours are CSS variables,
// so that light, dark and print need no second drawing.
const FAMILIES = {
  attached: ['attached_a', 'attached_b'],
  halfway: ['invariant', 'intrinsic'],
  jointc: ['jointc'],
  field: ['field_a', 'field_b'],
  potential: ['conformal', 'potential', 'helicoidal', 'quaternion', 'cayley'],
  peer: ['simbody_xyz', 'drake_rpy', 'chrono_body', 'exudyn_intrinsic', 'mbdyn_joint_inv'],
  linear: ['linearized']
};
const DASHES = [[], [7, 3], [2, 3], [9, 3, 2, 3], [4, 2]];
const SHAPES = ['circle', 'square', 'triangle-up', 'diamond', 'cross', 'triangle-down'];

// Systems that fall on top of another in the paper's figures are drawn with gaps, so that both are seen.
const GAPS = {jointc: [3, 4], linearized: [2, 6], field_a: [9, 3, 2, 3], field_b: [4, 3, 1, 3]};

const looks = new Map();
for (const [family, names] of Object.entries(FAMILIES)) {
  names.forEach((name, i) =>
    looks.set(name, {color: `var(--f-${family}-${i + 1})`, dash: GAPS[name] ?? DASHES[i], shape: SHAPES[i]})
  );
}

/** A formulation that is not listed above still gets a stable look. */
export function look(name) {
  if (!looks.has(name)) {
    const i = looks.size;
    looks.set(name, {color: `var(--f-other-${1 + (i % 3)})`, dash: DASHES[i % 5], shape: SHAPES[i % 6]});
  }
  return looks.get(name);
}

/** The n-th series of one formulation (several xi): same colour, another dash. */
export const seriesLook = (name, n) =>
  n === 0 ? look(name) : {...look(name), dash: DASHES[(n + 1) % DASHES.length]};

export const KIND_SHAPES = {angular: 'circle', linear: 'square', linear_angular: 'triangle-up'};
