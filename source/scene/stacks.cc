// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/entry.h>
#include <lamella/scene/scene_checks.h>

#include <map>

namespace lamella
{
  namespace
  {
    constexpr unsigned int most_copies = 1000;

    /// Number of copies by body, if more than one.
    using Stacks = std::map<std::string, unsigned int>;



    std::string
    copy_name(const std::string &name, const unsigned int k)
    {
      return name + "-" + std::to_string(k);
    }



    std::vector<std::string>
    copy_names(const std::string &name, const unsigned int n)
    {
      std::vector<std::string> names;
      for (unsigned int k = 1; k <= n; ++k)
        names.push_back(copy_name(name, k));
      return names;
    }



    Entry
    entry(const SceneText &text, const std::string &path)
    {
      return Entry(path, text.says(path).value_or(""));
    }



    /// Replaces @p name in the list @p list by @p copies, and copies the
    /// subsection `KIND NAME`. Throws InputError if a copy's name exists.
    void
    replace_by_copies(SceneText                      &text,
                      const std::string              &list,
                      const std::string              &kind,
                      const std::string              &name,
                      const std::vector<std::string> &copies)
    {
      const Entry              given = entry(text, list);
      std::vector<std::string> names;
      for (const std::string &one : given.items())
        if (one != name)
          names.push_back(one);
        else
          for (const std::string &copy : copies)
            {
              for (const std::string &other : given.items())
                if (copy == other)
                  given.refuse("scene.name-of-copy: '" + copy +
                                 "' is also the name of a copy of " + kind +
                                 " " + name,
                               "Rename one of the two subsections.");
              names.push_back(copy);
            }
      text.replace(list, joined(names));
      std::vector<std::string> paths;
      for (const std::string &copy : copies)
        paths.push_back(kind + " " + copy);
      text.copy_subsection(kind + " " + name, paths);
    }



    /// Returns the numbers @p at + k @p step as text of full precision.
    std::string
    stepped(const std::vector<double> &at,
            const std::vector<double> &step,
            const unsigned int         k)
    {
      constexpr int            digits = 15;
      std::vector<std::string> numbers;
      for (unsigned int c = 0; c < at.size(); ++c)
        numbers.push_back(to_text(at[c] + k * step[c], digits));
      return joined(numbers);
    }



    void
    expand_body(SceneText &text, const std::string &name, const unsigned int n)
    {
      const std::string body   = "Body " + name + "/";
      const auto        triple = [&](const std::string &what) {
        const Entry given = entry(text, body + what);
        if (given.is_empty())
          return std::vector<double>(3, 0.);
        const dealii::Point<3> point = given.point();
        return std::vector<double>{point[0], point[1], point[2]};
      };
      const auto   origin = triple("Origin"), shift = triple("Origin step");
      const Entry  longer = entry(text, body + "Length step");
      const double step   = longer.is_empty() ? 0. : longer.number();
      const double length = entry(text, body + "Length").positive();
      if (length + (n - 1) * step <= 0.)
        longer.refuse("scene.copy-length-not-positive: the last of " +
                        std::to_string(n) +
                        " copies (Copies, Length step) would have the length " +
                        to_text(length + (n - 1) * step),
                      "Write a Length step closer to 0, or fewer Copies.");
      for (const char *const what : {"Copies", "Origin step", "Length step"})
        text.erase(body + what);
      replace_by_copies(text, "Bodies", "Body", name, copy_names(name, n));
      for (unsigned int k = 0; k < n; ++k)
        {
          const std::string copy = "Body " + copy_name(name, k + 1) + "/";
          text.replace(copy + "Origin", stepped(origin, shift, k));
          text.replace(copy + "Length", stepped({length}, {step}, k));
        }
    }



    /// Returns the body in BODY: SURFACE, and the rest from the colon on.
    std::pair<std::string, std::string>
    parts_of_region(const std::string &region)
    {
      const auto colon = region.find(':');
      return {trimmed(region.substr(0, colon)),
              colon == std::string::npos ? "" : region.substr(colon)};
    }



    /// Replaces regions of stacks in the entry @p path by those of all copies.
    void
    expand_regions(SceneText         &text,
                   const std::string &path,
                   const Stacks      &stacks)
    {
      const Entry given = entry(text, path);
      if (given.is_empty())
        return;
      std::vector<std::string> regions;
      bool                     changed = false;
      for (const std::string &region : given.items(';'))
        {
          const auto [body, rest] = parts_of_region(region);
          const auto stack        = stacks.find(body);
          if (stack == stacks.end())
            regions.push_back(region);
          else
            for (const std::string &copy : copy_names(body, stack->second))
              {
                changed = true;
                regions.push_back(copy + rest);
              }
        }
      if (changed)
        text.replace(path, joined(regions, "; "));
    }



    void
    expand_contact(SceneText         &text,
                   const std::string &name,
                   const Stacks      &stacks)
    {
      const std::string path = "Contact " + name + "/";
      const auto first  = parts_of_region(entry(text, path + "First").text()),
                 second = parts_of_region(entry(text, path + "Second").text());
      const bool first_is_stack  = stacks.count(first.first) > 0,
                 second_is_stack = stacks.count(second.first) > 0;
      if (!first_is_stack && !second_is_stack)
        return;
      if (first_is_stack && second_is_stack && first.first != second.first)
        entry(text, path + "Second")
          .refuse("scene.two-stacks: both First and Second have Copies, " +
                    first.first + " and " + second.first,
                  "Write a single copy in First or Second, such as " +
                    copy_name(second.first, 1) + ".");
      const bool         within = first_is_stack && second_is_stack;
      const unsigned int n =
        stacks.at(first_is_stack ? first.first : second.first);
      const auto copies = copy_names(name, within ? n - 1 : n);
      replace_by_copies(text, "Contacts", "Contact", name, copies);
      for (unsigned int k = 1; k <= copies.size(); ++k)
        {
          const std::string copy = "Contact " + copies[k - 1] + "/";
          if (first_is_stack)
            text.replace(copy + "First",
                         copy_name(first.first, k) + first.second);
          if (second_is_stack)
            text.replace(copy + "Second",
                         copy_name(second.first, within ? k + 1 : k) +
                           second.second);
        }
    }
  } // namespace



  void
  expand_stacks(SceneText &text)
  {
    Stacks stacks;
    for (const std::string &body : entry(text, "Bodies").items())
      {
        const std::string  path   = "Body " + body + "/";
        const Entry        copies = entry(text, path + "Copies");
        const unsigned int n =
          copies.is_empty() ? 1 : copies.whole(1, most_copies);
        if (n > 1)
          stacks[body] = n;
        else
          for (const char *const step : {"Origin step", "Length step"})
            if (const Entry given = entry(text, path + step); !given.is_empty())
              given.refuse("scene.step-without-copies: this step is the "
                           "difference between one copy of the body and the "
                           "next, but the body has no Copies",
                           "Write Copies, as in 5, or remove the step.");
      }
    if (stacks.empty())
      return;
    for (const auto &[list, kind] :
         {std::make_pair("Supports", "Support"), {"Loads", "Load"}})
      for (const std::string &name : entry(text, list).items())
        expand_regions(text, std::string(kind) + " " + name + "/On", stacks);
    for (const std::string &name : entry(text, "Contacts").items())
      expand_contact(text, name, stacks);
    for (const auto &[body, n] : stacks)
      expand_body(text, body, n);
  }
} // namespace lamella
