// SPDX-License-Identifier: MIT
// The number types that a test templated over lanes runs on: TYPED_TEST_SUITE(Suite, lane_types).
#pragma once

#include "bolide/core/lane.hpp"

#include <gtest/gtest.h>

using lane_types = testing::Types<double, float, bolide::pack<double, 2>, bolide::pack<double, 4>, bolide::pack<double, 8>,
                                  bolide::pack<float, 4>, bolide::pack<float, 8>, bolide::pack<float, 16>>;
using pack_types = testing::Types<bolide::pack<double, 2>, bolide::pack<double, 4>, bolide::pack<double, 8>, bolide::pack<float, 4>,
                                  bolide::pack<float, 8>, bolide::pack<float, 16>>;
