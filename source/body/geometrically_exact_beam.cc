// SPDX-License-Identifier: LGPL-2.1-or-later

// A geometrically exact beam (Simo, Comput. Methods Appl. Mech. Eng. 49 (1985)
// 55-70; Simo and Vu-Quoc, ibid. 58 (1986) 79-116) with small warping: the law
// of its sections and its state. Forces: geometrically_exact_forces.cc; output
// at points: geometrically_exact_points.cc. Rotations are unit quaternions at
// nodes, interpolated linearly (Romero, Comput. Mech. 34 (2004) 121-133);
// strains divide by |Q|, hence are objective (the requirement of Jelenic and
// Crisfield, Comput. Methods Appl. Mech. Eng. 171 (1999) 141-171).

#include <lamella/base/arithmetic.h>
#include <lamella/base/exceptions.h>
#include <lamella/base/text.h>
#include <lamella/body/geometrically_exact_beam.h>
#include <lamella/section/shape_change.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <numeric>

namespace lamella
{
  using namespace dealii;

  namespace
  {
    // Gamma and kappa.
    constexpr unsigned int n_frame = 6;

    constexpr std::array<unsigned int, 3> translations{
      {RigidField::translation_x,
       RigidField::translation_y,
       RigidField::translation_z}};

    /// Field of the rotation about each axis, and the sign of its amplitude for
    /// a right-handed rotation.
    constexpr std::array<unsigned int, 3> rotates_about{
      {RigidField::slope_z, RigidField::rotation_y, RigidField::slope_x}};
    constexpr std::array<double, 3> sign_of_rotation{{-1., 1., 1.}};



    /// Returns @p section, or for a rigid one an LE-2 section of the same mesh.
    std::shared_ptr<const Section>
    with_warping(const std::shared_ptr<const Section> &section)
    {
      if (section->n_fields() > RigidField::n_all)
        return section;
      return make_section(section->element().shared_mesh(),
                          Theory::layer_wise(2));
    }

    // Without modes, every node carries all section functions: the six rigid
    // motions first, then warpings.
    std::vector<std::vector<unsigned int>>
    all_fields_at_each_node(const Section &section, const Axis &axis)
    {
      std::vector<unsigned int> all(section.n_fields());
      std::iota(all.begin(), all.end(), 0);
      return std::vector<std::vector<unsigned int>>(axis.n_nodes(), all);
    }



    /// Place in a list of fields, and amplitude per unit, of the field whose
    /// derivative is each of Gamma and kappa; zero if none is.
    struct FrameFields
    {
      FrameFields(const std::vector<unsigned int> &list, const double h)
      {
        for (unsigned int c = 0; c < 3; ++c)
          {
            set(c, list, translations[c], 1.);
            set(3 + c, list, rotates_about[c], h * sign_of_rotation[c]);
          }
      }

      void
      set(const unsigned int               c,
          const std::vector<unsigned int> &list,
          const unsigned int               field,
          const double                     by)
      {
        const auto found = std::find(list.begin(), list.end(), field);
        place[c]         = found == list.end() ? 0 : found - list.begin();
        factor[c]        = found == list.end() ? 0. : by;
      }

      std::array<unsigned int, n_frame> place{};
      std::array<double, n_frame>       factor{};
    };



    /// Returns the section fields of a unit of each strain in e, one column
    /// each; @p n_strains are the frame's, @p rigid the leading fields without
    /// warping. The column of kappa_y^2 / 2 is empty.
    FieldParts
    units(const FrameFields &frame,
          const unsigned int n_fields,
          const unsigned int rigid,
          const unsigned int n_strains)
    {
      const unsigned int m    = n_fields - rigid;
      FieldParts         unit = field_parts(n_fields, n_strains + 2 * m);
      for (unsigned int c = 0; c < n_frame; ++c)
        unit[FieldPart::derivative](frame.place[c], c) += frame.factor[c];
      for (unsigned int a = 0; a < m; ++a)
        {
          unit[FieldPart::value](rigid + a, n_strains + a)          = 1.;
          unit[FieldPart::shear_value](rigid + a, n_strains + a)    = 1.;
          unit[FieldPart::derivative](rigid + a, n_strains + m + a) = 1.;
        }
      return unit;
    }
  } // namespace



