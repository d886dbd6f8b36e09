// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/interface_law.h>

#include <cmath>

// Laws as projections, and their derivatives. For a slipping point with the
// bound b and the unit vector e along the trial shear z_t,
//   P_t = b e,   dP_t/dz_t = (b / |z_t|) (1 - e e^T),   dP_t/db = e.
namespace lamella
{
  using namespace dealii;

  InterfaceLaw::~InterfaceLaw() = default;



  ShearBound
  UnilateralContact::bound(const Tensor<1, 3> &) const
  {
    return {};
  }



  InterfaceResponse
  UnilateralContact::evaluate(const Tensor<1, 3> &z, const double) const
  {
    InterfaceResponse result;
    if (z[0] <= 0.)
      return result;
    result.state         = PointState::stick;
    result.traction[0]   = z[0];
    result.tangent[0][0] = 1.;
    result.energy        = 0.5 * z[0] * z[0];
    return result;
  }



  ShearBound
  CoulombFriction::bound(const Tensor<1, 3> &z) const
  {
    ShearBound result;
    if (z[0] > 0.)
      {
        result.value       = mu * z[0];
        result.gradient[0] = mu;
      }
    return result;
  }



  InterfaceResponse
  CoulombFriction::evaluate(const Tensor<1, 3> &z, const double bound) const
  {
    InterfaceResponse result = UnilateralContact::evaluate(z, bound);
    if (result.state == PointState::open)
      return result;
    const double length = std::hypot(z[1], z[2]);
    if (length <= bound)
      {
        result.traction = z;
        result.tangent  = unit_symmetric_tensor<3>();
        result.energy   = 0.5 * z.norm_square();
        return result;
      }
    result.state         = PointState::slip;
    const Tensor<1, 3> e = Tensor<1, 3>({0., z[1], z[2]}) / length;
    result.traction += bound * e;
    for (unsigned int i = 1; i < 3; ++i)
      for (unsigned int j = 1; j <= i; ++j)
        result.tangent[i][j] =
          bound / length * ((i == j ? 1. : 0.) - e[i] * e[j]);
    result.bound_derivative = e;
    result.energy += bound * (length - 0.5 * bound);
    return result;
  }



  ShearBound
  TiedInterface::bound(const Tensor<1, 3> &) const
  {
    return {};
  }



  InterfaceResponse
  TiedInterface::evaluate(const Tensor<1, 3> &z, const double) const
  {
    InterfaceResponse result;
    result.state    = PointState::stick;
    result.traction = z;
    result.tangent  = unit_symmetric_tensor<3>();
    result.energy   = 0.5 * z.norm_square();
    return result;
  }



  double
  law_compliance(const GapConstraint &row, const bool tangential)
  {
    return row.enforcement == Enforcement::penalty ? 1. / row.penalty :
           row.is_tied() ? row.adhesive[tangential ? 1 : 0] :
                           0.;
  }



  double
  law_compliance(const GapConstraints &rows, const unsigned int number)
  {
    return law_compliance(rows[rows.row_of(number)], number >= rows.size());
  }



  std::shared_ptr<const InterfaceLaw>
  law_of(const GapConstraint &row)
  {
    if (row.is_tied())
      return std::make_shared<TiedInterface>();
    if (row.slips.empty())
      return std::make_shared<UnilateralContact>();
    return std::make_shared<CoulombFriction>(row.friction);
  }
} // namespace lamella
