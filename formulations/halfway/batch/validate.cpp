#include "halfway/batch/batch.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace halfway::batch {
namespace {

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("batch: " + what); }

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

template <class T>
void has_room(const char* name, const Columns<T>& c, int rows, long count) {
  const std::string field = name;
  if (c.first == nullptr) refuse(field + " is missing");
  if (rows > 1 && c.stride < count) {
    refuse(field + ": stride " + std::to_string(c.stride) + " is less than " + std::to_string(count) +
           " joints");
  }
  const long needed = (rows - 1) * c.stride + count;
  if (c.size < needed) {
    refuse(field + ": holds " + std::to_string(c.size) + " numbers, needs " + std::to_string(needed) + " (" +
           std::to_string(rows) + " rows of " + std::to_string(count) + ')');
  }
}

template <class T>
void finite(const char* name, const Columns<const T>& c, int rows, long count) {
  has_room(name, c, rows, count);
  for (int row = 0; row < rows; ++row) {
    for (long i = 0; i < count; ++i) {
      const T x = c.first[row * c.stride + i];
      if (!std::isfinite(x)) {
        refuse("joint " + std::to_string(i) + ": " + name + '[' + std::to_string(row) + "] is " +
               number(double(x)));
      }
    }
  }
}

template <class T>
void unit_length(const std::string& where, const T (&q)[4]) {
  if (const auto n = detail::wrong_length(q))
    refuse(where + " is a quaternion of length " + number(*n) + ", not 1");
}

template <class T>
void quaternions(const char* name, const Columns<const T>& c, long count) {
  finite(name, c, 4, count);
  for (long i = 0; i < count; ++i) {
    const T q[4] = {c.first[i], c.first[c.stride + i], c.first[2 * c.stride + i], c.first[3 * c.stride + i]};
    unit_length("joint " + std::to_string(i) + ": " + name, q);
  }
}

template <class T>
void end(const char* name, const BatchEnd<T>& e) {
  for (const T x : e.o) {
    if (!std::isfinite(x)) refuse(std::string(name) + ": an offset is " + number(double(x)));
  }
  for (const T x : e.H) {
    if (!std::isfinite(x)) refuse(std::string(name) + ": the joint frame has " + number(double(x)));
  }
  unit_length(std::string(name) + ": the joint frame", e.H);
}

template <class T>
void inputs(const Model& model, const Joints<T>& j, Output output) {
  if (j.count < 0) refuse("count is " + std::to_string(j.count));
  if (model.xi && !std::isfinite(*model.xi)) refuse("xi is " + number(*model.xi));
  quaternions("q_a", j.q_a, j.count), quaternions("q_b", j.q_b, j.count);
  if (model.kind != Kind::angular) finite("x_a", j.x_a, 3, j.count), finite("x_b", j.x_b, 3, j.count);
  if (output == Output::product) finite("direction", j.direction, direction_rows(model.kind), j.count);
}

}  // namespace

/// A kernel takes |q| = 1 for granted: what it is off appears in the loads. 2^12 eps leave an integrator
/// room.
template <class T>
std::optional<double> detail::wrong_length(const T (&q)[4]) {
  const double n = std::hypot(std::hypot(double(q[0]), double(q[1])), std::hypot(double(q[2]), double(q[3])));
  if (std::abs(n - 1) <= 4096 * double(std::numeric_limits<T>::epsilon())) return {};
  return n;
}

template <class T>
void validate_laws(const Model& model, const Joints<T>& j) {
  finite("law", j.law, law_rows(model.kind, model.law), j.law_per_joint ? j.count : 1);
  if ((j.a == nullptr) != (j.b == nullptr)) refuse("an end is given for one node alone");
  if (j.a != nullptr) end("end a", *j.a), end("end b", *j.b);
}

template <class T>
void validate(const Model& model, const Joints<T>& joints, const Results<T>& results, Output output) {
  if (output == Output::tangent_144 && model.kind == Kind::angular)
    refuse("an angular joint has no 144 entries");
  inputs(model, joints, output);
  validate_laws(model, joints);
  has_room("loads", results.loads, load_rows(model.kind), joints.count);
  if (output == Output::compressed) {
    const int kept = Batch::compressed_rows(model);
    if (kept == 0) refuse(model.formulation + " has no compressed tangent: its loads are not balanced");
    const long needed = compressed_size(kept, joints.count);
    return has_room("tangent", Columns<T>{results.tangent.first, needed, results.tangent.size}, 1, needed);
  }
  const int rows = tangent_rows(model.kind, output);
  if (rows > 0) has_room("tangent", results.tangent, rows, joints.count);
}

template void validate(const Model&, const Joints<double>&, const Results<double>&, Output);
template void validate(const Model&, const Joints<float>&, const Results<float>&, Output);
template void validate_laws(const Model&, const Joints<double>&);
template void validate_laws(const Model&, const Joints<float>&);
template std::optional<double> detail::wrong_length(const double (&)[4]);
template std::optional<double> detail::wrong_length(const float (&)[4]);

}  // namespace halfway::batch
