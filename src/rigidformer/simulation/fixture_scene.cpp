// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fixture_scene.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

#include "fixture_room.hpp"
#include "fixtures.hpp"

namespace rigidformer {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t kFixtureStream = 0x66697874, kAttemptStride = 0x9e37;  // any numbers do
// All chosen by eye; lengths [m] where objects are about 1 m large, times and speeds likewise.
constexpr double kNoFixture = 0.15, kTwoFixtures = 0.25, kNoDriver = 0.15, kTwoDrivers = 0.35;  // of the scenes
constexpr double kReachOfSites = 3.5, kDriverRadius = 1.2, kOnTop = 0.4, kPusherShare = 0.35, kGripperShare = 0.4;
constexpr int kSiteTries = 30, kSeatTries = 6, kDriverTries = 4, kPalmTries = 12, kThrowTries = 200;
constexpr Range kFriction{0.2, 1.2}, kRestitution{0.0, 0.7}, kGripFriction{0.4, 1.2};
constexpr double kMostFriction = 2.0;  // of fingers, whose products with what they grip are kGripFriction
constexpr Range kFlight{0.1, 0.7}, kSpeed{0.3, 4.0}, kRise{-2.0, 2.0};
constexpr double kHighest = 6.0;       // of the start of a throw
constexpr double kFastest_mps = 16.0;  // a fall from the highest start ends with 11 m/s

class FixtureSceneBuilder {
 public:
  FixtureSceneBuilder(const VariedScene& scene, const std::vector<Shape>& shapes, double duration_s, Random random)
      : scene_(scene),
        unit_m_(scene.scale),
        scale_{scene.scale, duration_s},
        random_(std::move(random)),
        room_(shapes, scene.bullet, scene.scale),
        is_waiting_(scene.start.objects.size(), true) {}

  FixtureScene build() {
    const int num_fixtures = draw_number(kNoFixture, kTwoFixtures);
    int num_drivers = draw_number(kNoDriver, kTwoDrivers);
    if (num_fixtures + num_drivers == 0) num_drivers = 1;
    for (int i = 0; i < num_fixtures; ++i) add_fixture();
    for (int i = 0; i < num_drivers; ++i) {
      const auto taken = taken_.size();
      for (int attempt = 0; attempt < kDriverTries && !add_driver(); ++attempt) taken_.resize(taken);
    }
    for (std::size_t i = 0; i < is_waiting_.size(); ++i) {
      if (is_waiting_[i]) throw_object(i);
    }
    return assemble();
  }

 private:
  int draw_number(double none, double two) {
    const double number = random_.uniform(0.0, 1.0);
    return number < none ? 0 : number < none + two ? 2 : 1;
  }

  /// A circle of the floor that nothing takes yet.
  std::optional<Vector3d> take_floor(double radius_m) {
    for (int attempt = 0; attempt < kSiteTries; ++attempt) {
      const double reach = kReachOfSites * unit_m_;
      const Eigen::Vector2d middle(random_.uniform(-reach, reach), random_.uniform(-reach, reach));
      const bool is_free = std::all_of(taken_.begin(), taken_.end(), [&](const auto& circle) {
        return (circle.first - middle).norm() > circle.second + radius_m;
      });
      if (!is_free) continue;
      taken_.emplace_back(middle, radius_m);
      return Vector3d(middle.x(), middle.y(), 0.0);
    }
    return std::nullopt;
  }

  void add_given(const Block& block, const RigidTransform& T, bool is_driven, double friction) {
    RecordedObject object;
    object.shape = block.shape;
    object.size = block.size;
    object.properties = {std::nullopt, friction, draw(random_, kRestitution)};
    (is_driven ? object.is_driven : object.is_static) = true;
    object.T_world_object = {T};
    given_.push_back(std::move(object));
  }

