// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/child_process.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/section/theory.h>
#include <lamella/trade/trade_picture.h>

#include <boost/process/search_path.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace lamella
{
  namespace
  {
    using Cost = TradeTable::Cost;

    /// An error of zero has no place on a logarithmic axis.
    constexpr double least_error = 1e-6;

    // Of the picture, in pixels.
    constexpr int width = 1150, row_height = 330, top = 46, bottom = 12;
    // Of the panels, in shares of the width.
    constexpr double left_panel[] = {0.075, 0.43}, right_panel[] = {0.5, 0.855};
    // Of a letter of a name, in shares of a panel.
    constexpr double letter = 0.013;



    /// How the points of a theory look: open and filled mark, colour.
    struct Look
    {
      int         open = 0;
      std::string colour;
    };

    Look
    look_of(const std::string &name)
    {
      using Colours = std::vector<std::string>;
      // From pale to dark with rising order.
      static const Colours taylor{
        "#fdae6b", "#f16913", "#d94801", "#a63603", "#7f2704", "#4d1600"},
        layerwise{"#9ecae1", "#4292c6", "#08519c", "#041f4a"},
        hexahedra{"#74c476", "#006d2c"};
      const auto pick = [](const Colours &colours, const unsigned int order) {
        return colours[std::min<std::size_t>(order, colours.size()) - 1];
      };
      const Theory theory = Theory::parse(name, "Theory");
      switch (theory.kind)
        {
          case Theory::Kind::EBBT:
            return {10, "#b3b3b3"};
          case Theory::Kind::TBT:
            return {8, "#6e6e6e"};
          case Theory::Kind::TE:
            return {6, pick(taylor, theory.order)};
          case Theory::Kind::LE:
            return {4, pick(layerwise, theory.order)};
          default:
            return {12, pick(hexahedra, theory.order)};
        }
    }



    /// The theories of the rungs that have errors, each once, in their order.
    std::vector<std::string>
    theories_of(const TradeTable &table)
    {
      std::vector<std::string> theories;
      for (unsigned int k = 0; k < table.rungs().size(); ++k)
        for (unsigned int q = 0; q < table.quantities().size(); ++q)
          {
            const std::string &theory = table.rungs()[k].theory;
            if (table.has_error(k, q) &&
                std::find(theories.begin(), theories.end(), theory) ==
                  theories.end())
              theories.push_back(theory);
          }
      return theories;
    }



    double
    drawn_error(const TradeTable  &table,
                const unsigned int k,
                const unsigned int q)
    {
      return 100. * std::max(table.error(k, q), least_error);
    }



    /// Decades around all points: least and greatest cost, and error.
    struct Range
    {
      double x_min, x_max, y_min, y_max;
    };

    Range
    range_of(const TradeTable &table, const unsigned int q, const Cost cost)
    {
      Range range{1e300, 0., 1e300, 0.};
      for (unsigned int k = 0; k < table.rungs().size(); ++k)
        if (table.has_error(k, q))
          {
            const double x = table.cost(k, cost), y = drawn_error(table, k, q);
            range.x_min = std::min(range.x_min, x);
            range.x_max = std::max(range.x_max, x);
            range.y_min = std::min(range.y_min, y);
            range.y_max = std::max(range.y_max, y);
          }
      for (const double tolerance : table.tolerances())
        range.y_max = std::max(range.y_max, 100. * tolerance);
      return {range.x_min / 1.6,
              range.x_max * 1.6,
              std::pow(10., std::floor(std::log10(range.y_min) - 0.05)),
              std::pow(10., std::ceil(std::log10(range.y_max) + 0.05))};
    }



    /// The points of the front that have room for their names.
    std::vector<unsigned int>
    named_points(const TradeTable  &table,
                 const unsigned int q,
                 const Cost         cost,
                 const Range       &range)
    {
      const auto share = [](const double a, const double b, const double span) {
        return std::abs(std::log(a / b)) / span;
      };
      const double x_span = std::log(range.x_max / range.x_min),
                   y_span = std::log(range.y_max / range.y_min);
      std::vector<unsigned int> named;
      for (const unsigned int k : table.front(q, cost))
        if (named.empty() ||
            share(table.cost(k, cost), table.cost(named.back(), cost), x_span) >
              letter * (table.rungs()[named.back()].name.size() + 2) ||
            share(drawn_error(table, k, q),
                  drawn_error(table, named.back(), q),
                  y_span) > 0.06)
          named.push_back(k);
      return named;
    }



    /// @p name without what gnuplot would replace or end a string at.
    std::string
    harmless(std::string name)
    {
      name.erase(std::remove_if(name.begin(),
                                name.end(),
                                [](const char c) {
                                  return c == '"' || c == '`' || c == '\\' ||
                                         c == '@';
                                }),
                 name.end());
      return name;
    }



    /// 1, 2 and 5 of the decades between @p low and @p high, or 1 alone where
    /// these are many.
    std::string
    tics(const double low, const double high)
    {
      std::vector<std::string> texts;
      for (int d = std::floor(std::log10(low)); std::pow(10., d) <= high; ++d)
        for (const double m : {1., 2., 5.})
          if (const double x = m * std::pow(10., d);
              x >= low && x <= high && (m == 1. || high < 300. * low))
            texts.push_back(to_text(x, 3));
      return "(" + joined(texts) + ")";
    }



    /// The data of one panel: a block a theory, and those of the front.
    void
    write_data(std::ostream      &gp,
               const TradeTable  &table,
               const unsigned int q,
               const Cost         cost,
               const Range       &range)
    {
      const auto theories = theories_of(table);
      const auto front    = table.front(q, cost);
      const auto point    = [&](const unsigned int k) {
        return to_text(table.cost(k, cost), 8) + " " +
               to_text(drawn_error(table, k, q), 8);
      };
      for (unsigned int t = 0; t < theories.size(); ++t)
        {
          gp << "$theory" << t << " << EOD\n";
          for (unsigned int k = 0; k < table.rungs().size(); ++k)
            if (table.rungs()[k].theory == theories[t] && table.has_error(k, q))
              gp << point(k) << " "
                 << (std::find(front.begin(), front.end(), k) != front.end())
                 << "\n";
          gp << "EOD\n";
        }
      gp << "$front << EOD\n"
         << to_text(table.cost(front.front(), cost), 8) << " " << range.y_max
         << "\n";
      for (const unsigned int k : front)
        gp << point(k) << "\n";
      gp << range.x_max << " "
         << to_text(drawn_error(table, front.back(), q), 8) << "\nEOD\n";
      // Names to the right of their points, where the panel has room.
      std::string                     right, left;
      const std::vector<unsigned int> named =
        named_points(table, q, cost, range);
      for (const unsigned int k : named)
        {
          const std::string &name = table.rungs()[k].name;
          const bool         room =
            std::log(range.x_max / table.cost(k, cost)) >
            letter * name.size() * std::log(range.x_max / range.x_min);
          (room ? right : left) += point(k) + " \"" + harmless(name) + "\"\n";
        }
      gp << "$right << EOD\n"
         << right << "EOD\n$left << EOD\n"
         << left << "EOD\n";
    }



    void
    write_plot(std::ostream &gp, const TradeTable &table)
    {
      const auto theories = theories_of(table);
      gp << "plot $front using 1:2 with steps lc rgb '#c0c0c0' lw 2 notitle";
      for (const double tolerance : table.tolerances())
        gp << ", \\\n  " << 100. * tolerance
           << " with lines dt 3 lc rgb '#505050' notitle";
      for (unsigned int t = 0; t < theories.size(); ++t)
        {
          const Look        look = look_of(theories[t]);
          const std::string style =
            " ps 1.35 lw 1.6 lc rgb '" + look.colour + "'";
          const std::string data = "$theory" + std::to_string(t);
          gp << ", \\\n  " << data << " using ($3==0?$1:NaN):2 with points pt "
             << look.open << style << " notitle, \\\n  " << data
             << " using ($3==1?$1:NaN):2 with points pt " << look.open + 1
             << style << " notitle, \\\n  keyentry with points pt "
             << look.open + 1 << style << " title '" << theories[t] << "'";
        }
      for (const std::string side : {"right", "left"})
        gp << ", \\\n  $" << side << " using 1:2:3 with labels "
           << (side == "right" ? "left offset 0.7,0.5" : "right offset 0.7,0.7")
           << " font ',8' tc rgb '#303030' noenhanced notitle";
      gp << "\n";
    }



    /// The quantities with errors to draw.
    std::vector<unsigned int>
    drawn_quantities(const TradeTable &table)
    {
      std::vector<unsigned int> drawn;
      for (unsigned int q = 0; q < table.quantities().size(); ++q)
        if (!table.front(q, Cost::seconds).empty())
          drawn.push_back(q);
      return drawn;
    }



    int
    picture_height(const TradeTable &table)
    {
      return top + bottom + drawn_quantities(table).size() * row_height;
    }



    /// Quantity @p q in row @p row, counted from the top.
    void
    write_panel(std::ostream      &gp,
                const TradeTable  &table,
                const unsigned int q,
                const unsigned int row,
                const Cost         cost)
    {
      const double  height = picture_height(table);
      const bool    left   = cost == Cost::seconds;
      const double *x      = left ? left_panel : right_panel;
      const double  upper  = 1. - (top + row * row_height + 26) / height,
                   lower   = 1. - (top + (row + 1) * row_height - 54) / height;
      gp << "set lmargin at screen " << x[0] << "\nset rmargin at screen "
         << x[1] << "\nset tmargin at screen " << upper
         << "\nset bmargin at screen " << lower << "\n";
      const Range range = range_of(table, q, cost);
      gp << "set xrange [" << range.x_min << ":" << range.x_max
         << "]\nset xtics " << tics(range.x_min, range.x_max)
         << "\nset yrange [" << range.y_min << ":" << range.y_max << "]\n"
         << "set title '" << table.quantities()[q].label()
         << "' noenhanced offset 0,-0.4\n"
         << "set xlabel '"
         << (left ? "seconds of the whole process" : "degrees of freedom")
         << "' offset 0,0.4\nset ylabel '" << (left ? "error [%]" : "")
         << "'\n";
      // One key for all panels, beside the first row.
      if (row == 0 && !left)
        gp << "set key at screen 0.99, screen " << upper
           << " right top reverse Left\n";
      else
        gp << "unset key\n";
      write_data(gp, table, q, cost, range);
      write_plot(gp, table);
    }



    /// @p text between gnuplot's single quotes, in which nothing is replaced.
    std::string
    quoted(const std::string &text)
    {
      std::string result = "'";
      for (const char c : text)
        result += c == '\'' ? std::string("''") : std::string(1, c);
      return result + "'";
    }
  } // namespace



  std::string
  gnuplot_script(const TradeTable &table, const std::string &title)
  {
    const int          height = picture_height(table);
    std::ostringstream gp;
    gp << "# Draws trade.png, or trade.svg:\n"
          "#   gnuplot -e \"set terminal pngcairo size "
       << width << "," << height
       << "; set output 'trade.png'\" trade.gp\n"
          "set encoding utf8\n"
          "set logscale xy\n"
          "set grid lc rgb '#e6e6e6' lt 1\n"
          "set border 3\n"
          "set tics nomirror\n"
          "set format y '%g'\n"
          "set format x '%g'\n"
          "set multiplot\n"
          "set label 1 "
       << quoted(title) << " noenhanced at screen 0.02, screen "
       << 1. - 22. / height << " font ',13'\n";
    unsigned int row = 0;
    for (const unsigned int q : drawn_quantities(table))
      {
        for (const Cost cost : {Cost::seconds, Cost::dofs})
          {
            write_panel(gp, table, q, row, cost);
            gp << "unset label 1\n";
          }
        ++row;
      }
    gp << "unset multiplot\n";
    return gp.str();
  }



  std::string
  draw_trade(const TradeTable  &table,
             const std::string &title,
             const std::string &directory)
  {
    const std::string script = directory + "/trade.gp";
    std::ofstream     file(script);
    file << gnuplot_script(table, title);
    file.close();
    if (!file)
      throw InputError("Cannot write " + script + ". Is the disk full?");

    const std::string gnuplot = boost::process::search_path("gnuplot").string();
    if (gnuplot.empty())
      return "there is no gnuplot to draw the pictures with: apt-get install "
             "gnuplot-nox, and again";
    for (const auto &[terminal, name] :
         {std::make_pair("pngcairo", "trade.png"),
          std::make_pair("svg", "trade.svg")})
      {
        const std::string set =
          std::string("set terminal ") + terminal + " size " +
          std::to_string(width) + "," + std::to_string(picture_height(table)) +
          " font 'Sans,11' background rgb 'white'; set output " +
          quoted(directory + "/" + name);
        const std::string errors = directory + "/gnuplot.log";
        if (run_process(gnuplot, {"-e", set, script}, "/dev/null", errors)
              .status != 0)
          return "gnuplot could not draw " + script + ", see " + errors;
        std::filesystem::remove(errors);
      }
    return "";
  }
} // namespace lamella
