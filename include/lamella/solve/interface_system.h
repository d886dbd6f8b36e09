// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_solve_interface_system_h
#define lamella_solve_interface_system_h

#include <lamella/contact/gap_constraints.h>
#include <lamella/contact/interface_law.h>
#include <lamella/solve/tangent_operator.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <vector>

namespace lamella
{
  /// Normal and two tangential components (force or length) of all points.
  using PointVectors = std::vector<dealii::Tensor<1, 3>>;

  /// Returns the norm of the tangential components 1 and 2 of @p x.
  double
  tangential_norm(const dealii::Tensor<1, 3> &x);

  /// Returns @p x with its normal component 0 set to zero.
  dealii::Tensor<1, 3>
  tangential_part(dealii::Tensor<1, 3> x);

  /// Returns the scalar product of @p x and @p y, summed over all points.
  double
  inner_product(const PointVectors &x, const PointVectors &y);

  /// Returns the largest absolute value of all components of @p x.
  double
  largest_component(const PointVectors &x);

  /// Compliance matrix W of contact points: gaps and slips per unit force. A
  /// point has one matrix row for its normal and up to two for its tangents.
  struct PointCompliance
  {
    /// First matrix row of each point, then the number of matrix rows.
    std::vector<unsigned int> first{0};
    /// Matrix entries, column by column; the matrix is symmetric.
    std::vector<double> matrix;

    /// Returns the number of contact points.
    unsigned int
    n_points() const
    {
      return first.size() - 1;
    }
    /// Returns the number of matrix rows: one per point, and one per tangent.
    unsigned int
    n_rows() const
    {
      return first.back();
    }
    /// Returns the number of matrix rows of @p point: one plus its tangents.
    unsigned int
    size(const unsigned int point) const
    {
      return first[point + 1] - first[point];
    }
    /// Returns the entry in matrix row @p i and column @p j.
    double
    operator()(const unsigned int i, const unsigned int j) const
    {
      return matrix[std::size_t(j) * n_rows() + i];
    }
    /// @copydoc operator()(const unsigned int, const unsigned int) const
    double &
    operator()(const unsigned int i, const unsigned int j)
    {
      return matrix[std::size_t(j) * n_rows() + i];
    }

    /// Returns one vector per point from one entry per matrix row.
    PointVectors
    by_points(const std::vector<double> &rows) const;
    /// Returns the vectors @p points as one entry per matrix row.
    std::vector<double>
    by_rows(const PointVectors &points) const;

    /// Returns the gaps and slips W lambda due to the contact forces @p lambda.
    PointVectors
    times(const PointVectors &lambda) const;

    /// Adds the gaps and slips due to the force @p change at @p point to @p v.
    void
    add_of_point(const unsigned int          point,
                 const dealii::Tensor<1, 3> &change,
                 PointVectors               &v) const;
  };

  /// Symmetric, positive semidefinite 3 x 3 matrix D of each contact point
  /// [force / length], which maps gap and slips to contact forces.
  using PointStiffness = std::vector<dealii::SymmetricTensor<2, 3>>;

  /// Linearized law A dlambda + B dv = r of a contact point, with the change
  /// dlambda of its force and dv of gap and slips. A includes the compliance of
  /// the law.
  struct LinearizedLaw
  {
    /// State of the point: A = 1, B = 0, r = -lambda for an open one, A = D d,
    /// B = D for a sticking one, with the compliance d and stiffness D.
    PointState           state = PointState::open;
    dealii::Tensor<2, 3> A,        ///< Factor of the change of force.
      B;                           ///< Factor of the change of gap and slips.
    dealii::Tensor<1, 3> residual; ///< Right-hand side r.
  };

  /// Solution of equilibrium with the linearized law of each point.
  struct InterfaceStep
  {
    bool         is_solved = false; ///< False if the matrix is singular.
    PointVectors force,             ///< Contact force of each point.
      change;                       ///< Change of gaps and slips.
    /// Sign of the determinant of the matrix; -1 for an unstable equilibrium
    /// (InterfaceSolution::stability).
    int sign = 1;
  };

  /// Equilibrium of the bodies, reduced to the contact points: gaps and slips v
  /// as affine function of the contact forces. The iterate v need not satisfy
  /// it for the current forces; each solution of a linear system removes the
  /// difference. There are two linear-algebra back ends: a sparse matrix
  /// with penalty terms (SparseInterfaceSystem), and a dense compliance of the
  /// points (DenseInterfaceSystem).
  class InterfaceSystem
  {
  public:
    virtual ~InterfaceSystem() = default;

    /// Factorizes the operator with the stiffness @p D at the points. Throws
    /// NumericsError if it is not positive definite.
    virtual void
    factorize(const PointStiffness &D) = 0;

    /// Returns the change w of gaps and slips for which v + w are those of the
    /// contact forces @p force - D w, with the last factorized D.
    virtual PointVectors
    solve(const PointVectors &force) = 0;

