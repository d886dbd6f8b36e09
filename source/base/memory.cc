// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/memory.h>
#include <lamella/base/processes.h>
#include <lamella/base/text.h>

#include <deal.II/base/utilities.h>

#include <sys/mman.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    constexpr double unlimited = std::numeric_limits<double>::max();



    Utilities::System::MemoryStats
    memory_of_process()
    {
      Utilities::System::MemoryStats stats;
      Utilities::System::get_memory_stats(stats);
      return stats;
    }



    /// The number after @p key in a file, or alone in it; or else @p otherwise.
    double
    number_in(const std::filesystem::path &path,
              const std::string           &key,
              const double                 otherwise)
    {
      std::ifstream file(path);
      std::string   word;
      while (file >> word)
        if (key.empty() || word == key)
          {
            double value = otherwise;
            if (key.empty())
              file = std::ifstream(path);
            return file >> value ? value : otherwise;
          }
      return otherwise;
    }



    /// Returns the memory that control groups, nested up to @p root, permit.
    double
    memory_left_by_cgroups(const std::string &root,
                           const std::string &group,
                           const std::string &limit,
                           const std::string &usage,
                           const std::string &reclaimable)
    {
      double least = unlimited;
      for (std::filesystem::path path = group;; path = path.parent_path())
        {
          const std::filesystem::path folder =
            root / path.relative_path().lexically_normal();
          const double allowed = number_in(folder / limit, "", unlimited);
          // Files that the system keeps in memory make room when asked.
          if (allowed < unlimited)
            least =
              std::min(least,
                       allowed - number_in(folder / usage, "", 0.) +
                         number_in(folder / "memory.stat", reclaimable, 0.));
          if (!path.has_relative_path())
            return least;
        }
    }



    double
    memory_left_by_cgroups()
    {
      double        least = unlimited;
      std::ifstream groups("/proc/self/cgroup");
      for (std::string line; std::getline(groups, line);)
        {
          const std::string path = line.substr(line.rfind(':') + 1);
          if (line.compare(0, 3, "0::") == 0)
            least = std::min(least,
                             memory_left_by_cgroups("/sys/fs/cgroup",
                                                    path,
                                                    "memory.max",
                                                    "memory.current",
                                                    "inactive_file"));
          else if (line.find(":memory:") != std::string::npos)
            least = std::min(least,
                             memory_left_by_cgroups("/sys/fs/cgroup/memory",
                                                    path,
                                                    "memory.limit_in_bytes",
                                                    "memory.usage_in_bytes",
                                                    "total_inactive_file"));
        }
      return least;
    }
  } // namespace



  double
  resident_memory()
  {
    return 1024. * memory_of_process().VmRSS;
  }



  double
  peak_memory()
  {
    return 1024. * memory_of_process().VmHWM;
  }



  double
  sum_over_machine(const double bytes)
  {
    if (n_processes() == 1)
      return bytes;
    MPI_Comm machine;
    MPI_Comm_split_type(communicator(),
                        MPI_COMM_TYPE_SHARED,
                        this_process(),
                        MPI_INFO_NULL,
                        &machine);
    const double sum = Utilities::MPI::sum(bytes, machine);
    MPI_Comm_free(&machine);
    return sum;
  }



  double
  available_memory(const double limit)
  {
    const double here =
      limit > 0. ?
        limit - sum_over_machine(resident_memory()) :
        std::min(1024. * number_in("/proc/meminfo", "MemAvailable:", unlimited),
                 memory_left_by_cgroups());
    return std::max(0., Utilities::MPI::min(here, communicator()));
  }



  double
  to_bytes(const Entry &entry)
  {
    if (entry.text() == "auto")
      return 0.;
    std::istringstream words(entry.text());
    std::string        number, unit, more;
    words >> number >> unit >> more;
    const double factor = unit == "GB" ? 1e9 : unit == "MB" ? 1e6 : 0.;
    if (factor == 0. || !more.empty() || !(entry.number(number) > 0.))
      entry.refuse("base.invalid-memory: write auto, or a size such as 2 GB");
    return factor * entry.number(number);
  }



  std::string
  gigabytes(const double bytes)
  {
    return to_text(1e-9 * bytes, bytes < 1e9 ? 2 : 3) + " GB";
  }



  void
  require_address_space()
  {
    // What MPI and a first BLAS call take beyond the libraries themselves: a
    // small scene on one thread takes 250 MB, measured.
    constexpr std::size_t least = 300 * 1024 * 1024;
    rlimit                limit;
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
      return;
    void *const trial =
      mmap(nullptr, least, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (trial != MAP_FAILED)
      {
        munmap(trial, least);
        return;
      }
    throw InputError(
      "base.address-space-limited: the address space is limited to " +
      gigabytes(limit.rlim_cur) +
      " (ulimit -v); the program needs, beside its libraries, at least " +
      gigabytes(least) +
      ". Raise this limit, or use the entry Memory limit instead.");
  }
} // namespace lamella
