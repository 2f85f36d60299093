// What the scenes of chains and their solver refuse, each by name. One good text is broken in one place at a
// time.
#include "verify/oracle/broken_scene.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/chains/chain_rods.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace halfway::verify {
namespace {

namespace chain = reference::chain;

constexpr const char* kGoodChain = R"(title = "good"
formulations = ["invariant", "intrinsic"]
xis = [0.5]

[chain]
links = 8
length = 2
GJ = 1
EI = [2, 3]
EA = 1e4
GA = 5e3
curvature = [0.1, 0, 0.2]
root = { x = [0, 0, 1], h = [0.8, 0, 0.6, 0] }

[[load]]
type = "follower_force"
value = [0, 0, 1]

[path]
factor_end = 10
points = 2

[[reference]]
source = "s"
oracle = "printed"
factor = 10
tolerance = 1e-6
reason = "r"
[reference.values]
rod = { x = "0.1" }
)";

constexpr Broken kBrokenChains[] = {
    {"chain_key_unknown", "chain.stiffness = ", "GJ = 1", "GJ = 1\nstiffness = 3 #!"},
    {"chain_and_joint", "joint = ", "[[load]]", "[joint] #!\nkind = \"angular\"\n[[load]]"},
    {"chain_links_missing", "chain.links = nothing", "[chain]\nlinks = 8", "[chain] #!"},
    {"chain_links_zero", "chain.links = ", "links = 8", "links = 0 #!"},
    {"chain_links_float", "chain.links = ", "links = 8", "links = 8.5 #!"},
    {"chain_length_negative", "chain.length = ", "length = 2", "length = -2 #!"},
    {"chain_GJ_zero", "chain.GJ = ", "GJ = 1", "GJ = 0 #!"},
    {"chain_EI_zero", "chain.EI = ", "EI = [2, 3]", "EI = [2, 0] #!"},
    {"chain_EI_three", "chain.EI = ", "EI = [2, 3]", "EI = [2, 3, 4] #!"},
    {"chain_GA_text", "chain.GA = ", "GA = 5e3", "GA = \"5e3\" #!"},
    {"chain_EA_nan", "chain.EA = ", "EA = 1e4", "EA = nan #!"},
    {"chain_curvature_short", "chain.curvature = ", "[0.1, 0, 0.2]", "[0.1, 0.2] #!"},
    {"chain_root_not_rotation", "chain.root.h = ", "[0.8, 0, 0.6, 0] }", "[0.8, 0, 0.7, 0] } #!"},
    {"chain_node_order_unknown", "chain.node_order = ", "GJ = 1", "GJ = 1\nnode_order = \"a_first\" #!"},
    {"chain_load_unknown", "load[1].type = ", "\"follower_force\"", "\"dead_force\" #!"},
    {"chain_load_point", "load[1].point = ", "value = [0, 0, 1]", "value = [0, 0, 1]\npoint = [0, 0, 0] #!"},
    {"chain_load_arm", "load[1].arm = ", "value = [0, 0, 1]", "value = [0, 0, 1]\narm = [1, 0, 0] #!"},
    {"chain_arm_missing", "load[1].arm = nothing", "[[load]]\ntype = \"follower_force\"",
     "[[load]] #!\ntype = \"quasi_tangential_moment\""},
    {"chain_arm_along", "load[1].arm = ", "type = \"follower_force\"\nvalue = [0, 0, 1]",
     "type = \"quasi_tangential_moment\"\nvalue = [0, 0, 1]\narm = [1, 0, 1] #!"},
    {"chain_critical_axis", "path.critical_axis = ", "points = 2", "critical_axis = 1 #!"},
    {"chain_held_and_load", "load = ", "[[load]]", "[held]\nx = [1, 0, 0]\n[[load]] #!"},
    {"chain_output_of_joint", "outputs[1] = ", "xis = [0.5]", "xis = [0.5]\noutputs = [\"u_x\"] #!"},
    {"chain_linearized", "formulations[1] = ", "[\"invariant\", \"intrinsic\"]", "[\"linearized\"] #!"},
    {"chain_without_xi", "formulations = ", "\"intrinsic\"]\nxis = [0.5]", "\"intrinsic\"] #!"},
    {"chain_rod_with_xi", "reference[1].xi = ", "reason = \"r\"", "reason = \"r\"\nxi = 0.5 #!"},
    {"chain_reference_beyond", "reference[1].factor = ", "factor = 10\ntol", "factor = 11 #!\ntol"},
    {"chain_reference_unknown", "reference[1].values.red = ", "rod = { x = \"0.1\" }",
     "red = { x = \"0.1\" } #!"},
};

struct Asked {
  const char* what;
  const char* says;
  void (*change)(chain::Chain&);
};
constexpr Asked kAsked[] = {
    {"unknown_formulation", "no_such_law", [](chain::Chain& c) { c.formulation = "no_such_law"; }},
    {"missing_xi", "intrinsic", [](chain::Chain& c) { c.formulation = "intrinsic"; }},
    {"no_links", "links", [](chain::Chain& c) { c.links = 0; }},
    {"no_length", "length", [](chain::Chain& c) { c.length = 0; }},
    {"no_torsion", "GJ", [](chain::Chain& c) { c.section.GJ = 0; }},
    {"negative_bending", "EI3", [](chain::Chain& c) { c.section.EI3 = -1; }},
    {"curvature_nan", "curvature", [](chain::Chain& c) { c.curvature[1] = std::nan(""); }},
};

/// The solver's refusal names what is wrong.
Finding solver_refuses(const Asked& asked) {
  chain::Chain c;
  asked.change(c);
  std::string message;
  try {
    chain::solve(c, {{0, 1, 0}});
  } catch (const std::invalid_argument& error) {
    message = tapped(std::string(error.what()));
  }
  return finding(fmt::format("chains/refuses/{}", asked.what))
      .about("chains")
      .measured(message.find(asked.says) == std::string::npos, message.empty() ? "it was solved" : message)
      .at_most(0, fmt::format("the message must name {}", asked.says))
      .by(Oracle::closed_form);
}

std::vector<Finding> solver_refusals() {
  std::vector<Finding> out;
  for (const Asked& asked : kAsked) out.push_back(solver_refuses(asked));
  return out;
}

}  // namespace

void chain_refusals(Checks& checks) {
  checks.push_back({"scenes/accepts/good_chain", "chains",
                    [] { return std::vector{accepted("good_chain", kGoodChain)}; }});
  for (const Broken& broken : kBrokenChains) {
    checks.push_back({fmt::format("scenes/refuses/{}", broken.what), "chains",
                      [&broken] { return std::vector{broken_refused(kGoodChain, broken)}; }});
  }
  checks.push_back({"chains/refuses", "chains", solver_refusals});
}

}  // namespace halfway::verify
