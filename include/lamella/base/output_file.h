// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_output_file_h
#define lamella_base_output_file_h

#include <fstream>
#include <string>

namespace lamella
{
  /// An output file that is written as PATH.new and finally renamed to PATH, so
  /// that PATH is never incomplete. If writing fails, the old PATH remains.
  class OutputFile
  {
  public:
    /// Opens the file PATH.new and creates the folder of @p path if needed.
    /// Failures are reported by commit().
    explicit OutputFile(const std::string &path);
    /// Removes PATH.new if commit() has not renamed it.
    ~OutputFile();
    OutputFile(const OutputFile &) = delete;

    /// Returns the output stream, which is valid until commit().
    std::ostream &
    stream()
    {
      return file;
    }

    /// Closes the stream and renames the file; must be called only once.
    /// Returns whether opening, writing and renaming succeeded.
    bool
    commit();

  private:
    /// Final path of the file, and its path PATH.new during writing.
    std::string   path, beside;
    std::ofstream file;
  };

  /// Writes @p text into the file @p path by an OutputFile. Throws InputError
  /// if writing fails.
  void
  write_file(const std::string &path, const std::string &text);

  /// Appends @p text to the existing file @p path. Throws InputError on
  /// failure, and truncates the file to its old length.
  void
  append_to_file(const std::string &path, const std::string &text);

  /// Throws InputError with the message that the file @p path cannot be written
  /// and the reason from the operating system.
  [[noreturn]] void
  throw_cannot_write(const std::string &path);
} // namespace lamella

#endif
