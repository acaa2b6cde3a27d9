// SPDX-License-Identifier: MIT
// Clouds whose fragments are known: how many, what they are made of, and that no particle is lost or counted twice.
#include "bolide/observe/fragments.hpp"

#include "test_folder.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <set>

namespace bolide::observe {
namespace {

/// Collects particles and makes a snapshot of them; masses are multiples of 2^-20 kg, so that sums are exact in any order.
struct maker {
  int dimension = 2;
  bool axisymmetric = false;
  double spacing = 1;
  std::vector<double> x{}, v{}, m{}, failed{};
  std::vector<int> body{};
  void add(std::vector<double> position, std::vector<double> velocity, double mass = 1, int of = 0, bool broken = false) {
    x.insert(x.end(), position.begin(), position.end()), v.insert(v.end(), velocity.begin(), velocity.end());
    m.push_back(std::ldexp(std::round(mass * 16), -20)), failed.push_back(broken), body.push_back(of);
  }
  snapshot make(const std::vector<std::size_t>& order = {}) const {
    snapshot s;
    s.dimension = dimension, s.axisymmetric = axisymmetric, s.spacing = spacing, s.body_names = {"ball", "plate"};
    const std::size_t n = m.size(), d = static_cast<std::size_t>(dimension);
    std::vector<double> position, velocity, mass, broken, density;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = order.empty() ? k : order[k];
      for (std::size_t c = 0; c < d; ++c) position.push_back(x[i * d + c]), velocity.push_back(v[i * d + c]);
      mass.push_back(m[i]), broken.push_back(failed[i]), density.push_back(2.5 * m[i]), s.body.push_back(body[i]);
      s.id.push_back(static_cast<std::uint32_t>(i));
    }
    s.add("position", "m", dimension, position), s.add("velocity", "m/s", dimension, velocity), s.add("mass", "kg", 1, mass);
    s.add("density", "kg/m3", 1, density), s.add("failed", "1", 1, broken); // each particle has 0.4 m3
    return s;
  }
};
constexpr double unit_mass = 16.0 / (1 << 20); // kg

/// `count` blocks of lattice points, side[k]^dimension particles each, placed without contact at random.
maker blocks(int dimension, const std::vector<int>& sides, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  maker k{.dimension = dimension};
  for (std::size_t b = 0; b < sides.size(); ++b) {
    std::vector<double> corner(static_cast<std::size_t>(dimension)), u(corner.size());
    for (double& c : corner) c = 100 * uniform(random);
    corner[0] = 20.0 * static_cast<double>(b) + uniform(random); // at least 20 - 2 - 8 apart
    for (double& c : u) c = uniform(random);
    std::vector<int> at(corner.size(), 0);
    for (bool more = true; more;) {
      std::vector<double> x = corner;
      for (std::size_t d = 0; d < x.size(); ++d) x[d] += at[d];
      k.add(x, u, 1 + static_cast<double>(random() % 7), static_cast<int>(b % 2));
      more = false;
      for (std::size_t d = 0; d < at.size() && !more; ++d) {
        if (++at[d] < sides[b]) more = true;
        else at[d] = 0;
      }
    }
  }
  return k;
}

TEST(fragments, known_blocks_are_found_in_every_dimension) {
  for (const int dimension : {1, 2, 3}) {
    const std::vector<int> sides{3, 1, 8, 5, 2, 1};
    const maker cloud = blocks(dimension, sides, 7);
    const snapshot s = cloud.make();
    const fragments pieces(s);
    ASSERT_EQ(pieces.size(), sides.size()) << dimension;
    EXPECT_EQ(pieces.linking_length(), 2);
    std::multiset<std::size_t> expected, found;
    for (const int side : sides) expected.insert(static_cast<std::size_t>(std::pow(side, dimension) + 0.5));
    double total = 0, by_body = 0;
    std::size_t particles = 0;
    for (const fragment& f : pieces.list()) {
      found.insert(f.particles), particles += f.particles;
      by_body += f.mass_by_body[0] + f.mass_by_body[1];
      EXPECT_TRUE(f.mass_by_body[0] == 0 || f.mass_by_body[1] == 0);
      EXPECT_EQ(f.kind, fragment_kind::piece);
      EXPECT_NEAR(f.volume, 0.4 * static_cast<double>(f.particles), 1e-12 * f.volume);
      const double side = std::round(std::pow(static_cast<double>(f.particles), 1.0 / dimension)) - 1;
      for (int d = 0; d < dimension; ++d) EXPECT_NEAR(f.extent[static_cast<std::size_t>(d)], side, 1e-12);
      EXPECT_NEAR(f.internal_kinetic, 0, 1e-18);
    }
    for (const double m : cloud.m) total += m;
    EXPECT_EQ(found, expected);
    EXPECT_EQ(particles, s.size());
    EXPECT_EQ(pieces.mass(), total) << "exactly";
    EXPECT_EQ(by_body, total) << "exactly";
    for (std::size_t k = 1; k < pieces.size(); ++k) EXPECT_GE(pieces[k - 1].mass, pieces[k].mass);
  }
}

TEST(fragments, agrees_with_all_pairs_on_random_clouds) {
  for (const int dimension : {1, 2, 3})
    for (const double link : {0.15, 0.4, 1.0}) {
      std::mt19937 random(static_cast<std::uint32_t>(100 * link) + static_cast<std::uint32_t>(dimension));
      std::uniform_real_distribution<double> uniform(-4, 4);
      maker k{.dimension = dimension};
      for (int i = 0; i < 300; ++i) {
        std::vector<double> x(static_cast<std::size_t>(dimension));
        for (double& c : x) c = uniform(random);
        k.add(x, x);
      }
      const snapshot s = k.make();
      const fragments pieces(s, {.linking_length = link, .periodic = {{0, -4, 4}}});
      std::vector<int> label(s.size()); // by relaxation over all pairs
      for (std::size_t i = 0; i < label.size(); ++i) label[i] = static_cast<int>(i);
      for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t a = 0; a < s.size(); ++a)
          for (std::size_t b = 0; b < a; ++b) {
            double d2 = 0;
            for (int d = 0; d < dimension; ++d) {
              double gap = std::abs(s.at("position")(a, d) - s.at("position")(b, d));
              if (d == 0) gap = std::min(gap, 8 - gap);
              d2 += gap * gap;
            }
            if (d2 > link * link || label[a] == label[b]) continue;
            label[a] = label[b] = std::min(label[a], label[b]), changed = true;
          }
      }
      EXPECT_EQ(pieces.size(), std::set<int>(label.begin(), label.end()).size());
      for (std::size_t a = 0; a < s.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) ASSERT_EQ(label[a] == label[b], pieces.of_particle()[a] == pieces.of_particle()[b]);
    }
}

