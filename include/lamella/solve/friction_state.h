// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_friction_state_h
#define lamella_solve_friction_state_h

#include <lamella/contact/gap_rows.h>

#include <vector>

namespace lamella
{
  /**
   * What friction adds to a state and what it remembers: of each gap row, all
   * of them, as vectors of the scene, so that no frame is kept. Empty where no
   * contact has friction, and before the first load step.
   *
   * Coulomb's law of a step, with s_0 the slip at the end of the one before:
   *   v = s(u) + a lambda_t - s_0,   |lambda_t| <= mu lambda_n,
   *   v = 0 where |lambda_t| < mu lambda_n,
   *   lambda_t = -mu lambda_n v / |v| where v is not zero,
   * a the softness of the normal law (law_softness()): a penalty is one in the
   * tangents, too.
   */
  struct FrictionState
  {
    /// lambda_t, on the second side [force].
    std::vector<dealii::Tensor<1, 3>> shear;
    /// lambda_t / |lambda_t| of rows that slip; zero of all others.
    std::vector<dealii::Tensor<1, 3>> direction;
    /// s_0 [length], of open rows, too.
    std::vector<dealii::Tensor<1, 3>> before;
    /// The length of the slip so far, and what it has dissipated [energy]: in
    /// each step mu (lambda_n,0 + lambda_n,1) / 2 |v|, which is never negative
    /// and of second order in the step.
    std::vector<double> length, dissipated;
    /// g + a lambda_n [length].
    std::vector<double> opening;
    /**
     * What the steps so far miss of the work of contact, over all rows
     * [energy]: of each step
     *   - mean lambda . (change of (g, s) + a lambda) - dissipated,
     * with the mean of the forces at its ends. Bodies are linear, so what the
     * loads have done is strain energy, what penalties store (a |lambda|^2 /
     * 2), dissipated and this. It goes to zero as steps get shorter.
     */
    double path_gap = 0.;

    bool
    empty() const
    {
      return shear.empty();
    }

    /// The sum of `dissipated`, over all rows.
    double
    all_dissipated() const;

    /// That of @p rows without force or slip, of undeformed bodies.
    static FrictionState
    at_rest(const GapRows &rows);
  };

  /// What is said of an answer with friction that no load path leads to, and
  /// of one that is not found: the end of a message.
  constexpr const char *remedy_with_friction =
    ". Try more Substeps, a smaller step in Load factors, or a softer penalty.";

  /// Throws NumericsError: the answer that was found is unstable.
  [[noreturn]] void
  fail_as_unstable();

  /// A vector along tangents by its components, and back.
  dealii::Tensor<1, 2>
  along_tangents(const GapRow &row, const dealii::Tensor<1, 3> &vector);
  dealii::Tensor<1, 3>
  in_scene(const GapRow &row, const dealii::Tensor<1, 2> &components);

  /// s(u) of @p row at load factor @p factor, by components along its tangents.
  dealii::Tensor<1, 2>
  slip_of(const GapRow &row, const BlockVector &u, const LoadFactor &factor);

  /// f += B^T lambda of @p row: its force @p normal and, with friction, @p
  /// shear, a vector of the scene.
  void
  add_force(const GapRow               &row,
            const double                normal,
            const dealii::Tensor<1, 3> &shear,
            BlockVector                &f);
} // namespace lamella

#endif
