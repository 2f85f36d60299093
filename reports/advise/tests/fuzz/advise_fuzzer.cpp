// libFuzzer's door to the reader of a truth of one's own: `.ci/fuzz advise` builds and runs it.
#include "reports/advise/tests/promises.hpp"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string wrong =
      halfway::advise::test::broken_table_promise({reinterpret_cast<const char*>(data), size});
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
