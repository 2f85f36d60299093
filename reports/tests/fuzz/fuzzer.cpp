// libFuzzer's door to a reader: `.ci/fuzz` builds and runs one for each. HALFWAY_PROMISES is the header of
// its promises, HALFWAY_BROKEN_PROMISE its function text -> the promise that is broken, or nothing.
#include HALFWAY_PROMISES

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string wrong = halfway::HALFWAY_BROKEN_PROMISE({reinterpret_cast<const char*>(data), size});
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
