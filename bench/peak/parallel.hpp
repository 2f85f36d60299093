// Are two cores idle? Asked by two threads that compute on registers alone, in this process.
#pragma once

namespace halfway::bench {

/// How many times what one thread does two threads do in the same time; wall time, median of 15 tries of some
/// 3 ms. 2: two cores are idle; below kIdle others are at work on them, and a time of two threads says
/// nothing.
double measured_parallel();

inline constexpr double kIdle = 1.9;

}  // namespace halfway::bench
