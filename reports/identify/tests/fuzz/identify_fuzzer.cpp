// libFuzzer's door to the readers of `halfway identify`: `.ci/fuzz identify` builds and runs it.
#include "reports/identify/tests/promises.hpp"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string wrong =
      halfway::reports::test::broken_promise({reinterpret_cast<const char*>(data), size});
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
