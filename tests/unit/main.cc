// SPDX-License-Identifier: LGPL-2.1-or-later

#define BOOST_TEST_MODULE lamella
#include <lamella/base/processes.h>

#include <boost/test/unit_test.hpp>

/// Trilinos wants MPI for as long as there are tests.
struct Session
{
  Session()
    : mpi(boost::unit_test::framework::master_test_suite().argc,
          boost::unit_test::framework::master_test_suite().argv)
  {}

  lamella::MpiSession mpi;
};

BOOST_TEST_GLOBAL_FIXTURE(Session);
