// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_output_file_h
#define lamella_base_output_file_h

#include <fstream>
#include <string>

namespace lamella
{
  /**
   * A file that is there whole or not at all: it is written beside its place
   * and renamed into it at the end. Until then, and if anything fails on the
   * way, what stood there before stays.
   */
  class OutputFile
  {
  public:
    /// Makes the folder of @p path where there is none.
    explicit OutputFile(const std::string &path);
    /// Removes what was not put in place.
    ~OutputFile();
    OutputFile(const OutputFile &) = delete;

    std::ostream &
    stream()
    {
      return file;
    }

    /// Puts the file in its place; whether that and all writing succeeded.
    bool
    put_in_place();

  private:
    std::string   path, beside;
    std::ofstream file;
  };

  /// Writes @p text into the file @p path. Throws InputError if it cannot.
  void
  write_file(const std::string &path, const std::string &text);

  /// Adds @p text to the end of the file @p path, whole: throws InputError if
  /// that fails, and leaves the file as it was.
  void
  append_to_file(const std::string &path, const std::string &text);

  /// InputError for a file that could not be written, with the system's reason.
  [[noreturn]] void
  fail_to_write(const std::string &path);
} // namespace lamella

#endif