  void add_fixture() {
    const Fixture fixture = draw_fixture(unit_m_, random_);
    const auto place = take_floor(0.8 * fixture.radius_m);  // the corners of a circle's square are seldom in the way
    if (!place) return;
    const RigidTransform T{rotation_about({0.0, 0.0, random_.uniform(0.0, 2.0 * M_PI)}), *place};
    for (const PlacedBlock& placed : fixture.blocks) {
      RigidTransform T_world_block = T * placed.T_fixture_block;
      T_world_block.rotation = (T_world_block.rotation * placed.block.rotation).normalized();
      add_given(placed.block, T_world_block, false, draw_magnitude(random_, kFriction));
      room_.add_static(placed.block, T_world_block);
    }
    for (const Aim& aim : fixture.aims) {
      aims_.push_back({T * aim.point, aim.heading});
      if (aim.heading) aims_.back().heading = T.rotation * *aim.heading;
    }
    if (fixture.top) tops_.emplace_back(T, *fixture.top);
  }

  std::optional<Vector3d> draw_site() {
    if (tops_.empty() || !draw_chance(random_, kOnTop)) return take_floor(kDriverRadius * unit_m_);
    const auto& [T, top] = tops_[static_cast<std::size_t>(random_.uniform_int(0, static_cast<int>(tops_.size()) - 1))];
    const Vector3d aside(random_.uniform(-0.5, 0.5) * top.half_edges.x(),
                         random_.uniform(-0.5, 0.5) * top.half_edges.y(), 0.0);
    return T * Vector3d(top.middle + aside);
  }

  /// Lets the next waiting object come to rest there.
  std::optional<std::size_t> seat_object(const Vector3d& foot_world) {
    const auto waiting = std::find(is_waiting_.begin(), is_waiting_.end(), true);
    if (waiting == is_waiting_.end()) return std::nullopt;
    const auto i = static_cast<std::size_t>(waiting - is_waiting_.begin());
    for (int attempt = 0; attempt < kSeatTries; ++attempt) {
      const auto T = room_.seat(scene_.start.objects[i], foot_world, random_);
      if (!T) continue;
      starts_[i] = {*T};
      is_waiting_[i] = false;
      return i;
    }
    return std::nullopt;
  }

  /// `held` is the object that a gripper is for.
  void keep_driver(const Driver& driver, std::optional<std::size_t> held = std::nullopt) {
    double friction = draw_magnitude(random_, kFriction);
    if (held && driver.grips) {
      const double of_object = *scene_.start.objects[*held].properties.friction;
      friction = std::min(draw_magnitude(random_, kGripFriction) / of_object, kMostFriction);
    }
    for (std::size_t i = 0; i < driver.blocks.size(); ++i) {
      const RigidTransform start = driver.paths[i](0.0);
      add_given(driver.blocks[i], start, true, friction);
      driver_paths_.push_back(driver.paths[i]);
      const double above_m = 0.5 * (driver.blocks[i].edges.z() + unit_m_);
      aims_.push_back({start.translation + Vector3d(0.0, 0.0, above_m)});
    }
  }

  bool add_driver() {
    const double kind = random_.uniform(0.0, 1.0);
    if (kind > kPusherShare + kGripperShare) return add_palm();
    const auto site = draw_site();
    const auto object = site ? seat_object(*site) : std::nullopt;
    if (!object) return false;
    const DriverTarget target{room_.bounds(scene_.start.objects[*object], starts_.at(*object).T_world_object),
                              room_.reach()};
    for (int attempt = 0; attempt < kDriverTries; ++attempt) {
      const auto driver =
          kind < kPusherShare ? draw_pusher(scale_, target, random_) : draw_gripper(scale_, target, random_);
      if (!driver || !room_.has_way(*driver, scale_.duration_s) || !room_.add_driver(*driver)) continue;
      keep_driver(*driver, object);
      return true;
    }
    return true;  // the object lies there without a driver
  }

