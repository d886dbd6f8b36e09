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
  /// Names in each list at the top of a scene, by list.
  using NameLists = std::map<std::string, std::vector<std::string>>;

  /// Sources of subsections, and the scene to which they are added.
  struct SceneReading
  {
    dealii::ParameterHandler &prm;
    const NameLists          &names;
    /// Folder of the scene's files.
    std::string folder;
    /// Theory of the scene, the default of its bodies.
    Entry  theory;
    Scene &scene;
  };

  /// A kind of subsections, `subsection Body NAME` for each NAME of the list
  /// `Bodies`: its declaration and its effect on the scene.
  struct SubsectionKind
  {
    std::string list, kind;
    /// Declares the entries; the handler is in the subsection.
    void (*declare)(dealii::ParameterHandler &prm);
    /// Adds the subsection NAME with the entries `in`. Throws InputError.
    void (*resolve)(SceneReading      &reading,
                    const std::string &name,
                    const Entries     &in);
    /// Completes the scene after all names of the kind; usually null.
    void (*finish)(Scene &scene) = nullptr;
  };

  /// Returns all kinds, in the order of listing, printing and resolving.
  const std::vector<SubsectionKind> &
  subsection_kinds();
} // namespace lamella

#endif
