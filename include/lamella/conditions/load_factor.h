// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_load_factor_h
#define lamella_conditions_load_factor_h

#include <deal.II/base/exceptions.h>

#include <utility>
#include <vector>

namespace lamella
{
  /// The load factor t of a state, which multiplies loads, prescribed
  /// displacements and motions of obstacles. The scene has a factor t_0 (`Load
  /// factors`), and each object with its own history (`Factors`) has a t_k:
  ///   f(t) = t_0 f_0 + sum_k t_k f_k.
  /// Heat has a factor, too: 1, and less on the way to a first large step.
  class LoadFactor
  {
  public:
    /// History number of heat.
    static constexpr unsigned int heat = static_cast<unsigned int>(-1);

    /// Sets t_0 and the t_k of own histories, if any.
    LoadFactor(const double scene = 0., std::vector<double> own = {})
      : scene(scene)
      , own(std::move(own))
    {}

    /// Returns t_0.
    double
    of_scene() const
    {
      return scene;
    }

    /// Returns t_k, k = @p history; 0 is that of the scene.
    double
    of(const unsigned int history) const
    {
      if (history == 0)
        return scene;
      if (history == heat)
        return thermal_factor;
      AssertIndexRange(history - 1, own.size());
      return own[history - 1];
    }

    /// Adds the factor of one more history. Returns its number.
    unsigned int
    add(const double factor)
    {
      own.push_back(factor);
      return own.size();
    }

    /// Returns the factor at the fraction @p way between @p from and this.
    LoadFactor
    after(const LoadFactor &from, const double way) const
    {
      LoadFactor result(from.scene + way * (scene - from.scene), own);
      for (unsigned int k = 0; k < own.size(); ++k)
        result.own[k] = from.own[k] + way * (own[k] - from.own[k]);
      result.thermal_factor =
        from.thermal_factor + way * (thermal_factor - from.thermal_factor);
      return result;
    }

    /// Returns this with zero in all histories except heat.
    LoadFactor
    without_loads() const
    {
      return {0., std::vector<double>(own.size(), 0.)};
    }

    /// Returns without_loads(), also without heat.
    LoadFactor
    unloaded() const
    {
      LoadFactor result     = without_loads();
      result.thermal_factor = 0.;
      return result;
    }

    /// Returns this with the heat factor of @p other.
    LoadFactor
    with_thermal_factor_of(const LoadFactor &other) const
    {
      LoadFactor result     = *this;
      result.thermal_factor = other.thermal_factor;
      return result;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &scene &own &thermal_factor;
    }

  private:
    double              scene, thermal_factor = 1.;
    std::vector<double> own;
  };
} // namespace lamella

#endif
