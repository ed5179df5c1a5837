// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/scene/objection.hpp"

#include <gtest/gtest.h>

#include "rigidformer/scene/defects.hpp"
#include "rigidformer/tracking/flying_blob.hpp"

namespace rigidformer {
namespace {

ObjectState usable_object() {
  ObjectState object;
  object.id = "a";
  object.points_reference = testing::blob();
  object.T_world_current.translation = {1.0, 2.0, 3.0};
  object.T_world_previous.translation = {1.0, 2.0, 2.9};
  return object;
}

TEST(Objection, TellsWhatIsWrong) {
  EXPECT_FALSE(objection(usable_object()));
  for (const testing::Defect& defect : testing::defects()) {
    ObjectState object = usable_object();
    defect.apply(object);
    const auto found = objection(object);
    ASSERT_TRUE(found) << defect.name;
    EXPECT_NE(found->find(defect.part), std::string::npos) << defect.name << ": " << *found;
  }
}

TEST(Objection, OneSideOfSomethingIsEnough) {
  for (const float size : {1e-3F, 1.0F, 1e4F}) {
    ObjectState object = usable_object();
    testing::stretch(object.points_reference, size, size, 0.0F);
    EXPECT_FALSE(objection(object)) << size;
  }
  ObjectState triangle = usable_object();
  triangle.points_reference = Points::Zero(4, 3);
  triangle.points_reference(1, 0) = triangle.points_reference(2, 1) = 1.0F;
  EXPECT_FALSE(objection(triangle)) << "three places fix a rotation";
}

TEST(Objection, LengthsAreJudgedAsTheModelSeesThem) {
  ObjectState crumb = usable_object();
  crumb.points_reference *= 1e-4F;
  EXPECT_TRUE(objection(crumb));
  EXPECT_FALSE(objection(crumb, 1e-4));
  EXPECT_FALSE(objection(crumb, std::nullopt)) << "at its own scale it is as large as any";
  testing::stretch(crumb.points_reference, 1.0F, 0.0F, 0.0F);
  EXPECT_TRUE(objection(crumb, std::nullopt));
  crumb.points_reference.setZero();
  EXPECT_TRUE(objection(crumb, std::nullopt));
}

}  // namespace
}  // namespace rigidformer
