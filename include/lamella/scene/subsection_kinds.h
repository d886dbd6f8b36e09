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
  /// The names in each of the lists that a scene begins with, by list.
  using NameLists = std::map<std::string, std::vector<std::string>>;

  /// What the subsections of a scene are read from, and the scene that they
  /// become part of.
  struct SceneReading
  {
    dealii::ParameterHandler &prm;
    const NameLists          &names;
    /// Where the scene's files lie.
    std::string folder;
    /// The scene's Theory, the default of its bodies.
    Entry  theory;
    Scene &scene;
  };

  /**
   * A kind of subsections, `subsection Body NAME` for each NAME of the list
   * `Bodies`: how it is declared and what becomes of it. Whoever adds a kind
   * adds a row to subsection_kinds().
   */
  struct SubsectionKind
  {
    std::string list, kind;
    /// Declares its entries; the handler is in the subsection.
    void (*declare)(dealii::ParameterHandler &prm);
    /// Puts the subsection NAME, of the entries `in`, into the scene. Throws
    /// InputError.
    void (*resolve)(SceneReading      &reading,
                    const std::string &name,
                    const Entries     &in);
    /// What follows from all of its names together; null of most.
    void (*finish)(Scene &scene) = nullptr;
  };

  /// All of them, in the order in which they are listed, printed and resolved.
  const std::vector<SubsectionKind> &
  subsection_kinds();
} // namespace lamella

#endif
