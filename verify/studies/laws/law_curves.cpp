// Tables, slopes and polynomials as laws: against GSL's own splines and quadrature, and against dual numbers.
#include "reference/numbers/dual.hpp"
#include "reference/numbers/random.hpp"
#include "reference/scene/names.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/laws/read_text.hpp"

#include <fmt/format.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace halfway::verify {
namespace {

using reference::AnyLaw;
using reference::largest_entry;

struct Table {
  std::vector<double> x, y;
};

/// Points at uneven distances on a rising curve with a plateau; zero lies between two of them.
Table rising_table(unsigned seed) {
  reference::Generator random(seed);
  Table out;
  double x = -0.7, y = -40;
  for (int i = 0; i < 9; ++i) {
    out.x.push_back(x);
    out.y.push_back(y);
    const Vec3<double> step = random.vector(1.0).cwiseAbs();
    x += 0.05 + 0.2 * step[0];
    y += i == 1 ? 0 : 2 + 30 * step[1];
  }
  return out;
}

struct Method {
  const char* name;
  const gsl_interp_type* type;
};
const Method kMethods[] = {
    {"linear", gsl_interp_linear}, {"akima", gsl_interp_akima}, {"monotone", gsl_interp_steffen}};

/// GSL's spline through a table, and straight on beyond.
class Spline {
 public:
  Spline(const Table& table, const Method& method)
      : table_(table), spline_(gsl_spline_alloc(method.type, table.x.size()), &gsl_spline_free) {
    gsl_spline_init(spline_.get(), table.x.data(), table.y.data(), table.x.size());
  }
  double value(double e) const {
    const double inside = clamped(e);
    return gsl_spline_eval(spline_.get(), inside, nullptr) + slope(e) * (e - inside);
  }
  double slope(double e) const { return gsl_spline_eval_deriv(spline_.get(), clamped(e), nullptr); }

  /// Work from 0 to e by adaptive quadrature, which is told where the pieces end.
  double work(double e) const {
    const double from = e < 0 ? e : 0, to = e < 0 ? 0 : e;
    std::vector<double> ends = {from};
    for (const double x : table_.x) {
      if (x > from && x < to) ends.push_back(x);
    }
    ends.push_back(to);
    gsl_function f{[](double at, void* self) { return static_cast<const Spline*>(self)->value(at); },
                   const_cast<Spline*>(this)};
    const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> room(
        gsl_integration_workspace_alloc(200), &gsl_integration_workspace_free);
    double result = 0, error = 0;
    gsl_integration_qagp(&f, ends.data(), ends.size(), 1e-13, 1e-12, 200, room.get(), &result, &error);
    return e < 0 ? -result : result;
  }

 private:
  double clamped(double e) const { return std::clamp(e, table_.x.front(), table_.x.back()); }

  const Table& table_;
  std::unique_ptr<gsl_spline, void (*)(gsl_spline*)> spline_;
};

std::string law_text(const Table& table, const Method& method) {
  return thrice(fmt::format("x = {}\ny = {}\ninterpolation = \"{}\"", list_text(table.x), list_text(table.y),
                            method.name));
}

/// Between the points, on them, and beyond the ends.
std::vector<double> strains_of(const Table& table) {
  std::vector<double> out = table.x;
  for (std::size_t i = 1; i < table.x.size(); ++i) {
    for (const double t : {0.01, 0.37, 0.81})
      out.push_back(table.x[i - 1] + t * (table.x[i] - table.x[i - 1]));
  }
  out.insert(out.end(), {table.x.front() - 0.4, table.x.back() + 1.5});
  return out;
}

struct TableErrors {
  Measurement stress, slope, energy;
};

TableErrors table_errors(const Method& method) {
  TableErrors worst;
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Table table = rising_table(seed);
    const Spline spline(table, method);
    const AnyLaw<double, 3> law(scene_of_law(Kind::angular, law_text(table, method)).joint.law);
    for (const double e : strains_of(table)) {
      // Three strains that differ: each curve sees its own.
      const Vec3<double> strain(e, 0.7 * e + 0.011, -0.3 * e);
      const auto found = law(strain);
      double work = 0;
      for (int i = 0; i < 3; ++i) {
        const std::string where = fmt::format("table {}, strain {:.6g}", seed, strain[i]);
        worst.stress.include(std::abs(tapped(found.stress[i]) - spline.value(strain[i])) / 100, where);
        worst.slope.include(std::abs(tapped(found.stiffness(i, i)) - spline.slope(strain[i])) / 500, where);
        work += spline.work(strain[i]);
      }
      worst.energy.include(std::abs(tapped(law.energy(strain)) - work) / 10,
                           fmt::format("table {}, {:.6g}", seed, e));
    }
  }
  return worst;
}

