// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `scene`: the text of a scene and what it means. It owns the grammar,
// the messages that name entry, value, rule and remedy with their line, the
// descriptions that the text is resolved into, and the bodies made of them. It
// never runs anything: a scene is data.

#ifndef lamella_scene_scene_h
#define lamella_scene_scene_h

#include <lamella/axis/axis.h>
#include <lamella/base/units.h>
#include <lamella/body/hexahedral_mesh.h>
#include <lamella/body/placement.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/stabilisation.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/parameters.h>
#include <lamella/recover/requests.h>
#include <lamella/scene/scene_text.h>
#include <lamella/scene/trade_parameters.h>
#include <lamella/section/theory.h>
#include <lamella/shape/shapes.h>
#include <lamella/solve/parameters.h>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// A body as the scene describes it.
  struct BodyDescription
  {
    std::string   name, section;
    Theory        theory;
    Placement     placement;
    AxisMesh      axis;
    Stabilisation stabilisation;
    /// Of a solid.
    SolidRefinement refinement;
  };

  /// References of a resultant, see ResultantReferences.
  using ReferencesByName = std::map<std::string, std::vector<Reference>>;

  /// A scene, read and checked: plain data, names resolved.
  struct Scene
  {
    std::string title;
    Units       units;

    Materials                           materials;
    std::map<std::string, SectionShape> sections;
    std::vector<BodyDescription>        bodies;

    std::vector<Support>     supports;
    std::vector<Load>        loads;
    Obstacles                obstacles;
    std::vector<ContactPair> contacts;
    SolveParameters          solve;

    std::vector<Probe> probes;
    std::vector<Line>  lines;
    std::vector<Cut>   cuts;
    ReferencesByName   support_references, contact_references;
    bool               write_vtu = true;
    TradeParameters    trade;

    /// What is known to be inaccurate in the choices made, a sentence each.
    std::vector<std::string> warnings;

    /// The scene as it was run, every entry with its value.
    std::string resolved;
  };

  /// Reads @p text in two passes: the names first, then all entries. Throws
  /// InputError with the place in the text.
  Scene
  read_scene(const SceneText &text);

  /// Throws InputError for entries and subsections of @p text that no scene
  /// has; their values are not looked at.
  void
  check_entries(const SceneText &text);

  /// All entries with documentation and default, with one subsection of each
  /// kind, called NAME.
  std::string
  parameter_documentation();

  /// Section meshes by the name of the section.
  using SectionMeshes =
    std::map<std::string, std::shared_ptr<const SectionMesh>>;

  /// The meshes of all sections of @p scene, whether a body has them or not.
  SectionMeshes
  build_section_meshes(const Scene &scene);

  /// The bodies of @p scene on its section meshes @p meshes. Those with the
  /// same section and theory share it.
  Bodies
  build_bodies(const Scene &scene, const SectionMeshes &meshes);
} // namespace lamella

#endif
