// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>

#include <algorithm>
#include <cctype>
#include <iostream>
#include <new>
#include <numeric>
#include <regex>

namespace lamella
{
  namespace
  {
    /// @p message without what nobody reads: words of hundreds of characters,
    /// longer than any path, are cut in the middle.
    std::string
    shortened_message(const std::string &message)
    {
      constexpr std::size_t longest = 400;
      std::string           result, word;
      const auto            end_word = [&] {
        result += word.size() <= longest ? word : abridged(word);
        word.clear();
      };
      for (const char c : message)
        if (c == ' ' || c == '\n')
          {
            end_word();
            result += c;
          }
        else
          word += c;
      end_word();
      return result;
    }



    /// PATH = VALUE: RULE. REMEDY [ID], without what is not given.
    std::string
    composed(const std::string &path,
             const std::string &value,
             Message            rule,
             const std::string &remedy)
    {
      rule.text = path + (value.empty() ? "" : " = " + value) +
                  (path.empty() ? "" : ": ") + rule.text + "." +
                  (remedy.empty() ? "" : " " + remedy);
      const std::string     whole   = rule.shown();
      constexpr std::size_t longest = 120;
      return value.size() <= longest ? whole :
                                       replaced(whole, value, abridged(value));
    }



    std::size_t
    edit_distance(const std::string &a, const std::string &b)
    {
      const auto same = [](const char p, const char q) {
        return std::tolower(static_cast<unsigned char>(p)) ==
               std::tolower(static_cast<unsigned char>(q));
      };
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 0; i < a.size(); ++i)
        {
          std::size_t diagonal = row[0];
          row[0]               = i + 1;
          for (std::size_t j = 0; j < b.size(); ++j)
            {
              const std::size_t replace = diagonal + (same(a[i], b[j]) ? 0 : 1);
              diagonal                  = row[j + 1];
              row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replace});
            }
        }
      return row.back();
    }
  } // namespace



  Message::Message(const std::string &source)
    : text(source)
  {
    static const std::regex before("([a-z]+\\.[a-z0-9]+(-[a-z0-9]+)*): "),
      behind(" \\[([a-z]+\\.[a-z0-9]+(-[a-z0-9]+)*)\\]");
    std::smatch found;
    if (std::regex_search(
          source, found, before, std::regex_constants::match_continuous))
      text = found.suffix();
    else if (std::regex_search(source, found, behind))
      text = found.prefix().str() + found.suffix().str();
    else
      return;
    identifier = found[1];
  }



  std::string
  Message::shown() const
  {
    return identifier.empty() ? text : text + " [" + identifier + "]";
  }



  InputError::InputError(const std::string &message)
    : std::runtime_error(Message(message).shown())
    , id(Message(message).identifier)
    , rule_text(Message(message).text)
  {}



  InputError::InputError(const std::string &path,
                         const std::string &value,
                         const std::string &rule,
                         const std::string &remedy)
    : std::runtime_error(composed(path, value, Message(rule), remedy))
    , id(Message(rule).identifier)
    , entry_path(path)
    , entry_value(value)
    , rule_text(Message(rule).text)
    , remedy_text(remedy)
  {}



  InputError::InputError(const std::string &shown, const InputError &other)
    : std::runtime_error(shown)
    , id(other.id)
    , entry_path(other.entry_path)
    , entry_value(other.entry_value)
    , rule_text(other.rule_text)
    , remedy_text(other.remedy_text)
    , placed(other.placed)
  {}



  InputError
  InputError::missing(const std::string &path, const std::string &remedy)
  {
    Message    message(remedy);
    InputError error("", InputError(message.text));
    error.id          = message.identifier;
    error.entry_path  = path;
    error.rule_text   = "is missing";
    error.remedy_text = message.text;
    message.text      = path + " is missing: " + message.text;
    return InputError(message.shown(), error);
  }



  InputError
  InputError::at(const std::string &place) const
  {
    InputError error(place + what(), *this);
    error.placed = true;
    return error;
  }



  Outcome
  outcome_of(const std::function<void()> &program)
  {
    try
      {
        program();
      }
    catch (const InputError &error)
      {
        return {1, shortened_message(error.what())};
      }
    catch (const ToleranceNotMet &error)
      {
        return {3, error.what()};
      }
    catch (const NumericsError &error)
      {
        return {2, error.what()};
      }
    catch (const std::bad_alloc &)
      {
        return {2,
                "the scene does not fit in memory. Use a coarser mesh or a "
                "lower order. [run.out-of-memory]"};
      }
    catch (const std::exception &error)
      {
        return {2,
                std::string("internal error, please report it "
                            "[run.internal-error]:\n") +
                  error.what()};
      }
    return {};
  }



  int
  run_and_report(const std::function<void()> &program)
  {
    const Outcome outcome = outcome_of(program);
    if (outcome.status != 0)
      std::cerr << outcome.message << std::endl;
    return outcome.status;
  }



  std::string
  nearest_name(const std::string &name, const std::vector<std::string> &valid)
  {
    const auto nearest =
      std::min_element(valid.begin(),
                       valid.end(),
                       [&name](const auto &a, const auto &b) {
                         return edit_distance(name, a) < edit_distance(name, b);
                       });
    return nearest == valid.end() ? "" : *nearest;
  }
} // namespace lamella
