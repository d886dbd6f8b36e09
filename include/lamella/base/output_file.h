// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_output_file_h
#define lamella_base_output_file_h

#include <fstream>
#include <string>

namespace lamella
{
  /// An output file that is written as PATH.new and finally renamed to PATH.
  /// The file PATH is thus never incomplete, and is unchanged if writing fails.
  class OutputFile
  {
  public:
    /// Opens the file PATH.new, where PATH is @p path, and creates its folder
    /// if needed. commit() reports failures.
    explicit OutputFile(const std::string &path);
    /// Removes the file PATH.new unless commit() has renamed it to PATH.
    ~OutputFile();
    OutputFile(const OutputFile &) = delete;

    /// Returns the stream that writes to the file. It is valid until commit().
    std::ostream &
    stream()
    {
      return file;
    }

    /// Closes the stream and renames the file PATH.new to PATH. Returns true if
    /// opening, writing and renaming succeeded. Must be called only once.
    bool
    commit();

  private:
    /// Path PATH of the file, and its path PATH.new during writing.
    std::string   path, beside;
    std::ofstream file;
  };

  /// Writes @p text to the file @p path, which is replaced if it exists (see
  /// OutputFile). Throws InputError if writing fails.
  void
  write_file(const std::string &path, const std::string &text);

  /// Appends @p text to the existing file @p path. If this fails, truncates the
  /// file to its old length and throws InputError.
  void
  append_to_file(const std::string &path, const std::string &text);

  /// Throws InputError, with the message that @p path cannot be written.
  [[noreturn]] void
  throw_cannot_write(const std::string &path);
} // namespace lamella

#endif
