// SPDX-License-Identifier: MIT
// Boundaries and contact in the solver: periodic axes, moving and sticking walls, bodies with velocity fields of their own.
#include "bolide/space/plane_strain.hpp"
#include "bolide/strength/elastic.hpp"

#include "unit/solver/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bolide {
namespace {
using namespace test;
using quadratic = shape::quadratic_bspline;
using p1 = vec<double, 1>;
using p2 = vec<double, 2>;

auto fluid() { return material{eos::mie_grueneisen{{}}, strength::none{}, failure::none{}}; }

template <class Method> class Boundaries : public testing::Test {
public:
  static auto make(auto space, const auto&... bodies) {
    return solver{space, grid::sparse{1 * mm}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{}, one_thread<double>(), bodies...};
  }
};
using methods = testing::Types<linear_flip_usf, bspline_flip_musl, bspline_apic_usf>;
TYPED_TEST_SUITE(Boundaries, methods, method_names);

/// A wave in a periodic bar knows nothing of where the period is cut: the scene shifted by a quarter period gives the shifted answer.
TYPED_TEST(Boundaries, APeriodCanBeCutAnywhere) {
  const double length = 16 * mm, shift = 4 * mm;
  const auto run = [&](double from) {
    const body bar{"bar", box{p1{0}, p1{length}}, fluid(), 0.5 * mm, initial_state{2785, 0}};
    auto sim = this->make(space::planar_1d{}, bar);
    sim.add(grid::periodic{0, 0, length});
    sim.initialise([&](initial_point<1>& p) { p.velocity[0] = 50 + 20 * std::sin(2 * 3.14159265358979 * (p.position[0] - from) / length); });
    sim.run(length / 5328);
    std::vector<std::pair<double, double>> state;
    sim.for_each_body([&](const auto& s) {
      for (std::size_t i = 0; i < s.columns.size(); ++i) {
        double x = s.columns.template get<field::position>()[i] - from;
        x -= length * std::floor(x / length);
        state.emplace_back(x, s.columns.template get<field::velocity>()[i]);
      }
    });
    EXPECT_LT(std::abs(sim.energies().momentum_error(0)), 1e-13);
    EXPECT_LT(std::abs(sim.energies().residual()), 1e-12);
    std::sort(state.begin(), state.end());
    return state;
  };
  const auto a = run(0), b = run(shift);
  ASSERT_EQ(a.size(), b.size());
  double worst = 0, seen = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max(worst, std::abs(a[i].second - b[i].second));
    seen = std::max(seen, std::abs(a[i].second - 50));
  }
  EXPECT_GT(seen, 5);
  EXPECT_LT(worst, 1e-9);
}

/// A piston that moves at u into resting material is, seen from the piston, material that runs into a wall: shock state by momentum balance.
TYPED_TEST(Boundaries, APistonDrivesTheShockOfItsSpeed) {
  const double u = 500, us = 5328 + 1.338 * u, t = 5e-6;
  const body bar{"bar", box{p1{0}, p1{60 * mm}}, fluid(), 0.5 * mm, initial_state{2785, 0}};
  auto sim = this->make(space::planar_1d{}, bar);
  sim.add(grid::moving_wall{0, 0, u, true});
  sim.run(t);
  double p = 0, v = 0, n = 0;
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) {
      const double x = s.columns.template get<field::position>()[i];
      if (x < u * t + 8 * mm || x > us * t - 8 * mm) continue;
      p += s.columns.template get<field::pressure>()[i];
      v += s.columns.template get<field::velocity>()[i];
      n += 1;
    }
  });
  ASSERT_GT(n, 5);
  const bool smooth = TypeParam::shape_type::smooth; // material that moves through the cells of a linear shape rings (docs/validation.md)
  EXPECT_NEAR(p / n / (2785 * us * u), 1, smooth ? 0.025 : 0.3);
  EXPECT_NEAR(v / n / u, 1, smooth ? 0.015 : 0.2);
  const auto& e = sim.energies();
  EXPECT_NEAR(e.momentum_given[0] / (2785 * us * u * t), 1, smooth ? 0.03 : 0.1) << "p t, with p = rho Us u";
  EXPECT_NEAR(e.boundary_work / (2785 * us * u * t * u), 1, smooth ? 0.03 : 0.1) << "p u t";
  EXPECT_LT(std::abs(e.momentum_now[0] - e.momentum_given[0]), 1e-10 * e.momentum_now[0]);
  EXPECT_LT(std::abs(e.residual() * e.scale()), 1e-11 * e.now.total());
}

/// A wall does not pull: material that runs away from it does so freely.
TYPED_TEST(Boundaries, AWallDoesNotPull) {
  const body bar{"bar", box{p1{0}, p1{20 * mm}}, fluid(), 0.5 * mm, initial_state{2785, 0}, p1{100.}};
  auto sim = this->make(space::planar_1d{}, bar);
  sim.add(grid::moving_wall{0, 0, 0, true});
  sim.run(20e-6);
  EXPECT_EQ(sim.energies().boundary_work, 0);
  EXPECT_NEAR(sim.energies().now.kinetic / sim.energies().initial.kinetic, 1, 1e-12);
}

