// Joints of different formulations, kinds and laws in one table: sorted once, evaluated group by group.
//
// The tables are in the plan's order, in which the joints of a group are neighbours: nothing is
// gathered or scattered in the evaluation, and no joint decides anything. arrange() and restore()
// carry tables between the caller's order and the plan's.
#pragma once

#include "halfway/batch/batch.hpp"

#include <span>
#include <vector>

namespace halfway::batch {

/// What a joint is: models that are equal share a group.
struct Member {
  Model model;
  int ends = -1;  ///< index into Ends of the evaluation; -1: none
};

template <class T>
struct EndPair {
  BatchEnd<T> a, b;
};

class Plan {
 public:
  struct Group {
    Batch batch;
    int ends;
    long begin, count;
  };

  /// @param members  the different ones; of_joint: which one each joint is.
  /// Throws std::invalid_argument as Batch does, or when a joint names no member.
  Plan(std::span<const Member> members, std::span<const int> of_joint, std::optional<Isa> isa = {});

  /// Joint order()[k] of the caller is the plan's k-th.
  const std::vector<long>& order() const { return order_; }
  const std::vector<Group>& groups() const { return groups_; }
  long count() const { return long(order_.size()); }

  /// Rows of a table from the caller's order to the plan's, and back.
  template <class T>
  void arrange(int rows, const Columns<const T>& from, const Columns<T>& to) const;
  template <class T>
  void restore(int rows, const Columns<const T>& from, const Columns<T>& to) const;

  /// Tables in the plan's order; rows as each group's kind has them, those beyond are left alone. Law
  /// numbers are per joint. Joints::a and b are not read: `ends` has them. Nothing is checked: validate().
  template <class T>
  void evaluate(const Joints<T>& joints, const Results<T>& results, Output output,
                std::span<const EndPair<T>> ends = {}, const Options& options = {}) const;

 private:
  std::vector<long> order_;
  std::vector<Group> groups_;
};

/// The first thing that is wrong with a plan's evaluation: as validate() of a batch for each group, and
/// joints that are not as many as the plan has, laws that are not per joint, ends that are not given, an
/// output that was not built. Throws std::invalid_argument, which names the group.
template <class T>
void validate(const Plan& plan, const Joints<T>& joints, const Results<T>& results, Output output,
              std::span<const EndPair<T>> ends = {});

}  // namespace halfway::batch
