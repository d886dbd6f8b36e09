// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/patterns.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cmath>
#include <regex>
#include <sstream>

namespace lamella
{
  namespace patterns
  {
    using namespace dealii::Patterns;

    Double
    number()
    {
      return Double(-largest_number, largest_number);
    }



    Double
    positive()
    {
      return Double(smallest_number, largest_number);
    }



    List
    numbers()
    {
      return List(number());
    }



    List
    numbers(const unsigned int n)
    {
      return List(number(), n, n);
    }



    Whole::Whole(const unsigned int least, const unsigned int most)
      : least(least)
      , most(most)
    {}



    bool
    Whole::match(const std::string &text) const
    {
      if (!number_error(text).rule.empty())
        return false;
      const double value = to_number(text);
      return value >= least && value <= most && value == std::floor(value);
    }



    std::string
    Whole::description(const OutputStyle style) const
    {
      return Integer(least, most).description(style);
    }



    std::unique_ptr<PatternBase>
    Whole::clone() const
    {
      return std::make_unique<Whole>(*this);
    }



    WordOrPattern::WordOrPattern(const std::string &word,
                                 const PatternBase &other)
      : word(word)
      , other(other.clone())
    {}



    bool
    WordOrPattern::match(const std::string &text) const
    {
      return text == word || other->match(text);
    }



    std::string
    WordOrPattern::description(const OutputStyle style) const
    {
      return "[" + word + " or " + other->description(style) + "]";
    }



    std::unique_ptr<PatternBase>
    WordOrPattern::clone() const
    {
      return std::make_unique<WordOrPattern>(*this);
    }



    WordOrPattern
    optional(const PatternBase &other)
    {
      return WordOrPattern("", other);
    }



    namespace
    {
      /// `a, b or c` of `a|b|c`.
      std::string
      alternatives(const std::string &selection)
      {
        std::vector<std::string> names = split(selection, '|');
        const std::string        last  = names.back();
        names.pop_back();
        return names.empty() ? last : joined(names) + " or " + last;
      }



      /// Returns the rule for numbers from @p low to @p high.
      std::string
      rule_of_range(const std::string &low, const std::string &high)
      {
        const double least = std::stod(low);
        if (std::abs(std::stod(high)) < largest_number)
          return "entry.out-of-range: the value must lie between " +
                 to_text(least) + " and " + to_text(std::stod(high)) +
                 " (inclusive)";
        return least > 0. ? "entry.not-positive: the value must be positive" :
                            "entry.is-negative: the value must not be negative";
      }



      /// Throws InputError for a number out of the range of @p pattern.
      [[noreturn]] void
      refuse_range(const Entry &entry, const std::string &pattern)
      {
        std::smatch             part;
        static const std::regex whole(
          "\\[Integer range (\\S+)\\.\\.\\.(\\S+) \\(inclusive\\)\\]"),
          range("\\[Double (\\S+)\\.\\.\\.(\\S+) \\(inclusive\\)\\]");
        if (std::regex_match(pattern, part, whole))
          entry.refuse(
            "entry.not-whole: the value must be a whole number from " +
            part[1].str() + " to " + part[2].str() + " (inclusive)");
        if (std::regex_match(pattern, part, range))
          entry.refuse(rule_of_range(part[1], part[2]));
        entry.refuse("entry.pattern-mismatch: the value must have the form " +
                     pattern + ", in the notation of deal.II's Patterns");
      }



      /// Throws InputError for @p list: pattern of items, least, largest count.
      [[noreturn]] void
      refuse_list(const Entry &entry, const std::smatch &list)
      {
        const std::size_t n = entry.items().size(), least = std::stoul(list[2]);
        if (n < least || n > std::stoul(list[3]))
          {
            if (least == 3)
              entry.point();
            entry.refuse("entry.wrong-count: there are " + std::to_string(n) +
                           " values, but there must be " +
                           std::to_string(least),
                         "Write the values with commas between.");
          }
        entry.numbers();
        refuse_range(entry, list[1]);
      }
    } // namespace



    void
    refuse(const Entry &entry, const std::string &pattern)
    {
      std::smatch             part;
      static const std::regex word_or("\\[(.*?) or (.*)\\]"),
        list("\\[List of <(.*)> of length ([0-9]+)\\.\\.\\.([0-9]+).*\\]"),
        choice("\\[Selection (.*?) ?\\]");
      if (std::regex_match(pattern, part, word_or))
        {
          const std::string word = part[1], other = part[2];
          try
            {
              refuse(entry, other);
            }
          catch (const InputError &error)
            {
              // A fault of spelling stays one, whatever else could stand there.
              const bool is_bound =
                error.rule().rfind("the value must", 0) == 0;
              entry.refuse(error.marked(error.rule()) +
                             (word.empty() || !is_bound ? "" : ", or " + word),
                           error.remedy());
            }
        }
      if (std::regex_match(pattern, part, list))
        refuse_list(entry, part);
      if (std::regex_match(pattern, part, choice))
        entry.refuse(
          "entry.unknown-choice: the value must be one of the words " +
          alternatives(part[1]));
      if (pattern == "[Bool]")
        entry.boolean();
      // Errors of spelling, empty texts and several numbers precede bounds.
      if (pattern.find("[Integer") != 0)
        entry.number();
      refuse_range(entry, pattern);
    }



    void
    refuse(const Entry &entry, const dealii::ParameterHandler &prm)
    {
      std::stringstream json;
      prm.print_parameters(json, dealii::ParameterHandler::JSON);
      boost::property_tree::ptree tree;
      boost::property_tree::read_json(json, tree);
      refuse(entry,
             tree.get<std::string>(boost::property_tree::ptree::path_type(
               entry.path() + "/pattern_description", '/')));
    }
  } // namespace patterns
} // namespace lamella
