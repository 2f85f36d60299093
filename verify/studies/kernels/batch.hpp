// Joints with their 50-digit loads, and the same joints as tables of a batch.
#pragma once

#include "halfway/batch/table.hpp"
#include "reference/face/kernel_entry.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

namespace halfway::verify {

/// One joint of a batch, its law the spec's own, its ends those of the whole batch.
struct BatchJoint {
  JointSpec spec;
  reference::QuaternionPose<double> a, b;
  double phi = 0;
  NodeLoads<Real50> exact{};
  double steepness = 0;  ///< of its measure, see poles.hpp
  double scale = 0;      ///< |K| |strain|, what an error of the loads is relative to
};

/// 40 joints with their loads: phi from 0 and 1e-3 to pi - 1e-12, quaternions of both signs, a law each.
/// @param single  poses rounded to float, and none nearer to pi than float can tell
/// @param ends  third turns and offsets of order one on both nodes; else none
std::vector<BatchJoint> batch_joints(const Entry& entry, Kind kind, batch::LawForm law, bool ends,
                                     bool single);

/// Its loads and tangent at 50 digits, and what their errors are relative to.
void solve(const Entry& entry, BatchJoint& joint);

/// The same joints with laws that do not couple translation and rotation, which a batch may have a loop for.
std::vector<BatchJoint> uncoupled(const Entry& entry, std::vector<BatchJoint> joints);

/// The tables of some joints, and of their results.
template <class T>
struct BatchTables {
  batch::Model model;
  batch::Table<T> q_a, q_b, x_a, x_b, law, direction, loads, tangent;
  batch::BatchEnd<T> end_a, end_b;
  bool ends;
  long count;

  BatchTables(const Entry& entry, const std::vector<BatchJoint>& joints, batch::LawForm law, bool ends,
              int rows);
  batch::Joints<T> joints() const;
  batch::Results<T> results() { return {loads.columns(), tangent.columns()}; }
  /// Loads and, if `output` has them, all 144 entries of joint i.
  NodeLoads<T> at(long i, batch::Output output) const;
};

using batch::kIsas;

/// batch/NAME: a count of what is wrong, of which there may be none.
Finding counted(const std::string& name, double wrong, const std::string& reason);

/// 1 if nothing is thrown, or a message that lacks one of the words.
template <class Call>
int silent(const Call& call, std::initializer_list<const char*> words) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    const std::string message = tapped(std::string(error.what()));
    return std::ranges::any_of(words, [&](const char* word) { return message.find(word) == message.npos; });
  }
  return 1;
}

const Entry& invariant();

/// Many joints of `invariant`, in the poses of batch_joints over and over; not solved at 50 digits.
std::vector<BatchJoint> repeated(Kind kind, int count);
BatchTables<double> tables_of(const std::vector<BatchJoint>& joints, batch::Output output);

}  // namespace halfway::verify
