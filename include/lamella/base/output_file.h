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
   * way, what stood there before stays. A reader (a script, ParaView, a run
   * that goes on after a step) therefore never meets half a file. Beside means
   * PATH.new, in the same folder, so that the system can rename it in one go.
   */
  class OutputFile
  {
  public:
    /// Makes the folder of @p path where there is none. Throws nothing: what
    /// cannot be opened fails in put_in_place().
    explicit OutputFile(const std::string &path);
    /// Removes what was not put in place. So a file that is given up, or left
    /// by an exception, leaves no trace.
    ~OutputFile();
    OutputFile(const OutputFile &) = delete;

    /// To write to; good until put_in_place().
    std::ostream &
    stream()
    {
      return file;
    }

    /// Puts the file in its place; whether that and all writing succeeded.
    /// Closes the stream; call it once. On failure the old file still stands
    /// there.
    bool
    put_in_place();

  private:
    /// Where the file is to stand, and where it is written until then.
    std::string   path, beside;
    std::ofstream file;
  };

  /// Writes @p text into the file @p path. Throws InputError if it cannot. By
  /// an OutputFile, so whole or not at all; makes its folder.
  void
  write_file(const std::string &path, const std::string &text);

  /// Adds @p text to the end of the file @p path, whole: throws InputError if
  /// that fails, and leaves the file as it was. The file must exist. It is cut
  /// back to its old length if writing fails.
  void
  append_to_file(const std::string &path, const std::string &text);

  /// InputError for a file that could not be written, with the system's reason.
  [[noreturn]] void
  fail_to_write(const std::string &path);
} // namespace lamella

#endif
