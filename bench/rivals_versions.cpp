// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals_versions.cpp - which others, and which of their versions
#include "sections.h"

namespace spigolo::bench {

void rivals_versions(Report& report, const RivalPlaces& places) {
  report.text(
      "Other programs on the same clouds, run as they come from Debian. bench/rivals holds the "
      "small programs that call the libraries; they are built for this page only.");
  report.heading(2, "Versions");
  struct Row {
    const char *program, *package, *what;
  };
  std::vector<std::vector<std::string>> rows;
  for (const Row& row :
       {Row{"CGAL", "libcgal-dev",
            "VCM, bilateral smoothing, edge-aware upsampling, advancing front, Poisson"},
        Row{"PCL", "libpcl-dev", "curvature, moving least squares"},
        Row{"MeshLab", "meshlab", "RIMLS, APSS"},
        Row{"Open3D", "python3-open3d", "Poisson, ball pivoting"},
        Row{"CloudCompare", "cloudcompare", "surface variation"}})
    rows.push_back({row.program, package_version(places, row.package), row.what});
  rows.push_back({"multi-scale PCA", "own program",
                  "after Pauly, Keiser and Gross 2003: bench/rivals/multi_scale_pca.cpp"});
  report.table({"rival", "version", "what of it"}, rows);
}

}  // namespace spigolo::bench
