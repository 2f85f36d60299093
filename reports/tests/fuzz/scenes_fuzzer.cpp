// libFuzzer's door to the reader of scene files: `.ci/fuzz scenes` builds and runs it.
#include "reports/tests/scene_promises.hpp"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string wrong =
      halfway::reports::test::broken_scene_promise({reinterpret_cast<const char*>(data), size});
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
