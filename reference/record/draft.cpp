#include "reference/record/finding.hpp"

namespace halfway::reference {

Draft& Draft::about(std::string subject) {
  f_.subject = std::move(subject);
  return *this;
}

Draft& Draft::of(std::string formulation, std::string kind) {
  f_.formulation = std::move(formulation);
  f_.kind = std::move(kind);
  return *this;
}

Draft& Draft::measured(const Measurement& worst) {
  f_.replay = worst.replay();
  return measured(worst.value(), worst.where());
}

Draft& Draft::measured(double value, std::string where) {
  f_.value = value;
  f_.parameter = std::move(where);
  return *this;
}

Draft& Draft::in(std::string unit) {
  f_.unit = std::move(unit);
  return *this;
}

Draft& Draft::at_most(double limit, std::string why) {
  f_.comparison = Comparison::at_most;
  f_.high = limit;
  f_.reason = std::move(why);
  return *this;
}

Draft& Draft::at_least(double limit, std::string why) {
  f_.comparison = Comparison::at_least;
  f_.low = limit;
  f_.reason = std::move(why);
  return *this;
}

Draft& Draft::within(double low, double high, std::string why) {
  f_.comparison = Comparison::within;
  f_.low = low;
  f_.high = high;
  f_.reason = std::move(why);
  return *this;
}

Draft& Draft::equal(double expected, double tolerance, std::string why) {
  f_.comparison = Comparison::equal;
  f_.expected = expected;
  f_.high = tolerance;
  f_.reason = std::move(why);
  return *this;
}

Draft& Draft::reported(std::string why) {
  f_.comparison = Comparison::report;
  f_.reason = std::move(why);
  return *this;
}

Draft& Draft::left_out(std::string why) {
  f_.verdict = Verdict::left_out;
  f_.reason = std::move(why);
  return *this;
}

Draft& Draft::by(Oracle oracle, double uncertainty) {
  f_.oracle = oracle;
  f_.uncertainty = uncertainty;
  return *this;
}

}  // namespace halfway::reference
