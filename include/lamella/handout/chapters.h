// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_handout_chapters_h
#define lamella_handout_chapters_h

#include <lamella/handout/pictures.h>
#include <lamella/handout/run_folder.h>

#include <string>
#include <vector>

namespace lamella
{
  /// A part of the page with a heading.
  struct Chapter
  {
    /// For links, and the heading in plain text.
    std::string id, title;
    /// What stands below the heading.
    std::string html;
  };

  /**
   * The chapters of a handout, in the order in which they stand. Each is made
   * from what a run left in its folder, and each is there for every scene:
   * where there is nothing to tell (no contact, no goals) it says so.
   */

  /// Whether the run came to its end, and its main numbers: goals with their
  /// bars, contact forces, the smallest reserve factor, size and seconds.
  Chapter
  glance_chapter(const RunFolder &run);

  /// What the run has warned of, and what else forbids to take its numbers as
  /// they stand: load steps that are missing, goals without a bar or not met,
  /// plies that have failed. Without pictures @p why says what to do.
  Chapter
  warnings_chapter(const RunFolder &run, const std::string &why);

  /// The scene in words: bodies, what holds, loads and touches them, load
  /// steps, materials.
  Chapter
  scene_chapter(const RunFolder &run);

  /// Each section: its plies with angles and thicknesses, its stiffnesses, its
  /// mesh.
  Chapter
  sections_chapter(const RunFolder &run, Pictures &pictures);

  /// Goals with their bars and what these come from, the passes of a run to a
  /// tolerance, and all probes beside the references of the scene.
  Chapter
  numbers_chapter(const RunFolder &run, Pictures &pictures);

  /// The deformed bodies, and fields along lines and over cuts.
  Chapter
  shape_chapter(const RunFolder &run, Pictures &pictures);

  /// Of each contact forces, pressures, how much of it touches, and the places
  /// with the largest pressures.
  Chapter
  contact_chapter(const RunFolder &run, Pictures &pictures);

  /// Reserve factors of the last load step, the smallest first, what governs
  /// each load step, and the load at first failure.
  Chapter
  strength_chapter(const RunFolder &run);

  /// Loads and reactions, all forces on the bodies with their sum, and how they
  /// grow from load step to load step.
  Chapter
  forces_chapter(const RunFolder &run, Pictures &pictures);

  /// What was checked, how far it is off and what would be too far.
  Chapter
  checks_chapter(const RunFolder &run);

  /// DoFs, seconds, memory, version; which fields each node carries.
  Chapter
  costs_chapter(const RunFolder &run, Pictures &pictures);

  /// The tables of the folder, those of moderate size within the page.
  Chapter
  files_chapter(const RunFolder &run);

  /// The command and the whole scene.
  Chapter
  again_chapter(const RunFolder &run);
} // namespace lamella

#endif
