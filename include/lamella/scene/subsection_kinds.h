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
  /// Names in each list of names of a scene (`Bodies`, `Supports`, ...).
  using NameLists = std::map<std::string, std::vector<std::string>>;

  /// Input of the functions that parse subsections of a scene file, and the
  /// scene to which these functions add their results.
  struct SceneReading
  {
    dealii::ParameterHandler &prm;
    const NameLists          &names;
    /// Folder of the scene file, to which paths of mesh files are relative.
    std::string folder;
    /// Top-level entry `Theory`, the default for all bodies.
    Entry  theory;
    Scene &scene;
  };

  /// A kind of subsections, such as `subsection Body NAME` for each NAME of the
  /// list `Bodies`, with the functions that declare and parse its entries.
  struct SubsectionKind
  {
    std::string list, kind;
    /// Declares the entries in @p prm, which is in the subsection.
    void (*declare)(dealii::ParameterHandler &prm);
    /// Adds the object @p name with the entries @p in to the scene. Throws
    /// InputError for invalid entries.
    void (*resolve)(SceneReading      &reading,
                    const std::string &name,
                    const Entries     &in);
    /// Called after the last subsection of the kind; may be null.
    void (*finish)(Scene &scene) = nullptr;
  };

  /// Returns all kinds, in the order in which they are printed and parsed.
  const std::vector<SubsectionKind> &
  subsection_kinds();
} // namespace lamella

#endif
