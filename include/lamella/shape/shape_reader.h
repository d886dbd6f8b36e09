// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_shape_reader_h
#define lamella_shape_shape_reader_h

#include <lamella/base/entry.h>
#include <lamella/shape/shapes.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Readers of a section's entries, one per shape. All throw InputError.
  struct ShapeReader
  {
    /// Largest number of cells in a mesh line, against typing errors.
    static constexpr unsigned int max_cells_in_line = 10000;
    /// Largest number of refinements of an ellipse: 49152 cells.
    static constexpr unsigned int max_ellipse_refinements = 6;

    const Entries &in;
    /// Names that a material may have.
    const std::vector<std::string> &materials;

    /// Returns the lengths between commas, at least one; not checked for sign.
    std::vector<double>
    lengths(const std::string &entry) const;
    /// Returns the counts between commas, at least one.
    std::vector<unsigned int>
    counts(const std::string &entry) const;
    /// Returns a single count.
    unsigned int
    count(const std::string &entry) const;

    /// Returns @p name in @p entry, which must be a material.
    std::string
    material(const Entry &entry, const std::string &name) const;
    /// Returns the fabric of a section of one material.
    OrientedMaterial
    oriented_material() const;

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

  /// Returns @p items for @p n plies, one each, repeating a single one.
  template <typename T>
  std::vector<T>
  one_per_ply(const std::vector<T> &items,
              const unsigned int    n,
              const Entry          &entry)
  {
    if (items.size() == 1)
      return std::vector<T>(n, items[0]);
    if (items.size() != n)
      entry.refuse("shape.count-of-ply-values: there are " +
                     std::to_string(items.size()) + " values for " +
                     std::to_string(n) + " plies",
                   "Give one for all plies, or one per ply.");
    return items;
  }
} // namespace lamella

#endif
