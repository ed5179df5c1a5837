// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <vector>

#include "rigidformer/simulation/bullet_world.hpp"

namespace rigidformer {

/// Bullet's solver, which tells what bodies press on each other. Contact points know it only with warm starting, which
/// would change the motion.
class TellingSolver : public btSequentialImpulseConstraintSolver {
 public:
  std::vector<PressedBodies> pressed;  ///< Sums since it was cleared

 protected:
  btScalar solveGroupCacheFriendlyFinish(btCollisionObject** bodies, int num_bodies,
                                         const btContactSolverInfo& info) override {
    const auto index = [&](int solver_body) {
      const btRigidBody* body = m_tmpSolverBodyPool[solver_body].m_originalBody;  // null for what never moves
      return body == nullptr ? -1 : body->getUserIndex();
    };
    for (int i = 0; i < m_tmpSolverContactConstraintPool.size(); ++i) {
      const btSolverConstraint& contact = m_tmpSolverContactConstraintPool[i];
      add(index(contact.m_solverBodyIdA), index(contact.m_solverBodyIdB), contact.m_appliedImpulse);
    }
    return btSequentialImpulseConstraintSolver::solveGroupCacheFriendlyFinish(bodies, num_bodies, info);
  }

 private:
  void add(int first, int second, double impulse_Ns) {
    if (!(impulse_Ns > 0.0)) return;
    const int a = std::max(first, second), b = std::min(first, second);
    const auto is_pair = [&](const PressedBodies& pair) { return pair.body_a == a && pair.body_b == b; };
    const auto known = std::find_if(pressed.begin(), pressed.end(), is_pair);
    if (known != pressed.end()) {
      known->normal_impulse_Ns += impulse_Ns;
    } else {
      pressed.push_back({a, b, impulse_Ns});
    }
  }
};

}  // namespace rigidformer
