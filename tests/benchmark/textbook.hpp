// SPDX-License-Identifier: MIT
// The textbook solver: what every speed of this library is measured against. An explicit material point method written as a book would
// write it, one step after the other: particles as an array of structs in lattice order, a dense row-major grid, one loop per transfer, shape
// functions made anew for every particle in every loop. No sorting, no packing of lanes, no fusion of loops; and nothing that slows it down on
// purpose: no allocation in a step, no division that a constant's inverse saves, trip counts known to the compiler.
//
// Step (update stress first, FLIP), h the cell size, D = tr L, d = dev sym L:
//   m_I = sum N m,   v_I = sum N m v / m_I
//   L = sum v_I grad N (r-z: and v_r / r)
//   J <- J (1 + dt D),   s <- s + dt (W s - s W + 2 G d),  radial return to Y = Y0 + H ep
//   q = rho h |D| (c_q h |D| + c_l c0) in compression
//   e <- e + dt (s : d - p D) / rho                    the work of the stress as it was (p holds q)
//   p = p_H(J) (1 - gamma0 eta / 2) + gamma0 rho0 e + q,   eta = 1 - J,   p_H = rho0 c0^2 eta / (1 - s eta)^2;  eta < 0: p_ref = rho0 c0^2 (1/J - 1)
//   f_I = -sum V sigma grad N (r-z: and V s_tt N / r),   dv_I = f_I dt / m_I
//   v <- v + sum N dv_I,   x <- x + dt sum N (v_I + dv_I)
// The step is given, not chosen. Boundaries are free; the domain is a box that the material must not leave (within reach of a shape function of
// its faces), which in r-z lies off the axis. Nothing is checked in a step.
//
// It differs from the composed solver of the same policies (linear_hardening, mie_grueneisen, bulk, flip, usf) by terms of first order in dt
// (J, and e, which is no exact book-keeping here) and by three of its models: the viscosity has the sound speed of the reference state,
// elastic shear energy counts as heat in p, and B-splines have no correction of N / r. tests/verify/textbook_test.cpp measures all of it.
// Stored per particle: 12 numbers in r-z, 17 in 3-D. Source: docs/performance.md, variant B.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// The small functions of a loop, which a book would write into it. In a large program g++ would leave some of them as calls: a third slower.
#define TEXTBOOK_INLINE inline __attribute__((always_inline))

