// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef lamella_conditions_load_factor_h
#define lamella_conditions_load_factor_h

#include <deal.II/base/exceptions.h>

#include <utility>
#include <vector>

namespace lamella
{
  /// Load factors of a load step, which multiply loads, prescribed
  /// displacements and motions of obstacles. t_0 is the factor of the scene
  /// (`Load factors`). Each load, support or obstacle with its own history
  /// (`Factors`) has a factor t_k. The load vector is
  ///   f(t) = t_0 f_0 + sum_k t_k f_k.
  /// Temperatures have their own factor, which rises to 1 in the increments of
  /// the first load step.
  class LoadFactor
  {
  public:
    /// History index of temperatures.
    static constexpr unsigned int heat = static_cast<unsigned int>(-1);

    /// Constructs the factors t_0 = @p scene and t_1, t_2, ... = @p own.
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

    /// Returns t_k with k = @p history; 0 is the factor of the scene.
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

    /// Adds the factor of another history and returns its index.
    unsigned int
    add(const double factor)
    {
      own.push_back(factor);
      return own.size();
    }

    /// Returns factors interpolated linearly between @p from (@p way = 0) and
    /// this object (@p way = 1), for load increments.
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

    /// Returns factors of zero for everything except temperatures.
    LoadFactor
    without_loads() const
    {
      return {0., std::vector<double>(own.size(), 0.)};
    }

    /// Returns factors of zero for everything, including temperatures.
    LoadFactor
    unloaded() const
    {
      LoadFactor result     = without_loads();
      result.thermal_factor = 0.;
      return result;
    }

    /// Returns these factors, but with the temperature factor of @p other.
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
