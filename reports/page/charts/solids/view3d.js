// Geometry of the 3D pictures: turning, the order of painting, the edges of a body's outline. No drawing here.

/** Coordinates 1, 2, 3 seen from a turntable about axis 1, which points up: right, up, toward the viewer.
 * @param {number[]} point
 * @param {{yaw: number, pitch: number}} view rad
 */
export function turn([x1, x2, x3], {yaw, pitch}) {
  const c = Math.cos(yaw),
    s = Math.sin(yaw),
    cp = Math.cos(pitch),
    sp = Math.sin(pitch);
  const across = x2 * c - x3 * s,
    away = x2 * s + x3 * c;
  return [across, x1 * cp + away * sp, x1 * sp - away * cp];
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const size = (a) => Math.sqrt(dot(a, a));

/** Unit normal of a quadrilateral from its diagonals. */
export function normal([a, b, c, d]) {
  const n = cross(minus(c, a), minus(d, b));
  const length = size(n) || 1;
  return n.map((x) => x / length);
}

/** Middle and half diagonal of the box round the points. */
export function ball(points) {
  const ends = [0, 1, 2].map((k) => [
    Math.min(...points.map((p) => p[k])),
    Math.max(...points.map((p) => p[k]))
  ]);
  return {centre: ends.map(([a, b]) => (a + b) / 2), radius: size(ends.map(([a, b]) => (b - a) / 2)) || 1};
}

/** Pairs of nodes where the surface ends or bends by more than `degrees`. */
export function outline(faces, X, degrees = 30) {
  const limit = Math.cos((degrees * Math.PI) / 180);
  const normals = faces.map((f) => normal(f.map((n) => X[n])));
  const edges = new Map();
  faces.forEach((face, f) =>
    face.forEach((a, i) => {
      const b = face[(i + 1) % 4];
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      edges.set(key, [...(edges.get(key) ?? []), f]);
    })
  );
  return [...edges]
    .filter(([, [f, g]]) => g === undefined || Math.abs(dot(normals[f], normals[g])) < limit)
    .map(([key]) => key.split(' ').map(Number));
}

/** The same faces, each counter-clockwise seen from outside; the surface is closed. */
export function outward(faces, X) {
  const volume = faces.reduce(
    (sum, f) => sum + dot(X[f[0]], cross(minus(X[f[2]], X[f[0]]), minus(X[f[3]], X[f[1]]))),
    0
  );
  return volume < 0 ? faces.map((f) => [...f].reverse()) : faces;
}

/** Indices of the faces that look at the viewer, farthest first (painter's algorithm), for points already turned. */
export function farthestFirst(faces, seen) {
  const near = faces.map((f) => f.reduce((sum, n) => sum + seen[n][2], 0));
  return faces
    .map((_, i) => i)
    .filter((i) => normal(faces[i].map((n) => seen[n]))[2] > 0)
    .sort((a, b) => near[a] - near[b]);
}

const kLight = [-0.3, 0.5, 0.81];

/** How much of the light a face misses, 0 to 1. */
export const shade = (corners) => 1 - Math.max(0, dot(normal(corners), kLight));
