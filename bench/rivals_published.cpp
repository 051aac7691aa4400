// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals_published.cpp - learned networks: what is published about them, quoted, not run
#include "sections.h"

namespace spigolo::bench {

void rivals_published(Report& report) {
  report.heading(2, "Learned networks: quoted, not run");
  report.text(
      "Learned networks are not run here; what is published about them is quoted. The figures are "
      "counted from the labels that Himeur et al. (PCEDNet, ACM TOG 41(1), 2022) publish with "
      "their "
      "paper: each method's answer for every point of 17 ABC clouds; positive is a sharp edge, "
      "thin "
      "F1 as in our tables. **That is another set**: our nine ABC clouds are nine of these 17, so "
      "the figures are no ranking. Letters name what a network was trained on: A ABC, D the "
      "authors' own constructed clouds. With noise: the same 17 with displacements of .4 % of the "
      "diagonal along the normal, half a spacing and more.");
  report.table({"method", "needs", "mean F1, 17 clouds", "median", "points of all clouds together"},
               {{"PCPNet (A)", "training", ".817", ".896", ".762"},
                {"PCEDNet, two classes (A)", "training, normals", ".756", ".858", ".500"},
                {"PCEDNet, two classes (D)", "training, normals", ".710", ".761", ".445"},
                {"PCEDNet (D)", "training, normals", ".701", ".778", ".493"},
                {"CNN, two classes (A)", "training", ".662", ".727", ".470"},
                {"FC, two classes (A)", "training", ".605", ".648", ".516"},
                {"EC-Net", "training", ".490", ".492", ".482"},
                {"covariance analysis", "nothing", ".454", ".537", ".342"},
                {"feature edge extraction", "nothing", ".442", ".383", ".266"},
                {"the best of them for each cloud, by its labels", "", ".851", "-", "-"}});
  report.text(
      "With noise the best published mean F1 on those 17 is .404 (PCEDNet (D)), then .363 "
      "(EC-Net).");
}

}  // namespace spigolo::bench
