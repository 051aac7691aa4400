// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/step_writer.cpp
#include "spigolo/cad/step_writer.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>
#include <array>
#include <sstream>
#include <utility>

#include "spigolo/cad/occt-inl.h"
#include "spigolo/core/error.h"
#include "spigolo/io/atomic_file.h"

namespace spigolo {
namespace {

// The file says when it was made; ours say the same every time.
constexpr const char* step_time = "1970-01-01T00:00:00";
constexpr const char* iges_time = "19700101.000000";
// Its own shorter forms lose the exponent of numbers below 0.1.
constexpr const char* number_format = "%.16E";

// The names by which OpenCASCADE knows the units.
const char* occt_unit(const std::string& unit) {
  constexpr std::array<std::pair<const char*, const char*>, 4> units = {
      {{"mm", "MM"}, {"cm", "CM"}, {"m", "M"}, {"inch", "INCH"}}};
  for (const auto& [ours, theirs] : units)
    if (unit == ours) return theirs;
  throw UsageError("unit '" + unit + "' is not one of mm, cm, m, inch");
}

void require_content(const StepContent& content) {
  if (content.curves.empty() && content.points.empty() && content.faces.empty())
    throw NoResultError("there is nothing to write: no curve, no point, no face");
}

Handle(TCollection_HAsciiString) text_of(const char* text) {
  return new TCollection_HAsciiString(text);
}

void write_header(const Handle(StepData_StepModel) & model, const std::string& name) {
  APIHeaderSection_MakeHeader header(model);
  header.SetName(text_of(name.c_str()));
  header.SetTimeStamp(text_of(step_time));
  header.SetAuthorValue(1, text_of(""));
  header.SetOrganizationValue(1, text_of(""));
  header.SetOriginatingSystem(text_of("spigolo"));
  header.SetPreprocessorVersion(text_of("spigolo"));
  header.SetDescriptionValue(1, text_of("written by spigolo"));
}

// OpenCASCADE numbers products by how many it has written in its life.
void rename_products(const Handle(StepData_StepModel) & model, const std::string& name) {
  int products = 0, uses = 0;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    if (const auto product = Handle(StepBasic_Product)::DownCast(entity); !product.IsNull()) {
      const std::string own = ++products == 1 ? name : name + " " + std::to_string(products);
      product->SetId(text_of(own.c_str()));
      product->SetName(text_of(own.c_str()));
    }
    if (const auto use = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(entity);
        !use.IsNull())
      use->SetId(text_of(std::to_string(++uses).c_str()));
  }
}

std::string print(STEPControl_Writer& writer) {
  const Handle(StepData_StepModel) model = writer.Model();
  StepData_StepWriter out(model);
  out.FloatWriter().SetFormat(number_format);
  out.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ostringstream text;
  if (!out.Print(text)) throw Error("the STEP file could not be put together");
  return text.str();
}

void transfer(STEPControl_Writer& writer, const TopoDS_Shape& shape, STEPControl_StepModelType as) {
  if (writer.Transfer(shape, as) != IFSelect_RetDone)
    throw Error("OpenCASCADE cannot write this content as STEP");
}

}  // namespace

std::string step_text(const StepContent& content, const std::string& unit) {
  const char* const occt = occt_unit(unit);
  require_content(content);
  const OcctSession session;
  try {
    STEPControl_Controller::Init();
    // Coordinates are taken as they are: the unit in memory is the unit in the file.
    Interface_Static::SetCVal("xstep.cascade.unit", occt);
    Interface_Static::SetCVal("write.step.unit", occt);
    Interface_Static::SetCVal("write.step.schema", "AP214IS");
    Interface_Static::SetIVal("write.step.assembly", 0);  // one part, not one for each curve
    Interface_Static::SetCVal("write.step.product.name", content.name.c_str());
    STEPControl_Writer writer;
    if (!content.faces.empty()) transfer(writer, faces_to_occt(content), STEPControl_AsIs);
    if (!content.curves.empty())
      transfer(writer, curves_to_occt(content), STEPControl_GeometricCurveSet);
    if (!content.points.empty())
      transfer(writer, points_to_occt(content), STEPControl_GeometricCurveSet);
    write_header(writer.Model(), content.name);
    rename_products(writer.Model(), content.name);
    return print(writer);
  } catch (const Standard_Failure& failure) {
    throw Error("OpenCASCADE could not write the STEP file: " + message_of(failure));
  }
}

void write_step(const std::filesystem::path& path, const StepContent& content,
                const std::string& unit) {
  const std::string text = step_text(content, unit);
  AtomicFile out(path);
  out.write(text);
  out.commit();
}

std::string iges_text(const StepContent& content, const std::string& unit) {
  const char* const occt = occt_unit(unit);
  require_content(content);
  const OcctSession session;
  try {
    IGESControl_Controller::Init();
    Interface_Static::SetCVal("xstep.cascade.unit", occt);
    IGESControl_Writer writer(occt, 1);  // 1: trimmed surfaces as boundary representation
    if (!content.faces.empty()) writer.AddShape(faces_to_occt(content));
    if (!content.curves.empty()) writer.AddShape(curves_to_occt(content));
    if (!content.points.empty()) writer.AddShape(points_to_occt(content));
    writer.ComputeModel();
    IGESData_GlobalSection global = writer.Model()->GlobalSection();
    global.SetDate(text_of(iges_time));
    global.SetLastChangeDate(text_of(iges_time));
    global.SetAuthorName(text_of(""));
    global.SetFileName(text_of(content.name.c_str()));
    writer.Model()->SetGlobalSection(global);
    std::ostringstream text;
    if (!writer.Write(text)) throw Error("the IGES file could not be put together");
    return text.str();
  } catch (const Standard_Failure& failure) {
    throw Error("OpenCASCADE could not write the IGES file: " + message_of(failure));
  }
}

}  // namespace spigolo
