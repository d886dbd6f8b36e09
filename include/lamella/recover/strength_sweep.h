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
  /// Entries of `subsection Strength`: failure criteria and plies.
  struct StrengthParameters
  {
    /// Failure criteria, each once; by default none: no evaluation.
    std::vector<Criterion> criteria;
    /// Numbers of the bodies to be evaluated, ascending.
    std::vector<unsigned int> bodies;
    /// Boxes that are excluded: lower and upper corner, scene axes.
    std::vector<std::array<dealii::Point<3>, 2>> excluded_boxes;
    /// Stresses for the reserve factors: `recovered` or `equilibrium`.
    StressValues stress = StressValues::recovered;

    /// Declares the entries in the current subsection of @p prm.
    static void
    declare(dealii::ParameterHandler &prm);

    /// Reads the parameters for a scene with bodies of the names @p bodies.
    /// Throws InputError for unknown or repeated names, and for invalid boxes.
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
  /// of a laminate or wall adjacent to a core, all other criteria to plies that
  /// are not cores. The largest 1/R along a beam's axis is stored by ply
  /// (ReserveAlong). An element costs 27 stress evaluations. Collective.
  class StrengthSweep
  {
  public:
    /// Keeps a reference to @p bodies. Throws InputError for missing material
    /// data, and for `equilibrium` stresses without a laminate. Collective.
    StrengthSweep(const Bodies &bodies, const StrengthParameters &parameters);

    struct Found
    {
      std::vector<PlyReserve>   plies;
      std::vector<ReserveAlong> along;
    };

    /// Returns StepResults::plies and plies_along for the displacements @p u
    /// and @p tractions on faces. @p thermal_part are the displacements due to
    /// heat alone. Their stresses are constant; the reserve factor multiplies
    /// only the remaining stresses. Collective.
    Found
    sweep(const BlockVector   &u,
          const FaceTractions &tractions    = FaceTractions(),
          const BlockVector   *thermal_part = nullptr) const;

    /// Returns the largest 1/R of ply @p ply of body @p body for the stress
    /// @p ply_stress; 0 if no R is finite. Omits the interlaminar criterion.
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
      /// For each element of this process: true if its face at the ends of the
      /// first and the third unit coordinate is parallel to the ply and an
      /// interface to another ply; else empty.
      std::vector<std::array<bool, 4>> touched;
    };

    /// Returns the criteria for the plies of @p body, with regard to cores.
    std::vector<Task>
    tasks_of(const Body &body) const;
    /// Throws InputError if @p ply lacks the strengths for @p criterion.
    void
    require(const Criterion criterion, const Ply &ply, const Body &body) const;

    /// Returns true if @p task applies to point @p k with interfaces
    /// @p touched.
    static bool
    uses_point(const Task                &task,
               const std::array<bool, 4> &touched,
               const unsigned int         k);
    /// Returns true if @p x is in an excluded box.
    bool
    is_excluded(const dealii::Point<3> &x) const;

    /// Largest 1/R along the axis of a beam, by ply and position.
    class Along;

    /// Displacements of a body, and displacements due to heat alone or null.
    struct Displacements
    {
      const Vector &u;
      const Vector *thermal_part;
    };
    /// An element: its stresses, stresses due to heat alone (or null), and
    /// flags of faces on ply interfaces (SweptBody::touched).
    struct SweptCell
    {
      const OutputCell   &loaded;
      const OutputCell   *thermal_part;
      std::array<bool, 4> touched;
    };
    /// Points of a criterion that may be near failure.
    class Candidates;
    /// Adds points of @p cell for @p task to @p along and @p candidates.
    void
    evaluate_cell(const SweptCell &cell,
                  const Task      &task,
                  Along           &along,
                  Candidates      &candidates) const;
    /// Returns this process's points near failure for each criterion.
    std::vector<std::vector<dealii::Point<3>>>
    find_candidates(const SweptBody     &swept,
                    const Displacements &at,
                    Along               &along) const;
    /// Evaluates stresses of a body, and stresses due to heat alone or null.
    struct Stresses
    {
      const Vector                                &u;
      std::function<FieldSample(const Location &)> recovered;
      StressRecovery                              *thermal_recovery;
    };
    /// Returns the smallest reserve factor of @p task at @p points.
    std::optional<PlyReserve>
    worst_row(const SweptBody                     &swept,
              const Task                          &task,
              const std::vector<dealii::Point<3>> &points,
              const Stresses                      &stresses) const;
    /// Adds each criterion's smallest reserve factor to @p plies. Collective.
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

  /// Returns true if @p a is nearer to failure than @p b: by reserve factor, if
  /// both have none by failure index, and if equal (to 1e-7) by position.
  bool
  is_worse(const PlyReserve &a, const PlyReserve &b);

  /// Returns true if @p a is before @p b, ordered by x, then y, then z.
  /// Coordinates that differ by less than @p same are equal.
  bool
  is_before(const dealii::Point<3> &a,
            const dealii::Point<3> &b,
            const double            same);

  /// Returns the entry of @p rows nearest to failure; null if there are none.
  const PlyReserve *
  worst_of(const std::vector<PlyReserve> &rows);

  /// Returns a warning about the entry of @p rows nearest to failure if it is
  /// perhaps at a stress singularity: one of @p supports or of @p loads on a
  /// line or a point acts there, or element and recovered stresses differ by
  /// more than a tenth. Empty otherwise.
  std::string
  worst_reserve_warning(const std::vector<PlyReserve> &rows,
                        const std::vector<Support>    &supports,
                        const std::vector<Load>       &loads,
                        const Bodies                  &bodies);
} // namespace lamella

#endif
