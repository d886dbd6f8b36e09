// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/adapt/theory_pieces.h>
#include <lamella/base/arithmetic.h>

#include <algorithm>

namespace lamella
{
  using namespace dealii;

  std::vector<Theory>
  theories_at(const double y, const TheoryPieces &pieces, const double length)
  {
    const double        tolerance = arithmetic::same_position * length;
    std::vector<Theory> result;
    for (unsigned int k = 0; k < pieces.theories.size(); ++k)
      {
        const double begin = k == 0 ? 0. : pieces.breaks[k - 1],
                     end = k < pieces.breaks.size() ? pieces.breaks[k] : length;
        if (y > begin - tolerance && y < end + tolerance)
          result.push_back(pieces.theories[k]);
      }
    return result;
  }



  std::vector<unsigned int>
  list_of_degree(const Section &section, const unsigned int degree)
  {
    std::vector<unsigned int> list;
    for (unsigned int alpha = 0; alpha < section.n_fields(); ++alpha)
      if (degree >= section.element().degree() ||
          section.field_degree(alpha) <= degree)
        list.push_back(alpha);
    return list;
  }



  Wanted
  requirements_of(const std::vector<Theory> &theories)
  {
    Wanted wanted;
    for (const Theory &theory : theories)
      if (theory.is_layerwise())
        wanted.degree = std::max(wanted.degree, theory.order);
      else
        wanted.any_SV = true;
    for (const Theory &theory : theories)
      wanted.plain = wanted.plain && theory.order == 0;
    return wanted;
  }



  void
  add_coarse_row_notes(const Beam                          &beam,
                       const unsigned int                   body,
                       const TheoryPieces                  &pieces,
                       const std::vector<ContactInterface> &contacts,
                       std::vector<std::string>            &notes)
  {
    std::vector<bool> is_coarse;
    for (const double y : beam.axis().nodes())
      {
        const Wanted wanted =
          requirements_of(theories_at(y, pieces, beam.axis().length()));
        is_coarse.push_back(!wanted.any_SV &&
                            wanted.degree < beam.section().element().degree());
      }
    const auto reaches = [&](const GapConstraint &row) {
      for (const BodyFunctional &part : row.parts)
        for (const auto &[dof, weight] : part.row.entries())
          if (part.body == body && is_coarse[beam.dofs().node_of(dof)])
            return true;
      return false;
    };
    for (const ContactInterface &contact : contacts)
      if (contact.discretization == Discretization::surface_to_surface &&
          std::any_of(contact.rows.begin(), contact.rows.end(), reaches))
        notes.push_back(
          "adapt.too-many-constraints: body " + beam.name() + ": contact " +
          contact.name +
          " has more contact constraints than the body has DoFs where Theories "
          "has LE-N of a lower degree. The contact force is accurate there, "
          "not the pressure. Extend the LE-N of the highest degree over the "
          "contact, or use Discretization = node to surface");
  }



  namespace
  {
    /// The lists of a body whose pieces are all LE.
    std::vector<std::vector<unsigned int>>
    lists_by_degree(const Beam &beam, const TheoryPieces &pieces)
    {
      std::vector<std::vector<unsigned int>> lists;
      for (const double y : beam.axis().nodes())
        lists.push_back(list_of_degree(
          beam.section(),
          requirements_of(theories_at(y, pieces, beam.axis().length()))
            .degree));
      return lists;
    }
  } // namespace



  std::string
  label_of(const BodyDescription                        &body,
           const std::vector<std::vector<unsigned int>> &lists)
  {
    std::size_t least = lists[0].size(), most = least;
    for (const auto &list : lists)
      {
        least = std::min(least, list.size());
        most  = std::max(most, list.size());
      }
    std::string names;
    for (const Theory &theory : body.pieces.theories)
      names += (names.empty() ? "" : ", ") + theory.name();
    return (names.empty() ? body.theory.name() : names) + ", " +
           std::to_string(least) +
           (most > least ? " to " + std::to_string(most) : "") +
           " fields a node";
  }



  std::unique_ptr<Body>
  make_by_degrees(const BodyDescription &description, const Beam &beam)
  {
    const auto lists = lists_by_degree(beam, description.pieces);
    return std::make_unique<Beam>(beam.name(),
                                  std::make_shared<SectionSpace>(
                                    beam.fields().shared_section()),
                                  beam.shared_axis(),
                                  beam.place(),
                                  lists,
                                  label_of(description, lists));
  }
} // namespace lamella
