// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_handout_html_h
#define lamella_handout_html_h

#include <string>
#include <vector>

namespace lamella
{
  /**
   * Pieces of a page of HTML. Functions that take plain text escape it; what
   * they return is HTML and goes into others as it is. Nothing refers to
   * anything outside of the page.
   */

  /// @p text as HTML shows it, also within an attribute: `&`, `<`, `>`, `"` and
  /// `'` as references. Bytes that are no UTF-8, and characters that a page
  /// must not have, become U+FFFD.
  std::string
  escaped(const std::string &text);

  /// @p value for people: @p digits significant digits, a minus sign and powers
  /// of ten in Unicode, as in −1.3396·10⁸. Infinities and what is no number are
  /// named as such.
  std::string
  readable(const double value, const int digits = 5);

  /**
   * The number that @p written spells as `<data value="...">`, which keeps all
   * of its digits for programs and shows people readable() ones; a dash for an
   * empty text, the text itself if it is no number. What is below 1e-9 of
   * @p scale, the size of its neighbours, is rounding and is shown as 0.
   */
  std::string
  number(const std::string &written,
         const double       scale  = 0.,
         const int          digits = 5);

  /// The same of a value that is at hand.
  std::string
  number(const double value, const double scale = 0., const int digits = 5);

  /// @p name of a column as a formula: uz as u with the index z, sxy as sigma,
  /// exx as epsilon, gxy as gamma; other names as they are.
  std::string
  symbol(const std::string &name);

  /// `[unit]`, or `[kind]` in a scene whose units have no names.
  std::string
  in_brackets(const std::string &unit, const std::string &kind);

  /// A table, cells and caption in HTML. Cells of numbers stand to the right.
  struct HtmlTable
  {
    /// Names it for links and for programs that read the page.
    std::string              id;
    std::string              caption;
    std::vector<std::string> header;
    /// As many cells each as the header has.
    std::vector<std::vector<std::string>> rows;
    /// Of rows that are to stand out: their numbers, ascending.
    std::vector<unsigned int> marked;
  };

  std::string
  to_html(const HtmlTable &table);

  /// A paragraph of HTML.
  std::string
  paragraph(const std::string &html);

  /// An unordered list; empty for no items.
  std::string
  list(const std::vector<std::string> &items);

  /// The bytes of @p content as a URI of their own, `data:TYPE;base64,...`.
  std::string
  data_uri(const std::string &type, const std::string &content);

  /// The PNG @p content with the caption @p caption, which is HTML.
  std::string
  figure(const std::string &content,
         const std::string &name,
         const std::string &caption);
} // namespace lamella

#endif
