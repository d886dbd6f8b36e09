// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `scene`: the text of a scene and its meaning. It owns the grammar,
// the messages with line, entry, value, rule and remedy, and the descriptions
// that the text is resolved into. Each subject defines its own entries; this
// room assembles them. A scene is data: this room never runs it.
//
// Start with SceneText (the text with its lines), read_scene() (makes a Scene
// of it) and Simulation (run/simulation.h, made of a Scene).

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
  /// References of the resultants fx, fy and fz of supports or contacts, by
  /// name; an empty list for a name without any.
  using ReferencesByName = std::map<std::string, std::vector<Reference>>;

  /**
   * A scene, read and checked: plain data with names resolved. It describes a
   * boundary value problem with contact in the order in which it is built:
   * materials, cross-sections, bodies (a section swept along an axis, with the
   * theory that expands the displacements over it), supports, loads and
   * contacts, solution parameters, and requested output.
   *
   * Lists have the order of the lists of names in the text. Bodies are
   * referred to by their place in `bodies`, materials and sections by name.
   * All quantities are in the scene's units and never converted later;
   * positions are in its axes unless stated otherwise. There is no mesh yet: a
   * scene is cheap to copy.
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
    /// Pairs of surfaces that may touch; pairs share obstacles.
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

    /// Known inaccuracies of the choices made, a sentence each
    /// (notes_on_choices()).
    std::vector<std::string> warnings;

    /// Text of all entries with their values as run, from which read_scene()
    /// makes the same scene. Paths of mesh files are absolute.
    std::string resolved;

    /// Returns how often the cells of @p section are divided; 0 by default.
    unsigned int
    divisions_of(const std::string &section) const
    {
      const auto known = divisions.find(section);
      return known == divisions.end() ? 0 : known->second;
    }
  };

  /// Returns the scene of @p text. Names are read first (the lists at its top
  /// level define the subsections), then all entries. Each subject parses its
  /// own subsections; checked here are names, surfaces that two contacts pair,
  /// and sizes that exceed any memory. No mesh is made and no file is read
  /// (paths of mesh files are checked): Simulation finds out whether a point is
  /// in its body. Throws InputError with the place in the text.
  Scene
  read_scene(const SceneText &text);

  /// Throws InputError for entries and subsections of @p text that no scene
  /// has. Values, except the lists of names, are not checked.
  void
  check_entries(const SceneText &text);

  /// Returns all entries with documentation and default, as the text of a scene
  /// with one subsection NAME of each kind (--print-parameters without a
  /// scene).
  std::string
  parameter_documentation();

  /// Returns the meshes of all sections of @p scene by name, used or not;
  /// bodies share them. Throws InputError for shapes that cannot be meshed,
  /// mesh files that cannot be used, and distorted cells.
  SectionMeshes
  build_section_meshes(const Scene &scene);
} // namespace lamella

#endif
