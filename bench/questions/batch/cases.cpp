// Which batches are timed.
#include "bench/harness/flops.hpp"
#include "bench/questions/batch/problem.hpp"

#include "reference/face/registry.hpp"

namespace halfway::bench {

Cases batch_cases();

namespace {

using batch::Isa, batch::kIsas, batch::Output;

std::shared_ptr<const Inputs> inputs_for(const std::string& formulation, Kind kind, bool ends) {
  const Parameters& probe = reference::find_formulation(formulation)->probe;
  return std::make_shared<const Inputs>(inputs(kind, probe, false, ends));
}

/// A lane does what the kernel of one joint does. The batch's own dual numbers (J v) are not counted, nor is
/// what a law without coupling or a compressed tangent spares.
void add_flops(Case& c, const BatchProblem& p) {
  if (p.output == Output::product || p.output == Output::compressed || p.block_diagonal) return;
  const char* what = p.output == Output::residual ? "/residual/kernel" : "/residual_tangent/kernel";
  const std::string name =
      p.formulation + '/' + to_string(p.in->spec.kind) + what + (p.ends ? "" : "/no_ends");
  c.flops = kept_flops(name);
  if (!p.ends) c.products = kept_flops(name + kProducts);
}

template <class T>
void add(Cases& cases, const BatchProblem& p) {
  if (!can_run<T>(p)) return;
  cases.push_back(batch_case<T>(p));
  add_flops(cases.back(), p);
}

/// Tables in L1 and L2; joints without ends, as the kernels' variant of that name.
void add_by_isa(Cases& cases, const std::string& formulation, Kind kind) {
  const auto in = inputs_for(formulation, kind, false);
  for (const Isa isa : kIsas) {
    for (const Output output : {Output::residual, Output::tangent}) {
      const BatchProblem p{in, formulation, isa, output, kPoses};
      add<double>(cases, p);
      add<float>(cases, p);
    }
  }
  add<double>(cases, {in, formulation, batch::choose({}), Output::product, kPoses});
  add<double>(cases, {in, formulation, batch::choose({}), Output::compressed, kPoses});
  if (kind != Kind::angular)
    add<double>(cases, {in, formulation, batch::choose({}), Output::tangent_144, kPoses});
}

/// Laws that do not couple translation and rotation, where there is a loop for them.
void add_block_diagonal(Cases& cases) {
  const auto in = std::make_shared<const Inputs>(inputs(Kind::linear_angular, {}, true, false));
  for (const Isa isa : kIsas) {
    BatchProblem p{in, "fasse", isa, Output::tangent, kPoses};
    p.block_diagonal = true;
    add<double>(cases, p);
    add<float>(cases, p);
  }
}

/// The same packs in 16 registers and in 32, of a formulation that has no AVX-512 code.
void add_by_registers(Cases& cases) {
  for (const Kind kind : {Kind::angular, Kind::linear_angular}) {
    const auto in = inputs_for("potential", kind, false);
    for (const Isa isa : {Isa::avx2, Isa::avx2vl})
      add<double>(cases, {in, "potential", isa, Output::tangent, kPoses});
  }
}

/// Compressed, from memory; and whole, where add_threads does not time that.
void add_compressed(Cases& cases) {
  const auto add_one = [&](Kind kind, Output output) {
    add<double>(cases,
                {inputs_for("invariant", kind, false), "invariant", batch::choose({}), output, 100000});
  };
  for (const Kind kind : {Kind::angular, Kind::linear, Kind::linear_angular})
    add_one(kind, Output::compressed);
  add_one(Kind::linear_angular, Output::tangent);
}

/// From L1 to DRAM.
void add_by_number(Cases& cases, Kind kind) {
  const auto in = inputs_for("invariant", kind, false);
  for (const long joints : {1L, 8L, 64L, 512L, 4096L, 30000L, 250000L, 1000000L}) {
    for (const Output output : {Output::residual, Output::tangent}) {
      add<double>(cases, {in, "invariant", batch::choose({}), output, joints});
    }
  }
}

void add_threads(Cases& cases, Kind kind, Output output) {
  const auto in = inputs_for("invariant", kind, false);
  for (const int threads : {1, 2}) {
    BatchProblem p{in, "invariant", batch::choose({}), output, 100000};
    p.options.threads = threads;
    add<double>(cases, p);
  }
}

}  // namespace

Cases batch_cases() {
  Cases cases;
  for (const reference::Entry& entry : reference::formulations()) {
    if (!entry.wide) continue;
    add_by_isa(cases, std::string(entry.name), Kind::angular);
    add_by_isa(cases, std::string(entry.name), Kind::linear);
  }
  for (const char* name : {"attached_a", "invariant", "fasse"}) add_by_isa(cases, name, Kind::linear_angular);
  add_block_diagonal(cases), add_by_registers(cases), add_compressed(cases);
  // What joint points and frames apart from the nodes cost.
  for (const Kind kind : {Kind::angular, Kind::linear, Kind::linear_angular}) {
    BatchProblem p{
        inputs_for("invariant", kind, true), "invariant", batch::choose({}), Output::tangent, kPoses, true};
    add<double>(cases, p);
  }
  add_by_number(cases, Kind::angular), add_by_number(cases, Kind::linear);
  for (const Output output : {Output::residual, Output::tangent}) {
    add_threads(cases, Kind::angular, output), add_threads(cases, Kind::linear, output);
  }
  return cases;
}

}  // namespace halfway::bench