  GeometricallyExactBeam::GeometricallyExactBeam(
    const std::string                    &name,
    const std::shared_ptr<const Section> &section,
    const std::shared_ptr<const Axis>    &axis,
    const Placement                      &placement,
    const std::string                    &theory,
    const bool                            keeps_normal)
    : GeometricallyExactBeam(name,
                             std::make_shared<SectionSpace>(section),
                             axis,
                             placement,
                             all_fields_at_each_node(*section, *axis),
                             theory,
                             keeps_normal)
  {}



  GeometricallyExactBeam::GeometricallyExactBeam(
    const std::string                            &name,
    std::shared_ptr<const SectionSpace>           space,
    std::shared_ptr<const Axis>                   axis,
    const Placement                              &placement,
    const std::vector<std::vector<unsigned int>> &fields_of_node,
    const std::string                            &theory,
    const bool                                    keeps_normal)
    : FiniteRotationBeam(name,
                         std::move(space),
                         std::move(axis),
                         placement,
                         fields_of_node,
                         theory)
    , h(section().element().reference_length())
    , deformable_section(with_warping(fields().shared_section()))
  {
    for (const auto &list : fields_of_node)
      if (section().n_fields() > n_node_unknowns && !fields().is_dense(list))
        throw InputError(
          "body.theory-without-rotating-sections: "
          "geometrically exact beams (sections with finite rotations) need Theory = EBBT, TBT, SV or SV-N.");
    // Gauss rule with as many points as the degree: reduced integration against
    // shear locking (Zienkiewicz, Taylor and Too, Int. J. Numer. Meth. Eng. 3
    // (1971) 275-290; for this beam, Simo and Vu-Quoc).
    const QGauss<1> rule(this->axis().degree());
    for (unsigned int cell = 0; cell < this->axis().n_cells(); ++cell)
      {
        stations.emplace_back();
        for (unsigned int k = 0; k < rule.size(); ++k)
          stations.back().push_back(
            {this->axis().evaluate(cell, rule.point(k)[0]),
             rule.weight(k) *
               (this->axis().cell_end(cell) - this->axis().cell_begin(cell))});
      }
    const SaintVenant states(*deformable_section);
    twist_stretch = std::make_unique<TwistStretch>(states);
    make_laws(keeps_normal);
    // c of M = D k (1 + c k^2), less Wagner's share, which the law contains.
    stiffening = stiffening_by_shape(states);
    stiffening[1] -= twist_stretch->stiffening();
  }



  // Elements with the same list of fields share their law.
  void
  GeometricallyExactBeam::make_laws(const bool keeps_normal)
  {
    // Stiffness against shear over that against stretch: penalty of Kirchhoff's
    // constraint Gamma_x = Gamma_z = 0 for EBBT. In a cantilever of height h it
    // leaves 3 E I / (10^4 E A L^2) = 2.5e-5 (h / L)^2 of the deflection.
    constexpr double          normal = 1e4;
    std::vector<unsigned int> before;
    for (unsigned int cell = 0; cell < axis().n_cells(); ++cell)
      {
        const std::vector<unsigned int> list =
          along_axis().fields_of_element(cell);
        if (list == before)
          {
            laws.push_back(laws.back());
            continue;
          }
        const auto law = make_law(
          *make_section_operator(fields(), list, axis().has_assumed_shear()));
        for (const unsigned int shear : {0, 2})
          if (keeps_normal)
            law->D(shear, shear) += normal * law->D(1, 1);
        laws.push_back(law);
        before = list;
      }
  }



