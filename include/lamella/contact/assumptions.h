// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_contact_assumptions_h
#define lamella_contact_assumptions_h

#include <lamella/contact/gap_constraints.h>

#include <string>
#include <vector>

namespace lamella
{
  /// Throws InputError of `Contact NAME` if two of the contacts @p interfaces
  /// constrain the same points of the same two bodies, so that their forces
  /// would be counted twice. Contacts with weighted gaps may share a line of
  /// nodes if their areas are on different sides. Points are the same if they
  /// differ by at most 1e-9 of the body size, their opposite points by less
  /// than the root of the tributary area, and their normals by at most 60
  /// degrees.
  void
  check_conflicts(const std::vector<ContactInterface> &interfaces,
                  const Bodies                        &bodies);

  /// Throws InputError of `Contact NAME/Discretization` if a node-to-node
  /// contact in @p interfaces has partner nodes for fewer than half of the
  /// facing nodes of a surface: the bodies would pass through each other.
  void
  check_node_matching(const std::vector<ContactInterface> &interfaces);

  /// Sliding of the contact point that slides most relative to the point
  /// spacing: tangential displacement of the second surface relative to the
  /// first. Small-sliding contact assumes that it is small.
  struct Sliding
  {
    /// Sliding distance [length].
    double distance = 0.;
    /// Spacing of the contact points [length]; 0 if no point slides.
    double spacing = 0.;
    /// Undeformed position of the point on the first surface, scene axes.
    dealii::Point<3> position;
  };

  /// Returns the sliding that is largest relative to the point spacing, among
  /// the active constraints @p active (numbers within @p interface), at the
  /// displacements @p u and load factor @p factor, which moves an obstacle.
  /// Throws InputError if a contact point is not in its body.
  Sliding
  largest_sliding(const ContactInterface          &interface,
                  const Bodies                    &bodies,
                  const BlockVector               &u,
                  const LoadFactor                &factor,
                  const std::vector<unsigned int> &active);

  /// Returns warnings if the displacements @p u, with an obstacle at load
  /// factor @p factor, violate assumptions of small-sliding contact, which
  /// pairs initially facing points along initial normals. The constraints @p
  /// active (numbers within @p interface) are checked. A warning is given if
  /// the normals of the two surfaces differ by more than 5 degrees, or if
  /// sliding exceeds a tenth of the point spacing.
  std::vector<std::string>
  assumption_warnings(const ContactInterface          &interface,
                      const Bodies                    &bodies,
                      const BlockVector               &u,
                      const LoadFactor                &factor,
                      const std::vector<unsigned int> &active);

  /// Closes the gaps of ties, and treats initial overlap of @p interface as
  /// Overclosure of @p contact says. Throws InputError if tied surfaces are
  /// apart, and for overlap under Overclosure::refuse.
  void
  treat_initial_gaps(const ContactPair &contact, ContactInterface &interface);

  /// Main direction in which a contact acts at a constraint.
  struct MainNormal
  {
    unsigned int         row = 0; ///< Index of the constraint.
    dealii::Tensor<1, 3> normal;  ///< Unit vector, scene axes.
  };

  /// Returns the main normal of each constraint of @p interface (created from
  /// @p contact) whose gap exceeds the smallest by at most @p depth [length].
  /// Isostatic supports do not resist rigid motions along these normals. The
  /// normal at the smallest gap represents all constraints whose normal is
  /// within 60 degrees of it; the remaining constraints are treated in the same
  /// way. A roller on a flat face has one main normal; in a groove it has two.
  ///
  /// To be independent of the mesh, it is replaced by the normal of a flat
  /// surface if only one is flat or both are parallel. For two curved surfaces,
  /// components along their generators (straight lines) are removed.
  std::vector<MainNormal>
  main_normals(const ContactPair      &contact,
               const ContactInterface &interface,
               const Bodies           &bodies,
               const double            depth);
} // namespace lamella

#endif
