// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_base_output_file_h
#define lamella_base_output_file_h

#include <fstream>
#include <string>

namespace lamella
{
  /// A file that is written as PATH.new in the same folder and then renamed, so
  /// that readers never find a part of it. The old file survives failures.
  class OutputFile
  {
  public:
    /// Opens the file and creates the folder of @p path if needed. commit()
    /// returns whether that failed.
    explicit OutputFile(const std::string &path);
    /// Removes a file that was not put in place.
    ~OutputFile();
    OutputFile(const OutputFile &) = delete;

    /// Returns the stream to write to, valid until commit().
    std::ostream &
    stream()
    {
      return file;
    }

    /// Closes the stream and renames the file; call it once. Returns whether
    /// this and all writing succeeded.
    bool
    commit();

  private:
    /// Final path, and path during writing.
    std::string   path, beside;
    std::ofstream file;
  };

  /// Writes @p text into the file @p path by an OutputFile. Throws InputError
  /// if it fails.
  void
  write_file(const std::string &path, const std::string &text);

  /// Appends @p text to the existing file @p path. Throws InputError on
  /// failure, and truncates the file to its old length.
  void
  append_to_file(const std::string &path, const std::string &text);

  /// Throws InputError: @p path cannot be written, with the system's reason.
  [[noreturn]] void
  throw_cannot_write(const std::string &path);
} // namespace lamella

#endif