namespace textbook {

/// Aluminium unless told otherwise, SI units.
struct parameters {
  double rho0 = 2785, c0 = 5328, slope = 1.338, gamma0 = 2.0;         // Mie-Grueneisen
  double shear_modulus = 27.6e9, yield = 0.265e9, hardening = 0.4e9; // J2, Y = yield + hardening ep
  double quadratic = 1.5, linear = 0.06;                             // artificial viscosity
};

/// Two nodes per axis: N = 1 - |x|, x in cells.
struct linear {
  static constexpr int nodes = 2;
  static constexpr double offset = 0; // first node = floor(x - offset)
  template <class T> TEXTBOOK_INLINE static void value(T f, T* n) {
    n[0] = T(1) - f;
    n[1] = f;
  }
  template <class T> TEXTBOOK_INLINE static void slope(T, T* d) {
    d[0] = T(-1);
    d[1] = T(1);
  }
};

/// Three nodes per axis: quadratic B-spline.
struct quadratic {
  static constexpr int nodes = 3;
  static constexpr double offset = 0.5;
  template <class T> TEXTBOOK_INLINE static void value(T f, T* n) {
    n[0] = T(0.5) * (T(1.5) - f) * (T(1.5) - f);
    n[1] = T(0.75) - (f - T(1)) * (f - T(1));
    n[2] = T(0.5) * (f - T(0.5)) * (f - T(0.5));
  }
  template <class T> TEXTBOOK_INLINE static void slope(T f, T* d) {
    d[0] = f - T(1.5);
    d[1] = T(2) - T(2) * f;
    d[2] = f - T(0.5);
  }
};

/// The constitutive law of one particle.
template <class T> struct metal {
  T rho0, c0, slope, bulk, half_gamma, gamma_rho, twice_g, yield, hardening, inverse_3gh, quadratic, linear;

  explicit metal(const parameters& a)
      : rho0(T(a.rho0)), c0(T(a.c0)), slope(T(a.slope)), bulk(T(a.rho0 * a.c0 * a.c0)), half_gamma(T(a.gamma0 / 2)), gamma_rho(T(a.gamma0 * a.rho0)),
        twice_g(T(2 * a.shear_modulus)), yield(T(a.yield)), hardening(T(a.hardening)), inverse_3gh(T(1 / (3 * a.shear_modulus + a.hardening))),
        quadratic(T(a.quadratic)), linear(T(a.linear)) {}

  /// What radial return multiplies a trial deviator of s : s = `squares` by; ep grows.
  TEXTBOOK_INLINE T radial_return(T squares, T& ep) const {
    using std::sqrt;
    const T y = yield + hardening * ep, equivalent2 = T(1.5) * squares;
    if (!(equivalent2 > y * y)) return T(1);
    const T equivalent = sqrt(equivalent2), increment = (equivalent - y) * inverse_3gh;
    ep += increment;
    return (y + hardening * increment) / equivalent;
  }
  TEXTBOOK_INLINE T viscosity(T rho, T divergence, T h) const {
    if (!(divergence < T(0))) return T(0);
    const T speed = -divergence * h;
    return rho * speed * (quadratic * speed + linear * c0);
  }
  TEXTBOOK_INLINE T pressure(T J, T rho_ratio, T e) const {
    const T eta = T(1) - J;
    if (!(eta > T(0))) return bulk * (rho_ratio - T(1)) + gamma_rho * e;
    const T d = T(1) / (T(1) - slope * eta);
    return bulk * eta * d * d * (T(1) - half_gamma * eta) + gamma_rho * e;
  }
};

/// Nodes of a box: Dim numbers of cells, the origin of the first node.
template <int Dim> struct box {
  std::array<double, Dim> origin; // m
  std::array<int, Dim> nodes;
  double h; // m
};

/// First node and weights of a shape function on one axis.
template <class T, class Shape> struct weights {
  T f; // from the first node, in cells
  int first;
  T n[Shape::nodes];

  TEXTBOOK_INLINE weights(T x, T origin, T inverse_h) {
    const T cells = (x - origin) * inverse_h;
    first = static_cast<int>(cells - T(Shape::offset)); // inside the box: not negative
    f = cells - T(first);
    Shape::value(f, n);
  }
};
/// And slopes, 1/m.
template <class T, class Shape> struct slopes : weights<T, Shape> {
  T d[Shape::nodes];

  TEXTBOOK_INLINE slopes(T x, T origin, T inverse_h) : weights<T, Shape>(x, origin, inverse_h) {
    Shape::slope(this->f, d);
    for (T& slope : d) slope *= inverse_h;
  }
};

/// Axisymmetric, r-z.
template <class T, class Shape> class rz {
public:
  static constexpr int dim = 2;
  struct particle {
    T r, z, vr, vz, m, J, srr, szz, srz, e, ep, p;
  };
  struct node {
    T m, vr, vz, fr, fz; // mass; momentum, then velocity; force, then change of velocity
  };
  std::vector<particle> particles;
  std::vector<node> grid;

  rz(const parameters& a, const box<2>& b)
      : grid(static_cast<std::size_t>(b.nodes[0]) * static_cast<std::size_t>(b.nodes[1])), law(a), r0(T(b.origin[0])), z0(T(b.origin[1])), h(T(b.h)),
        inverse_h(T(1 / b.h)), nz(b.nodes[1]) {}

  void step(T dt) {
    map_mass_and_momentum();
    update_stress(dt);
    map_forces();
    accelerate(dt);
    move(dt);
  }

private:
  static constexpr int nodes = Shape::nodes;
  using values = weights<T, Shape>;
  using gradients = slopes<T, Shape>;
  metal<T> law;
  T r0, z0, h, inverse_h;
  int nz;

  TEXTBOOK_INLINE node& at(int i, int j) { return grid[static_cast<std::size_t>(i) * static_cast<std::size_t>(nz) + static_cast<std::size_t>(j)]; }

  void map_mass_and_momentum() {
    for (node& g : grid) g = {T(0), T(0), T(0), T(0), T(0)};
    for (const particle& p : particles) {
      const values r(p.r, r0, inverse_h), z(p.z, z0, inverse_h);
      for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b) {
          node& g = at(r.first + a, z.first + b);
          const T mass = r.n[a] * z.n[b] * p.m;
          g.m += mass;
          g.vr += mass * p.vr;
          g.vz += mass * p.vz;
        }
    }
    for (node& g : grid)
      if (g.m > T(0)) {
        const T inverse = T(1) / g.m;
        g.vr *= inverse;
        g.vz *= inverse;
      }
  }

