// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/run/command_line.h>

#include <cmath>
#include <filesystem>

namespace lamella
{
  std::string
  usage()
  {
    return R"(usage: lamella SCENE.prm [options]

  --output DIR          where results go (default: results/SCENE)
  --set PATH=VALUE      override an entry, as in
                        --set "Body upper/Kinematics/Theory=LE-3"; repeatable
  --validate            check the scene and print its plies and stiffnesses
  --print-parameters    print all entries (with a scene: as they are resolved)
  --threads N           threads (default 1)
  --version, --help

Exit status: 0 done, 1 a fault of the input, 2 a failure of the numerics.
)";
  }



  CommandLine
  CommandLine::parse(const std::vector<std::string> &words)
  {
    const std::vector<std::string> options{"--output",
                                           "--set",
                                           "--validate",
                                           "--print-parameters",
                                           "--threads",
                                           "--version",
                                           "--help"};
    CommandLine                    result;
    for (unsigned int i = 0; i < words.size(); ++i)
      {
        const std::string &word  = words[i];
        const auto         value = [&]() -> const std::string         &{
          if (i + 1 == words.size())
            throw InputError(word + " needs a value after it.");
          return words[++i];
        };
        if (word == "--output")
          result.output = value();
        else if (word == "--set")
          result.overrides.push_back(value());
        else if (word == "--validate")
          result.validate = true;
        else if (word == "--print-parameters")
          result.print_parameters = true;
        else if (word == "--version")
          result.version = true;
        else if (word == "--help")
          result.help = true;
        else if (word == "--threads")
          {
            const double n = to_number(value(), "--threads");
            if (!(n >= 1. && n <= 1024. && n == std::floor(n)))
              throw InputError("--threads must be a whole number from 1 to "
                               "1024.");
            result.threads = static_cast<unsigned int>(n);
          }
        else if (word.compare(0, 1, "-") == 0)
          throw InputError("there is no option " + word + "; the nearest is " +
                           nearest_name(word, options) + ".");
        else if (result.scene.empty())
          result.scene = word;
        else
          throw InputError("one scene at a time: both '" + result.scene +
                           "' and '" + word + "' are given.");
      }
    const bool needs_scene =
      !result.version && !result.help && !result.print_parameters;
    if (needs_scene && result.scene.empty())
      throw InputError("no scene is given.\n" + usage());
    if (result.output.empty())
      result.output =
        "results/" + std::filesystem::path(result.scene).stem().string();
    return result;
  }
} // namespace lamella
