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
#include <lamella/recover/named_quantity.h>
#include <lamella/recover/requests.h>
#include <lamella/recover/strength_sweep.h>
#include <lamella/scene/find.h>
#include <lamella/scene/goal_parameters.h>
#include <lamella/scene/scene_text.h>
#include <lamella/shape/shapes.h>
#include <lamella/solve/parameters.h>

#include <map>
#include <string>
#include <vector>

namespace lamella
{
  /// Reference values of resultant forces, by the name of support or contact.
  using ReferencesByName = std::map<std::string, std::vector<Reference>>;

  /// The boundary value problem with contact that a scene file describes:
  /// materials, cross-sections, bodies (sections extruded along an axis, with a
  /// beam theory), supports, loads, contacts, solution parameters and output.
  /// It is plain data that has been checked and contains no mesh.
  ///
  /// Vectors have the order of the lists of names in the file. Bodies are
  /// referred to by their index in `bodies`, materials and sections by name.
  /// All quantities are in the units of the file; positions are in global axes
  /// unless stated otherwise.
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
    /// Number of uniform refinements of the mesh of each section, by name.
    std::map<std::string, unsigned int> divisions;
    /// Number of refined cell layers at the corners of each section, by name.
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

    std::vector<Probe> probes; ///< Points at which fields are reported.
    std::vector<Line>  lines;  ///< Segments along which fields are reported.
    std::vector<Cut>   cuts;   ///< Sections on which fields are reported.
    /// Differences of field values between two probes.
    std::vector<Measure> measures;
    /// Plies and strength criteria of the failure analysis.
    StrengthParameters strength;
    /// Analyses after the load steps.
    FindRequest      find;
    ReferencesByName support_references, ///< Reference support forces.
      contact_references; ///< Reference resultants of contact forces.
    /// True if a run writes VTU files for ParaView.
    bool write_vtu = true;
    /// Quantities of interest of the run, with their tolerances.
    GoalParameters goals;
    /// Parameters of `lamella trade`, which compares variants of a scene.
    TradeParameters trade;

    /// Warnings on theories and meshes with known errors (notes_on_choices()).
    std::vector<std::string> warnings;

    /// Text of a scene file with all entries of this scene, defaults included.
    std::string resolved;

    /// Returns the number of uniform refinements of section @p section.
    unsigned int
    divisions_of(const std::string &section) const
    {
      const auto known = divisions.find(section);
      return known == divisions.end() ? 0 : known->second;
    }
  };

  /// Parses @p given and returns the scene. Checks names, repeated pairs of
  /// contact surfaces, and problem sizes against the memory. Generates no mesh
  /// and reads no mesh file. Throws InputError with file and line.
  Scene
  read_scene(const SceneText &given);

  /// Throws InputError for unknown entries and subsections of @p given.
  void
  check_entries(const SceneText &given);

  /// Returns a scene file with all possible entries, their documentation and
  /// default values (--print-parameters). Each kind of subsection occurs once,
  /// with NAME as its name.
  std::string
  parameter_documentation();

  /// Generates the meshes of all sections of @p scene or reads them from files.
  /// Throws InputError for invalid shapes or mesh files and distorted cells.
  SectionMeshes
  build_section_meshes(const Scene &scene);

  /// Returns the subsection (such as `Load push`) of the first support, load or
  /// obstacle of @p scene that has own load factors for the load steps (entry
  /// `Factors`) instead of the common ones; empty if there is none.
  std::string
  first_with_factors(const Scene &scene);

  /// Returns the first contact of @p scene with friction, or a null pointer.
  const ContactPair *
  first_with_friction(const Scene &scene);
} // namespace lamella

#endif