TEST(fragments, the_order_of_the_rows_changes_no_bit) {
  maker cloud = blocks(3, {4, 2, 3, 3, 5}, 3);
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0, 1);
  for (double& x : cloud.x) x += 0.1 * normal(random);
  for (double& v : cloud.v) v += normal(random);
  for (double& m : cloud.m) m *= 1 + 0.1 * std::abs(normal(random));
  std::vector<std::size_t> order(cloud.m.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const fragments one(cloud.make());
  for (int again = 0; again < 3; ++again) {
    std::shuffle(order.begin(), order.end(), random);
    const fragments other(cloud.make(order));
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
      EXPECT_EQ(one[k].mass, other[k].mass);
      EXPECT_EQ(one[k].volume, other[k].volume);
      EXPECT_EQ(one[k].centre, other[k].centre);
      EXPECT_EQ(one[k].velocity, other[k].velocity);
      EXPECT_EQ(one[k].angular_momentum, other[k].angular_momentum);
      EXPECT_EQ(one[k].internal_kinetic, other[k].internal_kinetic);
    }
    for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(other.of_particle()[i], one.of_particle()[order[i]]);
  }
}

TEST(fragments, distance_of_exactly_the_linking_length_links) {
  for (const double length : {1.0, 0.1, 0.05e-3, 3e5}) {
    maker k{.dimension = 1, .spacing = length};
    for (int i = -20; i <= 20; ++i) k.add({i * length}, {0.0});
    EXPECT_EQ(fragments(k.make(), {.linking_length = length}).size(), 1u) << length;
    EXPECT_EQ(fragments(k.make(), {.linking_length = 0.999999 * length}).size(), 41u) << length;
  }
}

