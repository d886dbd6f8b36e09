// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/exceptions.h>
#include <lamella/base/output_file.h>

#include <filesystem>

namespace lamella
{
  namespace fs = std::filesystem;

  OutputFile::OutputFile(const std::string &path)
    : path(path)
    , beside(path + ".new")
  {
    std::error_code error;
    const fs::path  folder = fs::path(path).parent_path();
    if (!folder.empty())
      fs::create_directories(folder, error);
    file.open(beside);
  }



  OutputFile::~OutputFile()
  {
    file.close();
    std::error_code error;
    fs::remove(beside, error);
  }



  bool
  OutputFile::commit()
  {
    file.close();
    std::error_code error;
    if (file)
      fs::rename(beside, path, error);
    return file && !error;
  }



  void
  write_file(const std::string &path, const std::string &text)
  {
    OutputFile file(path);
    file.stream() << text;
    if (!file.commit())
      throw_cannot_write(path);
  }



  void
  append_to_file(const std::string &path, const std::string &text)
  {
    std::error_code error;
    const auto      before = fs::file_size(path, error);
    if (error)
      throw_cannot_write(path);
    std::ofstream file(path, std::ios::binary | std::ios::app);
    file << text;
    file.close();
    if (!file)
      {
        fs::resize_file(path, before, error);
        throw_cannot_write(path);
      }
  }



  void
  throw_cannot_write(const std::string &path)
  {
    throw InputError("base.cannot-write: cannot write " + path +
                     ". Check that the disk is not full and that the folder "
                     "still exists. Files written before are complete.");
  }
} // namespace lamella
