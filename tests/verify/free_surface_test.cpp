// SPDX-License-Identifier: MIT
// Release at a free surface: its speed against the isentrope (u_p + integral dp/(rho c)), and the state of the released material.
#include "verify/flyer.hpp"

#include "bolide/analysis/release_isentrope.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method, class Start> void check(const char* name, const Start& at, double bar) {
  using point = vec<double, 1>;
  const auto shock = exact_shock(at);
  const auto release = analysis::release_isentrope(at.eos, shock.density, shock.energy);
  const double expected = shock.particle_speed + release.speed_gain;
  const material al{at.eos, strength::none{}, failure::none{}};
  const body flyer{"flyer", box{point{-8 * mm}, point{0}}, al, cell / 2, at.state, point{impact_speed}};
  const body plate{"plate", box{point{0}, point{3 * mm}}, al, cell / 2, at.state};
  solver sim{space::planar_1d{}, grid::sparse{cell}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{}, one_thread<double>(), flyer,
             plate};
  sim.run(0.48 * us); // the shock breaks out at 0.31 us
  double v = 0, e = 0, t = 0, last = 0;
  int n = 0;
  sim.for_each_body([&](const auto& s) {
    if (s.name != "plate") return;
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto from_end = s.first_id + p.size() - 1 - p.id()[i]; // number of particles between this one and the free surface
      if (from_end == 0) last = p.template get<field::velocity>()[i];
      if (from_end < 4 || from_end >= 10) continue;                // two to five cells in: the last two are the shock's start-up at the surface
      ++n;
      v += p.template get<field::velocity>()[i];
      e += p.template get<field::energy>()[i];
      t += s.material.thermodynamics(p, i).temperature;
    }
  });
  std::printf("| %s | %s | %.0f | %+.2f | %+.2f | %+.2f | %+.2f |\n", name, Method::name().c_str(), expected, 100 * (v / n / expected - 1), 100 * (last / expected - 1),
              100 * (e / n / release.energy - 1), 100 * (t / n / release.temperature - 1));
  EXPECT_NEAR(v / n / expected, 1, bar);
}

TEST(FreeSurface, MieGrueneisen) { check<bspline_apic_usf>("mie-gruneisen", mie_grueneisen(), 0.02); }
TEST(FreeSurface, Tillotson) { check<bspline_apic_usf>("tillotson", tillotson(), 0.02); }
TEST(FreeSurface, Mixed) { check<bspline_apic_usf>("mixed", mixed(), 0.02); }
TEST(FreeSurface, Helm) { check<bspline_apic_usf>("helm", helm(), 0.02); }
TEST(FreeSurface, PaperFromTheColdState) { check<bspline_apic_usf>("paper (cold)", paper(), 0.02); }
TEST(FreeSurface, MieGrueneisenLinearFlip) { check<linear_flip_usf>("mie-gruneisen", mie_grueneisen(), 0.05); }
TEST(FreeSurface, MieGrueneisenLinearMusl) { check<linear_flip_musl>("mie-gruneisen", mie_grueneisen(), 0.05); }

} // namespace
} // namespace bolide
