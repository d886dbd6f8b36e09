// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `scene`: the text of a scene, its grammar, its messages with line,
// entry, value, rule and remedy, and the descriptions that the text becomes.
// Each subject defines its own entries; this room assembles them and does not
// run scenes. Start with SceneText (the text with its lines), read_scene()
// (makes a Scene of it) and Simulation (run/simulation.h, made of a Scene).

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
  /// References of the resultants fx, fy and fz of supports or contacts.
  using ReferencesByName = std::map<std::string, std::vector<Reference>>;

  /**
   * A scene, read and checked: plain data with names resolved. It describes a
   * boundary value problem with contact: materials, cross-sections, bodies (a
   * section swept along an axis, with the theory of its displacements),
   * supports, loads and contacts, solution parameters, and output.
   *
   * Lists have the order of the lists of names in the text. Bodies are referred
   * to by their index in `bodies`, materials and sections by name. All
   * quantities are in the scene's units; positions are in its axes unless
   * stated otherwise. There is no mesh yet: a scene is cheap to copy.
   */
  struct Scene
  {
    /// Title, printed with the results; may be empty.
    std::string title;
    /// Unit labels of results; built-in materials are converted to these units.
    Units units;

    /// Materials by name, with elastic constants in the material's axes.
    Materials materials;
    /// Shapes by name of the section, from which its mesh is made.
    std::map<std::string, SectionShape> sections;
    /// Number of times, by section, that all cells are divided in four.
    std::map<std::string, unsigned int> divisions;
    /// Number of layers of cells at the corners, by section.
    std::map<std::string, unsigned int> corner_layers;
    /// Name, section, theory (Eq. 1), axis and placement of each body.
    std::vector<BodyDescription> bodies;

    /// Prescribed displacements at load factor 1.
    std::vector<Support> supports;
    /// Forces at load factor 1, and temperatures.
    std::vector<Load> loads;
    /// Acceleration that acts on each density, at load factor 1 [length / s^2].
    dealii::Tensor<1, 3> gravity;
    /// Rigid bodies that contacts refer to.
    Obstacles obstacles;
    /// Pairs of surfaces that may be in contact.
    std::vector<ContactPair> contacts;
    /// Load factors, strategy, limits.
    SolveParameters solve;

    /// Points, segments and sections at which fields are reported.
    std::vector<Probe> probes;
    std::vector<Line>  lines;
    std::vector<Cut>   cuts;
    /// Differences of values at probes.
    std::vector<Measure> measures;
    /// Plies and criteria of the failure analysis.
    StrengthParameters strength;
    /// True if the load at first failure is sought after the load factors.
    bool find_first_failure = false;
    /// References of resultants; probes have their own.
    ReferencesByName support_references, contact_references;
    /// True if a run writes VTU files for ParaView.
    bool write_vtu = true;
    /// Goals of the run, with their tolerances.
    GoalParameters goals;
    /// Parameters of `lamella trade`; unused by a run.
    TradeParameters trade;

    /// Known inaccuracies of choices, a sentence each (notes_on_choices()).
    std::vector<std::string> warnings;

    /// Text of all entries with their values as run, for read_scene().
    std::string resolved;

    /// Returns how often the cells of @p section are divided; 0 by default.
    unsigned int
    divisions_of(const std::string &section) const
    {
      const auto known = divisions.find(section);
      return known == divisions.end() ? 0 : known->second;
    }
  };

  /// Returns the scene of @p text. Each subject parses its own subsections.
  /// Names, surfaces that two contacts pair, and sizes that exceed any memory
  /// are checked here. No mesh is made and no file is read (paths of mesh files
  /// are checked). Throws InputError with the place in the text.
  Scene
  read_scene(const SceneText &text);

  /// Throws InputError for entries and subsections of @p text that no scene
  /// has.
  void
  check_entries(const SceneText &text);

  /// Returns all entries with documentation and default, as the text of a scene
  /// with one subsection NAME of each kind (--print-parameters).
  std::string
  parameter_documentation();

  /// Returns the meshes of all sections of @p scene by name. Throws InputError
  /// for shapes or mesh files that cannot be meshed, and distorted cells.
  SectionMeshes
  build_section_meshes(const Scene &scene);
} // namespace lamella

#endif
