// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/sections.h - one function a section of docs/results.md
#pragma once

#include <filesystem>

#include "report.h"
#include "rival.h"
#include "scoreboard.h"

namespace spigolo::bench {

void thesis_tables(Report& report);    // tables 1 and 2, section 3.7.1, figure 26
void off_the_lattice(Report& report);  // what the thesis could not measure
/// The picture noise-map.png goes to `pictures`.
void noise_map(Report& report, const std::filesystem::path& pictures);
/// The picture fillets.png goes to `pictures`.
void fillets(Report& report, const std::filesystem::path& pictures);
void creases(Report& report);
void hardships(Report& report);
/// data: folder with fandisk.off, may be empty.
void chapter5(Report& report, const std::filesystem::path& data,
              const std::filesystem::path& pictures);
/// data: folder with abc/clean and the models; may be empty.
void feature_lines(Report& report, const std::filesystem::path& data);
void judged_models(Report& report, const std::filesystem::path& data);  // its models
/// data: folder with the models and abc/clean, may be empty; large: a million points, too.
void meshing(Report& report, const std::filesystem::path& data,
             const std::filesystem::path& pictures, bool large);
/// data may be empty; large: whole clouds of a million points, else of a tenth of it
void chapter4(Report& report, const std::filesystem::path& data, bool large);
void local_lines(Report& report, const std::filesystem::path& data);  // tables 3 and 4
void chapter4_pictures(Report& report, const std::filesystem::path& pictures);
/// Those of README.md and docs/*.md that no other section draws.
void document_pictures(Report& report, const std::filesystem::path& pictures);
/// data may be empty; large: up to ten million points.
void speed(Report& report, const std::filesystem::path& data, const std::filesystem::path& pictures,
           bool large);
/// Its part on sizes, stages, verbs and noise; the picture speed.png goes to `pictures`.
void speed_by_size(Report& report, const std::filesystem::path& pictures, bool large);
/// Bytes for several numbers of threads; labels of moved clouds.
void determinism(Report& report);
/// Its last part: exit statuses of the program.
void guarantees(Report& report, const RivalPlaces& places);
/// Files of the folder `data` (see docs/benchmarks.md); pictures go to `pictures`.
void real_clouds(Report& report, const std::filesystem::path& data,
                 const std::filesystem::path& pictures);
/// Other programs, from where ./dev bench --peers puts them.
void rivals_versions(Report& report, const RivalPlaces& places);
/// data: folder with abc/clean and abc/noisy; may be empty.
void rivals_detect(Report& report, const RivalPlaces& places, const std::filesystem::path& data,
                   Scoreboard& board);
void rivals_published(Report& report);
void rivals_smooth(Report& report, const RivalPlaces& places, Scoreboard& board);
struct MeshPictures {
  std::filesystem::path kept, all;  // one small close-up of one edge; one of each cloud
};
void rivals_mesh(Report& report, const RivalPlaces& places, const MeshPictures& pictures,
                 Scoreboard& board);

}  // namespace spigolo::bench
