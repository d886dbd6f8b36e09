// SPDX-License-Identifier: LGPL-2.1-or-later

// The room `scene`: the text of a scene and what it means. It owns the grammar,
// the messages that name entry, value, rule and remedy with their line, the
// descriptions that the text is resolved into. What the entries of a subject
// are its own room knows; here they are put together. It never runs anything: a
// scene is data.
//
// Where to start reading: SceneText is the text with its lines, read_scene()
// makes a Scene of it, and Simulation (run/simulation.h) is made of that.

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
  /// References of the resultants of supports or of contacts, by their names:
  /// of fx, fy and fz. A name without any has an empty list.
  using ReferencesByName = std::map<std::string, std::vector<Reference>>;

  /**
   * A scene, read and checked: plain data, names resolved. A boundary value
   * problem with contact in the order in which it is built: what bodies are
   * made of, their cross-sections, the bodies themselves (a section swept along
   * an axis, with the theory that expands the displacements over it), what
   * holds, loads and touches them, how that is solved, and what is asked of the
   * solution.
   *
   * Lists are in the order of the lists of names in the text. Bodies are
   * referred to by their place in `bodies`, materials and sections by name.
   * Lengths, forces and stresses are in the scene's units throughout, positions
   * in its axes unless they say otherwise; nothing is converted later. No mesh
   * is there yet, so a scene is cheap to copy.
   */
  struct Scene
  {
    /// Printed with the results; may be empty.
    std::string title;
    /// Labels of results; the built-in materials are converted to them.
    Units units;

    /// By name, with the elastic constants in the material's axes.
    Materials materials;
    /// By name: what a section mesh is made from.
    std::map<std::string, SectionShape> sections;
    /// By name: how often all cells of the section are divided in four.
    std::map<std::string, unsigned int> divisions;
    /// By name: how many layers of cells lie at the corners of the section.
    std::map<std::string, unsigned int> corner_layers;
    /// Name, section, theory (Eq. 1), axis and placement of each body.
    std::vector<BodyDescription> bodies;

    /// Prescribed displacements, at load factor 1.
    std::vector<Support> supports;
    /// Forces, at load factor 1, and temperatures.
    std::vector<Load> loads;
    /// The acceleration that makes a weight of each density, at load factor 1
    /// [length / s^2].
    dealii::Tensor<1, 3> gravity;
    /// Rigid bodies that contacts refer to.
    Obstacles obstacles;
    /// Pairs of surfaces that may touch; those with an obstacle share it.
    std::vector<ContactPair> contacts;
    /// Load factors, strategy, limits.
    SolveParameters solve;

    /// Points, segments and sections at which fields are reported.
    std::vector<Probe> probes;
    std::vector<Line>  lines;
    std::vector<Cut>   cuts;
    /// Differences of what probes give.
    std::vector<Measure> measures;
    /// Which plies are looked at for failure, by which criteria.
    StrengthParameters strength;
    /// Whether the load at first failure is sought after the load factors.
    bool find_first_failure = false;
    /// What the resultants are compared with; probes have their own.
    ReferencesByName support_references, contact_references;
    /// Whether a run leaves pictures for ParaView.
    bool write_vtu = true;
    /// The numbers that the run is made for, and how exact they are to be.
    GoalParameters goals;
    /// What `lamella trade` is asked; a run does not look at it.
    TradeParameters trade;

    /// What is known to be inaccurate in the choices made, a sentence each
    /// (notes_on_choices()).
    std::vector<std::string> warnings;

    /// The scene as it was run: the text of every entry with its value, from
    /// which read_scene() makes the same scene. A mesh file has its absolute
    /// path in it.
    std::string resolved;

    /// How often the cells of @p section are divided: not at all where nothing
    /// is said.
    unsigned int
    divisions_of(const std::string &section) const
    {
      const auto known = divisions.find(section);
      return known == divisions.end() ? 0 : known->second;
    }
  };

  /**
   * Reads @p text in two passes: the names first (the lists at its top level
   * say which subsections there are), then all entries. Each subsection is
   * parsed by the parameters of its own room; what belongs to several of them
   * is checked here: names that are resolved, surfaces that two contacts pair,
   * sizes that no memory holds. No mesh is made and, but for the paths of mesh
   * files, no other file is looked at: whether a point lies in its body shows
   * when Simulation builds. Throws InputError with the place in the text.
   */
  Scene
  read_scene(const SceneText &text);

  /// Throws InputError for entries and subsections of @p text that no scene
  /// has; their values, but for the lists of names, are not looked at.
  void
  check_entries(const SceneText &text);

  /// All entries with documentation and default, as the text of a scene with
  /// one subsection of each kind, called NAME: what --print-parameters prints
  /// without a scene.
  std::string
  parameter_documentation();

  /// The meshes of all sections of @p scene by name, whether a body has them or
  /// not; bodies share them. Throws InputError for a shape that cannot be
  /// meshed, for a mesh file that cannot be used and for cells that are out of
  /// proportion.
  SectionMeshes
  build_section_meshes(const Scene &scene);
} // namespace lamella

#endif
