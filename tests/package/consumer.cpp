// SPDX-License-Identifier: MIT
// The smallest program of a user: includes the umbrella if there is one, calls something, and says whether it worked.
#include "bolide/bolide.hpp"
#ifdef CONSUMER_GSL
#include <gsl/gsl_version.h>
#endif
#ifdef CONSUMER_PNG
#include <png.h>
#endif
#ifdef CONSUMER_HDF5
#include "bolide/hdf5/checkpoint.hpp"
#endif

int main() {
  const bolide::native_pack<double> x(2.0);
  const double y = bolide::exp(bolide::log(x))[0];
  return y > 1.999999 && y < 2.000001 ? 0 : 1;
}
