// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_body_ends_h
#define lamella_contact_body_ends_h

#include <lamella/body/body.h>
#include <lamella/contact/search.h>

namespace lamella
{
  /// Search tree of the nodes at both end sections of an undeformed body.
  class BodyEnds
  {
  public:
    explicit BodyEnds(const Body &body); ///< Collects the end nodes.

    /// Returns true if an end node is at @p x, to 1e-9 of the body size.
    bool
    has(const dealii::Point<3> &x) const;

  private:
    double                        near = 0.;
    std::vector<dealii::Point<3>> nodes;
    PointSearch                   search;
  };
} // namespace lamella

#endif
