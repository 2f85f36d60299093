#include "halfway/batch/batch.hpp"

#include "halfway/batch/entries.hpp"
#include "halfway/batch/run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace halfway::batch {
namespace {

using detail::Entry;

const Entry& entry_named(const std::string& name) {
  std::string known;
  for (const Entry& e : detail::entries()) {
    if (e.name == name) return e;
    known += (known.empty() ? "" : ", ") + std::string(e.name);
  }
  throw std::invalid_argument("formulation '" + name + "' has no batch; known: " + known);
}

/// The formulation whose code serves `name` for this kind.
const Entry& serving(const std::string& name, Kind kind) {
  const Entry& own = entry_named(name);
  for (const Entry& e : detail::entries()) {
    if (e.kernel == own.served[int(kind)]) return e;
  }
  throw std::invalid_argument("formulation '" + name +
                              "': the one whose kernel it shares is not in the catalog");
}

template <class T>
const detail::Functions<T>& functions(const detail::Unit& unit, Kind kind) {
  if constexpr (std::is_same_v<T, double>)
    return unit.in_double[int(kind)];
  else
    return unit.in_float[int(kind)];
}

/// What becomes of a loop's results, stored past the caches or not; nullptr: nothing, they are in their
/// tables.
/// @param direct  does the loop write what a compressed tangent keeps?
template <class T>
detail::Spread<T> spread(Isa isa, Output output, int rows, bool direct, bool past_caches) {
  const detail::Spreadings& all = *detail::spreadings(isa);
  const detail::Spreading<T>* s;
  if constexpr (std::is_same_v<T, double>) {
    if (output == Output::compressed && !direct) return all.compressing(rows).compress;
    s = &all.in_double;
  } else {
    s = &all.in_float;
  }
  if (output == Output::tangent_144) return past_caches ? s->all_entries_streamed : s->all_entries;
  const bool kept = output == Output::tangent || output == Output::compressed;
  return kept && past_caches ? s->streamed : nullptr;
}

template <class T>
detail::Evaluate<T> function(const detail::Functions<T>& f, Output output) {
  return output == Output::residual ? f.residual : output == Output::product ? f.product : f.tangent;
}

/// The same function, or its lean twin where joints can do with it.
template <class T>
detail::Evaluate<T> leanest(const detail::Functions<T>& f, Output output, LawForm law, bool ends) {
  const bool lean = law == LawForm::linear && !ends && output != Output::product;
  const auto twin = output == Output::residual     ? f.lean_residual
                    : output == Output::compressed ? f.lean_compressed
                                                   : f.lean_tangent;
  return lean && twin != nullptr ? twin : function(f, output);
}

}  // namespace

Batch::Batch(const Model& model, std::optional<Isa> isa)
    : model_(model), widest_(choose(isa)), served_by_(&serving(model.formulation, model.kind)) {
  const Entry& entry = entry_named(model.formulation);
  const auto refuse = [&](const char* what) {
    throw std::invalid_argument("formulation '" + model.formulation + "' needs " + what);
  };
  if (entry.needs_xi && !(model.xi && std::isfinite(*model.xi))) refuse("a xi: Model::xi, any number");
  if (!entry.needs_length) return;
  if (!(model.length && std::isfinite(*model.length) && *model.length > 0))
    refuse("a length: Model::length, m, > 0");
  if (model.axis == 0 || std::abs(model.axis) > 3) refuse("an axis: Model::axis, 1, 2, 3 or -1, -2, -3");
}

bool Batch::knows(std::string_view formulation) {
  return std::ranges::any_of(detail::entries(), [&](const Entry& e) { return e.name == formulation; });
}

bool Batch::needs_length(std::string_view formulation) {
  return std::ranges::any_of(detail::entries(),
                             [&](const Entry& e) { return e.name == formulation && e.needs_length; });
}

int Batch::compressed_rows(const Model& model) {
  return entry_named(model.formulation).compressed[int(model.kind)];
}

