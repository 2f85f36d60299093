#include "halfway/assemble/shares.hpp"

#include <algorithm>
#include <numeric>

namespace halfway::assemble::detail {
namespace {

/// The node in whose stored rows block k lies: 0, a; 1, b.
int node_of(const Form& form, int k) { return form.layout == Layout::columns ? k % 2 : k / 2; }

void leave_out(Target& t, int k) {
  t.block[k] = -1;
  t.first |= 1 << k;
}

Target target_of(const Place& place, const Form& form, const Packs& packs) {
  Target t{place, 0};
  t.joint -= int(packs.first);
  for (int& row : t.row) {
    if (row >= 0) row += packs.inset;
  }
  for (int k = 0; k < 4; ++k) {
    if (t.block[k] < 0)
      leave_out(t, k);
    else
      t.block[k] += packs.inset * (t.stride[node_of(form, k)] + 1);
  }
  return t;
}

/// The same lane without a part in the rows of node n.
void drop_node(Target& t, const Form& form, int n) {
  t.row[n] = -1;
  for (int k = 0; k < 4; ++k) {
    if (node_of(form, k) == n) leave_out(t, k);
  }
}

/// The joints in packs; what is missing of the last one is filled up with its last joint, that goes nowhere.
std::vector<Target> in_packs(const Pattern& pattern, const Packs& packs) {
  std::vector<Target> all;
  for (const Place& place : pattern.places().subspan(packs.first, packs.count)) {
    all.push_back(target_of(place, pattern.form(), packs));
  }
  while (all.size() % packs.lanes != 0) {
    all.push_back(all.back());
    for (int n = 0; n < 2; ++n) drop_node(all.back(), pattern.form(), n);
  }
  return all;
}

/// Marks what comes first to each block, in the order in which packs are put.
void mark_first(std::vector<Target>& all, const Pattern& pattern, const Packs& packs) {
  std::vector<bool> taken(pattern.value_count());
  for (std::size_t from = 0; from < all.size(); from += packs.lanes_at_once) {
    for (const int k : std::span(packs.order, 4)) {
      for (int lane = 0; lane < packs.lanes_at_once; ++lane) {
        Target& t = all[from + lane];
        if (t.block[k] < 0 || taken[t.block[k]]) continue;
        taken[t.block[k]] = true;
        t.first |= 1 << k;
      }
    }
  }
}

/// Where each thread's rows begin, in unknowns; equal parts of the joints' ends.
std::vector<long> boundaries(const std::vector<Target>& all, const Pattern& pattern, int threads) {
  const int n = pattern.form().unknowns;
  std::vector<long> ends(pattern.unknown_count() / n);
  for (const Target& t : all) {
    for (const int row : t.row) {
      if (row >= 0) ++ends[row / n];
    }
  }
  std::inclusive_scan(ends.begin(), ends.end(), ends.begin());
  const long total = ends.empty() ? 0 : ends.back();
  std::vector<long> out;
  for (int k = 0; k < threads; ++k) {
    const long row = std::ranges::lower_bound(ends, total * k / threads + (k > 0)) - ends.begin();
    out.push_back(k == 0 ? 0 : n * row);
  }
  out.push_back(pattern.unknown_count());
  return out;
}

Share share_of(const std::vector<Target>& all, const Form& form, int lanes, long begin, long end) {
  Share share{begin, end, {}};
  for (std::size_t pack = 0; pack < all.size(); pack += lanes) {
    std::vector<Target>& out = share.targets;
    out.insert(out.end(), all.begin() + pack, all.begin() + pack + lanes);
    bool any = false;
    for (std::size_t i = out.size() - lanes; i < out.size(); ++i) {
      for (int n = 0; n < 2; ++n) {
        const bool own = out[i].row[n] >= begin && out[i].row[n] < end;
        any |= own;
        if (!own) drop_node(out[i], form, n);
      }
    }
    if (!any) out.resize(out.size() - lanes);
  }
  return share;
}

}  // namespace

std::vector<Share> share_out(const Pattern& pattern, const Packs& packs, int threads) {
  std::vector<Target> all = in_packs(pattern, packs);
  mark_first(all, pattern, packs);
  const std::vector<long> begin = boundaries(all, pattern, threads);
  std::vector<Share> shares;
  for (int k = 0; k < threads; ++k) {
    shares.push_back(share_of(all, pattern.form(), packs.lanes, begin[k], begin[k + 1]));
  }
  return shares;
}

}  // namespace halfway::assemble::detail