/// A block that slides along a mirror goes on; along one that sticks it is held at its foot.
TYPED_TEST(Boundaries, AStickingWallHoldsWhatSlides) {
  const auto slide = [&](bool stick) {
    const material solid{eos::mie_grueneisen{{}}, strength::elastic{27e9}, failure::none{}};
    const body block{"block", box{p2{0, 0}, p2{12 * mm, 6 * mm}}, solid, 0.5 * mm, initial_state{2785, 0}, p2{1, 0}};
    auto sim = this->make(space::plane_strain{}, block);
    sim.add(grid::mirror{1, 0, true, stick}).add(grid::periodic{0, 0, 12 * mm});
    sim.run(1e-6);
    double foot = 0, head = 0;
    int n = 0, m = 0;
    sim.for_each_body([&](const auto& s) {
      for (std::size_t i = 0; i < s.columns.size(); ++i) {
        const double y = s.columns.template get<field::position>(1)[i], v = s.columns.template get<field::velocity>(0)[i];
        if (y < 1.1 * mm) foot += v, ++n;
        if (y > 5 * mm) head += v, ++m;
      }
    });
    EXPECT_LT(std::abs(sim.energies().residual()), 1e-12);
    if (!stick) {
      EXPECT_LT(std::abs(sim.energies().momentum_error(0)), 1e-12);
    }
    return std::pair(foot / n, head / m);
  };
  const auto free = slide(false), held = slide(true);
  EXPECT_NEAR(free.first, 1, 1e-12);
  EXPECT_NEAR(free.second, 1, 1e-12);
  EXPECT_LT(held.first, 0.35);
  EXPECT_NEAR(held.second, 1, 0.05) << "the shear wave (3.1 km/s) has come half-way";
}

TEST(Boundaries, BadOnesAreRefusedWithASentence) {
  const body bar{"bar", box{p1{0}, p1{20 * mm}}, fluid(), 0.5 * mm, initial_state{2785, 0}};
  solver sim{space::planar_1d{}, grid::sparse{1 * mm}, shape::linear{}, transfer::flip{}, scheme::usf{}, one_thread<double>(), bar};
  EXPECT_THROW(sim.add(grid::periodic{0, 0, 20.5 * mm}), bad_parameter) << "not on a grid line";
  EXPECT_THROW(sim.add(grid::periodic{1, 0, 20 * mm}), bad_parameter) << "no such axis";
  EXPECT_THROW(sim.add(grid::periodic{0, 0, 3 * mm}), bad_parameter) << "too short";
  EXPECT_THROW(sim.add(grid::moving_wall{2, 0, 1}), bad_parameter);
  sim.add(grid::mirror{0, 0, true});
  EXPECT_THROW(sim.add(grid::periodic{0, 0, 20 * mm}), bad_parameter) << "a mirror is there";
  sim.add(grid::mirror{0, 10 * mm, false});
  EXPECT_THROW(sim.step(), bad_parameter) << "half of the bar is beyond that mirror";
  const body coarse{"coarse", box{p1{0}, p1{20 * mm}}, fluid(), 1 * mm, initial_state{2785, 0}};
  EXPECT_THROW((solver{space::planar_1d{}, grid::sparse{1 * mm}, shape::linear{}, transfer::flip{}, scheme::usf{}, one_thread<double>(), coarse}), bad_parameter);
  auto c = one_thread<double>();
  c.accept_one_particle_per_cell = true;
  EXPECT_NO_THROW((solver{space::planar_1d{}, grid::sparse{1 * mm}, shape::linear{}, transfer::flip{}, scheme::usf{}, c, coarse}));
}

// ---- contact ------------------------------------------------------------------------------------------------------------------------
template <class Method> class FrictionalContact : public testing::Test {
public:
  /// A block on a long slab that hold each other by nothing but contact: pressed together with v_y, sliding with v_x.
  static auto make(auto contact, double vx, double vy, const auto& solid) {
    const body slab{"slab", box{p2{-20 * mm, -6 * mm}, p2{20 * mm, 0}}, solid, 0.5 * mm, initial_state{2785, 0}};
    const body block{"block", box{p2{-6 * mm, 0}, p2{6 * mm, 6 * mm}}, solid, 0.5 * mm, initial_state{2785, 0}, p2{vx, vy}};
    return solver{space::plane_strain{}, grid::sparse{1 * mm}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{}, contact,
                  one_thread<double>(), slab, block};
  }
  static double speed(const auto& sim, int d) { // of the block
    double p = 0, m = 0;
    sim.for_each_body([&](const auto& s) {
      if (s.name != "block") return;
      for (std::size_t i = 0; i < s.columns.size(); ++i) {
        p += s.columns.template get<field::mass>()[i] * s.columns.template get<field::velocity>(d)[i];
        m += s.columns.template get<field::mass>()[i];
      }
    });
    return p / m;
  }
};
TYPED_TEST_SUITE(FrictionalContact, methods, method_names);

