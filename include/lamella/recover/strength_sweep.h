// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_recover_strength_sweep_h
#define lamella_recover_strength_sweep_h

#include <lamella/base/entry.h>
#include <lamella/conditions/load.h>
#include <lamella/conditions/support.h>
#include <lamella/recover/face_tractions.h>
#include <lamella/recover/recovery.h>
#include <lamella/recover/results.h>
#include <lamella/shape/section_mesh.h>
#include <lamella/strength/criterion.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lamella
{
  /// The entries of `subsection Strength`: which plies are looked at, by what.
  struct StrengthParameters
  {
    /// None by default: nothing is looked at. No criterion twice.
    std::vector<Criterion> criteria;
    /// Numbers of the scene's bodies, ascending.
    std::vector<unsigned int> bodies;
    /// Two corners each, the lower one first in all coordinates, scene axes.
    std::vector<std::array<dealii::Point<3>, 2>> leave_out;
    /// `recovered` or `equilibrium`.
    StressValues stress = StressValues::recovered;

    /// Declares them in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// @p bodies are the names of the scene's. Throws InputError for criteria
    /// and bodies that are none, with the nearest name, for those that come
    /// twice, and for boxes that are none.
    static StrengthParameters
    parse(const Entries &in, const std::vector<std::string> &bodies);
  };

  /**
   * Reserve factors of all plies, over whole bodies.
   *
   * Of each element the 3 x 3 x 3 Gauss-Lobatto points are looked at: corners,
   * and the middles of edges, faces and element, so that each ply is seen at
   * both of its faces and in its middle. The elements' own stresses come first.
   * Then, for each ply and criterion, the points at which 1/R comes to 0.8 of
   * the ply's largest are looked at again with recovered stresses
   * (StressRecovery, or EquilibriumStress), and that with the smallest reserve
   * factor R stays. So a place is missed only where an element's own stresses
   * are off by a fifth.
   *
   * The interlaminar criterion looks only at faces of elements that lie in the
   * plane of the element's ply and that another ply touches, from either side.
   * A ply whose
   * material has core strengths is a core: core shear and core crushing look at
   * cores alone, all others at what is none, and face wrinkling at plies of a
   * laminate, or of a wall, next to a core.
   *
   * On the way the nearest to failure at each station of a beam's axis is kept,
   * ply by ply, for pictures (ReserveAlong).
   *
   * Cost: an element takes 27 samples of its stress and as many assessments by
   * each criterion, and 5 kB while it is looked at; recovery only where failure
   * is near. Each process looks at its own elements; all get the same rows.
   */
  class StrengthSweep
  {
  public:
    /// @p bodies is referred to. Throws InputError if a material lacks what a
    /// criterion needs, with its entry, and for stresses by equilibrium of a
    /// body that is no laminate. Collective.
    StrengthSweep(const Bodies &bodies, const StrengthParameters &parameters);

    struct Found
    {
      std::vector<PlyReserve>   plies;
      std::vector<ReserveAlong> along;
    };

    /// The rows of StepResults::plies and plies_along for the displacements
    /// @p u, which have a block for each body, and @p tractions that act on
    /// faces. Of heated bodies @p cured are the displacements of heat alone:
    /// their stresses stay, and the reserve factor multiplies what @p u has
    /// beyond them. Collective.
    Found
    sweep(const BlockVector   &u,
          const FaceTractions &tractions = FaceTractions(),
          const BlockVector   *cured     = nullptr) const;

    /// The largest 1/R of ply @p ply of body @p body under @p ply_stress (its
    /// own axes), for pictures; 0 where no R is finite or nothing is looked
    /// at. The interlaminar criterion, which is of interfaces, is left out.
    double
    inverse_reserve(const unsigned int body,
                    const unsigned int ply,
                    const Voigt       &ply_stress) const;

  private:
    /// Into how many parts each element is divided each way for its points.
    static constexpr unsigned int intervals = 2;

    /// What is asked of a ply.
    struct Task
    {
      unsigned int   ply;
      Criterion      criterion;
      FailureSurface surface;
    };

    /// A body with its tasks and what of it never changes.
    struct Swept
    {
      unsigned int      body;
      std::vector<Task> tasks;
      /// Of each element of this process, whether another ply touches its faces
      /// at the beginning and at the end of the first and of the third unit
      /// coordinate, and these lie in its ply's plane. None where no task asks
      /// for it.
      std::vector<std::array<bool, 4>> touched;
    };

    /// The tasks of the plies of @p body, and whether one of them is a core.
    std::vector<Task>
    tasks_of(const Body &body) const;
    /// Throws InputError unless @p ply of @p body has what @p criterion needs.
    void
    require(const Criterion criterion, const Ply &ply, const Body &body) const;

    /// Whether @p task looks at point @p k of an element whose faces are
    /// @p touched.
    static bool
    looks_at(const Task                &task,
             const std::array<bool, 4> &touched,
             const unsigned int         k);
    /// Whether @p x is in a box that is left out.
    bool
    is_left_out(const dealii::Point<3> &x) const;

    /// What is found of a beam along its axis: the largest 1/R by ply and
    /// station.
    class Along;

    /// A body's displacements, with those of heat alone or null.
    struct Displacements
    {
      const Vector &u;
      const Vector *cured;
    };
    /// An element's stresses, and those of heat alone or null; its faces as in
    /// Swept.
    struct SweptCell
    {
      const OutputCell   &loaded;
      const OutputCell   *cured;
      std::array<bool, 4> touched;
    };
    /// The points of a task that may be near to failure.
    class Candidates;
    /// Adds the points of @p cell, of the ply of @p task, to @p along and to
    /// @p candidates.
    void
    look_at(const SweptCell &cell,
            const Task      &task,
            Along           &along,
            Candidates      &candidates) const;
    /// Of each task the points of this process that are near to failure.
    std::vector<std::vector<dealii::Point<3>>>
    near_failure(const Swept         &swept,
                 const Displacements &at,
                 Along               &along) const;
    /// What makes the stresses of a body with the displacements @p u:
    /// recovered fields, and what recovers those of heat alone, or null.
    struct Stresses
    {
      const Vector                                &u;
      std::function<FieldSample(const Location &)> recovered;
      StressRecovery                              *cure;
    };
    /// The worst row of @p task at @p points.
    std::optional<PlyReserve>
    worst_row(const Swept                         &swept,
              const Task                          &task,
              const std::vector<dealii::Point<3>> &points,
              const Stresses                      &stresses) const;
    /// The worst row of each task at its @p points of all processes, if it has
    /// one, to @p plies. Collective.
    void
    add_worst_rows(const Swept                                      &swept,
                   const std::vector<std::vector<dealii::Point<3>>> &points,
                   const Stresses                                   &stresses,
                   std::vector<PlyReserve> &plies) const;

    const Bodies                                &bodies;
    std::vector<Criterion>                       criteria;
    std::vector<std::array<dealii::Point<3>, 2>> leave_out;
    StressValues                                 stress;
    std::vector<Swept>                           all;
  };

  /// Whether @p a is nearer to failure than @p b: by reserve factors, of none
  /// by index, of equal ones (to 1e-7) by place, so that all numbers of
  /// processes find the same row.
  bool
  is_worse(const PlyReserve &a, const PlyReserve &b);

  /// Whether @p a comes before @p b, by x, y, z; coordinates closer than
  /// @p same [length] are equal.
  bool
  comes_before(const dealii::Point<3> &a,
               const dealii::Point<3> &b,
               const double            same);

  /// The worst of @p rows; null if there are none.
  const PlyReserve *
  worst_of(const std::vector<PlyReserve> &rows);

  /**
   * What is to be said of the worst of @p rows, a sentence: that it lies on
   * what @p supports hold or where one of @p loads acts on a line or a point,
   * or that the element's own stress and the recovered one differ by more than
   * a tenth there. In either case the stress may be singular, and its reserve
   * factor fall with each refinement. Empty if there is nothing to say.
   */
  std::string
  doubt_of_worst(const std::vector<PlyReserve> &rows,
                 const std::vector<Support>    &supports,
                 const std::vector<Load>       &loads,
                 const Bodies                  &bodies);
} // namespace lamella

#endif
