// Programs under check: words, lines and answers by themselves, then real processes that misbehave.
#define BOOST_TEST_MODULE child
#include <boost/test/unit_test.hpp>