  // Column k of D: the section forces of a unit of strain k (SectionOperator),
  //   D_ck = int b_c . C b_k dA,
  // with the strain field b_k of the section for e_k = 1. Six columns of Gamma
  // and kappa are the section stiffness; those of a, a' couple it to warping.
  std::shared_ptr<GeometricallyExactBeam::Law>
  GeometricallyExactBeam::make_law(
    const SectionOperator &section_operator) const
  {
    const std::vector<unsigned int> &list = section_operator.fields();
    const FrameFields                frame(list, h);
    const unsigned int               rigid = n_rigid();
    auto                             law   = std::make_shared<Law>();
    law->fields.assign(list.begin(), list.end());
    law->warpings.assign(list.begin() + rigid, list.end());
    const FieldParts work =
      section_operator.forces(units(frame, list.size(), rigid, n_strains)).work;
    const unsigned int n = n_strains + 2 * law->warpings.size();
    law->D.reinit(n, n);
    for (unsigned int k = 0; k < n; ++k)
      {
        const std::vector<double> s = on_strains(list, work, k);
        for (unsigned int c = 0; c < n; ++c)
          law->D(c, k) = s[c];
      }
    if (section().theory().can_twist())
      add_twist_stretch(*law);
    return law;
  }



  // Wagner's term: row and column of kappa_y^2 / 2 from TwistStretch, with its
  // strain epsilon_2 = r^2 e_yy + D_s v:
  //   D_cw = int b_c . C epsilon_2 dA,  D_ww = int epsilon_2 . C epsilon_2 dA.
  void
  GeometricallyExactBeam::add_twist_stretch(Law &law) const
  {
    constexpr unsigned int   w = n_frame;
    LAPACKFullMatrix<double> on_derivatives(section().n_fields(), 1);
    for (unsigned int alpha = 0; alpha < section().n_fields(); ++alpha)
      on_derivatives(alpha, 0) = twist_stretch->work()[alpha];
    FieldParts work             = field_parts(law.fields.size(), 1);
    work[FieldPart::derivative] = fields().on_list(law.fields, on_derivatives);
    const std::vector<double> s = on_strains(law.fields, work, 0);
    for (unsigned int c = 0; c < s.size(); ++c)
      law.D(c, w) = law.D(w, c) = s[c];
    law.D(w, w) = twist_stretch->stiffness();
  }



  // Section forces on fields, collected as stresses work-conjugate to e: if
  // strain c makes the field amplitude f_c e_c, its stress is f_c times it.
  std::vector<double>
  GeometricallyExactBeam::on_strains(const std::vector<unsigned int> &list,
                                     const FieldParts                &work,
                                     const unsigned int               k) const
  {
    const FrameFields   frame(list, h);
    std::vector<double> s;
    for (unsigned int c = 0; c < n_frame; ++c)
      s.push_back(frame.factor[c] *
                  work[FieldPart::derivative](frame.place[c], k));
    s.push_back(0.);
    for (unsigned int a = n_rigid(); a < list.size(); ++a)
      s.push_back(work[FieldPart::value](a, k) +
                  work[FieldPart::shear_value](a, k));
    for (unsigned int a = n_rigid(); a < list.size(); ++a)
      s.push_back(work[FieldPart::derivative](a, k));
    return s;
  }



  // ---- the state

  // Rotation vector from the slopes u_y,z = -theta_x, u_y,x = theta_z, times h.
  Tensor<1, 3>
  GeometricallyExactBeam::rotation(const unsigned int node,
                                   const Vector      &u) const
  {
    Tensor<1, 3> theta;
    for (unsigned int c = 0; c < 3; ++c)
      if (rotates_about[c] < section().n_fields())
        theta[c] = sign_of_rotation[c] / h *
                   u[dofs().first(node) + dofs().place(node, rotates_about[c])];
    return theta;
  }



