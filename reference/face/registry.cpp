#include "reference/face/registry.hpp"

#include <algorithm>

namespace halfway::reference {
namespace {

std::span<const Entry>& in_use() {
  static std::span<const Entry> entries = catalogued();
  return entries;
}

}  // namespace

std::span<const Entry> formulations() { return in_use(); }

const Entry* find_formulation(std::string_view name) {
  const auto all = formulations();
  const auto it = std::ranges::find(all, name, &Entry::name);
  return it == all.end() ? nullptr : &*it;
}

double stored_energy(const Entry& entry, const JointSpec& spec, const Pose<double>& a,
                     const Pose<double>& b) {
  if (const std::optional<double> potential = entry.in_double.energy(spec, a, b)) return *potential;
  const Eigen::VectorXd e = entry.in_double.strain(spec, a, b);
  if (spec.kind == Kind::linear_angular) return AnyLaw<double, 6>(spec.law).energy(e);
  return AnyLaw<double, 3>(spec.law).energy(e);
}

ScopedRegistry::ScopedRegistry(std::vector<Entry> entries)
    : entries_(std::move(entries)), before_(std::exchange(in_use(), entries_)) {}

ScopedRegistry::~ScopedRegistry() { in_use() = before_; }

}  // namespace halfway::reference
