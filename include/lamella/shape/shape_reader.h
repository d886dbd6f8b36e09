// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_shape_shape_reader_h
#define lamella_shape_shape_reader_h

#include <lamella/base/entry.h>
#include <lamella/shape/shapes.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Parsers of the entries of a section, one for each shape. All functions
  /// throw InputError for invalid entries, named by @p entry.
  struct ShapeReader
  {
    /// Largest number of cells in one direction, to detect typing errors.
    static constexpr unsigned int max_cells_in_line = 10000;
    /// Largest number of refinements of an ellipse, for 49152 cells.
    static constexpr unsigned int max_ellipse_refinements = 6;

    const Entries &in; ///< Entries of the section's subsection.
    /// Names of the materials of the scene.
    const std::vector<std::string> &materials;

    /// Returns the comma-separated lengths of @p entry, at least one.
    std::vector<double>
    lengths(const std::string &entry) const;
    /// Returns the comma-separated numbers of cells of @p entry, at least one.
    std::vector<unsigned int>
    counts(const std::string &entry) const;
    /// Returns the single number of cells of @p entry.
    unsigned int
    count(const std::string &entry) const;

    /// Returns @p name. Throws InputError for @p entry if no material has it.
    std::string
    material(const Entry &entry, const std::string &name) const;
    /// Returns material and fiber angle of a section of a single material.
    OrientedMaterial
    oriented_material() const;

    /// Returns a rectangular laminate.
    Laminate
    laminate() const;
    /// Returns a half disc for Hertzian contact.
    HalfDisc
    half_disc() const;
    /// Returns a solid ellipse.
    Ellipse
    ellipse() const;
    /// Returns a laminated elliptical tube.
    Tube
    tube() const;
    /// Returns a thin-walled section of the shape @p form.
    ThinWalled
    walls(const ShapeKind form) const;
    /// Returns a section meshed by Gmsh. Its path is relative to @p folder.
    SectionFile
    file(const std::string &folder) const;
  };

  /// Returns @p n values, one per ply: @p items, or its only item repeated.
  /// Throws InputError for @p entry if there are neither one nor @p n items.
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
                   "Write one value for all plies, or one for each ply.");
    return items;
  }
} // namespace lamella

#endif