std::vector<Finding> tables(const Method& method) {
  const TableErrors worst = table_errors(method);
  const auto name = [&](const char* what) { return fmt::format("laws/table/{}/{}", method.name, what); };
  return {
      at_most(
          name("stress"), "laws", worst.stress, 1e-14, "of 100 N m", Oracle::other_program,
          "coefficients of a cubic from its ends: some twenty roundings; gsl_spline_eval between the points"),
      at_most(name("stiffness"), "laws", worst.slope, 1e-13, "of 500 N m/rad", Oracle::other_program,
              "likewise, over steps of 0.05 rad"),
      at_most(name("energy"), "laws", worst.energy, 1e-12, "of 10 J", Oracle::other_program,
              "adaptive Gauss-Kronrod quadrature of GSL's spline, to 1e-12")};
}

/// A law at 50 digits: stiffness and energy by dual numbers along each strain.
Measurement dual_error(const reference::LawSpec& spec, const std::vector<double>& strains, bool of_energy) {
  using Dual = reference::Dual<Real50>;
  const AnyLaw<Real50, 3> law(spec);
  const AnyLaw<Dual, 3> dual(spec);
  Measurement worst;
  for (const double e : strains) {
    const Vec3<Real50> strain(Real50(e), Real50(0.7 * e + 0.011), Real50(-0.3 * e));
    const auto found = law(strain);
    for (int i = 0; i < 3; ++i) {
      Vec3<Dual> moving = strain.cast<Dual>();
      moving[i].d = Real50(1);
      const Real50 rate = of_energy ? dual.energy(moving).d : dual(moving).stress[i].d;
      const Real50 claimed = of_energy ? found.stress[i] : found.stiffness(i, i);
      worst.include(double(Real50(abs(Real50(tapped(claimed) - rate)) / Real50(500))),
                    fmt::format("strain {:.6g}", e));
    }
  }
  return worst;
}

const char* const kCurveKeys[] = {"negative = 1.8\npositive = 2.6", "k1 = 3\nk3 = -0.5\nk5 = 7",
                                  "stiffness = 4.25"};

std::vector<Finding> by_duals() {
  Measurement stiffness, energy;
  const auto include = [&](const std::string& text, const std::vector<double>& strains) {
    const reference::LawSpec law = scene_of_law(Kind::angular, text).joint.law;
    const Measurement k = dual_error(law, strains, false), w = dual_error(law, strains, true);
    stiffness.include(k.value(), k.where());
    energy.include(w.value(), w.where());
  };
  for (const Method& method : kMethods) {
    const Table table = rising_table(4);
    include(law_text(table, method), strains_of(table));
    include("preload = [1, 2, 3]\noffset = [0.1, -0.2, 0.05]\n" + law_text(table, method), strains_of(table));
  }
  for (const char* axis : kCurveKeys) include(thrice(axis), {-1.5, -0.2, -1e-9, 1e-9, 0.3, 2});
  return {at_most("laws/duals/stiffness", "laws", stiffness, kRounding, "of 500 N m/rad", Oracle::independent,
                  kRoundingReason),
          at_most("laws/duals/energy", "laws", energy, kRounding, "of 500 N m", Oracle::independent,
                  kRoundingReason)};
}

/// Slopes and polynomials in closed form, to the digits of a double.
std::vector<Finding> closed() {
  Measurement worst;
  for (const double e : {-2.0, -0.7, -0.01, 0.0, 0.02, 0.5, 3.0}) {
    const double bent = e < 0 ? 1.8 * e : 2.6 * e, odd = 3 * e - 0.5 * e * e * e + 7 * std::pow(e, 5);
    const double bent_work = bent * e / 2,
                 odd_work = 1.5 * e * e - std::pow(e, 4) / 8 + 7 * std::pow(e, 6) / 6;
    const double expected[][2] = {{bent, bent_work}, {odd, odd_work}, {4.25 * e, 2.125 * e * e}};
    for (int i = 0; i < 3; ++i) {
      const AnyLaw<double, 3> law(scene_of_law(Kind::angular, thrice(kCurveKeys[i])).joint.law);
      const Vec3<double> strain(0, e, 0);
      const double size = 1e-3 + std::abs(expected[i][0]) + std::abs(expected[i][1]);
      worst.include(std::abs(tapped(law(strain).stress[1]) - expected[i][0]) / size,
                    fmt::format("{} at {}", kCurveKeys[i], e));
      worst.include(std::abs(tapped(law.energy(strain)) - expected[i][1]) / size,
                    fmt::format("{} at {}", kCurveKeys[i], e));
    }
  }
  return {at_most("laws/closed_forms", "laws", worst, 1e-14, "relative", Oracle::closed_form,
                  "some roundings of a polynomial of degree 6")};
}

