// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/text.h>
#include <lamella/handout/html.h>

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lamella
{
  namespace
  {
    const std::string replacement = "\xef\xbf\xbd";



    /// @p text with U+FFFD for what is no UTF-8.
    std::string
    in_utf8(const std::string &text)
    {
      using nlohmann::json;
      const std::string quoted =
        json(text).dump(-1, ' ', false, json::error_handler_t::replace);
      return json::parse(quoted).get<std::string>();
    }



    /// @p n as it stands in an exponent.
    std::string
    raised(const std::string &n)
    {
      static const std::vector<std::string> digits{
        "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
      std::string text;
      for (const char c : n)
        text += c == '-' ? "⁻" : digits[c - '0'];
      return text;
    }



    bool
    spells_number(const std::string &text, double &value)
    {
      const char *end  = text.data() + text.size();
      const auto  read = std::from_chars(text.data(), end, value);
      return read.ec == std::errc() && read.ptr == end;
    }
  } // namespace



  std::string
  escaped(const std::string &text)
  {
    std::string result;
    for (const char c : in_utf8(text))
      switch (c)
        {
          case '&':
            result += "&amp;";
            break;
          case '<':
            result += "&lt;";
            break;
          case '>':
            result += "&gt;";
            break;
          case '"':
            result += "&quot;";
            break;
          case '\'':
            result += "&#39;";
            break;
          default:
            {
              const auto byte = static_cast<unsigned char>(c);
              const bool shown =
                (byte >= 0x20 && byte != 0x7f) || c == '\n' || c == '\t';
              result += shown ? std::string(1, c) : replacement;
            }
        }
    return result;
  }



  std::string
  readable(const double value, const int digits)
  {
    if (!std::isfinite(value))
      return std::isnan(value) ? "not a number" :
             value > 0.        ? "infinite" :
                                 "−infinite";
    const std::string plain = to_text(value, digits);
    const auto        e     = plain.find('e');
    std::string       text  = plain.substr(0, e);
    if (e != std::string::npos)
      text += "·10" + raised(std::to_string(std::stoi(plain.substr(e + 1))));
    return text[0] == '-' ? "−" + text.substr(1) : text;
  }



  std::string
  number(const std::string &written, const double scale, const int digits)
  {
    double value = 0.;
    if (written.empty())
      return "–";
    if (!spells_number(written, value))
      return escaped(written);
    const bool is_rounding = std::abs(value) < 1e-9 * scale;
    return "<data value=\"" + escaped(written) + "\">" +
           readable(is_rounding ? 0. : value, digits) + "</data>";
  }



  std::string
  number(const double value, const double scale, const int digits)
  {
    return number(to_text(value, 15), scale, digits);
  }



  std::string
  symbol(const std::string &name)
  {
    if (name.size() < 2)
      return name.empty() ? name : "<i>" + escaped(name) + "</i>";
    const auto of = [&name](const std::string &indices) {
      return std::all_of(name.begin() + 1,
                         name.end(),
                         [&indices](const char c) {
                           return indices.find(c) != std::string::npos;
                         });
    };
    const auto with_index = [&name](const std::string &letter) {
      return "<i>" + letter + "</i><sub>" + name.substr(1) + "</sub>";
    };
    if (name.size() == 2 && of("xyz") && (name[0] == 'u' || name[0] == 'f'))
      return with_index(name[0] == 'u' ? "u" : "F");
    if (name.size() == 2 && of("xyz") && name[0] == 'm')
      return with_index("M");
    if (name.size() == 3 && (of("xyz") || of("123")))
      {
        if (name[0] == 's')
          return with_index("σ");
        if (name[0] == 'e')
          return with_index("ε");
        if (name[0] == 'g')
          return with_index("γ");
      }
    return escaped(name);
  }



  std::string
  in_brackets(const std::string &unit, const std::string &kind)
  {
    return "[" + escaped(unit.empty() ? kind : unit) + "]";
  }



  std::string
  to_html(const HtmlTable &table)
  {
    std::string html =
      "<div class=\"wide\"><table id=\"table-" + escaped(table.id) + "\">\n";
    if (!table.caption.empty())
      html += "<caption>" + table.caption + "</caption>\n";
    html += "<thead><tr>";
    for (const std::string &cell : table.header)
      html += "<th scope=\"col\">" + cell + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (unsigned int k = 0; k < table.rows.size(); ++k)
      {
        const bool marked =
          std::binary_search(table.marked.begin(), table.marked.end(), k);
        html += marked ? "<tr class=\"marked\">" : "<tr>";
        for (const std::string &cell : table.rows[k])
          {
            // One number and nothing else, or none.
            const bool is_number =
              cell == "–" || (cell.compare(0, 5, "<data") == 0 &&
                              cell.find("</data>") == cell.size() - 7);
            html +=
              (is_number ? "<td class=\"number\">" : "<td>") + cell + "</td>";
          }
        html += "</tr>\n";
      }
    return html + "</tbody></table></div>\n";
  }



  std::string
  paragraph(const std::string &html)
  {
    return "<p>" + html + "</p>\n";
  }



  std::string
  list(const std::vector<std::string> &items)
  {
    if (items.empty())
      return "";
    std::string html = "<ul>\n";
    for (const std::string &item : items)
      html += "<li>" + item + "</li>\n";
    return html + "</ul>\n";
  }



  std::string
  data_uri(const std::string &type, const std::string &content)
  {
    return "data:" + type + ";base64," +
           dealii::Utilities::encode_base64({content.begin(), content.end()});
  }



  std::string
  figure(const std::string &content,
         const std::string &name,
         const std::string &caption)
  {
    return "<figure><img alt=\"" + escaped(name) + "\" src=\"" +
           data_uri("image/png", content) + "\"><figcaption>" + caption +
           "</figcaption></figure>\n";
  }
} // namespace lamella
