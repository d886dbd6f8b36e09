// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_load_factor_h
#define lamella_conditions_load_factor_h

#include <deal.II/base/exceptions.h>

#include <utility>
#include <vector>

namespace lamella
{
  /**
   * The load factor t of a state: what multiplies loads, prescribed
   * displacements and the ways of obstacles there. One number for all of the
   * scene (`Load factors`), and one for each of them that has a history of its
   * own (`Factors`),
   *   f(t) = t_0 f_0 + sum_k t_k f_k.
   * Heat has one, too: it is all there in any step, and on the way of bodies
   * that turn into the first one a part of it.
   */
  class LoadFactor
  {
  public:
    /// The number of the history of heat.
    static constexpr unsigned int heat = static_cast<unsigned int>(-1);

    /// The number is all there is in scenes where nothing has a history of its
    /// own.
    LoadFactor(const double scene = 0., std::vector<double> own = {})
      : scene(scene)
      , own(std::move(own))
    {}

    /// t_0.
    double
    of_scene() const
    {
      return scene;
    }

    /// t_k, k = @p history; 0 is that of the scene.
    double
    of(const unsigned int history) const
    {
      if (history == 0)
        return scene;
      if (history == heat)
        return of_heat;
      AssertIndexRange(history - 1, own.size());
      return own[history - 1];
    }

    /// Adds that of one more history; its number is returned.
    unsigned int
    add(const double factor)
    {
      own.push_back(factor);
      return own.size();
    }

    /// The one between @p from and this, at the share @p way of the way.
    LoadFactor
    after(const LoadFactor &from, const double way) const
    {
      LoadFactor result(from.scene + way * (scene - from.scene), own);
      for (unsigned int k = 0; k < own.size(); ++k)
        result.own[k] = from.own[k] + way * (own[k] - from.own[k]);
      result.of_heat = from.of_heat + way * (of_heat - from.of_heat);
      return result;
    }

    /// Zero in all histories but that of heat: nothing loads or moves the
    /// bodies.
    LoadFactor
    without_loads() const
    {
      return {0., std::vector<double>(own.size(), 0.)};
    }

    /// without_loads(), and cold.
    LoadFactor
    at_rest() const
    {
      LoadFactor result = without_loads();
      result.of_heat    = 0.;
      return result;
    }

    /// This, as warm as @p other.
    LoadFactor
    as_warm_as(const LoadFactor &other) const
    {
      LoadFactor result = *this;
      result.of_heat    = other.of_heat;
      return result;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &scene &own &of_heat;
    }

  private:
    double              scene, of_heat = 1.;
    std::vector<double> own;
  };
} // namespace lamella

#endif