/// Of C1 curves the stiffness goes on at a point; of a polygon it jumps there, and is that of the piece
/// above.
std::vector<Finding> at_points() {
  std::vector<Finding> out;
  const Table table = rising_table(5);
  for (const Method& method : kMethods) {
    const AnyLaw<double, 3> law(scene_of_law(Kind::angular, law_text(table, method)).joint.law);
    const bool is_polygon = std::string(method.name) == "linear";
    Measurement worst;
    for (std::size_t i = 1; i + 1 < table.x.size(); ++i) {
      const auto slope = [&](double e) { return tapped(law(Vec3<double>::Constant(e)).stiffness(1, 1)); };
      const double x = table.x[i], jump = slope(x) - slope(std::nextafter(x, -1));
      const auto chord = [&](std::size_t j) {
        return (table.y[j + 1] - table.y[j]) / (table.x[j + 1] - table.x[j]);
      };
      const double expected = is_polygon ? chord(i) - chord(i - 1) : 0;
      worst.include(std::abs(jump - expected) / 500, fmt::format("point {}", i));
    }
    out.push_back(at_most(fmt::format("laws/table/{}/jumps", method.name), "laws", worst, 1e-12,
                          "of 500 N m/rad", Oracle::closed_form,
                          "roundings of slopes over steps of 0.05 rad, and one ulp of strain"));
  }
  return out;
}

/// Every formulation with three such curves: is its tangent the derivative of its loads still, and are they
/// of its potential?
std::vector<Probe> curved_probes(const Entry& entry, Kind kind) {
  auto list = probes(entry, kind, 3, 2.0);
  const auto axis = [](const char* keys) { return fmt::format("[[joint.law.axis]]\n{}\n", keys); };
  const std::string akima =
      "x = [-3, -1, -0.3, 0, 0.2, 1, 3]\ny = [-90, -40, -11, 0, 9, 30, 99]\ninterpolation = \"akima\"";
  const std::string bent = "negative = 18\npositive = 26";
  const std::string odd = "k1 = 20\nk3 = 30\nk5 = 5";
  std::string text =
      "type = \"per_axis\"\noffset = " + list_text(std::vector<double>(strain_count(kind), 0.07)) +
      "\npreload = " + list_text(std::vector<double>(strain_count(kind), 1.5)) + "\n";
  const int n = strain_count(kind);
  for (int i = 0; i < n; ++i)
    text += axis(i % 3 == 0 ? akima.c_str() : i % 3 == 1 ? bent.c_str() : odd.c_str());
  const reference::LawSpec law = scene_of_law(kind, text).joint.law;
  for (Probe& probe : list) probe.spec.law = law;
  return list;
}

bool refuses(const Entry& entry, Kind kind) {
  return !reference::accepts_law(entry, curved_probes(entry, kind).front().spec);
}

}  // namespace

void law_curves(Checks& checks) {
  for (const Method& method : kMethods)
    checks.push_back(
        {fmt::format("laws/table/{}", method.name), "laws", [&method] { return tables(method); }});
  checks.push_back({"laws/duals", "laws", by_duals});
  checks.push_back({"laws/closed", "laws", closed});
  checks.push_back({"laws/points", "laws", at_points});
  const auto kinds = {Kind::angular, Kind::linear, Kind::linear_angular};
  add_property(checks, "tangent_curves", kinds, [](const Entry& entry, Kind kind, Draft f) {
    if (refuses(entry, kind)) return f.left_out("this formulation takes no curves");
    return hold(f, tangent_by_duals(under_test(entry), curved_probes(entry, kind)), {}, Oracle::independent);
  });
  add_property(checks, "energy_gradient_curves", kinds, [](const Entry& entry, Kind kind, Draft f) {
    if (refuses(entry, kind)) return f.left_out("this formulation takes no curves");
    if (!entry.has_potential(kind)) return f.left_out("this formulation has no potential of this kind");
    return hold(f, energy_gradient(under_test(entry), curved_probes(entry, kind)), {}, Oracle::independent);
  });
}

}  // namespace halfway::verify
