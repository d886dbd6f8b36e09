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
  /// The entries of `subsection Strength`: plies and criteria to evaluate.
  struct StrengthParameters
  {
    /// Criteria, each once; none (no sweep) by default.
    std::vector<Criterion> criteria;
    /// Numbers of the scene's bodies, ascending.
    std::vector<unsigned int> bodies;
    /// Boxes to leave out: lower and upper corner, scene axes.
    std::vector<std::array<dealii::Point<3>, 2>> excluded_boxes;
    /// Kind of stresses: `recovered` or `equilibrium`.
    StressValues stress = StressValues::recovered;

    /// Declares the entries in the subsection that @p prm is in.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Returns the parameters for a scene with the names @p bodies. Throws
    /// InputError for unknown or repeated names, and for invalid boxes.
    static StrengthParameters
    parse(const Entries &in, const std::vector<std::string> &bodies);
  };

  /**
   * Reserve factors of all plies, over whole bodies.
   *
   * The elements' own stresses are evaluated at 3 x 3 x 3 Gauss-Lobatto points
   * of each element, which include both faces and the middle of each ply. For
   * each ply and criterion, points whose 1/R is at least 0.8 of the ply's
   * largest are evaluated again with recovered stresses (StressRecovery or
   * EquilibriumStress), and the smallest reserve factor R is kept. The critical
   * point is missed only if an element's own stresses are wrong by a fifth.
   *
   * The interlaminar criterion uses faces of elements in the plane of their ply
   * that another ply touches. A ply whose material has core strengths is a
   * core. Core shear and core crushing apply to cores, face wrinkling to plies
   * of a laminate or wall next to a core, all others to plies that are not
   * cores. The largest 1/R at each station of a beam's axis is kept by ply
   * (ReserveAlong). An element costs 27 stress samples and evaluations of each
   * criterion. Processes share the elements; all get the same rows.
   */
  class StrengthSweep
  {
  public:
    /// Stores a reference to @p bodies. Throws InputError for missing material
    /// data, and for equilibrium of a body that is no laminate. Collective.
    StrengthSweep(const Bodies &bodies, const StrengthParameters &parameters);

    struct Found
    {
      std::vector<PlyReserve>   plies;
      std::vector<ReserveAlong> along;
    };

    /// Returns the rows of StepResults::plies and plies_along for the
    /// displacements @p u and @p tractions on faces. @p thermal_part are the
    /// displacements of heat alone: their stresses are constant, and the
    /// reserve factor multiplies the rest. Collective.
    Found
    sweep(const BlockVector   &u,
          const FaceTractions &tractions    = FaceTractions(),
          const BlockVector   *thermal_part = nullptr) const;

    /// Returns the largest 1/R of ply @p ply of body @p body under @p
    /// ply_stress; 0 if no R is finite. Omits the interlaminar criterion.
    double
    inverse_reserve(const unsigned int body,
                    const unsigned int ply,
                    const Voigt       &ply_stress) const;

  private:
    /// Number of subdivisions of each element in each direction.
    static constexpr unsigned int intervals = 2;

    /// A criterion to evaluate on a ply.
    struct Task
    {
      unsigned int   ply;
      Criterion      criterion;
      FailureSurface surface;
    };

    /// A body with its tasks and other data that do not change.
    struct SweptBody
    {
      unsigned int      body;
      std::vector<Task> tasks;
      /// Per element of this process: whether another ply touches its faces at
      /// the ends of the first and the third unit coordinate, and these lie in
      /// its ply's plane; else empty.
      std::vector<std::array<bool, 4>> touched;
    };

    /// Returns the tasks of the plies of @p body, taking account of cores.
    std::vector<Task>
    tasks_of(const Body &body) const;
    /// Throws InputError unless @p ply of @p body has the data of @p criterion.
    void
    require(const Criterion criterion, const Ply &ply, const Body &body) const;

    /// Returns whether @p task uses point @p k with faces @p touched.
    static bool
    uses_point(const Task                &task,
               const std::array<bool, 4> &touched,
               const unsigned int         k);
    /// Returns whether @p x is in a box that is left out.
    bool
    is_excluded(const dealii::Point<3> &x) const;

    /// Largest 1/R of a beam along its axis, by ply and station.
    class Along;

    /// Displacements of a body, and those of heat alone or null.
    struct Displacements
    {
      const Vector &u;
      const Vector *thermal_part;
    };
    /// Stresses of an element, and those of heat alone or null; its faces.
    struct SweptCell
    {
      const OutputCell   &loaded;
      const OutputCell   *thermal_part;
      std::array<bool, 4> touched;
    };
    /// Points of a task that may be near failure.
    class Candidates;
    /// Adds points of @p cell for @p task to @p along and @p candidates.
    void
    evaluate_cell(const SweptCell &cell,
                  const Task      &task,
                  Along           &along,
                  Candidates      &candidates) const;
    /// Returns for each task the points of this process near failure.
    std::vector<std::vector<dealii::Point<3>>>
    find_candidates(const SweptBody     &swept,
                    const Displacements &at,
                    Along               &along) const;
    /// Source of a body's stresses with @p u, and of heat alone or null.
    struct Stresses
    {
      const Vector                                &u;
      std::function<FieldSample(const Location &)> recovered;
      StressRecovery                              *thermal_recovery;
    };
    /// Returns the worst row of @p task at @p points.
    std::optional<PlyReserve>
    worst_row(const SweptBody                     &swept,
              const Task                          &task,
              const std::vector<dealii::Point<3>> &points,
              const Stresses                      &stresses) const;
    /// Adds the worst row of each task at its @p points to @p plies.
    /// Collective.
    void
    add_worst_rows(const SweptBody                                  &swept,
                   const std::vector<std::vector<dealii::Point<3>>> &points,
                   const Stresses                                   &stresses,
                   std::vector<PlyReserve> &plies) const;

    const Bodies                                &bodies;
    std::vector<Criterion>                       criteria;
    std::vector<std::array<dealii::Point<3>, 2>> excluded_boxes;
    StressValues                                 stress;
    std::vector<SweptBody>                       all;
  };

  /// Returns whether @p a is nearer to failure than @p b: by reserve factor,
  /// without one by index, and if equal (to 1e-7) by position.
  bool
  is_worse(const PlyReserve &a, const PlyReserve &b);

  /// Returns whether @p a is before @p b, by x, y, z, equal within @p same.
  bool
  is_before(const dealii::Point<3> &a,
            const dealii::Point<3> &b,
            const double            same);

  /// Returns the worst of @p rows; null if there are none.
  const PlyReserve *
  worst_of(const std::vector<PlyReserve> &rows);

  /// Returns a warning about the worst of @p rows: one of @p supports or of @p
  /// loads on a line or a point acts there, or element and recovered stresses
  /// differ by more than a tenth: perhaps a singularity. Empty without doubt.
  std::string
  worst_reserve_warning(const std::vector<PlyReserve> &rows,
                        const std::vector<Support>    &supports,
                        const std::vector<Load>       &loads,
                        const Bodies                  &bodies);
} // namespace lamella

#endif
