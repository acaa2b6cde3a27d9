// SPDX-License-Identifier: MIT
// GSL reports errors by aborting the program unless told otherwise; in this room they become exceptions.
// Including anything of this room links GSL, which is GPL-3-or-later: the program is then under its terms.
#pragma once

#include <gsl/gsl_errno.h>

#include <stdexcept>
#include <string>

namespace bolide::gsl {

/// A GSL routine failed; what() names it and gives GSL's reason.
struct failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// While it lives, GSL returns error codes instead of aborting. (GSL's handler is one per program: not for concurrent use.)
class errors_returned {
public:
  errors_returned() : before_(gsl_set_error_handler_off()) {}
  ~errors_returned() { gsl_set_error_handler(before_); }
  errors_returned(const errors_returned&) = delete;
  errors_returned& operator=(const errors_returned&) = delete;

private:
  gsl_error_handler_t* before_;
};

inline void check(int status, const char* routine) {
  if (status != GSL_SUCCESS) throw failure(std::string(routine) + ": " + gsl_strerror(status));
}

} // namespace bolide::gsl
