// SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "rigidformer/simulation/dataset_generator.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "fixture_scene.hpp"
#include "fixture_shapes.hpp"
#include "parallel_progress.hpp"
#include "rigidformer/data/kubasic.hpp"
#include "rigidformer/data/kubric.hpp"
#include "rigidformer/data/scene_archive.hpp"
#include "rigidformer/io/sha256.hpp"
#include "rigidformer/io/text_file.hpp"
#include "rigidformer/simulation/builtin_shapes.hpp"
#include "rigidformer/simulation/scene_set.hpp"
#include "rigidformer/simulation/varied_scene.hpp"

namespace rigidformer {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kScenesPerShard = 100;  // scenes of one archive, which a stopped run can lose; chosen by eye
// Of scenes with fixtures: with their slabs, no scene has many more objects than one without. Chosen by eye.
constexpr int kMinObjects = 2, kMaxObjects = 6;
constexpr std::uint64_t kMostAttempts = 50;  // to draw such a scene; chosen by eye
constexpr char kGenerationFile[] = "generation.json";
constexpr char kBullet[] = "bullet", kMujoco[] = "mujoco", kMovi[] = "movi", kVaried[] = "varied";

/// SHA-256 over the names, masses and vertices of the shapes.
std::string fingerprint(const std::vector<Shape>& shapes) {
  std::string bytes;
  for (const Shape& shape : shapes) {
    std::ostringstream mass;
    mass.imbue(std::locale::classic());  // the same text whatever the language of the machine
    mass << std::fixed << shape.mass_kg;
    bytes += shape.name + '\0' + mass.str() + '\0';
    const Points vertices = shape.vertices();
    bytes.append(reinterpret_cast<const char*>(vertices.data()),
                 static_cast<std::size_t>(vertices.size()) * sizeof(float));
  }
  return sha256_hex(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

/// Notes in the folder what it holds, or checks that the note there says the same.
void claim_folder(const DatasetOptions& options, const std::vector<Shape>& shapes) {
  Json wanted = {{"set", options.set},
                 {"seed", options.seed},
                 {"first_frame", options.movi.first_frame},
                 {"num_frames", options.movi.num_frames},
                 {"format", options.format},
                 {"shapes_sha256", fingerprint(shapes)}};
  if (options.engine != kBullet) wanted["engine"] = options.engine;
  if (options.contacts != kMovi) wanted["contacts"] = options.contacts;
  if (options.fixtures) wanted["fixtures"] = true;
  fs::create_directories(options.output);
  const fs::path path = options.output / kGenerationFile;
  if (!fs::exists(path)) {
    if (!fs::is_empty(options.output)) {
      throw std::runtime_error("'" + options.output.string() + "' is not empty and has no " + kGenerationFile +
                               ": choose another folder");
    }
    save_text_file(path, wanted.dump(2) + '\n');
    return;
  }
  std::ifstream in(path);
  const Json found = Json::parse(in, nullptr, false);
  for (const auto& [key, value] : wanted.items()) {
    const std::string there = found.is_object() && found.contains(key) ? found[key].dump() : "nothing";
    if (there != value.dump()) {
      throw std::runtime_error("'" + options.output.string() + "' holds scenes with " + key + " " + there + ", not " +
                               value.dump() + ": choose another folder or remove it");
    }
  }
}

/// Whether a shard is finished: it reads without error and holds at least the scenes asked for.
bool is_complete_shard(const fs::path& path, int num_scenes) {
  if (!fs::exists(path)) return false;
  try {
    return static_cast<int>(read_scene_archive(path).scenes.size()) >= num_scenes;
  } catch (const std::runtime_error&) {
    return false;
  }
}

/// The shapes of a folder that `set` draws from; meshes that it does not draw from may be broken.
std::vector<Shape> load_library(MoviSet set, const fs::path& folder, std::vector<std::string>& warnings) {
  const std::vector<std::string> available = kubasic_shape_names(folder);
  const std::vector<std::string> names = movi_shape_names(set, available);
  if (names == available) return load_usable_kubasic_shapes(folder, warnings);
  std::vector<Shape> shapes;
  for (const std::string& name : names) {
    if (std::find(available.begin(), available.end(), name) == available.end()) continue;
    shapes.push_back(load_kubasic_shape(folder / name, &warnings));
  }
  return shapes;
}

void require_one_of(const char* field, const std::string& value, const std::string& a, const std::string& b) {
  if (value == a || value == b) return;
  throw std::invalid_argument(std::string(field) + " '" + value + "' is not one of " + a + ", " + b);
}

class DatasetGenerator {
 public:
  DatasetGenerator(const DatasetOptions& options, std::vector<Shape> shapes, std::ostream& log)
      : options_(options),
        shapes_(std::move(shapes)),
        num_free_shapes_(static_cast<std::ptrdiff_t>(shapes_.size())),
        progress_(options.num_scenes, log) {
    if (options.fixtures) shapes_.insert(shapes_.end(), fixture_shapes().begin(), fixture_shapes().end());
  }

  void write_shards() {
    for (int first = 0; first < options_.num_scenes; first += kScenesPerShard) {
      const int count = std::min(kScenesPerShard, options_.num_scenes - first);
      char name[40];
      std::snprintf(name, sizeof(name), "scenes_%06d.safetensors", first);
      const fs::path path = options_.output / name;
      if (is_complete_shard(path, count)) {
        progress_.skip(count);
        continue;
      }
      SceneArchive archive{options_.set, shapes_, std::vector<SceneRecording>(static_cast<std::size_t>(count))};
      parallel_for(count, options_.jobs, [&](int i) {
        archive.scenes[static_cast<std::size_t>(i)] = generate(first + i);
        progress_.advance();
      });
      write_scene_archive(path, archive);
    }
    progress_.finish();
  }

  void write_kubric_folders() {
    for (const Shape& shape : shapes_) write_kubasic_shape(options_.output / "shapes", shape);
    parallel_for(options_.num_scenes, options_.jobs, [&](int i) {
      const fs::path folder = options_.output / std::to_string(i);
      if (fs::exists(folder / "metadata.json")) {
        progress_.skip(1);
        return;
      }
      write_kubric_scene(folder, generate(i));
      progress_.advance();
    });
    progress_.finish();
  }

 private:
  SceneRecording generate(int index) const {
    const MoviOptions& movi = options_.movi;
    const auto i = static_cast<std::uint64_t>(index);
    if (options_.fixtures) return generate_with_fixtures(i);
    if (options_.engine == kBullet && options_.contacts == kMovi) {
      return generate_scene(options_.set, shapes_, options_.seed, i, movi);
    }
    return move({sample(i, movi), {}});
  }

  VariedScene sample(std::uint64_t index, const MoviOptions& movi) const {
    const MoviSet set = parse_movi_set(options_.set);
    const std::vector<Shape> shapes(shapes_.begin(), shapes_.begin() + num_free_shapes_);
    if (options_.contacts == kVaried) return sample_varied_scene(set, shapes, options_.seed, index, movi);
    return {sample_movi_scene(set, shapes, options_.seed, index, movi), movi_bullet_settings(set), {}};
  }

  SceneRecording move(const FixtureScene& made) const {
    const MoviOptions& movi = options_.movi;
    const SceneRecording& start = made.scene.start;
#ifdef RIGIDFORMER_HAS_MUJOCO
    if (options_.engine == kMujoco) {
      return simulate(start, shapes_, made.scene.mujoco, movi.num_frames, movi.first_frame, made.paths);
    }
#endif
    return simulate(start, shapes_, made.scene.bullet, movi.num_frames, movi.first_frame, made.paths);
  }

  /// A scene is drawn anew where nothing finds room, or where a driver presses an object into something, which no
  /// engine survives.
  SceneRecording generate_with_fixtures(std::uint64_t index) const {
    MoviOptions movi = options_.movi;
    movi.min_objects = kMinObjects;
    movi.max_objects = kMaxObjects;
    const VariedScene free = sample(index, movi);
    std::string reason = "an object was squeezed out";
    for (std::uint64_t attempt = 0; attempt < kMostAttempts; ++attempt) {
      try {
        const double duration_s = movi.num_frames / free.bullet.frame_rate_hz;
        const SceneRecording made = move(add_fixtures(free, shapes_, options_.seed, index, attempt, duration_s));
        if (is_calm(made, free.scale)) return made;
      } catch (const std::runtime_error& error) {
        reason = error.what();
      }
    }
    throw std::runtime_error("scene " + std::to_string(index) + " with fixtures: " + reason);
  }

  const DatasetOptions& options_;
  std::vector<Shape> shapes_;  ///< Of the free objects, then those of fixtures and drivers
  std::ptrdiff_t num_free_shapes_;
  Progress progress_;
};

}  // namespace

void DatasetOptions::validate() const {
  check_scene_set(set);
  if (!shapes.empty() && !draws_from_library(set)) {
    throw std::invalid_argument("shapes = '" + shapes.string() + "': scenes of set " + set +
                                " have shapes of their own");
  }
  if (num_scenes < 1) throw std::invalid_argument("scenes = " + std::to_string(num_scenes) + " must be >= 1");
  if (movi.num_frames < 1) throw std::invalid_argument("frames = " + std::to_string(movi.num_frames) + " must be >= 1");
  if (movi.first_frame < 0) {
    throw std::invalid_argument("first_frame = " + std::to_string(movi.first_frame) + " must be >= 0");
  }
  if (jobs < 1) throw std::invalid_argument("jobs = " + std::to_string(jobs) + " must be >= 1");
  if (output.empty()) throw std::invalid_argument("out must name a folder");
  require_one_of("format", format, "archive", "kubric");
  require_one_of("contacts", contacts, kMovi, kVaried);
  require_one_of("engine", engine, kBullet, kMujoco);
#ifndef RIGIDFORMER_HAS_MUJOCO
  if (engine == kMujoco) throw std::runtime_error("mujoco is not built in: install libmujoco-dev and build again");
#endif
  if ((engine != kBullet || contacts != kMovi || fixtures) && !draws_from_library(set)) {
    throw std::invalid_argument("set '" + set + "' is made by bullet with its own contacts and without fixtures only");
  }
  if (format == "kubric" && fixtures) throw std::invalid_argument("format 'kubric' has no place for driven bodies");
  if (format == "kubric" && has_commands(set)) {
    throw std::invalid_argument("format 'kubric' has no place for the commands of set " + set);
  }
}

void generate_dataset(const DatasetOptions& options, std::ostream& log) {
  options.validate();
  std::vector<std::string> warnings;
  const std::vector<Shape> library =
      options.shapes.empty() ? builtin_shapes() : load_library(parse_movi_set(options.set), options.shapes, warnings);
  const std::vector<Shape> shapes = scene_set_shapes(options.set, library);
  for (const std::string& warning : warnings) log << "warning: " << warning << '\n';
  claim_folder(options, shapes);
  DatasetGenerator generator(options, shapes, log);
  if (options.format == "archive") {
    generator.write_shards();
  } else {
    generator.write_kubric_folders();
  }
}

}  // namespace rigidformer
