// SPDX-License-Identifier: LGPL-2.1-or-later

#include <lamella/base/processes.h>
#include <lamella/body/body_solver.h>
#include <lamella/body/solid.h>
#include <lamella/shape/section_geometry.h>

#include <boost/container_hash/hash.hpp>

#include <unordered_map>

namespace lamella
{
  using namespace dealii;

  Solid::Solid(const std::string                        &name,
               const std::shared_ptr<const SectionMesh> &section,
               const AxisMesh                           &axis,
               const Placement                          &placement,
               const unsigned int                        degree,
               const SolidRefinement                    &refinement)
    : Body(name, placement)
    , mesh(section, axis, degree, refinement, "Body " + name)
    , element(degree)
    , axis_length(axis.length)
    , laws(section->plies)
    , is_curved(has_curved_edges(*section))
    , box(mesh.nodes())
  {
    for (const HexahedralMesh::HangingNode &node : mesh.hanging_nodes())
      for (unsigned int c = 0; c < 3; ++c)
        {
          hanging.add_line(3 * node.node + c);
          for (const auto &[master, weight] : node.masters)
            hanging.add_entry(3 * node.node + c, 3 * master + c, weight);
        }
    hanging.close();
    find_kinds();
    make_boxes();
  }



  void
  Solid::find_kinds()
  {
    // Nodes relative to the first, rounded far below element size.
    using Key = std::vector<long>;
    std::unordered_map<Key, unsigned int, boost::hash<Key>> numbers;
    const unsigned int last = element.n_nodes() - 1;
    for (unsigned int cell = 0; cell < mesh.cells().size(); ++cell)
      {
        const Hexahedron::Nodes nodes = nodes_of(cell);
        int                     exponent;
        std::frexp(nodes[0].distance(nodes[last]), &exponent);
        const double unit = std::ldexp(1e-11, exponent);
        Key          key{long(mesh.cells()[cell].ply), exponent};
        for (const Point<3> &x : nodes)
          for (unsigned int d = 0; d < 3; ++d)
            key.push_back(std::lround((x[d] - nodes[0][d]) / unit));
        // In a curved wall the place in the section tells the law.
        if (laws.has_varying_law(mesh.cells()[cell].ply))
          for (const unsigned int d : {0, 2})
            key.push_back(std::lround(nodes[0][d] / unit));
        const auto [place, is_new] = numbers.emplace(key, kinds.size());
        if (is_new)
          kinds.push_back(
            {cell, element.incompatible_modes(nodes, stiffness_of(cell)), {}});
        kind_of_cell.push_back(place->second);
        if (cell >= mesh.owned_cells().first &&
            cell < mesh.owned_cells().second)
          kinds[place->second].own_cells.push_back(cell);
      }
  }



  StiffnessField
  Solid::stiffness_of(const unsigned int cell) const
  {
    return [this, cell](const Point<3> &x) { return law(cell, x).stiffness(); };
  }



  Hexahedron::Nodes
  Solid::nodes_of(const unsigned int cell) const
  {
    Hexahedron::Nodes nodes;
    for (const unsigned int node : mesh.cells()[cell].nodes)
      nodes.push_back(mesh.nodes()[node]);
    return nodes;
  }



  std::vector<DofIndex>
  Solid::dofs_of(const unsigned int cell) const
  {
    std::vector<DofIndex> dofs;
    for (const unsigned int node : mesh.cells()[cell].nodes)
      for (unsigned int c = 0; c < 3; ++c)
        dofs.push_back(3 * DofIndex(node) + c);
    return dofs;
  }



  std::string
  Solid::theory() const
  {
    return "solid-" + std::to_string(degree()) + ", " +
           std::to_string(mesh.cells().size()) +
           (mesh.cells().size() == 1 ? " hexahedron" : " hexahedra") +
           (degree() == 1 ? " with incompatible modes" : "") +
           (mesh.hanging_nodes().empty() ?
              "" :
              ", " + std::to_string(mesh.hanging_nodes().size()) +
                " hanging nodes");
  }



