// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_scene_subsection_kinds_h
#define lamella_scene_subsection_kinds_h

#include <lamella/base/entry.h>
#include <lamella/scene/scene.h>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// Names of objects (`upper`) by the entry that lists them (`Bodies`).
  using NameLists = std::map<std::string, std::vector<std::string>>;

  /// Arguments of the functions that parse the subsections of a scene file:
  /// input data, and the scene to which they add the parsed objects.
  struct SceneReading
  {
    dealii::ParameterHandler &prm;   ///< Entries of the scene file.
    const NameLists          &names; ///< Names of all objects.
    /// Folder of the scene file. Paths of mesh files are relative to it.
    std::string folder;
    /// Top-level entry `Theory`, the default theory of all bodies.
    Entry  theory;
    Scene &scene; ///< Result.
  };

  /// A kind of subsections with the functions that declare and parse its
  /// entries. For example, the kind `Body` has a subsection `Body NAME` for
  /// each NAME in the list `Bodies`.
  struct SubsectionKind
  {
    std::string list, ///< Entry with the names of the objects (`Bodies`).
      kind;           ///< First word of the subsections (`Body`).
    /// Declares the entries in @p prm, which has entered such a subsection.
    void (*declare)(dealii::ParameterHandler &prm);
    /// Creates the object @p name from the entries @p in of its subsection and
    /// adds it to reading.scene. Throws InputError for invalid entries.
    void (*resolve)(SceneReading      &reading,
                    const std::string &name,
                    const Entries     &in);
    /// Called after all subsections of this kind were parsed; may be null.
    void (*finish)(Scene &scene) = nullptr;
  };

  /// Returns all kinds of subsections, in the order of printing and parsing.
  const std::vector<SubsectionKind> &
  subsection_kinds();
} // namespace lamella

#endif