  // Left multiplication of the spin on the rotation, exp(du) q(u) (Simo and
  // Vu-Quoc; compound rotations by quaternions: Crisfield, Non-linear Finite
  // Element Analysis of Solids and Structures, Vol. 2, Wiley 1997, Ch. 16). The
  // vectors in u have angles of 0 to pi; their jump at pi has no effect, as
  // quaternions are composed and interpolated. Spins a and b in two planes make
  // a twist of second order, a x b / 2 (Baker, Campbell and Hausdorff).
  Vector
  GeometricallyExactBeam::retract(const Vector &u, const Vector &change) const
  {
    Vector result = u;
    result += change;
    for (unsigned int node = 0; node < dofs().n_nodes(); ++node)
      {
        const Tensor<1, 3> theta = rotation_vector_of(
          compose_rotations(quaternion_of(rotation(node, change)),
                            quaternion_of(rotation(node, u))));
        for (unsigned int c = 0; c < 3; ++c)
          if (rotates_about[c] < section().n_fields())
            result[dofs().first(node) + dofs().place(node, rotates_about[c])] =
              h * sign_of_rotation[c] * theta[c];
          else if (std::abs(theta[c]) > arithmetic::same_value)
            throw NumericsError(
              "body.twist-needed: body " + name() + " (" + theory() +
              ") bends in two planes and needs to twist by " +
              to_text(theta[c], 2) +
              " rad, but its theory excludes twist. Use Theory = SV.");
      }
    return result;
  }



  DofMagnitude
  GeometricallyExactBeam::magnitude(const Vector &u) const
  {
    DofMagnitude largest;
    for (unsigned int node = 0; node < dofs().n_nodes(); ++node)
      {
        largest.rotation = std::max(largest.rotation, rotation(node, u).norm());
        const std::vector<unsigned int> &list = dofs().fields(node);
        for (unsigned int k = 0; k < list.size(); ++k)
          largest.displacement = std::max(largest.displacement,
                                          std::abs(u[dofs().first(node) + k]) *
                                            fields().sizes()[list[k]]);
      }
    return largest;
  }



  // Rotations about the center at current positions: v x (X + r).
  std::vector<Vector>
  GeometricallyExactBeam::rigid_motions(const Vector &u) const
  {
    std::vector<Vector> motions = Beam::rigid_motions(u);
    if (u.size() == 0)
      return motions;
    for (unsigned int m = 0; m < 3; ++m)
      {
        Tensor<1, 3> axis;
        axis[m]              = 1.;
        const Tensor<1, 3> v = placement.vector_to_body(axis);
        for (unsigned int node = 0; node < dofs().n_nodes(); ++node)
          {
            const DofIndex first = dofs().first(node);
            Tensor<1, 3>   r;
            for (unsigned int c = 0; c < 3; ++c)
              r[c] = u[first + translations[c]];
            const Tensor<1, 3> more = cross_product_3d(v, r);
            for (unsigned int c = 0; c < 3; ++c)
              motions[3 + m][first + translations[c]] += more[c];
          }
      }
    return motions;
  }



  // Signs of quaternions: nearest to the first node's (q and -q are equal).
  GeometricallyExactBeam::Element
  GeometricallyExactBeam::element(const unsigned int cell,
                                  const Vector      &u) const
  {
    Element result;
    for (const unsigned int node : axis().nodes_of_cell(cell))
      {
        result.q.push_back(quaternion_of(rotation(node, u)));
        // q and -q are the same rotation: interpolation takes the shorter arc.
        if (result.q.back() * result.q.front() < 0.)
          result.q.back() *= -1.;
        const DofIndex first = dofs().first(node);
        result.r.emplace_back();
        for (unsigned int c = 0; c < 3; ++c)
          result.r.back()[c] = u[first + translations[c]];
        result.a.emplace_back();
        for (const unsigned int alpha : laws[cell]->warpings)
          {
            const int place = dofs().place(node, alpha);
            result.a.back().push_back(place < 0 ? 0. : u[first + place]);
          }
      }
    return result;
  }



