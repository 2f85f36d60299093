#define BOOST_TEST_MODULE identify
#include <boost/test/unit_test.hpp>
