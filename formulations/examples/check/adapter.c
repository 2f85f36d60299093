/* A joint behind `halfway check`, an isotropic spring: moment k times the rotation vector, force k d at node b. */
#include "protocol.h"

static const char* spring(const struct question* r, double loads[12]) {
  const char* reason = beyond_isotropic(r);
  if (reason) return reason;
  double turn[3];
  rotation_vector(r->a.q, r->b.q, turn);
  for (int i = 0; i < 3; i++) {
    loads[6 + i] = r->K[0] * (r->b.x[i] - r->a.x[i]), loads[i] = -loads[6 + i];
    loads[9 + i] = r->K[21] * turn[i], loads[3 + i] = -loads[9 + i];
  }
  return NULL;
}

int main(void) {
  return serve(
      "\"name\":\"isotropic spring in C\",\"kinds\":[\"linear_angular\"],\"law\":\"isotropic\",\"ends\":false",
      spring);
}
