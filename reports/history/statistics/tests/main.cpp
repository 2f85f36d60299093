// Statistics of the history and the gate, each by a road that shares nothing with the code.
#define BOOST_TEST_MODULE statistics
#include <boost/test/unit_test.hpp>
