// Contains the main function of every test program.
#define BOOST_TEST_MODULE ehl
#include <boost/test/unit_test.hpp>
