// The checksum of a run: of what was kept with it and of the names of its figures, so that no byte of it
// changes unseen.
#pragma once

#include "reports/history/record/record.hpp"

#include <cstdint>
#include <string_view>

namespace halfway::history {

/// CRC-32 over values in their order. Empty texts and NaN count as nothing at all in run(): a column that a
/// later schema adds leaves the checksums of earlier runs as they are.
class Digest {
 public:
  void run(const Run& run, const Series& series);
  void time(std::uint32_t figure, const Time& time);
  void change(std::uint32_t figure, const Reading& reading);
  void repetitions(std::uint32_t figure, const Repetitions& all);
  std::uint32_t value() const { return crc_; }

 private:
  void bytes(const void* data, std::size_t size);
  void text(std::string_view key, std::string_view value);
  template <class... Words>
  void words(Words... words);
  std::uint32_t crc_ = 0;
};

/// Stands for the figure in the checksums of its rows.
std::uint32_t digest_of(const Figure& figure);

}  // namespace halfway::history
