// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/tracking/stillness.hpp"

#include <gtest/gtest.h>

#include "rigidformer/tracking/flying_blob.hpp"
#include "rigidformer/tracking/track_store.hpp"

namespace rigidformer {
namespace {

using testing::blob;
using testing::Flight;
using testing::observe;

constexpr double kTimeStep = 10.0 / 240.0;  // [s]

/// Adds the flight's clouds from `start_s` on, `count` of them, this often a second.
void feed(TrackStore& store, const Flight& flight, double start_s, int count, double rate_hz = 10.0) {
  for (int i = 0; i < count; ++i) store.add(observe("a", flight, start_s + i / rate_hz, i / rate_hz));
}

Flight moving(const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin = Eigen::Vector3d::Zero()) {
  Flight flight;
  flight.velocity = velocity;
  flight.angular_velocity = spin;
  flight.gravity = 0.0;
  return flight;
}

const Flight kStill = moving(Eigen::Vector3d::Zero());

double newest(const TrackStore& store) { return store.snapshot(kTimeStep).objects.at(0).state.stood_s; }

TEST(Stillness, IsAsLongAsTheObjectWasSeenInOnePlace) {
  TrackStore store{TrackingOptions()};
  feed(store, kStill, 100.0, 8);
  EXPECT_NEAR(newest(store), 0.7, 1e-6);
}

TEST(Stillness, WhatIsThrownUpIsNotStillAtTheTop) {
  Flight thrown;  // up and down again to the same place
  thrown.velocity = {0.0, 0.0, 1.0};
  thrown.angular_velocity.setZero();
  TrackStore store{TrackingOptions()};
  feed(store, thrown, 100.0, 3, 10.0);
  EXPECT_EQ(newest(store), 0.0);
}

TEST(Stillness, EndsWithTheFirstMotion) {
  for (const Flight& flight : {moving({0.1, 0.0, 0.0}), moving({0.0, 0.0, 0.0}, {0.0, 0.0, 0.1})}) {
    TrackStore store{TrackingOptions()};
    feed(store, kStill, 100.0, 8);
    for (int i = 1; i <= 3; ++i) store.add(observe("a", flight, 100.7 + 0.1 * i, 0.1 * i));
    EXPECT_EQ(newest(store), 0.0);
  }
}

TEST(Stillness, WhatFallsHasNone) {
  TrackStore store{TrackingOptions()};
  feed(store, Flight(), 100.0, 8);
  EXPECT_EQ(newest(store), 0.0);
}

TEST(Stillness, CountsTheNewestPosesOnly) {
  TrackStore store{TrackingOptions()};
  feed(store, moving({0.3, 0.0, 0.0}), 100.0, 8);
  const Flight stopped = [] {
    Flight flight = kStill;
    flight.start += Eigen::Vector3d(0.3 * 0.7, 0.0, 0.0);
    return flight;
  }();
  for (int i = 1; i <= 4; ++i) store.add(observe("a", stopped, 100.7 + 0.1 * i, 0.0));
  EXPECT_NEAR(newest(store), 0.4, 1e-6);
}

TEST(Stillness, NoiseIsNoMotion) {
  TrackStore store{TrackingOptions()};
  for (int i = 0; i < 8; ++i) {
    Flight noisy = kStill;
    noisy.start.x() += i % 2 == 0 ? 0.001 : -0.001;  // history with the default noise of 3 mm
    store.add(observe("a", noisy, 100.0 + 0.1 * i, 0.0));
  }
  EXPECT_NEAR(newest(store), 0.7, 1e-6);
}

TEST(Stillness, GoesOnAfterAGapInTheSamePlaceOnly) {
  for (const double shift_m : {0.0, 0.02}) {
    TrackStore store{TrackingOptions()};
    feed(store, kStill, 100.0, 8);
    Flight later = kStill;
    later.start.x() += shift_m;
    EXPECT_EQ(store.add(observe("a", later, 101.2, 0.0)), AddResult::kNewTrackAfterGap);
    EXPECT_NEAR(newest(store), shift_m == 0.0 ? 1.2 : 0.0, 1e-6);
    EXPECT_TRUE(store.snapshot(kTimeStep).objects[0].assumed_static) << "its velocity is not known";
    store.add(observe("a", later, 101.3, 0.0));
    EXPECT_NEAR(newest(store), shift_m == 0.0 ? 1.3 : 0.1, 1e-6);
  }
}

TEST(Stillness, IsSeenInSlowClouds) {
  TrackStore store{TrackingOptions()};
  feed(store, kStill, 100.0, 5, 2.0);
  EXPECT_NEAR(newest(store), 2.0, 1e-6);
  TrackStore falling{TrackingOptions()};
  feed(falling, moving({0.0, 0.0, -0.1}), 100.0, 5, 2.0);
  EXPECT_EQ(newest(falling), 0.0);
}

TEST(Stillness, OfTheFastestCloudsIsLongEnough) {
  TrackStore store{TrackingOptions()};
  feed(store, kStill, 100.0, 400, 200.0);
  EXPECT_GT(newest(store), 0.5);
}

}  // namespace
}  // namespace rigidformer