TEST(fragments, empty_scene_and_one_particle) {
  const test::folder f("fragments_empty");
  const fragments none(maker{}.make());
  EXPECT_EQ(none.size(), 0u);
  EXPECT_EQ(none.mass(), 0);
  EXPECT_TRUE(none.cumulative_by_mass().empty());
  EXPECT_TRUE(none.by_size().edge.empty());
  none.write_csv(f.path / "n.csv"), none.write_json(f.path / "n.json");
  EXPECT_NE(test::bytes_of(f.path / "n.json").find("\"fragments\": 0"), std::string::npos);
  maker k{.dimension = 3};
  k.add({1, 2, 3}, {4, 5, 6});
  const fragments one(k.make());
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].centre, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(one[0].velocity, (std::array<double, 3>{4, 5, 6}));
  EXPECT_EQ(one[0].extent, (std::array<double, 3>{0, 0, 0}));
  EXPECT_NEAR(one[0].diameter, std::cbrt(6 * 0.4 / std::numbers::pi), 1e-14);
  EXPECT_EQ(one.by_size().number, std::vector<std::size_t>{1}) << "a range without width holds it";
  EXPECT_EQ(one.by_speed().number, std::vector<std::size_t>{1});
}

TEST(fragments, spin_and_inner_motion_of_a_turning_bar) {
  // four masses on a square of side 2 about (10, -3, 5), turning with omega about z and flying with (100, 0, 7)
  const double omega = 3;
  maker k{.dimension = 3};
  for (const double a : {-1.0, 1.0})
    for (const double b : {-1.0, 1.0}) k.add({10 + a, -3 + b, 5}, {100 - omega * b, omega * a, 7});
  const fragments pieces(k.make());
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_NEAR(pieces[0].angular_momentum[2], 4 * unit_mass * 2 * omega, 1e-15);
  EXPECT_NEAR(pieces[0].angular_momentum[0], 0, 1e-15);
  EXPECT_NEAR(pieces[0].internal_kinetic, 0.5 * 4 * unit_mass * 2 * omega * omega, 1e-15);
  EXPECT_NEAR(pieces[0].velocity[0], 100, 1e-12);
  EXPECT_NEAR(pieces[0].speed(), std::hypot(100, 7), 1e-12);
}

TEST(fragments, a_periodic_axis_joins_both_ends) {
  maker k{.dimension = 2};
  for (const double x : {9.5, 8.5, 0.5, 5.0}) k.add({x, 0}, {x, 0});
  const snapshot s = k.make();
  EXPECT_EQ(fragments(s, {.linking_length = 1.1}).size(), 3u);
  const fragments pieces(s, {.linking_length = 1.1, .periodic = {{0, 0, 10}}});
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].particles, 3u);
  EXPECT_NEAR(pieces[0].centre[0], 9.5, 1e-12) << "the mean of 8.5, 9.5 and 10.5";
  EXPECT_NEAR(pieces[0].extent[0], 2, 1e-12);
  maker through{.dimension = 1}; // a particle counted one period on is the same particle
  through.add({9.9}, {0}), through.add({-9.9}, {0});
  EXPECT_EQ(fragments(through.make(), {.linking_length = 0.3, .periodic = {{0, 0, 10}}}).size(), 1u);
  maker around{.dimension = 1};
  for (int i = 0; i < 10; ++i) around.add({i + 0.25}, {0});
  EXPECT_EQ(fragments(around.make(), {.linking_length = 1, .periodic = {{0, 0, 10}}}).size(), 1u);
  EXPECT_THROW(fragments(s, {.linking_length = 4, .periodic = {{0, 0, 10}}}), bad_parameter);
  EXPECT_THROW(fragments(s, {.periodic = {{2, 0, 10}}}), bad_parameter);
}

