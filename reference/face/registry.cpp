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

ScopedRegistry::ScopedRegistry(std::vector<Entry> entries)
    : entries_(std::move(entries)), before_(std::exchange(in_use(), entries_)) {}

ScopedRegistry::~ScopedRegistry() { in_use() = before_; }

}  // namespace halfway::reference