    /// Solves equilibrium with the linearized @p laws of all points about the
    /// contact forces @p force. The matrix need not be symmetric. Throws
    /// NumericsError as factorize() does.
    virtual InterfaceStep
    solve(const std::vector<LinearizedLaw> &laws,
          const PointVectors               &force) = 0;

    /// Adds the fraction @p t of the last result of solve() to the iterate.
    virtual void
    advance(const double t) = 0;

    /// Sets the iterate to the equilibrium under the contact forces @p force,
    /// or to the initial state if these are its forces. Returns false if that
    /// is not an equilibrium.
    virtual bool
    move_to(const PointVectors &force) = 0;

    /// Returns the iterate of gaps and slips v, without compliance of the law.
    virtual PointVectors
    lengths() const = 0;
  };

  /// Contact points of an InterfaceSystem with their laws, in which the lengths
  ///   v + d (lambda - lambda_bar) + a lambda_bar
  /// stand for gap and slips, with the compliance a of the law, the numerical
  /// compliance d >= a, and an estimate lambda_bar of the force. All vectors
  /// have one entry per point.
  struct InterfacePoints
  {
    std::vector<unsigned int> n_slips; ///< Number of tangents: 0, 1 or 2.
    std::vector<std::shared_ptr<const InterfaceLaw>> law; ///< Law.
    /// Numerical compliance d in normal and both tangential directions.
    PointVectors compliance;
    /// Lengths (d - a) lambda_bar.
    PointVectors shift;
    /// Stiffness that relates forces and lengths of a point in normal and
    /// tangential direction, the inverse of its local compliance.
    std::vector<std::array<double, 2>> stiffness;
    /// Stiffness of the springs at the point that give the starting point, in
    /// the order of that of the bodies under forces on all points.
    std::vector<double> spring;
    /// Lengths of open points up to this value are rounding errors of zero.
    double closed = 0.;
    /// Contact forces at the beginning, in equilibrium with the bodies.
    PointVectors about;

    /// Returns the lengths of point @p i for gap and slips @p v and the contact
    /// force @p force.
    dealii::Tensor<1, 3>
    lengths(const unsigned int          i,
            const dealii::Tensor<1, 3> &v,
            const dealii::Tensor<1, 3> &force) const
    {
      dealii::Tensor<1, 3> result = v - shift[i];
      for (unsigned int c = 0; c < 3; ++c)
        result[c] += compliance[i][c] * force[c];
      return result;
    }
  };

  /// The compliance of contact constraints, the Schur complement
  ///   C = B K^-1 B^T
  /// with the condensed stiffness K of each body and the rows B of all
  /// constraints added by include(). C_ij [length / force] is the gap in
  /// constraint i due to a unit force in constraint j; slips are constraints,
  /// too (see GapConstraints). C is symmetric, and positive definite if the
  /// constraints are independent. Memory: n (n + 1) / 2 numbers for n
  /// constraints, and the nonzeros of L^-1 B^T (Cholesky factor L of K).
  class Compliance
  {
  public:
    /// Keeps references to both arguments, which must outlive this object;
    /// @p tangent_operator must have factorized the stiffnesses of all bodies.
    Compliance(const TangentOperator &tangent_operator,
               const GapConstraints  &rows);

    /// Adds the constraints with the indices @p wanted to the compliance, by
    /// one solution per body for all that have not been added before.
    void
    include(const std::vector<unsigned int> &wanted);

    /// Returns the indices of the constraints added by each call of include().
    /// A repetition of these calls reproduces the compliance bit for bit.
    const std::vector<std::vector<unsigned int>> &
    row_groups() const
    {
      return included;
    }

    /// Returns true if constraint @p row has been added by include().
    bool
    is_included(const unsigned int row) const
    {
      return place[row] != dealii::numbers::invalid_unsigned_int;
    }

    /// Returns the change of the gap of constraint @p row due to a unit force
    /// in it [length / force]; zero if the force acts on supported points only.
    double
    diagonal(const unsigned int row) const;

    /// Returns the compliance matrix of the constraints @p of, by columns.
    std::vector<double>
    among(const std::vector<unsigned int> &of) const;

    /// Returns the displacements K^-1 B^T lambda due to the forces @p lambda in
    /// the distinct constraints @p of. They are zero in prescribed DoFs.
    BlockVector
    displacement(const std::vector<unsigned int> &of,
                 const std::vector<double>       &lambda) const;

  private:
    /// Solutions K^-1 b^T for the constraint rows b of one body, and the index
    /// of each row in the compliance matrix.
    struct BodyConstraints
    {
      std::unique_ptr<SolvedRows> solved;
      std::vector<unsigned int>   place;
    };

    const TangentOperator       &tangent_operator;
    const GapConstraints         rows;
    std::vector<BodyConstraints> bodies;

    /// Index of each constraint in C, and lower triangle of C by rows.
    std::vector<unsigned int>        place;
    std::vector<std::vector<double>> entries;

    std::vector<std::vector<unsigned int>> included;
  };
} // namespace lamella

#endif