TEST(fragments, in_rz_a_component_is_a_ring_or_an_axis_body) {
  maker k{.dimension = 2, .axisymmetric = true};
  k.add({0.5, 0}, {0, 0}), k.add({1.5, 0}, {0, 0});                       // reaches its own image across the axis
  k.add({10, 0}, {3, 5}, 2), k.add({11, 0}, {3, 5}, 2), k.add({11, 1}, {3, 5}, 2); // does not
  const fragments pieces(k.make(), {.linking_length = 1});
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].kind, fragment_kind::ring);
  EXPECT_EQ(pieces[1].kind, fragment_kind::axis_body);
  EXPECT_NEAR(pieces[1].diameter, std::cbrt(6 * 0.8 / std::numbers::pi), 1e-14) << "the sphere of its volume";
  const double section = 0.4 / (2 * std::numbers::pi) * (1.0 / 10 + 2.0 / 11);
  EXPECT_NEAR(pieces[0].diameter, std::sqrt(4 * section / std::numbers::pi), 1e-14) << "the circle of its section";
  EXPECT_NEAR(pieces[0].centre[0], 32.0 / 3, 1e-12);
  EXPECT_EQ(pieces[0].angular_momentum, (std::array<double, 3>{}));
  EXPECT_THROW(fragments(k.make(), {.periodic = {{0, 0, 20}}}), bad_parameter) << "a radius does not repeat";
}

TEST(fragments, failed_particles_are_linked_dust_or_left_out) {
  maker k{.dimension = 1}; // two sound ends and a failed middle that would bridge them; a failed crumb
  for (int i = 0; i < 9; ++i) k.add({double(i)}, {0}, 1, 0, i >= 3 && i < 6);
  k.add({20}, {0}, 3, 1, true);
  const snapshot s = k.make();
  double total = 0;
  for (const double m : k.m) total += m;
  const auto with = [&](failed_particles what) { return fragments(s, {.linking_length = 1, .failed = what}); };
  EXPECT_EQ(with(failed_particles::linked).size(), 2u);
  const fragments dusty = with(failed_particles::dust), bare = with(failed_particles::left_out);
  EXPECT_EQ(dusty.size(), 2u);
  EXPECT_EQ(dusty[0].particles, 3u);
  EXPECT_EQ(dusty.dust().particles, 4u);
  EXPECT_EQ(dusty.dust().mass, 6 * unit_mass);
  EXPECT_EQ(dusty.mass() + dusty.dust().mass, total);
  EXPECT_EQ(bare.size(), 2u);
  EXPECT_EQ(bare.dust().particles, 0u);
  EXPECT_EQ(bare.left_out().particles, 4u);
  EXPECT_EQ(bare.mass() + bare.left_out().mass, total);
  EXPECT_EQ(bare.of_particle()[4], -1);
}

TEST(fragments, small_ones_and_foreign_bodies) {
  maker k{.dimension = 1};
  for (int i = 0; i < 6; ++i) k.add({double(i)}, {0}, 1, i < 4 ? 0 : 1);
  k.add({20}, {0}), k.add({30}, {0}), k.add({31}, {0});
  const snapshot s = k.make();
  const fragments all(s, {.linking_length = 1}), coarse(s, {.linking_length = 1, .least_particles = 3}), apart(s, {.linking_length = 1, .across_bodies = false});
  EXPECT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].mass_by_body, (std::vector<double>{4 * unit_mass, 2 * unit_mass}));
  EXPECT_EQ(coarse.size(), 1u);
  EXPECT_EQ(coarse.dust().particles, 3u);
  EXPECT_EQ(coarse.mass() + coarse.dust().mass, all.mass());
  EXPECT_EQ(apart.size(), 4u);
  EXPECT_EQ(apart[0].particles, 4u);
}

