/* A joint behind `halfway check` in C99 and nothing else, an isotropic spring: moment k times the rotation
   vector, force k d at node b. Reads what `halfway check` writes, not any JSON. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The n numbers after a key: the end of the last one, or NULL. */
static const char* numbers(const char* at, const char* key, int n, double* out) {
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

/* Does a joint point or frame differ from the node's? */
static int is_offset(const char* at, const char* key, int n, double first) {
  double v[4];
  while ((at = numbers(at, key, n, v)) != NULL)
    if (v[0] != first || v[1] != 0 || v[2] != 0 || (n == 4 && v[3] != 0)) return 1;
  return 0;
}

static const char* what_it_cannot_do(const char* line, double K[36]) {
  if (!strstr(line, "\"linear_angular\"") || !strstr(line, "\"linear\"") || !numbers(line, "\"K\":", 36, K))
    return "linear_angular joints with a linear law alone";
  for (int i = 0; i < 36; i++)
    if (K[i] != (i % 7 == 0 ? K[i < 18 ? 0 : 21] : 0))
      return "one stiffness for translation and one for rotation alone";
  if (is_offset(line, "\"o\":", 3, 0) || is_offset(line, "\"h\":", 4, 1))
    return "the joint is at the nodes, in their axes";
  return NULL;
}

static void loads(const char* line, const double K[36], double f[3], double m[3]) {
  const char *a = strstr(line, "\"a\":"), *b = strstr(line, "\"b\":");
  double x_a[3] = {0}, x_b[3] = {0}, p[4] = {1}, q[4] = {1};
  numbers(a, "\"x\":", 3, x_a), numbers(a, "\"q\":", 4, p);
  numbers(b, "\"x\":", 3, x_b), numbers(b, "\"q\":", 4, q);
  /* The rotation from a to b in global axes: q times the inverse of p. */
  const double c = q[0] * p[0] + q[1] * p[1] + q[2] * p[2] + q[3] * p[3];
  const double v[3] = {p[0] * q[1] - q[0] * p[1] - q[2] * p[3] + q[3] * p[2],
                       p[0] * q[2] - q[0] * p[2] - q[3] * p[1] + q[1] * p[3],
                       p[0] * q[3] - q[0] * p[3] - q[1] * p[2] + q[2] * p[1]};
  const double sine = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  const double turn = sine > 0 ? 2 * atan2(sine, fabs(c)) / copysign(sine, c) : 0;
  for (int i = 0; i < 3; i++) f[i] = K[0] * (x_b[i] - x_a[i]), m[i] = K[21] * turn * v[i];
}

int main(void) {
  static char line[1 << 20];
  while (fgets(line, sizeof line, stdin)) {
    const char* id = strstr(line, "\"id\":");
    if (!id) continue;
    id += 5;
    printf("{\"id\":%.*s,", (int)strcspn(id, ",}"), id);
    double K[36], f[3], m[3];
    const char* reason;
    if (strstr(line, "\"hello\":")) {
      printf(
          "\"name\":\"isotropic spring in "
          "C\",\"kinds\":[\"linear_angular\"],\"law\":\"isotropic\",\"frames\":false}\n");
    } else if ((reason = what_it_cannot_do(line, K)) != NULL) {
      printf("\"skipped\":\"%s\"}\n", reason);
    } else {
      loads(line, K, f, m);
      printf("\"loads\":[%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,", -f[0], -f[1], -f[2], -m[0], -m[1], -m[2]);
      printf("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g]}\n", f[0], f[1], f[2], m[0], m[1], m[2]);
    }
    fflush(stdout);
  }
  return 0;
}
