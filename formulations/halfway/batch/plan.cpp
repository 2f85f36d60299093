#include "halfway/batch/plan.hpp"

#include <stdexcept>

namespace halfway::batch {
namespace {

template <class T>
Columns<T> from_joint(const Columns<T>& c, long i) {
  return {c.first == nullptr ? nullptr : c.first + i, c.stride, c.size - i};
}

template <class T>
Joints<T> part_of(const Plan::Group& g, const Joints<T>& joints, std::span<const EndPair<T>> ends) {
  Joints<T> part = joints;
  part.count = g.count;
  part.law_per_joint = true;
  for (Columns<const T>* c : {&part.q_a, &part.q_b, &part.x_a, &part.x_b, &part.law, &part.direction}) {
    *c = from_joint(*c, g.begin);
  }
  part.a = part.b = nullptr;
  if (g.ends < 0) return part;
  if (g.ends >= int(ends.size()))
    throw std::invalid_argument("plan: ends " + std::to_string(g.ends) + " are not given");
  part.a = &ends[g.ends].a, part.b = &ends[g.ends].b;
  return part;
}

template <class T>
Results<T> part_of(const Plan::Group& g, const Results<T>& results) {
  return {from_joint(results.loads, g.begin), from_joint(results.tangent, g.begin)};
}

}  // namespace

Plan::Plan(std::span<const Member> members, std::span<const int> of_joint, std::optional<Isa> isa) {
  std::vector<long> counts(members.size());
  for (std::size_t i = 0; i < of_joint.size(); ++i) {
    const int member = of_joint[i];
    if (member < 0 || member >= int(members.size())) {
      throw std::invalid_argument("plan: joint " + std::to_string(i) + " names member " +
                                  std::to_string(member) + " of " + std::to_string(members.size()));
    }
    ++counts[member];
  }
  std::vector<long> next(members.size());
  long begin = 0;
  for (std::size_t m = 0; m < members.size(); ++m) {
    next[m] = begin;
    if (counts[m] > 0) groups_.push_back({Batch(members[m].model, isa), members[m].ends, begin, counts[m]});
    begin += counts[m];
  }
  order_.resize(of_joint.size());
  for (std::size_t i = 0; i < of_joint.size(); ++i) order_[next[of_joint[i]]++] = long(i);
}

template <class T>
void Plan::arrange(int rows, const Columns<const T>& from, const Columns<T>& to) const {
  for (int row = 0; row < rows; ++row) {
    const T* const source = from.first + row * from.stride;
    T* const target = to.first + row * to.stride;
    for (long k = 0; k < count(); ++k) target[k] = source[order_[k]];
  }
}

template <class T>
void Plan::restore(int rows, const Columns<const T>& from, const Columns<T>& to) const {
  for (int row = 0; row < rows; ++row) {
    const T* const source = from.first + row * from.stride;
    T* const target = to.first + row * to.stride;
    for (long k = 0; k < count(); ++k) target[order_[k]] = source[k];
  }
}

template <class T>
void Plan::evaluate(const Joints<T>& joints, const Results<T>& results, Output output,
                    std::span<const EndPair<T>> ends, const Options& options) const {
  for (const Group& g : groups_) {
    g.batch.evaluate(part_of(g, joints, ends), part_of(g, results), output, options);
  }
}

template <class T>
void validate(const Plan& plan, const Joints<T>& joints, const Results<T>& results, Output output,
              std::span<const EndPair<T>> ends) {
  if (joints.count != plan.count()) {
    throw std::invalid_argument("plan: " + std::to_string(joints.count) +
                                " joints are given, the plan is of " + std::to_string(plan.count()));
  }
  if (!joints.law_per_joint) throw std::invalid_argument("plan: law_per_joint is false; laws are per joint");
  for (const Plan::Group& g : plan.groups()) {
    const Model& model = g.batch.model();
    const std::string group = "plan, joints " + std::to_string(g.begin) + " to " +
                              std::to_string(g.begin + g.count - 1) + " (" + model.formulation + '/' +
                              halfway::to_string(model.kind) + "), counted from the first of them: ";
    try {
      validate(model, part_of(g, joints, ends), part_of(g, results), output);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(group + error.what());
    }
    if (!g.batch.has<T>(output)) throw std::invalid_argument(group + "this output is not built for them");
  }
}

template void Plan::arrange(int, const Columns<const double>&, const Columns<double>&) const;
template void Plan::arrange(int, const Columns<const float>&, const Columns<float>&) const;
template void Plan::restore(int, const Columns<const double>&, const Columns<double>&) const;
template void Plan::restore(int, const Columns<const float>&, const Columns<float>&) const;
template void Plan::evaluate(const Joints<double>&, const Results<double>&, Output,
                             std::span<const EndPair<double>>, const Options&) const;
template void Plan::evaluate(const Joints<float>&, const Results<float>&, Output,
                             std::span<const EndPair<float>>, const Options&) const;
template void validate(const Plan&, const Joints<double>&, const Results<double>&, Output,
                       std::span<const EndPair<double>>);
template void validate(const Plan&, const Joints<float>&, const Results<float>&, Output,
                       std::span<const EndPair<float>>);

}  // namespace halfway::batch
