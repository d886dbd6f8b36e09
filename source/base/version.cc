// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/version.h>

#include <deal.II/base/config.h>

#include <Trilinos_version.h>
#include <cholmod.h>
#include <dlfcn.h>
#include <dmumps_c.h>
#include <p4est_config.h>

#include LAMELLA_COMMIT_HEADER

namespace lamella
{
  namespace
  {
    /// OpenBLAS says its version and the processor's kernels; others nothing.
    std::string
    blas()
    {
      using Config = char *();
      const auto config =
        reinterpret_cast<Config *>(dlsym(RTLD_DEFAULT, "openblas_get_config"));
      return config == nullptr ? "not OpenBLAS" : config();
    }



    std::string
    version_of_cholmod()
    {
      int numbers[3];
      ::cholmod_version(numbers);
      return std::to_string(numbers[0]) + "." + std::to_string(numbers[1]) +
             "." + std::to_string(numbers[2]);
    }
  } // namespace



  std::string
  version()
  {
    return LAMELLA_VERSION;
  }



  std::string
  full_version()
  {
    return "lamella " + version() + " (commit " LAMELLA_COMMIT ")\n" +
           "deal.II   " DEAL_II_PACKAGE_VERSION "\n" + "CHOLMOD   " +
           version_of_cholmod() + "\n" + "MUMPS     " MUMPS_VERSION "\n" +
           "Trilinos  " TRILINOS_VERSION_STRING "\n" +
           "p4est     " P4EST_PACKAGE_VERSION "\n" + "BLAS      " + blas() +
           "\n" + "compiler  " __VERSION__ "\n";
  }
} // namespace lamella