  void update_stress(T dt) {
    const T third = T(1) / T(3), half(0.5), inverse_rho0 = T(1) / law.rho0;
    for (particle& p : particles) {
      const gradients r(p.r, r0, inverse_h), z(p.z, z0, inverse_h);
      T lrr(0), lrz(0), lzr(0), lzz(0), vr(0);
      for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b) {
          const node& g = at(r.first + a, z.first + b);
          const T nr = r.d[a] * z.n[b], nz_ = r.n[a] * z.d[b];
          lrr += nr * g.vr;
          lrz += nz_ * g.vr;
          lzr += nr * g.vz;
          lzz += nz_ * g.vz;
          vr += r.n[a] * z.n[b] * g.vr;
        }
      const T ltt = vr / p.r, divergence = lrr + lzz + ltt;
      p.J *= T(1) + dt * divergence;
      const T ratio = T(1) / p.J, rho = law.rho0 * ratio;

      const T drr = lrr - third * divergence, dzz = lzz - third * divergence, drz = half * (lrz + lzr), w = half * (lrz - lzr);
      const T power = p.srr * drr + p.szz * dzz + (p.srr + p.szz) * (drr + dzz) + T(2) * p.srz * drz;
      const T turn = T(2) * w * p.srz, srr = p.srr, szz = p.szz;
      p.srr += dt * (turn + law.twice_g * drr);
      p.szz += dt * (law.twice_g * dzz - turn);
      p.srz += dt * (w * (szz - srr) + law.twice_g * drz);
      const T stt = -(p.srr + p.szz);
      const T scale = law.radial_return(p.srr * p.srr + p.szz * p.szz + stt * stt + T(2) * p.srz * p.srz, p.ep);
      p.srr *= scale;
      p.szz *= scale;
      p.srz *= scale;

      p.e += dt * (power - p.p * divergence) * p.J * inverse_rho0;
      p.p = law.pressure(p.J, ratio, p.e) + law.viscosity(rho, divergence, h);
    }
  }

  void map_forces() {
    const T inverse_rho0 = T(1) / law.rho0;
    for (const particle& p : particles) {
      const gradients r(p.r, r0, inverse_h), z(p.z, z0, inverse_h);
      const T volume = p.m * p.J * inverse_rho0;
      const T frr = -volume * (p.srr - p.p), fzz = -volume * (p.szz - p.p), frz = -volume * p.srz, ftt = volume * (p.srr + p.szz + p.p) / p.r;
      for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b) {
          node& g = at(r.first + a, z.first + b);
          const T nr = r.d[a] * z.n[b], nz_ = r.n[a] * z.d[b];
          g.fr += frr * nr + frz * nz_ + ftt * (r.n[a] * z.n[b]);
          g.fz += frz * nr + fzz * nz_;
        }
    }
  }

  void accelerate(T dt) {
    for (node& g : grid)
      if (g.m > T(0)) {
        const T factor = dt / g.m;
        g.fr *= factor;
        g.fz *= factor;
        g.vr += g.fr;
        g.vz += g.fz;
      }
  }

  void move(T dt) {
    for (particle& p : particles) {
      const values r(p.r, r0, inverse_h), z(p.z, z0, inverse_h);
      T vr(0), vz(0), ar(0), az(0);
      for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b) {
          const node& g = at(r.first + a, z.first + b);
          const T n = r.n[a] * z.n[b];
          vr += n * g.vr;
          vz += n * g.vz;
          ar += n * g.fr;
          az += n * g.fz;
        }
      p.vr += ar;
      p.vz += az;
      p.r += dt * vr;
      p.z += dt * vz;
    }
  }
};