  double
  Solid::stiffness_entries() const
  {
    // Three by three for each pair of nodes that share a hexahedron.
    std::vector<std::vector<unsigned int>> cells_of_node(mesh.nodes().size());
    for (unsigned int cell = 0; cell < mesh.cells().size(); ++cell)
      for (const unsigned int node : mesh.cells()[cell].nodes)
        cells_of_node[node].push_back(cell);
    std::vector<unsigned int> seen_by(mesh.nodes().size(),
                                      numbers::invalid_unsigned_int);
    double                    pairs = 0.;
    for (unsigned int i = mesh.owned_nodes().first;
         i < mesh.owned_nodes().second;
         ++i)
      for (const unsigned int cell : cells_of_node[i])
        for (const unsigned int j : mesh.cells()[cell].nodes)
          if (seen_by[j] != i)
            {
              seen_by[j] = i;
              ++pairs;
            }
    return 9. * Utilities::MPI::sum(pairs, communicator());
  }



  IndexSet
  Solid::owned_dofs() const
  {
    IndexSet owned(n_dofs());
    owned.add_range(3 * DofIndex(mesh.owned_nodes().first),
                    3 * DofIndex(mesh.owned_nodes().second));
    return owned;
  }



  double
  Solid::size() const
  {
    return 0.5 *
           std::max(
             {box.side_length(0), box.side_length(1), box.side_length(2)});
  }



  BoundingBox<3>
  Solid::bounding_box() const
  {
    std::vector<Point<3>> corners;
    for (unsigned int v = 0; v < 8; ++v)
      corners.push_back(placement.to_scene(box.vertex(v)));
    return BoundingBox<3>(corners);
  }



  std::vector<Vector>
  Solid::rigid_motions(const Vector &) const
  {
    std::vector<Vector> motions(6, Vector(n_dofs()));
    const Point<3>      middle = box.center();
    for (unsigned int m = 0; m < 6; ++m)
      {
        Tensor<1, 3> direction;
        direction[m % 3]     = 1.;
        const Tensor<1, 3> v = placement.vector_to_body(direction);
        for (unsigned int i = 0; i < mesh.nodes().size(); ++i)
          {
            const Tensor<1, 3> u =
              m < 3 ? v : cross_product_3d(v, mesh.nodes()[i] - middle);
            for (unsigned int c = 0; c < 3; ++c)
              motions[m][3 * DofIndex(i) + c] = u[c];
          }
      }
    return motions;
  }



  void
  Solid::for_each_stiffness_block(const Vector &,
                                  const Vector &,
                                  const bool           with_values,
                                  const BlockCallback &use) const
  {
    for (const Kind &kind : kinds)
      {
        StiffnessBlock block;
        if (with_values && !kind.own_cells.empty())
          {
            const FullMatrix<double> K =
              element.stiffness(nodes_of(kind.cell),
                                stiffness_of(kind.cell),
                                kind.modes);
            for (unsigned int i = 0; i < K.m(); ++i)
              for (unsigned int j = 0; j < K.n(); ++j)
                block.values.push_back(K(i, j));
          }
        for (const unsigned int cell : kind.own_cells)
          {
            block.rows = block.columns = dofs_of(cell);
            use(block);
          }
      }
  }



  std::vector<double>
  Solid::relative_displacements(const unsigned int cell, const Vector &u) const
  {
    const auto         &nodes = mesh.cells()[cell].nodes;
    std::vector<double> relative;
    for (const unsigned int node : nodes)
      for (unsigned int c = 0; c < 3; ++c)
        relative.push_back(u[3 * DofIndex(node) + c] -
                           u[3 * DofIndex(nodes[0]) + c]);
    return relative;
  }



  Gradient
  Solid::gradient_at(const unsigned int     cell,
                     const HexahedronPoint &point,
                     const Vector          &u) const
  {
    const std::vector<double> v = relative_displacements(cell, u);
    Gradient                  H;
    for (unsigned int i = 0; i < point.gradients.size(); ++i)
      H += outer_product(point.gradients[i],
                         Tensor<1, 3>({v[3 * i], v[3 * i + 1], v[3 * i + 2]}));
    return H;
  }