/// Exact with linear shapes. B-splines see a corner from nodes deep inside the slab, where its own surface gives no direction: some per cent.
TYPED_TEST(FrictionalContact, BodiesThatSlideOrPartFeelNothing) {
  const double exact = TypeParam::shape_type::smooth ? 0.5 : 1e-8; // of 10 m/s
  const material solid{eos::mie_grueneisen{{}}, strength::elastic{27e9}, failure::none{}};
  for (const double vy : {0.0, 5.0}) {
    auto sim = this->make(contact::frictional{0.5}, 10, vy, solid);
    sim.run(2e-6);
    EXPECT_NEAR(this->speed(sim, 0), 10, exact) << "vy = " << vy;
    EXPECT_NEAR(this->speed(sim, 1), vy, exact);
    auto stuck = this->make(contact::single_field{}, 10, vy, solid);
    stuck.run(2e-6);
    EXPECT_LT(this->speed(stuck, 0), 9) << "the single field holds them together";
  }
}

/// Pressed together by an approach velocity: the impulses of friction and pressure are in the ratio of the coefficient.
TYPED_TEST(FrictionalContact, SlidingFrictionIsTheCoefficientTimesThePressure) {
  const material solid{eos::mie_grueneisen{{}}, strength::elastic{27e9}, failure::none{}, viscosity::bulk{0, 0}};
  for (const double mu : {0.0, 0.2, 0.5}) {
    auto sim = this->make(contact::frictional{mu}, 40, -10, solid);
    sim.run(1e-6);
    const double tangential = 40 - this->speed(sim, 0), normal = this->speed(sim, 1) + 10;
    EXPECT_GT(normal, 3);
    EXPECT_NEAR(tangential / normal, mu, TypeParam::shape_type::smooth ? 0.12 : 0.02) << "mu " << mu;
    for (std::size_t d = 0; d < 2; ++d) EXPECT_LT(std::abs(sim.energies().momentum_error(d)), 1e-12);
    EXPECT_LT(std::abs(sim.energies().residual()), 1e-12);
    EXPECT_LE(sim.energies().contact, 1e-12 * sim.energies().scale()) << "contact takes energy, it gives none";
  }
}

/// Head-on and without friction, contact is the single field of one body: the same shock.
TYPED_TEST(FrictionalContact, AnImpactHeadOnIsThatOfOneField) {
  const auto run = [&](auto contact) {
    const body flyer{"flyer", box{p1{-10 * mm}, p1{0}}, fluid(), 0.5 * mm, initial_state{2785, 0}, p1{1000.}};
    const body target{"target", box{p1{0}, p1{10 * mm}}, fluid(), 0.5 * mm, initial_state{2785, 0}};
    solver sim{space::planar_1d{}, grid::sparse{1 * mm}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{}, contact,
               one_thread<double>(), flyer, target};
    sim.run(1.2e-6);
    double p = 0;
    int n = 0;
    sim.for_each_body([&](const auto& s) {
      for (std::size_t i = 0; i < s.columns.size(); ++i)
        if (std::abs(s.columns.template get<field::position>()[i] - 0.6 * mm) < 3 * mm) p += s.columns.template get<field::pressure>()[i], ++n;
    });
    return p / n;
  };
  const double exact = 2785 * (5328 + 1.338 * 500) * 500, one = run(contact::single_field{}), two = run(contact::frictional{});
  EXPECT_NEAR(one / exact, 1, 0.08);
  EXPECT_NEAR(two / exact, 1, 0.12);
}

TEST(FrictionalContact, CorrectionIsOddAndNeverPulls) {
  const contact::frictional c{0.3};
  using v = std::array<double, 2>;
  const v u{3, -1}, n{0.8, 0.6}, minus_u{-3, 1}, minus_n{-0.8, -0.6};
  const v a = c.correction(u, n), b = c.correction(minus_u, minus_n);
  EXPECT_NEAR(a[0], -b[0], 1e-15);
  EXPECT_NEAR(a[1], -b[1], 1e-15);
  EXPECT_NEAR((u[0] + a[0]) * n[0] + (u[1] + a[1]) * n[1], 0, 1e-15);
  const double normal = 3 * 0.8 - 0.6, tangential = 3 * 0.6 + 0.8; // along (0.6, -0.8)
  EXPECT_NEAR(a[0] * 0.6 - a[1] * 0.8, -0.3 * normal, 1e-15);
  EXPECT_GT(tangential, 0.3 * normal);
  const v none = c.correction(minus_u, n);
  EXPECT_EQ(none[0], 0);
  EXPECT_EQ(none[1], 0);
  EXPECT_THROW(contact::frictional{-0.1}, bad_parameter);
}

} // namespace
} // namespace bolide
