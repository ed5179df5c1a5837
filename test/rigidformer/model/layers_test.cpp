// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/layers.hpp"

#include <gtest/gtest.h>

#include "gradient_check.hpp"
#include "random_scene.hpp"
#include "rigidformer/model/features.hpp"

namespace rigidformer {
namespace {

constexpr double kGradientTolerance = 1e-6;  // relative, of central differences in float64
constexpr double kExact = 1e-12;             // float64, with the same order of operations

/// Options with sizes at which every element can be checked.
ModelOptions miniature() {
  ModelOptions options;
  options.encoder_widths = {5};
  options.encoder_fuse_hidden = 6;
  options.embedding_dim = 6;
  options.num_heads = 2;
  options.head_dim = 8;
  options.rotary_dim = 6;
  options.num_layers = 2;
  options.num_registers = 1;
  options.film_hidden = 4;
  options.block_residual_size = 2;
  options.avp_hidden = options.avp_dim = 4;
  options.scales = {0, 2};
  options.head_hidden = 6;
  return options;
}

/// Puts a module into float64 and moves all its parameters away from zero.
template <typename Module>
Module prepared(Module module) {
  module->to(torch::kFloat64);
  torch::NoGradGuard no_grad;
  for (Tensor parameter : module->parameters()) parameter.add_(0.3 * torch::randn_like(parameter));
  return module;
}

template <typename Module>
double module_gradient_error(Module& module, const std::vector<Tensor>& inputs, const std::function<Tensor()>& f) {
  std::vector<Tensor> leaves = module->parameters();
  leaves.insert(leaves.end(), inputs.begin(), inputs.end());
  return gradient_error(f, leaves);
}

class LayersTest : public ::testing::Test {
 protected:
  void SetUp() override { torch::manual_seed(3); }
};

TEST_F(LayersTest, RmsNormHasUnitRootMeanSquare) {
  RmsNorm norm(2);
  const Tensor y = norm(torch::tensor({3.0, 4.0}, torch::kFloat64));
  EXPECT_LT(largest_difference(y, torch::tensor({3.0, 4.0}, torch::kFloat64) / std::sqrt(12.5)), 1e-6);
  EXPECT_TRUE(torch::equal(norm(torch::zeros({2})), torch::zeros({2})));
}

TEST_F(LayersTest, SwiGluFollowsItsFormula) {
  SwiGlu ffn = prepared(SwiGlu(4, 2.5, 0.0));
  const Tensor x = torch::randn({3, 4}, torch::kFloat64);
  const Tensor both = torch::matmul(x, ffn->gate_and_value->weight.t());
  ASSERT_EQ(both.size(1), 20);
  const Tensor w1 = both.slice(1, 0, 10), w2 = both.slice(1, 10);
  EXPECT_LT(largest_difference(ffn(x), torch::matmul(w1 * torch::sigmoid(w1) * w2, ffn->output->weight.t())), kExact);
}

TEST_F(LayersTest, FilmStartsAsIdentity) {
  Film film(2, 8, 5);
  const Tensor z = torch::randn({2, 3, 5});
  EXPECT_TRUE(torch::equal(film(z, torch::randn({2, 2})), z));
  film = prepared(film);
  EXPECT_GT(largest_difference(film(z.to(torch::kFloat64), torch::randn({2, 2})), z), 1e-3);
}

TEST_F(LayersTest, DecoderBlocksStartUnconditioned) {
  const ModelOptions options = model_preset("tiny");
  DecoderBlock block(options, 2);
  const TokenSet z{torch::randn({1, 3, options.embedding_dim}), Tensor(), Tensor()};
  EXPECT_TRUE(
      torch::equal(block->forward(z, torch::tensor({{0.1, 0.01}})), block->forward(z, torch::tensor({{1.0, 1.0}}))));
}

TEST_F(LayersTest, BlockResidualMixesSummariesBySoftmax) {
  BlockResidual residual(4, 3);
  const std::vector<Tensor> summaries = {torch::randn({1, 2, 4}), torch::randn({1, 2, 4}), torch::randn({1, 2, 4})};
  const double newest = std::exp(4.0) / (std::exp(4.0) + 2.0), older = 1.0 / (std::exp(4.0) + 2.0);
  const Tensor expected = older * (summaries[0] + summaries[1]) + newest * summaries[2];
  EXPECT_LT(largest_difference(residual->forward(summaries), expected), 1e-6);
}

TEST_F(LayersTest, GradientsOfSmallModules) {
  const Tensor x = random_leaf({2, 3, 6}), code = random_leaf({2, 2});
  RmsNorm norm = prepared(RmsNorm(6));
  EXPECT_LT(module_gradient_error(norm, {x}, [&] { return norm(x); }), kGradientTolerance);
  SwiGlu ffn = prepared(SwiGlu(6, 1.5, 0.0));
  EXPECT_LT(module_gradient_error(ffn, {x}, [&] { return ffn(x); }), kGradientTolerance);
  Film film = prepared(Film(2, 4, 6));
  EXPECT_LT(module_gradient_error(film, {x, code}, [&] { return film(x, code); }), kGradientTolerance);
  BlockResidual residual = prepared(BlockResidual(6, 3));
  const Tensor y = random_leaf({2, 3, 6}), z = random_leaf({2, 3, 6});
  EXPECT_LT(module_gradient_error(residual, {x, y, z},
                                  [&] {
                                    return residual->forward({x, y, z});
                                  }),
            kGradientTolerance);
}

TEST_F(LayersTest, GradientsOfAttention) {
  const Tensor query = random_leaf({2, 3, 6}), key = random_leaf({2, 4, 6});
  const Tensor query_angles = random_leaf({2, 3, 6}), key_angles = random_leaf({2, 4, 6});
  const Tensor mask = torch::tensor({{1, 1, 1, 0}, {1, 1, 0, 1}}, torch::kInt64).to(torch::kBool);
  for (const bool gated : {true, false}) {
    ModelOptions options = miniature();
    options.gated_attention = gated;
    GatedAttention attention = prepared(GatedAttention(options));
    const auto f = [&] { return attention->forward({query, Tensor(), query_angles}, {key, mask, key_angles}); };
    EXPECT_LT(module_gradient_error(attention, {query, key, query_angles, key_angles}, f), kGradientTolerance);
  }
}

TEST_F(LayersTest, GradientsOfAnchorVertexPoolingEncoderAndDecoder) {
  const ModelOptions options = miniature();
  const Tensor mask = torch::tensor({{1, 1, 1, 1}, {1, 1, 1, 0}}, torch::kInt64).to(torch::kBool).unsqueeze(0);
  AnchorVertexPooling pooling = prepared(AnchorVertexPooling(options));
  const Tensor f = random_leaf({1, 2, 4, 5}), points = random_leaf({1, 2, 4, 3}), anchors = random_leaf({1, 2, 2, 3});
  EXPECT_LT(module_gradient_error(pooling, {f, points, anchors}, [&] { return pooling(f, points, mask, anchors); }),
            kGradientTolerance);
  PointEncoder encoder = prepared(PointEncoder(options));
  const Tensor h = random_leaf({1, 2, 4, num_vertex_features(options)});
  EXPECT_LT(module_gradient_error(encoder, {h}, [&] { return encoder(h, mask).tokens; }), kGradientTolerance);
  ObjectDecoder decoder = prepared(ObjectDecoder(options, 2));
  const Tensor tokens = random_leaf({1, 3, 6}), code = random_leaf({1, 2});
  const TokenSet objects{tokens, torch::ones({1, 3}, torch::kBool), torch::randn({1, 3, 6}, torch::kFloat64)};
  EXPECT_LT(
      module_gradient_error(decoder, {tokens, code}, [&] { return torch::cat(decoder->forward(objects, code), 1); }),
      kGradientTolerance);
}

TEST_F(LayersTest, GatedAttentionFollowsItsFormula) {
  const ModelOptions options = miniature();
  GatedAttention attention = prepared(GatedAttention(options));
  const Tensor query = torch::randn({1, 2, 6}, torch::kFloat64), key = torch::randn({1, 3, 6}, torch::kFloat64);
  const Tensor q_all = torch::matmul(query, attention->to_query->weight.t());
  const Tensor k_all = torch::matmul(key, attention->to_key->weight.t());
  const Tensor v_all = torch::matmul(key, attention->to_value->weight.t());
  std::vector<Tensor> heads;
  for (std::int64_t head = 0; head < 2; ++head) {
    const auto part = [&](const Tensor& x) { return x.slice(-1, 8 * head, 8 * head + 8)[0]; };
    const Tensor q = attention->query_norm(part(q_all)), k = attention->key_norm(part(k_all));
    heads.push_back(torch::matmul(torch::softmax(torch::matmul(q, k.t()) / std::sqrt(8.0), -1), part(v_all)));
  }
  const Tensor gate = torch::sigmoid(attention->to_gate(query));
  const Tensor expected = torch::matmul(gate * torch::cat(heads, -1), attention->to_output->weight.t());
  EXPECT_LT(largest_difference(attention->forward({query, Tensor(), Tensor()}, {key, Tensor(), Tensor()}), expected),
            kExact);
}

TEST_F(LayersTest, MaskedKeysHaveNoInfluence) {
  GatedAttention attention = prepared(GatedAttention(miniature()));
  const TokenSet query{torch::randn({1, 2, 6}, torch::kFloat64), Tensor(), Tensor()};
  TokenSet key{torch::randn({1, 3, 6}, torch::kFloat64), torch::tensor({{1, 0, 1}}, torch::kInt64).to(torch::kBool),
               Tensor()};
  const Tensor before = attention(query, key);
  key.tokens = key.tokens.clone();
  key.tokens[0][1].fill_(1e3);
  EXPECT_TRUE(torch::equal(attention(query, key), before));
}

TEST_F(LayersTest, AnchorVertexPoolingFollowsEquation3InAnyVertexOrder) {
  AnchorVertexPooling pooling = prepared(AnchorVertexPooling(miniature()));
  const Tensor f = torch::randn({1, 1, 6, 5}, torch::kFloat64), points = torch::randn({1, 1, 6, 3}, torch::kFloat64);
  const Tensor anchors = points.slice(2, 0, 2), mask = torch::ones({1, 1, 6}, torch::kBool);
  const double sigma = std::exp(pooling->log_sigma.item<double>());
  std::vector<Tensor> pooled;
  for (std::int64_t k = 0; k < 2; ++k) {
    const Tensor w = torch::exp(-(points[0][0] - anchors[0][0][k]).norm(2, -1) / sigma);
    pooled.push_back((w.unsqueeze(-1) * f[0][0]).sum(0) / w.sum());
  }
  const Tensor u = pooling(f, points, mask, anchors);
  EXPECT_LT(largest_difference(u[0][0], pooling->mlp(torch::stack(pooled))), 1e-5);  // the distance is smoothed at 0
  const Tensor order = torch::tensor({4, 2, 0, 5, 1, 3}, torch::kInt64);
  const Tensor shuffled = pooling(f.index_select(2, order), points.index_select(2, order), mask, anchors);
  EXPECT_LT(largest_difference(shuffled, u), kExact);
  EXPECT_TRUE(torch::equal(AnchorVertexPooling(miniature())(f.to(torch::kFloat32), points, mask, anchors),
                           torch::zeros({1, 1, 2, 4})));  // the last layer starts at zero
}

TEST_F(LayersTest, EncoderLevelsPoolPrefixesOfTheFarthestPointOrder) {
  const ModelOptions options = miniature();
  const std::int64_t N = 16, E = 5;
  const Tensor h = torch::randn({1, 1, N, num_vertex_features(options)}, torch::kFloat64);
  const Tensor mask = torch::ones({1, 1, N}, torch::kBool);
  const std::int64_t pooled_points[] = {16, 8, 4, 2};
  for (std::int64_t level = 0; level < 4; ++level) {
    PointEncoder encoder = prepared(PointEncoder(options));
    torch::NoGradGuard no_grad;
    const Tensor kept = encoder->fuse->first->weight.slice(1, level * E, level * E + E).clone();
    encoder->fuse->first->weight.zero_().slice(1, level * E, level * E + E).copy_(kept);
    const Tensor before = encoder(h, mask).tokens;
    for (std::int64_t i = 0; i < N; ++i) {
      Tensor changed = h.clone();
      changed[0][0][i] = 100.0 * encoder->backbone[0]->as<Linear>()->weight[0];  // largest value of channel 0
      const bool reaches = largest_difference(encoder(changed, mask).tokens, before) > 0.0;
      EXPECT_EQ(reaches, i < pooled_points[level]) << "level " << level << ", point " << i;
    }
  }
}

TEST_F(LayersTest, EncoderLevelsAreTheSameWithoutGradientsAlsoWhereNotFinite) {
  PointEncoder encoder(miniature());
  torch::manual_seed(3);
  Tensor features = torch::randn({2, 3, 17, num_vertex_features(miniature())});
  features[1][2][0][0] = std::nanf("");
  const Tensor num_points = torch::tensor({17, 5, 1, 0, 9, 2}).reshape({2, 3, 1});
  const Tensor mask = torch::arange(17).reshape({1, 1, 17}) < num_points;
  const Tensor expected = encoder(features, mask).tokens.detach();
  EXPECT_TRUE(expected[1][2].isnan().all().item<bool>());
  torch::NoGradGuard no_grad;
  EXPECT_TRUE(torch::allclose(encoder(features, mask).tokens, expected, 0.0, 0.0, /*equal_nan=*/true));
}

TEST_F(LayersTest, RotaryAnglesAreLogSpacedAndDoubled) {
  const Tensor angles =
      rotary_angles(torch::tensor({{32.0, 0.0, 1.0}}, torch::kFloat64), 24);  // 24 channels: 4 frequencies per axis
  ASSERT_EQ(angles.size(1), 24);
  const Tensor x = angles[0].slice(0, 0, 4);
  EXPECT_NEAR(x[0].item<double>(), 2.0 * M_PI, 1e-9);       // the longest wavelength is 32 m
  EXPECT_NEAR(x[3].item<double>(), 2.0 * M_PI * 64, 1e-9);  // the shortest wavelength is 0.5 m
  EXPECT_NEAR((x[1] / x[0]).item<double>(), 4.0, 1e-9);
  EXPECT_NEAR((x[2] / x[1]).item<double>(), 4.0, 1e-9);
  EXPECT_TRUE(torch::equal(angles[0].slice(0, 4, 8), x));
  EXPECT_TRUE(torch::equal(angles[0].slice(0, 8, 16), torch::zeros({8}, torch::kFloat64)));
  EXPECT_LT(largest_difference(angles[0].slice(0, 16, 24) * 32.0, angles[0].slice(0, 0, 8)), 1e-9);
}

TEST_F(LayersTest, RotationKeepsLengthsAndPassesTheRestThrough) {
  const Tensor x = torch::randn({1, 2, 5, 32}, torch::kFloat64);
  const Tensor angles = rotary_angles(torch::randn({1, 5, 3}, torch::kFloat64), 24);
  const Tensor turned = apply_rotary(x, angles);
  EXPECT_LT(largest_difference(turned.norm(2, -1), x.norm(2, -1)), kExact);
  EXPECT_TRUE(torch::equal(turned.slice(-1, 24), x.slice(-1, 24)));
  EXPECT_TRUE(torch::equal(apply_rotary(x, torch::zeros_like(angles)), x));
  EXPECT_GT(largest_difference(turned, x), 0.1);
  EXPECT_LT(largest_difference(apply_rotary(turned, -angles), x), kExact);
}

TEST_F(LayersTest, AropeAttentionDependsOnRelativePositionsOnly) {
  ModelOptions options = model_preset("tiny");
  GatedAttention attention = prepared(GatedAttention(options));
  const Tensor tokens = torch::randn({1, 4, options.embedding_dim}, torch::kFloat64);
  const Tensor anchors = torch::randn({1, 4, 4, 3}, torch::kFloat64);
  const auto attend = [&](const Tensor& positions) {
    const TokenSet z{tokens, Tensor(), rotary_angles(positions, options.rotary_dim).mean(2)};
    return attention(z, z);
  };
  const Tensor before = attend(anchors);
  EXPECT_LT(largest_difference(attend(anchors + torch::tensor({3.0, -7.0, 0.4}, torch::kFloat64)), before),
            kExact * 100);
  EXPECT_GT(largest_difference(attend(1.5 * anchors), before), 1e-3);
}

TEST_F(LayersTest, AropeOfAnObjectIsTheMeanOverItsAnchorsInAnyOrder) {
  const ModelOptions options = model_preset("tiny");
  const RandomScene scene = random_scene(2, {{8, 8}});
  TokenPositionEncoder encoder(options);
  const Tensor x = scene.state.current.apply(scene.batch.points_reference);
  const Tensor anchors = gather_points(x, scene.batch.anchor_index);
  const Tensor order = torch::tensor({2, 3, 1, 0}, torch::kInt64);
  const TokenPositions a = encoder(scene.batch, scene.state.current, x, anchors);
  const TokenPositions b = encoder(scene.batch, scene.state.current, x, anchors.index_select(2, order));
  EXPECT_LT(largest_difference(a.object_angles, b.object_angles), kExact);
  EXPECT_TRUE(torch::equal(a.anchor_angles.index_select(2, order), b.anchor_angles));
  EXPECT_LT(largest_difference(a.object_angles, a.anchor_angles.mean(2)), kExact);
  EXPECT_FALSE(a.object_embedding.defined());
}

}  // namespace
}  // namespace rigidformer
