// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/cad_file.cpp
#include "spigolo/cad/cad_file.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <utility>

#include "spigolo/cad/occt-inl.h"
#include "spigolo/core/error.h"

namespace spigolo {

namespace {

// Faces smaller than this share of their squared extent have no area.
constexpr double no_area = 1e-12;
constexpr double area_tolerance = 1e-7;  // relative

struct Loaded {
  TopoDS_Shape shape;  // null if nothing in the file has a shape
  std::string unit;
};

struct UnitName {
  const char *in_file, *occt, *ours;
};
constexpr std::array<UnitName, 14> unit_names = {{{"millimetre", "MM", "mm"},
                                                  {"milimetre", "MM", "mm"},
                                                  {"millimeter", "MM", "mm"},
                                                  {"mm", "MM", "mm"},
                                                  {"centimetre", "CM", "cm"},
                                                  {"cm", "CM", "cm"},
                                                  {"metre", "M", "m"},
                                                  {"meter", "M", "m"},
                                                  {"m", "M", "m"},
                                                  {"inch", "INCH", "inch"},
                                                  {"in", "INCH", "inch"},
                                                  {"foot", "FT", "foot"},
                                                  {"ft", "FT", "foot"},
                                                  {"km", "KM", "km"}}};

// Lengths stay as they are in the file: has OpenCASCADE take the file's unit for its own.
std::string keep_unit(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const UnitName& unit : unit_names)
    if (name == unit.in_file) {
      Interface_Static::SetCVal("xstep.cascade.unit", unit.occt);
      return unit.ours;
    }
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  return "";
}

std::string first_bytes(const std::filesystem::path& path, std::size_t count) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError(path.string(), "", "cannot be read; is the name right?");
  std::string bytes(count, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  if (bytes.empty()) throw InputError(path.string(), "", "is empty");
  return bytes;
}

[[noreturn]] void damaged(const std::filesystem::path& path, const char* format) {
  throw InputError(path.string(), "",
                   std::string("is a damaged ") + format +
                       " file: it cannot be parsed to its end; export it again");
}

// Transferring an entity that did not load crashes OpenCASCADE: the file is refused before.
void require_sound(const std::filesystem::path& path, const Interface_InterfaceModel& model,
                   const char* format) {
  for (int i = 1; i <= model.NbEntities(); ++i)
    if (model.IsErrorEntity(i))
      throw InputError(path.string(), "entity " + std::to_string(i),
                       std::string("is a damaged ") + format +
                           " file: this entity names what is not there, or is not what its type "
                           "says; export it again");
}

Loaded load_step(const std::filesystem::path& path) {
  if (first_bytes(path, 4096).find("ISO-10303-21") == std::string::npos)
    throw InputError(path.string(), "header", "is no STEP file: ISO-10303-21 is not there");
  STEPControl_Controller::Init();
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) damaged(path, "STEP");
  require_sound(path, *reader.WS()->Model(), "STEP");
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  Loaded loaded;
  loaded.unit = keep_unit(lengths.IsEmpty() ? "" : lengths.First().ToCString());
  reader.TransferRoots();
  loaded.shape = reader.OneShape();
  return loaded;
}

Loaded load_iges(const std::filesystem::path& path) {
  const std::string start = first_bytes(path, 80);
  if (start.size() < 73 || start[72] != 'S')
    throw InputError(path.string(), "line 1", "is no IGES file: column 73 has no S");
  IGESControl_Controller::Init();
  IGESControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) damaged(path, "IGES");
  require_sound(path, *reader.IGESModel(), "IGES");
  const Handle(TCollection_HAsciiString) unit = reader.IGESModel()->GlobalSection().UnitName();
  Loaded loaded;
  loaded.unit = keep_unit(unit.IsNull() ? "" : unit->ToCString());
  reader.TransferRoots();
  loaded.shape = reader.OneShape();
  return loaded;
}

