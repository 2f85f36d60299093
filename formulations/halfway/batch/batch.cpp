#include "halfway/batch/batch.hpp"

#include "halfway/batch/entries.hpp"
#include "halfway/batch/run.hpp"

#include <algorithm>
#include <cmath>
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

template <class T>
const detail::Spreading<T>& spreading(Isa isa) {
  if constexpr (std::is_same_v<T, double>)
    return detail::spreadings(isa)->in_double;
  else
    return detail::spreadings(isa)->in_float;
}

template <class T>
detail::Evaluate<T> function(const detail::Functions<T>& f, Output output) {
  return output == Output::residual ? f.residual : output == Output::product ? f.product : f.tangent;
}

/// The same function, or its lean twin where this call can do with it.
template <class T>
detail::Evaluate<T> leanest(const detail::Functions<T>& f, Output output, LawForm law,
                            const Joints<T>& joints) {
  const bool lean = law == LawForm::linear && joints.a == nullptr && output != Output::product;
  const auto twin = output == Output::residual     ? f.lean_residual
                    : output == Output::compressed ? f.lean_compressed
                                                   : f.lean_tangent;
  return lean && twin != nullptr ? twin : function(f, output);
}

}  // namespace

Batch::Batch(const Model& model, std::optional<Isa> isa)
    : model_(model), widest_(choose(isa)), served_by_(&serving(model.formulation, model.kind)) {
  if (entry_named(model.formulation).needs_xi && !(model.xi && std::isfinite(*model.xi)))
    throw std::invalid_argument("formulation '" + model.formulation + "' needs a xi: Model::xi, any number");
}

bool Batch::knows(std::string_view formulation) {
  return std::ranges::any_of(detail::entries(), [&](const Entry& e) { return e.name == formulation; });
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
  const int lanes = (16 << int(c.isa)) / int(sizeof(T));
  const auto f = leanest(*c.functions, output, model_.law, joints);
  const bool compressed = output == Output::compressed;
  const int rows = compressed ? compressed_rows(model_) : tangent_rows(model_.kind, output);
  const bool compressing = compressed && f == c.functions->lean_compressed;
  detail::run(
      detail::Work<T>{model_, joints, results, output, f, spreading<T>(c.isa), lanes, rows, compressing},
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
  const auto& s = spreading<double>(widest_);
  (output == Output::tangent_144 ? s.expand_all : s.expand)[detail::compressed_form(rows)](
      unpacking(joints, compressed, rows, tangent));
}

void Batch::multiply(const Joints<double>& joints, const Results<double>& compressed,
                     const Columns<double>& product) const {
  const int rows = compressed_rows(model_);
  spreading<double>(widest_).multiply[detail::compressed_form(rows)](
      unpacking(joints, compressed, rows, product));
}

template bool Batch::has<double>(Output) const;
template bool Batch::has<float>(Output) const;
template Isa Batch::isa<double>(Output) const;
template Isa Batch::isa<float>(Output) const;
template void Batch::evaluate(const Joints<double>&, const Results<double>&, Output, const Options&) const;
template void Batch::evaluate(const Joints<float>&, const Results<float>&, Output, const Options&) const;

}  // namespace halfway::batch
