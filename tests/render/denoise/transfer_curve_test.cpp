#include "render/denoise/transfer_curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace idap::render {
namespace {

TEST(TransferCurve, GoesThereAndBackOverTheWholeRange) {
  const TransferCurve curve;
  for (float v = 1e-4f; v < 65000; v *= 1.07f) EXPECT_NEAR(curve.inverse(curve.forward(v)) / v, 1, 2e-2) << v;
  for (float v = 0.01f; v < 65000; v *= 1.07f) EXPECT_NEAR(curve.inverse(curve.forward(v)) / v, 1, 1e-3) << v;
}

TEST(TransferCurve, EndsAtZeroAndOne) {
  const TransferCurve curve;
  EXPECT_FLOAT_EQ(curve.forward(0), 0);
  EXPECT_FLOAT_EQ(curve.forward(65504), 1);
  EXPECT_FLOAT_EQ(curve.forward(1e30f), 1);
  EXPECT_FLOAT_EQ(curve.forward(INFINITY), 1);
  EXPECT_FLOAT_EQ(curve.forward(NAN), 0);
  EXPECT_FLOAT_EQ(curve.inverse(-1), 0);
  EXPECT_NEAR(curve.inverse(2), 65504, 10);
}

TEST(TransferCurve, Grows) {
  const TransferCurve curve;
  float last = 0;
  for (float v = 1e-8f; v < 60000; v *= 1.02f) {
    EXPECT_GE(curve.forward(v), last);
    last = curve.forward(v);
  }
}

}  // namespace
}  // namespace idap::render
