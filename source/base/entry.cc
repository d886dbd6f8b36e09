// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/entry.h>
#include <lamella/base/patterns.h>

#include <algorithm>
#include <cmath>

namespace lamella
{
  Entry::Entry(const std::string &path, const std::string &text)
    : where(path)
    , what(trimmed(text))
  {}



  void
  Entry::refuse(const std::string &rule, const std::string &remedy) const
  {
    throw InputError(where, what, rule, remedy);
  }



  void
  Entry::refuse_missing(const std::string &remedy) const
  {
    throw InputError::missing(where, remedy);
  }



  double
  Entry::number(const std::string &piece) const
  {
    const auto fault = number_error(piece);
    if (!fault.rule.empty())
      refuse(fault.rule, fault.remedy);
    return to_number(piece);
  }



  double
  Entry::number() const
  {
    return number(what);
  }



  double
  Entry::positive() const
  {
    if (is_empty())
      refuse_missing("entry.is-missing: write a positive number, as in 0.5.");
    const double value = number();
    if (!(value > 0.))
      refuse("entry.not-positive: the value must be positive");
    return value;
  }



  std::vector<double>
  Entry::numbers() const
  {
    std::vector<double> values;
    for (const std::string &piece : items())
      values.push_back(number(piece));
    return values;
  }



  std::vector<double>
  Entry::ascending(const double end, const std::string &name) const
  {
    std::vector<double> values   = numbers();
    double              previous = 0.;
    for (const double value : values)
      {
        if (!(value > previous && value < end))
          refuse("entry.not-ascending: values must ascend between 0 and " +
                 name + " (" + to_text(end) + "), as in 0.2, 0.5");
        previous = value;
      }
    return values;
  }



  std::vector<unsigned int>
  Entry::whole_numbers(const unsigned int least, const unsigned int most) const
  {
    std::vector<unsigned int> values;
    for (const double value : numbers())
      {
        if (!(value >= least && value <= most && value == std::floor(value)))
          refuse("entry.not-whole: write whole numbers only, from " +
                 std::to_string(least) + " to " + std::to_string(most) +
                 ", as in 4");
        values.push_back(static_cast<unsigned int>(value));
      }
    return values;
  }



  unsigned int
  Entry::whole(const unsigned int least, const unsigned int most) const
  {
    const std::vector<unsigned int> values = whole_numbers(least, most);
    if (values.size() != 1)
      refuse("entry.not-one-number: write one whole number, as in 4");
    return values[0];
  }



  dealii::Point<3>
  Entry::point(const std::string &piece) const
  {
    const Entry               part(where, piece);
    const std::vector<double> x = part.numbers();
    if (x.size() != 3)
      refuse("entry.not-a-point: " +
             (part.text() == what ? "the value " : "'" + part.text() + "' ") +
             "must be three numbers x, y, z with commas, as in 0, 1, 0.1");
    return {x[0], x[1], x[2]};
  }



  dealii::Point<3>
  Entry::point() const
  {
    return point(what);
  }



  bool
  Entry::boolean() const
  {
    if (what != "true" && what != "false")
      refuse("entry.not-boolean: the value must be true or false");
    return what == "true";
  }



  const std::string &
  Entry::among(const std::vector<std::string> &names,
               const std::string              &kind,
               const std::string              &list) const
  {
    if (std::find(names.begin(), names.end(), what) == names.end())
      refuse("entry.unknown-name: there is no " + kind + " '" + what + "'",
             "Check the spelling: the most similar name in " + list + " is '" +
               nearest_name(what, names) + "'.");
    return what;
  }



  void
  Entry::refuse_choice(const std::string &pattern) const
  {
    patterns::refuse(*this, pattern);
  }



  Entry
  Entries::operator[](const std::string &name) const
  {
    return {subsection.empty() ? name : subsection + "/" + name, prm.get(name)};
  }



  void
  Entries::refuse(const std::string &rule, const std::string &remedy) const
  {
    throw InputError(subsection, "", rule, remedy);
  }
} // namespace lamella