template <class T>
Batch::Code<T> Batch::code(Output output) const {
  if (output == Output::tangent_144 && model_.kind == Kind::angular) return {};
  if (output == Output::compressed && (sizeof(T) != sizeof(double) || compressed_rows(model_) == 0))
    return {};
  for (int isa = int(widest_); isa >= 0; --isa) {
    const detail::Unit* const unit = served_by_->units[isa];
    if (unit == nullptr) continue;
    const detail::Functions<T>& f = functions<T>(*unit, model_.kind);
    if (function(f, output) != nullptr) return {&f, Isa(isa)};
  }
  return {};
}

template <class T>
bool Batch::has(Output output) const {
  return code<T>(output).functions != nullptr;
}

template <class T>
Isa Batch::isa(Output output) const {
  return code<T>(output).isa;
}

template <class T>
void Batch::evaluate(const Joints<T>& joints, const Results<T>& results, Output output,
                     const Options& options) const {
  const Code<T> c = code<T>(output);
  if (c.functions == nullptr) {
    throw std::invalid_argument(model_.formulation + '/' + halfway::to_string(model_.kind) + " in " +
                                (sizeof(T) == 4 ? "float" : "double") +
                                ": this output is not built for the instruction sets in use");
  }
  const auto f = leanest(*c.functions, output, model_.law, joints.a != nullptr);
  const int rows = output == Output::compressed ? compressed_rows(model_) : tangent_rows(model_.kind, output);
  const bool direct = output == Output::compressed && f == c.functions->lean_compressed;
  const auto spread_by = [&](bool past_caches) {
    return spread<T>(c.isa, output, rows, direct, past_caches);
  };
  const bool chosen_from = !direct && output != Output::residual && output != Output::product;
  const int kept = chosen_from ? tangent_rows(model_.kind, Output::tangent) : rows;
  detail::run(detail::Work<T>{model_, joints, results, output, f, spread_by(false), spread_by(true),
                              bytes(c.isa) / int(sizeof(T)), rows, kept},
              options);
}

namespace {

/// Compressed results of a batch; nullptr for what a call does not read.
detail::Unpacking unpacking(const Joints<double>& j, const Results<double>& r, int rows,
                            const Columns<double>& out) {
  return {j.count,
          j.x_a,
          j.x_b,
          j.direction,
          {r.loads.first, r.loads.stride},
          detail::blocks<const double>(r.tangent.first, rows),
          {out.first, out.stride}};
}

}  // namespace

void Batch::expand(const Joints<double>& joints, const Results<double>& compressed,
                   const Columns<double>& tangent, Output output) const {
  const int rows = compressed_rows(model_);
  const detail::Compressing& form = detail::spreadings(widest_)->compressing(rows);
  (output == Output::tangent_144 ? form.expand_all
                                 : form.expand)(unpacking(joints, compressed, rows, tangent));
}

void Batch::multiply(const Joints<double>& joints, const Results<double>& compressed,
                     const Columns<double>& product) const {
  const int rows = compressed_rows(model_);
  detail::spreadings(widest_)->compressing(rows).multiply(unpacking(joints, compressed, rows, product));
}

bool Batch::has_potential() const { return entry_named(model_.formulation).has_potential[int(model_.kind)]; }

detail::PackLoop Batch::loop(Output output, bool ends) const {
  const Code<double> c = code<double>(output);
  return {leanest(*c.functions, output, model_.law, ends), bytes(c.isa) / int(sizeof(double))};
}

template bool Batch::has<double>(Output) const;
template bool Batch::has<float>(Output) const;
template Isa Batch::isa<double>(Output) const;
template Isa Batch::isa<float>(Output) const;
template void Batch::evaluate(const Joints<double>&, const Results<double>&, Output, const Options&) const;
template void Batch::evaluate(const Joints<float>&, const Results<float>&, Output, const Options&) const;

}  // namespace halfway::batch