  bool add_palm() {
    const auto site = take_floor(kDriverRadius * unit_m_);
    if (!site) return false;
    for (int attempt = 0; attempt < kPalmTries; ++attempt) {
      const Driver palm = draw_palm(scale_, *site, random_);
      if (!room_.has_way(palm, scale_.duration_s) || !room_.add_driver(palm)) continue;
      keep_driver(palm);
      seat_object(palm.paths[0](0.0).translation + Vector3d(0.0, 0.0, 0.5 * palm.blocks[0].edges.z()));
      return true;
    }
    return false;
  }

  /// Throws an object so that it meets an aim; it is left out where nothing is free.
  void throw_object(std::size_t i) {
    if (aims_.empty()) return;
    const RecordedObject& object = scene_.start.objects[i];
    const double time_unit_s = std::sqrt(unit_m_);
    for (int attempt = 0; attempt < kThrowTries; ++attempt) {
      const Aim& aim = aims_[static_cast<std::size_t>(random_.uniform_int(0, static_cast<int>(aims_.size()) - 1))];
      const double flight_s = time_unit_s * draw(random_, kFlight);
      Vector3d velocity = time_unit_s * draw_magnitude(random_, kSpeed) * aim.heading.value_or(draw_direction(random_));
      velocity.z() = time_unit_s * draw(random_, kRise);
      RigidTransform T{random_.rotation(), aim.point - flight_s * velocity};
      T.translation.z() -= 0.5 * scene_.start.gravity.z() * flight_s * flight_s;
      if (T.translation.z() > kHighest * unit_m_ || !room_.add_free(object, T)) continue;
      starts_[i] = {T, velocity, object.angular_velocities.front()};
      return;
    }
  }

  FixtureScene assemble() {
    FixtureScene made{scene_, {}};
    std::vector<RecordedObject>& objects = made.scene.start.objects;
    objects.clear();
    for (const auto& [i, start] : starts_) {
      objects.push_back(scene_.start.objects[i]);
      objects.back().T_world_object = {start.T_world_object};
      objects.back().velocities = {start.velocity};
      objects.back().angular_velocities = {start.angular_velocity};
    }
    if (objects.empty()) throw std::runtime_error("scene '" + scene_.start.name + "': nothing finds room");
    made.paths.resize(objects.size());
    auto path = driver_paths_.begin();
    for (RecordedObject& object : given_) {
      made.paths.push_back(object.is_driven ? *path++ : MotionPath());
      objects.push_back(std::move(object));
    }
    return made;
  }

  const VariedScene& scene_;
  double unit_m_;
  DriverScale scale_;
  Random random_;
  FixtureRoom room_;
  std::vector<bool> is_waiting_;             ///< Of every free object, for a driver
  std::map<std::size_t, BodyState> starts_;  ///< Of those that have found room
  std::vector<std::pair<Eigen::Vector2d, double>> taken_;
  std::vector<std::pair<RigidTransform, Top>> tops_;
  std::vector<Aim> aims_;  ///< In world
  std::vector<RecordedObject> given_;
  std::vector<MotionPath> driver_paths_;
};

}  // namespace

FixtureScene add_fixtures(const VariedScene& scene, const std::vector<Shape>& shapes, std::uint64_t seed,
                          std::uint64_t index, std::uint64_t attempt, double duration_s) {
  Random random(seed ^ (kFixtureStream + kAttemptStride * attempt), index);
  return FixtureSceneBuilder(scene, shapes, duration_s, random).build();
}

bool is_calm(const SceneRecording& recording, double unit_m) {
  const double fastest_m = kFastest_mps * std::sqrt(unit_m) / recording.frame_rate_hz;
  for (const RecordedObject& object : recording.objects) {
    if (object.is_given()) continue;
    for (std::size_t frame = 1; frame < object.T_world_object.size(); ++frame) {
      const Vector3d way = object.T_world_object[frame].translation - object.T_world_object[frame - 1].translation;
      if (!(way.norm() < fastest_m)) return false;
    }
  }
  return true;
}

}  // namespace rigidformer
