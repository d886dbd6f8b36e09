// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/child_process.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/trade/trade_picture.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace lamella
{
  namespace
  {
    /// trade.py of this folder, as CMake puts it into a string.
    const char *const script_of_pictures =
#include LAMELLA_TRADE_SCRIPT
      ;



    /// trade.py with what only the trade knows. What JSON calls a string, or a
    /// list of numbers, is one to Python, too.
    std::string
    script(const TradeTable &table, const std::string &title)
    {
      std::vector<double> per_cent;
      for (const double tolerance : table.tolerances())
        per_cent.push_back(100. * tolerance);
      std::string text = script_of_pictures;
      text             = replaced(text,
                      "TITLE = \"\"",
                      "TITLE = " + nlohmann::json(title).dump());
      return replaced(text,
                      "TOLERANCES = []",
                      "TOLERANCES = " + nlohmann::json(per_cent).dump());
    }
  } // namespace



  std::string
  draw_trade(const TradeTable  &table,
             const std::string &title,
             const std::string &directory)
  {
    const std::string path = directory + "/trade.py";
    std::ofstream     file(path);
    file << script(table, title);
    file.close();
    if (!file)
      throw InputError("Cannot write " + path + ". Is the disk full?");

    const std::string python = python_with("matplotlib");
    if (python.empty())
      return "there is no python3 with matplotlib to draw them with: apt-get "
             "install python3-matplotlib, and run " +
             path;
    const std::string errors = directory + "/trade.log";
    if (run_process(python, {path}, "/dev/null", errors).status != 0)
      return path + " failed, see " + errors;
    std::filesystem::remove(errors);
    return "";
  }
} // namespace lamella
