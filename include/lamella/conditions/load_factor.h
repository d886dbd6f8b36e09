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
  /// (`Load factors`). Each load, support or obstacle with the entry `Factors`
  /// has its own factor t_k, k > 0. The load vector is
  ///   f(t) = t_0 f_0 + sum_k t_k f_k.
  /// The factor of temperatures rises to 1 in the first load step.
  class LoadFactor
  {
  public:
    /// Index of the factor of temperatures, an argument of of().
    static constexpr unsigned int heat = static_cast<unsigned int>(-1);

    /// Constructs the factors of the scene and of loads with entry `Factors`.
    LoadFactor(const double scene = 0., std::vector<double> own = {})
      : scene(scene)
      , own(std::move(own))
      , amplitudes(this->own.size(), 0.)
    {}

    /// Returns the factor of the scene.
    double
    of_scene() const
    {
      return scene;
    }

    /// Returns the factor with the index @p history; 0: the scene's.
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

    /// Adds the factor of another load, support or obstacle; returns its index.
    /// If it @p oscillates, its value is an amplitude (`Factors = harmonic`).
    unsigned int
    add(const double factor, const bool oscillates = false)
    {
      own.push_back(factor);
      amplitudes.push_back(oscillates ? 1. : 0.);
      return own.size();
    }

    /// Returns factors interpolated linearly between @p from (@p way = 0) and
    /// this object (@p way = 1), for load increments.
    LoadFactor
    after(const LoadFactor &from, const double way) const
    {
      LoadFactor result = *this;
      result.scene      = from.scene + way * (scene - from.scene);
      for (unsigned int k = 0; k < own.size(); ++k)
        result.own[k] = from.own[k] + way * (own[k] - from.own[k]);
      result.thermal_factor =
        from.thermal_factor + way * (thermal_factor - from.thermal_factor);
      return result;
    }

    /// Returns zero factors for everything except temperatures (factor 1).
    LoadFactor
    without_loads() const
    {
      return {0., std::vector<double>(own.size(), 0.)};
    }

    /// Returns the factor @p scene for the scene, zero for loads with entry
    /// `Factors`.
    LoadFactor
    of_scene_alone(const double scene = 1.) const
    {
      return {scene, std::vector<double>(own.size(), 0.)};
    }

    /// Returns zero factors for everything, including temperatures.
    LoadFactor
    unloaded() const
    {
      LoadFactor result     = without_loads();
      result.thermal_factor = 0.;
      return result;
    }

    /// Returns true if the load with the factor of index @p history oscillates.
    bool
    oscillates(const unsigned int history) const
    {
      return history > 0 && amplitudes[history - 1] > 0.;
    }

    /// Returns these factors plus the amplitudes of oscillating loads.
    LoadFactor
    with_oscillation() const
    {
      LoadFactor result = *this;
      for (unsigned int k = 0; k < own.size(); ++k)
        result.own[k] += amplitudes[k];
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

    /// Serializes all members (Boost.Serialization).
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &scene &own &amplitudes &thermal_factor;
    }

  private:
    double              scene, thermal_factor = 1.;
    std::vector<double> own, amplitudes;
  };
} // namespace lamella

#endif
