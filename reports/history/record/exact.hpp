// A kept reading as the comparisons take it.
#pragma once

#include "reports/history/record/record.hpp"
#include "reports/history/statistics/exact.hpp"

namespace halfway::history {

statistics::Exact exact_of(const Figure& figure, const Reading& reading);

}  // namespace halfway::history
