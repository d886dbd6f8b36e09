// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `scene`: the text of a scene, its grammar, its messages with line,
// entry, value, rule and remedy, and the description of the problem. Other
// rooms define the entries of their subsections; this room combines them. It
// does not run scenes. Start with SceneText (text and line numbers),
// read_scene() (text to Scene) and Simulation (run/simulation.h).

#ifndef lamella_scene_scene_h
#define lamella_scene_scene_h

#include <lamella/base/units.h>
#include <lamella/body/parameters.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/contact/parameters.h>
#include <lamella/recover/measure.h>
#include <lamella/recover/requests.h>
#include <lamella/recover/strength_sweep.h>
#include <lamella/scene/goal_parameters.h>
#include <lamella/scene/scene_text.h>
#include <lamella/scene/trade_parameters.h>
#include <lamella/shape/shapes.h>
#include <lamella/solve/parameters.h>

#include <map>
#include <string>
#include <vector>


namespace lamella
{
  /// Reference values of the resultant forces of supports or contacts, by name.
  using ReferencesByName = std::map<std::string, std::vector<Reference>>;

  /// A boundary value problem with contact as read from a scene file and
  /// checked: materials, cross-sections, bodies (a section extruded along an
  /// axis, with the theory of its displacements), supports, loads, contacts,
  /// solution parameters and output, as plain data.
  ///
  /// Lists are in the order of the lists of names in the file. Bodies are
  /// referred to by their index in `bodies`, materials and sections by name.
  /// All quantities are in the units of the file; positions are in global axes
  /// unless stated otherwise. A scene contains no mesh.
  struct Scene
  {
    /// Title, printed with the results; may be empty.
    std::string title;
    /// Unit labels of results; built-in materials are converted to these units.
    Units units;

    /// Materials by name, with elastic constants in the material's axes.
    Materials materials;
    /// Shape of each section by name, from which the section is meshed.
    std::map<std::string, SectionShape> sections;
    /// Number of uniform refinements of the mesh of each section.
    std::map<std::string, unsigned int> divisions;
    /// Number of refined cell layers at the corners of each section.
    std::map<std::string, unsigned int> corner_layers;
    /// Name, section, theory, axis and placement of each body.
    std::vector<BodyDescription> bodies;

    /// Prescribed displacements at load factor 1.
    std::vector<Support> supports;
    /// Forces at load factor 1, and temperatures.
    std::vector<Load> loads;
    /// Acceleration of gravity at load factor 1 [length / s^2].
    dealii::Tensor<1, 3> gravity;
    /// Rigid surfaces with which bodies may be in contact.
    Obstacles obstacles;
    /// Pairs of surfaces that may be in contact.
    std::vector<ContactPair> contacts;
    /// Parameters of the solution: load factors, strategy, limits.
    SolveParameters solve;

    /// Points, segments and sections at which fields are reported.
    std::vector<Probe> probes;
    std::vector<Line>  lines;
    std::vector<Cut>   cuts;
    /// Differences of values at probes.
    std::vector<Measure> measures;
    /// Plies and strength criteria of the failure analysis.
    StrengthParameters strength;
    /// True if the load factor of first failure is computed.
    bool find_first_failure = false;
    /// Reference values of resultant forces.
    ReferencesByName support_references, contact_references;
    /// True if a run writes VTU files for ParaView.
    bool write_vtu = true;
    /// Quantities of interest of the run, with their tolerances.
    GoalParameters goals;
    /// Parameters of `lamella trade`; unused by a run.
    TradeParameters trade;

    /// Warnings on inaccurate theories and meshes (notes_on_choices()).
    std::vector<std::string> warnings;

    /// Text of a scene file with all entries, defaults included.
    std::string resolved;

    /// Returns the number of uniform refinements of @p section.
    unsigned int
    divisions_of(const std::string &section) const
    {
      const auto known = divisions.find(section);
      return known == divisions.end() ? 0 : known->second;
    }
  };

  /// Parses @p text and returns the scene. Names, repeated pairs of contact
  /// surfaces and problem sizes that exceed the memory are checked. No mesh is
  /// generated and no mesh file is read. Throws InputError with file and line.
  Scene
  read_scene(const SceneText &text);

  /// Throws InputError for unknown entries and subsections of @p text.
  void
  check_entries(const SceneText &text);

  /// Returns a scene file with all entries, their documentation and defaults,
  /// and one subsection NAME of each kind (--print-parameters).
  std::string
  parameter_documentation();

  /// Generates or reads the meshes of all sections of @p scene. Throws
  /// InputError for invalid shapes or mesh files and for distorted cells.
  SectionMeshes
  build_section_meshes(const Scene &scene);
} // namespace lamella

#endif