  // Linear interpolation of quaternions, not normalized; Q' likewise:
  //   Q = sum N_i q_i,  Q' = sum N_i' q_i = sum N_i' (q_i - q_0).
  GeometricallyExactBeam::Frame
  GeometricallyExactBeam::frame_at(const AxisPoint &point,
                                   const Element   &element)
  {
    Frame              result;
    const unsigned int m = element.a.front().size();
    result.a.assign(m, 0.);
    result.da.assign(m, 0.);
    for (unsigned int i = 0; i < point.N.size(); ++i)
      {
        result.Q += point.N[i] * element.q[i];
        result.r += point.N[i] * element.r[i];
        // Differences to the first node vanish exactly for rigid motions.
        result.dQ += point.dN[i] * (element.q[i] - element.q[0]);
        result.dr += point.dN[i] * (element.r[i] - element.r[0]);
        for (unsigned int a = 0; a < m; ++a)
          {
            result.a[a] += point.N[i] * element.a[i][a];
            result.da[a] += point.dN[i] * (element.a[i][a] - element.a[0][a]);
          }
      }
    return result;
  }



  std::vector<double>
  GeometricallyExactBeam::strains(const Frame &frame, const FrameStrains &of)
  {
    std::vector<double> e(of.value.begin(), of.value.end());
    e.insert(e.end(), frame.a.begin(), frame.a.end());
    e.insert(e.end(), frame.da.begin(), frame.da.end());
    return e;
  }



  std::vector<double>
  GeometricallyExactBeam::strains(const Frame &frame)
  {
    return strains(frame, frame_strains(frame.Q, frame.dQ, frame.dr, 0));
  }



  // ---- local numbers: of each node r, spin and warpings
  //
  // With DoF = factor x local unknown, virtual work gives the congruence
  //   f_dof = f_local / factor,  K_ij,dof = K_ij,local / (factor_i factor_j).

  std::vector<GeometricallyExactBeam::LocalDof>
  GeometricallyExactBeam::local_dofs(const unsigned int cell) const
  {
    std::vector<LocalDof> result;
    for (const unsigned int node : axis().nodes_of_cell(cell))
      {
        const auto add = [&](const unsigned int alpha, const double factor) {
          const int place =
            alpha < fields().n_fields() ? dofs().place(node, alpha) : -1;
          result.emplace_back();
          if (place >= 0)
            result.back() = {dofs().first(node) + place, factor};
        };
        for (unsigned int c = 0; c < 3; ++c)
          add(translations[c], 1.);
        for (unsigned int c = 0; c < 3; ++c)
          add(rotates_about[c], h * sign_of_rotation[c]);
        for (const unsigned int alpha : laws[cell]->warpings)
          add(alpha, 1.);
      }
    return result;
  }



  void
  GeometricallyExactBeam::add_local(const std::vector<LocalDof> &dofs,
                                    const std::vector<double>   &local,
                                    Vector                      &f)
  {
    for (unsigned int k = 0; k < dofs.size(); ++k)
      if (dofs[k].exists())
        f[dofs[k].dof] += local[k] / dofs[k].factor;
  }



  StiffnessBlock
  GeometricallyExactBeam::block_of(const std::vector<LocalDof>    &dofs,
                                   const LAPACKFullMatrix<double> &local)
  {
    StiffnessBlock            block;
    std::vector<unsigned int> there;
    for (unsigned int k = 0; k < dofs.size(); ++k)
      if (dofs[k].exists())
        {
          there.push_back(k);
          block.rows.push_back(dofs[k].dof);
        }
    block.columns = block.rows;
    if (local.m() > 0)
      for (const unsigned int i : there)
        for (const unsigned int j : there)
          block.values.push_back(local(i, j) /
                                 (dofs[i].factor * dofs[j].factor));
    return block;
  }
} // namespace lamella
