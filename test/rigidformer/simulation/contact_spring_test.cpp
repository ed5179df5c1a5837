// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/contact_spring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace rigidformer {
namespace {

TEST(ContactSpring, ReboundsWithTheRestitutionAtEverySolverStep) {
  for (const double solver_step_s : {1e-4, 5e-4, 1e-2}) {
    for (const double restitution : {0.1, 0.3, 0.6, 0.9}) {
      EXPECT_NEAR(rebound_speed(contact_spring(restitution, solver_step_s), solver_step_s), restitution, 1e-6);
    }
  }
}

TEST(ContactSpring, SmallStepsReachTheClosedForm) {
  // A contact that pushes but never pulls has e = exp(-z / sqrt(1 - z^2) (pi - 2 asin z)) for the damping ratio z.
  const double z = 0.3;
  const double frequency = 300.0;
  const double expected = std::exp(-z / std::sqrt(1.0 - z * z) * (M_PI - 2.0 * std::asin(z)));
  EXPECT_NEAR(rebound_speed({frequency * frequency, 2.0 * z * frequency}, 1e-7), expected, 1e-4);
}

TEST(ContactSpring, TheUndampedContactTakesTwelveSteps) {
  EXPECT_NEAR(std::sqrt(contact_spring(0.5, 0.001).stiffness), M_PI / 0.012, 1e-9);
}

TEST(ContactSpring, ContactsOfMoreStepsAreSofter) {
  for (const double steps : {6.0, 8.0, 20.0}) {
    const ContactSpring spring = contact_spring(0.6, 0.001, steps);
    EXPECT_NEAR(std::sqrt(spring.stiffness), M_PI / (0.001 * steps), 1e-9);
    EXPECT_NEAR(rebound_speed(spring, 0.001), 0.6, 1e-6);
  }
}

TEST(ContactSpring, LessRestitutionThanOneTenthActsAsOneTenth) {
  EXPECT_EQ(contact_spring(0.0, 0.001).damping, contact_spring(0.1, 0.001).damping);
  EXPECT_GT(contact_spring(0.1, 0.001).damping, contact_spring(0.2, 0.001).damping);
}

TEST(ContactSpring, RefusesImpossibleContacts) {
  EXPECT_THROW(contact_spring(-0.1, 0.001), std::invalid_argument);
  EXPECT_THROW(contact_spring(1.1, 0.001), std::invalid_argument);
  EXPECT_THROW(contact_spring(0.5, 0.0), std::invalid_argument);
  EXPECT_THROW(contact_spring(0.5, 0.001, 5.0), std::invalid_argument);
}

}  // namespace
}  // namespace rigidformer
