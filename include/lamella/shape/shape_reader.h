// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_shape_reader_h
#define lamella_shape_shape_reader_h

#include <lamella/base/entry.h>
#include <lamella/shape/shapes.h>

#include <string>
#include <vector>

namespace lamella
{
  /// What the entries of one section are read with: SectionParameters::parse()
  /// in its parts, a function a shape. All of them throw InputError.
  struct ShapeReader
  {
    /// Along a line of a mesh: a slip of a digit must not end in a machine out
    /// of memory.
    static constexpr unsigned int most_in_line = 10000;
    /// Of an ellipse: 49152 cells.
    static constexpr unsigned int most_refinements = 6;

    const Entries &in;
    /// Names that a material may have.
    const std::vector<std::string> &materials;

    /// One a piece between commas, at least one.
    std::vector<double>
    lengths(const std::string &entry) const;
    /// Likewise.
    std::vector<unsigned int>
    counts(const std::string &entry) const;
    /// A single one.
    unsigned int
    count(const std::string &entry) const;

    /// @p name, which stands in @p entry and must be a material.
    std::string
    material(const Entry &entry, const std::string &name) const;
    /// Of a section of one material.
    Fabric
    fabric() const;

    Laminate
    laminate() const;
    HalfDisc
    half_disc() const;
    Ellipse
    ellipse() const;
    Tube
    tube() const;
    /// A box, a double-T, a T, a channel or an angle.
    ThinWalled
    walls(const ShapeKind form) const;
    /// A mesh by Gmsh, whose path is relative to @p folder.
    SectionFile
    file(const std::string &folder) const;
  };

  /// @p items, one for each of @p n plies or one for all, as @p entry gives
  /// them.
  template <typename T>
  std::vector<T>
  one_a_ply(const std::vector<T> &items,
            const unsigned int    n,
            const Entry          &entry)
  {
    if (items.size() == 1)
      return std::vector<T>(n, items[0]);
    if (items.size() != n)
      entry.refuse("there are " + std::to_string(items.size()) +
                     " values for " + std::to_string(n) + " plies",
                   "Give one for all plies or one a ply.");
    return items;
  }
} // namespace lamella

#endif
