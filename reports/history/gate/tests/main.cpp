// compare and gate: reports that differ in one field, and benchmark programs that are shell scripts.
#define BOOST_TEST_MODULE gate
#include <boost/test/unit_test.hpp>
