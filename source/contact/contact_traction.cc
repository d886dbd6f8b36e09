// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/contact/contact_traction.h>
#include <lamella/contact/gap_constraints.h>


namespace lamella
{
  using namespace dealii;

  namespace
  {
    /// On the second side.
    Tensor<1, 3>
    force_of(const ContactTraction::Row &row)
    {
      return row.force * row.normal + row.shear;
    }



    std::vector<ContactTraction::Row>
    rows_of(const ContactInterface              &contact,
            const ArrayView<const double>       &forces,
            const ArrayView<const Tensor<1, 3>> &shears)
    {
      std::vector<ContactTraction::Row> rows;
      for (unsigned int k = 0; k < contact.points.size(); ++k)
        {
          const ContactInterface::Point &point = contact.points[k];
          ContactTraction::Row           row{
            place_of(point), point.normal, point.area, forces[k], {}};
          if (shears.size() > 0)
            row.shear = shears[k];
          row.moment = cross_product_3d(Tensor<1, 3>(row.place), force_of(row));
          rows.push_back(row);
        }
      return rows;
    }
  } // namespace



  ContactTraction::ContactTraction(std::shared_ptr<const SlaveSurface> surface,
                                   std::vector<Row>                    rows,
                                   std::vector<Dissipation>            left)
    : traction_surface(std::move(surface))
    , all(std::move(rows))
    , points_left(std::move(left))
  {
    Assert(traction_surface == nullptr ||
             traction_surface->n_rows() == all.size(),
           ExcMessage("The surface carries other rows."));
  }



  ContactTraction::ContactTraction(const ContactInterface              &contact,
                                   const ArrayView<const double>       &forces,
                                   const ArrayView<const Tensor<1, 3>> &shears)
    : ContactTraction(contact.surface, rows_of(contact, forces, shears))
  {}



  ContactTraction::Value
  ContactTraction::at(const SlaveSurface::Place &place) const
  {
    const std::vector<double> values = traction_surface->functions_at(place);
    const auto &rows  = traction_surface->facets()[place.facet].rows;
    const auto &whole = traction_surface->integrals();
    Value       sum;
    for (unsigned int k = 0; k < values.size(); ++k)
      for (const auto &[row, share] : rows[k])
        {
          const double per_area = values[k] * share / whole[row].area;
          sum.pressure += per_area * all[row].force;
          sum.shear += per_area * all[row].shear;
        }
    return sum;
  }



  ContactTraction::Value
  ContactTraction::on_line(const Point<3>     &x,
                           const Tensor<1, 3> &n,
                           const double        search_radius) const
  {
    if (traction_surface == nullptr)
      return {};
    const auto place = traction_surface->on_line(x, n, search_radius);
    return place ? at(*place) : Value();
  }



  std::vector<SlaveSurface::Integrals>
  ContactTraction::inside(const ContactStrip &strip) const
  {
    std::vector<SlaveSurface::Integrals> sums(all.size());
    if (traction_surface != nullptr)
      sums = traction_surface->integrals(strip);
    for (unsigned int k = 0; k < all.size(); ++k)
      {
        const double at = all[k].place[strip.axis];
        if (is_point(k))
          sums[k].area = double(strip.from <= at && at < strip.to);
        else
          {
            const SlaveSurface::Integrals &whole =
              traction_surface->integrals()[k];
            const double share = sums[k].area / whole.area;
            sums[k]            = {share,
                                  (sums[k].moment - share * whole.moment) / whole.area};
          }
      }
    return sums;
  }



  std::vector<double>
  ContactTraction::shares(const std::optional<ContactStrip> &strip) const
  {
    std::vector<double> result(all.size(), 1.);
    if (strip)
      {
        const auto parts = inside(*strip);
        for (unsigned int k = 0; k < all.size(); ++k)
          result[k] = parts[k].area;
      }
    return result;
  }



  ContactTraction::Resultant
  ContactTraction::resultant(const std::optional<ContactStrip> &strip) const
  {
    std::vector<SlaveSurface::Integrals> parts;
    if (strip)
      parts = inside(*strip);
    Resultant sum;
    for (unsigned int k = 0; k < all.size(); ++k)
      {
        const Tensor<1, 3> force = force_of(all[k]);
        const double       share = strip ? parts[k].area : 1.;
        sum.force += share * force;
        sum.moment += share * all[k].moment;
        if (strip)
          sum.moment += cross_product_3d(parts[k].moment, force);
      }
    return sum;
  }



  double
  ContactTraction::dissipated(const std::optional<ContactStrip> &strip) const
  {
    const std::vector<double> parts = shares(strip);
    double                    sum   = 0.;
    for (unsigned int k = 0; k < all.size(); ++k)
      sum += parts[k] * all[k].dissipated;
    for (const Dissipation &point : points_left)
      if (!strip || (strip->from <= point.place[strip->axis] &&
                     point.place[strip->axis] < strip->to))
        sum += point.energy;
    return sum;
  }
} // namespace lamella