  void
  Solid::add_internal_forces(const Vector &u, Vector &f) const
  {
    Vector share(n_dofs());
    for (const Kind &kind : kinds)
      {
        if (kind.own_cells.empty())
          continue;
        const std::vector<HexahedronPoint> points =
          element.quadrature_points(nodes_of(kind.cell));
        std::vector<std::vector<Voigt>> B;
        std::vector<ElasticLaw>         laws_here;
        for (const HexahedronPoint &point : points)
          {
            B.push_back(element.strains(point, kind.modes));
            laws_here.push_back(law(kind.cell, point.position));
          }
        for (const unsigned int cell : kind.own_cells)
          {
            const std::vector<double>   v    = relative_displacements(cell, u);
            const std::vector<DofIndex> dofs = dofs_of(cell);
            for (unsigned int q = 0; q < B.size(); ++q)
              {
                Voigt strain;
                for (unsigned int d = 0; d < v.size(); ++d)
                  strain += v[d] * B[q][d];
                const Voigt stress =
                  points[q].JxW * laws_here[q].stress(strain);
                for (unsigned int d = 0; d < v.size(); ++d)
                  share[dofs[d]] += B[q][d] * stress;
              }
          }
      }
    sum_over_processes(share);
    f += share;
  }



  Deformation
  Solid::deformation(const Vector &u) const
  {
    Deformation result;
    for_each_gauss_point([&](const unsigned int        cell,
                             const HexahedronPoint    &point,
                             const std::vector<Voigt> &B,
                             const ElasticLaw         &law) {
      const std::vector<double> v = relative_displacements(cell, u);
      Voigt                     strain;
      Tensor<1, 3>              curl;
      for (unsigned int d = 0; d < v.size(); ++d)
        strain += v[d] * B[d];
      for (unsigned int i = 0; i < point.gradients.size(); ++i)
        curl +=
          cross_product_3d(point.gradients[i],
                           Point<3>(v[3 * i], v[3 * i + 1], v[3 * i + 2]));
      result.energy += point.JxW * law.energy_density(strain);
      result.max_rotation = std::max(result.max_rotation, 0.5 * curl.norm());
    });
    result.energy = Utilities::MPI::sum(result.energy, communicator());
    result.max_rotation =
      Utilities::MPI::max(result.max_rotation, communicator());
    return result;
  }



  ElasticLaw
  Solid::law_at(const unsigned int cell,
                const Point<3>    &unit,
                const Point<3>    &x) const
  {
    if (!is_heated())
      return law(cell, x);
    const Point<3> middle(0.5, 0.5, 0.5);
    const Voigt    alpha =
      mesh.section().plies[mesh.cells()[cell].ply].expansion({x[0], x[2]});
    return ElasticLaw(
      law(cell, x).stiffness(),
      temperature(position({cell, degree() == 1 ? middle : unit})) * alpha);
  }



  double
  Solid::add_thermal_load(const Vector &u, Vector &f) const
  {
    if (!is_heated())
      return 0.;
    Vector share(n_dofs());
    double energy = 0.;
    for_each_gauss_point([&](const unsigned int        cell,
                             const HexahedronPoint    &point,
                             const std::vector<Voigt> &B,
                             const ElasticLaw &) {
      const ElasticLaw            at = law_at(cell, point.unit, point.position);
      const Voigt                 stress = -1. * at.stress(Voigt());
      const std::vector<DofIndex> dofs   = dofs_of(cell);
      for (unsigned int d = 0; d < dofs.size(); ++d)
        share[dofs[d]] += point.JxW * (B[d] * stress);
      energy += point.JxW * at.energy_density(Voigt());
    });
    sum_over_processes(share);
    f += share;
    if (u.size() > 0)
      add_product_of_blocks(
        [&](const auto &use) { for_each_thermal_block(u, use); }, u, f);
    return Utilities::MPI::sum(energy, communicator());
  }



  // int N_i N_j dV is the same for the three components.
  void
  Solid::for_each_mass_block(const Vector &,
                             const bool,
                             const BlockCallback &use) const
  {
    const std::vector<double> rho = densities(*this);
    for (const Kind &kind : kinds)
      {
        if (kind.own_cells.empty())
          continue;
        const unsigned int  n = mesh.cells()[kind.cell].nodes.size();
        std::vector<double> NN(n * n, 0.);
        for (const HexahedronPoint &point :
             element.quadrature_points(nodes_of(kind.cell)))
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              NN[i * n + j] += point.JxW * point.N[i] * point.N[j];
        for (const unsigned int cell : kind.own_cells)
          for (unsigned int c = 0; c < 3; ++c)
            {
              StiffnessBlock block;
              for (const unsigned int node : mesh.cells()[cell].nodes)
                block.rows.push_back(3 * DofIndex(node) + c);
              block.columns = block.rows;
              for (const double integral : NN)
                block.values.push_back(rho[mesh.cells()[cell].ply] * integral);
              use(block);
            }
      }
  }
} // namespace lamella
