// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/decoder.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "random_scene.hpp"

namespace rigidformer {
namespace {

TEST(DecoderTest, AttentionResidualStartsWithTheMean) {
  AttentionResidual residual(4);
  const std::vector<Tensor> sources = {torch::randn({1, 2, 4}), torch::randn({1, 2, 4})};
  EXPECT_LT(largest_difference(residual->forward(sources), 0.5 * (sources[0] + sources[1])), 1e-6);
  EXPECT_LT(largest_difference(residual->forward({sources[0]}), sources[0]), 1e-6);
  residual->query->weight.data().fill_(3.0);
  const Tensor k_0 = residual->norm(sources[0]).sum(-1, true), k_1 = residual->norm(sources[1]).sum(-1, true);
  const Tensor first = torch::sigmoid(3.0 * (k_0 - k_1));
  EXPECT_LT(largest_difference(residual->forward(sources), first * sources[0] + (1.0 - first) * sources[1]), 1e-5);
}

TEST(DecoderTest, BlockSumsAreTheEmbeddingFinishedBlocksAndThePartialSum) {
  const Tensor e = torch::tensor({1.0}), a = torch::tensor({10.0}), b = torch::tensor({100.0});
  BlockSums sums(e, 2);
  const auto values = [&] {
    std::vector<double> list;
    for (const Tensor& source : sums.sources()) list.push_back(source.item<double>());
    return list;
  };
  EXPECT_EQ(values(), (std::vector<double>{1.0}));
  sums.add(a);
  EXPECT_EQ(values(), (std::vector<double>{1.0, 10.0}));
  sums.add(b);
  EXPECT_EQ(values(), (std::vector<double>{1.0, 110.0}));
  sums.add(b);
  EXPECT_EQ(values(), (std::vector<double>{1.0, 110.0, 100.0}));
}

TEST(DecoderTest, DecoderWithAResidualPerSublayerStartsFromMeans) {
  // With sublayers that add nothing but FiLM's identity, every source after the embedding is zero.
  ModelOptions options = model_preset("tiny");
  options.block_residual_size = 4;
  options.residual_per_sublayer = true;
  options.num_layers = 2;
  ObjectDecoder decoder(options, 2);
  torch::NoGradGuard no_grad;
  for (const auto& module : *decoder->blocks) {
    module->as<DecoderBlock>()->attention->to_output->weight.zero_();
    module->as<DecoderBlock>()->ffn->output->weight.zero_();
  }
  EXPECT_EQ(decoder->residuals->size(), 5u) << "before each of four sublayers, and after the last";
  const Tensor tokens = torch::randn({1, 3, options.embedding_dim});
  const std::vector<Tensor> Z =
      decoder->forward({tokens, torch::ones({1, 3}, torch::kBool), Tensor()}, torch::zeros({1, 2}));
  ASSERT_EQ(Z.size(), 3u);
  EXPECT_LT(largest_difference(Z[0], tokens), 1e-6);
  EXPECT_LT(largest_difference(Z[1], tokens / 2.0), 1e-6) << "embedding and partial sum";
  EXPECT_LT(largest_difference(Z[2], tokens / 2.0), 1e-6) << "embedding and the finished block";
}

}  // namespace
}  // namespace rigidformer
