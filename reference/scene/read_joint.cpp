#include "reference/scene/read_joint.hpp"

#include "reference/scene/read_law.hpp"

#include <fmt/format.h>
#include <Eigen/LU>

#include <cmath>

namespace halfway::reference {
namespace {

/// How far a quaternion's length or R R^T may be from one: three digits of a person. Beyond is a mistake.
constexpr double kTolerance = 1e-3;

/// From here on a person is told: what is nearer is written with seven digits.
constexpr double kSilent = 1e-6;

constexpr const char* kAllowed = "a unit quaternion [w, x, y, z] or the 3 rows of a rotation matrix";

Mat3<double> from_quaternion(const Field& field) {
  const Eigen::Vector4d q = field.vector<4>(kAllowed);
  const double length = q.stableNorm();
  if (length == 0) {
    field.refuse("is the zero quaternion, which is no rotation", "[1, 0, 0, 0] for none",
                 "not_unit_quaternion");
  }
  const double off = std::abs(length - 1);
  if (!(off <= kTolerance)) {
    field.refuse(fmt::format("has length {:.9g}", length),
                 "a quaternion [w, x, y, z] of length 1 to 1e-3: divide each number by the length",
                 "not_unit_quaternion");
  }
  if (off > kSilent) field.note(fmt::format("has length {:.9g} and was divided by it", length));
  return so3::matrix<double>({q[0] / length, q.tail<3>() / length});
}

/// The nearest rotation: the orthogonal factor of the polar decomposition, by Newton.
Mat3<double> nearest_rotation(Mat3<double> R) {
  for (int i = 0; i < 4; ++i) R = (R + R.inverse().transpose()) / 2;  // from 1e-3: 1e-6, 1e-12, rounding
  return R;
}

Mat3<double> from_rows(const Field& field) {
  const Mat3<double> R = field.square_matrix(3, kAllowed);
  const double off = (R * R.transpose() - Mat3<double>::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= kTolerance)) {
    field.refuse(fmt::format("is not orthogonal (R R^T is off by {:.3g})", off),
                 "3 rows of a rotation matrix, orthogonal to 1e-3: give more digits, or a quaternion",
                 "not_a_rotation");
  }
  if (R.determinant() < 0)
    field.refuse("is a reflection (determinant -1)", "a rotation matrix", "not_a_rotation");
  if (off > kSilent)
    field.note(fmt::format("is orthogonal to {:.1g} only; the nearest rotation is used", off));
  return nearest_rotation(R);
}

/// The keys of one end, in both spellings.
struct EndKeys {
  std::string_view node, offset, frame;
};

/// joint.offset_a or joint.a.o: one of the two.
std::optional<Field> either(const Field& joint, std::string_view node, std::string_view word,
                            std::string_view letter) {
  const auto table = joint.find(node);
  auto by_word = joint.find(word);
  auto by_letter = table ? table->find(letter) : std::nullopt;
  if (by_word && by_letter)
    by_letter->refuse(fmt::format("stands beside {}", word), "one of the two", "named_twice");
  return by_word ? by_word : by_letter;
}

JointEnd<double> read_end(const Field& joint, const EndKeys& keys) {
  JointEnd<double> end;
  if (const auto o = either(joint, keys.node, keys.offset, "o"))
    end.o = o->vector<3>("3 numbers, m, axes of the node", dimension::length);
  if (const auto H = either(joint, keys.node, keys.frame, "h")) end.H = read_rotation(*H);
  return end;
}

Kind read_kind(const Field& kind) {
  const std::string name = kind.one_of({"angular", "linear", "linear_angular"}, "unknown_kind");
  return name == "angular" ? Kind::angular : name == "linear" ? Kind::linear : Kind::linear_angular;
}

}  // namespace

Mat3<double> read_rotation(const Field& field) {
  return field.holds_arrays() ? from_rows(field) : from_quaternion(field);
}

bool read_rod(const Field& joint, JointSpec& spec) {
  const auto length = joint.find("length"), axis = joint.find("axis");
  if (axis && !length) axis->refuse("stands without a length", "length, m, beside it", "length_missing");
  if (length) spec.length = length->positive(dimension::length);
  if (axis) {
    spec.axis = axis->integer(-3, 3);
    if (spec.axis == 0) axis->refuse("is no axis", "1, 2, 3 or -1, -2, -3");
  }
  return length.has_value();
}

JointSpec read_joint(const Field& joint) {
  JointSpec spec;
  spec.kind = read_kind(joint.at("kind", "angular, linear, linear_angular"));
  spec.law = read_law(joint.at("law", "a table with type = linear, polynomial or per_axis"), spec.kind);
  spec.a = read_end(joint, {"a", "offset_a", "frame_a"});
  spec.b = read_end(joint, {"b", "offset_b", "frame_b"});
  return spec;
}

}  // namespace halfway::reference
