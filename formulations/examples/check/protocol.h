/* What adapters of `halfway check` share, in C99 and nothing else: JSON lines in, one answer a line out. Reads what
   `halfway check` writes, not any JSON. An adapter brings a function from a question to its loads. */
#pragma once

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* SI units, radians; quaternions w, x, y, z. */
struct body {
  double x[3], q[4]; /* position, body axes -> global axes */
  double o[3], h[4]; /* joint point, joint axes -> body axes */
};
struct question {
  double K[36]; /* row by row, along the joint axes, translation first */
  struct body a, b;
};

/* NULL and 12 loads f_a, m_a, f_b, m_b, or why the program cannot. */
typedef const char* (*answerer)(const struct question*, double loads[12]);

/* The n numbers after a key: the end of the last one, or NULL. */
static inline const char* numbers(const char* at, const char* key, int n, double* out) {
  at = at ? strstr(at, key) : NULL;
  if (at) at += strlen(key);
  for (int i = 0; at && i < n; i++) {
    char* end;
    at += strcspn(at, "-0123456789");
    out[i] = strtod(at, &end);
    at = end > at ? end : NULL;
  }
  return at;
}

/* A body: what stands between its own key and the other's. */
static inline struct body read_body(const char* line, const char* key) {
  struct body out = {{0}, {1, 0, 0, 0}, {0}, {1, 0, 0, 0}};
  static char text[1 << 12];
  const char* at = strstr(line, key);
  if (!at) return out;
  snprintf(text, sizeof text, "%.*s", (int)strcspn(at, "}"), at);
  numbers(text, "\"x\":", 3, out.x), numbers(text, "\"q\":", 4, out.q);
  numbers(text, "\"o\":", 3, out.o), numbers(text, "\"h\":", 4, out.h);
  return out;
}

/* NULL, or why a question is beyond a joint at its bodies with one stiffness each. */
static inline const char* beyond_isotropic(const struct question* r) {
  for (int i = 0; i < 36; i++)
    if (r->K[i] != (i % 7 == 0 ? r->K[i < 18 ? 0 : 21] : 0))
      return "one stiffness for translation and one for rotation alone";
  const struct body* bodies[] = {&r->a, &r->b};
  for (int n = 0; n < 2; n++)
    for (int i = 0; i < 3; i++)
      if (bodies[n]->o[i] != 0 || bodies[n]->h[i + 1] != 0) return "the joint is at the nodes, in their axes";
  return NULL;
}

/* From the axes of quaternion p to those of q, global axes: of q times the inverse of p, on the shorter way. */
static inline void rotation_vector(const double p[4], const double q[4], double out[3]) {
  const double c = q[0] * p[0] + q[1] * p[1] + q[2] * p[2] + q[3] * p[3];
  const double v[3] = {p[0] * q[1] - q[0] * p[1] - q[2] * p[3] + q[3] * p[2],
                       p[0] * q[2] - q[0] * p[2] - q[3] * p[1] + q[1] * p[3],
                       p[0] * q[3] - q[0] * p[3] - q[1] * p[2] + q[2] * p[1]};
  const double sine = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  const double turn = sine > 0 ? 2 * atan2(sine, fabs(c)) / copysign(sine, c) : 0;
  for (int i = 0; i < 3; i++) out[i] = turn * v[i];
}

static inline void answer(const char* line, answerer joint) {
  struct question r = {{0}, read_body(line, "\"a\":{"), read_body(line, "\"b\":{")};
  double loads[12];
  const char* reason = "linear_angular joints with a linear law alone";
  if (strstr(line, "\"linear_angular\"") && strstr(line, "\"linear\"") && numbers(line, "\"K\":", 36, r.K))
    reason = joint(&r, loads);
  if (reason) {
    printf("\"skipped\":\"%s\"}\n", reason);
    return;
  }
  for (int i = 0; i < 12; i++) printf("%s%.17g", i ? "," : "\"loads\":[", loads[i]);
  printf("]}\n");
}

/* Answers until the input ends. hello: what the program says of itself (README.md), JSON without its braces. */
static inline int serve(const char* hello, answerer joint) {
  static char line[1 << 20];
  while (fgets(line, sizeof line, stdin)) {
    const char* id = strstr(line, "\"id\":");
    if (!id) continue;
    id += 5;
    printf("{\"id\":%.*s,", (int)strcspn(id, ",}"), id);
    if (strstr(line, "\"hello\":"))
      printf("%s}\n", hello);
    else
      answer(line, joint);
    fflush(stdout);
  }
  return 0;
}