const char* type_of(const BRepAdaptor_Surface& surface) {
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      return "plane";
    case GeomAbs_Cylinder:
      return "cylinder";
    case GeomAbs_Cone:
      return "cone";
    case GeomAbs_Sphere:
      return "sphere";
    case GeomAbs_Torus:
      return "torus";
    case GeomAbs_BezierSurface:
      return "bezier";
    case GeomAbs_BSplineSurface:
      return "bspline";
    case GeomAbs_SurfaceOfRevolution:
      return "revolution";
    case GeomAbs_SurfaceOfExtrusion:
      return "extrusion";
    case GeomAbs_OffsetSurface:
      return "offset";
    default:
      return "other";
  }
}

Box box_of(const TopoDS_Shape& shape) {
  Bnd_Box bound;
  BRepBndLib::AddOptimal(shape, bound, false, false);
  Box box;
  if (bound.IsVoid()) return box;
  box.add(from_occt(bound.CornerMin()));
  box.add(from_occt(bound.CornerMax()));
  return box;
}

// Whether the face's range is all of its surface's and the surface comes back there.
bool comes_round(bool surface_closed, double first, double last, const Interval& range) {
  return surface_closed && range.length() >= (last - first) * (1 - 1e-9);
}

CadFaceInfo describe(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face, false);
  CadFaceInfo info;
  info.type = type_of(surface);
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(face, properties, area_tolerance);
  info.area = std::abs(properties.Mass());
  const FaceRange range = range_of(face);
  info.u = range.u;
  info.v = range.v;
  info.trimmed = !range.trims.empty();
  info.periodic_u = surface.IsUPeriodic();
  info.periodic_v = surface.IsVPeriodic();
  info.closed_u = comes_round(surface.IsUClosed(), surface.FirstUParameter(),
                              surface.LastUParameter(), range.u);
  info.closed_v = comes_round(surface.IsVClosed(), surface.FirstVParameter(),
                              surface.LastVParameter(), range.v);
  info.bounds = box_of(face);
  return info;
}

std::size_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum what, TopAbs_ShapeEnum outside) {
  std::size_t n = 0;
  for (TopExp_Explorer all(shape, what, outside); all.More(); all.Next()) ++n;
  return n;
}

std::string lower_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

}  // namespace

bool is_cad_file(const std::filesystem::path& path) {
  const std::string ending = lower_ending(path);
  return ending == ".step" || ending == ".stp" || ending == ".iges" || ending == ".igs";
}

CadFile::CadFile(const std::filesystem::path& path) {
  if (!is_cad_file(path))
    throw UsageError(path.string() + " is no CAD file: .step, .stp, .iges and .igs are read");
  const bool step = lower_ending(path).starts_with(".st");
  const OcctSession session;
  TopTools_IndexedMapOfShape shapes;  // the faces, in the order of the file
  try {
    const Loaded loaded = step ? load_step(path) : load_iges(path);
    summary_.format = step ? "STEP" : "IGES";
    summary_.unit = loaded.unit;
    if (!loaded.shape.IsNull()) {
      TopExp::MapShapes(loaded.shape, TopAbs_FACE, shapes);
      summary_.free_curves = count(loaded.shape, TopAbs_EDGE, TopAbs_FACE);
      summary_.free_points = count(loaded.shape, TopAbs_VERTEX, TopAbs_EDGE);
      summary_.bounds = box_of(loaded.shape);
    }
    for (int i = 1; i <= shapes.Extent(); ++i)
      summary_.faces.push_back(describe(TopoDS::Face(shapes(i))));
  } catch (const Standard_Failure& failure) {
    throw InputError(path.string(), "", "cannot be read: " + message_of(failure));
  }
  convert_ = [shapes](std::size_t i) {
    const OcctSession converting;
    return convert_face(TopoDS::Face(shapes(static_cast<int>(i) + 1)));
  };
}

CadFile::CadFile(CadSummary summary, std::function<NurbsFace(std::size_t)> convert)
    : summary_(std::move(summary)), convert_(std::move(convert)) {}

NurbsFace CadFile::face(std::size_t i) const {
  if (i >= summary_.faces.size())
    throw UsageError("there is no face " + std::to_string(i) + "; the file has " +
                     std::to_string(summary_.faces.size()) + ", counted from 0");
  const CadFaceInfo& info = summary_.faces[i];
  const double extent = squared_norm(info.bounds.size());
  if (!(info.area > no_area * extent))
    throw NoResultError("face " + std::to_string(i) + " has no area");
  return convert_(i);
}

}  // namespace spigolo
