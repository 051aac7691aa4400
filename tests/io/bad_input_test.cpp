// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/io/bad_input_test.cpp - what is wrong with a file is said with its name and the place
#include "support.h"

#include "spigolo/io/ply_writer.h"

namespace spigolo {
namespace {

constexpr const char* cloud_endings[] = {".ply", ".xyz", ".txt", ".csv", ".pts",
                                         ".obj", ".off", ".pcd", ".las"};

template <class E = InputError>
std::string error_of(const std::filesystem::path& path) {
  return message_of<E>([&] { read_cloud(path); });
}

TEST(BadInput, MissingEmptyAndFolder) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "d.ply");
  write_file(folder / "e.ply", "");
  EXPECT_TRUE(has(error_of(folder / "m.ply"), (folder / "m.ply").string() + ": there is no such"));
  EXPECT_TRUE(has(error_of(folder / "d.ply"), "is a folder"));
  EXPECT_TRUE(has(error_of(folder / "e.ply"), "e.ply, byte 0: the file is empty"));
}

TEST(BadInput, UnknownEndingsListTheKnownOnes) {
  EXPECT_TRUE(
      has(error_of<UsageError>("a.docx"), "unknown ending .docx; known here are .ply .xyz"));
  EXPECT_TRUE(has(error_of<UsageError>("cloud"), "no ending"));
  EXPECT_TRUE(has(message_of<UsageError>([] { write_cloud("a.laz", {}); }), ".las"));
  EXPECT_TRUE(has(message_of<UsageError>([] { read_mesh("a.xyz"); }), "known here are .ply .obj"));
  EXPECT_EQ(known_endings(FileUse::write_mesh), ".ply .obj .off .stl");
}

TEST(BadInput, ForeignFormatsSayTheWayOut) {
  EXPECT_TRUE(has(error_of("a.laz"), "laszip -i in.laz -o out.las"));
  EXPECT_TRUE(has(error_of("a.copc.laz"), "laszip"));
  EXPECT_TRUE(has(error_of("a.E57"), "CloudCompare"));
}

TEST(BadInput, ContentOfAnotherFormat) {
  const TempFolder folder;
  const std::string binary("\x89PNG\0\0\1\2 and so on", 18);
  for (const char* ending :
       {".ply", ".xyz", ".csv", ".pts", ".obj", ".off", ".stl", ".pcd", ".las"})
    for (const std::string& content : {binary, std::string("Dear reader,\nthis is a letter.\n")}) {
      write_file(folder / (std::string("a") + ending), content);
      EXPECT_TRUE(has(error_of(folder / (std::string("a") + ending)), std::string("a") + ending));
    }
}

// 10^12 points promised by a few bytes: refused before anything is allocated, or this would throw
// MemoryError.
TEST(BadInput, HeadersThatLie) {
  const std::string trillion = "1000000000000";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const auto refused = [](const std::string& text, FileFormat format) {
    const std::string what = message_of<InputError>([&] { read_cloud(as_input(text), format); });
    EXPECT_TRUE(has(what, "fixture, ")) << what;
  };
  for (const char* kind : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string head = "ply\nformat " + std::string(kind) + " 1.0\nelement vertex ";
    refused(head + trillion + "\n" + xyz + "end_header\n1 2 3\n", FileFormat::ply);
    refused(head + trillion + "\n" + xyz + "property list uchar int a\nend_header\n1 2 3 0\n",
            FileFormat::ply);
    refused(head + "0\n" + xyz + "element face " + trillion +
                "\nproperty list uchar int vertex_indices\nend_header\n",
            FileFormat::ply);
    refused(head + "18446744073709551615\n" + xyz + "end_header\n1 2 3\n", FileFormat::ply);
  }
  refused("OFF\n" + trillion + " 0 0\n1 2 3\n", FileFormat::off);
  refused("OFF\n0 " + trillion + " 0\n1 2 3\n", FileFormat::off);
  refused(trillion + "\n1 2 3\n", FileFormat::pts);
  refused(std::string(80, ' ') + "\xff\xff\xff\xff", FileFormat::stl);
  for (const char* kind : {"ascii", "binary", "binary_compressed"})
    refused("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH " + trillion + "\nDATA " + kind +
                "\n\xff\xff\xff\xff\xff\xff\xff\xff",
            FileFormat::pcd);
}

TEST(BadInput, AnElementWithoutPropertiesTakesNoTime) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement nothing 18446744073709551615\nelement vertex 1\nproperty int "
      "x\nproperty int y\nproperty int z\nend_header\n1 2 3\n";
  EXPECT_EQ(read_cloud(as_input(text), FileFormat::ply).size(), 1u);
}

// Cut anywhere, a file is refused - but for a table, of which a part is a table too, and a text cut
// in its last number or its last line end.
TEST(BadInput, CutAtEveryByte) {
  const TempFolder folder;
  PointCloud cloud = survey_cloud(4, 1);
  cloud.set("gps_time", ScalarType::float64, {1, 2, 3, 4, 5});
  for (const bool ascii : {false, true})
    for (const char* ending : cloud_endings) {
      WriteOptions options;
      options.ascii = ascii;
      options.compressed = !ascii;
      const std::filesystem::path path = folder / (std::string("a") + ending);
      write_cloud(path, cloud, options);
      const std::string whole = read_file(path);
      const FileFormat format = file_format(path, FileUse::read_cloud);
      const bool table =
          format == FileFormat::xyz || format == FileFormat::csv || format == FileFormat::obj;
      const bool text = table || format == FileFormat::pts || format == FileFormat::off || ascii;
      const std::size_t last_number = text && format != FileFormat::las
                                          ? whole.find_last_of(" ,", whole.size() - 2) + 1
                                          : whole.size();
      for (std::size_t cut = 0; cut < whole.size(); ++cut) {
        try {
          const PointCloud back =
              read_cloud(as_input(std::string_view(whole).substr(0, cut)), format);
          validate(back);
          EXPECT_TRUE(table || cut > last_number) << ending << " cut at " << cut;
          EXPECT_LE(back.size(), cloud.size());
        } catch (const InputError&) {
        }
      }
    }
}

TEST(BadInput, MeshesCutAtEveryByte) {
  const TempFolder folder;
  TriangleMesh mesh;
  mesh.vertices = survey_cloud(3, 1);
  mesh.triangles = {{0, 1, 2}, {1, 2, 3}};
  for (const bool ascii : {false, true})
    for (const char* name : {"a.ply", "a.stl", "a.off"}) {
      WriteOptions options;
      options.ascii = ascii;
      write_mesh(folder / name, mesh, options);
      const std::string whole = read_file(folder / name);
      const FileFormat format = file_format(folder / name, FileUse::read_mesh);
      const std::size_t last = format == FileFormat::stl && ascii
                                   ? whole.rfind("endsolid") + 7
                                   : whole.size() - 2;  // the line end is no loss
      for (std::size_t cut = 0; cut < last; ++cut)
        EXPECT_THROW(read_mesh(as_input(std::string_view(whole).substr(0, cut)), format),
                     InputError)
            << name << " cut at " << cut;
    }
}

}  // namespace
}  // namespace spigolo
