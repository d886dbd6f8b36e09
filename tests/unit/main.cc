// SPDX-License-Identifier: LGPL-2.1-or-later

#define BOOST_TEST_MODULE lamella
#include <deal.II/base/mpi.h>

#include <boost/test/unit_test.hpp>

/// Trilinos wants MPI for as long as there are tests.
struct MpiSession
{
  MpiSession()
    : mpi(boost::unit_test::framework::master_test_suite().argc,
          boost::unit_test::framework::master_test_suite().argv,
          1)
  {}

  dealii::Utilities::MPI::MPI_InitFinalize mpi;
};

BOOST_TEST_GLOBAL_FIXTURE(MpiSession);
