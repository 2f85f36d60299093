#define BOOST_TEST_MODULE advise
#include "reference/face/registry.hpp"

#include <boost/test/unit_test.hpp>

namespace {
struct Complete {
  Complete() { halfway::reference::complete_catalog(); }
};
}  // namespace
BOOST_TEST_GLOBAL_FIXTURE(Complete);
