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
  /// Entries of `subsection Strength`, which requests reserve factors of plies.
  struct StrengthParameters
  {
    /// Failure criteria, each once; if empty, nothing is evaluated.
    std::vector<Criterion> criteria;
    /// Indices of the bodies to be evaluated, ascending.
    std::vector<unsigned int> bodies;
    /// Boxes without evaluation, as lower and upper corner, scene axes.
    std::vector<std::array<dealii::Point<3>, 2>> excluded_boxes;
    /// Stresses for the reserve factors: `recovered` or `equilibrium`.
    StressValues stress = StressValues::recovered;

    /// Declares the entries of Strength in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the entries of a scene with the bodies named @p bodies. Throws
    /// InputError for unknown or repeated names, and for invalid boxes.
    static StrengthParameters
    parse(const Entries &in, const std::vector<std::string> &bodies);
  };

  /// Evaluates the reserve factors of all plies of whole bodies.
  ///
  /// Element stresses are evaluated at 3 x 3 x 3 Gauss-Lobatto points of each
  /// element, which include both faces and the middle of each ply. For each ply
  /// and criterion, points whose inverse reserve factor 1/R is at least 0.8 of
  /// the ply's largest are evaluated again with recovered stresses
  /// (StressRecovery or EquilibriumStress), and the smallest R is the result.
  /// The critical point is missed only if element stresses err by a fifth.
  ///
  /// The interlaminar criterion uses element faces parallel to the ply that are
  /// interfaces to another ply. A ply whose material has core strengths is a
  /// core. Core shear and core crushing apply to cores, face wrinkling to plies
  /// next to a core, all other criteria to plies that are not cores. An element
  /// costs 27 stress evaluations. Collective.
  class StrengthSweep
  {
  public:
    /// Keeps a reference to @p bodies. Throws InputError for missing material
    /// data, and for `equilibrium` stresses without a laminate. Collective.
    StrengthSweep(const Bodies &bodies, const StrengthParameters &parameters);

    /// Smallest reserve factors of all evaluated bodies.
    struct Found
    {
      std::vector<PlyReserve>   plies; ///< Factors of each ply and criterion.
      std::vector<ReserveAlong> along; ///< Factors of plies along beam axes.
    };

    /// Returns the smallest reserve factors for the displacements @p u and @p
    /// tractions on faces. @p thermal_part, if not null, are those due to
    /// temperature alone; the reserve factor does not multiply their stresses.
    /// Collective.
    Found
    sweep(const BlockVector   &u,
          const FaceTractions &tractions    = FaceTractions(),
          const BlockVector   *thermal_part = nullptr) const;

    /// Returns the largest inverse reserve factor of the ply with index @p ply
    /// of the body with index @p body at the stress @p ply_stress (ply axes),
    /// by all criteria except `interlaminar`; 0 if the ply cannot fail.
    double
    inverse_reserve(const unsigned int body,
                    const unsigned int ply,
                    const Voigt       &ply_stress) const;

  private:
    /// Number of subdivisions of each element in each direction.
    static constexpr unsigned int intervals = 2;

    /// A failure criterion to be evaluated in a ply.
    struct Task
    {
      unsigned int   ply;
      Criterion      criterion;
      FailureSurface surface;
    };

    /// A body with the failure criteria that are evaluated in it.
    struct SweptBody
    {
      unsigned int      body;
      std::vector<Task> tasks;
      /// For each element and its four faces at the ends of the first and third
      /// unit coordinate: true if the face is an interface to another ply.
      /// Empty without interlaminar criterion.
      std::vector<std::array<bool, 4>> touched;
    };

    /// Returns the criteria that apply to each ply of @p body.
    std::vector<Task>
    tasks_of(const Body &body) const;
    /// Throws InputError if @p ply lacks the strengths for @p criterion.
    void
    require(const Criterion criterion, const Ply &ply, const Body &body) const;

    /// Returns true if the criterion @p task is evaluated at point number @p k
    /// (0 to 26) of an element whose faces @p touched are ply interfaces.
    static bool
    uses_point(const Task                &task,
               const std::array<bool, 4> &touched,
               const unsigned int         k);
    /// Returns true if @p x is in an excluded box.
    bool
    is_excluded(const dealii::Point<3> &x) const;

    /// Largest 1/R along the axis of a beam, by ply and position.
    class Along;

    /// Displacements of a body: in total, and due to temperature alone or null.
    struct Displacements
    {
      const Vector &u;
      const Vector *thermal_part;
    };
    /// Stresses of an element: in total, and due to temperature alone (or
    /// null). `touched` is true for faces on ply interfaces.
    struct SweptCell
    {
      const OutputCell   &loaded;
      const OutputCell   *thermal_part;
      std::array<bool, 4> touched;
    };
    /// Points at which a criterion is near its largest inverse reserve factor.
    class Candidates;
    /// Evaluates @p task in @p cell; adds points to @p along and @p candidates.
    void
    evaluate_cell(const SweptCell &cell,
                  const Task      &task,
                  Along           &along,
                  Candidates      &candidates) const;
    /// Returns this process's points nearest to failure, for each criterion.
    std::vector<std::vector<dealii::Point<3>>>
    find_candidates(const SweptBody     &swept,
                    const Displacements &at,
                    Along               &along) const;
    /// Recovered stresses: in total, and due to temperature alone or null.
    struct Stresses
    {
      const Vector                                &u;
      std::function<FieldSample(const Location &)> recovered;
      StressRecovery                              *thermal_recovery;
    };
    /// Returns the smallest reserve factor by @p task at @p points.
    std::optional<PlyReserve>
    worst_row(const SweptBody                     &swept,
              const Task                          &task,
              const std::vector<dealii::Point<3>> &points,
              const Stresses                      &stresses) const;
    /// Adds the smallest reserve factor of each criterion to @p plies, from the
    /// points of all processes. Collective.
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

  /// Returns true if @p a has a smaller reserve factor than @p b. If both have
  /// none, their failure indices are compared. If these values are equal (to
  /// 1e-7), @p a must precede in position (is_before()).
  bool
  is_worse(const PlyReserve &a, const PlyReserve &b);

  /// Returns true if @p a precedes @p b in the order by x, then y, then z.
  /// Coordinates that differ by less than @p same count as equal.
  bool
  is_before(const dealii::Point<3> &a,
            const dealii::Point<3> &b,
            const double            same);

  /// Returns the entry of @p rows that is nearest to failure; null if none.
  const PlyReserve *
  worst_of(const std::vector<PlyReserve> &rows);

  /// Returns a warning if the smallest reserve factor of @p rows is perhaps at
  /// a stress singularity: one of @p supports, or one of @p loads on a line or
  /// a point acts there, or element and recovered stresses differ by more than
  /// a tenth. Otherwise the result is empty.
  std::string
  worst_reserve_warning(const std::vector<PlyReserve> &rows,
                        const std::vector<Support>    &supports,
                        const std::vector<Load>       &loads,
                        const Bodies                  &bodies);
} // namespace lamella

#endif
