// SPDX-License-Identifier: MIT
// A material chosen at run time: one virtual call per chunk of particles, nothing virtual inside.
//
// For programs that offer many equations of state from a command line: the solver is compiled once for any_material instead of once per
// equation of state. Whoever composes at compile time pays nothing for it. Wrapped materials must use the fields below (those of
// johnson_cook, tension_or_melt, bulk viscosity and record::peak_pressure) and those of the last parameter, or fewer: a strength whose modulus
// varies, damage and softening bring fields that others do not pay for, any_material<T, Space, fields<field::shear_modulus>>.
#pragma once

#include "bolide/material/material.hpp"
#include "bolide/particles/column_view.hpp"

#include <memory>
#include <utility>

namespace bolide {

template <class T, class SpaceType, class More = fields<>> class any_material {
public:
  using particle_fields =
      field_union_t<fields<field::mass, field::velocity, field::volume, field::energy, field::pressure, field::deviator, field::plastic_strain, field::failed,
                           field::material_volume, field::viscous_pressure, field::sound_speed, field::peak_pressure>,
                    More>;
  static constexpr bool thermal = true;

  template <class Material>
    requires(!std::is_same_v<std::remove_cvref_t<Material>, any_material>)
  explicit any_material(Material m) : model_(std::make_shared<model<Material>>(std::move(m))) {}

  template <class Columns> void initialise(Columns& p, std::size_t begin, std::size_t n, double density, double energy) const {
    model_->initialise(view(p), begin, n, density, energy);
  }
  template <class Space, class Columns>
  void update(Columns& p, std::size_t begin, int n, const T (*l)[chunk_size], const step_context<T>& step, update_report& report) const {
    model_->update(view(p), begin, n, l, step, report);
  }
  template <class Space, class Columns> void work(Columns& p, std::size_t begin, int n, const T (*l)[chunk_size], T dt, update_report& report) const {
    model_->work(view(p), begin, n, l, dt, report);
  }
  template <class Columns> thermal_point<double> thermodynamics(const Columns& p, std::size_t i) const { return model_->thermodynamics(view(p), i); }
  template <class Columns> double material_volume(const Columns& p, std::size_t i) const {
    if (p.template get<field::failed>()[i] > 0) return static_cast<double>(p.template get<field::material_volume>()[i]);
    return static_cast<double>(p.template get<field::volume>()[i]);
  }
  template <class Columns> double shear_energy(const Columns& p, std::size_t i) const { return model_->shear_energy(view(p), i); }
  double impedance() const { return model_->impedance(); }

private:
  using fields_view = particles::column_view<T, SpaceType, particle_fields>;
  template <class Columns> static fields_view view(Columns& p) {
    // columns that the view lists and storage lacks would not compile: the union of field lists has them all
    return fields_view(p);
  }
  struct base {
    virtual ~base() = default;
    virtual void initialise(fields_view p, std::size_t begin, std::size_t n, double density, double energy) const = 0;
    virtual void update(fields_view p, std::size_t begin, int n, const T (*l)[chunk_size], const step_context<T>& step, update_report& report) const = 0;
    virtual void work(fields_view p, std::size_t begin, int n, const T (*l)[chunk_size], T dt, update_report& report) const = 0;
    virtual thermal_point<double> thermodynamics(fields_view p, std::size_t i) const = 0;
    virtual double shear_energy(fields_view p, std::size_t i) const = 0;
    virtual double impedance() const = 0;
  };
  template <class Material> struct model final : base {
    Material material;
    explicit model(Material m) : material(std::move(m)) {}
    void initialise(fields_view p, std::size_t begin, std::size_t n, double density, double energy) const override {
      material.initialise(p, begin, n, density, energy);
    }
    void update(fields_view p, std::size_t begin, int n, const T (*l)[chunk_size], const step_context<T>& step, update_report& report) const override {
      material.template update<SpaceType>(p, begin, n, l, step, report);
    }
    void work(fields_view p, std::size_t begin, int n, const T (*l)[chunk_size], T dt, update_report& report) const override {
      material.template work<SpaceType>(p, begin, n, l, dt, report);
    }
    thermal_point<double> thermodynamics(fields_view p, std::size_t i) const override { return material.thermodynamics(p, i); }
    double shear_energy(fields_view p, std::size_t i) const override { return material.shear_energy(p, i); }
    double impedance() const override { return material.impedance(); }
  };
  std::shared_ptr<const base> model_;
};

} // namespace bolide
