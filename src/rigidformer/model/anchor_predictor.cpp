// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/model/anchor_predictor.hpp"

#include "rigidformer/model/contact_tokens.hpp"
#include "rigidformer/model/features.hpp"

namespace rigidformer {

CrossAttentionLayerImpl::CrossAttentionLayerImpl(const ModelOptions& options) {
  const std::int64_t D = options.embedding_dim;
  query_norm = register_module("query_norm", RmsNorm(D));
  key_norm = register_module("key_norm", RmsNorm(D));
  attention = register_module("attention", GatedAttention(options));
  if (options.predictor_ffn) {
    ffn_norm = register_module("ffn_norm", RmsNorm(D));
    ffn = register_module("ffn", SwiGlu(D, options.ffn_expansion, options.dropout));
  }
}

Tensor CrossAttentionLayerImpl::forward(const TokenSet& query, const TokenSet& key) {
  const TokenSet normed_query{query_norm(query.tokens), query.mask, query.angles};
  const TokenSet normed_key{key_norm(key.tokens), key.mask, key.angles};
  const Tensor y = query.tokens + attention(normed_query, normed_key);
  return ffn.is_empty() ? y : y + ffn(ffn_norm(y));
}

std::int64_t num_anchor_outputs(const ModelOptions& options) {
  return 3 + (options.end_velocity_output ? 3 : 0) + (options.engine_motion ? options.advisers : 0);
}

AnchorPredictorImpl::AnchorPredictorImpl(const ModelOptions& model_options) : options(model_options) {
  const std::int64_t D = options.embedding_dim;
  const std::int64_t state_dim = num_vertex_features(options) + 3 + options.avp_dim +
                                 (options.contact_tokens ? kContactAnchorFeatures : 0) + num_ground_features(options) +
                                 num_engine_features(options);  // 271 in the paper
  to_query = register_module("to_query", Mlp(state_dim, D, D));
  if (options.own_token_in_query) own_token = register_module("own_token", Linear(D, D, false));
  const size_t num_layers = options.scales.size() * static_cast<size_t>(options.predictor_layers_per_scale);
  for (size_t i = 0; i < num_layers; ++i) layers->push_back(CrossAttentionLayer(options));
  register_module("layers", layers);
  fuse = register_module("fuse", Linear(static_cast<std::int64_t>(options.scales.size()) * D, D));
  head_norm = register_module("head_norm", RmsNorm(D));
  head = register_module("head", Mlp(D, options.head_hidden, num_anchor_outputs(options)));
  torch::NoGradGuard no_grad;
  head->second->weight.mul_(0.1);            // training starts near the base motion ...
  head->second->weight.slice(0, 3).zero_();  // ... and at the mean velocity of the step at its end
  head->second->bias.slice(0, 3).zero_();
}

Tensor AnchorPredictorImpl::forward(const Tensor& anchor_state, const std::vector<Tensor>& decoder_outputs,
                                    const TokenSet& objects, const Tensor& anchor_angles,
                                    const Tensor& anchor_embedding) {
  const std::int64_t K = anchor_state.size(1), A = anchor_state.size(2);
  Tensor queries = to_query(anchor_state);  // [B, K, A, D]
  if (anchor_embedding.defined()) queries = queries + anchor_embedding.to(queries.scalar_type());
  if (!own_token.is_empty()) queries = queries + own_token(decoder_outputs.back()).unsqueeze(2);
  queries = queries.flatten(1, 2);
  const Tensor angles = anchor_angles.defined() ? anchor_angles.flatten(1, 2) : Tensor();

  std::vector<Tensor> reads;
  auto layer = layers->begin();
  for (const int scale : options.scales) {
    Tensor tokens = queries;
    const TokenSet keys{decoder_outputs[static_cast<size_t>(scale)], objects.mask, objects.angles};
    for (int i = 0; i < options.predictor_layers_per_scale; ++i, ++layer) {
      tokens = (*layer)->as<CrossAttentionLayer>()->forward({tokens, Tensor(), angles}, keys);
    }
    reads.push_back(tokens);
  }
  return head(head_norm(fuse(torch::cat(reads, -1)))).unflatten(1, {K, A});
}

}  // namespace rigidformer
