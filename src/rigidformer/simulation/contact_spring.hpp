// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace rigidformer {

/// Spring and damper of a contact, both per unit of effective mass.
struct ContactSpring {
  double stiffness = 0.0;  ///< Stiffness of the spring [1/s^2]
  double damping = 0.0;    ///< Damping of the damper [1/s]
};

/// Speed after a contact that only pushes, for unit speed before it. The contact is stepped as MuJoCo
/// does, first the velocity and then the position; the result is the mean over the moments between two
/// steps at which the impact can fall.
double rebound_speed(const ContactSpring& spring, double solver_step_s);

constexpr double kStepsPerContact = 12.0;  ///< Solver steps that an undamped spring pushes; chosen by eye

/// Finds the contact that rebounds with `restitution` times the speed of impact at this solver step; its undamped
/// spring pushes for `steps_per_contact` steps: more make softer contacts. Restitutions below 0.1 act as 0.1, because
/// more damping cannot be stepped through. Throws std::invalid_argument unless 0 <= restitution <= 1, solver_step_s > 0
/// and steps_per_contact >= 6.
ContactSpring contact_spring(double restitution, double solver_step_s, double steps_per_contact = kStepsPerContact);

}  // namespace rigidformer
