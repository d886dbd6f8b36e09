// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/progress.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <optional>
#include <sstream>

BOOST_AUTO_TEST_SUITE(progress)

using namespace lamella;

namespace
{
  /// A terminal that is a string, and a clock set by hand.
  struct Terminal
  {
    std::ostringstream text;
    double             seconds = 0.;
    Progress           progress{text, [this] { return seconds; }};
    std::ostream      &out = progress.output();

    /// What is drawn at the time @p at.
    std::string
    drawn(const double at)
    {
      text.str("");
      seconds = at;
      progress.draw();
      return text.str();
    }
  };



  /// What a terminal shows of @p text: a carriage return goes back to the
  /// beginning of its line. Ends of lines have no blanks.
  std::string
  shown(const std::string &text)
  {
    std::string all, line;
    std::size_t at       = 0;
    const auto  end_line = [&] {
      line.erase(line.find_last_not_of(' ') + 1);
      all += line;
      line.clear();
      at = 0;
    };
    for (const char c : text)
      if (c == '\r')
        at = 0;
      else if (c == '\n')
        {
          end_line();
          all += c;
        }
      else
        {
          line.resize(std::max(line.size(), at + 1), ' ');
          line[at++] = c;
        }
    end_line();
    return all;
  }



  /// The per cents in @p line; -1 if there are none.
  int
  share_in(const std::string &line)
  {
    const auto end = line.find(" %");
    if (end == std::string::npos)
      return -1;
    const auto begin = line.find_last_of(' ', end - 1);
    return std::stoi(line.substr(begin, end - begin));
  }
} // namespace

BOOST_AUTO_TEST_CASE(nothing_early_and_at_most_twice_a_second)
{
  Terminal             terminal;
  const Progress::Part part(terminal.out, "steps", 10.);
  BOOST_TEST(terminal.drawn(2.9) == "");
  BOOST_TEST(terminal.drawn(3.1) == "\r  steps, 4 s so far");
  BOOST_TEST(terminal.drawn(3.5) == "");
  BOOST_TEST(terminal.drawn(3.7) != "");
}

BOOST_AUTO_TEST_CASE(share_and_time_are_those_of_work)
{
  Terminal             terminal;
  const Progress::Part steps(terminal.out, "step", 10.);
  const Progress::Part inner(terminal.out, "factor of upper");
  terminal.seconds = 4.;
  Progress::done(terminal.out, 2.);
  // Two in four seconds; of the sixteen that the others take one has passed.
  BOOST_TEST(terminal.drawn(5.) ==
             "\r  step: factor of upper, 20 %, about 15 s left");
  Progress::expect(terminal.out, -5.);
  BOOST_TEST(terminal.drawn(6.).find("40 %, about 4 s left") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(share_never_falls_and_is_never_above_all)
{
  Terminal             terminal;
  const Progress::Part part(terminal.out, "factors", 1.);
  int                  before = 0;
  double               now    = 4.;
  for (const double more : {0.5, 9., 0., 20., -25., 0.})
    {
      Progress::expect(terminal.out, more);
      Progress::done(terminal.out, 1.);
      const int share = share_in(terminal.drawn(now += 1.));
      BOOST_TEST(share >= before);
      BOOST_TEST(share <= 100);
      before = share;
    }
  BOOST_TEST(before == 100);
}

BOOST_AUTO_TEST_CASE(a_rate_is_handed_on)
{
  Terminal terminal;
  {
    const Progress::Part first(terminal.out, "first", 10.);
    terminal.seconds = 5.;
    Progress::done(terminal.out, 10.);
  }
  const Progress::Part second(terminal.out, "second", 20.);
  BOOST_TEST(terminal.drawn(6.) == "\r  second, about 9 s left");
}

BOOST_AUTO_TEST_CASE(line_is_erased_before_anything_else)
{
  Terminal                      terminal;
  std::optional<Progress::Part> part;
  part.emplace(terminal.out, "a long name of a part of the work", 1.);
  terminal.out << "first\n";
  terminal.seconds = 4.;
  terminal.progress.draw();
  terminal.out << "second\nthird: ";
  BOOST_TEST(shown(terminal.text.str()) == "first\nsecond\nthird:");
  terminal.seconds = 5.;
  terminal.progress.draw();
  BOOST_TEST(shown(terminal.text.str()) ==
             "first\nsecond\nthird: a long name of a part of the work, 5 "
             "s so far");
  // A shorter one leaves nothing of a longer one.
  part.emplace(terminal.out, "short");
  terminal.seconds = 6.;
  terminal.progress.draw();
  BOOST_TEST(shown(terminal.text.str()) ==
             "first\nsecond\nthird: short, 1 s so far");
  terminal.out << 3 << '\n';
  // Nothing to be told: what was drawn goes.
  terminal.seconds = 7.;
  terminal.progress.draw();
  part.reset();
  terminal.seconds = 8.;
  terminal.progress.draw();
  BOOST_TEST(shown(terminal.text.str()) == "first\nsecond\nthird: 3\n");
}

BOOST_AUTO_TEST_CASE(end_of_it_erases_the_line)
{
  std::ostringstream text;
  double             seconds = 0.;
  {
    Progress             progress(text, [&] { return seconds; });
    const Progress::Part part(progress.output(), "work");
    seconds = 4.;
    progress.draw();
    BOOST_TEST(shown(text.str()) == "  work, 4 s so far");
  }
  BOOST_TEST(shown(text.str()) == "");
}

BOOST_AUTO_TEST_CASE(line_fits_a_terminal)
{
  Terminal             terminal;
  const Progress::Part outer(terminal.out, "the outermost part");
  const Progress::Part inner(terminal.out,
                             "factor of " + std::string(45, 'x'),
                             1.);
  // What is inside stays.
  BOOST_TEST(terminal.drawn(4.) ==
             "\r  factor of " + std::string(45, 'x') + ", 4 s so far");
  const Progress::Part longest(terminal.out, std::string(200, 'y'));
  BOOST_TEST(terminal.drawn(5.).size() == 80);
}

BOOST_AUTO_TEST_CASE(other_streams_share_it_or_have_none)
{
  Terminal     terminal;
  std::ostream nowhere(nullptr), other(nullptr);
  nowhere.copyfmt(terminal.out);
  const Progress::Part part(nowhere, "model 2"), none(other, "other");
  Progress::done(other, 1.);
  BOOST_TEST(terminal.drawn(4.) == "\r  model 2, 4 s so far");
}

BOOST_AUTO_TEST_SUITE_END()