/// Three dimensions.
template <class T, class Shape> class xyz {
public:
  static constexpr int dim = 3;
  struct particle {
    T x[3], v[3], m, J, sxx, syy, szz, sxy, sxz, syz, e, ep, p;
  };
  struct node {
    T m, v[3], f[3];
  };
  std::vector<particle> particles;
  std::vector<node> grid;

  xyz(const parameters& a, const box<3>& b)
      : grid(static_cast<std::size_t>(b.nodes[0]) * static_cast<std::size_t>(b.nodes[1]) * static_cast<std::size_t>(b.nodes[2])), law(a),
        x0{T(b.origin[0]), T(b.origin[1]), T(b.origin[2])}, h(T(b.h)), inverse_h(T(1 / b.h)), ny(b.nodes[1]), nz(b.nodes[2]) {}

  void step(T dt) {
    map_mass_and_momentum();
    update_stress(dt);
    map_forces();
    accelerate(dt);
    move(dt);
  }

private:
  static constexpr int nodes = Shape::nodes;
  using values = weights<T, Shape>;
  using gradients = slopes<T, Shape>;
  metal<T> law;
  T x0[3], h, inverse_h;
  int ny, nz;

  TEXTBOOK_INLINE node& at(int i, int j, int k) {
    const std::size_t row = static_cast<std::size_t>(i) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(j);
    return grid[row * static_cast<std::size_t>(nz) + static_cast<std::size_t>(k)];
  }

  void map_mass_and_momentum() {
    for (node& g : grid) g = {T(0), {T(0), T(0), T(0)}, {T(0), T(0), T(0)}};
    for (const particle& p : particles) {
      const values x(p.x[0], x0[0], inverse_h), y(p.x[1], x0[1], inverse_h), z(p.x[2], x0[2], inverse_h);
      for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b)
          for (int c = 0; c < nodes; ++c) {
            node& g = at(x.first + a, y.first + b, z.first + c);
            const T mass = x.n[a] * y.n[b] * z.n[c] * p.m;
            g.m += mass;
            for (int d = 0; d < 3; ++d) g.v[d] += mass * p.v[d];
          }
    }
    for (node& g : grid)
      if (g.m > T(0)) {
        const T inverse = T(1) / g.m;
        for (int d = 0; d < 3; ++d) g.v[d] *= inverse;
      }
  }

  void update_stress(T dt) {
    const T third = T(1) / T(3), half(0.5), inverse_rho0 = T(1) / law.rho0;
    for (particle& p : particles) {
      const gradients x(p.x[0], x0[0], inverse_h), y(p.x[1], x0[1], inverse_h), z(p.x[2], x0[2], inverse_h);
      T l[3][3] = {};
      for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b)
          for (int c = 0; c < nodes; ++c) {
            const node& g = at(x.first + a, y.first + b, z.first + c);
            const T slope[3] = {x.d[a] * y.n[b] * z.n[c], x.n[a] * y.d[b] * z.n[c], x.n[a] * y.n[b] * z.d[c]};
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j) l[i][j] += slope[j] * g.v[i];
          }
      const T divergence = l[0][0] + l[1][1] + l[2][2];
      p.J *= T(1) + dt * divergence;
      const T ratio = T(1) / p.J, rho = law.rho0 * ratio;

      const T dxx = l[0][0] - third * divergence, dyy = l[1][1] - third * divergence, dzz = l[2][2] - third * divergence;
      const T dxy = half * (l[0][1] + l[1][0]), dxz = half * (l[0][2] + l[2][0]), dyz = half * (l[1][2] + l[2][1]);
      const T wxy = half * (l[0][1] - l[1][0]), wxz = half * (l[0][2] - l[2][0]), wyz = half * (l[1][2] - l[2][1]);
      const T power = p.sxx * dxx + p.syy * dyy + p.szz * dzz + T(2) * (p.sxy * dxy + p.sxz * dxz + p.syz * dyz);
      const T sxx = p.sxx, syy = p.syy, szz = p.szz, sxy = p.sxy, sxz = p.sxz, syz = p.syz;
      p.sxx += dt * (T(2) * (wxy * sxy + wxz * sxz) + law.twice_g * dxx);
      p.syy += dt * (T(2) * (wyz * syz - wxy * sxy) + law.twice_g * dyy);
      p.szz += dt * (law.twice_g * dzz - T(2) * (wxz * sxz + wyz * syz));
      p.sxy += dt * (wxy * (syy - sxx) + wxz * syz + wyz * sxz + law.twice_g * dxy);
      p.sxz += dt * (wxz * (szz - sxx) + wxy * syz - wyz * sxy + law.twice_g * dxz);
      p.syz += dt * (wyz * (szz - syy) - wxy * sxz - wxz * sxy + law.twice_g * dyz);
      const T scale = law.radial_return(
          p.sxx * p.sxx + p.syy * p.syy + p.szz * p.szz + T(2) * (p.sxy * p.sxy + p.sxz * p.sxz + p.syz * p.syz), p.ep);
      p.sxx *= scale;
      p.syy *= scale;
      p.szz *= scale;
      p.sxy *= scale;
      p.sxz *= scale;
      p.syz *= scale;

      p.e += dt * (power - p.p * divergence) * p.J * inverse_rho0;
      p.p = law.pressure(p.J, ratio, p.e) + law.viscosity(rho, divergence, h);
    }
  }

  void map_forces() {
    const T inverse_rho0 = T(1) / law.rho0;
    for (const particle& p : particles) {
      const gradients x(p.x[0], x0[0], inverse_h), y(p.x[1], x0[1], inverse_h), z(p.x[2], x0[2], inverse_h);
      const T volume = p.m * p.J * inverse_rho0;
      const T fxx = -volume * (p.sxx - p.p), fyy = -volume * (p.syy - p.p), fzz = -volume * (p.szz - p.p);
      const T fxy = -volume * p.sxy, fxz = -volume * p.sxz, fyz = -volume * p.syz;
      for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b)
          for (int c = 0; c < nodes; ++c) {
            node& g = at(x.first + a, y.first + b, z.first + c);
            const T nx = x.d[a] * y.n[b] * z.n[c], ny_ = x.n[a] * y.d[b] * z.n[c], nz_ = x.n[a] * y.n[b] * z.d[c];
            g.f[0] += fxx * nx + fxy * ny_ + fxz * nz_;
            g.f[1] += fxy * nx + fyy * ny_ + fyz * nz_;
            g.f[2] += fxz * nx + fyz * ny_ + fzz * nz_;
          }
    }
  }

  void accelerate(T dt) {
    for (node& g : grid)
      if (g.m > T(0)) {
        const T factor = dt / g.m;
        for (int d = 0; d < 3; ++d) {
          g.f[d] *= factor;
          g.v[d] += g.f[d];
        }
      }
  }

  void move(T dt) {
    for (particle& p : particles) {
      const values x(p.x[0], x0[0], inverse_h), y(p.x[1], x0[1], inverse_h), z(p.x[2], x0[2], inverse_h);
      T v[3] = {}, dv[3] = {};
      for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b)
          for (int c = 0; c < nodes; ++c) {
            const node& g = at(x.first + a, y.first + b, z.first + c);
            const T n = x.n[a] * y.n[b] * z.n[c];
            for (int d = 0; d < 3; ++d) {
              v[d] += n * g.v[d];
              dv[d] += n * g.f[d];
            }
          }
      for (int d = 0; d < 3; ++d) {
        p.v[d] += dv[d];
        p.x[d] += dt * v[d];
      }
    }
  }
};

} // namespace textbook