TEST(fragments, what_is_no_number_is_counted_and_in_no_fragment) {
  maker k{.dimension = 2};
  k.add({0, 0}, {0, 0}), k.add({1, std::nan("")}, {0, 0}), k.add({2, 0}, {INFINITY, 0}), k.add({1e300, 0}, {0, 0});
  const fragments pieces(k.make());
  EXPECT_EQ(pieces.not_finite(), 2u);
  EXPECT_EQ(pieces.size(), 2u);
}

TEST(fragments, distributions) {
  const test::folder f("fragments_out");
  maker k{.dimension = 1};
  for (const int n : {1, 1, 2, 4, 8}) // masses 1, 1, 2, 4, 8; lengths 0.4 times that; speeds 0, 10, 20, 30, 40
    for (int i = 0; i < n; ++i) k.add({100.0 * static_cast<double>(std::set<double>(k.v.begin(), k.v.end()).size() - (i > 0)) + i},
                                      {i > 0 ? k.v.back() : 10.0 * static_cast<double>(std::set<double>(k.v.begin(), k.v.end()).size())});
  const fragments pieces(k.make(), {.linking_length = 1});
  ASSERT_EQ(pieces.size(), 5u);
  const double u = unit_mass;
  EXPECT_EQ(pieces.cumulative_by_mass(), (std::vector<std::pair<double, std::size_t>>{{8 * u, 1}, {4 * u, 2}, {2 * u, 3}, {u, 5}}));
  const histogram size = pieces.by_size(2), speed = pieces.by_speed(4);
  EXPECT_EQ(size.number, (std::vector<std::size_t>{3, 2})) << "0.4 0.4 0.8 | 1.6 3.2, the last range closed";
  EXPECT_NEAR(size.edge[1], 0.4 * std::sqrt(8), 1e-12);
  EXPECT_EQ(size.mass[1], 12 * u);
  EXPECT_EQ(speed.number, (std::vector<std::size_t>{1, 1, 1, 2}));
  EXPECT_EQ(speed.edge, (std::vector<double>{0, 10, 20, 30, 40}));
  EXPECT_EQ(speed.mass[3], 12 * u);
  EXPECT_THROW(pieces.by_size(0), bad_parameter);

  pieces.write_csv(f.path / "f.csv"), pieces.write_json(f.path / "f.json");
  const std::string csv = test::bytes_of(f.path / "f.csv"), json = test::bytes_of(f.path / "f.json");
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "fragment,kind,particles,first_id,mass (kg),diameter (m),volume (m3),x (m),v_x (m/s),extent_x (m),speed (m/s),"
                                           "internal_kinetic (J),mass of ball (kg),mass of plate (kg)");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
  EXPECT_NE(csv.find("\n0,piece,8,8,0.0001220703125,"), std::string::npos) << csv;
  EXPECT_NE(json.find("\"linking_length_m\": 1"), std::string::npos);
  EXPECT_NE(json.find("\"number\": [1, 2, 3, 5]"), std::string::npos) << json;
  EXPECT_NE(json.find("\"edge_m_s\": [0, "), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(aside(f.path / "f.csv")));
}

TEST(fragments, refuses_what_makes_no_sense) {
  maker k{.dimension = 1, .spacing = 0};
  k.add({0}, {0});
  EXPECT_THROW(fragments(k.make()), bad_parameter) << "no spacing to make a linking length of";
  EXPECT_NO_THROW(fragments(k.make(), {.linking_length = 1}));
  EXPECT_THROW(fragments(k.make(), {.linking_length = -1}), bad_parameter);
  EXPECT_THROW(fragments(k.make(), {.linking_length = 1, .least_particles = 0}), bad_parameter);
  snapshot s = k.make();
  std::erase_if(s.columns, [](const column& c) { return c.name == "failed"; });
  EXPECT_THROW(fragments(s, {.linking_length = 1, .failed = failed_particles::dust}), bad_parameter);
}

} // namespace
} // namespace bolide::observe
