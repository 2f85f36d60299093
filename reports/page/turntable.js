// A picture in three dimensions that a person turns: by dragging, or by keys.

/** @typedef {{yaw: number, pitch: number, zoom: number}} View  angles in rad */

/** @type {View} */
export const START = {yaw: 0.6, pitch: 0.4, zoom: 1};
const kStep = 0.1; // rad for one press of an arrow key
const kPerPixel = 0.009; // rad for one pixel of a drag
const kSteepest = 1.45; // rad: short of looking straight along the upright axis

const limited = (x, low, high) => Math.min(Math.max(x, low), high);

const KEYS = {
  ArrowLeft: (v) => {
    v.yaw -= kStep;
  },
  ArrowRight: (v) => {
    v.yaw += kStep;
  },
  ArrowUp: (v) => {
    v.pitch += kStep;
  },
  ArrowDown: (v) => {
    v.pitch -= kStep;
  },
  '+': (v) => {
    v.zoom *= 1.1;
  },
  '-': (v) => {
    v.zoom /= 1.1;
  },
  Home: (v) => Object.assign(v, START)
};

/** Drag and keys change the view, then paint it.
 * @param {HTMLElement} frame @param {View} view @param {() => void} repaint
 */
export function turnable(frame, view, repaint) {
  const moved = () => {
    view.pitch = limited(view.pitch, -kSteepest, kSteepest);
    view.zoom = limited(view.zoom, 0.5, 4);
    repaint();
  };
  /** @type {number[] | null} */
  let last = null;
  frame.addEventListener('pointerdown', (e) => {
    last = [e.clientX, e.clientY];
    frame.setPointerCapture(e.pointerId);
  });
  frame.addEventListener('pointermove', (e) => {
    if (!last) return;
    view.yaw += (e.clientX - last[0]) * kPerPixel;
    view.pitch += (e.clientY - last[1]) * kPerPixel;
    last = [e.clientX, e.clientY];
    moved();
  });
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'])
    frame.addEventListener(end, () => {
      last = null;
    });
  frame.addEventListener('keydown', (e) => {
    if (!KEYS[e.key] || e.ctrlKey || e.metaKey || e.altKey) return;
    e.preventDefault();
    KEYS[e.key](view);
    moved();
  });
}
